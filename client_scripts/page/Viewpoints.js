/**
 * The viewpoints of the sectors around, in the order a visitor would walk them: `next` is the nearest he has not been at,
 * `previous` the one he came from (paper 004 §4.1.6).
 */
export class Viewpoints {
    constructor() {
        Object.assign(this, { known: new Map(), been: [], at: -1 });
    }

    /** `viewpoints`: [{ name, east, north, heading }] of a sector's file. */
    add(sectorId, viewpoints) {
        viewpoints.forEach((viewpoint, i) => {
            const id = `${sectorId}#${i}`;
            if (!this.known.has(id)) this.known.set(id, { ...viewpoint, id, sectorId });
        });
    }

    get all() {
        return [...this.known.values()];
    }

    /** The nearest first. */
    around({ east, north }) {
        const far = viewpoint => Math.hypot(viewpoint.east - east, viewpoint.north - north);
        return this.all.sort((a, b) => far(a) - far(b));
    }

    /** Null: none is known. When all have been visited it begins again. */
    next(pose) {
        if (this.at + 1 < this.been.length) return this.been[++this.at];
        const fresh = this.around(pose).filter(viewpoint => !this.been.includes(viewpoint) && !isAt(viewpoint, pose));
        const next = fresh[0] ?? this.around(pose).find(viewpoint => !isAt(viewpoint, pose)) ?? null;
        if (next) this.at = this.been.push(next) - 1;
        return next;
    }

    previous() {
        return this.at > 0 ? this.been[--this.at] : null;
    }
}

const isAt = ({ east, north }, pose) => Math.hypot(east - pose.east, north - pose.north) < 1;
