import { distance, distanceToLine } from './planGeometry.js';

/** s: light behind a door that is being asked for; a leaf that opens, that shuts. */
const kLightSeconds = 0.5, kOpenSeconds = 1.6, kShutSeconds = 1.2;
/** Share of the way from which on a leaf lets somebody through. */
const kPassable = 0.6;
/** mm: who is so near is in the doorway; so far behind a door is deep inside, as long as the room is not smaller. */
const kDoorwayMm = 1000, kDeepMm = 1500, kDeepShare = 0.6;
/** mm: who came so near may walk through; who is so far again does not. */
const kComeMm = 4000, kGoneMm = 8000;
/** s until a door shuts before which nobody came; until one is given up behind which nothing can be had. */
const kWaitSeconds = 40, kGiveUpSeconds = 30;
/** mm within which a door can be opened without a click on it. */
export const kReachMm = 4000;

/**
 * The doors around the visitor, paper 004 §5.2.3 and Fig. 7. A click asks for what is behind: the pane turns clear and a
 * light goes on; the leaf opens once that is there; when the visitor is deep inside, or goes away, it shuts, and what
 * the door kept there is no longer wanted.
 *
 * A door is two records, one on each side, which move together; a state is kept for doors that are not at rest:
 * loading -> opening -> open -> shutting -> at rest.
 *
 * Needs   `show(stem, doorId, look)` for doors of sectors whose near file is live; look: { angle: share open, light, isBare:
 *         what is behind is there, no picture needed }, shares 0 ... 1.
 * Frame   plan lattice, mm; times in seconds, never decreasing.
 * Differs what was left stays as long as L_i keeps it (SectorPlanner), where e-Agora released it at once.
 */
export class Doors {
    constructor(show) {
        this.show = show;
        this.states = new Map();   // pair -> { phase, door, from, askedAt, openAt, angle, light, hasCome }
        this.shown = new Map();    // door id -> what it looks like
        this.last = null;
    }

    /** A click on either side of a door: opens it, or shuts it. `current`: where the visitor is. */
    touch(door, current, now) {
        const state = this.states.get(pairOf(door));
        if (!state)
            this.states.set(pairOf(door), { phase: 'loading', door, from: current, askedAt: now, openAt: 0, angle: 0, light: 0, hasCome: false });
        else if (state.phase === 'shutting') Object.assign(state, { phase: 'opening', from: current });
        else if (state.phase === 'open') state.phase = 'shutting';
    }

    /** Sectors on both sides of every door that is not at rest: wanted, besides what the visitor sees otherwise. */
    get wanted() {
        return [...new Set([...this.states.values()].flatMap(({ door }) => [door.from, door.to]))];
    }

    /** Ids of door sides that let the visitor through. */
    get open() {
        return [...this.states.values()].filter(({ angle }) => angle >= kPassable).flatMap(({ door }) => [door.id, door.twin]);
    }

    /**
     * The door of the visitor's sector within reach that he means, as { door, isShut }, or null: the nearest, one at his
     * back counting as three times as far. `heading`: radians clockwise from north.
     */
    near(point, sector, heading) {
        let best = null, least = Infinity;
        for (const door of sector?.doors ?? []) {
            const far = distanceToLine(door.line, point), [east, north] = middleOf(door.line).map((value, i) => value - point[i]);
            const ahead = (east * Math.sin(heading) + north * Math.cos(heading)) / (Math.hypot(east, north) || 1);
            if (far <= kReachMm && far * (2 - ahead) < least) [best, least] = [door, far * (2 - ahead)];
        }
        return best && { door: best, isShut: !this.states.has(pairOf(best)) };
    }

    /**
     * One frame. `point`: the visitor, or null; `current`: his sector; `sectors`: id -> sector of the core; `isLive(stem)`.
     * Returns whether something moves, so that another frame is needed.
     */
    step(now, point, current, sectors, isLive) {
        const seconds = this.last === null ? 0 : Math.max(0, now - this.last);
        this.last = now;
        for (const [pair, state] of this.states) {
            advance(state, now, seconds, point, current, sectors, isLive);
            if (state.phase === 'rest') this.states.delete(pair);
        }
        this.paint(sectors, isLive);
        return [...this.states.values()].some(isMoving);
    }

    paint(sectors, isLive) {
        for (const sector of sectors.values()) {
            if (!sector.doors?.length) continue;
            const isThere = isLive(sector.id);
            for (const door of sector.doors) {
                if (!isThere) {
                    this.shown.delete(door.id);
                    continue;
                }
                const { angle = 0, light = 0 } = this.states.get(pairOf(door)) ?? {}, look = { angle, light, isBare: isLive(door.to) };
                const before = this.shown.get(door.id) ?? { angle: 0, light: 0, isBare: false };
                if (before.angle !== angle || before.light !== light || before.isBare !== look.isBare) this.show(sector.id, door.id, look);
                this.shown.set(door.id, look);
            }
        }
    }
}

function pairOf({ id, twin }) {
    return id < twin ? id : twin;
}

function isMoving({ phase, light }) {
    return phase === 'opening' || phase === 'shutting' || light < 1;
}

function advance(state, now, seconds, point, current, sectors, isLive) {
    const { door } = state, far = point ? distanceToLine(door.line, point) : Infinity;
    const towards = (value, goal, time) => (value < goal ? Math.min(goal, value + seconds / time) : Math.max(goal, value - seconds / time));
    state.light = towards(state.light, state.phase === 'shutting' ? 0 : 1, kLightSeconds);
    if (state.phase === 'loading') {
        if (isLive(door.from) && isLive(door.to)) state.phase = 'opening';
        else if (now - state.askedAt > kGiveUpSeconds) state.phase = 'shutting';
    }
    if (state.phase === 'opening') {
        state.angle = towards(state.angle, 1, kOpenSeconds);
        if (state.angle === 1) Object.assign(state, { phase: 'open', openAt: now });
    }
    if (state.phase === 'open') {
        state.hasCome ||= far < kComeMm;
        const isThrough = current !== state.from && far > deepBehind(door, sectors.get(current));
        const isGone = state.hasCome ? far > kGoneMm : now - state.openAt > kWaitSeconds;
        if (isThrough || isGone) state.phase = 'shutting';
    }
    if (state.phase === 'shutting') {
        if (far < kDoorwayMm && state.angle > 0) Object.assign(state, { phase: 'opening', from: current });
        else state.angle = towards(state.angle, 0, kShutSeconds);
        if (state.angle === 0 && state.light === 0) state.phase = 'rest';
    }
}

/** mm behind the door at which somebody is deep inside. */
function deepBehind({ line }, sector) {
    if (!sector?.ground) return kDeepMm;
    const middle = middleOf(line);
    return Math.min(kDeepMm, kDeepShare * Math.max(...sector.ground[0].map(corner => distance(corner, middle))));
}

function middleOf([a, b]) {
    return [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
}

/** How a leaf turns, rad: inwards, and farther than square to the wall. */
const kWide = 1.75;

/**
 * Makes the nodes of a door (x3d_export/door_nodes) look so. `find(name)` -> node of the sector's scene; `rotation(x, y, z,
 * angle)`, `color(r, g, b)` -> values of the browser's.
 */
export function paintDoor(id, { angle, light, isBare }, { find, rotation, color }) {
    const smooth = angle * angle * (3 - 2 * angle);
    find(`DOOR-LEAF-${id}`).rotation = rotation(0, 1, 0, -kWide * smooth);
    find(`DOOR-GLASS-${id}`).transparency = 0.35 + 0.45 * light;
    find(`DOOR-LAMP-${id}`).emissiveColor = color(0.42 * light, 0.36 * light, 0.24 * light);
    find(`DOOR-BEYOND-${id}`).visible = !isBare;
}
