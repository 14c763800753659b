/**
 * The table of docs/visitor.md: the three avatar-in-sector tests (paper 004 §5.2) over a real city, speed against error.
 *
 *     vicus serve city.gpkg --port 8080 &
 *     node tests/bench/sectorTests.js http://127.0.0.1:8080 [STEPS]
 *
 * For each test and margin a visitor strolls for the same seed: wrong steps (against an independent oracle), changes of the
 * sector per km, files of L_1 asked for per km where nothing is kept, and the time of a test. Walks differ by what is hard:
 * a stroll, one who turns round in gates, one who runs on a slow machine. `half-gates` is the paper's own gate test, sampled.
 */
import { distanceToLine, orient } from '../../client_scripts/core/planGeometry.js';
import { SectorFinder } from '../../client_scripts/core/SectorFinder.js';
import { sectorFromRecord, stemOf } from '../../client_scripts/core/sectorRecord.js';
import { sectorsWithin } from '../../client_scripts/core/sectorSets.js';
import { GroundOracle } from '../support/groundOracle.js';
import { randomWalk } from '../support/randomWalk.js';

const [origin, steps = '200000'] = process.argv.slice(2), kSeed = 1;
const kWalks = {
    'stroll, 1.4 m/s, 60 frames/s': { stepMm: [23, 23], gates: 0, long: 0, jumps: 0 },
    'turning in gates': { stepMm: [23, 60], gates: 0.02, long: 0, jumps: 0 },
    'run, 7 m/s, 5 frames/s': { stepMm: [1400, 1400], gates: 0, long: 0, jumps: 0 },
};

const kRows = [...['polygon', 'box', 'gate'].flatMap(test => [[test, 0], [test, 500]]), ['half-gates', 500]];

async function sectorsOf(server) {
    const found = new Map();
    const { features } = await (await fetch(`${server}/collections/sectors/items?limit=10000`)).json();
    for (const { id } of features) found.set(id, sectorFromRecord(await (await fetch(`${server}/sectors/${id}.json`)).json()));
    return found;
}

/**
 * The gate test as the paper has it, for comparison: two ProximitySensors per gate, `depthMm` deep each, looked at once a
 * frame; who leaves the gate's box by its outer half has passed. Nothing sets it right again but a jump.
 */
class HalfGates {
    constructor(depthMm) {
        Object.assign(this, { depthMm, gate: null, isOuter: false });
    }

    find(known, currentId, point) {
        const isIn = gate => distanceToLine(gate.line, point) <= this.depthMm;
        if (this.gate && !isIn(this.gate)) {
            const { gate, isOuter } = this;
            this.gate = null;
            if (isOuter) return gate.to;
        }
        this.gate ??= known.get(currentId).gates.find(gate => gate.to && isIn(gate)) ?? null;
        if (this.gate) this.isOuter = orient(this.gate.line[0], this.gate.line.at(-1), point) < 0;
        return currentId;
    }
}

const finderOf = (test, marginMm) => (test === 'half-gates' ? new HalfGates(marginMm) : new SectorFinder(test, { marginMm }));

function stroll(points, truth, test, marginMm) {
    const finder = finderOf(test, marginMm), begun = performance.now(), ids = [];
    let current = truth[0][0] ?? sectors.keys().next().value;
    for (const point of points) ids.push(current = finder.find(sectors, current, point));
    const microseconds = 1000 * (performance.now() - begun) / points.length;
    const counts = { wrong: 0, changes: 0, files: 0, microseconds, km: 0 };
    let wanted = new Set();
    for (const [i, id] of ids.entries()) {
        counts.wrong += truth[i].length > 0 && !truth[i].includes(id);
        if (i > 0) counts.km += Math.hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]) / 1e6;
        if (i > 0 && id === ids[i - 1]) continue;
        counts.changes += i > 0;
        const next = new Set([...sectorsWithin(sectors, sectors.get(id), 1)].map(([other, { level }]) => stemOf(other, level)));
        if (i > 0) for (const stem of next) counts.files += !wanted.has(stem);
        wanted = next;
    }
    return counts;
}

const sectors = await sectorsOf(origin), oracle = new GroundOracle(sectors);
console.log(`${sectors.size} sectors, seed ${kSeed}, ${steps} steps each\n`);
console.log('| walk | test | margin | wrong steps | changes/km | files/km | time of a test |');
console.log('|---|---|--:|--:|--:|--:|--:|');
for (const [name, options] of Object.entries(kWalks)) {
    const points = [...randomWalk(sectors, oracle, { seed: kSeed, steps: Number(steps), ...options })].map(({ point }) => point);
    const truth = points.map(point => oracle.sectorsAt(point));
    for (const [test, marginMm] of kRows) {
        const { wrong, changes, files, microseconds, km } = stroll(points, truth, test, marginMm);
        const share = (100 * wrong / points.length).toFixed(2);
        console.log(`| ${name} | ${test} | ${marginMm / 1000} m | ${share} % | ${(changes / km).toFixed(1)} | ${(files / km).toFixed(0)} | ${microseconds.toFixed(2)} µs |`);
    }
}
