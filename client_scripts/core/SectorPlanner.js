import { boxContains, boxDistance, distance, distanceToEdges, isInside, latticePoint, nearestOnSegment } from './planGeometry.js';
import { idOf, levelOf, levelsAround, sectorFromNeighbour, sectorFromRecord, stemOf } from './sectorRecord.js';

/** m beyond the current ground at which a neighbour becomes current: a step back at a gate changes nothing. */
const kGateHysteresisMm = 500;
/** s that a sector left behind stays as it was: a walker who turns round finds it there. */
const kKeepSeconds = 10;
/** Live Shape nodes, all levels of detail: beyond it X_ITE's own bookkeeping per node costs the frame. */
const kShapeCap = 1500;
/** A far or tall file is one merged Shape. */
const kMergedShapes = 1;
const kLoadsInFlight = 3;
const kRetrySeconds = [1, 2, 4, 8, 16, 30];
const kUrgency = { near: 0, far: 1, tall: 2 };

/**
 * Says which sectors should be there, and which file of each: paper 004 §5.1 and §5.2, without knowing who shows them.
 *
 * The current sector and its gate neighbours are wanted near, what else is visible far or tall (levelsAround). Files go
 * by their stems. A sector that changes its level keeps the old file until the new one is there.
 *
 * The owner calls plan() once per frame and does what it returns; it reports arrived(), failed().
 * Frame   positions and records in plan metres, [east, north]; times in seconds, never decreasing.
 * Needs   every stem given to arrived() or failed() was returned in `load` before.
 * Cost    the current sector's edges and its neighbours'; all known sectors' only after a jump.
 * Differs the current sector's test is point in polygon (§5.2.1), exact on the lattice, not a scaled box: a polygon's
 *         own edge with a margin beyond it serves as the scaled gate.
 */
export class SectorPlanner {
    /** `nearOnly`: the world has no far and tall files, near ones stand for them. */
    constructor(start, { keepSeconds = kKeepSeconds, shapeCap = kShapeCap, loadsInFlight = kLoadsInFlight, nearOnly = false } = {}) {
        this.options = { keepSeconds, shapeCap, loadsInFlight, nearOnly };
        this.sectors = new Map();   // id -> sector, ground null while only a neighbour told of it
        this.states = new Map();    // stem -> { phase: loading | live | failed, wantedAt, failures, retryAt }
        this.current = start;
    }

    /** A place known from a neighbour's record or from the root world. Never forgets a ground. */
    addNeighbour(record) {
        if (!this.sectors.has(record.id)) this.sectors.set(record.id, sectorFromNeighbour(record));
    }

    /** The file is shown; with a near one came its record. Returns the ids it made known for the first time. */
    arrived(stem, record) {
        const state = this.states.get(stem);
        const fresh = levelOf(stem) === 'near' ? this.learn(stem, record) : [];
        if (state) Object.assign(state, { phase: 'live', failures: 0 });
        return fresh;
    }

    learn(id, record) {
        const sector = sectorFromRecord(record);
        if (sector.id !== id) throw new Error(`asked for sector ${id}, the file's record says ${sector.id}`);
        this.sectors.set(id, sector);
        const fresh = sector.neighbours.filter(neighbour => !this.sectors.has(neighbour.id));
        for (const neighbour of fresh) this.sectors.set(neighbour.id, neighbour);
        return fresh.map(neighbour => neighbour.id);
    }

    /** It could not be fetched or read: asked for again after 1, 2, 4, ... 30 s, for as long as it is wanted. */
    failed(stem, now) {
        const state = this.states.get(stem);
        const wait = kRetrySeconds[Math.min(state.failures, kRetrySeconds.length - 1)];
        Object.assign(state, { phase: 'failed', failures: state.failures + 1, retryAt: now + wait });
    }

    /**
     * -> { current, changed, load: at most one stem, unload: stems, wakeAt }. `position` may be null: not known yet.
     * Nothing changes before `wakeAt` (s, Infinity: never) unless the visitor moves or a file arrives or fails.
     */
    plan(position, now) {
        const before = this.current;
        const point = position && latticePoint(position);
        if (point) this.current = this.currentSector(point);
        const wanted = this.wanted(point);
        for (const stem of wanted) if (this.states.has(stem)) this.states.get(stem).wantedAt = now;
        const unload = this.unloads(wanted, now);
        const load = this.nextLoad(wanted, now), changed = this.current !== before;
        return { current: this.current, changed, load, unload, wakeAt: load.length ? now : this.wakeTime(wanted, now) };
    }

    wakeTime(wanted, now) {
        let earliest = Infinity;
        for (const [stem, state] of this.states) {
            if (!wanted.includes(stem)) earliest = Math.min(earliest, this.isRecent(state, now) ? this.keptUntil(state) : Infinity);
            else if (state.phase === 'failed') earliest = Math.min(earliest, state.retryAt);
        }
        return earliest;
    }

    /** Paper 004 §5.2.3: the current sector and its neighbours are tested; everything known only after a jump. */
    currentSector(point) {
        const current = this.sectors.get(this.current);
        if (current?.ground) {
            if (hasInside(current, point)) return current.id;
            const around = [...levelsAround(current).keys()].map(id => this.sectors.get(id));
            const next = around.find(sector => sector && hasInside(sector, point));
            if (next) return distanceToEdges(current.ground, point) > kGateHysteresisMm ? next.id : current.id;
        }
        for (const sector of this.sectors.values()) if (hasInside(sector, point)) return sector.id;
        return this.current;
    }

    /**
     * Stems that should be there, the most urgent first. Off every known ground: what might hold the visitor, too.
     * Before the visitor's first position only his start: X_ITE binds a world's viewpoint, and so begins to show it,
     * once nothing of it is on its way.
     */
    wanted(point) {
        const current = this.sectors.get(this.current);
        if (!current) return [];
        if (!point) return [stemOf(current.id, 'near')];
        const levels = new Map([...levelsAround(current)].filter(([id]) => this.sectors.has(id)));
        if (this.options.nearOnly) for (const id of levels.keys()) levels.set(id, 'near');
        if (current.ground && !hasInside(current, point))
            for (const sector of this.sectors.values())
                if (!sector.ground && boxContains(sector.box, point)) levels.set(sector.id, 'near');
        const ranked = [...levels].map(([id, level]) => [kUrgency[level], this.gap(current, id, point), stemOf(id, level)]);
        return ranked.sort((a, b) => a[0] - b[0] || a[1] - b[1] || (a[2] < b[2] ? -1 : 1)).map(([, , stem]) => stem);
    }

    /** How far the visitor is from a sector: from its nearest gate where he may pass into it, else from its box. */
    gap(current, id, point) {
        if (id === current.id) return -1;
        const gates = (current.gates ?? []).filter(gate => gate.to === id);
        if (gates.length === 0) return boxDistance(this.sectors.get(id).box, point);
        return Math.min(...gates.map(({ line }) => distanceToLine(line, point)));
    }

    /**
     * What another file of the same sector has replaced; what was left longer ago than keepSeconds; over the cap, what
     * was left the longest ago at once.
     */
    unloads(wanted, now) {
        const stemFor = new Map(wanted.map(stem => [idOf(stem), stem]));
        const left = [...this.states].filter(([stem]) => !wanted.includes(stem)).sort((a, b) => a[1].wantedAt - b[1].wantedAt);
        let excess = this.excessShapes(wanted);
        const unload = [];
        for (const [stem, state] of left) {
            const instead = stemFor.get(idOf(stem));
            const isKept = instead ? this.standsIn(state, instead) : this.isRecent(state, now) && excess <= 0;
            if (isKept) continue;
            excess -= this.shapesOf(stem);
            this.states.delete(stem);
            unload.push(stem);
        }
        return unload;
    }

    keptUntil(state) {
        return state.wantedAt + this.options.keepSeconds;
    }

    isRecent(state, now) {
        return now < this.keptUntil(state);
    }

    standsIn(state, instead) {
        return state.phase === 'live' && this.states.get(instead)?.phase !== 'live';
    }

    /** Is a finer file there that was wanted a moment ago? Then a visitor who turns round finds it still there. */
    isServedFiner(stem, now) {
        return Object.keys(kUrgency).some(level => {
            const state = kUrgency[level] < kUrgency[levelOf(stem)] && this.states.get(stemOf(idOf(stem), level));
            return state && state.phase === 'live' && this.isRecent(state, now);
        });
    }

    nextLoad(wanted, now) {
        const inFlight = [...this.states.values()].filter(state => state.phase === 'loading').length;
        if (inFlight >= this.options.loadsInFlight) return [];
        const isFull = this.excessShapes(wanted) > 0;
        for (const stem of wanted) {
            const state = this.states.get(stem);
            if (state && (state.phase !== 'failed' || now < state.retryAt)) continue;
            if (!state && !isFull && this.isServedFiner(stem, now)) continue;
            const fits = this.liveShapes() + this.shapesOf(stem) <= this.options.shapeCap;
            if (!state && !fits && stem !== this.current && !this.isCoarser(stem)) return [];
            this.states.set(stem, { phase: 'loading', wantedAt: now, failures: state?.failures ?? 0, retryAt: 0 });
            return [stem];
        }
        return [];
    }

    /** Would the file replace one with more Shapes? */
    isCoarser(stem) {
        return [...this.states.keys()].some(other => idOf(other) === idOf(stem) && this.shapesOf(other) > this.shapesOf(stem));
    }

    shapesOf(stem) {
        return levelOf(stem) === 'near' ? this.sectors.get(stem).shapes : kMergedShapes;
    }

    /** Shape nodes of everything asked for and not given back. */
    liveShapes() {
        let shapes = 0;
        for (const stem of this.states.keys()) shapes += this.shapesOf(stem);
        return shapes;
    }

    /** Shapes above the cap once all that is wanted is there beside what is there now. */
    excessShapes(wanted) {
        const missing = wanted.filter(stem => !this.states.has(stem)).reduce((sum, stem) => sum + this.shapesOf(stem), 0);
        return this.liveShapes() + missing - this.options.shapeCap;
    }
}

function hasInside(sector, point) {
    return sector.ground !== null && boxContains(sector.box, point) && isInside(sector.ground, point);
}

function distanceToLine(line, point) {
    let least = Infinity;
    for (let i = 1; i < line.length; ++i)
        least = Math.min(least, distance(nearestOnSegment(line[i - 1], line[i], point), point));
    return least;
}
