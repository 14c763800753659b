import { boxDistance, distance, distanceToLine } from './planGeometry.js';

const kUrgency = { near: 0, far: 1, tall: 2 };
/** How much more what lies ahead counts than what lies aside; what lies behind counts as much less. */
const kAhead = 0.6;
/** mm: nearer than this everything fills the view alike. */
const kCloseMm = 5000;

/** < 0: a is asked for before b. Entries of loadEntry(); equal only where the stems are. */
export function compareLoads(a, b) {
    return a.ring - b.ring || a.urgency - b.urgency || a.cost - b.cost || (a.stem < b.stem ? -1 : 1);
}

/** The finer of two levels is the lesser. */
export function urgencyOf(level) {
    return kUrgency[level];
}

/**
 * What a file is worth to the visitor: rings from the inside outwards, near files before far ones before tall ones; then
 * near ones by the way to the gate, the others by size on screen; and what lies ahead, where he looks and where he
 * walks, before what lies behind.
 *
 * `visitor`: { point (mm), view, walk: unit vectors or null }.
 */
export function loadEntry(stem, { ring, level }, current, sector, visitor) {
    const ahead = aheadness(sector.box, visitor);
    const cost = level === 'near' ? gateDistance(current, sector, visitor.point) : 1 / sizeOnScreen(sector.box, visitor.point);
    return { stem, ring, level, urgency: kUrgency[level], cost: cost / ahead };
}

/** mm from the visitor to the nearest gate that leads there, else to the sector's box; -1: he is in it. */
export function gateDistance(current, sector, point) {
    if (sector.id === current.id) return -1;
    const lines = (current.gates ?? []).filter(gate => gate.to === sector.id).map(gate => gate.line);
    if (lines.length === 0) return boxDistance(sector.box, point);
    return Math.min(...lines.map(line => distanceToLine(line, point)));
}

/** Width of the box over its distance. */
function sizeOnScreen([west, south, east, north], point) {
    return Math.hypot(east - west, north - south) / Math.max(kCloseMm, boxDistance([west, south, east, north], point));
}

/** 1 + kAhead where he looks and walks straight at the box's middle, 1 - kAhead with it at his back. */
function aheadness([west, south, east, north], { point, view, walk }) {
    const middle = [(west + east) / 2, (south + north) / 2], far = distance(middle, point);
    const directions = [view, walk].filter(Boolean);
    if (far < kCloseMm || directions.length === 0) return 1;
    const cosines = directions.map(([x, y]) => ((middle[0] - point[0]) * x + (middle[1] - point[1]) * y) / far);
    return 1 + kAhead * cosines.reduce((sum, cosine) => sum + cosine, 0) / cosines.length;
}
