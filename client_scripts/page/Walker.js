import { GroundWalls, constrainMetres } from '../core/GroundWalls.js';
import { GroundHeights } from '../core/GroundHeights.js';
import { cornerRound, detourRound } from '../core/detour.js';
import { latticePoint } from '../core/planGeometry.js';
import { sectorFromRecord } from '../core/sectorRecord.js';

const kWalkSpeed = 2.2, kRunSpeed = 7;            // m/s
const kTurnSpeed = 1.6;                           // rad/s
const kMostPitch = 1.2;                           // rad
/** Share of the step that walls alone would let, below which a visitor counts as stopped by a body. */
const kStopped = 0.5;
/** Share of a step below which walls alone stop him. */
const kWalledIn = 0.1;
/** Share of a step above which nothing is in the way, and below which a wall is met head on. */
const kFree = 0.95, kHeadOn = 0.3;
/** Cosine of the angle by which a visitor may turn on his way round a body and still want to get past it. */
const kSameWay = 0.7;
/** s: a stall longer than this (a sector being parsed) moves the visitor no farther. */
const kLongestStep = 0.2;
/** m: of the eye above the ground; and how fast it follows a kerb or a step, per second. */
const kEye = 1.7, kRise = 9;

/**
 * Moves the visitor by what the controls say, as far as walls and bodies let: the ground edges of the sectors that are
 * there, so nobody leaves but through a gate, and what stands on the ground. One who walks straight into a body, or into
 * a wall just beside its corner, is led round it. The eye follows the ground over kerbs, steps and slopes; where the
 * ground is not known it keeps its height.
 *
 * Needs   `view`: pose(), setPose() as XIteAdapter has them.
 */
export class Walker {
    constructor(view) {
        this.view = view;
        this.ground = new GroundWalls([]);
        this.key = '';
        this.heights = new GroundHeights([]);
        this.detour = null;   // { way: lattice points still to go to, towards: what was wanted }
    }

    /** `records` of the sectors that are there, `open`: doors that are open; cheap when they are the same as before. */
    setGround(records, open = []) {
        const key = [...records.map(record => record.id), ...open].sort().join(' ');
        if (key === this.key) return;
        this.key = key;
        this.ground = new GroundWalls(records.map(sectorFromRecord), undefined, open);
        this.open = this.ground.withoutBodies();
        this.heights = new GroundHeights(records.map(record => record.surface).filter(Boolean));
        this.detour = null;
    }

    /** One frame of `seconds`. `wish`: forward, right, turn in -1..1, look [heading, pitch] in radians, run. */
    step(wish, seconds) {
        if (!wish.forward && !wish.right && !wish.turn && !wish.look[0] && !wish.look[1]) return false;
        const time = Math.min(seconds, kLongestStep), pose = this.view.pose();
        pose.heading += wish.turn * kTurnSpeed * time + wish.look[0];
        pose.pitch = Math.min(kMostPitch, Math.max(-kMostPitch, pose.pitch + wish.look[1]));
        if (wish.forward || wish.right) {
            [pose.east, pose.north] = this.walk(pose, wish, time);
            const ground = this.heights.at([pose.east * 1000, pose.north * 1000]);
            if (ground !== null) pose.up += (ground / 1000 + kEye - pose.up) * Math.min(1, kRise * time);
        }
        this.view.setPose(pose);
        return true;
    }

    walk({ east, north, heading }, wish, time) {
        const length = Math.hypot(wish.forward, wish.right), sin = Math.sin(heading), cos = Math.cos(heading);
        const towards = [
            (wish.forward * sin + wish.right * cos) / length, (wish.forward * cos - wish.right * sin) / length];
        const reach = (wish.run ? kRunSpeed : kWalkSpeed) * time * Math.min(1, length), from = [east, north];
        if (this.detour && dot(towards, this.detour.towards) < kSameWay) this.detour = null;
        if (this.detour) return this.follow(from, reach);
        const goal = [east + reach * towards[0], north + reach * towards[1]];
        const end = constrainMetres(this.ground, from, goal);
        const way = this.wayRound(from, goal, end, towards);
        if (!way) return end;
        this.detour = { way, towards };
        return this.follow(from, reach);
    }

    /** The way round what stops the visitor at `end`, or null: nothing does, or there is no way. */
    wayRound(from, goal, end, towards) {
        const share = dot(minus(end, from), towards) / dot(minus(goal, from), towards);
        if (share > kFree) return null;
        if (this.isStoppedByBody(from, goal, end)) return detourRound(this.ground, latticePoint(from), towards);
        return share < kHeadOn ? cornerRound(this.ground, latticePoint(from), towards) : null;
    }

    isStoppedByBody(from, goal, end) {
        if (this.ground.bodies.length === 0) return false;
        const open = minus(constrainMetres(this.open, from, goal), from), length = Math.hypot(...open);
        return length > kWalledIn * Math.hypot(...minus(goal, from)) && dot(minus(end, from), open) < kStopped * length ** 2;
    }

    /** Along the detour. It touches no body or has to, so only walls count. */
    follow(from, reach) {
        const { way } = this.detour;
        let at = from, left = reach;
        while (way.length && left > 0) {
            const [east, north] = minus([way[0][0] / 1000, way[0][1] / 1000], at), gap = Math.hypot(east, north);
            const share = Math.min(1, left / (gap || 1));
            const next = constrainMetres(this.open, at, [at[0] + share * east, at[1] + share * north]);
            if (share === 1) way.shift();
            else if (Math.hypot(...minus(next, at)) < kWalledIn * left) way.length = 0;
            at = next;
            left -= gap;
        }
        if (!way.length) this.detour = null;
        return at;
    }
}

function minus(a, b) {
    return [a[0] - b[0], a[1] - b[1]];
}

function dot(a, b) {
    return a[0] * b[0] + a[1] * b[1];
}
