import assert from 'node:assert/strict';
import test from 'node:test';
import { Viewpoints } from '../../../../client_scripts/page/Viewpoints.js';
import { StepButtons } from '../../../../client_scripts/page/StepButtons.js';
import { storedSettings } from '../../../../client_scripts/page/Settings.js';

const view = (name, east) => ({ name, east, north: 0, heading: 0 });

test('next goes to the nearest that was not visited, previous the way back, next again forward', () => {
    const views = new Viewpoints();
    views.add('a', [view('a', 0)]);
    views.add('b', [view('b', 10), view('b2', 12)]);
    views.add('c', [view('c', -30)]);
    views.add('a', [view('a', 0)]);
    assert.equal(views.all.length, 4);
    let at = view('here', 0);
    const go = found => { at = found; return found?.name; };
    assert.equal(go(views.next(at)), 'b');
    assert.equal(go(views.next(at)), 'b2');
    assert.equal(go(views.previous()), 'b');
    assert.equal(go(views.next(at)), 'b2');
    assert.equal(go(views.next(at)), 'a');
    assert.equal(go(views.next(at)), 'c');
    assert.equal(go(views.next(at)), 'a', 'all were visited: it begins again');
    assert.equal(new Viewpoints().next(at), null);
    assert.equal(new Viewpoints().previous(), null);
});

test('a button goes on while it is held, and makes one step when it is tapped', () => {
    const handlers = {}, button = { dataset: { wish: 'forward 1' }, addEventListener: (type, handler) => { handlers[type] = handler; } };
    const pad = new StepButtons({ querySelectorAll: selector => (selector === '[data-wish]' ? [button] : []) }, {});
    const wish = seconds => pad.addTo({ forward: 0, right: 0, turn: 0, look: [0, 0] }, seconds).forward;
    const frames = seconds => { for (let count = 0; ; ++count) if (!wish(seconds)) return count; };
    const press = during => {
        handlers.pointerdown({ pointerId: 1 });
        during();
        handlers.pointerup();
        handlers.click();
    };
    press(() => { for (let i = 0; i < 100; ++i) assert.equal(wish(0.1), 1); });
    assert.equal(wish(0.1), 0, 'a long press is no step besides');
    press(() => {});
    assert.equal(frames(0.1), 4, 'a press between two frames is a step');
    press(() => assert.equal(wish(0.1), 1));
    assert.equal(frames(0.1), 3);
    handlers.click();
    assert.equal(frames(2), 2, 'by a key, on a slow machine');
});

test('settings: the address before what is kept, nonsense counts as nothing, who saves data has a slow line', () => {
    const kept = text => ({ getItem: () => text });
    const none = { level: null, isMeasured: false, test: '' };
    assert.deepEqual(storedSettings(none, kept(null), {}), { level: null, line: 'auto', test: 'polygon', startLevel: 1, detail: 'medium', form: 'auto' });
    assert.equal(storedSettings(none, kept(null), { saveData: true }).line, 'slow');
    assert.deepEqual(storedSettings(none, kept('{"level":3,"line":"fast","test":"gate","detail":"fine","form":"blockMap"}'), {}), { level: 3, line: 'fast', test: 'gate', startLevel: 1, detail: 'fine', form: 'blockMap' });
    for (const text of ['{"level":9,"line":"x","test":"y"}', 'no JSON', '7'])
        assert.deepEqual(storedSettings(none, kept(text), {}), { level: null, line: 'auto', test: 'polygon', startLevel: 1, detail: 'medium', form: 'auto' });
    assert.equal(storedSettings({ ...none, level: 0 }, kept('{"level":3}'), {}).level, 0);
    assert.deepEqual(storedSettings({ ...none, level: 2, isMeasured: true, test: 'box' }, kept('{"level":3}'), {}),
        { level: null, line: 'auto', test: 'box', startLevel: 2, detail: 'medium', form: 'auto' });
    assert.equal(storedSettings(none, { getItem: () => { throw new Error('forbidden'); } }, {}).line, 'auto');
});
