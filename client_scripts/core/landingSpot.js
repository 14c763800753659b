/** m off its edge that a visitor lands. */
const kOffWalls = 0.9;

/**
 * Where one lands who is above `point`: there, where it lies in a sector; else the nearest place that does. `sectors`:
 * { id, rings } in plan metres, the outer ring first. { id, point }, or null: there is no sector.
 */
export function landingSpot(sectors, point) {
    const here = sectors.find(({ rings }) => isInside(rings, point));
    if (here) return { id: here.id, point };
    let best = null;
    for (const { id, rings } of sectors)
        for (const ring of rings)
            ring.forEach((a, i) => {
                const spot = nearest(a, ring[(i + 1) % ring.length], point), away = Math.hypot(spot[0] - point[0], spot[1] - point[1]);
                if (!best || away < best.away) best = { id, rings, spot, away };
            });
    return best && { id: best.id, point: drawnIn(best.rings, best.spot) };
}

function nearest(a, b, p) {
    const [x, y] = [b[0] - a[0], b[1] - a[1]], square = x * x + y * y;
    const t = square ? Math.min(1, Math.max(0, ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / square)) : 0;
    return [a[0] + t * x, a[1] + t * y];
}

/** A place near one on the edge that is inside and as far from all edges as can be, up to kOffWalls. */
function drawnIn(rings, [east, north]) {
    const clearance = p => Math.min(...rings.flatMap(ring => ring.map((a, i) => {
        const q = nearest(a, ring[(i + 1) % ring.length], p);
        return Math.hypot(q[0] - p[0], q[1] - p[1]);
    })));
    let best = null;
    for (let i = 0; i < 32; ++i)
        for (const reach of [kOffWalls, 2 * kOffWalls, kOffWalls / 3]) {
            const p = [east + reach * Math.cos(i * Math.PI / 16), north + reach * Math.sin(i * Math.PI / 16)];
            if (!isInside(rings, p)) continue;
            const room = Math.min(kOffWalls, clearance(p)) - 0.01 * reach;
            if (!best || room > best.room) best = { p, room };
        }
    return best?.p ?? [east, north];
}

export function isInside(rings, [x, y]) {
    let inside = false;
    for (const ring of rings)
        for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
            const [[ax, ay], [bx, by]] = [ring[j], ring[i]];
            if ((ay > y) !== (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)) inside = !inside;
        }
    return inside;
}
