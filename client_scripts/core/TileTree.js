import { viewCone } from './viewCone.js';

/** A tile that is good enough is left alone until it is better than this share of what is asked: no flicker. */
const kCoarsen = 0.8;
/** Of the error asked for: who comes near it is asked for before it is needed (class C). */
const kSoon = 0.5;
/** Tangents of the view, widened so much: what is just beside it (class B). */
const kBeside = 1.7;
/** m: heights of a city above 0 before anything of it is known. */
const kUnknownRange = [0, 100];
/** m: nearer than this a tile's error counts as if it were there. */
const kNear = 10;
const kQuadrants = [[0, 0], [1, 0], [0, 1], [1, 1]];
const kAllQuadrants = 15;

/** The tiles of a flown city, from /blockmaps/tree.json, and which of them a view needs. */
export class TileTree {
    constructor({ levels, leafSide_m: leafSide, tiles }) {
        this.levels = levels;
        this.rootSide = leafSide * 2 ** (levels - 1);
        this.tiles = new Map(tiles.map(([z, x, y, houses, blockMapError, , prismError]) => {
            const key = `${z}/${x}/${y}`, side = this.rootSide / 2 ** z;
            const corner = [x * side - this.rootSide / 2, y * side - this.rootSide / 2];
            return [key, { key, z, x, y, houses, blockMapError, prismError, side, corner }];
        }));
        for (const tile of this.tiles.values()) tile.children = kQuadrants.map(([dx, dy]) =>
            this.tiles.get(`${tile.z + 1}/${2 * tile.x + dx}/${2 * tile.y + dy}`) ?? null);
    }

    get root() {
        return this.tiles.get('0/0/0');
    }

    /** { low, high } of the space a tile may fill. `range`: its lowest and highest point, m. */
    boxOf({ corner: [east, north], side }, [low, high]) {
        return { low: [east, north, low], high: [east + side, north + side, high] };
    }

    /**
     * Which tiles to draw, the nearest first, and which to ask for (paper 001 §6).
     *
     * `view`: as viewCone has it, with pixelsPerRadian and pixels, the error on screen that is asked for. `isThere(tile)`: it
     * can be drawn now. `rangeOf(tile)`: its lowest and highest point, or null. `errorOf(tile)`: m. `refined`: of the last call.
     *
     * draw: [{ tile, quadrants: bits, onScreen: error in pixels }]: a tile whose children are wanted and there gives way to
     * them quadrant by quadrant (Fig. 8), so that nothing is drawn twice and nothing is missing. What is out of view stays as
     * fine as it was. ask: [{ tile, rank: 'A' in view, 'B' beside it, 'C' before it is needed, onScreen }].
     */
    choose(view, { isThere, rangeOf = () => null, errorOf, refined = new Set() }) {
        const draw = [], ask = [], now = new Set(), sees = viewCone(view), seesBeside = viewCone(view, kBeside);
        const visit = (tile, inherited) => {
            const range = rangeOf(tile) ?? inherited, box = this.boxOf(tile, range), error = errorOf(tile);
            const onScreen = error * view.pixelsPerRadian / Math.max(distanceTo(box, view.eye), kNear);
            const isSeen = sees(box), isBeside = isSeen || seesBeside(box), was = refined.has(tile.key);
            const isRefined = isBeside ? onScreen > view.pixels * (was ? kCoarsen : 1) : was;
            const rank = !isRefined ? 'C' : isSeen ? 'A' : 'B';
            if (isRefined) now.add(tile.key);
            let own = kAllQuadrants;
            const visits = [];
            tile.children.forEach((child, q) => {
                if (!child) return;
                if (isRefined && isThere(child)) {
                    own &= ~(1 << q);
                    visits.push(child);
                } else if (isBeside && !isThere(child) && (isRefined || onScreen > view.pixels * kSoon)) {
                    const childBox = this.boxOf(child, range);
                    const childRank = rank === 'A' && !sees(childBox) ? 'B' : rank;
                    if (childRank !== 'C' || sees(childBox)) ask.push({ tile: child, rank: childRank, onScreen });
                }
            });
            const middle = tile.corner.map(value => value + tile.side / 2);
            const firstEast = view.eye[0] > middle[0] ? 1 : 0, firstNorth = view.eye[1] > middle[1] ? 2 : 0, first = firstEast | firstNorth;
            for (const q of [first, first ^ 1, first ^ 2, first ^ 3]) {
                const child = tile.children[q];
                if (visits.includes(child)) visit(child, range);
            }
            if (own) draw.push({ tile, quadrants: own, onScreen, isFinest: !tile.children.some(Boolean) });
        };
        const root = this.root;
        if (root && isThere(root)) visit(root, kUnknownRange);
        else if (root) ask.push({ tile: root, rank: 'A', onScreen: Infinity });
        return { draw, ask, refined: now };
    }
}

function distanceTo({ low, high }, eye) {
    return Math.hypot(...eye.map((value, k) => Math.max(low[k] - value, 0, value - high[k])));
}
