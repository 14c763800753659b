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

/** So many things that each take a byte of a stream or more. */
function checked(count, { bytes, at }) {
    if (count > bytes.length - at) throw new Error('prism tile: a stream ends too soon');
    return count;
}

/**
 * A prism tile (city_db/FORMAT.md) as { corner: [m, m], side, error, houses, trees }; each house { kind, owned, quadrant, rings, ground, eave, top,
 * wall, roof }: rings of [east, north] in metres from the corner, heights in metres above the plan frame's 0, colours
 * [r, g, b]; with its own roof also `points` [east, north, up] and `facets` { isGable, corners }: numbers of the rings' points in their
 * order, then of `points`. Each tree { form, quadrant, at: [east, north], ground, height, crown, leaves }: a radius, a colour. `layout`: of prism_tile_layout.h. Throws an Error that says what is wrong with the bytes.
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
    const [shapes, east, north, grounds, eaves, rises, colours, anchors, offsets, facetCorners,
        treeEast, treeNorth, treeGrounds, treeSizes, treeLooks] = streams;
    let first = [0, 0], ground = 0;
    /** Points of a roof beside the rings', [steps, steps, steps above the eave], and its facets by numbers of both. */
    const readFacets = corners => {
        const counts = [shapes.next(), shapes.next()];
        const known = i => {
            if (!(i >= 0 && i < corners.length)) throw new Error('prism tile: a corner that the house does not have');
            return corners[i];
        };
        let anchor = 0, firstCorner = 0;
        const points = Array.from({ length: checked(counts[0], offsets) }, () => {
            const [x, y] = known(anchor += anchors.nextSigned());
            return [x + offsets.nextSigned(), y + offsets.nextSigned(), rises.nextSigned()];
        });
        corners = [...corners, ...points];
        const facets = Array.from({ length: checked(counts[1], facetCorners) }, () => {
            const shape = facetCorners.next(), list = [];
            let corner = firstCorner;
            for (let n = Math.floor(shape / 2) + 3; n > 0; --n) {
                known(corner += facetCorners.nextSigned());
                list.push(corner);
            }
            firstCorner = list[0];
            return { isGable: shape % 2 === 1, corners: list };
        });
        return { points, facets };
    };
    const readHouse = () => {
        const shape = shapes.next();
        const rings = [], kind = shape % 8;
        let [x, y] = first;
        for (let r = Math.floor(shape / layout.PRISM_RINGS); r >= 0; --r) {
            const ring = [];
            for (let n = shapes.next() + 3; n > 0; --n) {
                x += east.nextSigned();
                y += north.nextSigned();
                if (rings.length === 0 && ring.length === 0) first = [x, y];
                ring.push([x, y]);
            }
            rings.push(ring);
        }
        const own = kind === layout.PRISM_KIND_FACETED ? readFacets(rings.flat()) : null;
        ground += grounds.nextSigned();
        const low = base + ground * upStep, eave = low + eaves.next() * upStep;
        const top = eave + upStep * (own ? own.points.reduce((most, [, , up]) => Math.max(most, up), 0) : rises.next());
        const [wall, roof] = [palette[colours.next()], palette[colours.next()]];
        if (!wall || !roof) throw new Error('prism tile: a colour that the palette does not have');
        const quadrant = Math.floor(shape / layout.PRISM_QUADRANT) % layout.PRISM_QUADRANTS;
        const inMetres = rings.map(ring => ring.map(point => point.map(value => value * step)));
        const house = { kind, owned: (shape & layout.PRISM_OWNED) !== 0, quadrant, rings: inMetres, ground: low, eave, top, wall, roof };
        if (!own) return house;
        return { ...house, points: own.points.map(([x, y, up]) => [x * step, y * step, eave + up * upStep]), facets: own.facets };
    };
    const houses = Array.from({ length: view.getUint32(layout.PRISM_HOUSES_AT, true) }, readHouse);
    let treeAt = [0, 0], treeGround = 0;
    const readTree = () => {
        treeAt = [treeAt[0] + treeEast.nextSigned(), treeAt[1] + treeNorth.nextSigned()];
        treeGround += treeGrounds.nextSigned();
        const height = treeSizes.next() * upStep, crown = treeSizes.next() * upStep, look = treeLooks.next();
        const leaves = palette[Math.floor(look / layout.PRISM_TREE_COLOUR)];
        if (!leaves) throw new Error('prism tile: a colour that the palette does not have');
        return { form: look % layout.PRISM_TREE_QUADRANT, quadrant: Math.floor(look / layout.PRISM_TREE_QUADRANT) % layout.PRISM_QUADRANTS,
            at: treeAt.map(value => (value + 0.5) * step), ground: base + treeGround * upStep, height, crown, leaves };
    };
    const trees = Array.from({ length: checked(view.getUint32(layout.PRISM_TREES_AT, true), treeLooks) }, readTree);
    return {
        corner: [metres(layout.PRISM_EAST_AT), metres(layout.PRISM_NORTH_AT)],
        side: metres(layout.PRISM_TILE_SIDE_AT),
        error: metres(layout.PRISM_ERROR_AT),
        houses,
        trees,
    };
}
