import { GroundWalls, constrainMetres } from '../core/GroundWalls.js';
import { sectorFromRecord } from '../core/sectorRecord.js';

const kWalkSpeed = 2.2, kRunSpeed = 7;            // m/s
const kTurnSpeed = 1.6;                           // rad/s
const kMostPitch = 1.2;                           // rad
/** Share of a step below which a body counts as head on. */
const kHeadOn = 0.3;
const kAside = [0.6, 1.2, Math.PI / 2];           // rad
const kLeastAsideShare = 0.4;                     // of the speed
/** s: a stall longer than this (a sector being parsed) moves the visitor no farther. */
const kLongestStep = 0.2;

/**
 * Moves the visitor by what the controls say: walls in plan first, bodies in 3D second, walls again, gravity by the
 * browser. The walls are the ground edges of the sectors that are there, so nobody leaves but through a gate.
 *
 * Needs   `view`: pose(), setPose(), constrainStep(), setGravity() as XIteAdapter has them.
 */
export class Walker {
    constructor(view) {
        this.view = view;
        this.walls = new GroundWalls([]);
        this.key = '';
        this.side = 1;   // 1: passes bodies on the right
    }

    /** `records` of the sectors that are there; cheap when they are the same as before. */
    setGround(records) {
        const key = records.map(record => record.id).sort().join(' ');
        if (key === this.key) return;
        this.key = key;
        this.walls = new GroundWalls(records.map(sectorFromRecord));
    }

    /** Gravity only where there is ground below: not before the sector is there, not after a jump to where none is yet. */
    keepFromFalling() {
        const { east, north } = this.view.pose();
        this.view.setGravity(this.walls.isOnGround([east * 1000, north * 1000]));
    }

    /** One frame of `seconds`. `wish`: forward, right, turn in -1..1, look [heading, pitch] in radians, run. */
    step(wish, seconds) {
        const time = Math.min(seconds, kLongestStep);
        this.keepFromFalling();
        if (!wish.forward && !wish.right && !wish.turn && !wish.look[0] && !wish.look[1]) return false;
        const pose = this.view.pose();
        pose.heading += wish.turn * kTurnSpeed * time + wish.look[0];
        pose.pitch = Math.min(kMostPitch, Math.max(-kMostPitch, pose.pitch + wish.look[1]));
        if (wish.forward || wish.right) [pose.east, pose.north] = this.walk(pose, wish, time);
        this.view.setPose(pose);
        return true;
    }

    walk({ east, north, heading }, wish, time) {
        const length = Math.max(1, Math.hypot(wish.forward, wish.right));
        const reach = (wish.run ? kRunSpeed : kWalkSpeed) * time / length;
        const sin = Math.sin(heading), cos = Math.cos(heading), from = [east, north];
        const goal = [
            east + reach * (wish.forward * sin + wish.right * cos), north + reach * (wish.forward * cos - wish.right * sin)];
        const inPlan = constrainMetres(this.walls, from, goal);
        const step = [inPlan[0] - east, inPlan[1] - north];
        if (Math.hypot(...step) < 1e-4) return from;
        const free = this.passBodies(step);
        if (Math.hypot(free[0] - step[0], free[1] - step[1]) < 1e-6) return inPlan;
        return constrainMetres(this.walls, from, [east + free[0], north + free[1]]);
    }

    /** Round a body (a trunk, a bench) that stops the step head on: aside, on the same side as the last time first. */
    passBodies(step) {
        const passed = this.view.constrainStep(step), length = Math.hypot(...step);
        if (Math.hypot(...passed) > kHeadOn * length) return passed;
        for (const side of [this.side, -this.side])
            for (const angle of kAside) {
                const cos = Math.cos(angle), sin = side * Math.sin(angle), share = Math.max(cos, kLeastAsideShare);
                const aside = [share * (cos * step[0] + sin * step[1]), share * (cos * step[1] - sin * step[0])];
                const free = this.view.constrainStep(aside);
                if (Math.hypot(...free) <= kHeadOn * Math.hypot(...aside)) continue;
                this.side = side;
                return free;
            }
        return passed;
    }
}
