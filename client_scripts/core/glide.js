/** rad, between -pi and pi. */
const turnBetween = (from, to) => Math.atan2(Math.sin(to - from), Math.cos(to - from));
const kSlowest = 1.2, kLongest = 4, kMetresPerSecond = 400;   // s, s, of far glides

/** s that a glide from one pose to another should take. */
export function glideSeconds(from, to) {
    const way = Math.hypot(to.east - from.east, to.north - from.north, to.up - from.up);
    return Math.min(kLongest, kSlowest + way / kMetresPerSecond);
}

/** The pose at a share 0 ... 1 of the way: it starts and ends at rest; a far one rises on its way by `arch` metres. */
export function glidePose(from, to, share, arch = 0) {
    const t = Math.min(1, Math.max(0, share)), s = t * t * (3 - 2 * t), mix = (a, b) => a + s * (b - a);
    return {
        east: mix(from.east, to.east), north: mix(from.north, to.north), up: mix(from.up, to.up) + arch * 4 * s * (1 - s),
        heading: from.heading + s * turnBetween(from.heading, to.heading), pitch: mix(from.pitch, to.pitch) };
}
