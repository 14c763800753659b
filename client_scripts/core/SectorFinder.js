import { GateTracker } from './GateTracker.js';
import { boxContains, distance, distanceToEdges, distanceToLine, isInside } from './planGeometry.js';
import { depthInBox, tightBox } from './tightBox.js';

/** mm beyond the current sector at which another becomes current: a step back at a gate changes nothing. */
export const kGateMarginMm = 500;
/** mm in one step that nobody walks in a frame: the visitor was put there. */
export const kJumpMm = 5000;

/**
 * Which sector the visitor is in, paper 004 §5.2, by one of three tests:
 *
 * polygon  exact on the lattice (§5.2.1).
 * box      the tightest box round the ground, turned as the street runs (§5.2.2). Boxes of neighbours overlap.
 * gate     which gates he passes, in which direction (§5.2.3); boxes and polygons are asked after jumps alone.
 *
 * While he walks, the current sector and those behind its gates are tested; after a jump, or when none of them has him,
 * all that are known. A change fires `marginMm` beyond what is left: the scaled box, the scaled gate, and for polygons
 * the same distance from the ground. Where no ground holds him the current sector stays.
 *
 * Through doors, and inside, the polygons tell, whatever the test: boxes of streets hold the houses beside them.
 *
 * Frame   plan lattice, mm.
 * Error   polygon: none beyond the margin. box: none beyond the margin where one box alone holds him. gate: none beyond
 *         the margin as long as he walks.
 * Differs boxes and gates grow by a distance, not by a factor: long streets would keep him far into a square.
 */
export class SectorFinder {
    constructor(test = 'polygon', { marginMm = kGateMarginMm } = {}) {
        if (!(test in kTests)) throw new Error(`there is no sector test '${test}': polygon, box and gate are there`);
        Object.assign(this, { test, marginMm, last: null, gates: new GateTracker(marginMm) });
    }

    /** The visitor is put elsewhere, however near: all that are known are tested next. */
    jump() {
        this.last = null;
    }

    /** The id of the sector at `point`; `sectors`: id -> sector (sectorRecord.js). */
    find(sectors, currentId, point) {
        const isJump = this.last === null || distance(this.last, point) > kJumpMm;
        const indoors = this.findIndoors(sectors, sectors.get(currentId), point, isJump);
        const found = indoors ?? kTests[this.test](this, sectors, sectors.get(currentId), point, isJump);
        if (indoors) this.gates.reset(indoors, sectors.get(indoors));
        this.last = point;
        return found ?? currentId;
    }

    /** Where doors are in play: the sector that has him, by its ground whatever the test; null: no door matters. */
    findIndoors(sectors, current, point, isJump) {
        if (isJump) return [...sectors.values()].find(sector => sector.isInterior && hasInside(sector, point))?.id ?? null;
        if (!current?.ground) return null;
        for (const { to, line } of current.doors ?? []) {
            const behind = sectors.get(to);
            if (behind && hasInside(behind, point) && !hasInside(current, point))
                return distanceToLine(line, point) > this.marginMm ? behind.id : current.id;
        }
        return current.isInterior && hasInside(current, point) ? current.id : null;
    }
}

const kTests = {
    polygon({ marginMm }, sectors, current, point, isJump) {
        if (current?.ground && hasInside(current, point)) return current.id;
        const next = current && !isJump ? behindGates(sectors, current).find(sector => hasInside(sector, point)) : null;
        const found = next ?? firstInside(sectors, point);
        if (!found || isJump || !current?.ground) return found?.id;
        return distanceToEdges(current.ground, point) > marginMm ? found.id : current.id;
    },

    box({ marginMm }, sectors, current, point, isJump) {
        if (current && !isJump && depthInBox(tightBox(current), point) >= -marginMm) return current.id;
        const near = current && !isJump ? deepest(behindGates(sectors, current), point) : null;
        return (near ?? deepest(sectors.values(), point))?.id;
    },

    gate({ gates, last, marginMm }, sectors, current, point, isJump) {
        const walked = current && last && !isJump ? gates.follow(sectors, current, last, point) : null;
        if (walked) return walked;
        const exact = current && hasInside(current, point) ? current : firstInside(sectors, point);
        gates.reset(exact?.id ?? null, current);
        return kTests.polygon({ marginMm }, sectors, current, point, isJump);
    },
};

export function hasInside(sector, point) {
    return sector.ground !== null && boxContains(sector.box, point) && isInside(sector.ground, point);
}

function behindGates(sectors, { gates = [] }) {
    return [...new Set(gates.map(gate => gate.to))].map(id => sectors.get(id)).filter(Boolean);
}

function firstInside(sectors, point) {
    for (const sector of sectors.values()) if (hasInside(sector, point)) return sector;
    return undefined;
}

/** The sector in whose box the point lies deepest. */
function deepest(sectors, point) {
    let best = null, most = 0;
    for (const sector of sectors) {
        if (!boxContains(sector.box, point)) continue;   // the ground's own box holds the ground
        const depth = depthInBox(tightBox(sector), point);
        if (depth >= most) [best, most] = [sector, depth];
    }
    return best;
}
