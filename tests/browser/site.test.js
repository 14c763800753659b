// The city as a folder for a plain web server: the page walks and flies, and nothing answers but files.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { openBrowser, openTab } from './support/chromium.js';
import { cities, vicusProgram } from './support/vicusServer.js';

const kShots = process.env.VICUS_SHOTS ?? 'out', kXIte = fileURLToPath(new URL('../../node_modules/x_ite', import.meta.url));
const kTypes = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.css': 'text/css', '.json': 'application/json',
    '.svg': 'image/svg+xml', '.png': 'image/png', '.x3d': 'model/x3d+xml' };

/** Gives files and nothing else. */
async function serveFolder(folder) {
    const server = createServer((request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, 'http://x').pathname)), file = join(folder, path.endsWith('/') ? `${path}index.html` : path);
        try {
            if (!statSync(file).isFile()) throw new Error('a folder');
            response.writeHead(200, { 'Content-Type': kTypes[extname(file)] ?? 'application/octet-stream' }).end(readFileSync(file));
        } catch {
            response.writeHead(404).end();
        }
    });
    await new Promise(resolve => server.listen(0, '127.0.0.1', resolve));
    return { origin: `http://127.0.0.1:${server.address().port}`, stop: () => server.close() };
}

test('a site without a server is flown over, and landed in far from where one started', { timeout: 600000, skip: !cities().town }, async t => {
    mkdirSync(kShots, { recursive: true });
    const folder = mkdtempSync(join(tmpdir(), 'vicus-site-')), site = join(folder, 'site');
    execFileSync(vicusProgram, ['export', cities().town(folder), '--format', 'site', '--x_ite', kXIte, '-o', site, '--quiet']);
    const server = await serveFolder(site), browser = await openBrowser({ width: 800, height: 500 });
    t.after(async () => {
        await browser.close();
        server.stop();
        rmSync(folder, { recursive: true, force: true });
    });
    const { page, requests, complaints } = await openTab(browser.context);
    await page.goto(`${server.origin}/`);
    await page.waitForFunction(() => window.vicus?.visit.firstStreetAt, null, { timeout: 120000 });
    await page.keyboard.press('KeyV');
    await page.waitForFunction(() => window.vicus.flight.phase === 'flying' && window.vicus.flight.flyover.isSettled, null, { timeout: 120000 });
    const goal = await page.evaluate(async () => {
        const { sectors } = await (await fetch('/plan.json')).json(), { view } = window.vicus, here = view.pose();
        const away = ([, w, s, e, n]) => Math.hypot((w + e) / 2 - here.east, (s + n) / 2 - here.north);
        const [id, w, s, e, n] = sectors.sort((a, b) => away(b) - away(a))[0];
        view.setPose({ ...here, east: (w + e) / 2, north: (s + n) / 2 });
        return { id, at: [(w + e) / 2, (s + n) / 2], away: away([id, w, s, e, n]) };
    });
    assert.ok(goal.away > 150, 'the town is too small to tell');
    await page.waitForFunction(() => window.vicus.flight.flyover.isSettled, null, { timeout: 120000 });
    await page.screenshot({ path: join(kShots, 'site-fly.png') });
    await page.keyboard.press('KeyV');
    await page.waitForFunction(() => window.vicus.flight.phase === 'walking', null, { timeout: 120000 });
    const pose = await page.evaluate(() => window.vicus.view.pose());
    assert.ok(Math.hypot(pose.east - goal.at[0], pose.north - goal.at[1]) < 60, JSON.stringify([pose, goal]));
    assert.ok(requests.some(({ path }) => /^\/blockmaps\/\d+\/\d+\/\d+\.prisms$/.test(path)));
    assert.deepEqual(complaints.filter(text => !text.includes('404')), []);   // a server is asked for first
});
