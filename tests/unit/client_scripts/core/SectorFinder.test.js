import assert from 'node:assert/strict';
import test from 'node:test';
import { SectorFinder, kGateMarginMm } from '../../../../client_scripts/core/SectorFinder.js';
import { distanceToEdges, distanceToLine } from '../../../../client_scripts/core/planGeometry.js';
import { depthInBox, tightBox } from '../../../../client_scripts/core/tightBox.js';
import { GroundOracle } from '../../../support/groundOracle.js';
import { quarterSectors } from '../../../support/quarterRecords.js';
import { randomWalk } from '../../../support/randomWalk.js';

const kSteps = 250000, kSeeds = [1, 2, 3, 4];

/** Walks `steps` and asks `judge(finder's id, oracle's ids, point)` at each; counts what happened. */
function walk(seed, options, judge, steps = kSteps) {
    const sectors = quarterSectors(6, seed), oracle = new GroundOracle(sectors), finder = new SectorFinder(options.test, options);
    const counts = { step: 0, slide: 0, gate: 0, jump: 0, stand: 0, changes: 0, wrong: 0, visited: new Set() };
    let current = sectors.keys().next().value;
    for (const { point, kind } of randomWalk(sectors, oracle, { seed, steps })) {
        if (kind === 'jump') finder.jump();
        const before = current, truth = oracle.sectorsAt(point);
        current = finder.find(sectors, current, point);
        ++counts[kind];
        counts.changes += current !== before;
        counts.wrong += !truth.includes(current);
        counts.visited.add(current);
        const fault = judge({ sectors, current, truth, point, kind });
        assert.ok(!fault, `seed ${seed}, ${options.test}: ${fault} at ${point} (${kind}): ${current}, in truth ${truth}, before ${before}`);
    }
    for (const [kind, least] of Object.entries({ step: 0.3, slide: 0.02, gate: 0.01, jump: 0.0002, stand: 0.0005 }))
        assert.ok(counts[kind] >= least * steps, `seed ${seed}: ${counts[kind]} of kind ${kind} in ${steps}`);
    assert.ok(counts.visited.size > 80, `seed ${seed}: ${counts.visited.size} sectors visited`);
    return counts;
}

for (const test_ of ['polygon', 'gate']) test(`${test_} without a margin: right at each of 10^6 steps`, t => {
    for (const seed of kSeeds) {
        const { changes } = walk(seed, { test: test_, marginMm: 0 }, ({ current, truth, point, sectors }) => {
            if (truth.includes(current)) return '';
            // On a gate's line, to the lattice's half millimetre, both sides are right.
            return test_ === 'gate' && isAtGate(sectors, current, truth, point, 0) ? '' : 'wrong';
        });
        t.diagnostic(`seed ${seed}: ${kSteps} steps, ${changes} changes`);
    }
});

for (const test_ of ['polygon', 'gate']) test(`${test_} with the margin: wrong nowhere but within it`, t => {
    for (const seed of kSeeds) {
        const { wrong, changes } = walk(seed, { test: test_ }, ({ sectors, current, truth, point }) => {
            if (truth.includes(current)) return '';
            if (test_ === 'polygon') return distanceToEdges(sectors.get(current).ground, point) <= kGateMarginMm ? '' : 'wrong beyond the margin';
            return isAtGate(sectors, current, truth, point, kGateMarginMm) ? '' : 'wrong beyond the margin';
        });
        t.diagnostic(`seed ${seed}: ${kSteps} steps, ${changes} changes, ${wrong} within the margin`);
    }
});

/** Is the point within `margin` of a gate that leads from `current` on? Sectors shorter than the margin may lie between. */
function isAtGate(sectors, current, truth, point, margin) {
    return sectors.get(current).gates.some(({ line }) => distanceToLine(line, point) <= margin)
        || truth.some(id => sectors.get(id).gates.some(({ to, line }) => to === current && distanceToLine(line, point) <= margin));
}

test('box: the visitor is in the scaled box that is reported; where one box alone holds him it is his', t => {
    for (const seed of kSeeds) {
        const { wrong, changes } = walk(seed, { test: 'box' }, ({ sectors, current, truth, point }) => {
            const depth = depthInBox(tightBox(sectors.get(current)), point);
            if (truth.length && depth < -kGateMarginMm) return `${-depth} mm outside of the box`;
            if (truth.includes(current)) return '';
            const holders = [...sectors.values()].filter(sector => depthInBox(tightBox(sector), point) >= -kGateMarginMm);
            return holders.length > 1 ? '' : 'one box holds him, another is reported';
        }, kSteps / 5);
        t.diagnostic(`seed ${seed}: ${kSteps / 5} steps, ${changes} changes, ${wrong} in boxes that overlap`);
    }
});

test('turning round on a gate changes nothing within the margin; without one it changes at each turn', () => {
    const sectors = quarterSectors(2, 1), gate = sectors.get('x0-0').gates[0], [a, b] = gate.line;
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]), middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
    const off = mm => [Math.round(middle[0] + mm * (b[1] - a[1]) / length), Math.round(middle[1] - mm * (b[0] - a[0]) / length)];
    for (const test_ of ['polygon', 'box', 'gate']) {
        const changes = marginMm => {
            const finder = new SectorFinder(test_, { marginMm }), ids = [];
            let current = finder.find(sectors, 'x0-0', off(-800));
            for (let i = 0; i < 10; ++i) for (const mm of [-300, 300]) ids.push(current = finder.find(sectors, current, off(mm)));
            return new Set(ids).size;
        };
        assert.equal(changes(kGateMarginMm), 1, test_);
        if (test_ !== 'box') assert.equal(changes(0), 2, test_);   // boxes overlap: a margin of their own
    }
});

test('a sector whose ground is not known yet is entered through its gate, and left when it is known', () => {
    const sectors = quarterSectors(2, 1), { gates } = sectors.get('x0-0'), { to, line } = gates[0], known = sectors.get(to);
    const [a, b] = line, length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    const at = mm => [0, 1].map(k => Math.round((a[k] + b[k]) / 2 + (k ? -mm * (b[0] - a[0]) : mm * (b[1] - a[1])) / length));
    sectors.set(to, { ...known, ground: null, gates: undefined });
    const finder = new SectorFinder('gate');
    for (const mm of [-500, -100]) assert.equal(finder.find(sectors, 'x0-0', at(mm)), 'x0-0');
    assert.equal(finder.find(sectors, 'x0-0', at(900)), 'x0-0', 'no ground tells that he is there');
    sectors.set(to, known);
    assert.equal(finder.find(sectors, 'x0-0', at(1000)), to);
    assert.equal(finder.find(sectors, to, at(-1000)), 'x0-0');
});

test('an unknown test is refused by name', () => {
    assert.throws(() => new SectorFinder('sphere'), /there is no sector test 'sphere': polygon, box and gate are there/);
});
