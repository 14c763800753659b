/** What a short press or a key on a button does: steps of so long. */
const kTapSeconds = 0.35;
const kLookSpeed = 0.7;     // rad/s

/**
 * Buttons for who cannot or will not drag a mouse (paper 004 §3): held they go on, tapped they make a step. With the
 * keyboard, Enter and Space tap.
 */
export class StepButtons {
    /** `pad`: holds buttons with data-wish="AXIS VALUE"; `commands`: of data-command. */
    constructor(pad, commands) {
        this.active = new Map();   // button -> { axis, value, until: s or null while it is held }
        for (const button of pad.querySelectorAll('[data-wish]')) this.listen(button);
        for (const button of pad.querySelectorAll('[data-command]'))
            button.addEventListener('click', () => commands[button.dataset.command]());
    }

    listen(button) {
        const [axis, value] = button.dataset.wish.split(' ');
        const begin = until => this.active.set(button, { axis, value: Number(value), until });
        button.addEventListener('pointerdown', event => {
            button.setPointerCapture?.(event.pointerId);
            begin(null);
        });
        for (const type of ['pointerup', 'pointercancel']) button.addEventListener(type, () => this.active.delete(button));
        button.addEventListener('click', () => begin(performance.now() / 1000 + kTapSeconds));
    }

    /** Adds to a wish of Controls what is pressed now. */
    addTo(wish, seconds, now = performance.now() / 1000) {
        for (const [button, { axis, value, until }] of this.active) {
            if (until !== null && now > until) this.active.delete(button);
            else if (axis === 'look') wish.look = [wish.look[0], wish.look[1] + value * kLookSpeed * seconds];
            else wish[axis] = Math.min(1, Math.max(-1, wish[axis] + value));
        }
        return wish;
    }
}
