import assert from 'node:assert/strict';
import test from 'node:test';
import { sectorFromLinks, sectorFromRecord } from '../../../../client_scripts/core/sectorRecord.js';
import { sectorsWithin } from '../../../../client_scripts/core/sectorSets.js';
import { seededRandom } from '../../../support/random.js';

const place = id => ({ id, origin: [0, 0], box: [0, 0, 1, 1] });
const kLine = [[0, 0], [1, 0]], kGround = [[[0, 0], [1, 0], [1, 1]]];

/** Records of a random city: gates both ways, lists that hold the gate neighbours, some seen over roofs alone. */
function randomRecords(seed, count = 40) {
    const random = seededRandom(seed), pick = () => Math.floor(random() * count), gates = Array.from({ length: count }, () => new Set());
    for (let i = 1; i < count; ++i) {
        const other = Math.floor(random() * i);
        gates[i].add(other);
        gates[other].add(i);
    }
    return gates.map((behind, i) => {
        const overRoofs = new Set([pick(), pick()].filter(id => id !== i && !behind.has(id)));
        const visible = new Set([i, ...behind, pick(), ...overRoofs]), names = set => [...set].map(id => `s${id}`);
        return { ...place(`s${i}`), ground: kGround, gates: names(behind).map(to => ({ to, line: kLine })), visible: names(visible),
            over_roofs: names(overRoofs), neighbours: names(visible).filter(id => id !== `s${i}`).map(place) };
    });
}

/** L_i as paper 004 §5.1 writes it: the union of VIS over L_{i-1}; those seen over roofs alone lead no further. */
function unionOfLists(records, start, i) {
    const byId = new Map(records.map(record => [record.id, record])), levels = new Map([[start, 'near']]);
    for (const { to } of i > 0 ? byId.get(start).gates : []) levels.set(to, 'near');
    let whole = new Set([start]);
    for (let ring = 1; ring <= i; ++ring) {
        const next = new Set(whole);
        for (const id of whole) {
            const { visible, over_roofs: overRoofs } = byId.get(id);
            for (const other of visible) {
                if (overRoofs.includes(other)) levels.has(other) || levels.set(other, 'tall');
                else next.add(other);
            }
        }
        for (const id of next) if (levels.get(id) !== 'near') levels.set(id, 'far');
        whole = next;
    }
    return levels;
}

test('L_0 to L_3 are the unions of the lists, whether records came with near files or with far ones', () => {
    for (let seed = 1; seed <= 60; ++seed) {
        const records = randomRecords(seed), whole = new Map(records.map(record => [record.id, sectorFromRecord(record)]));
        const linked = new Map(records.map(record => [record.id, record.id === 's0' ? sectorFromRecord(record) : sectorFromLinks(record)]));
        for (const sectors of [whole, linked]) for (const i of [0, 1, 2, 3]) {
            const found = new Map([...sectorsWithin(sectors, sectors.get('s0'), i)].map(([id, { level }]) => [id, level]));
            assert.deepEqual(new Map([...found].sort()), new Map([...unionOfLists(records, 's0', i)].sort()), `seed ${seed}, i = ${i}`);
        }
    }
});

test('rings are counted from the inside; a set grows as records arrive', () => {
    const records = [0, 1, 2, 3].map(i => ({ ...place(`s${i}`), ground: kGround, gates: [i - 1, i + 1].filter(j => j >= 0 && j < 4).map(j => ({ to: `s${j}`, line: kLine })),
        neighbours: [i - 1, i + 1].filter(j => j >= 0 && j < 4).map(j => place(`s${j}`)) }));
    const sectors = new Map([['s0', sectorFromRecord(records[0])], ['s1', sectorFromLinks(place('s1'))]]);
    assert.deepEqual([...sectorsWithin(sectors, sectors.get('s0'), 3).keys()], ['s0', 's1']);
    for (const record of records) sectors.set(record.id, sectorFromRecord(record));
    const rings = [...sectorsWithin(sectors, sectors.get('s0'), 3)].map(([id, { ring, level }]) => `${id} ${ring} ${level}`);
    assert.deepEqual(rings, ['s0 0 near', 's1 1 near', 's2 2 far', 's3 3 far'], 'without lists gates lead on');
});
