import { boxContains, distance, isInside, latticePoint, nearestOnSegment, orient, segmentsMeet } from './planGeometry.js';

/** mm: a visitor's half width in plan. */
export const kVisitorRadiusMm = 300;
const kPushes = 6;
/** mm a clearance may be short after pushing: six pushes in a corner converge to less than this. */
const kClearanceSlackMm = 2;
/** mm within which a visitor off every ground is taken back onto it. */
const kRescueMm = 5000;
/** mm that a door's line may lie off the wall it stands in; that its threshold reaches to both sides. */
const kDoorOffMm = 12, kThresholdMm = 60;

/**
 * What stops a visitor in plan. Walls: every ground edge of the sectors that are there, but the gates between two of
 * them, and the doors between two of them that are open. Bodies: what stands on the ground (a trunk, a lamp, a bench), each a disc.
 *
 * Frame   plan lattice, mm. A wall has its ground on the left.
 * Needs   sectors with ground (sectorFromRecord); a gate's edges are edges of the ground, same vertices.
 * Holds   constrain(p, q) is on the ground, no wall lies between p and it, and it keeps `radius` from every wall and
 *         body, or p's own clearance where p has less: a walker in a crack may leave it.
 */
export class GroundWalls {
    /** `open`: ids of doors that let people through. */
    constructor(sectors, radius = kVisitorRadiusMm, open = []) {
        const there = new Set(sectors.map(sector => sector.id));
        this.radius = radius;
        this.sectors = sectors;
        const doors = sectors.flatMap(sector => sector.doors ?? []).filter(door => open.includes(door.id) && there.has(door.to));
        this.thresholds = doors.map(thresholdOf);
        this.walls = sectors.flatMap(sector => withoutDoors(wallsOf(sector, there), doors.filter(door => door.from === sector.id)));
        this.bodies = sectors.flatMap(sector => sector.bodies);
    }

    /** The same walls and no bodies. */
    withoutBodies() {
        return Object.assign(Object.create(GroundWalls.prototype), this, { bodies: [] });
    }

    isOnGround(point) {
        const at = point.map(Math.round);
        return this.sectors.some(sector => boxContains(sector.box, at) && isInside(sector.ground, at))
            || this.thresholds.some(ring => isInside([ring], at));
    }

    /** Distance to the nearest wall or body; below 0 within a body. */
    clearance(point, walls = this.walls, bodies = this.bodies) {
        let least = Infinity;
        for (const [a, b] of walls) least = Math.min(least, distance(nearestOnSegment(a, b, point), point));
        for (const { at, radius } of bodies) least = Math.min(least, distance(at, point) - radius);
        return least;
    }

    /** What lies within `reach` of a point: [walls, bodies]. */
    around(point, reach) {
        return [
            this.walls.filter(([a, b]) => distance(nearestOnSegment(a, b, point), point) <= reach),
            this.bodies.filter(({ at, radius }) => distance(at, point) - radius <= reach)];
    }

    /** Where a visitor who wants to go from `from` to `to` gets: as far as the walls let, sliding along them. */
    constrain(from, to) {
        if (!this.isOnGround(from)) return this.rescue(from);
        const near = this.around(from, distance(from, to) + 2 * this.radius);
        const steps = Math.max(1, Math.ceil(distance(from, to) / (this.radius / 2)));
        const step = [(to[0] - from[0]) / steps, (to[1] - from[1]) / steps];
        let at = from;
        for (let i = 0; i < steps; ++i) {
            const next = this.stepTo(at, [at[0] + step[0], at[1] + step[1]], near);
            if (next === at) break;
            at = next;
        }
        return at;
    }

    stepTo(at, goal, [walls, bodies]) {
        const needed = Math.min(this.radius, this.clearance(at, walls, bodies)) - kClearanceSlackMm;
        for (const share of [1, 0.5, 0.25]) {
            const aim = [at[0] + share * (goal[0] - at[0]), at[1] + share * (goal[1] - at[1])];
            const pushed = this.pushOut(at, aim, walls, bodies);
            if (walls.every(([a, b]) => !segmentsMeet(at, pushed, a, b) || touches(a, b, at))
                && this.clearance(pushed, walls, bodies) >= needed && this.isOnGround(pushed)) return pushed;
        }
        return at;
    }

    /** `goal` moved off every wall and body it comes too near, to the side of a wall that `at` is on. */
    pushOut(at, goal, walls, bodies) {
        let point = goal;
        for (let i = 0; i < kPushes; ++i) {
            const before = point;
            for (const body of bodies) point = pushOffBody(body, point, this.radius);
            for (const [a, b] of walls) point = pushOff(a, b, at, point, this.radius);
            if (point === before) break;
        }
        return point;
    }

    /** Off the ground (a fall, a jump into a house): onto it again when it is near, else where one is. */
    rescue(from) {
        let best = from, least = kRescueMm;
        for (const [a, b] of this.sectors.flatMap(edgesOf)) {
            const near = nearestOnSegment(a, b, from), gap = distance(near, from), length = distance(a, b);
            if (gap >= least || length === 0) continue;
            const inward = [-(b[1] - a[1]) / length * this.radius, (b[0] - a[0]) / length * this.radius];
            const inside = [near[0] + inward[0], near[1] + inward[1]];
            if (this.isOnGround(inside)) [best, least] = [inside, gap];
        }
        return best;
    }
}

function edgesOf(sector) {
    return sector.ground.flatMap(ring => ring.map((point, i) => [point, ring[(i + 1) % ring.length]]));
}

function wallsOf(sector, there) {
    const open = new Set();
    for (const gate of sector.gates)
        if (there.has(gate.to))
            for (let i = 1; i < gate.line.length; ++i) open.add(`${gate.line[i - 1]},${gate.line[i]}`);
    return edgesOf(sector).filter(([a, b]) => !open.has(`${a},${b}`));
}

/** Walls with gaps where doors stand open: a wall's points and a door's line agree within kDoorOffMm. */
function withoutDoors(walls, doors) {
    return doors.reduce((left, { line }) => left.flatMap(wall => cutBy(wall, line)), walls);
}

function cutBy([a, b], [p, q]) {
    const length = distance(a, b), along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    const shareOf = point => ((point[0] - a[0]) * along[0] + (point[1] - a[1]) * along[1]) / length;
    const from = Math.max(0, shareOf(p)), to = Math.min(1, shareOf(q));
    if (!(from < to)) return [[a, b]];
    const at = share => [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])];
    if (distance(nearestOnSegment(p, q, at((from + to) / 2)), at((from + to) / 2)) > kDoorOffMm) return [[a, b]];
    return [[a, at(from)], [at(to), b]].filter(([c, d]) => distance(c, d) >= 1);
}

/** Ground under a door: where roundings leave a crack between two grounds. */
function thresholdOf({ line: [a, b] }) {
    const length = distance(a, b), out = [(b[1] - a[1]) / length * kThresholdMm, -(b[0] - a[0]) / length * kThresholdMm];
    return [[a[0] + out[0], a[1] + out[1]], [b[0] + out[0], b[1] + out[1]], [b[0] - out[0], b[1] - out[1]], [a[0] - out[0], a[1] - out[1]]]
        .map(corner => corner.map(Math.round));
}

function pushOff(a, b, at, point, radius) {
    const near = nearestOnSegment(a, b, point);
    const east = point[0] - near[0], north = point[1] - near[1], gap = Math.hypot(east, north);
    const side = Math.sign(orient(a, b, at)) || 1;
    const isThrough = orient(a, b, point) * side < 0 && segmentsMeet(at, point, a, b);
    if (gap >= radius && !isThrough) return point;
    if (gap > 0 && !isThrough) return [near[0] + east / gap * radius, near[1] + north / gap * radius];
    const length = distance(a, b) || 1;
    return [near[0] - side * (b[1] - a[1]) / length * radius, near[1] + side * (b[0] - a[0]) / length * radius];
}

function pushOffBody({ at, radius }, point, gap) {
    const east = point[0] - at[0], north = point[1] - at[1], far = Math.hypot(east, north);
    if (far >= radius + gap || far === 0) return point;
    return [at[0] + east / far * (radius + gap), at[1] + north / far * (radius + gap)];
}

function touches(a, b, point) {
    return distance(nearestOnSegment(a, b, point), point) === 0;
}

/** Metres in, metres out. */
export function constrainMetres(walls, from, to) {
    const end = walls.constrain(latticePoint(from), [to[0] * 1000, to[1] * 1000]);
    return [end[0] / 1000, end[1] / 1000];
}
