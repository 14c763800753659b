import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { openBrowser, openTab } from './support/chromium.js';
import { CityMap, startWithRoute } from './support/cityMap.js';
import { cities, serveCity } from './support/vicusServer.js';

process.env.VICUS_BUILD_OPTIONS = '--impostors yes --over-roofs no --panoramas yes';

const kShots = process.env.VICUS_SHOTS ?? 'out';
const [[name, make]] = Object.entries(cities());

test(`pictures in the gates of ${name}`, { timeout: 1800000 }, async t => {
    mkdirSync(kShots, { recursive: true });
    const server = await serveCity(make), browser = await openBrowser({ width: 960, height: 600 });
    t.after(async () => {
        await browser.close();
        await server.stop();
    });
    const map = new CityMap(server.origin), start = await startWithRoute(map, 1), [, neighbour] = await map.route(start, 1);
    const gate = (await map.record(start)).gates.find(({ to, impostor }) => to === neighbour && impostor);
    assert.ok(gate, `the gate from ${start} to ${neighbour} has a picture`);

    await t.test('a picture is small, is a PNG and stays in the cache', async () => {
        const response = await fetch(`${server.origin}/${gate.impostor.url}`), body = await response.arrayBuffer();
        assert.equal(response.headers.get('Content-Type'), 'image/png');
        assert.ok(response.headers.get('ETag'));
        assert.ok(body.byteLength < 16000, `${body.byteLength} bytes`);
    });

    await t.test('the picture is there while the sector behind is on its way, and gone afterwards', async () => {
        const tab = await openTab(browser.context), { page } = tab;
        let release;
        const released = new Promise(resolve => { release = resolve; });
        await page.route(new RegExp(`/parcels\\?files=([^&]*,)?${neighbour}(\\.far)?[,&]`), async route => {
            await released;
            await route.continue().catch(() => {});   // given up meanwhile
        });
        await page.goto(`${server.origin}/?start=${start}&i=1`);
        await page.waitForFunction(() => window.vicus?.visit.firstStreetAt, null, { timeout: 180000 });
        const [east, north] = middle(gate.line);
        await page.evaluate(([east, north]) => {
            const { view } = window.vicus, pose = view.pose();
            view.setPose({ ...pose, heading: Math.atan2(east - pose.east, north - pose.north), pitch: 0 });
        }, [east, north]);
        await page.waitForFunction(shown, { start, gate: gate.id, is: true }, { timeout: 180000 });
        await page.waitForFunction(() => window.vicus.view.isIdle(), null, { timeout: 180000 }).catch(() => {});
        await page.waitForTimeout(1500);
        await page.screenshot({ path: join(kShots, `${name}-impostor.png`) });
        assert.ok(tab.requests.some(({ path }) => path === `/${gate.impostor.url}`), 'the picture was fetched');
        release();
        await page.waitForFunction(shown, { start, gate: gate.id, is: false }, { timeout: 180000 });
        await page.waitForTimeout(1000);
        await page.screenshot({ path: join(kShots, `${name}-no-impostor.png`) });
        assert.deepEqual(tab.complaints, []);
        await page.close();
    });

    await t.test('the world without the page does the same', async () => {
        const tab = await openTab(browser.context), { page } = tab;
        let release;
        const released = new Promise(resolve => { release = resolve; });
        await page.route(new RegExp(`/sectors/${neighbour}(\\.far)?\\.x3d`), async route => {
            await released;
            await route.continue().catch(() => {});
        });
        const body = `<!DOCTYPE html><script type="module" src="/x_ite/15.0.1/dist/x_ite.min.mjs"></script>
<x3d-canvas src="/city.x3d?start=${start}&i=1" splashScreen="false" notifications="false" style="width: 640px; height: 480px"></x3d-canvas>`;
        await page.route('**/bare.html', reply => reply.fulfill({ contentType: 'text/html', body }));
        await page.goto(`${server.origin}/bare.html`);
        await page.waitForFunction(shownBare, { node: `IMPOSTOR-${gate.id}`, is: true }, { timeout: 180000, polling: 100 });
        release();
        await page.waitForFunction(shownBare, { node: `IMPOSTOR-${gate.id}`, is: false }, { timeout: 180000, polling: 100 });
        assert.deepEqual(tab.complaints, []);
        await page.close();
    });

    await t.test('an open sector has a picture around it while one is there, in the page and without it', async () => {
        const { features } = await (await fetch(`${server.origin}/collections/sectors/items?limit=1000`)).json();
        const open = features.filter(({ properties: { kind } }) => kind === 'square' || kind === 'open').map(({ id }) => id);
        const records = await Promise.all(open.map(id => map.record(id))), square = records.find(({ panorama }) => panorama);
        assert.ok(square, 'no open sector of the town sees beyond its L_vis');
        const tab = await openTab(browser.context), { page } = tab;
        await page.goto(`${server.origin}/?start=${square.id}&i=1`);
        await page.waitForFunction(panoramaShown, { id: square.id, is: true }, { timeout: 180000 });
        const isFetched = () => tab.requests.some(({ path }) => path === `/${square.panorama.url}`);
        for (let i = 0; i < 100 && !isFetched(); ++i) await page.waitForTimeout(100);
        assert.ok(isFetched(), 'the picture was fetched');
        const [east, north] = square.panorama.eye;
        await page.waitForFunction(() => window.vicus.view.isIdle(), null, { timeout: 180000 }).catch(() => {});
        await page.screenshot({ path: join(kShots, `${name}-panorama.png`) });
        const next = square.gates.find(({ to }) => to);
        await page.evaluate(id => window.vicus.travel.toSector(id), next.to);
        await page.waitForFunction(panoramaShown, { id: square.id, is: false }, { timeout: 180000 });
        assert.ok(Math.hypot(east - next.line[0][0], north - next.line[0][1]) < 200, 'it was taken in the square');
        assert.deepEqual(tab.complaints, []);
        await page.goto('about:blank');
        const body = `<!DOCTYPE html><script type="module" src="/x_ite/15.0.1/dist/x_ite.min.mjs"></script>
<x3d-canvas src="/city.x3d?start=${square.id}&i=1" splashScreen="false" notifications="false" style="width: 640px; height: 480px"></x3d-canvas>`;
        await page.route('**/square.html', reply => reply.fulfill({ contentType: 'text/html', body }));
        await page.goto(`${server.origin}/square.html`);
        await page.waitForFunction(shownBare, { node: 'PANORAMA', is: true }, { timeout: 180000, polling: 100 });
        assert.deepEqual(tab.complaints, []);
        await page.close();
    });
});

function middle(line) {
    const [a, b] = [line[0], line.at(-1)];
    return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}

/* What follows runs in the page. */

function shown({ start, gate, is }) {
    const file = window.vicus.visit.files.files.get(start);
    return file?.phase === 'live' && file.scene.getNamedNode(`IMPOSTOR-${gate}`).visible === is;
}

function panoramaShown({ id, is }) {
    const file = window.vicus?.visit.files.files.get(id);
    return file?.phase === 'live' && file.scene.getNamedNode('PANORAMA').visible === is;
}

function shownBare({ node, is }) {
    const scene = document.querySelector('x3d-canvas')?.browser?.currentScene;
    if (!scene || !Array.from(scene.rootNodes).length) return false;
    const inline = scene.getNamedNode('WORLD').children[0].children[0];
    try {
        return inline.getValue().getInternalScene().getNamedNode(node).visible === is;
    } catch {
        return false;
    }
}
