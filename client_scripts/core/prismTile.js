/** Unsigned and zigzag varints, from the front of some bytes. Throws where they end too soon. */
class VarintSource {
    constructor(bytes) {
        this.bytes = bytes;
        this.at = 0;
    }
    next() {
        let value = 0;
        for (let scale = 1; ; scale *= 128) {
            if (this.at >= this.bytes.length || scale > 2 ** 35) throw new Error('prism tile: a stream ends too soon');
            const byte = this.bytes[this.at++];
            value += (byte & 127) * scale;
            if (byte < 128) return value;
        }
    }
    nextSigned() {
        const value = this.next();
        return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
    }
}

/**
 * A prism tile (city_db/FORMAT.md) as { corner: [m, m], side, error, houses }; each house { kind, owned, quadrant, rings, ground, eave, top,
 * wall, roof }: rings of [east, north] in metres from the corner, heights in metres above the plan frame's 0, colours
 * [r, g, b]. `layout`: of prism_tile_layout.h. Throws an Error that says what is wrong with the bytes.
 */
export function decodePrisms(bytes, layout) {
    const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    if (bytes.length < layout.PRISM_HEADER_BYTES || view.getUint32(layout.PRISM_MAGIC_AT, true) !== layout.PRISM_MAGIC)
        throw new Error('no prism tile');
    if (view.getUint16(layout.PRISM_VERSION_AT, true) !== layout.PRISM_VERSION)
        throw new Error('a prism tile of another version: build the city again, or load the page again');
    const metres = at => view.getInt32(at, true) / 1000;
    const step = metres(layout.PRISM_STEP_AT), upStep = metres(layout.PRISM_UP_STEP_AT), base = metres(layout.PRISM_BASE_AT);
    let at = layout.PRISM_HEADER_BYTES;
    const palette = Array.from({ length: view.getUint16(layout.PRISM_COLOURS_AT, true) }, () => {
        at += 3;
        return [...bytes.subarray(at - 3, at)];
    });
    const streams = Array.from({ length: layout.PRISM_STREAMS }, (_, i) => {
        const length = view.getUint32(layout.PRISM_LENGTHS_AT + 4 * i, true);
        at += length;
        return new VarintSource(bytes.subarray(at - length, at));
    });
    if (at !== bytes.length) throw new Error(`prism tile: expected ${at} bytes, found ${bytes.length}`);
    const [shapes, east, north, grounds, eaves, rises, colours] = streams;
    let first = [0, 0], ground = 0;
    const readHouse = () => {
        const shape = shapes.next();
        const rings = [];
        let [x, y] = first;
        for (let r = Math.floor(shape / layout.PRISM_RINGS); r >= 0; --r) {
            const ring = [];
            for (let n = shapes.next() + 3; n > 0; --n) {
                x += east.nextSigned();
                y += north.nextSigned();
                if (rings.length === 0 && ring.length === 0) first = [x, y];
                ring.push([x * step, y * step]);
            }
            rings.push(ring);
        }
        ground += grounds.nextSigned();
        const low = base + ground * upStep, eave = low + eaves.next() * upStep, top = eave + rises.next() * upStep;
        const [wall, roof] = [palette[colours.next()], palette[colours.next()]];
        if (!wall || !roof) throw new Error('prism tile: a colour that the palette does not have');
        const quadrant = Math.floor(shape / layout.PRISM_QUADRANT) % layout.PRISM_QUADRANTS;
        return { kind: shape % 8, owned: (shape & layout.PRISM_OWNED) !== 0, quadrant, rings, ground: low, eave, top, wall, roof };
    };
    const houses = Array.from({ length: view.getUint32(layout.PRISM_HOUSES_AT, true) }, readHouse);
    return {
        corner: [metres(layout.PRISM_EAST_AT), metres(layout.PRISM_NORTH_AT)],
        side: metres(layout.PRISM_TILE_SIDE_AT),
        error: metres(layout.PRISM_ERROR_AT),
        houses,
    };
}
