const kArrivedMetres = 0.4;
const kTurnFor = 0.5;              // rad off at full turning speed
const kWalkWithin = 0.6;           // rad off up to which he walks while he turns
const kFarthestMetres = 60;
/** A visitor who comes no nearer for so long has a wall before him. */
const kPatienceSeconds = 1.5, kNearerMetres = 0.1;

/** Walks the visitor to a place that was clicked: paper 004 §3, click-and-go. What he steers himself ends it. */
export class GoTo {
    constructor() {
        this.goal = null;
    }

    start(goal) {
        Object.assign(this, { goal, nearest: Infinity, waited: 0 });
    }

    /** The wish (Controls) that leads there; null: there is no goal, or it is reached, or cannot be. */
    wish({ east, north, heading }, seconds) {
        if (!this.goal) return null;
        const [x, y] = [this.goal[0] - east, this.goal[1] - north], left = Math.hypot(x, y);
        if (left < this.nearest - kNearerMetres) Object.assign(this, { nearest: left, waited: 0 });
        else this.waited += seconds;
        const error = Math.atan2(x, y) - heading, off = Math.atan2(Math.sin(error), Math.cos(error));
        const isTurning = Math.abs(off) > kWalkWithin;
        if (isTurning) this.waited = 0;
        if (left < kArrivedMetres || this.waited > kPatienceSeconds) {
            this.goal = null;
            return null;
        }
        const turn = Math.min(1, Math.max(-1, off / kTurnFor));
        return { forward: isTurning ? 0 : 1, right: 0, turn, look: [0, 0], run: left > 12 };
    }
}

/**
 * The place on the level ground under a pixel, at most kFarthestMetres off: [east, north]; null: it shows the sky.
 * `x`, `y`: -1 .. 1 from the view's middle, right and up; `aspect`: width over height; `fieldOfView`: rad, of the smaller side.
 */
export function groundUnder({ east, north, up, heading, pitch }, [x, y], aspect, fieldOfView) {
    const half = Math.tan(fieldOfView / 2), across = x * half * Math.max(1, aspect), above = y * half * Math.max(1, 1 / aspect);
    const rise = Math.sin(pitch) + above * Math.cos(pitch), ahead = Math.cos(pitch) - above * Math.sin(pitch);
    if (rise > -0.01) return null;
    const reach = Math.min(up / -rise, kFarthestMetres / Math.hypot(ahead, across));
    const forward = ahead * reach, right = across * reach;
    return [
        east + forward * Math.sin(heading) + right * Math.cos(heading), north + forward * Math.cos(heading) - right * Math.sin(heading)];
}
