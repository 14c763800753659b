// The pictures of README.md from a running server: node scripts/take_pictures.mjs http://127.0.0.1:8080/ FOLDER
// street.png: where a visitor starts, and how long the page took until the street was there.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { openBrowser } from '../tests/browser/support/chromium.js';
import { Visitor } from '../tests/browser/support/Visitor.js';

const [origin, folder] = process.argv.slice(2);
if (!folder) {
    console.error('usage: node scripts/take_pictures.mjs ADDRESS FOLDER');
    process.exit(2);
}
mkdirSync(folder, { recursive: true });
const browser = await openBrowser({ width: 1200, height: 700 });
try {
    const visitor = await Visitor.open(browser.context, origin);
    const cold = await visitor.streetTime();
    await visitor.settle(120);
    await visitor.page.waitForFunction(() => !document.body.innerText.includes('loading '), null, { timeout: 60000 });
    await visitor.page.waitForTimeout(5000);   // what is live stands in the scene before it stands in a frame, and i may grow
    await visitor.page.screenshot({ path: join(folder, 'street.png') });
    await visitor.page.close();
    const again = await Visitor.open(browser.context, origin);
    const warm = await again.streetTime();
    console.log(JSON.stringify({ cold_ms: Math.round(cold), warm_ms: Math.round(warm), complaints: visitor.complaints }));
} finally {
    await browser.close();
}
