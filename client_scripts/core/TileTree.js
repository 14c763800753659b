/** A tile that is good enough is left alone until it is better than this share of what is asked: no flicker. */
const kCoarsen = 0.8;
/** m: roofs are not higher than this over the ground, so an eye that low may be right before one. */
const kRoofs = 100;
/** m: nearer than this a tile's error counts as if it were there. */
const kNear = 10;
/** More houses than this are drawn as a BlockMap where there is one: their polygons would be too many. */
const kMostHouses = 1500;

/** The tiles of a flown city, from /blockmaps/tree.json, and which of them a view needs. */
export class TileTree {
    constructor({ levels, leafSide_m: leafSide, tiles }) {
        this.levels = levels;
        this.rootSide = leafSide * 2 ** (levels - 1);
        this.tiles = new Map(tiles.map(([z, x, y, houses, blockMapError, , prismError]) =>
            [`${z}/${x}/${y}`, { z, x, y, houses, blockMapError, prismError }]));
    }

    childrenOf({ z, x, y }) {
        return [[0, 0], [1, 0], [0, 1], [1, 1]].map(([dx, dy]) => this.tiles.get(`${z + 1}/${2 * x + dx}/${2 * y + dy}`))
            .filter(Boolean);
    }

    /** What a tile is sent as: { path, error in metres }. Prisms but where they would be too many. */
    formOf({ z, x, y, houses, blockMapError, prismError }) {
        const path = `blockmaps/${z}/${x}/${y}`;
        const asBlockMap = prismError === null || (blockMapError !== null && houses > kMostHouses);
        return asBlockMap ? { path, error: blockMapError ?? 0 } : { path: `${path}.prisms`, error: prismError };
    }

    /** m: from an eye [east, north, up] to the nearest point that something of the tile may be at. */
    distance({ z, x, y }, [east, north, up]) {
        const side = this.rootSide / 2 ** z, west = x * side - this.rootSide / 2, south = y * side - this.rootSide / 2;
        return Math.hypot(Math.max(west - east, 0, east - west - side), Math.max(south - north, 0, north - south - side),
            Math.max(up - kRoofs, 0));
    }

    /**
     * Which tiles to draw and which to ask for, the most needed first (paper 001 §6). `view`: { eye, pixelsPerRadian, pixels: the
     * error on screen that is asked for }. `isThere(path)`: it can be drawn now. `refined`: of the last call. A tile
     * gives way to its children when all of them can be drawn, so nothing is drawn twice and nothing is missing.
     */
    choose(view, isThere, refined = new Set()) {
        const draw = [], ask = [], now = new Set();
        const visit = tile => {
            const { path, error } = this.formOf(tile);
            const onScreen = error * view.pixelsPerRadian / Math.max(this.distance(tile, view.eye), kNear);
            const children = this.childrenOf(tile);
            const fine = children.length === 0 || onScreen <= view.pixels * (refined.has(path) ? kCoarsen : 1);
            if (!isThere(path)) ask.push({ path, onScreen });
            if (!fine) {
                now.add(path);
                const before = [draw.length, ask.length];
                if (children.map(visit).every(Boolean)) {
                    if (ask.at(before[1] - 1)?.path === path) ask.splice(before[1] - 1, 1);
                    return true;
                }
                draw.length = before[0];
            }
            if (isThere(path)) draw.push(path);
            return isThere(path);
        };
        const root = this.tiles.get('0/0/0');
        if (root) visit(root);
        ask.sort((a, b) => b.onScreen - a.onScreen || (a.path < b.path ? -1 : 1));
        return { draw, ask: ask.map(({ path }) => path), refined: now };
    }
}
