import assert from 'node:assert/strict';
import test from 'node:test';

/** As much of a window as Controls listens to. */
const listeners = {};
Object.assign(globalThis, { innerWidth: 1000, addEventListener: (type, listener) => { listeners[type] = listener; } });
const { Controls } = await import('../../../../client_scripts/page/Controls.js');

function makeControls(commands = {}) {
    const surface = { handlers: {}, addEventListener(type, handler) { this.handlers[type] = handler; }, focus() {}, classList: { toggle() {}, remove() {} } };
    const stick = { style: {}, hidden: true, firstElementChild: { style: {} } };
    const controls = new Controls(surface, stick, commands);
    const key = (type, code, more = {}) => listeners[type]({ code, target: {}, shiftKey: false, preventDefault() {}, ...more });
    const point = (type, x, y, pointerType = 'touch', pointerId = 1) =>
        surface.handlers[type]({ clientX: x, clientY: y, pointerType, pointerId, button: 0 });
    return { controls, stick, key, point };
}

const axes = ({ forward, right, turn, run }) => ({ forward, right, turn, run });

test('keys that are held add up, opposite ones cancel, none counts twice', () => {
    const { controls, key } = makeControls();
    key('keydown', 'KeyW');
    key('keydown', 'ArrowUp');
    key('keydown', 'KeyD', { shiftKey: true });
    key('keydown', 'KeyQ', { shiftKey: true });
    assert.deepEqual(axes(controls.wish()), { forward: 1, right: 1, turn: -1, run: true });
    key('keydown', 'KeyE');
    key('keyup', 'KeyW');
    key('keyup', 'ArrowUp');
    assert.deepEqual(axes(controls.wish()), { forward: 0, right: 1, turn: 0, run: false });
});

test('leaving the window lets go of every key', () => {
    const { controls, key } = makeControls();
    key('keydown', 'KeyW', { shiftKey: true });
    listeners.blur();
    assert.deepEqual(axes(controls.wish()), { forward: 0, right: 0, turn: 0, run: false });
});

test('the browser\'s own shortcuts and keys typed on a button are left alone; a command runs once', () => {
    let helps = 0;
    const { controls, key } = makeControls({ KeyH: () => ++helps });
    key('keydown', 'KeyW', { ctrlKey: true });
    key('keydown', 'KeyW', { target: { closest: () => ({}) } });
    assert.equal(controls.wish().forward, 0);
    key('keydown', 'KeyH');
    key('keydown', 'KeyH', { repeat: true });
    assert.equal(helps, 1);
});

test('a mouse drag looks round: what was dragged is handed over once', () => {
    const { controls, point } = makeControls();
    point('pointerdown', 100, 100, 'mouse');
    point('pointermove', 80, 110, 'mouse');
    const { look, forward } = controls.wish();
    assert.ok(Math.abs(look[0] - 0.1) < 1e-9 && Math.abs(look[1] - 0.05) < 1e-9 && forward === 0, String(look));
    assert.deepEqual(controls.wish().look, [0, 0]);
    point('pointerup', 80, 110, 'mouse');
    point('pointermove', 0, 0, 'mouse');
    assert.deepEqual(controls.wish().look, [0, 0]);
});

test('two thumbs: the left half walks as far as it is pushed, the right half looks', () => {
    const { controls, stick, point } = makeControls();
    point('pointerdown', 100, 500, 'touch', 1);
    point('pointermove', 100, 472, 'touch', 1);
    point('pointerdown', 800, 500, 'touch', 2);
    point('pointermove', 780, 500, 'touch', 2);
    assert.equal(stick.hidden, false);
    const wish = controls.wish();
    assert.deepEqual([wish.forward, wish.right, wish.look[0]], [0.5, 0, 0.1]);
    point('pointermove', 100, 100, 'touch', 1);
    assert.equal(controls.wish().forward, 1);
    point('pointerup', 100, 100, 'touch', 1);
    assert.equal(stick.hidden, true);
    assert.equal(controls.wish().forward, 0);
});
