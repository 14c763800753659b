// Builds every city found in the data folder, checks it, draws it, and prints the table of docs/sectors.md.
// usage: node scripts/sector_figures.mjs VICUS [PICTURES_DIRECTORY]      data: ../shared/data or $VICUS_DATA
import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import path from 'node:path';

const root = path.resolve(import.meta.dirname ?? path.dirname(new URL(import.meta.url).pathname), '..');
const data = process.env.VICUS_DATA ?? path.join(root, '..', 'shared', 'data');
const [vicus, pictures] = process.argv.slice(2);
if (!vicus) {
  console.error('usage: node scripts/sector_figures.mjs VICUS [PICTURES_DIRECTORY]');
  process.exit(2);
}

const tiles = (folder) => ['buildings', 'streets', 'water'].map((f) => `${folder}/${f}.geojsonl.gz`);
// [name, input files, part of the city to draw in metres from its origin (all of it without)]
const cities = [
  ['Rochechouart', ['paris-rochechouart/paris-rochechouart.osm.pbf']],
  ['Montmartre', tiles('paris-montmartre'), [-900, -700, 700, 500]],
  ['Graz', tiles('graz'), [300, 300, 1700, 1400]],
  ['Berlin Mitte', tiles('berlin-mitte'), [-700, -550, 800, 550]],
  ['London Soho', ['london-soho/london-soho.osm.pbf']],
  ['Prague Bubenec', ['prague-bubenec/bubenec.gpkg']],
];

const run = (...args) => spawnSync(vicus, args, { encoding: 'utf8', maxBuffer: 1 << 28 });
const two = (v, digits = 2) => (v == null ? '-' : v.toFixed(digits));
const scratch = mkdtempSync(path.join(tmpdir(), 'vicus-figures-'));

console.log('| city | rules | sectors (streets, crossroads, squares) | gates per sector med / p95 | convexity med / p05 | gate width ratio med / p95 | length med / p95 m | named share outside cores | bytes med / max | normalise + sectors, CPU s |');
console.log('|---|---|---|---|---|---|---|---|---|---|');
for (const [name, files, box] of cities) {
  const inputs = files.map((f) => path.join(data, f));
  if (!inputs.every(existsSync)) {
    console.error(`${name}: skipped, no data`);
    continue;
  }
  const city = path.join(scratch, name.replace(/\W+/g, '-').toLowerCase() + '.gpkg');
  const build = run('build', ...inputs, '-o', city, '--json');
  if (build.status !== 0) throw new Error(`${name}: ${build.stderr}`);
  const stages = Object.fromEntries(JSON.parse(build.stdout).stages.map((s) => [s.stage, s.cpu_s]));
  const check = JSON.parse(run('check', city, '--json').stdout);
  const s = check.shape;
  const broken = Object.entries(check.holds).filter(([, holds]) => !holds).map(([rule]) => rule);
  console.log(`| ${name} | ${broken.length ? 'broken: ' + broken.join(', ') : 'all hold'} | ${check.counts.sectors} (${s.sectors ?? s.gates_per_sector.count ?? '-'}) | ` +
    `${two(s.gates_per_sector.median, 0)} / ${two(s.gates_per_sector.p95, 0)} | ${two(s.convexity.median, 3)} / ${two(s.convexity.p05, 3)} | ` +
    `${two(s.gate_width_ratio.median, 3)} / ${two(s.gate_width_ratio.p95, 3)} | ${two(s.sector_length_m.median, 0)} / ${two(s.sector_length_m.p95, 0)} | ` +
    `${s.named_street_share == null ? 'no names' : two(100 * s.named_street_share, 1) + ' %'} | ${check.bytes.sector_median} / ${check.bytes.sector_max} | ` +
    `${two(stages.normalise)} + ${two(stages.sectors)} |`);
  if (!pictures) continue;
  const svg = city.replace('.gpkg', '.svg');
  run('export', city, '--format', 'svg', ...(box ? ['--bbox', ...box.map(String)] : []), '-o', svg);
  execFileSync('rsvg-convert', ['-w', '1400', svg, '-o', path.join(pictures, path.basename(city, '.gpkg') + '.png')]);
}
rmSync(scratch, { recursive: true });
