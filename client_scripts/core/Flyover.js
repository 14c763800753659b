import { RoofHeights } from './RoofHeights.js';
import { TileFades } from './TileFades.js';
import { TileRequests } from './TileRequests.js';
import { TileTree } from './TileTree.js';

/** Corners handed to the graphics card per second that a frame takes, within bounds: a tenth of its time. */
const kCornersASecond = 400000, kFewestCorners = 6000, kMostCorners = 60000;
/** Where what is seen has no room, more error is allowed: so much more each frame, and less again when it has. */
const kStrain = 1.03, kEase = 1.002;
const kMostBytes = 192e6, kFull = 0.8;

/**
 * The city from above: which tiles are fetched, kept and drawn as the eye moves (paper 001 §6). All that is kept for good is
 * the tree, a few kB.
 *
 * Needs   `load(tile, signal, form)`: a promise of what tileMesh or blockMapMesh makes of it, with `sentBytes`. `stage`: makes and shows quadrants:
 * begin(mesh) -> what is being made; work(making): makes a piece, returns its corners, null: nothing to do now; isDone(making); show(making, quadrant),
 * setState(making, quadrant, state of TileFades), hide(making, quadrant), drop(making); surround(mesh of the root), showSurroundings(isShown).
 */
export class Flyover {
    constructor({ tree, load, stage, pixels = 2, form = 'prisms', mostBytes = kMostBytes, mostInFlight = 6, complain }) {
        this.tree = new TileTree(tree);
        this.requests = new TileRequests({ load: (tile, signal) => load(tile, signal, this.formOf(tile)), arrived: (tile, mesh) => this.arrive(tile, mesh), mostInFlight, complain });
        Object.assign(this, { stage, pixels, form, mostBytes, kept: new Map(), making: [], bytes: 0, fades: new TileFades(),
            heights: new RoofHeights(), refined: new Set(), isShown: true, arrivals: 0, strain: 1, chosen: { draw: [], ask: [] }, now: 0 });
        this.figures = { files: 0, sentBytes: 0, firstAt: null };
    }

    /** What a tile is drawn as: as wanted where it is sent as that; a BlockMap also where there are too many houses for prisms. */
    formOf({ prismError, blockMapError, houses }) {
        const wantsIt = this.form === 'blockMap' || (prismError === null && houses > 0);
        return wantsIt && blockMapError !== null ? 'blockMap' : 'prisms';
    }

    /** Another form: everything is fetched again, as it is needed. */
    setForm(form) {
        if (form === this.form) return;
        const { isShown } = this;
        this.hide();
        for (const record of [...this.kept.values()]) this.drop(record);
        Object.assign(this, { form, isShown, making: [] });
    }

    errorOf(tile) {
        if (this.formOf(tile) === 'blockMap') return tile.blockMapError;
        return tile.prismError ?? (tile.houses ? Infinity : 0);   // too many houses for one tile: its ground alone
    }

    /** Can it be drawn now? */
    isThere(tile) {
        return this.kept.get(tile.key)?.isMade ?? false;
    }

    arrive(tile, mesh) {
        const record = { tile, mesh, made: this.stage.begin(mesh), isMade: false, usedAt: this.now };
        this.kept.set(tile.key, record);
        this.making.push(record);
        this.bytes += mesh.bytes;
        this.figures.files += 1;
        this.figures.sentBytes += mesh.sentBytes ?? 0;
    }

    /** One frame. `view`: as TileTree.choose has it, without pixels; `now`: s. */
    step(view, now) {
        this.make(Math.min(kMostCorners, Math.max(kFewestCorners, kCornersASecond * (now - this.now))));
        this.now = now;
        const chosen = this.tree.choose({ ...view, pixels: this.pixels * this.strain }, {
            isThere: tile => this.isThere(tile), rangeOf: tile => this.kept.get(tile.key)?.mesh.range ?? null,
            errorOf: tile => this.errorOf(tile), refined: this.refined });
        this.use([...chosen.draw.map(({ tile }) => tile), ...[...chosen.refined].map(key => this.tree.tiles.get(key))], now);
        const isFull = this.bytes > kFull * this.mostBytes;   // then nothing is fetched that is not needed now
        this.requests.step(chosen.ask.filter(({ tile, rank }) => !this.kept.has(tile.key) && (rank === 'A' || !isFull)), now);
        if (!this.isShown) Object.assign(this, { chosen, refined: chosen.refined });
        else if (this.fades.set(chosen.draw, now)) Object.assign(this, { chosen, refined: chosen.refined });
        else this.chosen.ask = chosen.ask;
        for (const { tile, quadrant, state } of this.fades.step(now)) this.apply(this.kept.get(tile.key).made, quadrant, state);
        this.evict();
        this.strain = this.bytes > this.mostBytes ? this.strain * kStrain : Math.max(1, this.strain / kEase);
    }

    /** Some work each frame, by corners: the visitor is flying meanwhile. One piece is always done. */
    make(most) {
        let corners = 0;
        for (const record of [...this.making]) {
            while (corners < most) {
                const done = this.stage.work(record.made);
                if (done === null) break;   // it waits for its picture
                corners += done;
                if (this.stage.isDone(record.made)) {
                    this.finish(record);
                    break;
                }
            }
        }
    }

    finish(record) {
        this.making.splice(this.making.indexOf(record), 1);
        record.isMade = true;
        ++this.arrivals;
        record.mesh.parts = null;   // it is in the scene
        if (record.tile === this.tree.root) this.stage.surround(record.mesh);
        this.heights.add(record.tile.key, record.mesh);
        this.figures.firstAt ??= performance.now();
    }

    apply(made, quadrant, state) {
        if (state >= 1) this.stage.hide(made, quadrant);
        else {
            this.stage.showSurroundings(true);
            this.stage.show(made, quadrant);
            this.stage.setState(made, quadrant, state);
        }
    }

    use(tiles, now) {
        for (const { key } of tiles) if (this.kept.has(key)) this.kept.get(key).usedAt = now;
    }

    /** What was drawn longest ago goes first, until it all has room; what is drawn, or was asked for just now, stays. */
    evict() {
        if (this.bytes <= this.mostBytes) return;
        const drawn = new Set([...this.fades.parts.values()].map(({ tile }) => tile.key));
        const idle = [...this.kept.values()].filter(({ tile, isMade }) => isMade && !drawn.has(tile.key) && !this.refined.has(tile.key))
            .sort((a, b) => a.usedAt - b.usedAt || b.tile.z - a.tile.z);
        while (this.bytes > this.mostBytes && idle.length) this.drop(idle.shift());
    }

    drop({ tile, mesh, made }) {
        this.stage.drop(made);
        this.kept.delete(tile.key);
        this.heights.remove(tile.key);
        this.bytes -= mesh.bytes;
    }

    /** All that the view needs is there. */
    get isReady() {
        return this.chosen.draw.length > 0 && !this.chosen.ask.some(({ rank }) => rank === 'A');
    }

    /** Nothing is on its way or half there, and nothing more is needed for what is seen. */
    get isSettled() {
        const isNeeded = ({ rank, tile }) => rank === 'A' && !this.requests.failures.has(tile.key);
        return this.fades.isCalm && this.making.length === 0 && !this.chosen.ask.some(isNeeded) && this.chosen.draw.length > 0;
    }

    /** Nothing is drawn any more; the tiles stay, for when he is back. */
    hide() {
        for (const { tile, quadrant } of this.fades.parts.values()) this.stage.hide(this.kept.get(tile.key).made, quadrant);
        this.fades.clear();
        Object.assign(this, { refined: new Set(), isShown: false });
        this.stage.showSurroundings(false);
        this.requests.cancel();
    }
}
