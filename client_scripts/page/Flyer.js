import { eyeAxes } from '../core/viewCone.js';

const kTurnSpeed = 1.4;                          // rad/s
const kMostPitch = 1.5;                          // rad
/** Speed in heights over the ground per second, at least so many m/s; Shift makes it three times as much. */
const kSpeed = 0.7, kLeastSpeed = 14, kRun = 3;
/** m over roofs, over the ground, and how far up; and how fast a roof lifts him, per second. */
const kOverRoofs = 6, kOverGround = 22, kHighest = 6000, kLift = 5;
const kLongestStep = 0.2;                        // s
/** What a notch of the wheel (100 pixels) brings nearer, of the height. */
const kZoom = 0.15;

/** Moves who flies by what the controls say: over roofs and above the ground, as far as tiles tell where they are. */
export class Flyer {
    /** `view`: pose(), setPose(); `heights`: RoofHeights. */
    constructor(view, heights) {
        Object.assign(this, { view, heights });
    }

    /** m above 0 below which nobody flies there. */
    floor({ east, north }) {
        return Math.max(this.heights.roof([east, north]) + kOverRoofs, (this.heights.ground([east, north]) ?? 0) + kOverGround);
    }

    /** m over the ground, or over 0 where it is not known. */
    height({ east, north, up }) {
        return up - (this.heights.ground([east, north]) ?? 0);
    }

    /** One frame of `seconds`; true when he moved. */
    step(wish, seconds) {
        const time = Math.min(seconds, kLongestStep), pose = this.view.pose(), before = { ...pose };
        pose.heading += wish.turn * kTurnSpeed * time + wish.look[0];
        pose.pitch = Math.min(kMostPitch, Math.max(-kMostPitch, pose.pitch + wish.look[1]));
        const reach = Math.max(kLeastSpeed, kSpeed * this.height(pose)) * (wish.run ? kRun : 1) * time;
        const [s, c] = [Math.sin(pose.heading), Math.cos(pose.heading)];
        pose.east += reach * (wish.forward * s + wish.right * c);
        pose.north += reach * (wish.forward * c - wish.right * s);
        pose.up += reach * wish.rise;
        if (wish.zoom) {
            const { ahead } = eyeAxes(pose.heading, pose.pitch), way = kZoom * wish.zoom * Math.max(kLeastSpeed, this.height(pose));
            [pose.east, pose.north, pose.up] = [pose.east, pose.north, pose.up].map((value, k) => value + way * ahead[k]);
        }
        const floor = this.floor(pose);
        if (pose.up < floor) pose.up = wish.rise < 0 || wish.zoom ? floor : pose.up + (floor - pose.up) * Math.min(1, kLift * time);
        pose.up = Math.min(kHighest, pose.up);
        if (Object.keys(pose).every(key => Math.abs(pose[key] - before[key]) < 1e-9)) return false;
        this.view.setPose(pose);
        return true;
    }
}
