// The facades of one house in its four levels of detail beside each other, as in paper 004, figure 5:
//   node scripts/level_pictures.mjs VICUS CITY.gpkg ADDRESS SECTOR N OUT.png
// ADDRESS: where `vicus serve CITY.gpkg` runs, for X_ITE and the textures. N: the N-th LOD node of the sector's files.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { openBrowser } from '../tests/browser/support/chromium.js';

const [vicus, city, address, sector, n, out] = process.argv.slice(2);
if (!out) {
    console.error('usage: node scripts/level_pictures.mjs VICUS CITY.gpkg ADDRESS SECTOR N OUT.png');
    process.exit(2);
}
const kGap_m = 4, kView = 0.6;
const folder = mkdtempSync(join(tmpdir(), 'vicus-levels-'));
execFileSync(vicus, ['export', city, '--format', 'x3d', '-o', join(folder, 'out'), '--quiet']);
const files = readdirSync(join(folder, 'out', 'sectors')).filter(name => name.startsWith(`${sector}.`)).sort();
const nodes = files.flatMap(name => readFileSync(join(folder, 'out', 'sectors', name), 'utf8').split('<LOD ').slice(1));
rmSync(folder, { recursive: true });
const lod = nodes[Number(n)];
if (!lod) throw new Error(`sector ${sector} has ${nodes.length} LOD nodes`);
const looks = new Map([...nodes.join('').matchAll(/<Appearance DEF='(IMAGE-\w+)'>[\s\S]*?<\/Appearance>/g)].map(m => [m[1], m[0]]));
const levels = lod.slice(lod.indexOf('\n') + 1, lod.indexOf('</LOD>')).split('</Group>\n').slice(0, 4).reverse()
    .map(text => `${text}</Group>`.replaceAll(/<Appearance USE='(IMAGE-\w+)'\/>/g, (_, id) => looks.get(id)).replaceAll(/ DEF='[^']*'/g, ''));

const corners = [...levels[1].matchAll(/<Coordinate point='([^']*)'/g)].map(([, text]) => text.trim().split(/[\s,]+/).map(Number))
    .flatMap(list => list.flatMap((v, i) => (i % 3 ? [] : [list.slice(i, i + 3)])));
const wall = quadsOf(levels[1]).sort((a, b) => b.area - a.area)[0];
const heading = Math.atan2(wall.normal[0], wall.normal[2]);
const turned = corners.map(([x, y, z]) => [x * Math.cos(heading) - z * Math.sin(heading), y,
    x * Math.sin(heading) + z * Math.cos(heading)]);
const [left, right] = range(turned.map(p => p[0])), [, top] = range(turned.map(p => p[1])), [back, front] = range(turned.map(p => p[2]));
const step = right - left + kGap_m, width = 4 * step;
const distance = Math.max(width / 2.6, top) / (2 * Math.tan(kView / 2)) * 1.1;
const shown = levels.map((text, i) => `<Transform translation='${(i - 1.5) * step} 0 0'>
  <Transform rotation='0 1 0 ${-heading}'><Transform translation='${-middleX()} 0 ${-middleZ()}'>${text.replaceAll('"../', `"${address}/`)}
  </Transform></Transform></Transform>`).join('');

function middleX() { const x = (left + right) / 2, z = (back + front) / 2; return x * Math.cos(heading) + z * Math.sin(heading); }
function middleZ() { const x = (left + right) / 2, z = (back + front) / 2; return -x * Math.sin(heading) + z * Math.cos(heading); }
function range(values) { return [Math.min(...values), Math.max(...values)]; }
function quadsOf(text) {
    const quads = [];
    for (const [, index, points] of text.matchAll(/coordIndex='([^']*)'[\s\S]*?<Coordinate point='([^']*)'/g)) {
        const p = points.trim().split(/[\s,]+/).map(Number);
        for (const face of index.split('-1')) {
            const at = face.trim().split(/\s+/).map(Number);
            if (at.length !== 4) continue;
            const [a, b, c] = at.map(i => p.slice(3 * i, 3 * i + 3)), u = b.map((v, i) => v - a[i]), v = c.map((w, i) => w - a[i]);
            const normal = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
            quads.push({ normal, area: Math.hypot(...normal) });
        }
    }
    return quads;
}

const scene = `<X3D profile='Full' version='4.0'><Scene><Background skyColor='0.93 0.95 0.97'/>
<NavigationInfo headlight='false' type='"NONE"'/><DirectionalLight direction='-0.5 -0.6 -0.8' intensity='0.75'/>
<DirectionalLight direction='0.7 -0.2 -0.5' intensity='0.45'/>
<Viewpoint position='0 ${top / 2} ${distance + front - back}' fieldOfView='${kView}'/>${shown}</Scene></X3D>`;
const browser = await openBrowser({ width: 1400, height: 540 });
const page = await browser.context.newPage();
await page.route('**/levels.x3d', route => route.fulfill({ contentType: 'model/x3d+xml', body: scene }));
await page.route('**/levels.html', route => route.fulfill({ contentType: 'text/html', body: `<body style='margin:0'>
<script type='module'>import X3D from '/x_ite/15.0.1/dist/x_ite.min.mjs'; await new Promise((y, n) => X3D(y, n));
const canvas = document.querySelector('x3d-canvas'); await canvas.browser.loadURL(new X3D.MFString('/levels.x3d'));
window.isShown = true;</script><x3d-canvas style='width:1400px;height:540px'></x3d-canvas>` }));
await page.goto(`${address}/levels.html`);
await page.waitForFunction(() => window.isShown);
await page.waitForTimeout(4000);
await page.screenshot({ path: out });
await browser.close();
