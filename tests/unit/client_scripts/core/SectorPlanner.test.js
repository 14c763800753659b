import assert from 'node:assert/strict';
import test from 'node:test';
import { SectorPlanner } from '../../../../client_scripts/core/SectorPlanner.js';
import { idOf, levelOf, levelsAround } from '../../../../client_scripts/core/sectorRecord.js';
import { seeingFar, streetRecords } from '../../../support/streetRecords.js';

/** A visitor in the street: every load arrives `delay` frames later (60 frames a second). */
class Visit {
    constructor({ start = 's0', options = {}, delay = 3, records = streetRecords(), broken = new Set() } = {}) {
        this.records = new Map(records.map(record => [record.id, record]));
        this.planner = new SectorPlanner(start, { fixedLevel: 1, ...options });
        this.planner.addNeighbour(this.records.get(start));
        Object.assign(this, { delay, broken, now: 0, pending: [], live: new Set(), asked: [], unloads: [], perFrame: 0 });
    }

    frame(position) {
        this.now += 1 / 60;
        for (const job of this.pending.filter(job => job.due <= this.now))
            if (this.planner.states.has(job.id)) this.settle(job.id);
        this.pending = this.pending.filter(job => job.due > this.now);
        const plan = this.planner.plan(position, this.now);
        for (const id of plan.unload) this.live.delete(id), this.unloads.push(id);
        for (const id of plan.load) this.asked.push(id), this.pending.push({ id, due: this.now + this.delay / 60 });
        this.perFrame = Math.max(this.perFrame, plan.load.length);
        return plan;
    }

    settle(stem) {
        if (this.broken.has(stem)) return this.planner.failed(stem, this.now);
        this.live.add(stem);
        this.planner.arrived(stem, levelOf(stem) === 'tall' ? null : this.records.get(idOf(stem)));
    }

    stay(position, seconds) {
        for (let i = 0; i < seconds * 60; ++i) this.frame(position);
        return this;
    }

    walk(from, to, speed = 1.5) {
        const length = Math.hypot(to[0] - from[0], to[1] - from[1]), frames = Math.ceil(length / speed * 60);
        for (let i = 0; i <= frames; ++i)
            this.frame([from[0] + (to[0] - from[0]) * i / frames, from[1] + (to[1] - from[1]) * i / frames]);
        return this;
    }

    get liveIds() {
        return [...this.live].sort();
    }
}

test('the first sector comes first, then its gate neighbours, one asked for per frame', () => {
    const visit = new Visit({ start: 's2' }).stay([100, 5], 1);
    assert.equal(visit.asked[0], 's2');
    assert.deepEqual(visit.liveIds, ['s1', 's2', 's3', 'yard']);
    assert.equal(visit.perFrame, 1);
});

test('before the visitor\'s place is known the start sector is current, and nothing else is asked for', () => {
    const visit = new Visit({ start: 's2' }).stay(null, 1);
    assert.equal(visit.planner.current, 's2');
    assert.deepEqual(visit.liveIds, ['s2']);
    assert.deepEqual(visit.stay([100, 5], 1).liveIds, ['s1', 's2', 's3', 'yard']);
});

test('along the street and back: L_1 is there at every moment, what was left goes after keepSeconds, nothing is asked twice', () => {
    const visit = new Visit({ options: { keepSeconds: 10 } }).stay([20, 5], 1);
    for (let i = 1; i < 6; ++i) {
        visit.walk([40 * i - 20, 5], [40 * i + 20, 5]);
        assert.equal(visit.planner.current, `s${i}`);
        for (const id of levelsAround(visit.planner.sectors.get(`s${i}`)).keys()) assert.ok(visit.live.has(id), `${id} at s${i}`);
    }
    assert.deepEqual(visit.stay([220, 5], 11).liveIds, ['s4', 's5']);
    const asked = [...visit.asked];
    assert.equal(new Set(asked).size, asked.length, `asked twice: ${asked}`);
    assert.ok(!asked.includes('s6'));
});

test('turning round at a gate within the hysteresis changes nothing', () => {
    const visit = new Visit().stay([20, 5], 1);
    for (let i = 0; i < 5; ++i) visit.walk([39, 5], [40.45, 5]).walk([40.45, 5], [39, 5]);
    assert.equal(visit.planner.current, 's0');
    visit.walk([39, 5], [40.6, 5]);
    assert.equal(visit.planner.current, 's1');
    visit.walk([40.6, 5], [39.6, 5]);
    assert.equal(visit.planner.current, 's1');
    visit.walk([39.6, 5], [39.4, 5]);
    assert.equal(visit.planner.current, 's0');
    assert.deepEqual(visit.unloads.filter(stem => levelOf(stem) === 'near'), []);
});

test('a walker who turns back within keepSeconds finds the sector there', () => {
    const visit = new Visit({ options: { keepSeconds: 10 } }).stay([20, 5], 1).walk([20, 5], [85, 5]).stay([85, 5], 3).walk([85, 5], [20, 5]);
    assert.equal(visit.asked.filter(id => id === 's0').length, 1);
    assert.deepEqual(visit.unloads.includes('s0'), false);
});

test('in a hole of the ground, or in no ground, the current sector stays', () => {
    const visit = new Visit({ start: 'yard' }).stay([100, 13], 1);
    assert.equal(visit.frame([100, 20]).current, 'yard');
    assert.equal(visit.frame([500, 500]).current, 'yard');
});

test('after a jump every known ground is tested, and an unloaded sector whose box holds the visitor is asked for', () => {
    const visit = new Visit({ options: { keepSeconds: 1 } }).stay([20, 5], 1).walk([20, 5], [180, 5]).stay([180, 5], 2);
    assert.equal(visit.frame([20, 5]).current, 's0');

    const blind = new Visit().stay([20, 5], 1);
    blind.planner.addNeighbour(blind.records.get('s4'));
    assert.equal(blind.stay([180, 5], 1).planner.current, 's4');
});

test('gate neighbours are near, what else is visible is far, what is seen over roofs alone is tall; near comes first', () => {
    const records = seeingFar(streetRecords(), { overRoofs: ['s5'] });
    const visit = new Visit({ start: 's1', records }).stay([60, 5], 1);
    assert.deepEqual(visit.liveIds, ['s0', 's1', 's2', 's3.far', 's4.far', 's5.tall', 'yard.far']);
    assert.deepEqual(visit.asked.map(levelOf), ['near', 'near', 'near', 'far', 'far', 'far', 'tall']);
    assert.equal(visit.perFrame, 1);
});

test('a gate neighbour is near even where the record says that it is seen over roofs', () => {
    const levels = levelsAround({ id: 'a', gates: [{ to: 'b' }, { to: null }], visible: ['a', 'b', 'c'], overRoofs: ['b', 'c'] });
    assert.deepEqual([...levels], [['a', 'near'], ['b', 'near'], ['c', 'tall']]);
});

test('the sector behind the nearest gate is asked for first', () => {
    assert.deepEqual(new Visit({ start: 's2' }).stay([117, 5], 1).asked, ['s2', 's3', 'yard', 's1']);
    assert.deepEqual(new Visit({ start: 's2' }).stay([100, 9], 1).asked.slice(0, 2), ['s2', 'yard']);
});

test('along the street and back: no hole where a sector changes its level, no sector twice, one file asked for per frame', () => {
    for (const overRoofs of [[], ['s0', 's4', 'yard']]) {
        const visit = new Visit({ options: { keepSeconds: 2 }, records: seeingFar(streetRecords(), { overRoofs }) }).stay([20, 5], 2);
        const seen = new Set([...visit.live].map(idOf));
        assert.equal(seen.size, 7);
        for (const [from, to] of [[20, 220], [220, 20]]) for (let x = from; (to - x) * (to - from) > 0; x += (to - from) / 8000) {
            visit.frame([x, 5]);
            const ids = [...visit.live].map(idOf);
            assert.deepEqual(ids.length, new Set(ids).size, `two files of a sector at ${x}: ${visit.liveIds}`);
            for (const id of seen) assert.ok(ids.includes(id), `${id} is not there at ${x}: ${visit.liveIds}`);
        }
        const files = levelsAround(visit.planner.sectors.get('s0'));
        for (const stem of visit.stay([20, 5], 4).live) assert.equal(levelOf(stem), files.get(idOf(stem)), stem);
        assert.equal(visit.perFrame, 1);
    }
});

test('a sector left behind stays near for keepSeconds, then its far file takes its place; back at once', () => {
    const visit = new Visit({ options: { keepSeconds: 5 }, records: seeingFar(streetRecords()) }).stay([20, 5], 1);
    visit.walk([20, 5], [85, 5], 20).stay([85, 5], 4);
    assert.ok(visit.live.has('s0') && !visit.asked.includes('s0.far'));
    visit.stay([85, 5], 3);
    assert.ok(!visit.live.has('s0') && visit.live.has('s0.far'));
    visit.walk([85, 5], [60, 5], 20).stay([60, 5], 0.5);
    assert.ok(visit.live.has('s0') && !visit.live.has('s0.far'));
});

test('wakeAt is when a sector is due to change to its far file', () => {
    const visit = new Visit({ options: { keepSeconds: 5 }, records: seeingFar(streetRecords()) }).stay([20, 5], 1);
    visit.walk([20, 5], [85, 5], 20).stay([85, 5], 1);
    assert.ok(visit.frame([85, 5]).wakeAt < visit.now + 2.1, 'when he rests, what he walked to is no longer ahead');
    visit.stay([85, 5], 2.1);
    const { wakeAt } = visit.frame([85, 5]);
    assert.ok(wakeAt > visit.now && wakeAt < visit.now + 3, `${wakeAt - visit.now}`);
    visit.stay([85, 5], 6);
    assert.equal(visit.frame([85, 5]).wakeAt, Infinity);
});

test('a far file that cannot be had leaves the near one there', () => {
    const visit = new Visit({ options: { keepSeconds: 1 }, records: seeingFar(streetRecords()), broken: new Set(['s0.far']) });
    visit.stay([20, 5], 1).walk([20, 5], [85, 5], 20).stay([85, 5], 20);
    assert.ok(visit.live.has('s0'));
    assert.ok(visit.asked.filter(stem => stem === 's0.far').length >= 3);
    visit.broken.clear();
    assert.deepEqual(visit.stay([85, 5], 20).liveIds.filter(stem => idOf(stem) === 's0'), ['s0.far']);
});

test('over the cap sectors become far at once', () => {
    const records = seeingFar(streetRecords().map(record => ({ ...record, shapes: 100,
        neighbours: record.neighbours.map(neighbour => ({ ...neighbour, shapes: 100 })) })));
    const visit = new Visit({ records, options: { shapeCap: 440, keepSeconds: 1e6 } }).stay([20, 5], 1);
    for (let x = 20; x < 220; x += 0.1) {
        visit.frame([x, 5]);
        assert.ok(visit.planner.liveShapes() <= 440 + 1, `${visit.planner.liveShapes()} at ${x}`);
        assert.ok(visit.live.has(visit.planner.current));
        for (const id of visit.records.keys()) assert.ok(visit.liveIds.some(stem => idOf(stem) === id), `${id} at ${x}`);
    }
});

test('in a world of near files alone every visible sector is near', () => {
    const visit = new Visit({ start: 's1', records: seeingFar(streetRecords(), { overRoofs: ['s5'] }), options: { nearOnly: true } });
    assert.deepEqual(visit.stay([60, 5], 1).liveIds, ['s0', 's1', 's2', 's3', 's4', 's5', 'yard']);
});

test('a sector that cannot be had is asked for after 1, 2, 4, ... 30 s, and comes when it can be had', () => {
    const visit = new Visit({ broken: new Set(['s1']), delay: 0 });
    const times = [];
    for (let i = 0; i < 60 * 100; ++i) if (visit.frame([20, 5]).load.includes('s1')) times.push(visit.now);
    const waits = times.slice(1).map((time, i) => Math.round(time - times[i]));
    assert.deepEqual(waits, [1, 2, 4, 8, 16, 30, 30]);
    visit.broken.clear();
    assert.ok(visit.stay([20, 5], 31).live.has('s1'));
});

test('wakeAt is when the next retry or unload is due, now while more is to be asked for, never when all is settled', () => {
    const visit = new Visit({ broken: new Set(['s2']), options: { keepSeconds: 10 } });
    assert.equal(visit.frame([20, 5]).wakeAt, visit.now);
    visit.stay([20, 5], 1);
    assert.equal(visit.frame([20, 5]).wakeAt, Infinity);
    visit.walk([20, 5], [50, 5]).stay([50, 5], 0.5);
    const { wakeAt } = visit.frame([50, 5]);
    assert.ok(wakeAt > visit.now && wakeAt < visit.now + 2.1, `${wakeAt - visit.now} s`);
});

test('live Shapes stay under the cap: what was left the longest ago goes first, the farthest is not asked for', () => {
    const records = streetRecords(6).map(record => ({ ...record, shapes: 100,
        neighbours: record.neighbours.map(neighbour => ({ ...neighbour, shapes: 100 })) }));
    const visit = new Visit({ records, options: { shapeCap: 350, keepSeconds: 1e6 } }).stay([20, 5], 1);
    for (let x = 20; x < 220; x += 0.1) {
        visit.frame([x, 5]);
        assert.ok(visit.planner.liveShapes() <= 350, `${visit.planner.liveShapes()} at ${x}`);
        assert.ok(visit.live.has(visit.planner.current));
    }
    assert.equal(visit.unloads.find(stem => levelOf(stem) === 'near'), 's0');
});

test('at most three are on their way at a time', () => {
    const visit = new Visit({ start: 's2', delay: 600 });
    visit.settle('s2');
    visit.stay([100, 5], 5);
    assert.equal(visit.asked.length, 3);
});

test('a record that belongs to another sector, or lacks its ground, is refused by name', () => {
    const planner = new SectorPlanner('s0'), [s0, s1] = streetRecords();
    assert.throws(() => planner.arrived('s0', s1), /asked for sector s0, the file's record says s1/);
    assert.throws(() => planner.arrived('s0', { ...s0, ground: [] }), /sector s0: its record has no ground/);
    assert.throws(() => planner.addNeighbour({ id: 's9', origin: [0, 'x'], box: [0, 0, 1, 1] }), /needs id, origin and box/);
});

test('what is on its way and no longer wanted is given up at once', () => {
    const visit = new Visit({ records: seeingFar(streetRecords()), delay: 600, options: { fixedLevel: 1 } });
    visit.settle('s0');
    visit.stay([20, 5], 1);
    assert.deepEqual(visit.asked, ['s0', 's1', 's2.far']);
    assert.deepEqual(visit.unloads, []);
    visit.planner.choice.set(0);
    assert.deepEqual(visit.frame([20, 5]).unload.sort(), ['s1', 's2.far']);
    assert.deepEqual([...visit.planner.states.keys()], ['s0']);
});

test('L_0 is the sector alone, and what lies behind a gate for who stands near it', () => {
    const visit = new Visit({ start: 's1', options: { fixedLevel: 0, keepSeconds: 1 } }).stay([60, 5], 1);
    assert.deepEqual(visit.liveIds, ['s1']);
    assert.deepEqual(visit.stay([70, 5], 1).liveIds, ['s1', 's2']);
    assert.deepEqual(visit.stay([60, 5], 3).liveIds, ['s1']);
});

test('L_2 comes after L_1, by the gates where no list is, by the lists where they are; i may change on the way', () => {
    const visit = new Visit({ options: { fixedLevel: 2, keepSeconds: 1 } }).stay([20, 5], 1);
    assert.deepEqual(visit.asked, ['s0', 's1', 's2.far']);
    visit.planner.choice.set(3);
    assert.deepEqual(visit.stay([20, 5], 1).liveIds, ['s0', 's1', 's2.far', 's3.far', 'yard.far']);
    visit.planner.choice.set(1);
    assert.deepEqual(visit.stay([20, 5], 3).liveIds, ['s0', 's1']);
});

test('a sector marked important stays near when it is left, others go after keepSeconds', () => {
    const records = streetRecords().map(record => ({ ...record, important: record.id === 's1' ? ['s0'] : [] }));
    const visit = new Visit({ records, options: { keepSeconds: 2 } }).stay([20, 5], 1).walk([20, 5], [140, 5], 20).stay([140, 5], 60);
    assert.ok(visit.live.has('s0') && !visit.live.has('s1'), visit.liveIds.join());
    assert.ok(!visit.stay([140, 5], 300).live.has('s0'), 'not for ever');
});

test('of what is far, what he looks at comes first, and what is large on the screen before what is small', () => {
    const records = seeingFar(streetRecords());
    for (const [heading, first] of [[Math.PI / 2, ['s4.far', 's5.far', 's0.far']], [-Math.PI / 2, ['s0.far', 's4.far', 's5.far']]]) {
        const planner = new SectorPlanner('s2', { fixedLevel: 1, loadsInFlight: 99 }), asked = [];
        for (const record of records) planner.addNeighbour(record);
        planner.learn('s2', records[2]);
        for (let i = 0; i < 10; ++i) asked.push(...planner.plan([100, 5], i / 60, { heading }).load);
        assert.deepEqual(asked.filter(stem => first.includes(stem)), first);
    }
});

test('i goes by measure: up where all is calm, and wakeAt tells when', () => {
    const visit = new Visit({ options: { fixedLevel: null } }).stay([20, 5], 0.5);
    assert.equal(visit.planner.i, 1);
    const { wakeAt } = visit.frame([20, 5]);
    assert.ok(wakeAt > visit.now && wakeAt < visit.now + 1.1, `${wakeAt - visit.now}`);
    visit.stay([20, 5], 1.5);
    assert.equal(visit.planner.i, 2);
    assert.ok(visit.live.has('s2.far'));
});

test('many files by one request: the sector he is in alone, then all of L_1 at once, then all of the next ring at once', () => {
    const visit = new Visit({ start: 's0', records: seeingFar(streetRecords()), options: { fixedLevel: 2, filesAtOnce: 48 }, delay: 4 }), requests = [];
    for (let i = 0; i < 120; ++i) {
        const { load } = visit.frame([5, 0]);
        if (load.length) requests.push(load);
    }
    const one = new Visit({ start: 's0', records: seeingFar(streetRecords()), options: { fixedLevel: 2 } }).stay([5, 0], 5);
    assert.deepEqual(visit.liveIds, one.liveIds, 'the same files as one by one');
    assert.deepEqual(requests[0], ['s0']);
    const ringOf = stem => visit.planner.wantedNow.get(stem).ring;
    assert.ok(requests[1].length > 1);
    for (const load of requests) assert.equal(new Set(load.map(ringOf)).size, 1, `${load}: of one ring`);
    assert.deepEqual(visit.asked, [...new Set(visit.asked)], 'nothing is asked for twice');
    const few = new Visit({ start: 's0', records: seeingFar(streetRecords()), options: { fixedLevel: 1, filesAtOnce: 2, loadsInFlight: 1 }, delay: 4 }).stay([5, 0], 5);
    assert.equal(few.perFrame, 2);
});

test('what is needed most: by ring, then near before far before tall, what is not wanted last', () => {
    const visit = new Visit({ start: 's0', records: seeingFar(streetRecords()), options: { fixedLevel: 2 } }).stay([5, 0], 5);
    const stems = [...visit.planner.wantedNow.keys(), 'nobody'].sort((a, b) => visit.planner.compareNeed(a, b));
    const rings = stems.slice(0, -1).map(stem => visit.planner.wantedNow.get(stem).ring);
    assert.equal(stems[0], 's0');
    assert.equal(stems.at(-1), 'nobody');
    assert.deepEqual(rings, [...rings].sort());
});

test('how long files wait is told by who knows the line; else since when they were asked for', () => {
    for (const [waitSeconds, least] of [[null, 1], [0, 2]]) {
        const planner = new SectorPlanner('s0', { level: 2 }), [s0, ...others] = streetRecords();
        planner.addNeighbour(s0);
        planner.plan([5, 0], 0);
        planner.arrived('s0', s0);
        for (let now = 0; now < 30; now += 0.25) planner.plan([5, 0], now, { waitSeconds });
        assert.equal(planner.i, least, `${others.length} files never arrive`);
    }
});

test('who walks to a gate has what is seen from behind it before he is there; who stands or walks away has not', () => {
    const visit = new Visit().stay([30, 5], 1);
    assert.deepEqual(visit.liveIds, ['s0', 's1']);
    visit.walk([30, 5], [20.5, 5]);
    assert.deepEqual(visit.liveIds, ['s0', 's1'], 'away from it');
    const missing = [];
    for (let x = 20.5; x < 60; x += 1.4 / 60) {
        visit.frame([x, 5]);
        const here = visit.planner.sectors.get(visit.planner.current);
        const ids = new Set([...visit.live].map(idOf));
        for (const id of levelsAround(here).keys()) if (!ids.has(id)) missing.push(`${id} at ${x.toFixed(1)}`);
    }
    assert.equal(visit.planner.current, 's1');
    assert.deepEqual(missing, []);
});

test('who rests before a gate keeps L_1 alone', () => {
    const visit = new Visit({ options: { keepSeconds: 5 } }).stay([25, 5], 1).walk([25, 5], [35, 5]);
    assert.deepEqual(visit.stay([35, 5], 1).liveIds, ['s0', 's1', 's2.far']);
    assert.deepEqual(visit.stay([35, 5], 10).liveIds, ['s0', 's1']);
});
