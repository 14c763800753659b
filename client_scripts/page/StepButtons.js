/** What a short press or a key on a button does: steps of so long. */
const kTapSeconds = 0.35;
const kLookSpeed = 0.7;     // rad/s
const kLongestStep = 0.2;   // s, as Walker has it

/**
 * Buttons for who cannot or will not drag a mouse (paper 004 §3): held they go on, tapped they make a step. With the
 * keyboard, Enter and Space tap.
 */
export class StepButtons {
    /** `pad`: holds buttons with data-wish="AXIS VALUE"; `commands`: of data-command. */
    constructor(pad, commands) {
        this.active = new Map();   // button -> { axis, value, left, spent: s }
        for (const button of pad.querySelectorAll('[data-wish]')) this.listen(button);
        for (const button of pad.querySelectorAll('[data-command]'))
            button.addEventListener('click', () => commands[button.dataset.command]());
    }

    listen(button) {
        const [axis, value] = button.dataset.wish.split(' ');
        const begin = left => this.active.set(button, { axis, value: Number(value), left, spent: 0 });
        let isPointers = false;   // whose click it is
        button.addEventListener('pointerdown', event => {
            button.setPointerCapture?.(event.pointerId);
            isPointers = true;
            begin(Infinity);
        });
        for (const type of ['pointerup', 'pointercancel']) button.addEventListener(type, () => this.release(button));
        button.addEventListener('click', () => {
            if (!isPointers) begin(kTapSeconds);
            isPointers = false;
        });
    }

    /** A press is a step at least, however short it was, or long the frame. */
    release(button) {
        const press = this.active.get(button);
        if (!press) return;
        press.left = kTapSeconds - press.spent;
        if (press.left <= 0) this.active.delete(button);
    }

    /** Adds to a wish of Controls what is pressed in a frame of `seconds`. */
    addTo(wish, seconds) {
        for (const [button, press] of this.active) {
            if (press.axis === 'look') wish.look = [wish.look[0], wish.look[1] + press.value * kLookSpeed * seconds];
            else wish[press.axis] = Math.min(1, Math.max(-1, wish[press.axis] + press.value));
            press.left -= Math.min(seconds, kLongestStep);
            press.spent += Math.min(seconds, kLongestStep);
            if (press.left <= 0) this.active.delete(button);
        }
        return wish;
    }
}
