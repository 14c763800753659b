/**
 * Points, segments and rings in plan.
 *
 * Frame   plan lattice: integer millimetres, point = [east, north]. A ring is closed implicitly.
 * Error   isInside is exact for lattice points: differences stay below 2^26 inside one sector's box (67 km), their
 *         products below 2^53. Distances are doubles.
 */
export const millimetres = metres => Math.round(metres * 1000);
export const latticePoint = point => [millimetres(point[0]), millimetres(point[1])];

export function boxContains(box, point) {
    return point[0] >= box[0] && point[0] <= box[2] && point[1] >= box[1] && point[1] <= box[3];
}

/** Distance from a point to a closed box, 0 inside it. */
export function boxDistance(box, point) {
    const east = Math.max(box[0] - point[0], 0, point[0] - box[2]);
    const north = Math.max(box[1] - point[1], 0, point[1] - box[3]);
    return Math.hypot(east, north);
}

/** > 0: c lies left of the line from a to b; 0: on it. orient(a,b,c) == -orient(b,a,c). */
export function orient(a, b, c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/** Closed polygon with holes: the border counts as inside. Needs the point within the polygon's box. */
export function isInside(rings, point) {
    let inside = false;
    for (const ring of rings) {
        for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
            const a = ring[j], b = ring[i];
            const side = orient(a, b, point);
            if (side === 0 && isBetween(a, b, point)) return true;
            if ((a[1] > point[1]) !== (b[1] > point[1]) && (side > 0) === (b[1] > a[1])) inside = !inside;
        }
    }
    return inside;
}

function isBetween(a, b, point) {
    return Math.min(a[0], b[0]) <= point[0] && point[0] <= Math.max(a[0], b[0])
        && Math.min(a[1], b[1]) <= point[1] && point[1] <= Math.max(a[1], b[1]);
}

/** The point of the closed segment ab nearest to `point`. */
export function nearestOnSegment(a, b, point) {
    const east = b[0] - a[0], north = b[1] - a[1];
    const square = east * east + north * north;
    if (square === 0) return [a[0], a[1]];
    const along = ((point[0] - a[0]) * east + (point[1] - a[1]) * north) / square;
    const t = Math.min(1, Math.max(0, along));
    return [a[0] + t * east, a[1] + t * north];
}

export function distance(a, b) {
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/** Distance from a point to an open line of points. */
export function distanceToLine(line, point) {
    let least = Infinity;
    for (let i = 1; i < line.length; ++i)
        least = Math.min(least, distance(nearestOnSegment(line[i - 1], line[i], point), point));
    return least;
}

/** Distance from a point to a polygon's edges, inside or outside. */
export function distanceToEdges(rings, point) {
    let least = Infinity;
    for (const ring of rings)
        for (let i = 0, j = ring.length - 1; i < ring.length; j = i++)
            least = Math.min(least, distance(nearestOnSegment(ring[j], ring[i], point), point));
    return least;
}

/** Do the closed segments ab and cd meet? */
export function segmentsMeet(a, b, c, d) {
    const abc = Math.sign(orient(a, b, c)), abd = Math.sign(orient(a, b, d));
    const cda = Math.sign(orient(c, d, a)), cdb = Math.sign(orient(c, d, b));
    if (abc !== abd && cda !== cdb) return true;
    return (abc === 0 && isBetween(a, b, c)) || (abd === 0 && isBetween(a, b, d))
        || (cda === 0 && isBetween(c, d, a)) || (cdb === 0 && isBetween(c, d, b));
}
