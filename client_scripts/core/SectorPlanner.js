import { boxContains, boxDistance, distanceToEdges, isInside, latticePoint } from './planGeometry.js';
import { firstLevel, sectorFromNeighbour, sectorFromRecord } from './sectorRecord.js';

/** m beyond the current ground at which a neighbour becomes current: a step back at a gate changes nothing. */
const kGateHysteresisMm = 500;
/** s that a sector left behind stays: a walker who turns round finds it there. */
const kKeepSeconds = 10;
/** Live Shape nodes, all levels of detail: beyond it X_ITE's own bookkeeping per node costs the frame. */
const kShapeCap = 1500;
const kLoadsInFlight = 3;
const kRetrySeconds = [1, 2, 4, 8, 16, 30];

/**
 * Says which sectors should be there: paper 004 §5.1 and §5.2, without knowing who shows them.
 *
 * The owner calls plan() once per frame and does what it returns; it reports arrived(), failed().
 * Frame   positions and records in plan metres, [east, north]; times in seconds, never decreasing.
 * Needs   every id given to arrived() or failed() was returned in `load` before.
 * Cost    the current sector's edges and its neighbours'; all known sectors' only after a jump.
 * Differs the current sector's test is point in polygon (§5.2.1), exact on the lattice, not a scaled box: a polygon's
 *         own edge with a margin beyond it serves as the scaled gate.
 */
export class SectorPlanner {
    constructor(start, { keepSeconds = kKeepSeconds, shapeCap = kShapeCap, loadsInFlight = kLoadsInFlight } = {}) {
        this.options = { keepSeconds, shapeCap, loadsInFlight };
        this.sectors = new Map();   // id -> sector, ground null while only a neighbour told of it
        this.states = new Map();    // id -> { phase: loading | live | failed, wantedAt, failures, retryAt }
        this.current = start;
    }

    /** A place known from a neighbour's record or from the root world. Never forgets a ground. */
    addNeighbour(record) {
        if (!this.sectors.has(record.id)) this.sectors.set(record.id, sectorFromNeighbour(record));
    }

    /** The sector is shown; its record came with it. Returns the ids it made known for the first time. */
    arrived(id, record) {
        const sector = sectorFromRecord(record);
        if (sector.id !== id) throw new Error(`asked for sector ${id}, the file's record says ${sector.id}`);
        this.sectors.set(id, sector);
        const fresh = sector.neighbours.filter(neighbour => !this.sectors.has(neighbour.id));
        for (const neighbour of fresh) this.sectors.set(neighbour.id, neighbour);
        const state = this.states.get(id);
        if (state) Object.assign(state, { phase: 'live', failures: 0 });
        return fresh.map(neighbour => neighbour.id);
    }

    /** It could not be fetched or read: asked for again after 1, 2, 4, ... 30 s, for as long as it is wanted. */
    failed(id, now) {
        const state = this.states.get(id);
        const wait = kRetrySeconds[Math.min(state.failures, kRetrySeconds.length - 1)];
        Object.assign(state, { phase: 'failed', failures: state.failures + 1, retryAt: now + wait });
    }

    /**
     * -> { current, changed, load: at most one id, unload: ids, wakeAt }. `position` may be null: not known yet.
     * Nothing changes before `wakeAt` (s, Infinity: never) unless the visitor moves or a sector arrives or fails.
     */
    plan(position, now) {
        const before = this.current;
        const point = position && latticePoint(position);
        if (point) this.current = this.currentSector(point);
        const wanted = this.wanted(point);
        for (const id of wanted) if (this.states.has(id)) this.states.get(id).wantedAt = now;
        const unload = this.unloads(wanted, now);
        const load = this.nextLoad(wanted, now, unload), changed = this.current !== before;
        return { current: this.current, changed, load, unload, wakeAt: load.length ? now : this.wakeTime(wanted) };
    }

    wakeTime(wanted) {
        let earliest = Infinity;
        for (const [id, state] of this.states)
            if (!wanted.includes(id)) earliest = Math.min(earliest, state.wantedAt + this.options.keepSeconds);
            else if (state.phase === 'failed') earliest = Math.min(earliest, state.retryAt);
        return earliest;
    }

    /** Paper 004 §5.2.3: the current sector and its neighbours are tested; everything known only after a jump. */
    currentSector(point) {
        const current = this.sectors.get(this.current);
        if (current?.ground) {
            if (hasInside(current, point)) return current.id;
            const around = firstLevel(current).map(id => this.sectors.get(id));
            const next = around.find(sector => sector && hasInside(sector, point));
            if (next) return distanceToEdges(current.ground, point) > kGateHysteresisMm ? next.id : current.id;
        }
        for (const sector of this.sectors.values()) if (hasInside(sector, point)) return sector.id;
        return this.current;
    }

    /** Ids that should be there, the most urgent first. Off every known ground: what might hold the visitor, too. */
    wanted(point) {
        const current = this.sectors.get(this.current);
        if (!current) return [];
        const ids = firstLevel(current).filter(id => this.sectors.has(id));
        if (!point) return ids;
        if (current.ground && !hasInside(current, point))
            for (const sector of this.sectors.values())
                if (!sector.ground && boxContains(sector.box, point) && !ids.includes(sector.id)) ids.push(sector.id);
        const far = id => (id === this.current ? -1 : boxDistance(this.sectors.get(id).box, point));
        return ids.map(id => [far(id), id]).sort((a, b) => a[0] - b[0] || (a[1] < b[1] ? -1 : 1)).map(pair => pair[1]);
    }

    /** What was left longer ago than keepSeconds; over the cap, what was left the longest ago at once. */
    unloads(wanted, now) {
        const left = [...this.states].filter(([id]) => !wanted.includes(id)).sort((a, b) => a[1].wantedAt - b[1].wantedAt);
        let excess = this.liveShapes() - this.options.shapeCap;
        for (const id of wanted) if (!this.states.has(id)) excess += this.sectors.get(id).shapes;
        const unload = [];
        for (const [id, state] of left) {
            if (now - state.wantedAt < this.options.keepSeconds && excess <= 0) continue;
            excess -= this.shapesOf(id);
            this.states.delete(id);
            unload.push(id);
        }
        return unload;
    }

    nextLoad(wanted, now, unload) {
        const inFlight = [...this.states.values()].filter(state => state.phase === 'loading').length;
        if (inFlight >= this.options.loadsInFlight) return [];
        for (const id of wanted) {
            const state = this.states.get(id);
            if (unload.includes(id) || (state && (state.phase !== 'failed' || now < state.retryAt))) continue;
            const fits = this.liveShapes() + this.sectors.get(id).shapes <= this.options.shapeCap;
            if (!state && !fits && id !== this.current) return [];
            this.states.set(id, { phase: 'loading', wantedAt: now, failures: state?.failures ?? 0, retryAt: 0 });
            return [id];
        }
        return [];
    }

    shapesOf(id) {
        return this.sectors.get(id).shapes;
    }

    /** Shape nodes of everything asked for and not given back. */
    liveShapes() {
        let shapes = 0;
        for (const id of this.states.keys()) shapes += this.shapesOf(id);
        return shapes;
    }
}

function hasInside(sector, point) {
    return sector.ground !== null && boxContains(sector.box, point) && isInside(sector.ground, point);
}
