import { kSurfaces } from './prismMesh.js';

/** Of the tile's side: how far the ground goes on below its rim, so that no gap shows between tiles of two levels. */
const kSkirt = 0.02;

/** Adds a quadrant of a ground tile (of decodeGround) to a TriangleBuilder, metres from the tile's corner. */
export function addGround(builder, { side, nodes, heights }, quadrant) {
    const half = (nodes - 1) / 2, first = [quadrant & 1 ? half : 0, quadrant & 2 ? half : 0];
    const step = side / (nodes - 1), colour = [1, 1, 1, kSurfaces.ground], numbers = [];
    const up = (column, row) => heights[row * nodes + column];
    const clamp = i => Math.min(nodes - 1, Math.max(0, i));
    const place = (column, row) => [column / (nodes - 1), 1 - row / (nodes - 1)];
    const normal = (column, row) => {
        const slope = (low, high, span) => (high - low) / (span * step);
        const [west, east, south, north] = [clamp(column - 1), clamp(column + 1), clamp(row - 1), clamp(row + 1)];
        const n = [-slope(up(west, row), up(east, row), east - west), 1, slope(up(column, south), up(column, north), north - south)];
        const size = Math.hypot(...n);
        return n.map(value => value / size);
    };
    const corner = (column, row, below = 0) => builder.corner(
        [column * step, up(column, row) - below, -row * step], normal(column, row), colour, place(column, row));
    for (let row = 0; row <= half; ++row)
        for (let column = 0; column <= half; ++column) numbers.push(corner(first[0] + column, first[1] + row));
    const width = half + 1;
    for (let row = 0; row < half; ++row)
        for (let column = 0; column < half; ++column) {
            const a = row * width + column + numbers[0], b = a + 1, c = a + width, d = c + 1;
            builder.triangle(a, b, d);
            builder.triangle(a, d, c);
        }
    const rim = [];   // once round, counter-clockwise
    for (let i = 0; i < half; ++i) rim.push([i, 0]);
    for (let i = 0; i < half; ++i) rim.push([half, i]);
    for (let i = half; i > 0; --i) rim.push([i, half]);
    for (let i = half; i > 0; --i) rim.push([0, i]);
    rim.forEach((from, i) => {
        const to = rim[(i + 1) % rim.length], below = 1 + kSkirt * side;
        const [a, b, c, d] = [corner(first[0] + from[0], first[1] + from[1], below), corner(first[0] + to[0], first[1] + to[1], below),
            corner(first[0] + to[0], first[1] + to[1]), corner(first[0] + from[0], first[1] + from[1])];
        builder.triangle(a, b, c);
        builder.triangle(a, c, d);
    });
}
