import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { faultsOfPage } from './support/accessibility.js';
import { openBrowser } from './support/chromium.js';
import { CityMap, startWithRoute } from './support/cityMap.js';
import { cities, serveCity } from './support/vicusServer.js';
import { Visitor } from './support/Visitor.js';

const kShots = process.env.VICUS_SHOTS ?? 'out';
const [[name, make]] = Object.entries(cities());

test(`what else a visitor of ${name} can do`, { timeout: 900000 }, async t => {
    mkdirSync(kShots, { recursive: true });
    const server = await serveCity(make), browser = await openBrowser({ width: 1280, height: 760 });
    const phone = await openBrowser({ width: 390, height: 780, hasTouch: true });
    t.after(async () => {
        await browser.close();
        await phone.close();
        await server.stop();
    });
    const map = new CityMap(server.origin), start = await startWithRoute(map, 2), [, neighbour] = await map.route(start, 1);
    const open = async (context = browser.context, rest = '') => {
        const visitor = await Visitor.open(context, `${server.origin}/?start=${start}&i=1${rest}`);
        await visitor.streetTime();
        return visitor;
    };
    /** The near files are there, and two seconds have passed for others. */
    const nearby = async ({ page }) => {
        await page.waitForFunction(() => {
            const { here, sectors } = window.vicus.visit, near = new Set(sectors.filter(({ record }) => record).map(({ stem }) => stem));
            return here && here.gates.every(({ to }) => !to || near.has(to));
        }, null, { timeout: 120000 });
        await page.waitForTimeout(2000);
    };
    const shoot = (page, label) => page.screenshot({ path: join(kShots, `${name}-${label}.png`) });
    const isIn = (page, id) => page.waitForFunction(id => window.vicus.visit.current === id, id, { timeout: 60000 });

    await t.test('the page runs under script-src \'self\', without a Script node', async () => {
        const policy = (await fetch(`${server.origin}/`)).headers.get('Content-Security-Policy');
        assert.match(policy, /script-src 'self';/);
        const { page, complaints } = await open();
        const evalWorks = await page.evaluate(() => {
            const script = document.createElement('script');
            script.textContent = 'window.hasRun = true';
            document.head.append(script);
            return Boolean(window.hasRun);
        });
        assert.equal(evalWorks, false, 'the policy holds');
        complaints.splice(0);
        const scripts = await page.evaluate(() => Array.from(window.vicus.view.browser.currentScene.rootNodes).filter(node => node.getNodeTypeName() === 'Script').length);
        assert.equal(scripts, 0);
        await page.close();
    });

    await t.test('a click on the ground walks there, keys work afterwards, steering ends the walk', async () => {
        const visitor = await open(), { page } = visitor;
        await nearby(visitor);
        const before = (await visitor.now()).pose;
        await page.mouse.click(450, 600);
        await page.waitForFunction(() => window.vicus.travel.goTo.goal === null, null, { timeout: 60000 });
        const { pose, current } = await visitor.now(), walked = Math.hypot(pose.east - before.east, pose.north - before.north);
        assert.ok(walked > 1 && walked < 12, `${walked} m`);
        await page.keyboard.press('KeyN');
        await page.waitForFunction(pose => Math.hypot(window.vicus.view.pose().east - pose.east, window.vicus.view.pose().north - pose.north) > 0.9, pose);
        assert.deepEqual(visitor.complaints, []);
        assert.ok(current);
        await page.close();
    });

    await t.test('next and previous viewpoint: there and back', async () => {
        const visitor = await open(), { page } = visitor;
        await nearby(visitor);
        await page.click('#view-next');
        await page.waitForFunction(() => window.vicus.travel.viewpoints.at === 0);
        await page.waitForTimeout(600);
        const first = (await visitor.now()).pose;
        await page.keyboard.press('PageDown');
        await page.waitForTimeout(600);
        const second = (await visitor.now()).pose;
        assert.ok(Math.hypot(first.east - second.east, first.north - second.north) > 1);
        await page.keyboard.press('PageUp');
        await page.waitForTimeout(600);
        const back = (await visitor.now()).pose;
        assert.ok(Math.hypot(first.east - back.east, first.north - back.north) < 0.01);
        await page.close();
    });

    await t.test('a click on the map goes there, and the document follows', async () => {
        const visitor = await open(), { page } = visitor;
        await nearby(visitor);
        await page.waitForFunction(id => window.vicus.plan.houses.size > 0 && window.vicus.plan.sectors.has(id), neighbour);
        await page.check('#map-seen');
        await page.waitForTimeout(500);
        await shoot(page, 'map');
        const record = await map.record(neighbour), [east, north] = (await map.wallsToRunInto(neighbour))[0].stand.map(mm => mm / 1000);
        const spot = await page.evaluate(place => window.vicus.map.pixel(place), [east, north]);
        await page.click('#map', { position: { x: spot[0], y: spot[1] } });
        await isIn(page, neighbour);
        const { pose } = await visitor.now();
        assert.ok(Math.hypot(pose.east - east, pose.north - north) < 2, 'where the map was clicked');
        await nearby(visitor);
        await page.waitForFunction(text => document.getElementById('document-title').textContent === text, record.name || 'A crossroads');
        assert.match(await page.textContent('#document-parts'), /From here to/);
        assert.equal(await page.textContent('#document-rights'), await page.evaluate(() => window.vicus.world.rights));
        assert.deepEqual(visitor.complaints, []);
        await page.close();
    });

    await t.test('a neighbouring place is reached by keyboard alone', async () => {
        const visitor = await open(), { page } = visitor, record = await map.record(start);
        await nearby(visitor);
        await page.waitForSelector('#document-parts button');
        const goal = await page.evaluate(() => {
            const button = [...document.querySelectorAll('#document-parts section')].find(part => /From here/.test(part.textContent)).querySelector('button');
            button.focus();
            return button.textContent;
        });
        await page.keyboard.press('Enter');
        await page.waitForFunction(id => window.vicus.visit.current !== id, start, { timeout: 60000 });
        const { current } = await visitor.now(), there = await map.record(current);
        assert.ok(record.gates.some(gate => gate.to === current), `${current} is behind a gate`);
        if (there.name) assert.equal(goal, there.name);
        await page.close();
    });

    await t.test('buttons walk, turn and look up, by mouse and by keyboard', async () => {
        const visitor = await open(), { page } = visitor;
        await nearby(visitor);
        await page.keyboard.press('KeyB');
        const before = (await visitor.now()).pose, press = label => page.locator(`#pad [aria-label="${label}"]`);
        const until = (say, condition) => page.waitForFunction(condition, before, { timeout: 30000 }).catch(() => assert.fail(say));
        await press('Forward').click({ delay: 700 });
        await until('forward', ({ east, north }) => {
            const pose = window.vicus.view.pose();
            return Math.hypot(pose.east - east, pose.north - north) > 0.4;
        });
        await press('Turn right').focus();
        await page.keyboard.press('Enter');
        await until('turn right', ({ heading }) => window.vicus.view.pose().heading - heading > 0.2);
        await press('Look up').click({ delay: 400 });
        await until('look up', () => window.vicus.view.pose().pitch > 0.1);
        await shoot(page, 'buttons');
        await press('Look straight ahead').click();
        await until('level', () => Math.abs(window.vicus.view.pose().pitch) < 0.01);
        await page.close();
    });

    await t.test('a shared link restores i and how the visitor looks up', async () => {
        const visitor = await open(), { page } = visitor;
        await nearby(visitor);
        await page.evaluate(() => { window.vicus.view.setPose({ ...window.vicus.view.pose(), pitch: 0.3 }); });
        await page.keyboard.press('KeyL');
        await page.waitForFunction(() => location.hash);
        const guest = await Visitor.open(browser.context, page.url());
        await guest.streetTime();
        const { level, choice } = await guest.page.evaluate(() => ({ level: window.vicus.visit.level, choice: window.vicus.visit.planner.choice.fixed }));
        assert.deepEqual([level, choice], [1, 1]);
        assert.ok(Math.abs((await guest.now()).pose.pitch - 0.3) < 0.02);
        await guest.page.close();
        await page.close();
    });

    await t.test('requests that are no longer wanted are given up', async () => {
        const visitor = await Visitor.open(browser.context, 'about:blank'), { page } = visitor, aborted = new Set();
        page.on('requestfailed', request => { if (request.failure()?.errorText === 'net::ERR_ABORTED') aborted.add(new URL(request.url()).pathname); });
        await page.route(/\/parcels\?files=[^&]*\.(far|tall)/, () => {});   // never answered
        await page.goto(`${server.origin}/?start=${start}&i=1`);
        await page.waitForFunction(() => window.vicus?.visit.sectors.some(({ stem, phase }) => stem.includes('.') && phase === 'loading'), null, { timeout: 120000 });
        await page.keyboard.press('KeyO');
        await page.waitForTimeout(500);
        assert.match(await page.textContent('#figures'), /On the way[1-9]/);
        // Away from all gates, so that L_0 is the sector alone: a parcel is given up when nobody wants any more of it.
        await page.evaluate(() => { window.vicus.view.setPose({ ...window.vicus.view.pose(), east: 20000 }); });
        await page.selectOption('#set-level', '0');
        await page.waitForFunction(() => window.vicus.visit.sectors.every(({ stem }) => !stem.includes('.')));
        await page.waitForTimeout(300);
        assert.deepEqual([...aborted], ['/parcels']);
        await page.close();
    });

    await t.test('nothing that axe would call serious: panels open and closed, wide and on a phone', async () => {
        for (const context of [browser.context, phone.context]) {
            const visitor = await open(context), { page } = visitor, size = context === phone.context ? 'phone' : 'wide';
            await nearby(visitor);
            if (!await page.isVisible('#side')) await page.click('#side-button');
            await page.waitForSelector('#document-parts section');
            await page.waitForTimeout(500);
            await shoot(page, `${size}-side`);
            assert.deepEqual(await faultsOfPage(page), [], `${size}, side`);
            await page.click('#side-button');
            await page.click('#pad-button');
            assert.deepEqual(await faultsOfPage(page), [], `${size}, buttons`);
            for (const dialog of ['settings', 'help']) {
                await page.click(`#${dialog}-button`);
                await page.waitForTimeout(300);
                await shoot(page, `${size}-${dialog}`);
                assert.deepEqual(await faultsOfPage(page), [], `${size}, ${dialog}`);
                assert.equal(await page.evaluate(() => document.activeElement.id), `${dialog}-close`);
                await page.keyboard.press('Escape');
                assert.equal(await page.evaluate(() => document.activeElement.id), 'window');
            }
            const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
            assert.equal(wide, false, 'nothing hangs over the edge');
            await page.close();
        }
    });
});
