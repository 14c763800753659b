/** Sides of a cell in the order of their bits: east, north, west, south; the line's bit comes after them. */
const kSides = [[1, 0], [0, 1], [-1, 0], [0, -1]];
const kLineBit = 16;

/** Which walls each cell has columns for: the rule of city_db/blockmap.hpp, in whole numbers below 2^53. */
function wallBits(map, layout) {
    const { side: n, height, foot, slopeEast, slopeNorth, offset, stepUm, wallStepUm, sideMm } = map;
    const riseOf = (cell, east, north) => {
        const slope = (slopeEast[cell] - layout.BLOCKMAP_SLOPE_ZERO) * east + (slopeNorth[cell] - layout.BLOCKMAP_SLOPE_ZERO) * north;
        return height[cell] * stepUm + Math.trunc(slope * sideMm * 1000 / (2 * layout.BLOCKMAP_SLOPE_ONE * n));
    };
    const bits = new Uint8Array(n * n);
    for (let row = 0, cell = 0; row < n; ++row)
        for (let column = 0; column < n; ++column, ++cell) {
            if (offset[cell] !== 0) {
                if ((height[cell] - foot[cell]) * stepUm > wallStepUm) bits[cell] = kLineBit;
                continue;
            }
            kSides.forEach(([east, north], side) => {
                const c = column + east, r = row + north, own = riseOf(cell, east, north);
                const inside = c >= 0 && r >= 0 && c < n && r < n, other = r * n + c;
                const step = !inside ? own : offset[other] !== 0 ? 0 : own - riseOf(other, -east, -north);
                if (step > wallStepUm) bits[cell] |= 1 << side;
            });
        }
    return bits;
}

/** Number of the first column of each cell, cells in Z order; and the number of all. */
function firstColumns(bits, n) {
    const first = new Uint32Array(bits.length);
    let next = 0;
    const visit = (column, row, size) => {
        if (size > 1) {
            const half = size / 2;
            for (const [dc, dr] of [[0, 0], [half, 0], [0, half], [half, half]]) visit(column + dc, row + dr, half);
            return;
        }
        const cell = row * n + column;
        first[cell] = next;
        for (let b = bits[cell]; b !== 0; b &= b - 1) ++next;
    };
    visit(0, 0, n);
    return { first, count: next };
}

/**
 * A BlockMap+ (city_db/FORMAT.md): header and planes as typed arrays, the columns counted, the four pictures as bytes
 * (indexedPicture.js). `layout`: of blockmap_layout.h. Throws an Error that says what is wrong with the bytes.
 */
export function decodeBlockMap(bytes, layout) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes.length < layout.BLOCKMAP_HEADER_BYTES || view.getUint32(layout.BLOCKMAP_MAGIC_AT, true) !== layout.BLOCKMAP_MAGIC)
        throw new Error('no BlockMap');
    if (view.getUint16(layout.BLOCKMAP_VERSION_AT, true) !== layout.BLOCKMAP_VERSION)
        throw new Error('a BlockMap of another version: load the page again');
    const side = view.getUint16(layout.BLOCKMAP_SIDE_AT, true), cells = side * side;
    const linesAt = layout.BLOCKMAP_HEADER_BYTES + layout.BLOCKMAP_PLANES * cells;
    if (bytes.length < linesAt) throw new Error(`BlockMap: expected ${linesAt} bytes and more, found ${bytes.length}`);
    const plane = which => {
        const begin = layout.BLOCKMAP_HEADER_BYTES + which * cells;
        return bytes.subarray(begin, begin + cells);
    };
    const offset = plane(layout.BLOCKMAP_PLANE_OFFSET), lines = offset.reduce((sum, value) => sum + (value !== 0), 0);
    let at = linesAt + layout.BLOCKMAP_LINE_BYTES * lines;
    const pictures = [layout.BLOCKMAP_ROOF_BYTES_AT, layout.BLOCKMAP_GROUND_BYTES_AT, layout.BLOCKMAP_AMBIENT_BYTES_AT,
        layout.BLOCKMAP_WALL_BYTES_AT].map(field => {
        const length = view.getUint32(field, true);
        at += length;
        return bytes.subarray(at - length, at);
    });
    if (at !== bytes.length) throw new Error(`BlockMap: expected ${at} bytes, found ${bytes.length}`);
    const ofLines = (which, Type) => {   // 0 where there is no line
        const out = new Type(cells);
        for (let i = 0, line = linesAt + which * lines; i < cells; ++i) if (offset[i]) out[i] = bytes[line++];
        return out;
    };
    const footLow = ofLines(layout.BLOCKMAP_LINE_FOOT_LOW, Uint16Array);
    const wide = (high, low) => {
        const [h, l] = [plane(high), plane(low)];
        return Uint16Array.from(h, (value, i) => value * 256 + l[i]);
    };
    const map = {
        side,
        rows: view.getUint16(layout.BLOCKMAP_ROWS_AT, true),
        corner: [view.getInt32(layout.BLOCKMAP_EAST_AT, true) / 1000, view.getInt32(layout.BLOCKMAP_NORTH_AT, true) / 1000],
        sideMm: view.getUint32(layout.BLOCKMAP_TILE_SIDE_AT, true),
        base: view.getInt32(layout.BLOCKMAP_BASE_AT, true) / 1000,
        baseEast: view.getInt32(layout.BLOCKMAP_BASE_EAST_AT, true) / layout.BLOCKMAP_BASE_ONE,
        baseNorth: view.getInt32(layout.BLOCKMAP_BASE_NORTH_AT, true) / layout.BLOCKMAP_BASE_ONE,
        stepUm: view.getUint32(layout.BLOCKMAP_STEP_AT, true),
        wallStepUm: view.getUint32(layout.BLOCKMAP_WALL_STEP_AT, true),
        error: view.getUint32(layout.BLOCKMAP_ERROR_AT, true) / 1000,
        top: view.getUint32(layout.BLOCKMAP_TOP_AT, true),
        height: wide(layout.BLOCKMAP_PLANE_HEIGHT_HIGH, layout.BLOCKMAP_PLANE_HEIGHT_LOW),
        foot: ofLines(layout.BLOCKMAP_LINE_FOOT_HIGH, Uint16Array).map((high, i) => high * 256 + footLow[i]),
        slopeEast: plane(layout.BLOCKMAP_PLANE_SLOPE_EAST),
        slopeNorth: plane(layout.BLOCKMAP_PLANE_SLOPE_NORTH),
        angle: ofLines(layout.BLOCKMAP_LINE_ANGLE, Uint8Array),
        offset,
        roof: pictures[0], ground: pictures[1], ambient: pictures[2], wall: pictures[3],
    };
    map.walls = wallBits(map, layout);
    const columns = firstColumns(map.walls, side);
    if (columns.count !== view.getUint32(layout.BLOCKMAP_COLUMNS_AT, true))
        throw new Error(`BlockMap: ${columns.count} wall columns where its header says another number`);
    return { ...map, firstColumn: columns.first, columns: columns.count };
}
