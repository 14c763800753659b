import assert from 'node:assert/strict';
import test from 'node:test';
import { Walker } from '../../../../client_scripts/page/Walker.js';
import { streetRecords } from '../../../support/streetRecords.js';

const kStill = { forward: 0, right: 0, turn: 0, look: [0, 0], run: false };

/** A view that lets every step pass but those `blocks` says no to. */
function viewAt(east, north, heading = Math.PI / 2, blocks = () => false) {
    const view = { at: { east, north, up: 1.7, heading, pitch: 0 }, sets: 0 };
    view.pose = () => ({ ...view.at });
    view.setPose = pose => { view.at = pose; ++view.sets; };
    view.setGravity = isOn => { view.gravity = isOn; };
    view.constrainStep = step => (blocks(step) ? [0, 0] : step);
    return view;
}

function walkerIn(view, ids = ['s0', 's1']) {
    const walker = new Walker(view);
    walker.setGround(streetRecords().filter(record => ids.includes(record.id)));
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

test('a body in the way stops the visitor where the plan has no wall', () => {
    const view = viewAt(20, 5, Math.PI / 2, step => step[0] > 0);
    seconds(walkerIn(view), { forward: 1 }, 2);
    assert.deepEqual([view.at.east, view.at.north], [20, 5]);
});

test('a visitor gets round a post head on, and past a bench', () => {
    for (const [reach, width] of [[0.6, 0.6], [0.6, 1.2]]) {
        const view = viewAt(20, 5);
        const isIn = (east, north) => Math.abs(east - 25) < reach && Math.abs(north - 5) < width;
        view.constrainStep = step => (isIn(view.at.east + step[0], view.at.north + step[1]) ? [0, 0] : step);
        seconds(walkerIn(view), { forward: 1 }, 8);
        assert.ok(view.at.east > 26, `stuck at ${view.at.east}, ${view.at.north}`);
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

test('gravity is on over ground that is there, off elsewhere', () => {
    const view = viewAt(50, 5), walker = walkerIn(view, ['s0']);
    walker.step(kStill, 0.05);
    assert.equal(view.gravity, false);
    walker.setGround(streetRecords().filter(({ id }) => ['s0', 's1'].includes(id)));
    walker.step(kStill, 0.05);
    assert.equal(view.gravity, true);
});

test('a stall carries nobody away', () => {
    const view = viewAt(20, 5);
    walkerIn(view).step({ ...kStill, forward: 1, run: true }, 60);
    assert.ok(view.at.east - 20 < 1.5);
});
