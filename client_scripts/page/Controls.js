const kWalkKeys = {
    KeyW: { forward: 1 }, ArrowUp: { forward: 1 }, KeyS: { forward: -1 }, ArrowDown: { forward: -1 },
    Space: { rise: 1 }, KeyC: { rise: -1 },
    KeyA: { right: -1 }, KeyD: { right: 1 },
    KeyQ: { turn: -1 }, ArrowLeft: { turn: -1 }, KeyE: { turn: 1 }, ArrowRight: { turn: 1 },
};
const kLookPerPixel = 0.005;      // rad
const kStickReach = 56;           // CSS pixels from the centre to full speed
/** A press that moves less and is shorter is a click. */
const kTapPixels = 6, kTapMilliseconds = 400;
/** Elements that have a use for keys themselves. */
const kOwnKeys = 'button, input, select, textarea, a, article';

/**
 * Keys, mouse and touch -> what the visitor wants: { forward, right, turn, rise, zoom, look, run }.
 *
 * Mouse: a drag looks round, a click taps, the wheel zooms (100 pixels: 1). Touch: the left half is a stick that walks, the right half looks.
 * Keys count by place, not by letter (KeyboardEvent.code): WASD lies alike on every keyboard.
 */
export class Controls {
    /** `stick`: the element that shows the touch stick. `commands`: code -> function. `tap([x, y], event)`: a click, in its pixels. */
    constructor(surface, stick, commands, tap = () => {}) {
        Object.assign(this, { surface, stick, commands, tap, held: new Set(), drags: new Map(), look: [0, 0], zoom: 0, shift: false });
        addEventListener('keydown', event => this.keyDown(event));
        addEventListener('keyup', event => this.keyUp(event));
        addEventListener('blur', () => this.release());
        surface.addEventListener('mousedown', event => event.preventDefault(), { capture: true });   // the focus stays here
        surface.addEventListener('wheel', event => { this.zoom -= event.deltaY / 100; }, { capture: true, passive: true });
        surface.addEventListener('pointerdown', event => this.pointerDown(event));
        surface.addEventListener('pointermove', event => this.pointerMove(event));
        for (const type of ['pointerup', 'pointercancel']) surface.addEventListener(type, event => this.pointerUp(event));
    }

    /** What is wanted now; looking is handed over once. */
    wish() {
        const wish = { forward: 0, right: 0, turn: 0, rise: 0, zoom: this.zoom, look: this.look, run: this.shift };
        Object.assign(this, { look: [0, 0], zoom: 0 });
        for (const code of this.held)
            for (const [axis, value] of Object.entries(kWalkKeys[code])) wish[axis] += value;
        for (const drag of this.drags.values()) {
            if (drag.role !== 'walk') continue;
            wish.forward -= clamp((drag.y - drag.y0) / kStickReach);
            wish.right += clamp((drag.x - drag.x0) / kStickReach);
        }
        for (const axis of ['forward', 'right', 'turn', 'rise']) wish[axis] = clamp(wish[axis]);
        return wish;
    }

    keyDown(event) {
        this.shift = event.shiftKey;
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        if (event.target.closest?.(kOwnKeys) && event.code !== 'Escape' && isForElement(event)) return;
        if (event.code in kWalkKeys) {
            this.held.add(event.code);
            event.preventDefault();
        } else if (!event.repeat && this.commands[event.code]) {
            event.preventDefault();   // a letter that opens a dialog is none for its field
            this.commands[event.code]();
        }
    }

    keyUp(event) {
        this.shift = event.shiftKey;
        this.held.delete(event.code);
    }

    release() {
        this.held.clear();
        this.drags.clear();
        this.shift = false;
        this.showStick(null);
    }

    pointerDown(event) {
        if (event.pointerType === 'mouse' && event.button !== 0) return;
        const walks = event.pointerType === 'touch' && event.clientX < innerWidth / 2;
        const [x, y] = [event.clientX, event.clientY];
        const drag = { role: walks ? 'walk' : 'look', x0: x, y0: y, x, y, at: event.timeStamp, moved: 0 };
        this.drags.set(event.pointerId, drag);
        this.surface.setPointerCapture?.(event.pointerId);
        this.surface.focus();
        this.surface.classList.toggle('dragging', !walks);
        if (walks) this.showStick(drag);
    }

    pointerMove(event) {
        const drag = this.drags.get(event.pointerId);
        if (!drag) return;
        if (drag.role === 'look') {
            this.look[0] -= (event.clientX - drag.x) * kLookPerPixel;
            this.look[1] += (event.clientY - drag.y) * kLookPerPixel;
        }
        [drag.x, drag.y] = [event.clientX, event.clientY];
        drag.moved = Math.max(drag.moved, Math.hypot(drag.x - drag.x0, drag.y - drag.y0));
        if (drag.role === 'walk') this.showStick(drag);
    }

    pointerUp(event) {
        const drag = this.drags.get(event.pointerId);
        this.drags.delete(event.pointerId);
        this.surface.classList.remove('dragging');
        if (drag?.role === 'walk') this.showStick(null);
        if (event.type !== 'pointerup' || !drag || drag.moved > kTapPixels || event.timeStamp - drag.at > kTapMilliseconds) return;
        const { left = 0, top = 0 } = this.surface.getBoundingClientRect?.() ?? {};
        this.tap([drag.x - left, drag.y - top], event);
    }

    showStick(drag) {
        this.stick.hidden = !drag;
        if (!drag) return;
        this.stick.style.left = `${drag.x0}px`;
        this.stick.style.top = `${drag.y0}px`;
        const [x, y] = [clamp((drag.x - drag.x0) / kStickReach), clamp((drag.y - drag.y0) / kStickReach)];
        this.stick.firstElementChild.style.transform = `translate(${x * 34}px, ${y * 34}px)`;
    }
}

/** Where one chooses, keys belong to the choice; a text that scrolls has the arrows, a button what presses it. */
function isForElement({ target, code }) {
    if (target.closest('select, textarea, input') !== null) return true;
    if (/^(Enter|NumpadEnter|Space|Tab)$/.test(code)) return true;
    return target.matches('article') && /^(Arrow|Page|Home|End)/.test(code);
}

function clamp(value) {
    return Math.min(1, Math.max(-1, value));
}
