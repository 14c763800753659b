import assert from 'node:assert/strict';
import test from 'node:test';
import { GoTo, groundUnder } from '../../../../client_scripts/page/GoTo.js';

const kPose = { east: 10, north: 20, up: 1.7, heading: 0, pitch: 0 };

/** Walks as Walker does, at 2 m/s and 1.6 rad/s, `blocked`: north of that is a wall. */
function walk(goTo, pose, { blocked = Infinity, seconds = 60 } = {}) {
    for (let t = 0; t < seconds; t += 0.05) {
        const wish = goTo.wish(pose, 0.05);
        if (!wish) return { pose, t };
        const heading = pose.heading + wish.turn * 1.6 * 0.05, step = wish.forward * 2 * 0.05;
        pose = { ...pose, heading, east: pose.east + step * Math.sin(heading), north: Math.min(blocked, pose.north + step * Math.cos(heading)) };
    }
    return { pose, t: seconds };
}

test('leads to the spot from any heading, and ends there', () => {
    for (let heading = -3; heading <= 3; heading += 0.5) {
        const goTo = new GoTo();
        goTo.start([4, 33]);
        const { pose, t } = walk(goTo, { ...kPose, heading });
        assert.ok(Math.hypot(pose.east - 4, pose.north - 33) < 0.45 && t < 15, `${t} s, ${pose.east}, ${pose.north}`);
        assert.equal(goTo.goal, null);
    }
});

test('before a wall it gives up soon', () => {
    const goTo = new GoTo();
    goTo.start([10, 40]);
    const { pose, t } = walk(goTo, kPose, { blocked: 25 });
    assert.ok(pose.north === 25 && t < 5, `${t} s`);
});

test('the spot under a pixel is the one that is seen there', () => {
    for (const pose of [kPose, { ...kPose, heading: 2, pitch: -0.3 }, { ...kPose, heading: -1, pitch: 0.2 }])
        for (const aspect of [0.6, 1.7]) for (const spot of [[-0.4, -0.8], [0, -0.7], [0.5, -0.95]]) {
            const found = groundUnder(pose, spot, aspect, 0.95);
            const { x, y } = project(found, pose, aspect, 0.95);
            if (Math.hypot(found[0] - pose.east, found[1] - pose.north) > 59) continue;
            assert.ok(Math.abs(x - spot[0]) < 1e-9 && Math.abs(y - spot[1]) < 1e-9, `${spot} -> ${found} -> ${[x, y]}`);
        }
    assert.equal(groundUnder(kPose, [0, 0.3], 1.5, 0.95), null, 'the sky');
    const far = groundUnder(kPose, [0, -0.03], 1.5, 0.95);
    assert.ok(Math.abs(far[1] - kPose.north - 60) < 1e-6, 'no farther than 60 m');
});

/** Where a point of the ground appears: turned back by heading, then by pitch, over its depth. */
function project([east, north], pose, aspect, fieldOfView) {
    const dx = east - pose.east, dy = north - pose.north, sin = Math.sin(pose.heading), cos = Math.cos(pose.heading);
    const right = dx * cos - dy * sin, ahead = dx * sin + dy * cos, up = -pose.up;
    const depth = ahead * Math.cos(pose.pitch) + up * Math.sin(pose.pitch), above = up * Math.cos(pose.pitch) - ahead * Math.sin(pose.pitch);
    const half = Math.tan(fieldOfView / 2);
    return { x: right / depth / half / Math.max(1, aspect), y: above / depth / half / Math.max(1, 1 / aspect) };
}
