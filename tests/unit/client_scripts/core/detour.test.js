import assert from 'node:assert/strict';
import test from 'node:test';
import { GroundWalls, kVisitorRadiusMm } from '../../../../client_scripts/core/GroundWalls.js';
import { detourRound } from '../../../../client_scripts/core/detour.js';
import { distance } from '../../../../client_scripts/core/planGeometry.js';
import { sectorFromRecord } from '../../../../client_scripts/core/sectorRecord.js';
import { streetRecords } from '../../../support/streetRecords.js';

const streetWith = bodies => new GroundWalls([sectorFromRecord({ ...streetRecords()[0], bodies })]);
const lengthOf = (from, way) => way.reduce(([sum, at], to) => [sum + distance(at, to), to], [0, from])[0];

test('the way round a bench ends behind it, touches nothing and is little longer than straight', () => {
    const walls = streetWith([[20, 5, 0.5]]), from = [19200, 5000], way = detourRound(walls, from, [1, 0]);
    assert.ok(way.at(-1)[0] > 20700, String(way));
    let at = from;
    for (const to of way) {
        for (let share = 0; share <= 1; share += 0.02) {
            const point = [at[0] + share * (to[0] - at[0]), at[1] + share * (to[1] - at[1])];
            assert.ok(walls.clearance(point) >= kVisitorRadiusMm - 40, `${walls.clearance(point)} mm at ${point}`);
        }
        at = to;
    }
    assert.ok(lengthOf(from, way) < 1.8 * distance(from, way.at(-1)), String(way));
});

test('the way keeps to the side where there is room', () => {
    const way = detourRound(streetWith([[20, 9.4, 0.1]]), [19600, 9400], [1, 0]);
    assert.ok(way.some(([, north]) => north < 9100), String(way));
});

test('no way where a wall ends it, before or behind the body', () => {
    assert.equal(detourRound(streetWith([[20, 9.4, 0.5]]), [20000, 8600], [0, 1]), null);
    assert.equal(detourRound(streetWith([[39.6, 5, 0.3]]), [38900, 5000], [1, 0]), null);
});

test('through the bodies where they leave no room', () => {
    const row = Array.from({ length: 18 }, (_, i) => [20, 0.6 * i, 0.08]);
    const way = detourRound(streetWith(row), [19620, 5000], [1, 0]);
    assert.ok(way.at(-1)[0] >= 20300 && way.every(([, north]) => Math.abs(north - 5000) < 5), String(way));
});
