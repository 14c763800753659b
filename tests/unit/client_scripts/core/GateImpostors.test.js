import assert from 'node:assert/strict';
import test from 'node:test';
import { GateImpostors, fadeImpostor } from '../../../../client_scripts/core/GateImpostors.js';

/** Sector a with gates to b, c, out of the city and one without a picture; what is live is in `live`. */
function street() {
    const shown = new Map(), live = new Set(), calls = [];
    const gate = (id, to, hasImpostor = true) => ({ id, to, hasImpostor });
    const sectors = new Map([['a', { id: 'a', gates: [gate('ab', 'b'), gate('ac', 'c'), gate('a-out', null), gate('ad', 'd', false)] }],
        ['b', { id: 'b', gates: [gate('ba', 'a'), gate('be', 'e')] }], ['c', { id: 'c', gates: null }]]);
    const impostors = new GateImpostors((stem, id, opacity) => {
        calls.push(`${stem} ${id}`);
        shown.set(id, opacity);
    });
    return { shown, live, calls, step: now => impostors.step(now, sectors, stem => live.has(stem)) };
}

test('a picture stands in a gate while what is behind is not there, and in no other', () => {
    const { shown, live, calls, step } = street();
    assert.equal(step(0), false);
    assert.deepEqual(calls, [], 'nothing is there');
    live.add('a');
    step(1);
    assert.deepEqual([...shown], [['ab', 1], ['ac', 1]]);
    step(2);
    assert.equal(calls.length, 2, 'nothing is said twice');
});

test('it fades once the sector behind is there, near or far, and comes back when that goes', () => {
    const { shown, live, step } = street();
    live.add('a');
    step(0);
    live.add('b').add('c.far');
    let now = 0, before = 1;
    for (; step(now += 0.1); before = shown.get('ab')) {
        assert.ok(shown.get('ab') < before);
        assert.equal(shown.get('ac'), shown.get('ab'));
        assert.ok(now < 1, 'it takes half a second');
    }
    assert.equal(shown.get('ab'), 0);
    assert.equal(shown.get('ba'), undefined, 'what was there before the gate\'s own sector needs no picture');
    assert.equal(shown.get('be'), 1, 'the picture in the next gate');
    live.delete('b');
    step(now += 0.1);
    assert.equal(shown.get('ab'), 1);
});

test('a sector that comes again with its neighbour there shows none', () => {
    const { shown, live, step } = street();
    live.add('a').add('b').add('c');
    step(0);
    assert.equal(shown.size, 1);
    assert.equal(shown.get('be'), 1);
});

test('its image is fetched when it is shown first', () => {
    const texture = { load: false }, material = { transparency: 0 }, group = { visible: false, children: [{ appearance: { texture, material } }] };
    fadeImpostor(group, 0);
    assert.deepEqual([group.visible, texture.load], [false, false]);
    fadeImpostor(group, 1);
    assert.deepEqual([group.visible, texture.load, material.transparency], [true, true, 0]);
    fadeImpostor(group, 0.25);
    assert.deepEqual([group.visible, material.transparency], [true, 0.75]);
});
