/** Turn about up by -heading, then about the eye's own right by pitch, as X3D writes a rotation: axis and angle. */
export function axisAngle(heading, pitch) {
    const sy = Math.sin(-heading / 2), cy = Math.cos(-heading / 2), sp = Math.sin(pitch / 2), cp = Math.cos(pitch / 2);
    const [x, y, z, w] = [cy * sp, sy * cp, -sy * sp, cy * cp];
    const length = Math.hypot(x, y, z);
    return length < 1e-9 ? [0, 1, 0, 0] : [x / length, y / length, z / length, 2 * Math.atan2(length, w)];
}
