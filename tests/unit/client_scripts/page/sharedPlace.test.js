import assert from 'node:assert/strict';
import test from 'node:test';
import { placeFromUrl, rootUrl, urlOfPlace } from '../../../../client_scripts/page/sharedPlace.js';

test('a shared address gives back its place to a centimetre and a degree', () => {
    const url = urlOfPlace('http://city.example/?start=old', 'r12', { east: 12.344, north: -5.5, heading: -Math.PI / 2 });
    assert.equal(url, 'http://city.example/?start=r12#12.34,-5.50,270');
    const { start, pose } = placeFromUrl(url);
    assert.equal(start, 'r12');
    assert.deepEqual([pose.east, pose.north, pose.heading], [12.34, -5.5, 1.5 * Math.PI]);
});

test('an address without a place, or with something else behind #, has no pose', () => {
    assert.deepEqual(placeFromUrl('http://city.example/'), { start: '', pose: null });
    for (const rest of ['#', '#top', '#1,2', '#1,2,x', '#1,2,3,4']) assert.equal(placeFromUrl(`http://city.example/${rest}`).pose, null, rest);
});

test('the root world is asked for by sector, whatever its name holds', () => {
    assert.equal(rootUrl(''), '/city.x3d');
    assert.equal(rootUrl('a&b'), '/city.x3d?start=a%26b');
});
