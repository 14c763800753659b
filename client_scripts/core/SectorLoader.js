import { GateImpostors } from './GateImpostors.js';
import { SectorPlanner } from './SectorPlanner.js';
import { idOf, levelOf } from './sectorRecord.js';

/**
 * The loop of paper 004 §5: watches the visitor, does what the planner says, hears what became of it.
 *
 * Needs   `sectors` shows and hides files by their stems: show(stem, origin), hide(stem), phase(stem), record(stem), links(stem);
 *         setImpostor(stem, gateId, opacity) where files have pictures in their gates.
 * Fails   never: a sector that cannot be had is reported to `complain` and asked for again later.
 */
export class SectorLoader {
    constructor(start, sectors, { complain = () => {}, ...options } = {}) {
        this.planner = new SectorPlanner(start, options);
        this.sectors = sectors;
        this.complain = complain;
        this.loading = new Set();
        this.impostors = new GateImpostors((stem, gate, opacity) => this.sectors.setImpostor?.(stem, gate, opacity));
        this.isFading = false;
    }

    /** One frame. `position` in plan metres or null, `now` in seconds, `visitor` as in plan(). Returns the planner's plan. */
    step(position, now, visitor) {
        for (const stem of [...this.loading]) this.collect(stem, now);
        const plan = this.planner.plan(position, now, visitor);
        for (const stem of plan.unload) {
            this.loading.delete(stem);
            this.sectors.hide(stem);
        }
        for (const stem of plan.load) {
            this.loading.add(stem);
            this.sectors.show(stem, this.planner.sectors.get(idOf(stem)).origin);
        }
        const { states, sectors } = this.planner;
        this.isFading = this.impostors.step(now, sectors, stem => states.get(stem)?.phase === 'live');
        return plan;
    }

    collect(stem, now) {
        const phase = this.sectors.phase(stem);
        if (phase === 'loading' || phase === 'absent') return;
        this.loading.delete(stem);
        try {
            if (phase === 'failed') throw new Error(`sector ${stem} cannot be fetched`);
            this.planner.arrived(stem, this.recordOf(stem));
        } catch (error) {
            this.complain(error.message);
            this.planner.failed(stem, now);
        }
    }

    /** A near file has its record; a far one may tell where it leads, a tall one nothing. */
    recordOf(stem) {
        const level = levelOf(stem);
        if (level === 'near') return this.sectors.record(stem);
        return level === 'far' ? this.sectors.links(stem) : null;
    }
}
