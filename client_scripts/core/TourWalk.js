const kStep = 0.5;        // m between two headings
const kSpan = 2;          // m before and after over which the way's direction is averaged

/**
 * A tour of /tours as a walk: where one is and looks so far along it.
 *
 * Frame   plan metres; headings in radians clockwise from north.
 * Bound   a corner is spread over 2 kSpan metres: a heading changes by no more than the way turns within them.
 */
export class TourWalk {
    /** `points`: [east, north, ground, walked] each, as /tours gives them. */
    constructor({ points }) {
        this.points = points;
        this.length = points.at(-1)[3];
        const count = Math.max(1, Math.ceil(this.length / kStep)), sums = [0];
        for (let i = 0, angle = null; i < count; ++i) {
            const [a, b] = this.leg((i + 0.5) * kStep), raw = Math.atan2(b[0] - a[0], b[1] - a[1]);
            angle = angle === null ? raw : angle + turnBetween(angle, raw);
            sums.push(sums.at(-1) + angle);
        }
        const span = kSpan / kStep, mean = (from, to) => (sums[to] - sums[from]) / (to - from);
        this.headings = Array.from({ length: count + 1 }, (_, i) => mean(Math.max(0, i - span), Math.min(count, i + span)));
    }

    /** { east, north, ground, heading } at `walked` metres from the beginning. */
    at(walked) {
        const along = Math.min(this.length, Math.max(0, walked)), [a, b] = this.leg(along);
        const share = b[3] > a[3] ? Math.min(1, (along - a[3]) / (b[3] - a[3])) : 0;
        const [east, north, ground] = [0, 1, 2].map(axis => a[axis] + share * (b[axis] - a[axis]));
        const place = Math.min(this.headings.length - 1, along / kStep), before = Math.floor(place);
        const next = Math.min(this.headings.length - 1, before + 1);
        const heading = this.headings[before] + (place - before) * (this.headings[next] - this.headings[before]);
        return { east, north, ground, heading };
    }

    /** The two points that `walked` lies between. */
    leg(walked) {
        let low = 0, high = this.points.length - 1;
        while (high - low > 1) {
            const middle = (low + high) >> 1;
            if (this.points[middle][3] <= walked) low = middle;
            else high = middle;
        }
        return [this.points[low], this.points[Math.min(low + 1, this.points.length - 1)]];
    }
}

function turnBetween(from, to) {
    return Math.atan2(Math.sin(to - from), Math.cos(to - from));
}
