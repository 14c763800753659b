/** Twice the area of a ring, positive where it is counter-clockwise. */
export function doubledArea(ring) {
    let sum = 0;
    for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) sum += ring[j][0] * ring[i][1] - ring[i][0] * ring[j][1];
    return sum;
}

const cross = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
const isSame = (a, b) => a[0] === b[0] && a[1] === b[1];

/** Is p in the closed triangle a, b, c (counter-clockwise)? */
const isInTriangle = (a, b, c, p) => cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= 0;

function segmentsMeet(a, b, c, d) {
    const side = (p, q, r) => Math.sign(cross(p, q, r));
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/** Does the way from a ring's corner to p begin inside the ring? Twins at a bridge differ in that. */
function isInCorner(ring, i, p) {
    const a = ring.at(i - 1), b = ring[i], c = ring[(i + 1) % ring.length];
    if (cross(a, b, c) > 0) return cross(a, b, p) > 0 && cross(b, c, p) > 0;
    return cross(a, b, p) > 0 || cross(b, c, p) > 0;
}

/** `outer` with the hole cut into it along the shortest bridge that crosses no edge; the shortest of all where each does. */
function withHole(outer, hole, others) {
    const pairs = [];
    outer.forEach((a, i) => hole.forEach((b, j) => pairs.push([(a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2, i, j])));
    pairs.sort((p, q) => p[0] - q[0]);
    const rings = [outer, hole, ...others];
    const crosses = ([, i, j]) => !isInCorner(outer, i, hole[j]) || rings.some(ring =>
        ring.some((p, k) => segmentsMeet(outer[i], hole[j], p, ring[(k + 1) % ring.length])));
    const [, i, j] = pairs.find(pair => !crosses(pair)) ?? pairs[0];
    return [...outer.slice(0, i + 1), ...hole.slice(j), ...hole.slice(0, j + 1), ...outer.slice(i)];
}

/**
 * Triangles [a, b, c] of points that cover a polygon: `rings` the outer one counter-clockwise, then holes clockwise. Ears are
 * cut one by one; of rings that cross themselves (rounding does that) it makes something that ends, and covers nearly it.
 * Cost   n^2 for n points.
 */
export function triangulate(rings) {
    let ring = rings[0];
    for (let i = 1; i < rings.length; ++i) ring = withHole(ring, rings[i], rings.slice(i + 1));
    const points = ring.filter((p, i) => !isSame(p, ring[(i + 1) % ring.length])), triangles = [];
    const isEar = i => {
        const n = points.length, a = points[(i + n - 1) % n], b = points[i], c = points[(i + 1) % n];
        if (cross(a, b, c) <= 0) return false;
        return points.every((p, k) => {
            const isCorner = isSame(p, a) || isSame(p, b) || isSame(p, c);   // or its twin at a bridge
            return (isCorner || !isInTriangle(a, b, c, p)) && !segmentsMeet(a, c, p, points[(k + 1) % n]);
        });
    };
    for (let i = 0, misses = 0; points.length > 3;) {
        i %= points.length;
        if (isEar(i) || misses > points.length) {
            const n = points.length, triangle = [points[(i + n - 1) % n], points[i], points[(i + 1) % n]];
            if (cross(...triangle) > 0) triangles.push(triangle);
            points.splice(i, 1);
            misses = 0;
        } else {
            ++i;
            ++misses;
        }
    }
    if (points.length === 3 && cross(...points) > 0) triangles.push(points);
    return triangles;
}
