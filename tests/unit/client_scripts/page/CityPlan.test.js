import assert from 'node:assert/strict';
import test from 'node:test';
import { CityPlan } from '../../../../client_scripts/page/CityPlan.js';

const kRecords = { near: [10, 10, 50, 40], far: [900, 900, 950, 960] };
const recordOf = (id, [w, s, e, n]) => ({ id, kind: 'street', name: id, ground: [[[w, s], [e, s], [e, n], [w, n]]] });
const answer = value => ({ ok: value !== undefined, status: value === undefined ? 404 : 200, json: async () => value });

test('where no server answers, plan.json says whose records to fetch: those near alone, each once', async () => {
    const asked = [], files = { '/plan.json': { sectors: Object.entries(kRecords).map(([id, box]) => [id, ...box]) },
        ...Object.fromEntries(Object.entries(kRecords).map(([id, box]) => [`/sectors/${id}.json`, recordOf(id, box)])) };
    for (const degrees of [null, [48.9, 2.3]]) {
        asked.length = 0;
        const plan = new CityPlan(degrees, { request: async url => (asked.push(url), answer(files[url])) });
        await plan.whole(30, 30, 80);
        await plan.whole(30, 30, 80);
        assert.equal(plan.sectorAt(30, 20)?.id, 'near');
        assert.equal(plan.sectorAt(920, 930), null);
        assert.equal(asked.filter(url => url === '/plan.json').length, 1);
        assert.deepEqual(asked.filter(url => url.startsWith('/sectors/')), ['/sectors/near.json']);
        await plan.whole(920, 930, 10);
        assert.equal(plan.sectorAt(920, 930)?.id, 'far');
    }
});
