import { eyeAxes } from './viewCone.js';

/** m: the first step along the ray; each is longer by its share of the way, as what lies there is smaller on the screen. */
const kStep = 0.5, kGrow = 0.004, kFarthest = 6000;
const kHalvings = 12;

/**
 * What is seen at a place of the window, of the ground and the roofs of tiles that are there: { point: [east, north], up, away: m,
 * isRoof }; null: the sky, or what is too far. `view`: { eye, heading, pitch, half } as viewCone has it; `x`, `y`: -1 .. 1 from its middle,
 * right and up; `heights`: RoofHeights.
 */
export function placeBelow({ eye, heading, pitch, half }, [x, y], heights) {
    const { ahead, right, above } = eyeAxes(heading, pitch);
    const long = ahead.map((value, k) => value + x * half[0] * right[k] + y * half[1] * above[k]), length = Math.hypot(...long);
    const way = long.map(value => value / length);
    const at = t => eye.map((value, k) => value + t * way[k]);
    const below = t => {
        const [east, north, up] = at(t), roof = heights.top([east, north]), ground = heights.ground([east, north]);
        const top = Math.max(roof, ground ?? -Infinity);
        return up <= top ? { point: [east, north], up: top, away: t, isRoof: roof > (ground ?? -Infinity) } : null;
    };
    for (let t = 0, before = 0; t < kFarthest; before = t, t += kStep + kGrow * t) {
        let found = below(t);
        if (!found) continue;
        for (let i = 0, near = before, far = t; i < kHalvings; ++i) {
            const middle = (near + far) / 2, nearer = below(middle);
            if (nearer) [found, far] = [nearer, middle];
            else near = middle;
        }
        return found;
    }
    return null;
}
