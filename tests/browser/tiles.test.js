// What `vicus export --format 3dtiles` writes, read by somebody else: Khronos' glTF validator and CesiumJS.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createReadStream, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import validator from 'gltf-validator';
import { openBrowser, openTab } from './support/chromium.js';
import { cities, vicusProgram } from './support/vicusServer.js';

const kCesium = fileURLToPath(new URL('../../node_modules/cesium/Build/Cesium', import.meta.url));
const kTypes = { '.js': 'text/javascript', '.json': 'application/json', '.glb': 'model/gltf-binary', '.css': 'text/css',
    '.wasm': 'application/wasm', '.html': 'text/html', '.png': 'image/png', '.jpg': 'image/jpeg' };
/** The city from above at 40 degrees, nothing else: no globe, no imagery, nothing from elsewhere. */
const kPage = `<!DOCTYPE html><meta charset="utf-8"><style>html, body, #city, .cesium-widget, canvas { margin: 0; width: 100%; height: 100%; }</style>
<div id="city"></div><script>window.CESIUM_BASE_URL = '/cesium/';</script><script src="/cesium/Cesium.js"></script>
<script type="module">
const widget = new Cesium.CesiumWidget('city', { baseLayer: false, globe: false, skyBox: false, skyAtmosphere: false,
    requestRenderMode: false, contextOptions: { webgl: { preserveDrawingBuffer: true } } });
widget.scene.backgroundColor = Cesium.Color.WHITE;
widget.clock.currentTime = Cesium.JulianDate.fromIso8601('2026-06-21T10:00:00Z');
widget.clock.shouldAnimate = false;
const tileset = await Cesium.Cesium3DTileset.fromUrl('/tiles/tileset.json');
widget.scene.primitives.add(tileset);
window.failed = [];
tileset.tileFailed.addEventListener(failure => window.failed.push(failure.url + ': ' + failure.message));
const look = (heading, pitch, range) => {
    const { center } = tileset.boundingSphere;
    const place = Cesium.Transforms.eastNorthUpToFixedFrame(center);
    widget.camera.lookAtTransform(place, new Cesium.HeadingPitchRange(heading, pitch, range));
    window.quietSince = 0;
};
window.vicus = { widget, tileset, look };
</script>`;

const [[name, make]] = Object.entries(cities());

test(`glTF and 3D Tiles of ${name} are read by others`, { timeout: 600000 }, async t => {
    const folder = mkdtempSync(join(tmpdir(), 'vicus-tiles-')), tiles = join(folder, 'tiles');
    t.after(() => rmSync(folder, { recursive: true, force: true }));
    const city = make(folder);
    for (const coding of ['draco', 'meshopt']) {
        const out = join(tiles, coding);
        execFileSync(vicusProgram, ['export', city, '--format', '3dtiles', '--coding', coding, '-o', out, '--quiet']);
        await t.test(`${coding}: no file has an error or a warning of the glTF validator`, () => assertValid(join(out, 'sectors')));
        await t.test(`${coding}: CesiumJS draws the city`, () => assertDrawn(out, coding));
    }
});

async function assertValid(folder) {
    const files = readdirSync(folder);
    assert.ok(files.length > 100);
    for (const file of files) {
        const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(join(folder, file))));
        assert.equal(issues.numErrors + issues.numWarnings, 0, `${file}: ${JSON.stringify(issues.messages.slice(0, 3))}`);
    }
}

async function assertDrawn(tiles, coding) {
    const server = await serveFolders({ '/tiles/': tiles, '/cesium/': kCesium }), browser = await openBrowser();
    try {
        const { page, complaints } = await openTab(browser.context);
        await page.goto(`${server.origin}/`);
        await page.waitForFunction(() => window.vicus, null, { timeout: 120000 });
        for (const [shot, ...view] of [['tiles-above', 0.4, -0.7, 420], ['tiles-near', 3.6, -0.3, 70]]) {
            await page.evaluate(view => window.vicus.look(...view), view);
            // A new view is noticed in the next frame only.
            await page.waitForFunction(() => {
                const { tileset } = window.vicus, quiet = tileset.tilesLoaded && tileset.statistics.selected > 0;
                window.quietSince = quiet ? window.quietSince || performance.now() : 0;
                return quiet && performance.now() - window.quietSince > 3000;
            }, null, { timeout: 240000 });
            const colours = await page.evaluate(coloursSeen);
            if (process.env.VICUS_SHOTS) {
                mkdirSync(process.env.VICUS_SHOTS, { recursive: true });
                await page.screenshot({ path: join(process.env.VICUS_SHOTS, `${shot}-${coding}.png`) });
            }
            assert.ok(colours.covered > 0.3, `${shot}: the city covers ${colours.covered} of the window`);
            assert.ok(colours.kinds > 30, `${shot}: ${colours.kinds} colours`);
            if (shot === 'tiles-near') assert.ok(await page.evaluate(nearTiles) > 0, 'no tile is refined close by');
        }
        assert.deepEqual(await page.evaluate(() => window.failed), []);
        assert.deepEqual(complaints, []);
    } finally {
        await browser.close();
        await server.stop();
    }
}

/** Tiles drawn with their facades. */
function nearTiles() {
    return window.vicus.tileset._selectedTiles.filter(tile => !tile._contentResource.url.includes('.far.')).length;
}

/** Share of pixels that are not the white background, and colours in steps of 16. */
function coloursSeen() {
    const { canvas } = window.vicus.widget, copy = document.createElement('canvas');
    Object.assign(copy, { width: canvas.width, height: canvas.height });
    const context = copy.getContext('2d');
    window.vicus.widget.render();
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height), kinds = new Set();
    let covered = 0;
    for (let i = 0; i < data.length; i += 4) {
        covered += data[i] + data[i + 1] + data[i + 2] < 750;
        kinds.add((data[i] >> 4 << 8) | (data[i + 1] >> 4 << 4) | data[i + 2] >> 4);
    }
    return { covered: covered / (data.length / 4), kinds: kinds.size };
}

/** A plain web server, as any user of an export has one: { origin, stop }. */
function serveFolders(folders) {
    const server = createServer((request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, 'http://here').pathname));
        if (path === '/') return response.writeHead(200, { 'content-type': 'text/html' }).end(kPage);
        const mount = Object.keys(folders).find(prefix => path.startsWith(prefix));
        const file = mount && join(folders[mount], path.slice(mount.length));
        if (!file || !existsSync(file) || !statSync(file).isFile()) return response.writeHead(path === '/favicon.ico' ? 204 : 404).end();
        response.writeHead(200, { 'content-type': kTypes[extname(file)] ?? 'application/octet-stream' });
        createReadStream(file).pipe(response);
    });
    return new Promise(resolve => server.listen(0, '127.0.0.1', () => resolve({
        origin: `http://127.0.0.1:${server.address().port}`,
        stop: () => new Promise(done => {
            server.closeAllConnections();
            server.close(done);
        }),
    })));
}
