/**
 * The table of docs/exports.md: bytes and requests to the first complete street view, the same houses by two ways: the page
 * (X3D in X_ITE) and the 3D Tiles that we export, in CesiumJS. The same eye in both, one after the other, in one run.
 *
 *     vicus build MAP -o city.gpkg
 *     VICUS=.../vicus node tests/bench/streetViews.js city.gpkg [VIEWS]
 *
 * Complete: X_ITE has every file of L_1 and their images, CesiumJS says that all tiles of the view are loaded; nothing is on its
 * way for 1.5 s. Counted is what comes over the line, each file as brotli where that is smaller (both servers do); the
 * libraries apart.
 */
import { execFileSync, spawn } from 'node:child_process';
import { createServer } from 'node:http';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync, constants } from 'node:zlib';
import { openBrowser, openTab } from '../browser/support/chromium.js';
import { vicusProgram } from '../browser/support/vicusServer.js';

const [city, views = '5'] = process.argv.slice(2), kShots = process.env.VICUS_SHOTS;
const kCesium = fileURLToPath(new URL('../../node_modules/cesium/Build/Cesium', import.meta.url));
const kTypes = { '.js': 'text/javascript', '.json': 'application/json', '.glb': 'model/gltf-binary', '.css': 'text/css', '.wasm': 'application/wasm',
    '.png': 'image/png', '.jpg': 'image/jpeg' };
const kQuietMs = 1500, kPatienceMs = 240000;
/** rad: of the smaller side of the view, as the root world has it (city_db/surroundings.hpp). */
const kFieldOfView = 0.95;

/** Cesium asks for tiles of this error in pixels; 16 is its own choice. */
const cesiumPage = ({ lat, lon, up, heading }) => `<!DOCTYPE html><meta charset="utf-8"><style>html, body, #city, .cesium-widget, canvas { margin: 0; width: 100%; height: 100%; }</style>
<div id="city"></div><script>window.CESIUM_BASE_URL = '/cesium/';</script><script src="/cesium/Cesium.js"></script>
<script type="module">
const widget = new Cesium.CesiumWidget('city', { baseLayer: false, globe: false, skyBox: false, skyAtmosphere: false, requestRenderMode: false });
widget.scene.backgroundColor = Cesium.Color.LIGHTSKYBLUE;
widget.clock.currentTime = Cesium.JulianDate.fromIso8601('2026-06-21T10:00:00Z');
widget.clock.shouldAnimate = false;
widget.camera.frustum.fov = 2 * Math.atan(Math.tan(${kFieldOfView} / 2) * Math.max(1, innerWidth / innerHeight));   // of the larger side
widget.camera.frustum.near = 0.2;
widget.camera.setView({ destination: Cesium.Cartesian3.fromDegrees(${lon}, ${lat}, ${up}), orientation: { heading: ${heading}, pitch: 0, roll: 0 } });
const tileset = await Cesium.Cesium3DTileset.fromUrl('/tiles/tileset.json');
widget.scene.primitives.add(tileset);
window.isComplete = () => tileset.tilesLoaded && tileset.statistics.selected > 0;
</script>`;

/** Files of folders as any web server sends them, brotli where it is smaller. */
function serveFolders(folders, page) {
    const coded = new Map();
    const server = createServer((request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, 'http://here').pathname));
        if (path === '/') return response.writeHead(200, { 'content-type': 'text/html' }).end(page());
        const mount = Object.keys(folders).find(prefix => path.startsWith(prefix)), file = mount && join(folders[mount], path.slice(mount.length));
        if (!file || !existsSync(file) || !statSync(file).isFile()) return response.writeHead(path === '/favicon.ico' ? 204 : 404).end();
        if (!coded.has(file)) {
            const plain = readFileSync(file), br = brotliCompressSync(plain, { params: { [constants.BROTLI_PARAM_QUALITY]: 6 } });
            coded.set(file, br.length < plain.length ? [br, 'br'] : [plain, null]);
        }
        const [bytes, coding] = coded.get(file);
        response.writeHead(200, { 'content-type': kTypes[extname(file)] ?? 'application/octet-stream', ...(coding ? { 'content-encoding': coding } : {}) });
        return response.end(bytes);
    });
    return new Promise(resolve => server.listen(0, '127.0.0.1', () => resolve({ origin: `http://127.0.0.1:${server.address().port}`, server })));
}

function startVicus() {
    const child = spawn(vicusProgram, ['serve', city, '--bind', '127.0.0.1', '--port', '0'], { stdio: ['ignore', 'pipe', 'ignore'] });
    return new Promise(resolve => {
        let said = '';
        child.stdout.on('data', chunk => {
            const address = (said += chunk).match(/http:\/\/[^\s"]+:\d+/);
            if (address) resolve({ origin: address[0], stop: () => child.kill('SIGTERM') });
        });
    });
}

/** Sectors' own viewpoints, spread over the city: { id, pose for the page, place on earth for Cesium }. */
async function posesOf(origin, count) {
    const { features } = await (await fetch(`${origin}/collections/sectors/items?limit=10000`)).json();
    const streets = features.filter(({ properties: { kind } }) => kind === 'street' || kind === 'square').sort((a, b) => (a.id < b.id ? -1 : 1));
    const root = await (await fetch(`${origin}/city.x3d`)).text(), [lat0, lon0] = root.match(/name='origin' content='([^']*)'/)[1].split(' ').map(Number);
    const poses = [];
    for (let i = 0; i < count; ++i) {
        const { id } = streets[Math.floor((i + 0.5) * streets.length / count)];
        const { viewpoints: [view] } = await (await fetch(`${origin}/sectors/${id}.json`)).json();
        const [east, north] = view.at, radius = 6378137, e2 = 0.00669437999014, phi = lat0 * Math.PI / 180, w = Math.sqrt(1 - e2 * Math.sin(phi) ** 2);
        const lat = lat0 + north / (radius * (1 - e2) / w ** 3) * 180 / Math.PI, lon = lon0 + east / (radius / w * Math.cos(phi)) * 180 / Math.PI;
        poses.push({ id, east, north, heading: view.heading, earth: { lat, lon, up: view.eye, heading: view.heading * Math.PI / 180 } });
    }
    return poses;
}

/** { bytes, requests } of the city alone, { bytes } of the library and page, once `isComplete` has held for a while. */
async function measure(url, isComplete, isLibrary, shot) {
    const browser = await openBrowser();
    try {
        const tab = await openTab(browser.context), { page } = tab, begun = Date.now();
        await page.goto(url);
        for (let since = 0; !since || Date.now() - since < kQuietMs; await page.waitForTimeout(50)) {
            if (Date.now() - begun > kPatienceMs) throw new Error(`${url}: not complete after ${kPatienceMs / 1000} s`);
            since = await page.evaluate(isComplete) ? since || Date.now() : 0;
        }
        const seconds = (Date.now() - begun - kQuietMs) / 1000;
        if (shot && kShots) await page.screenshot({ path: join(kShots, shot) });
        const own = tab.requests.filter(({ path }) => !isLibrary(path));
        const bytesOf = wanted => [...tab.bytes].reduce((all, [path, bytes]) => all + (wanted(path) ? bytes : 0), 0);
        return { bytes: bytesOf(path => !isLibrary(path)), requests: own.length, library: bytesOf(isLibrary), seconds };
    } finally {
        await browser.close();
    }
}

const folder = mkdtempSync(join(tmpdir(), 'vicus-views-'));
try {
    if (kShots) mkdirSync(kShots, { recursive: true });
    execFileSync(vicusProgram, ['export', city, '--format', '3dtiles', '-o', join(folder, 'tiles'), '--quiet']);
    const vicus = await startVicus(), poses = await posesOf(vicus.origin, Number(views));
    let pose = null;
    const tiles = await serveFolders({ '/tiles/': join(folder, 'tiles'), '/cesium/': kCesium }, () => cesiumPage(pose.earth));
    const inPage = () => Boolean(window.vicus?.visit.here) && window.vicus.view.isIdle() && window.vicus.visit.missing(window.vicus.view.pose()).length === 0
        && window.vicus.visit.sectors.every(({ phase }) => phase === 'live');
    const inCesium = () => Boolean(window.isComplete?.());
    console.log('| view | page: kB | requests | s | CesiumJS: kB | requests | s | bytes | requests |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|');
    const all = [];
    for (pose of poses) {
        const ours = await measure(`${vicus.origin}/?start=${pose.id}&i=1#${pose.east},${pose.north},${pose.heading}`, inPage,
            path => path.startsWith('/x_ite/') || path.startsWith('/client/') || path === '/', `view-${pose.id}-page.png`);
        const theirs = await measure(`${tiles.origin}/`, inCesium, path => path.startsWith('/cesium/') || path === '/', `view-${pose.id}-cesium.png`);
        all.push([ours, theirs]);
        const kB = bytes => Math.round(bytes / 1000);
        console.log(`| ${pose.id} | ${kB(ours.bytes)} | ${ours.requests} | ${ours.seconds.toFixed(1)} | ${kB(theirs.bytes)} | ${theirs.requests} | `
            + `${theirs.seconds.toFixed(1)} | ${(ours.bytes / theirs.bytes).toFixed(2)} | ${(ours.requests / theirs.requests).toFixed(2)} |`);
    }
    const mean = f => all.reduce((sum, pair) => sum + f(pair), 0) / all.length;
    console.log(`\nlibrary and page, kB: X_ITE ${Math.round(mean(([ours]) => ours.library) / 1000)}, CesiumJS ${Math.round(mean(([, theirs]) => theirs.library) / 1000)}`);
    vicus.stop();
    tiles.server.closeAllConnections();
    tiles.server.close();
} finally {
    rmSync(folder, { recursive: true, force: true });
}
