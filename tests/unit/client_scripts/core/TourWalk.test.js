import assert from 'node:assert/strict';
import test from 'node:test';
import { TourWalk } from '../../../../client_scripts/core/TourWalk.js';
import { degreesFromPlan, planFromDegrees } from '../../../../client_scripts/core/planFrame.js';

const corner = { points: [[0, 0, 10, 0], [0, 20, 12, 20], [30, 20, 12, 50]] };

test('a walk goes at a steady pace from point to point', () => {
    const walk = new TourWalk(corner);
    assert.equal(walk.length, 50);
    assert.deepEqual([walk.at(-1).north, walk.at(10).north, walk.at(10).ground], [0, 10, 11]);
    assert.deepEqual([walk.at(35).east, walk.at(35).north, walk.at(99).east], [15, 20, 30]);
});

test('a corner is looked round gently', () => {
    const walk = new TourWalk(corner), quarter = Math.PI / 2;
    assert.ok(Math.abs(walk.at(10).heading) < 1e-9 && Math.abs(walk.at(40).heading - quarter) < 1e-9);
    for (let at = 0; at < 50; at += 0.25) {
        const change = Math.abs(walk.at(at + 0.25).heading - walk.at(at).heading);
        assert.ok(change <= quarter / 4 * 0.25 + 1e-9, `${change} rad in a quarter of a metre at ${at} m`);
    }
});

test('turning back never jumps', () => {
    const walk = new TourWalk({ points: [[0, 0, 0, 0], [0, 20, 0, 20], [0, 0, 0, 40], [-20, 0, 0, 60]] });
    for (let at = 0; at < 60; at += 0.25)
        assert.ok(Math.abs(walk.at(at + 0.25).heading - walk.at(at).heading) <= Math.PI / 4 * 0.25 + 1e-9);
});

test('a tour of one place stands there', () => {
    const walk = new TourWalk({ points: [[3, 4, 5, 0], [3, 4, 5, 0]] });
    assert.deepEqual([walk.at(0).east, walk.at(1).north], [3, 4]);
});

test('degrees from the plan are those that lead there', () => {
    for (const origin of [[48.88, 2.34], [-33.9, 151.2], [69.6, 18.9]])
        for (const place of [[0, 0], [1234.567, -987.654], [-20000, 30000]]) {
            const [east, north] = planFromDegrees(degreesFromPlan(place, origin), origin);
            assert.ok(Math.hypot(east - place[0], north - place[1]) < 1e-5);
        }
});
