/** The paper stops at 2; a static world may have 3. */
export const kMostLevel = 3;
const kFrames = 30;                 // moving frames to judge by
const kSlowFrame = 0.066, kFastFrame = 0.04;   // s
/** A smaller set must take this share of the time per frame, else it was not the sectors that made frames slow. */
const kHelps = 0.85;
const kFutileSeconds = 120;         // until a smaller set is tried again after it did not help
const kRestSeconds = 20;            // until a larger set is tried after a smaller one was needed
const kEffectSeconds = 5;           // until the next step down
const kGoneSeconds = 10;            // what is no longer wanted stays so long (SectorPlanner): only then frames tell of the smaller set
/** A smaller set for the frames' sake is never less than what is seen from here: houses count more than frames. */
const kLeastForFrames = 1;
const kCalmSeconds = 1;             // all there for so long before a larger set is tried
const kLongWait = 8;                // s a file may be on its way
const kMemoryFull = 0.85, kMemoryRoom = 0.6, kShapeRoom = 0.7;   // shares of what there is

/**
 * Chooses i of L_i (paper 004 §5.1) by what is measured: time per frame while the visitor moves, how long files are on
 * their way, live Shapes and memory. `fixed`: no choice, that i.
 *
 * Holds   0 <= i <= limit. One step at a time. A smaller set that does not make frames faster is given up again.
 */
export class LevelChoice {
    constructor({ start = 1, limit = 2, fixed = null } = {}) {
        Object.assign(this, { limit, fixed, chosen: Math.min(start, limit), frames: [], trial: null, median: null });
        Object.assign(this, { restUntil: 0, futileUntil: 0, tooMuch: null, calmSince: null, reason: 'start' });
    }

    get i() {
        return this.fixed ?? this.chosen;
    }

    /** null: by measure, from 0 to `limit`. */
    set(fixed, limit = this.limit) {
        Object.assign(this, { fixed, limit, chosen: Math.min(fixed ?? this.i, limit), frames: [], trial: null, calmSince: null });
    }

    /** A frame of `seconds` in which the visitor moved and nothing arrived. */
    addFrame(seconds) {
        this.frames.push(seconds);
    }

    /**
     * Once a frame. `isSettled`: all that is wanted is there. `waitSeconds`: the longest that a file is on its way.
     * `nextShapes`: live Shapes with one ring more. `memoryShare`: of what the browser allows, 0 where it tells nothing.
     */
    judge({ now, isSettled, waitSeconds, shapes, nextShapes, shapeCap, memoryShare }) {
        if (this.fixed !== null) return;
        if (shapes > shapeCap) return void this.lower(now, 'Shapes');
        if (memoryShare > kMemoryFull) return void this.lower(now, 'memory');
        if (waitSeconds > kLongWait && this.chosen > 1) {
            this.tooMuch = { i: this.chosen, until: now + kFutileSeconds };
            return void this.lower(now, 'line');
        }
        if (this.trial && now < this.trial.from) this.frames = [];
        if (this.frames.length >= kFrames && !this.judgeFrames(now)) return;
        this.calmSince = isSettled && waitSeconds < kLongWait ? this.calmSince ?? now : null;
        const hasRoom = nextShapes < kShapeRoom * shapeCap && memoryShare < kMemoryRoom;
        const isCalm = this.calmSince !== null && now - this.calmSince >= kCalmSeconds && now >= this.restUntil;
        if (!hasRoom || this.isSlow(now)) this.calmSince = null;
        else if (isCalm && !this.trial) this.change(Math.min(this.chosen + 1, this.most(now)), 'room');
    }

    /** When a larger set is due if nothing else happens; Infinity: never. */
    get wakeAt() {
        if (this.fixed !== null || this.calmSince === null || this.chosen >= this.limit || this.trial) return Infinity;
        return Math.max(this.calmSince + kCalmSeconds, this.restUntil);
    }

    /** A set that made frames slow is not tried again soon. */
    most(now) {
        return this.tooMuch && now < this.tooMuch.until ? Math.min(this.limit, this.tooMuch.i - 1) : this.limit;
    }

    isSlow(now) {
        return this.median !== null && this.median > kFastFrame && now >= this.futileUntil;
    }

    /** Returns whether it left i as it is. */
    judgeFrames(now) {
        const before = this.chosen;
        this.median = this.frames.sort((a, b) => a - b)[this.frames.length >> 1];
        this.frames = [];
        if (this.trial) {
            const helped = this.median < kHelps * this.trial.median;
            if (helped) this.tooMuch = { i: this.trial.i, until: now + kFutileSeconds };
            else {
                this.futileUntil = now + kFutileSeconds;
                this.change(this.trial.i, 'frames: a smaller set is no faster');
            }
            this.trial = null;
        } else if (this.median > kSlowFrame && this.chosen > kLeastForFrames && now >= this.futileUntil) {
            const trial = { i: this.chosen, median: this.median, from: now + kGoneSeconds };
            if (this.lower(now, 'frames')) this.trial = trial;
        }
        return this.chosen === before;
    }

    /** Returns whether it did: not while the last step has not taken effect, not below 0. */
    lower(now, reason) {
        if (this.chosen === 0 || now < this.restUntil - kRestSeconds + kEffectSeconds) return false;
        this.restUntil = now + kRestSeconds;
        this.change(this.chosen - 1, reason);
        return true;
    }

    change(i, reason) {
        if (i === this.chosen) return;
        Object.assign(this, { chosen: i, reason, frames: [], calmSince: null, trial: null });
    }
}
