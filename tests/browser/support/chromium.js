import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';

const kFlags = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];
const kPlaces = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'];
/** What Chromium says of its own software renderer when pixels are read back; X_ITE's collision does that. */
const kDriverTalk = /GL Driver Message .*(Performance|ReadPixels)|GPU stall due to ReadPixels|Automatic fallback to software WebGL/;

/** A browser with a profile of its own; close() removes it. Fails  Error: no Chromium on this machine. */
export async function openBrowser({ width = 960, height = 600, hasTouch = false } = {}) {
    const executablePath = kPlaces.find(path => path && existsSync(path));
    if (!executablePath) throw new Error('no Chromium found: install it (apt install chromium) or set CHROMIUM');
    const profile = mkdtempSync(join(tmpdir(), 'vicus-chromium-'));
    const context = await chromium.launchPersistentContext(profile, {
        executablePath, headless: true, viewport: { width, height }, hasTouch, args: kFlags });
    return {
        context,
        async close() {
            await context.close();
            rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
        },
    };
}

/** A tab that keeps what the console said and what was fetched: { page, complaints, requests, bytes }. */
export async function openTab(context) {
    const page = await context.newPage();
    const tab = { page, complaints: [], requests: [], bytes: new Map() };
    page.on('console', message => {
        const said = `${message.type()}: ${message.text()}`;
        if (['error', 'warning'].includes(message.type()) && !kDriverTalk.test(said)) tab.complaints.push(said);
    });
    page.on('pageerror', error => tab.complaints.push(`uncaught: ${error.stack}`));
    const devtools = await context.newCDPSession(page);
    await devtools.send('Network.enable');
    const paths = new Map();
    devtools.on('Network.requestWillBeSent', ({ requestId, request }) => {
        if (!request.url.startsWith('http')) return;   // what the page has already: blob:, data:
        paths.set(requestId, new URL(request.url).pathname);
        tab.requests.push({ path: new URL(request.url).pathname, at: Date.now() });
    });
    devtools.on('Network.loadingFinished', ({ requestId, encodedDataLength }) => {
        const path = paths.get(requestId);
        if (!path) return;
        tab.bytes.set(path, (tab.bytes.get(path) ?? 0) + encodedDataLength);
    });
    return tab;
}
