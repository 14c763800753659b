import assert from 'node:assert/strict';
import test from 'node:test';
import { GroundHeights } from '../../../../client_scripts/core/GroundHeights.js';

const kRoad = { points: [[0, 0, -120], [10000, 0, -120], [10000, 5000, -120], [0, 5000, -120]], triangles: [0, 1, 2, 0, 2, 3] };
const kRamp = { points: [[0, 5000, 0], [10000, 5000, 1000], [10000, 9000, 1000], [0, 9000, 0]], triangles: [0, 1, 2, 0, 2, 3] };
const kKerb = { points: [[10000, 5000, -120], [0, 5000, -120], [0, 5000, 0]], triangles: [0, 1, 2] };

test('a place has the height of the triangle it lies in', () => {
    const heights = new GroundHeights([kRoad, kRamp, kKerb]);
    assert.equal(heights.at([5000, 2500]), -120);
    assert.equal(Math.round(heights.at([2500, 7000])), 250);
    assert.equal(Math.round(heights.at([9999, 8999])), 1000);
});

test('on an edge the higher side counts; off every triangle there is none', () => {
    const heights = new GroundHeights([kRoad, kRamp, kKerb]);
    assert.equal(Math.round(heights.at([4000, 5000])), 400);
    assert.equal(heights.at([-1, 2500]), null);
    assert.equal(new GroundHeights([]).at([0, 0]), null);
});
