import { SectorPlanner } from '../core/SectorPlanner.js';

/**
 * The loop of paper 004 §5: watches the visitor, does what the planner says, hears what became of it.
 *
 * Needs   `sectors` shows and hides: show(id, origin), hide(id), phase(id), record(id).
 * Fails   never: a sector that cannot be had is reported to `complain` and asked for again later.
 */
export class SectorLoader {
    constructor(start, sectors, { complain = () => {}, ...options } = {}) {
        this.planner = new SectorPlanner(start, options);
        this.sectors = sectors;
        this.complain = complain;
        this.loading = new Set();
    }

    /** One frame. `position` in plan metres or null, `now` in seconds. Returns the planner's plan. */
    step(position, now) {
        for (const id of [...this.loading]) this.collect(id, now);
        const plan = this.planner.plan(position, now);
        for (const id of plan.unload) {
            this.loading.delete(id);
            this.sectors.hide(id);
        }
        for (const id of plan.load) {
            this.loading.add(id);
            this.sectors.show(id, this.planner.sectors.get(id).origin);
        }
        return plan;
    }

    collect(id, now) {
        const phase = this.sectors.phase(id);
        if (phase === 'loading' || phase === 'absent') return;
        this.loading.delete(id);
        try {
            if (phase === 'failed') throw new Error(`sector ${id} cannot be fetched`);
            this.planner.arrived(id, this.sectors.record(id));
        } catch (error) {
            this.complain(error.message);
            this.planner.failed(id, now);
        }
    }
}
