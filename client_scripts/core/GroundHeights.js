/** mm: side of the cells in which triangles are found again. */
const kCellMm = 4000;

/**
 * How high the ground is, from the triangles that are drawn.
 *
 * Frame   plan lattice, mm. `patches`: { points: [[east, north, up], ...], triangles: [i, j, k, ...] }; upright
 *         triangles (kerbs) are passed over.
 */
export class GroundHeights {
    constructor(patches) {
        this.cells = new Map();
        for (const { points, triangles } of patches)
            for (let i = 0; i + 2 < triangles.length; i += 3)
                this.add(triangles.slice(i, i + 3).map(index => points[index]));
    }

    add(corners) {
        if (twiceArea(...corners) <= 0) return;
        const [east, north] = [0, 1].map(axis => corners.map(corner => Math.floor(corner[axis] / kCellMm)));
        for (let x = Math.min(...east); x <= Math.max(...east); ++x)
            for (let y = Math.min(...north); y <= Math.max(...north); ++y) {
                const key = `${x},${y}`;
                if (!this.cells.has(key)) this.cells.set(key, []);
                this.cells.get(key).push(corners);
            }
    }

    /** The highest ground at [east, north], or null where there is none. */
    at(point) {
        let best = null;
        for (const corners of this.cells.get(point.map(value => Math.floor(value / kCellMm)).join()) ?? []) {
            const [a, b, c] = corners, all = twiceArea(a, b, c);
            const shares = [twiceArea(point, b, c), twiceArea(a, point, c), twiceArea(a, b, point)];
            if (shares.some(share => share < 0)) continue;
            const up = shares.reduce((sum, share, k) => sum + share / all * corners[k][2], 0);
            if (best === null || up > best) best = up;
        }
        return best;
    }
}

function twiceArea(a, b, c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
