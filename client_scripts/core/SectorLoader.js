import { Doors } from './Doors.js';
import { GateImpostors } from './GateImpostors.js';
import { Panoramas } from './Panoramas.js';
import { SectorPlanner } from './SectorPlanner.js';
import { latticePoint } from './planGeometry.js';
import { idOf, levelOf } from './sectorRecord.js';

/**
 * The loop of paper 004 §5: watches the visitor, does what the planner says, hears what became of it.
 *
 * Needs   `sectors` shows and hides files by their stems: show(stem, origin), hide(stem), phase(stem), record(stem), links(stem);
 *         setImpostor(stem, gateId, opacity) where files have pictures in their gates, setPanorama(stem, opacity) where they have one around; setDoor(stem, doorId, look) and
 *         touchTime(stem, doorId), the time of the last click on a door's leaf, where they have doors.
 * Fails   never: a sector that cannot be had is reported to `complain` and asked for again later.
 */
export class SectorLoader {
    constructor(start, sectors, { complain = () => {}, ...options } = {}) {
        this.planner = new SectorPlanner(start, options);
        this.sectors = sectors;
        this.complain = complain;
        this.loading = new Set();
        this.impostors = new GateImpostors((stem, gate, opacity) => this.sectors.setImpostor?.(stem, gate, opacity));
        this.panoramas = new Panoramas((stem, opacity) => this.sectors.setPanorama?.(stem, opacity));
        this.doors = new Doors((stem, door, look) => this.sectors.setDoor?.(stem, door, look));
        this.touched = new Map();   // door id -> time of the last click that was seen
        this.isFading = false;
    }

    /** One frame. `position` in plan metres or null, `now` in seconds, `visitor` as in plan(). Returns the planner's plan. */
    step(position, now, visitor) {
        for (const stem of [...this.loading]) this.collect(stem, now);
        const { states, sectors } = this.planner, isLive = stem => states.get(stem)?.phase === 'live';
        this.hearTouches(now, sectors, isLive);
        const point = position && latticePoint(position), isSwinging = this.doors.step(now, point, this.planner.current, sectors, isLive);
        this.planner.beyondDoors = this.doors.wanted;
        const plan = this.planner.plan(position, now, visitor);
        for (const stem of plan.unload) {
            this.loading.delete(stem);
            this.sectors.hide(stem);
        }
        for (const stem of plan.load) {
            this.loading.add(stem);
            this.sectors.show(stem, this.planner.sectors.get(idOf(stem)).origin);
        }
        const isTurning = this.panoramas.step(now, this.planner.current, sectors, isLive);
        this.isFading = this.impostors.step(now, sectors, isLive) || isTurning || isSwinging;
        return plan;
    }

    /** Clicks on doors since the frame before; what was clicked before its file was put in does not count. */
    hearTouches(now, sectors, isLive) {
        if (!this.sectors.touchTime) return;
        for (const { id, doors } of sectors.values())
            for (const door of doors ?? []) {
                const before = this.touched.get(door.id);
                if (!isLive(id)) {
                    this.touched.delete(door.id);
                    continue;
                }
                const time = this.sectors.touchTime(id, door.id);
                if (before !== undefined && time !== before) this.doors.touch(door, this.planner.current, now);
                this.touched.set(door.id, time);
            }
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
