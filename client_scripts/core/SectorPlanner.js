import { LevelChoice } from './LevelChoice.js';
import { SectorFinder, hasInside } from './SectorFinder.js';
import { compareLoads, gateDistance, loadEntry, urgencyOf } from './loadOrder.js';
import { boxContains, distance, latticePoint } from './planGeometry.js';
import { idOf, levelOf, sectorFromLinks, sectorFromNeighbour, sectorFromRecord, stemOf } from './sectorRecord.js';
import { sectorsWithin } from './sectorSets.js';

/** s that a sector left behind stays as it was: a walker who turns round finds it there. */
const kKeepSeconds = 10;
/** s for those marked important: visitors come back to them (paper 004 §4.1.7). */
const kKeepImportantSeconds = 300;
/** Live Shape nodes, all levels of detail: beyond it X_ITE's own bookkeeping per node costs the frame. */
const kShapeCap = 1500;
/** A far or tall file is one merged Shape. */
const kMergedShapes = 1;
const kLoadsInFlight = 3;
const kRetrySeconds = [1, 2, 4, 8, 16, 30];
/** mm from a gate at which L_0 takes in what lies behind: a gate to nothing is shut. */
const kThresholdMm = 12000;
/** mm from a gate that he walks towards, at which L_1 takes in what is seen from behind it: else that is missing when he comes in. */
const kAheadMm = 20000;
/** s that he may stand still and is still taken for walking. */
const kWalkEndsSeconds = 3;
/** s between two frames, above which the browser slept. */
const kLongestFrame = 1;

/**
 * Says which sectors should be there, and which file of each: paper 004 §5.1 and §5.2, without knowing who shows them.
 *
 * The current sector and its gate neighbours are wanted near, what else is in L_i far or tall (sectorsWithin). Files go
 * by their stems. A sector that changes its level keeps the old file until the new one is there. What is on its way and
 * no longer wanted is given up at once.
 *
 * The owner calls plan() once per frame and does what it returns; it reports arrived(), failed().
 * Frame   positions and records in plan metres, [east, north]; times in seconds, never decreasing.
 * Needs   every stem given to arrived() or failed() was returned in `load` before.
 * Cost    the set only when the sector, i or what is known changes; its order when something is missing.
 * Differs L_0 holds the sector behind a gate too while the visitor stands near that gate; L_1 what is seen from behind a gate
 *         that he walks to; doors in use add L_i of both their sides.
 */
export class SectorPlanner {
    /**
     * `nearOnly`: the world has no far and tall files, near ones stand for them, and i is 1 at most. `level`: i to start
     * with, `limit`: the largest, `fixedLevel`: no choice; `test`: of SectorFinder. `filesAtOnce`: how many one request can
     * bring.
     */
    constructor(start, { keepSeconds = kKeepSeconds, shapeCap = kShapeCap, loadsInFlight = kLoadsInFlight, nearOnly = false,
        filesAtOnce = 1, level = 1, limit = 2, fixedLevel = null, test = 'polygon', marginMm } = {}) {
        this.options = { keepSeconds, shapeCap, loadsInFlight, nearOnly, filesAtOnce };
        this.requests = 0;
        this.wantedNow = new Map(); // stem -> { ring, level }, of the last plan
        this.sectors = new Map();   // id -> sector, ground null while only others have told of it
        this.states = new Map();    // stem -> { phase: loading | live | failed, request: its number, askedAt, wantedAt, failures, retryAt }
        this.current = start;
        this.finder = new SectorFinder(test, { marginMm });
        this.choice = new LevelChoice({ start: level, limit: nearOnly ? Math.min(limit, 1) : limit, fixed: fixedLevel });
        this.important = new Set();
        this.known = 0;             // grows with what is known
        this.beyondDoors = [];      // ids of sectors on both sides of doors in use: Doors.wanted
        this.last = { point: null, now: 0, isDisturbed: true, walk: null, movedAt: -Infinity };
        this.ahead = [];   // ids of sectors behind gates that he walks to
    }

    get i() {
        return this.options.nearOnly ? Math.min(this.choice.i, 1) : this.choice.i;
    }

    /** A place known from a neighbour's record or from the root world. Never forgets a ground. */
    addNeighbour(record) {
        this.addKnown([sectorFromNeighbour(record)]);
    }

    /** The file is shown; with a near one came its record, with a far one perhaps. Returns ids known for the first time. */
    arrived(stem, record) {
        const state = this.states.get(stem), level = levelOf(stem);
        const links = level === 'far' && record ? this.learnLinks(idOf(stem), record) : [];
        const fresh = level === 'near' ? this.learn(stem, record) : links;
        if (state) Object.assign(state, { phase: 'live', failures: 0 });
        this.last.isDisturbed = true;
        return fresh;
    }

    /** A whole record, with a near file or without. */
    learn(id, record) {
        return this.keep(id, sectorFromRecord(record));
    }

    learnLinks(id, record) {
        const sector = sectorFromLinks(record);
        return this.sectors.get(id)?.ground ? this.addKnown(sector.neighbours) : this.keep(id, sector);
    }

    keep(id, sector) {
        if (sector.id !== id) throw new Error(`asked for sector ${id}, the file's record says ${sector.id}`);
        this.sectors.set(id, sector);
        for (const other of sector.important ?? []) this.important.add(other);
        ++this.known;
        return this.addKnown(sector.neighbours);
    }

    addKnown(neighbours) {
        const fresh = neighbours.filter(neighbour => !this.sectors.has(neighbour.id));
        for (const neighbour of fresh) this.sectors.set(neighbour.id, neighbour);
        if (fresh.length) ++this.known;
        return fresh.map(neighbour => neighbour.id);
    }

    /** It could not be fetched or read: asked for again after 1, 2, 4, ... 30 s, for as long as it is wanted. */
    failed(stem, now) {
        const state = this.states.get(stem);
        const wait = kRetrySeconds[Math.min(state.failures, kRetrySeconds.length - 1)];
        Object.assign(state, { phase: 'failed', failures: state.failures + 1, retryAt: now + wait });
    }

    /**
     * -> { current, changed, level, load: stems, at most filesAtOnce, unload: stems, wakeAt }. `position` may be null: not known
     * yet. `heading`: radians clockwise from north; `isJump`: the visitor was put there; `waitSeconds`, `memoryShare`: of
     * LevelChoice, where the owner knows better.
     * Nothing changes before `wakeAt` (s, Infinity: never) unless the visitor moves or a file arrives or fails.
     */
    plan(position, now, { heading = null, isJump = false, waitSeconds = null, memoryShare = 0 } = {}) {
        const before = this.current, point = position && latticePoint(position), { i } = this;
        if (isJump) this.finder.jump();
        if (point) this.current = this.finder.find(this.sectors, this.current, point);
        this.observe(point, now);
        const wanted = this.wantedNow = this.wanted(point);
        for (const [stem, { wantedAt }] of this.states) if (wanted.has(stem) && wantedAt < now) this.states.get(stem).wantedAt = now;
        const unload = this.unloads(wanted, now), load = this.nextLoad(wanted, now, point, heading);
        this.chooseLevel(wanted, now, waitSeconds, memoryShare);
        const wakeAt = load.length || this.i !== i ? now : Math.min(this.wakeTime(wanted, now), this.choice.wakeAt);
        return { current: this.current, changed: this.current !== before, level: this.i, load, unload, wakeAt };
    }

    /** Time per frame counts while the visitor moves and nothing is put in; the way he walks is where he went last, until he rests. */
    observe(point, now) {
        const { last } = this, moved = point && last.point ? distance(point, last.point) : 0, seconds = now - last.now;
        if (moved > 0 && last.isMoving && !last.isDisturbed && seconds < kLongestFrame) this.choice.addFrame(seconds);
        const movedAt = moved > 0 ? now : last.movedAt, isResting = now >= movedAt + kWalkEndsSeconds;
        const walk = moved > 0 ? [(point[0] - last.point[0]) / moved, (point[1] - last.point[1]) / moved] : isResting ? null : last.walk;
        this.last = { point: point ?? last.point, now, isMoving: moved > 0, isDisturbed: false, walk, movedAt };
    }

    chooseLevel(wanted, now, waitSeconds, memoryShare) {
        const current = this.sectors.get(this.current), before = this.i;
        if (!current?.ground) return;
        let oldest = now, isSettled = true;
        for (const stem of wanted.keys()) {
            const state = this.states.get(stem);
            if (state?.phase === 'loading') oldest = Math.min(oldest, state.askedAt);
            if (!state || state.phase === 'loading') isSettled &&= this.isServedFiner(stem, now);
        }
        const shapes = this.liveShapes(), more = sectorsWithin(this.sectors, current, before + 1).size - wanted.size;
        this.choice.judge({ now, isSettled, waitSeconds: waitSeconds ?? now - oldest, shapes, memoryShare,
            nextShapes: shapes + Math.max(0, more) * kMergedShapes, shapeCap: this.options.shapeCap });
    }

    wakeTime(wanted, now) {
        let earliest = this.ahead.length ? this.last.movedAt + kWalkEndsSeconds : Infinity;
        for (const [stem, state] of this.states) {
            if (!wanted.has(stem)) earliest = Math.min(earliest, this.isRecent(stem, now) ? this.keptUntil(stem) : Infinity);
            else if (state.phase === 'failed') earliest = Math.min(earliest, state.retryAt);
        }
        return earliest;
    }

    /**
     * What should be there: stem -> { ring, level }. Off every known ground: what might hold the visitor, too. Before
     * the visitor's first position only his start: X_ITE binds a world's viewpoint, and so begins to show it, once
     * nothing of it is on its way.
     */
    wanted(point) {
        const current = this.sectors.get(this.current);
        if (!current) return new Map();
        if (!point) return new Map([[stemOf(current.id, 'near'), { ring: 0, level: 'near' }]]);
        this.ahead = this.behindGatesAhead(current, point);
        const set = new Map(this.setAround(current, this.ahead));
        const addNear = sector => { set.set(sector.id, { ring: 1, level: 'near' }); };
        if (this.i === 0)
            for (const sector of (current.gates ?? []).map(gate => this.sectors.get(gate.to)).filter(Boolean))
                if (gateDistance(current, sector, point) < kThresholdMm) addNear(sector);
        if (current.ground && !hasInside(current, point))
            for (const sector of this.sectors.values()) if (!sector.ground && boxContains(sector.box, point)) addNear(sector);
        const { nearOnly } = this.options;
        return new Map([...set].map(([id, { ring, level }]) => [stemOf(id, nearOnly ? 'near' : level), { ring, level }]));
    }

    setAround(current, ahead) {
        const key = [current.id, this.i, this.known, ...this.beyondDoors, '>', ...ahead].join(' ');
        if (this.set?.key !== key) this.set = { key, sectors: this.withWhatIsAhead(this.setWithDoors(current), ahead) };
        return this.set.sectors;
    }

    /** Ids of sectors that he comes to soon; with i = 2 all that they see is there anyway. */
    behindGatesAhead(current, point) {
        const { walk } = this.last;
        if (this.i !== 1 || !walk || this.options.nearOnly) return [];
        const isAhead = ({ line: [[x, y]] }) => (x - point[0]) * walk[0] + (y - point[1]) * walk[1] > 0;
        const near = (current.gates ?? []).filter(gate => gate.to && isAhead(gate) && gateDistance(current, { id: gate.to }, point) < kAheadMm);
        return [...new Set(near.map(({ to }) => to))].filter(id => this.sectors.get(id)?.ground);
    }

    /** What those see, after all that is seen from here, and far: it is near when he is there. */
    withWhatIsAhead(set, ahead) {
        for (const id of ahead)
            for (const [other, { level }] of sectorsWithin(this.sectors, this.sectors.get(id), 1))
                if (!set.has(other)) set.set(other, { ring: 2, level: level === 'near' ? 'far' : level });
        return set;
    }

    /** L_i, and L_i of what is behind doors in use: these first, because somebody waits for them. */
    setWithDoors(current) {
        const set = sectorsWithin(this.sectors, current, this.i);
        for (const id of this.beyondDoors) {
            const behind = this.sectors.get(id);
            if (!behind) continue;
            for (const [other, { ring, level }] of sectorsWithin(this.sectors, behind, this.i)) {
                const there = set.get(other);
                if (!there || urgencyOf(level) < urgencyOf(there.level)) set.set(other, { ring: Math.min(ring, there?.ring ?? ring), level });
            }
        }
        return set;
    }

    /**
     * What is on its way for nothing; what another file of the same sector has replaced; what was left longer ago than
     * it is kept; over the cap, what was left the longest ago at once.
     */
    unloads(wanted, now) {
        const stemFor = new Map([...wanted.keys()].map(stem => [idOf(stem), stem]));
        const left = [...this.states].filter(([stem]) => !wanted.has(stem)).sort((a, b) => a[1].wantedAt - b[1].wantedAt);
        let excess = this.excessShapes(wanted);
        const unload = [];
        for (const [stem, state] of left) {
            const instead = stemFor.get(idOf(stem));
            const isKept = state.phase === 'live'
                && (instead ? this.states.get(instead)?.phase !== 'live' : this.isRecent(stem, now) && excess <= 0);
            if (isKept) continue;
            excess -= this.shapesOf(stem);
            this.states.delete(stem);
            unload.push(stem);
        }
        return unload;
    }

    keptUntil(stem) {
        const seconds = this.important.has(idOf(stem)) ? kKeepImportantSeconds : this.options.keepSeconds;
        return this.states.get(stem).wantedAt + Math.max(seconds, this.options.keepSeconds);
    }

    isRecent(stem, now) {
        return now < this.keptUntil(stem);
    }

    /** A finer file that was needed a moment ago serves for as long as that is kept anyway. */
    isServedFiner(stem, now) {
        return ['near', 'far'].some(level => {
            const finer = stemOf(idOf(stem), level);
            return urgencyOf(level) < urgencyOf(levelOf(stem)) && this.states.get(finer)?.phase === 'live' && this.isRecent(finer, now);
        });
    }

    /** One request: the file of the sector he is in alone, others as many together as the owner can ask for at once. */
    nextLoad(wanted, now, point, heading) {
        const { loadsInFlight, filesAtOnce, shapeCap } = this.options, loading = [...this.states].filter(([, { phase }]) => phase === 'loading');
        if (new Set(loading.map(([, { request }]) => request)).size >= loadsInFlight) return [];
        const isFull = this.excessShapes(wanted) > 0, load = [];
        let outermost = this.outermostRing(loading.map(([stem]) => stem), wanted);
        ++this.requests;
        for (const { stem } of this.missing(wanted, now, point, heading)) {
            const state = this.states.get(stem), isHere = stem === this.current;
            if (load.length >= filesAtOnce || wanted.get(stem).ring > outermost) break;
            if (!state && !isFull && this.isServedFiner(stem, now)) continue;
            const fits = this.liveShapes() + this.shapesOf(stem) <= shapeCap;
            if (!state && !fits && !isHere && !this.isCoarser(stem)) break;
            this.states.set(stem, { phase: 'loading', request: this.requests, askedAt: now, wantedAt: now, failures: state?.failures ?? 0, retryAt: 0 });
            load.push(stem);
            if (isHere) break;
            if (load.length === 1) outermost = Math.min(outermost, this.outermostRing(load, wanted));
        }
        return load;
    }

    /**
     * Files of a ring tell what there is in the next: where many come by one request, the next ring waits for them, so that it
     * takes one request, too.
     */
    outermostRing(loading, wanted) {
        if (this.options.filesAtOnce === 1) return Infinity;
        return Math.max(1, Math.min(...loading.map(stem => wanted.get(stem)?.ring ?? Infinity)));
    }

    /** What is wanted and neither there nor on its way, the most urgent first. */
    missing(wanted, now, point, heading) {
        const missing = [...wanted].filter(([stem]) => {
            const state = this.states.get(stem);
            return !state || (state.phase === 'failed' && now >= state.retryAt);
        });
        if (!point) return missing.map(([stem]) => ({ stem }));
        const current = this.sectors.get(this.current), view = heading === null ? null : [Math.sin(heading), Math.cos(heading)];
        const visitor = { point, view, walk: this.last.walk };
        return missing.map(([stem, place]) => loadEntry(stem, place, current, this.sectors.get(idOf(stem)), visitor)).sort(compareLoads);
    }

    /** < 0: the file of stem `a` is needed before that of `b`, as the last plan wants them; 0: alike. */
    compareNeed(a, b) {
        const [first, second] = [a, b].map(stem => this.wantedNow.get(stem) ?? { ring: Infinity, level: levelOf(stem) });
        return first.ring === second.ring ? urgencyOf(first.level) - urgencyOf(second.level) : first.ring - second.ring;
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
        let missing = 0;
        for (const stem of wanted.keys()) if (!this.states.has(stem)) missing += this.shapesOf(stem);
        return this.liveShapes() + missing - this.options.shapeCap;
    }
}
