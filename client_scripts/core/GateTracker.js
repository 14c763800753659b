import { boxContains, distanceToLine, orient, segmentsMeet } from './planGeometry.js';

/** Sectors that a visitor may pass in one step; more means that his way goes in a circle. */
const kMostPassed = 64;

/**
 * Point in gate, paper 004 §5.2.3: a gate is two half-gates, and the order in which they are entered tells the direction.
 * A half-gate here is one side of a gate's line: whoever's step meets the line and ends on the outer side has passed.
 * `sector` changes with the line; `current`, what is reported, when the visitor leaves the gate's box, `marginMm` deep.
 *
 * Frame   plan lattice. A gate's line has its own sector's ground on the left.
 * Cost    the gates of the current sector, and of each one that is passed.
 * Differs the paper samples two ProximitySensors once a frame, and who runs through both between two frames is lost; here
 *         the whole step counts. A step through the end of a line, where walls and other gates begin, is not decided.
 */
export class GateTracker {
    constructor(marginMm) {
        Object.assign(this, { marginMm, sector: null, passed: [] });   // gates from what is reported to `sector`, in order
    }

    /** The visitor is in a sector (null: in none that is known), reported is `current` until he is off their gate. */
    reset(sectorId, current) {
        const between = (current?.gates ?? []).filter(gate => gate.to === sectorId);
        Object.assign(this, { sector: sectorId, passed: between.slice(0, 1) });
    }

    /** The sector to report after a step, or null: gates alone cannot tell. */
    follow(sectors, current, from, to) {
        if (this.sector === null) return null;
        let at = 0;
        for (let i = 0; i < kMostPassed; ++i) {
            const sector = sectors.get(this.sector);
            if (!sector?.ground) return null;
            const pass = firstPass(sector.gates, from, to, at);
            if (pass === null) return boxContains(sector.box, to) ? this.report(current, to) : null;
            if (pass.isUnclear || !sectors.has(pass.gate.to)) return null;
            this.pass(current, pass.gate);
            at = pass.share;
        }
        return null;
    }

    /** Who comes back to a sector that he passed has passed nothing since. */
    pass(current, gate) {
        const seen = gate.to === current.id ? 0 : this.passed.findIndex(({ to }) => to === gate.to) + 1;
        if (seen > 0 || gate.to === current.id) this.passed.length = seen;
        else this.passed.push(gate);
        this.sector = gate.to;
    }

    /** Behind the last of the gates passed whose box he has left. */
    report(current, to) {
        if (this.sector === current.id) return current.id;
        let last = this.passed.length - 1;
        while (last >= 0 && distanceToLine(this.passed[last].line, to) <= this.marginMm) --last;
        if (this.passed.length === 0) return this.sector;
        const reported = last >= 0 ? this.passed[last].to : current.id;
        this.passed.splice(0, last + 1);
        return reported;
    }
}

/** The first gate that the step passes outwards at `at` or later: { gate, share, isUnclear }. */
function firstPass(gates, from, to, at) {
    let first = null;
    for (const gate of gates)
        for (let i = 1; i < gate.line.length; ++i) {
            const [a, b] = [gate.line[i - 1], gate.line[i]];
            const before = orient(a, b, from), after = orient(a, b, to);
            if (after >= 0 && before >= 0 && !(after === 0 && before === 0)) continue;   // stays on its inner side
            if (!segmentsMeet(from, to, a, b)) continue;
            const share = before === after ? at : before / (before - after);
            const isUnclear = orient(from, to, a) === 0 || orient(from, to, b) === 0;
            if ((share < at || after > 0) && !isUnclear) continue;                       // before, or comes in
            if (!first || share < first.share || isUnclear) first = { gate, share, isUnclear };
        }
    return first;
}
