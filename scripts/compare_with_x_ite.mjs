// What the page shows from a pose, and what `vicus render` makes of it, beside each other:
//   node scripts/compare_with_x_ite.mjs VICUS CITY.gpkg ADDRESS START FOLDER [HEADING_DEG]
// ADDRESS: where `vicus serve CITY.gpkg` runs; START: a sector. Writes FOLDER/x_ite.png, x_ite-sky.png (the sky in pure
// magenta), render.png and depth.pfm; `picture_difference` (tests/bench) says how far they are apart.
import { execFileSync } from 'node:child_process';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { openBrowser } from '../tests/browser/support/chromium.js';

const [vicus, city, address, start, folder, degrees] = process.argv.slice(2);
if (!folder) {
    console.error('usage: node scripts/compare_with_x_ite.mjs VICUS CITY.gpkg ADDRESS START FOLDER [HEADING_DEG]');
    process.exit(2);
}
const [width, height] = [960, 600];
mkdirSync(folder, { recursive: true });
const browser = await openBrowser({ width, height });
const page = await browser.context.newPage();
await page.goto(`${address}/?start=${start}&i=3`);
await page.waitForFunction(() => window.vicus?.visit.firstStreetAt, null, { timeout: 180000 });
await page.addStyleTag({ content: `body * { visibility: hidden !important } x3d-canvas { visibility: visible !important;
    position: fixed !important; inset: 0; width: ${width}px !important; height: ${height}px !important }` });
const pose = await page.evaluate(degrees => {
    const { view } = window.vicus;
    view.setContentScale(1);
    const pose = view.pose();
    if (degrees !== null) view.setPose({ ...pose, heading: degrees * Math.PI / 180, pitch: 0.04 });
    return view.pose();
}, degrees === undefined ? null : Number(degrees));
await page.waitForFunction(() => {
    const { view, visit } = window.vicus;
    const quiet = view.isIdle() && visit.sectors.every(sector => sector.phase !== 'loading');
    window.quietSince = quiet ? window.quietSince || performance.now() : 0;
    return quiet && performance.now() - window.quietSince > 4000;
}, null, { timeout: 240000 });
await page.screenshot({ path: join(folder, 'x_ite.png') });
await page.evaluate(() => {
    const { view } = window.vicus, { MFColor, SFColor } = view.X3D;
    const sky = Array.from(view.browser.currentScene.rootNodes).find(node => node.getNodeTypeName() === 'Background');
    for (const [field, count] of [['skyColor', 3], ['groundColor', 3]]) sky[field] = new MFColor(...Array.from({ length: count }, () => new SFColor(1, 0, 1)));
});
await page.waitForTimeout(3000);
await page.screenshot({ path: join(folder, 'x_ite-sky.png') });
await browser.close();
const { east, north, up, heading, pitch } = pose;
const look = [east + Math.sin(heading) * Math.cos(pitch), north + Math.cos(heading) * Math.cos(pitch), up + Math.sin(pitch)];
console.log(execFileSync(vicus, ['render', city, `--eye=${[east, north, up]}`, `--look=${look}`, '--size', `${width}x${height}`,
    '--as', 'lod4', '-o', join(folder, 'render.png'), '--depth', join(folder, 'depth.pfm')]).toString());
console.log(JSON.stringify(pose));
