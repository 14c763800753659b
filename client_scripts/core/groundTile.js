/**
 * A ground tile (city_db/FORMAT.md) as { corner: [m, m], side, nodes, heights, picture }: heights in metres above the plan
 * frame's 0, row by row from the south; picture the bytes of its WebP, north row first. `layout`: of ground_tile_layout.h.
 * Throws an Error that says what is wrong with the bytes.
 */
export function decodeGround(bytes, layout) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes.length < layout.GROUND_HEADER_BYTES || view.getUint32(layout.GROUND_MAGIC_AT, true) !== layout.GROUND_MAGIC)
        throw new Error('no ground tile');
    if (view.getUint16(layout.GROUND_VERSION_AT, true) !== layout.GROUND_VERSION)
        throw new Error('a ground tile of another version: build the city again, or load the page again');
    const nodes = view.getUint16(layout.GROUND_NODES_AT, true), cells = nodes * nodes;
    const begin = layout.GROUND_HEADER_BYTES, pictureBytes = view.getUint32(layout.GROUND_PICTURE_BYTES_AT, true);
    if (nodes % 2 === 0 || nodes < layout.GROUND_LEAST_NODES || nodes > layout.GROUND_MOST_NODES)
        throw new Error(`ground tile: ${nodes} nodes a side`);
    if (bytes.length !== begin + 2 * cells + pictureBytes)
        throw new Error(`ground tile: expected ${begin + 2 * cells + pictureBytes} bytes, found ${bytes.length}`);
    const base = view.getInt32(layout.GROUND_BASE_AT, true), step = view.getUint32(layout.GROUND_STEP_AT, true);
    return {
        corner: [view.getInt32(layout.GROUND_EAST_AT, true) / 1000, view.getInt32(layout.GROUND_NORTH_AT, true) / 1000],
        side: view.getUint32(layout.GROUND_TILE_SIDE_AT, true) / 1000,
        nodes,
        heights: Float64Array.from({ length: cells }, (_, i) =>
            (base + step * (256 * bytes[begin + i] + bytes[begin + cells + i])) / 1000),
        picture: bytes.subarray(begin + 2 * cells),
    };
}
