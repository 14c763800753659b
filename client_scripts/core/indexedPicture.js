/**
 * A picture of few colours (city_db/indexed_picture.hpp) of so many pixels, as RGBA bytes. Throws an Error that says what is wrong with
 * the bytes.
 */
export function decodeIndexed(bytes, pixels) {
    const colours = (bytes[0] ?? 0) + 1, begin = 1 + 3 * colours;
    if (bytes.length !== begin + pixels) throw new Error(`picture: expected ${begin + pixels} bytes, found ${bytes.length}`);
    const out = new Uint8Array(4 * pixels).fill(255);
    for (let i = 0; i < pixels; ++i) {
        const colour = bytes[begin + i];
        if (colour >= colours) throw new Error('picture: a colour that its palette does not have');
        for (let k = 0; k < 3; ++k) out[4 * i + k] = bytes[1 + 3 * colour + k];
    }
    return out;
}

/** { roof, ground, ambient, wall } of a BlockMap (of decodeBlockMap) as RGBA, the top row first; null: it has none. */
export function blockMapPictures({ side, rows, columns, roof, ground, ambient, wall }, layout) {
    const strips = Math.ceil(columns / layout.BLOCKMAP_ATLAS_WIDTH), wide = Math.min(columns, layout.BLOCKMAP_ATLAS_WIDTH);
    const of = (bytes, pixels) => (bytes.length ? decodeIndexed(bytes, pixels) : null);
    return { roof: of(roof, side * side), ground: of(ground, side * side / 4), ambient: of(ambient, side * side / 4), wall: of(wall, wide * strips * rows) };
}
