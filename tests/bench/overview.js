// A whole city from above: bytes until the first picture, and until no tile errs by more than so many pixels.
// usage: node tests/bench/overview.js ORIGIN FOLDER [UP_M] [PIXELS...]      pictures go to FOLDER; 5000 m, 4 2 1 pixels
import { join } from 'node:path';
import { openBrowser, openTab } from '../browser/support/chromium.js';

const [origin, folder, up = '5000', ...asked] = process.argv.slice(2);
if (!folder) {
    console.error('usage: node tests/bench/overview.js ORIGIN FOLDER [UP_M] [PIXELS...]');
    process.exit(2);
}
const browser = await openBrowser({ width: 1024, height: 640 });
try {
    for (const pixels of asked.length ? asked : ['4', '2', '1']) {
        const tab = await openTab(browser.context), { page } = tab;
        const sum = filter => Math.round([...tab.bytes].filter(([path]) => filter(path)).reduce((all, [, bytes]) => all + bytes, 0) / 1000);
        const isOfCity = path => !/^\/(client|x_ite)\//.test(path) && path !== '/';
        const begun = Date.now();
        await page.goto(`${origin}/#0,-${up},0,-45,${up}`);
        await page.waitForFunction(() => window.vicus?.flight.flyover, null, { timeout: 120000 });
        await page.evaluate(pixels => { window.vicus.flight.flyover.pixels = pixels; }, +pixels);
        await page.waitForFunction(() => window.vicus.flight.flyover.figures.firstAt, null, { timeout: 120000 });
        const first = { ms: Date.now() - begun, kB: sum(isOfCity) };
        await page.waitForFunction(() => {
            const { flight, view } = window.vicus;
            const isQuiet = flight.flyover.isSettled && view.isIdle();
            window.quietSince = isQuiet ? window.quietSince || performance.now() : 0;
            return isQuiet && performance.now() - window.quietSince > 1500;
        }, null, { timeout: 900000 });
        const { strain, tiles, scale } = await page.evaluate(() => {
            const { flyover, frameRate } = window.vicus.flight;
            return { strain: flyover.strain, tiles: flyover.chosen.draw.length, scale: frameRate.scale };
        });
        await page.screenshot({ path: join(folder, `overview-${pixels}.png`) });
        console.log(`${pixels} pixels: first picture ${first.ms} ms, ${first.kB} kB; whole ${Date.now() - begun} ms, ` +
            `${sum(isOfCity)} kB, ${tiles} quadrants drawn (strain ${strain.toFixed(2)}, ${scale.toFixed(2)} of the pixels); ` +
            `tree ${sum(path => path.endsWith('tree.json'))} kB, tiles ${sum(path => path.startsWith('/blockmaps/') && !path.endsWith('.json'))} kB; ` +
            `complaints ${tab.complaints.length}`);
        await page.close();
    }
} finally {
    await browser.close();
}
