import assert from 'node:assert/strict';
import test from 'node:test';
import { Doors, kReachMm, paintDoor } from '../../../../client_scripts/core/Doors.js';
import { GroundWalls } from '../../../../client_scripts/core/GroundWalls.js';
import { SectorFinder } from '../../../../client_scripts/core/SectorFinder.js';
import { SectorLoader } from '../../../../client_scripts/core/SectorLoader.js';
import { recordFromMetadata } from '../../../../client_scripts/core/recordMetadata.js';
import { levelOf, sectorFromRecord } from '../../../../client_scripts/core/sectorRecord.js';
import { metadataOf } from '../../../support/fakeScene.js';
import { houseRecords, houseSectors } from '../../../support/houseRecords.js';

const kFrame = 1 / 30;
const kBefore = [20500, 8000], kDoorway = [20500, 10100], kInside = [20500, 13000];

/** Doors alone: files are live when the test says so. */
class House {
    constructor(live = ['s0']) {
        Object.assign(this, { sectors: houseSectors(), live: new Set(live), now: 0, current: 's0', looks: new Map(), paints: 0 });
        this.doors = new Doors((stem, door, look) => {
            assert.ok(this.live.has(stem), `${door} of ${stem} is painted, and not there`);
            this.looks.set(door, look);
            ++this.paints;
        });
    }

    door(sector, id) {
        return this.sectors.get(sector).doors.find(door => door.id === id);
    }

    touch(sector, id) {
        this.doors.touch(this.door(sector, id), this.current, this.now);
        return this;
    }

    stay(point, seconds) {
        for (const end = this.now + seconds; this.now < end;) {
            this.now += kFrame;
            this.isMoving = this.doors.step(this.now, point, this.current, this.sectors, stem => this.live.has(stem));
        }
        return this;
    }

    get phases() {
        return [...this.doors.states.values()].map(({ phase }) => phase).join();
    }
}

test('a click lights what is behind, and the leaf opens no sooner than that is there', () => {
    const house = new House().stay(kBefore, 0.1).touch('s0', 'd').stay(kBefore, 2);
    assert.equal(house.phases, 'loading');
    assert.deepEqual(house.doors.wanted, ['s0', 'hall']);
    assert.deepEqual(house.looks.get('d'), { angle: 0, light: 1, isBare: false });
    assert.deepEqual(house.doors.open, []);
    house.live.add('hall');
    house.stay(kBefore, 0.8);
    const { angle, isBare } = house.looks.get('d');
    assert.ok(angle > 0.3 && angle < 0.7, `${angle}`);
    assert.ok(isBare, 'the picture stays before what is there');
    assert.deepEqual(house.looks.get('d-in'), house.doors.shown.get('d-in'));
    assert.equal(house.looks.get('d-in').angle, angle, 'the two faces of the leaf part');
    house.stay(kBefore, 1.5);
    assert.equal(house.phases, 'open');
    assert.deepEqual(house.doors.open.sort(), ['d', 'd-in']);
    assert.equal(house.isMoving, false);
});

test('who goes deep inside has the door shut behind him, and nothing is wanted any more', () => {
    const house = new House(['s0', 'hall']).touch('s0', 'd').stay(kBefore, 3).stay(kDoorway, 1);
    assert.equal(house.phases, 'open');
    house.current = 'hall';
    house.stay([20500, 11300], 3);
    assert.equal(house.phases, 'open', 'it shut on somebody\'s heels');
    house.stay(kInside, 3);
    assert.equal(house.phases, '');
    assert.deepEqual(house.doors.wanted, []);
    assert.deepEqual(house.doors.open, []);
    assert.equal(house.looks.get('d-in').angle, 0);
});

test('a door does not shut on who stands in it', () => {
    const house = new House(['s0', 'hall']).touch('s0', 'd').stay(kBefore, 3).touch('s0', 'd').stay(kBefore, 0.3);
    assert.equal(house.phases, 'shutting');
    house.stay(kDoorway, 2);
    assert.equal(house.phases, 'open');
});

test('in a small room deep inside is nearer', () => {
    const house = new House(['hall', 'closet']);
    house.current = 'hall';
    house.touch('hall', 'e').stay([20000, 15000], 3);
    house.current = 'closet';
    house.stay([20000, 18200], 3);
    assert.equal(house.phases, '');
});

test('a second click shuts it, and so does going away, or never coming', () => {
    const clicked = new House(['s0', 'hall']).touch('s0', 'd').stay(kBefore, 3).touch('s0', 'd').stay(kBefore, 3);
    assert.equal(clicked.phases, '');
    const gone = new House(['s0', 'hall']).touch('s0', 'd').stay(kBefore, 3).stay([35000, 5000], 2);
    assert.equal(gone.phases, '');
    const never = new House(['s0', 'hall']).touch('s0', 'd').stay([35000, 5000], 30);
    assert.equal(never.phases, 'open', 'he needs time to come');
    assert.equal(never.stay([35000, 5000], 20).phases, '');
});

test('what cannot be had is given up, dark and shut', () => {
    const house = new House().touch('s0', 'd').stay(kBefore, 29);
    assert.equal(house.phases, 'loading');
    house.stay(kBefore, 3);
    assert.equal(house.phases, '');
    assert.deepEqual(house.looks.get('d'), { angle: 0, light: 0, isBare: false });
});

test('a file that comes again looks as its door stands; what does not change is not painted', () => {
    const house = new House(['s0', 'hall']).stay(kBefore, 0.2).touch('s0', 'd').stay(kBefore, 4);
    const { paints } = house;
    house.stay(kBefore, 2);
    assert.equal(house.paints, paints);
    house.live.delete('hall');
    house.stay(kBefore, 0.1);
    house.live.add('hall');
    house.looks.delete('d-in');
    house.stay(kBefore, 0.1);
    assert.equal(house.looks.get('d-in').angle, 1);
});

test('the door one means is near and ahead', () => {
    const { doors, sectors } = new House(), hall = sectors.get('hall');
    assert.equal(doors.near([20400, 13100], hall, 0).door.id, 'e');
    assert.equal(doors.near([20400, 13100], hall, Math.PI).door.id, 'd-in');
    assert.equal(doors.near([20500, 10000 - kReachMm - 100], sectors.get('s0'), 0), null);
    assert.equal(doors.near([5000, 5000], sectors.get('s1'), 0), null);
});

test('walls have a gap where a door stands open, and none where it is shut', () => {
    const sectors = ['s0', 'hall'].map(id => houseSectors().get(id));
    const shut = new GroundWalls(sectors), open = new GroundWalls(sectors, undefined, ['d', 'd-in', 'e', 'e-in']);
    const walk = (walls, from, to) => {
        let at = from;
        for (let i = 1; i <= 40; ++i) at = walls.constrain(at, [from[0] + (to[0] - from[0]) * i / 40, from[1] + (to[1] - from[1]) * i / 40]);
        return at;
    };
    assert.ok(walk(shut, kBefore, kInside)[1] < 9800);
    assert.deepEqual(walk(open, kBefore, kInside).map(Math.round), kInside);
    assert.deepEqual(walk(open, kInside, kBefore).map(Math.round), kBefore);
    assert.ok(walk(open, [18000, 8000], [18000, 13000])[1] < 9800, 'beside the door is wall');
    assert.ok(walk(open, [20000, 15000], [20000, 18000])[1] < 16300, 'what is not there is not walked into');
});

test('doors a few millimetres behind the wall, and walls with a corner in the doorway, open all the same', () => {
    const records = houseRecords(), [street] = records, hall = records.find(({ id }) => id === 'hall');
    street.ground = [[[0, 0], [40, 0], [40, 10], [20.5, 10.004], [0, 10]]];
    for (const ring of hall.ground) for (const corner of ring) if (corner[1] === 10) corner[1] = 10.008;
    for (const { line } of [street.doors[0], hall.doors[0]]) for (const end of line) end[1] = 10.008;
    const walls = new GroundWalls([street, hall].map(sectorFromRecord), undefined, ['d', 'd-in']);
    assert.deepEqual(walls.constrain([20500, 9000], [20500, 12000]).map(Math.round), [20500, 12000]);
});

for (const name of ['polygon', 'box', 'gate']) test(`by ${name}s a visitor is found inside, and outside again`, () => {
    const sectors = houseSectors(), finder = new SectorFinder(name), way = [];
    let current = 's0';
    for (let y = 8000; y <= 13000; y += 100) way.push([20500, y]);
    for (let y = 13000; y >= 8000; y -= 100) way.push([20500, y]);
    const seen = way.map(point => [point[1], current = finder.find(sectors, current, point)]);
    const changes = seen.filter(([, id], i) => i > 0 && id !== seen[i - 1][1]);
    assert.deepEqual(changes.map(([, id]) => id), ['hall', 's0']);
    const [[entered], [left]] = changes;
    assert.ok(entered > 10400 && entered <= 10700, `${entered}`);
    assert.ok(left < 9600 && left >= 9300, `${left}`);
    finder.jump();
    assert.equal(finder.find(sectors, 's2', [20000, 18000]), 'closet');
});

test('the loader wants both sides of a door in use with their L_i, and lets go of the street behind a shut one', () => {
    const records = new Map(houseRecords().map(record => [record.id, record])), files = new Map(), touched = new Map();
    const sectors = {
        show: stem => files.set(stem, 'live'), hide: stem => files.delete(stem), phase: stem => files.get(stem),
        record: stem => records.get(stem), links: () => null, setDoor() {}, touchTime: (stem, door) => touched.get(door) ?? 0,
    };
    const loader = new SectorLoader('s0', sectors, { fixedLevel: 1 });
    loader.planner.addNeighbour(records.get('s0'));
    let now = 0, plan = null;
    const stay = (point, seconds) => {
        for (const end = now + seconds; now < end;) plan = loader.step(point.map(mm => mm / 1000), now += kFrame);
        return [...files.keys()].filter(stem => levelOf(stem) === 'near').sort();
    };
    assert.deepEqual(stay(kBefore, 1), ['s0', 's1'], 'a shut door leads nowhere');
    touched.set('d', 12.5);
    assert.deepEqual(stay(kBefore, 4), ['hall', 's0', 's1']);
    assert.deepEqual(loader.doors.open.sort(), ['d', 'd-in']);
    stay([20500, 10200], 0.5);
    stay([20500, 11500], 0.5);
    assert.deepEqual(stay(kInside, 4), ['hall', 's0', 's1'], 'what was left stays a moment');
    assert.equal(plan.current, 'hall');
    assert.deepEqual(stay(kInside, 12), ['hall']);
    touched.set('d-in', 30);
    assert.deepEqual(stay(kInside, 1), ['hall', 's0', 's1']);
});

test('doors come out of a file\'s metadata as out of its JSON', () => {
    const record = houseRecords().find(({ id }) => id === 'hall');
    const read = recordFromMetadata(metadataOf(record));
    assert.deepEqual(read.doors, record.doors);
    assert.deepEqual(sectorFromRecord(read).doors, sectorFromRecord(record).doors);
    assert.throws(() => sectorFromRecord({ ...record, doors: [{ id: 'x', to: 's0', line: [[0, 0], [1, 0]], origin: [0, 0], box: [0, 0, 1, 1] }] }), /twin/);
});

test('a leaf is painted as far open as it is', () => {
    const nodes = new Map(), find = name => nodes.get(name) ?? nodes.set(name, {}).get(name);
    const values = { find, rotation: (...v) => v, color: (...v) => v };
    paintDoor('d', { angle: 0, light: 0, isBare: false }, values);
    const dark = find('DOOR-GLASS-d').transparency;
    assert.equal(Math.abs(find('DOOR-LEAF-d').rotation[3]), 0);
    paintDoor('d', { angle: 1, light: 1, isBare: true }, values);
    assert.ok(find('DOOR-LEAF-d').rotation[3] < -Math.PI / 2, 'wider than square');
    assert.ok(find('DOOR-GLASS-d').transparency > dark + 0.3);
    assert.ok(find('DOOR-LAMP-d').emissiveColor.every(v => v > 0.2));
    assert.equal(find('DOOR-BEYOND-d').visible, false);
});
