import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { openBrowser, openTab } from './support/chromium.js';
import { CityMap, firstDoor, startWithRoute } from './support/cityMap.js';
import { cities, serveCity } from './support/vicusServer.js';
import { Visitor } from './support/Visitor.js';

const kShots = process.env.VICUS_SHOTS ?? 'out';

const [[name, make]] = Object.entries(cities());
test(`a walk in ${name} by X3DOM`, { timeout: 600000 }, async t => {
    mkdirSync(kShots, { recursive: true });
    const server = await serveCity(make), browser = await openBrowser();
    t.after(async () => {
        await browser.close();
        await server.stop();
    });
    const map = new CityMap(server.origin), start = await startWithRoute(map, 2);
    const [, next] = await map.route(start, 2);
    const visitor = new X3domVisitor(await openTab(browser.context)), { page } = visitor;
    const policies = [];
    page.on('response', response => { if (response.url().includes('/x3dom.html')) policies.push(response.headers()['content-security-policy']); });
    await page.goto(`${server.origin}/x3dom.html?start=${start}&i=1`);

    await visitor.isIn(start, 120);
    await visitor.has(await map.filesAround(start));
    await page.waitForTimeout(1500);
    await page.screenshot({ path: join(kShots, 'x3dom-start.png') });
    assert.ok(await colours(page) > 60, 'the view is empty');
    assert.deepEqual(await greyTextures(page), [true], 'grain and windows multiply the colours below');

    const way = await map.path(start, await visitor.place(), await map.gateMiddle(start, next));
    const beyond = (await map.wallsToRunInto(next))[0].stand;
    await visitor.walk([...way, beyond], { run: true });
    await visitor.isIn(next, 30);
    await visitor.has(await map.filesAround(next));
    await page.waitForTimeout(1500);
    await page.screenshot({ path: join(kShots, 'x3dom-next.png') });
    assert.ok(await colours(page) > 60, 'the view is empty');

    assert.deepEqual([...new Set(policies)].map(policy => /script-src 'self';/.test(policy)), [true]);
    assert.deepEqual(visitor.complaints, []);
    await page.close();
    if (name === 'town') await t.test('a door opens and leads in', () => goInside(browser, server));
});

/** Whether X3DOM multiplies: of the textures over colours by face, each answer once. */
function greyTextures(page) {
    return page.evaluate(() => {
        const shapes = [...document.querySelectorAll('inline Shape')].filter(shape => shape.querySelector('Color'));
        const textures = shapes.map(shape => shape.querySelector('ImageTexture, PixelTexture')).filter(Boolean);
        return [...new Set(textures.map(texture => texture._x3domNode._blending))];
    });
}

async function goInside(browser, server) {
    const { street, room, door, at, heading } = await firstDoor(server.origin);
    const visitor = new X3domVisitor(await openTab(browser.context)), { page } = visitor;
    await page.goto(`${server.origin}/x3dom.html?start=${street}&i=1`);
    await visitor.isIn(street, 120);
    const [east, north] = at(3);
    await page.evaluate(pose => window.vicus.view.setPose({ ...window.vicus.view.pose(), ...pose }), { east, north, heading, pitch: 0 });
    await page.locator('#door-button').click();
    await page.waitForFunction(id => window.vicus.loader.doors.open.includes(id), door.id, { timeout: 60000 });
    await page.waitForTimeout(1500);
    await page.screenshot({ path: join(kShots, 'x3dom-door.png') });
    await visitor.walk([at(-0.6), at(-2)].map(point => point.map(metres => 1000 * metres)), { run: false, within: 0.4 });
    await visitor.isIn(room.id, 30);
    assert.deepEqual(visitor.complaints, []);
}

/** Walks by the same keys; what is there is asked of the page for X3DOM. */
class X3domVisitor extends Visitor {
    async isIn(id, seconds) {
        await this.page.waitForFunction(id => window.vicus?.loader.planner.current === id && window.vicus.sectors.live().includes(id), id, { timeout: 1000 * seconds });
    }

    /** Waits until these files are there, as far as finer ones do not stand for them. */
    async has(stems) {
        await this.page.waitForFunction(stems => {
            const live = window.vicus.sectors.live();
            return stems.every(stem => live.includes(stem) || live.includes(stem.split('.')[0]));
        }, stems, { timeout: 120000 });
    }

    /** mm */
    async place() {
        const { east, north } = await this.page.evaluate(() => window.vicus.view.pose());
        return [Math.round(1000 * east), Math.round(1000 * north)];
    }
}

/** Different colours in the picture, coarsely: sky alone has few. */
function colours(page) {
    return page.evaluate(() => {
        const canvas = document.querySelector('#window canvas'), copy = document.createElement('canvas');
        [copy.width, copy.height] = [160, 100];
        const context = copy.getContext('2d');
        window.vicus.view.x3d.runtime.canvas.doc.needRender = true;
        return new Promise(resolve => {
            requestAnimationFrame(() => requestAnimationFrame(() => {
                context.drawImage(canvas, 0, 0, 160, 100);
                const { data } = context.getImageData(0, 0, 160, 100), seen = new Set();
                for (let i = 0; i < data.length; i += 4) seen.add(`${data[i] >> 3},${data[i + 1] >> 3},${data[i + 2] >> 3}`);
                resolve(seen.size);
            }));
        });
    });
}
