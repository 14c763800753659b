import assert from 'node:assert/strict';
import test from 'node:test';
import { boxDistance, distance, distanceToEdges, isInside, latticePoint, nearestOnSegment, orient, segmentsMeet }
    from '../../../../client_scripts/core/planGeometry.js';
import { seededRandom } from '../../../support/random.js';

const kSquare = [[[0, 0], [10, 0], [10, 10], [0, 10]], [[4, 4], [4, 6], [6, 6], [6, 4]]];

test('the closed polygon holds its border, its vertices and its hole\'s border, not its hole', () => {
    for (const point of [[5, 1], [0, 0], [10, 5], [5, 10], [4, 5], [6, 6]]) assert.equal(isInside(kSquare, point), true, point);
    for (const point of [[5, 5], [-1, 5], [11, 5], [5, 11], [5, -1], [10, 11]]) assert.equal(isInside(kSquare, point), false, point);
});

/** Slow and obvious: BigInt crossing count against a ray to a point no lattice line meets. */
function windingOracle(ring, [x, y]) {
    let winding = 0;
    for (let i = 0; i < ring.length; ++i) {
        const [ax, ay] = ring[i].map(BigInt), [bx, by] = ring[(i + 1) % ring.length].map(BigInt);
        const px = BigInt(x), py = BigInt(y);
        const side = (bx - ax) * (py - ay) - (by - ay) * (px - ax);
        if (side === 0n && (px - ax) * (px - bx) <= 0n && (py - ay) * (py - by) <= 0n) return true;
        if (ay <= py && by > py && side > 0n) ++winding;
        if (ay > py && by <= py && side < 0n) --winding;
    }
    return winding !== 0;
}

test('isInside agrees with exact winding on star-shaped polygons of kilometres, at points chosen on and near edges', () => {
    for (let seed = 1; seed <= 200; ++seed) {
        const random = seededRandom(seed);
        const ring = Array.from({ length: 3 + Math.floor(random() * 20) }, (_, i, count = 23) => {
            const angle = 2 * Math.PI * (i + random() * 0.9) / count, radius = 1e3 + random() * 3e6;
            return [Math.round(radius * Math.cos(angle)), Math.round(radius * Math.sin(angle))];
        });
        for (let i = 0; i < 50; ++i) {
            const [a, b] = [ring[i % ring.length], ring[(i + 1) % ring.length]], t = random();
            const point = [Math.round(a[0] + t * (b[0] - a[0])), Math.round(a[1] + t * (b[1] - a[1])) + Math.round(random() * 2 - 1)];
            assert.equal(isInside([ring], point), windingOracle(ring, point), `seed ${seed} point ${point}`);
        }
    }
});

test('orient changes sign when its line is turned round', () => {
    const random = seededRandom(7), point = () => [Math.floor(random() * 100), Math.floor(random() * 100)];
    for (let i = 0; i < 1000; ++i) {
        const a = point(), b = point(), c = point();
        assert.equal(orient(a, b, c) + orient(b, a, c), 0);
    }
});

test('the nearest point of a segment is its end beyond the end, and a point for a segment without length', () => {
    assert.deepEqual(nearestOnSegment([0, 0], [10, 0], [15, 3]), [10, 0]);
    assert.deepEqual(nearestOnSegment([0, 0], [10, 0], [4, 3]), [4, 0]);
    assert.deepEqual(nearestOnSegment([2, 2], [2, 2], [4, 3]), [2, 2]);
});

test('distances: to edges from both sides, to a box from outside only', () => {
    assert.equal(distanceToEdges(kSquare, [5, 1]), 1);
    assert.equal(distanceToEdges(kSquare, [13, 14]), 5);
    assert.equal(boxDistance([0, 0, 10, 10], [13, 14]), 5);
    assert.equal(boxDistance([0, 0, 10, 10], [3, 4]), 0);
    assert.equal(distance([0, 0], [3, 4]), 5);
});

test('segments meet when they cross, touch or overlap, and not when they only come near', () => {
    assert.equal(segmentsMeet([0, 0], [10, 10], [0, 10], [10, 0]), true);
    assert.equal(segmentsMeet([0, 0], [10, 0], [5, 0], [5, 9]), true);
    assert.equal(segmentsMeet([0, 0], [10, 0], [5, 0], [15, 0]), true);
    assert.equal(segmentsMeet([0, 0], [10, 0], [11, 0], [15, 0]), false);
    assert.equal(segmentsMeet([0, 0], [10, 0], [5, 1], [5, 9]), false);
});

test('metres become the nearest millimetre', () => {
    assert.deepEqual(latticePoint([1.0004, -0.0016]), [1000, -2]);
});
