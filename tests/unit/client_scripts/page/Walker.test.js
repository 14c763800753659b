import assert from 'node:assert/strict';
import test from 'node:test';
import { Walker } from '../../../../client_scripts/page/Walker.js';
import { seededRandom } from '../../../support/random.js';
import { streetRecords } from '../../../support/streetRecords.js';

const kStill = { forward: 0, right: 0, turn: 0, look: [0, 0], run: false };

function viewAt(east, north, heading = Math.PI / 2) {
    const view = { at: { east, north, up: 1.7, heading, pitch: 0 }, sets: 0 };
    view.pose = () => ({ ...view.at });
    view.setPose = pose => { view.at = pose; ++view.sets; };
    return view;
}

/** `bodies`: [east, north, radius], in s0. */
function walkerIn(view, ids = ['s0', 's1'], bodies = []) {
    const walker = new Walker(view);
    walker.setGround(streetRecords().filter(record => ids.includes(record.id))
        .map(record => (record.id === 's0' ? { ...record, bodies } : record)));
    return walker;
}

const seconds = (walker, wish, count) => { for (let i = 0; i < count * 20; ++i) walker.step({ ...kStill, ...wish }, 0.05); };

test('standing still sets no pose', () => {
    const view = viewAt(20, 5);
    assert.equal(walkerIn(view).step(kStill, 0.05), false);
    assert.equal(view.sets, 0);
});

test('forward goes where the visitor looks, right goes to the right, run is faster, both axes are no faster', () => {
    const lengthOf = wish => {
        const view = viewAt(20, 5);
        seconds(walkerIn(view), wish, 0.5);
        return [view.at.east - 20, view.at.north - 5];
    };
    assert.deepEqual(lengthOf({ forward: 1 }).map(value => Math.round(value * 100) / 100), [1.1, 0]);
    assert.deepEqual(lengthOf({ right: 1 }).map(value => Math.round(value * 100) / 100), [0, -1.1]);
    assert.ok(Math.hypot(...lengthOf({ forward: 1, run: true })) > 3);
    assert.ok(Math.hypot(...lengthOf({ forward: 1, right: 1 })) < 1.11);
});

test('the visitor passes the open gate, stops at the end of what is there and at facades', () => {
    const view = viewAt(20, 5), walker = walkerIn(view);
    seconds(walker, { forward: 1, run: true }, 20);
    assert.ok(Math.abs(view.at.east - 79.7) < 0.01, `${view.at.east}`);
    seconds(walker, { right: 1 }, 10);
    assert.ok(Math.abs(view.at.north - 0.3) < 0.01, `${view.at.north}`);
});

const kTrunk = 0.16, kLamp = 0.08, kBench = 0.5, kFountain = 1.6;
const row = (count, step, [east, north], radius) => Array.from({ length: count }, (_, i) => [east, north + i * step, radius]);
const kScenes = {
    'a trunk head on': [[25, 5, kTrunk]],
    'a fountain head on': [[25, 5, kFountain]],
    'a bench a little aside': [[25, 5.3, kBench]],
    'a row of benches that reaches the wall': row(4, 1.1, [25, 5], kBench),
    'a niche of two trees and a bench': [[25, 5, kBench], [24.6, 4.2, kTrunk], [24.6, 5.8, kTrunk]],
    'a row of lamps from wall to wall, too narrow everywhere': row(18, 0.6, [25, 0], kLamp),
};

for (const [scene, bodies] of Object.entries(kScenes)) test(`a visitor who walks straight on gets past ${scene}`, () => {
    const view = viewAt(20, 5);
    seconds(walkerIn(view, ['s0', 's1'], bodies), { forward: 1 }, 10);
    assert.ok(view.at.east > 30, `stuck at ${view.at.east}, ${view.at.north}`);
});

test('a visitor along a wall gets past a lamp before it, also where he cannot pass between lamp and wall', () => {
    for (const off of [0.1, 0.3, 0.5, 0.8]) for (const heading of [Math.PI / 2, 1.8, 2.2]) {
        const view = viewAt(20, 0.4, heading);
        seconds(walkerIn(view, ['s0', 's1'], [[25, off, kLamp]]), { forward: 1 }, 14);
        assert.ok(view.at.east > 27, `lamp ${off} m off the wall, heading ${heading}: at ${view.at.east}, ${view.at.north}`);
    }
});

test('nobody walks through a body where there is room beside it', () => {
    const bodies = kScenes['a row of benches that reaches the wall'], view = viewAt(20, 5), walker = walkerIn(view, ['s0'], bodies);
    for (let i = 0; i < 200; ++i) {
        walker.step({ ...kStill, forward: 1 }, 0.05);
        for (const [east, north, radius] of bodies) {
            const gap = Math.hypot(view.at.east - east, view.at.north - north) - radius;
            assert.ok(gap > 0.25, `${gap} m from the bench at ${east}, ${north}`);
        }
    }
});

/** A street 6 m wide that runs north, and a house's corner at 20.6 E, 10 N in it: beyond, it is 3.4 m wide. */
function narrowing() {
    const ground = [[[18, 0], [24, 0], [24, 30], [20.9, 30], [20.6, 10], [18, 9.8]]];
    return { id: 'n', origin: [21, 15], box: [18, 0, 24, 30], ground, gates: [] };
}

test('a visitor who walks into a wall beside its corner gets round it', () => {
    for (const east of [20.3, 20.5, 20.7, 20.85]) for (const heading of [-0.05, 0, 0.05]) {
        const view = viewAt(east, 9, heading), walker = new Walker(view);
        walker.setGround([narrowing()]);
        seconds(walker, { forward: 1, run: true }, 1);
        assert.ok(view.at.north > 12, `from ${east} heading ${heading}: stuck at ${view.at.east}, ${view.at.north}`);
    }
});

test('a visitor who walks into a wall far from its corner stays before it', () => {
    const view = viewAt(19.2, 9, -0.077), walker = new Walker(view);
    walker.setGround([narrowing()]);
    seconds(walker, { forward: 1 }, 3);
    assert.ok(view.at.north < 9.7 && Math.abs(view.at.east - 19.2) < 0.5, `${view.at.east}, ${view.at.north}`);
});

test('a body before a wall leads nobody along the wall', () => {
    const view = viewAt(20, 5, 0);
    seconds(walkerIn(view, ['s0', 's1'], [[20, 9.5, kBench]]), { forward: 1 }, 8);
    assert.ok(Math.abs(view.at.east - 20) < 1, `${view.at.east}, ${view.at.north}`);
});

test('who turns away on the way round a body goes where he looks', () => {
    const view = viewAt(20, 5), walker = walkerIn(view, ['s0', 's1'], [[25, 5, kFountain]]);
    seconds(walker, { forward: 1 }, 2);
    view.at.heading = -Math.PI / 2;
    const { east } = view.at;
    seconds(walker, { forward: 1 }, 1);
    assert.ok(view.at.east < east - 1.5, `${east} -> ${view.at.east}`);
});

test('whatever stands in the street, straight on leads to its end', () => {
    for (let seed = 1; seed <= 60; ++seed) {
        const random = seededRandom(seed), kinds = [kTrunk, kLamp, kBench, kFountain];
        const bodies = Array.from({ length: 25 }, () => [3 + 74 * random(), 10 * random(), kinds[Math.floor(4 * random())]]);
        const view = viewAt(1, 1 + 8 * random());
        const walker = new Walker(view), [s0, s1] = streetRecords();
        walker.setGround([{ ...s0, bodies }, s1]);
        for (let i = 0; i < 1000; ++i) walker.step({ ...kStill, forward: 1, run: i % 3 === 0 }, 0.02 + 0.1 * random());
        assert.ok(view.at.east > 78, `seed ${seed}: stuck at ${view.at.east}, ${view.at.north}`);
    }
});

test('turning and looking move nobody; pitch has an end', () => {
    const view = viewAt(20, 5, 0), walker = walkerIn(view);
    walker.step({ ...kStill, look: [0.5, 9] }, 0.05);
    seconds(walker, { turn: 1 }, 1);
    assert.ok(Math.abs(view.at.heading - 2.1) < 1e-9);
    assert.equal(view.at.pitch, 1.2);
    assert.deepEqual([view.at.east, view.at.north], [20, 5]);
});

test('a stall carries nobody away', () => {
    const view = viewAt(20, 5);
    walkerIn(view).step({ ...kStill, forward: 1, run: true }, 60);
    assert.ok(view.at.east - 20 < 1.5);
});

test('the eye follows a kerb and steps, and keeps its height where the ground is unknown', () => {
    const slab = (from, to, up) => ({ points: [[from, 0, up], [to, 0, up], [to, 10000, up], [from, 10000, up]], triangles: [0, 1, 2, 0, 2, 3] });
    const view = viewAt(20, 5), walker = new Walker(view);
    walker.setGround(streetRecords().map(record => ({ ...record, surface: slab(0, 21000, 0) })));
    walker.heights = new walker.heights.constructor([slab(0, 21000, 0), slab(21000, 22000, 120), slab(22000, 23000, 300)]);
    seconds(walker, { forward: 1 }, 0.9);
    assert.ok(view.at.up > 1.75, `${view.at.up}`);
    seconds(walker, { forward: 1 }, 0.4);
    assert.ok(Math.abs(view.at.up - 2) < 0.05, `${view.at.up}`);
    const before = view.at.up;
    walker.heights = new walker.heights.constructor([]);
    seconds(walker, { forward: 1 }, 0.5);
    assert.equal(view.at.up, before);
});
