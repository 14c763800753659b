const kSlow = 0.045, kFast = 0.02;     // s per frame
const kScales = [1, 0.75, 0.5, 0.35];
const kFramesToJudge = 20;
const kRestSeconds = 0.6;

/**
 * Fewer pixels when frames come slowly while the visitor moves, more again when they come fast.
 * A frame in which a sector arrived is not judged: it says nothing about drawing. Who stands still sees every pixel.
 */
export class FrameRate {
    /** `apply(scale)` is called when the scale changes; `isSoftware` starts at half. */
    constructor(apply, isSoftware) {
        this.apply = apply;
        this.index = isSoftware ? 2 : 0;
        this.times = [];
        this.rested = 0;   // s without a move
        if (isSoftware) apply(this.scale);
    }

    get isResting() {
        return this.rested >= kRestSeconds;
    }

    /** `seconds` the last frame took, while standing still. */
    rest(seconds) {
        const wasResting = this.isResting;
        this.rested += seconds;
        if (this.isResting && !wasResting && this.scale < 1) this.apply(1);
    }

    get scale() {
        return kScales[this.index];
    }

    /** `seconds` the last frame took, while moving. */
    add(seconds) {
        const wasResting = this.isResting;
        this.rested = 0;
        if (wasResting) {
            if (this.scale < 1) this.apply(this.scale);
            return;   // the frame drawn with all pixels
        }
        this.times.push(seconds);
        if (this.times.length < kFramesToJudge) return;
        const median = this.times.sort((a, b) => a - b)[kFramesToJudge >> 1];
        this.times = [];
        const next = median > kSlow ? this.index + 1 : median < kFast ? this.index - 1 : this.index;
        if (next === this.index || next < 0 || next >= kScales.length) return;
        this.index = next;
        this.apply(this.scale);
    }
}
