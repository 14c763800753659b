import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { faultsOfPage } from './support/accessibility.js';
import { openBrowser } from './support/chromium.js';
import { cities, serveCity } from './support/vicusServer.js';
import { Visitor } from './support/Visitor.js';

const kShots = process.env.VICUS_SHOTS ?? 'out';
const [[name, make]] = Object.entries(cities());

test(`a visitor of ${name} finds a place and is walked there`, { timeout: 900000 }, async t => {
    mkdirSync(kShots, { recursive: true });
    const server = await serveCity(make), browser = await openBrowser({ width: 1280, height: 760 });
    t.after(async () => {
        await browser.close();
        await server.stop();
    });
    const streets = (await (await fetch(`${server.origin}/collections/sectors/items?limit=10000`)).json()).features
        .map(({ properties }) => properties.name).filter(Boolean);
    const goal = streets.at(-1);
    const visitor = await Visitor.open(browser.context, `${server.origin}/`), { page, complaints } = visitor;
    await visitor.streetTime();
    const shoot = label => page.screenshot({ path: join(kShots, `${name}-${label}.png`) });

    await t.test('by the keyboard, with a typing error', async () => {
        await page.keyboard.press('KeyF');
        const wrong = goal.replace(/(.)(.)(.)$/, '$1$3$2');   // the last two letters swapped
        await page.keyboard.type(wrong);
        await page.waitForSelector('#find-to-list li');
        await page.keyboard.press('ArrowDown');
        assert.equal(await page.getAttribute('#find-to', 'aria-activedescendant'), 'find-to-list-0');
        await shoot('find');
        assert.deepEqual(await faultsOfPage(page), []);
        await page.keyboard.press('Enter');
        assert.equal(await page.inputValue('#find-to'), goal);
    });

    await t.test('plays to the end, step by step', async () => {
        const before = (await visitor.now()).pose;
        await page.keyboard.press('Enter');
        await page.waitForSelector('#player:not([hidden])', { timeout: 60000 });
        const tour = await page.evaluate(() => window.vicus.player.tour);
        assert.ok(tour.length > 5, `${tour.length} m`);
        assert.ok(Math.hypot(tour.points[0][0] - before.east, tour.points[0][1] - before.north) < 1, 'it begins where the visitor is');
        await page.selectOption('#tour-speed', '8');
        await page.waitForTimeout(4000);
        await page.click('#tour-steps-button');
        await shoot('tour');
        assert.deepEqual(await faultsOfPage(page), []);
        await page.waitForFunction(() => {
            const { player } = window.vicus;
            return player.walked >= player.walk.length && !player.isPlaying;
        }, null, { timeout: 600000 });
        const { pose, current } = await visitor.now(), end = tour.points.at(-1);
        assert.ok(Math.hypot(pose.east - end[0], pose.north - end[1]) < 0.1);
        await visitor.isIn(tour.sectors.at(-1).id, 60);
        assert.equal(current && complaints.length, 0, complaints.join('\n'));
    });

    await t.test('steering pauses, a link plays it again', async () => {
        const url = page.url();
        assert.match(url, /[?&]from=.*[?&]to=/);
        await page.focus('#window');
        await page.keyboard.press('KeyK');   // from the beginning
        await page.waitForFunction(() => window.vicus.player.isPlaying);
        await page.keyboard.down('KeyW');
        await page.waitForFunction(() => !window.vicus.player.isPlaying);
        await page.keyboard.up('KeyW');
        const other = await Visitor.open(browser.context, url);
        await other.page.waitForSelector('#player:not([hidden])', { timeout: 120000 });
        assert.deepEqual(other.complaints, []);
        await other.page.close();
    });
});
