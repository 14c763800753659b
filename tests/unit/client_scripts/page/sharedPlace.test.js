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
    assert.deepEqual(placeFromUrl('http://city.example/'), { start: '', pose: null, level: null, isMeasured: false, test: '' });
    for (const rest of ['#', '#top', '#1,2', '#1,2,x', '#1,2,3,x', '#1,2,3,4,5,6']) assert.equal(placeFromUrl(`http://city.example/${rest}`).pose, null, rest);
});

test('a shared address of who flies keeps his height', () => {
    const pose = { east: 1, north: 2, heading: 1, pitch: -0.5, up: 123.4 };
    const back = placeFromUrl(urlOfPlace('http://city.example/', 'r12', pose, { isFlying: true })).pose;
    for (const key of Object.keys(pose)) assert.ok(Math.abs(back[key] - pose[key]) < 0.01, key);
    const level = placeFromUrl(urlOfPlace('http://city.example/', 'r12', { ...pose, pitch: 0 }, { isFlying: true })).pose;
    assert.deepEqual([level.pitch, level.up], [0, 123.4]);
    assert.equal(placeFromUrl(urlOfPlace('http://city.example/', 'r12', pose)).pose.up, undefined);
});

test('a shared address keeps how the visitor looks up, and i, chosen or measured', () => {
    const pose = { east: 1, north: 2, heading: 0, pitch: 0.35 };
    for (const isMeasured of [true, false]) {
        const url = urlOfPlace('http://city.example/', 'r12', pose, { level: 2, isMeasured }), back = placeFromUrl(url);
        assert.equal(new URL(url).searchParams.get('i'), isMeasured ? 'auto-2' : '2');
        assert.deepEqual([back.level, back.isMeasured], [2, isMeasured]);
        assert.ok(Math.abs(back.pose.pitch - 0.35) < 0.01);
    }
    for (const i of ['4', '-1', 'auto', 'x']) assert.equal(placeFromUrl(`http://city.example/?i=${i}`).level, null);
});

test('the root world is asked for by sector, whatever its name holds', () => {
    assert.equal(rootUrl(''), '/city.x3d');
    assert.equal(rootUrl('a&b'), '/city.x3d?start=a%26b');
});
