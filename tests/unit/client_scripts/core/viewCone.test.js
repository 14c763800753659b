import assert from 'node:assert/strict';
import test from 'node:test';
import { eyeAxes, viewCone } from '../../../../client_scripts/core/viewCone.js';

test('axes are at right angles; heading is clockwise from north, pitch up', () => {
    for (const [heading, pitch] of [[0, 0], [1, -0.5], [-2, 1.2]]) {
        const { ahead, right, above } = eyeAxes(heading, pitch), dot = (a, b) => a.reduce((sum, v, k) => sum + v * b[k], 0);
        for (const [a, b] of [[ahead, right], [right, above], [above, ahead]]) assert.ok(Math.abs(dot(a, b)) < 1e-12);
        for (const a of [ahead, right, above]) assert.ok(Math.abs(dot(a, a) - 1) < 1e-12);
    }
    const east = eyeAxes(Math.PI / 2, 0).ahead, down = eyeAxes(0, -Math.PI / 2).ahead;
    assert.ok(Math.abs(east[0] - 1) < 1e-12 && Math.abs(down[2] + 1) < 1e-12);
});

/** Oracle: points of a box, thrown on the screen one by one. */
test('no box is left out of which a point is in view', () => {
    let state = 9, hits = 0, misses = 0;
    const random = () => ((state = (state * 1103515245 + 12345) % 2147483648) / 2147483648);
    for (let i = 0; i < 3000; ++i) {
        const view = { eye: [0, 0, 100], heading: 6.28 * random(), pitch: -1.4 * random(), half: [0.4 + random(), 0.3 + random()] };
        const low = [600 * random() - 300, 600 * random() - 300, 0], high = low.map(v => v + 10 + 100 * random());
        const { ahead, right, above } = eyeAxes(view.heading, view.pitch), dot = (a, b) => a.reduce((sum, v, k) => sum + v * b[k], 0);
        const isIn = Array.from({ length: 60 }).some(() => {
            const p = low.map((v, k) => v + random() * (high[k] - v) - view.eye[k]), z = dot(p, ahead);
            return z > 0 && Math.abs(dot(p, right)) < z * view.half[0] && Math.abs(dot(p, above)) < z * view.half[1];
        });
        const sees = viewCone(view)({ low, high });
        if (isIn) assert.ok(sees, `case ${i}`);
        hits += isIn;
        misses += !sees;
    }
    assert.ok(hits > 300 && misses > 300, `${hits} ${misses}`);
});
