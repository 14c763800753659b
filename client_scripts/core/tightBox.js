const kBoxes = new WeakMap();

/**
 * The box of least area, turned any way, that holds a sector's ground; its upright box while the ground is not known.
 * { centre, along: unit vector, half: [mm along, mm across] }.
 *
 * Source  Freeman & Shapira 1975: a side of it lies on an edge of the convex hull. Each edge of the outer ring is tried;
 *         those of the hull are among them.
 * Cost    once per sector: the square of its outer ring's points.
 */
export function tightBox(sector) {
    const known = kBoxes.get(sector);
    if (known) return known;
    const box = sector.ground ? leastBox(sector.ground[0]) : uprightBox(sector.box);
    kBoxes.set(sector, box);
    return box;
}

/** mm from the nearest side, below 0 outside. */
export function depthInBox({ centre, along, half }, point) {
    const east = point[0] - centre[0], north = point[1] - centre[1];
    const u = Math.abs(east * along[0] + north * along[1]), v = Math.abs(north * along[0] - east * along[1]);
    return Math.min(half[0] - u, half[1] - v);
}

function uprightBox([west, south, east, north]) {
    return { centre: [(west + east) / 2, (south + north) / 2], along: [1, 0], half: [(east - west) / 2, (north - south) / 2] };
}

function leastBox(ring) {
    let best = null, least = Infinity;
    for (const [i, a] of ring.entries()) {
        const b = ring[(i + 1) % ring.length], length = Math.hypot(b[0] - a[0], b[1] - a[1]);
        if (length === 0) continue;
        const box = boxAlong(ring, [(b[0] - a[0]) / length, (b[1] - a[1]) / length]);
        const area = box.half[0] * box.half[1];
        if (area < least) [best, least] = [box, area];
    }
    return best;
}

function boxAlong(ring, along) {
    let [u0, u1, v0, v1] = [Infinity, -Infinity, Infinity, -Infinity];
    for (const [east, north] of ring) {
        const u = east * along[0] + north * along[1], v = north * along[0] - east * along[1];
        [u0, u1, v0, v1] = [Math.min(u0, u), Math.max(u1, u), Math.min(v0, v), Math.max(v1, v)];
    }
    const u = (u0 + u1) / 2, v = (v0 + v1) / 2;
    return {
        centre: [u * along[0] - v * along[1], u * along[1] + v * along[0]], along, half: [(u1 - u0) / 2, (v1 - v0) / 2] };
}
