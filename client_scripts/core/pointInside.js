/**
 * A point of a polygon well off its edges: the middle of the longest span of a few level lines across it. Rings as in
 * planGeometry.
 */
export function pointInside(rings, lines = 9) {
    const norths = rings[0].map(point => point[1]), south = Math.min(...norths), north = Math.max(...norths);
    let best = rings[0][0], longest = -1;
    for (let i = 1; i <= lines; ++i) {
        const y = south + (north - south) * i / (lines + 1), crossings = crossingsAt(rings, y);
        for (let k = 0; k + 1 < crossings.length; k += 2) {
            const length = crossings[k + 1] - crossings[k];
            if (length > longest) [best, longest] = [[(crossings[k] + crossings[k + 1]) / 2, y], length];
        }
    }
    return best;
}

function crossingsAt(rings, y) {
    const easts = [];
    for (const ring of rings)
        for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
            const [[ax, ay], [bx, by]] = [ring[j], ring[i]];
            if ((ay > y) !== (by > y)) easts.push(ax + (y - ay) / (by - ay) * (bx - ax));
        }
    return easts.sort((a, b) => a - b);
}
