import { distance } from './planGeometry.js';

/** mm a visitor is followed along his wish, as if no body were there, to find where he wants to get. */
const kReachMm = 8000;
const kStepMm = 200;
/** mm by which the way may lie beside the straight one; more than half a fountain. */
const kAsideMm = 3000;
/** mm of clearance that may be missing: a visitor who touches a body stands on the edge of what is free. */
const kTouchMm = 30;
/** A way longer than this many times the straight one is no way round. */
const kLongest = 4;

/**
 * The way round the bodies that stop a visitor, as a person would take it: where would he be if they were not there,
 * and what is the shortest way there that touches nothing?
 *
 * Frame   plan lattice, mm. `towards` is a unit vector.
 * Returns points after `from`, each reached from the one before in a straight line; null when a wall stops him anyway.
 *         Where bodies and walls leave no room, the way leads past the walls and through the bodies: a lamp in a
 *         passage shuts nobody in.
 * Cost    kAsideMm and kReachMm bound the cells that are looked at: 4000 at most.
 */
export function detourRound(walls, from, towards) {
    const straight = wayWithoutBodies(walls, from, towards);
    if (!straight) return null;
    return shortestWay(walls, from, straight.at(-1), kLongest * kStepMm * straight.length) ?? straight;
}

/** mm to a side within which a corner is rounded: a visitor's width and a little. */
const kShiftsMm = [200, 400, 600, 800];
/** mm that must be free beyond the corner. */
const kBeyondMm = 700;
const kGetsThere = 0.9;

/**
 * The way round a corner that catches a visitor who walks into a wall less than a step from its end: aside, then on.
 * Null where there is none: a wall ends the way.
 */
export function cornerRound(walls, from, towards) {
    for (const shift of kShiftsMm)
        for (const side of [1, -1]) {
            const aside = [from[0] + side * shift * towards[1], from[1] - side * shift * towards[0]];
            const at = walls.constrain(from, aside);
            if (distance(at, aside) > (1 - kGetsThere) * shift) continue;
            const beyond = [at[0] + kBeyondMm * towards[0], at[1] + kBeyondMm * towards[1]];
            const end = walls.constrain(at, beyond);
            if (distance(end, beyond) <= (1 - kGetsThere) * kBeyondMm) return [at, end];
        }
    return null;
}

/** Steps along the walls until nothing is in the way; null where walls end it before. */
function wayWithoutBodies(walls, from, towards) {
    const open = walls.withoutBodies(), way = [];
    for (let at = from; way.length * kStepMm < kReachMm;) {
        const next = open.constrain(at, [at[0] + kStepMm * towards[0], at[1] + kStepMm * towards[1]]);
        if (distance(at, next) < kStepMm / 4) return null;
        way.push(at = next);
        if (isOffBodies(walls, at)) return way;
    }
    return null;
}

function isOffBodies(walls, point) {
    return walls.bodies.every(({ at, radius }) => distance(at, point) >= radius + walls.radius);
}

/** Over a grid that has `from` on a corner: eight neighbours, nearest first; then pulled straight. */
function shortestWay(walls, from, to, longest) {
    const near = walls.around(from, distance(from, to) + kAsideMm + 2 * walls.radius);
    const isFree = point => walls.clearance(point, ...near) >= walls.radius - kTouchMm && walls.isOnGround(point);
    const pointOf = ([i, j]) => [from[0] + kStepMm * i, from[1] + kStepMm * j];
    const isInReach = point => distance(from, point) + distance(point, to) <= distance(from, to) + 2 * kAsideMm;
    const reached = new Map([['0,0', { cell: [0, 0], cost: 0, before: null }]]), rim = [reached.get('0,0')], done = new Set();
    while (rim.length) {
        const here = takeNearest(rim);
        if (done.has(String(here.cell))) continue;
        done.add(String(here.cell));
        const at = pointOf(here.cell);
        if (distance(at, to) <= kStepMm * Math.SQRT1_2 && here.cost > 0)
            return here.cost <= longest ? pulledStraight(from, [...trace(here).map(pointOf), to], isFree) : null;
        for (const [di, dj] of kNeighbours) {
            const cell = [here.cell[0] + di, here.cell[1] + dj], key = String(cell), point = pointOf(cell);
            const cost = here.cost + kStepMm * Math.hypot(di, dj);
            if (done.has(key) || cost >= (reached.get(key)?.cost ?? Infinity) || !isInReach(point)) continue;
            if (!reached.has(key) && !isFree(point)) {
                done.add(key);
                continue;
            }
            const entry = { cell, cost, before: here };
            reached.set(key, entry);
            rim.push(entry);
        }
    }
    return null;
}

const kNeighbours = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1]];

function takeNearest(rim) {
    let best = 0;
    for (let i = 1; i < rim.length; ++i) if (rim[i].cost < rim[best].cost) best = i;
    return rim.splice(best, 1)[0];
}

/** Cells from the first after the start to `end`. */
function trace(end) {
    const cells = [];
    for (let entry = end; entry.before; entry = entry.before) cells.unshift(entry.cell);
    return cells;
}

/** Leaves out each point that is not needed: the next ones are reached straight. */
function pulledStraight(from, way, isFree) {
    const out = [];
    for (let at = from, i = 0; i < way.length;) {
        let last = i;
        while (last + 1 < way.length && isClear(at, way[last + 1], isFree)) ++last;
        out.push(at = way[last]);
        i = last + 1;
    }
    return out;
}

function isClear(a, b, isFree) {
    const steps = Math.ceil(distance(a, b) / (kStepMm / 2));
    for (let i = 1; i < steps; ++i)
        if (!isFree([a[0] + (b[0] - a[0]) * i / steps, a[1] + (b[1] - a[1]) * i / steps])) return false;
    return true;
}
