import assert from 'node:assert/strict';
import test from 'node:test';
import { idOf } from '../../client_scripts/core/sectorRecord.js';
import { openBrowser, openTab } from './support/chromium.js';
import { CityMap, startWithRoute } from './support/cityMap.js';
import { cities, serveCity } from './support/vicusServer.js';

const kGates = 3;

/** Nothing of ours but the world: X_ITE and an x3d-canvas. */
const bareWorld = file => `<!DOCTYPE html><script type="module" src="/x_ite/15.0.1/dist/x_ite.min.mjs"></script>
<x3d-canvas src="${file}" splashScreen="false" notifications="false" style="width: 640px; height: 480px"></x3d-canvas>`;

const [[name, make]] = Object.entries(cities());
for (const format of ['x3d', 'wrl']) test(`the .${format} world of ${name} works without the page`, { timeout: 600000 }, async t => {
    const server = await serveCity(make), browser = await openBrowser();
    t.after(async () => {
        await browser.close();
        await server.stop();
    });
    const map = new CityMap(server.origin), start = await startWithRoute(map, kGates);
    const route = await map.route(start, kGates);
    const tab = await openTab(browser.context);
    const body = bareWorld(`/city.${format}?start=${start}&i=1`);
    await tab.page.route('**/bare.html', reply => reply.fulfill({ contentType: 'text/html', body }));
    await tab.page.goto(`${server.origin}/bare.html`);
    await assertSector(tab.page, map, start, format);
    for (let i = 1; i < route.length; ++i) {
        await moveTo(tab.page, await map.gateMiddle(route[i - 1], route[i]));
        await moveTo(tab.page, (await map.wallsToRunInto(route[i]))[0].stand);
        await assertSector(tab.page, map, route[i], format);
    }
    assert.deepEqual(tab.complaints, []);
    assert.ok(tab.requests.every(({ path }) => !/^\/client\/(page|bundle)\//.test(path)), 'the page took part');
});

/** The LOADER says `id`, and L_1 of it is there: live Inlines (X3D) or what the Script fetched (VRML97, near files alone). */
async function assertSector(page, map, id, format) {
    const files = await map.filesAround(id), wanted = format === 'wrl' ? files.map(idOf) : files;
    await page.waitForFunction(({ id, wanted }) => {
        const scene = document.querySelector('x3d-canvas')?.browser?.currentScene;
        const loader = scene && Array.from(scene.rootNodes).length ? scene.getNamedNode('LOADER') : null;
        if (loader?.sector_changed !== id) return false;
        const contents = Array.from(scene.getNamedNode('WORLD').children).flatMap(place => Array.from(place.children ?? []));
        const live = contents.map(node => {
            if (node.getNodeTypeName() === 'Anchor') return JSON.parse(node.parameter[0]).id;
            const isLive = node.getNodeTypeName() === 'Inline' && node.load && node.getValue().checkLoadState() === 1008;
            return isLive ? node.url[0].replace(/^.*\/|\.x3d$/g, '') : '';
        });
        return wanted.every(stem => live.includes(stem) || live.includes(stem.split('.')[0]));
    }, { id, wanted }, { timeout: 180000, polling: 100 });
}

/** Moves the eye in a straight line, 0.5 m a frame, as a navigation paradigm would. */
async function moveTo(page, [east, north]) {
    // X_ITE binds a world's viewpoint once nothing is on its way, pictures in gates included.
    await page.waitForFunction(() => document.querySelector('x3d-canvas').browser.activeViewpoint, null, { timeout: 120000 });
    await page.evaluate(async ([east, north]) => {
        const { browser } = document.querySelector('x3d-canvas');
        for (let left = 1; left > 0;) {
            const view = browser.activeViewpoint.getValue(), at = view.getUserPosition().copy();
            const dx = east - at.x, dz = -north - at.z;
            left = Math.hypot(dx, dz);
            const share = Math.min(1, 0.5 / (left || 1));
            at.x += share * dx;
            at.z += share * dz;
            view.setUserPosition(at);
            left -= 0.5;
            await new Promise(requestAnimationFrame);
        }
    }, [east / 1000, north / 1000]);
}
