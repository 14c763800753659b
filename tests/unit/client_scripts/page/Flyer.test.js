import assert from 'node:assert/strict';
import test from 'node:test';
import { RoofHeights } from '../../../../client_scripts/core/RoofHeights.js';
import { Flyer } from '../../../../client_scripts/page/Flyer.js';

const kStill = { forward: 0, right: 0, turn: 0, rise: 0, zoom: 0, look: [0, 0], run: false };

/** Ground at 5 m, a tower of 60 m at (100, 100). */
function flyerAt(pose) {
    const view = { at: { east: 0, north: 0, up: 80, heading: 0, pitch: 0, ...pose }, sets: 0 };
    view.pose = () => ({ ...view.at });
    view.setPose = next => { view.at = next; ++view.sets; };
    const heights = new RoofHeights();
    heights.add('0', { corner: [-500, -500], side: 1000, nodes: 3, heights: Array(9).fill(5), roofs: Float32Array.from([90, 90, 110, 110, 60]) });
    return { view, flyer: new Flyer(view, heights) };
}
const run = (flyer, wish, seconds) => { for (let i = 0; i < seconds * 20; ++i) flyer.step({ ...kStill, ...wish }, 0.05); };

test('who wants nothing stays, and the scene stays still', () => {
    const { view, flyer } = flyerAt({});
    assert.equal(flyer.step(kStill, 0.05), false);
    assert.equal(view.sets, 0);
});

test('forward is where he looks in plan, faster the higher he is and with Shift, and keeps the height', () => {
    const way = (pose, wish) => {
        const { view, flyer } = flyerAt({ heading: Math.PI / 2, pitch: -0.8, ...pose });
        run(flyer, { forward: 1, ...wish }, 1);
        assert.ok(Math.abs(view.at.north) < 1e-9 && view.at.up === (pose.up ?? 80));
        return view.at.east;
    };
    const low = way({}), high = way({ up: 405 }), fast = way({}, { run: true });
    assert.ok(Math.abs(low - 0.7 * 75) < 1e-6 && Math.abs(high - 0.7 * 400) < 1e-6 && Math.abs(fast - 3 * low) < 1e-6, `${low} ${high} ${fast}`);
});

test('nobody sinks into the ground or a roof; a roof that comes lifts him over it', () => {
    const ground = flyerAt({});
    run(ground.flyer, { rise: -1 }, 20);
    assert.equal(ground.view.at.up, 27);
    const tower = flyerAt({ east: 100, north: 100, up: 90 });
    run(tower.flyer, { rise: -1 }, 20);
    assert.equal(tower.view.at.up, 66);
    const towards = flyerAt({ east: 100, north: 0, up: 40 });
    run(towards.flyer, { forward: 1 }, 4);
    assert.ok(towards.view.at.north > 92 && towards.view.at.north < 112, `${towards.view.at.north}`);
    run(towards.flyer, {}, 2);
    assert.ok(towards.view.at.up > 65, `${towards.view.at.up}`);
});

test('the wheel brings nearer what he looks at, never through the ground, and nothing leads out of the sky', () => {
    const { view, flyer } = flyerAt({ up: 205, pitch: -1.5 });
    flyer.step({ ...kStill, zoom: 1 }, 0.05);
    assert.ok(Math.abs(view.at.up - (205 - 30 * Math.sin(1.5))) < 1e-9 && Math.abs(view.at.north - 30 * Math.cos(1.5)) < 1e-9);
    for (let i = 0; i < 60; ++i) flyer.step({ ...kStill, zoom: 1 }, 0.05);
    assert.equal(view.at.up, 27);
    for (let i = 0; i < 200; ++i) flyer.step({ ...kStill, zoom: -1 }, 0.05);
    assert.equal(view.at.up, 6000);
});
