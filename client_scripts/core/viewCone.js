/** The eye's axes in plan metres [east, north, up]: ahead, right, above. Heading clockwise from north, pitch up, radians. */
export function eyeAxes(heading, pitch) {
    const [s, c, sp, cp] = [Math.sin(heading), Math.cos(heading), Math.sin(pitch), Math.cos(pitch)];
    return { ahead: [s * cp, c * cp, sp], right: [c, -s, 0], above: [-s * sp, -c * sp, cp] };
}

/**
 * What a view sees: a function that tells of a box { low: [east, north, up], high } whether some of it may be in view; it may say
 * so of a box just beside. `view`: { eye, heading, pitch, half: tangents of half the angle of view, across and up }. `wider`:
 * times those tangents.
 */
export function viewCone({ eye, heading, pitch, half }, wider = 1) {
    const { ahead, right, above } = eyeAxes(heading, pitch), [x, y] = half.map(tangent => tangent * wider);
    const plane = (tangent, side, sign) => ahead.map((a, k) => a * tangent + sign * side[k]);   // its normal looks inwards
    const normals = [plane(x, right, 1), plane(x, right, -1), plane(y, above, 1), plane(y, above, -1), ahead];
    return ({ low, high }) => normals.every(normal =>
        normal.reduce((sum, n, k) => sum + n * ((n > 0 ? high[k] : low[k]) - eye[k]), 0) >= 0);
}
