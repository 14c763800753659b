import assert from 'node:assert/strict';
import test from 'node:test';
import { Panoramas } from '../../../../client_scripts/core/Panoramas.js';

/** Two squares with a picture around them, a street without. */
function quarter() {
    const shown = new Map(), live = new Set();
    const sectors = new Map([['a', { id: 'a', hasPanorama: true }], ['b', { id: 'b', hasPanorama: true }], ['s', { id: 's' }]]);
    const panoramas = new Panoramas((stem, opacity) => shown.set(stem, opacity));
    return { shown, live, step: (now, current) => panoramas.step(now, current, sectors, stem => live.has(stem)) };
}

test('it fades in around who comes into a square, once its file is there, and out behind him', () => {
    const { shown, live, step } = quarter();
    assert.equal(step(0, 'a'), false);
    assert.equal(shown.size, 0, 'its file is not there');
    live.add('a').add('s');
    assert.equal(step(1, 'a'), false, 'the first frame after a long pause shows it whole');
    assert.equal(shown.get('a'), 1);
    assert.equal(step(2, 'a'), false);
    assert.equal(step(2.3, 's'), true);
    assert.ok(Math.abs(shown.get('a') - 0.5) < 1e-9);
    assert.equal(step(2.7, 's'), false);
    assert.equal(shown.get('a'), 0);
    assert.deepEqual([...shown.keys()], ['a'], 'a street has none');
});

test('one goes while the next comes', () => {
    const { shown, live, step } = quarter();
    live.add('a').add('b');
    step(0, 'a');
    step(1, 'a');
    assert.equal(step(1.15, 'b'), true);
    assert.ok(Math.abs(shown.get('a') - 0.75) < 1e-9 && Math.abs(shown.get('b') - 0.25) < 1e-9, `${shown.get('a')}, ${shown.get('b')}`);
    step(1.3, 'a');   // who turns back
    assert.ok(Math.abs(shown.get('a') - 1) < 1e-9 && Math.abs(shown.get('b')) < 1e-9);
});

test('a file that went and came again shows it anew', () => {
    const { shown, live, step } = quarter();
    live.add('a');
    step(0, 'a');
    step(1, 'a');
    live.delete('a');
    step(2, 'a');
    shown.clear();
    live.add('a');
    step(2.3, 'a');
    assert.ok(shown.get('a') > 0);
});
