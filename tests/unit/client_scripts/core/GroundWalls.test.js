import assert from 'node:assert/strict';
import test from 'node:test';
import { GroundWalls, constrainMetres, kVisitorRadiusMm } from '../../../../client_scripts/core/GroundWalls.js';
import { distance } from '../../../../client_scripts/core/planGeometry.js';
import { sectorFromRecord } from '../../../../client_scripts/core/sectorRecord.js';
import { seededRandom } from '../../../support/random.js';
import { streetRecords } from '../../../support/streetRecords.js';

const kSlack = 5;
const wallsOf = (...ids) => new GroundWalls(streetRecords().filter(({ id }) => ids.includes(id)).map(sectorFromRecord));

test('a walker stops a radius before the wall and slides along it', () => {
    const walls = wallsOf('s0', 's1');
    assert.deepEqual(walls.constrain([20000, 5000], [20000, 50000]), [20000, 10000 - kVisitorRadiusMm]);
    const slid = walls.constrain([20000, 9700], [24000, 13000]);
    assert.ok(slid[0] > 23900 && slid[1] <= 9700 + 1, String(slid));
});

test('a gate to a sector that is there is open, to one that is not there it is a wall, as is the end of the city', () => {
    assert.deepEqual(wallsOf('s0', 's1').constrain([39000, 5000], [45000, 5000]), [45000, 5000]);
    assert.deepEqual(wallsOf('s0').constrain([39000, 5000], [45000, 5000]), [40000 - kVisitorRadiusMm, 5000]);
    assert.deepEqual(wallsOf('s0', 's1').constrain([1000, 5000], [-5000, 5000]), [kVisitorRadiusMm, 5000]);
});

test('a walker goes through a gate in the middle of a side and stays off its posts', () => {
    const walls = wallsOf('s2', 'yard');
    assert.deepEqual(walls.constrain([100000, 9000], [100000, 12000]), [100000, 12000]);
    const slanting = walls.constrain([95000, 9000], [97500, 13000]);
    assert.ok(walls.isOnGround(slanting) && walls.clearance(slanting) >= kVisitorRadiusMm - kSlack);
});

test('a fast walker does not pass a wall in one step', () => {
    const walls = wallsOf('s0', 's1', 's2', 'yard');
    const end = walls.constrain([100000, 15000], [100000, 500000]);
    assert.ok(walls.isOnGround(end) && walls.clearance(end) >= kVisitorRadiusMm - kSlack, String(end));
});

test('from outside, a walker is taken onto the ground nearby, and stays where there is none', () => {
    const walls = wallsOf('s0');
    assert.deepEqual(walls.constrain([20000, 12000], [20000, 13000]), [20000, 10000 - kVisitorRadiusMm]);
    assert.deepEqual(walls.constrain([20000, 90000], [20000, 91000]), [20000, 90000]);
});

test('a walker keeps off a body and slides round it; one who stands too near may leave', () => {
    const [s0] = streetRecords(), walls = new GroundWalls([sectorFromRecord({ ...s0, bodies: [[20, 5, 0.5]] })]);
    const head = walls.constrain([15000, 5000], [25000, 5000]);
    assert.ok(Math.abs(head[0] - 19200) <= kSlack, String(head));
    const round = walls.constrain([15000, 5300], [25000, 5300]);
    assert.ok(round[0] > 20500 && walls.clearance(round) >= kVisitorRadiusMm - kSlack, String(round));
    assert.ok(walls.constrain([20600, 5000], [23000, 5000])[0] >= 23000);
    assert.ok(distance(walls.withoutBodies().constrain([15000, 5000], [25000, 5000]), [25000, 5000]) < 1);
});

test('metres go in and come out', () => {
    const end = constrainMetres(wallsOf('s0'), [20, 5], [21.5, 6]);
    assert.ok(distance(end, [21.5, 6]) < 1e-9, String(end));
});

test('random walkers in random rooms with pillars never leave, never come nearer than the radius, and do get about', () => {
    for (let seed = 1; seed <= 60; ++seed) {
        const random = seededRandom(seed), walls = new GroundWalls([randomRoom(random)]);
        let at = [0, 0], travelled = 0;
        for (let i = 0; i < 200; ++i) {
            const angle = random() * 2 * Math.PI, length = random() * 4000;
            const next = walls.constrain(at, [at[0] + length * Math.cos(angle), at[1] + length * Math.sin(angle)]);
            assert.ok(walls.isOnGround(next), `seed ${seed} step ${i}: ${next} is off the ground`);
            assert.ok(walls.clearance(next) >= kVisitorRadiusMm - kSlack, `seed ${seed} step ${i}: ${walls.clearance(next)} mm`);
            travelled += distance(at, next);
            at = next;
        }
        assert.ok(travelled > 100000, `seed ${seed}: only ${travelled} mm in 200 steps`);
    }
});

/** A star-shaped room of 12 to 30 m with a square pillar in each quadrant, around a free middle. */
function randomRoom(random) {
    const corners = 8 + Math.floor(random() * 16);
    const outer = Array.from({ length: corners }, (_, i) => {
        const angle = 2 * Math.PI * (i + 0.8 * random()) / corners, radius = 12 + random() * 18;
        return [radius * Math.cos(angle), radius * Math.sin(angle)];
    });
    const pillars = [[4, 4], [-4, 4], [-4, -4], [4, -4]].map(([x, y]) => {
        const half = 0.2 + random();
        return [[x - half, y - half], [x - half, y + half], [x + half, y + half], [x + half, y - half]];
    });
    return sectorFromRecord({ id: 'room', origin: [0, 0], box: [-31, -31, 31, 31], ground: [outer, ...pillars], gates: [] });
}
