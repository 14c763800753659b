/** Share of a threshold that a visitor must be beyond it before a level of detail changes: no flicker at the threshold. */
const kMargin = 0.1;

/**
 * The level of detail at a distance: 0 is the nearest. `ranges` ascend: level i is for distances below ranges[i].
 * `current` is the level shown now, -1 for none. While the distance stays within the margin of the threshold between the
 * current level and the one next to it, the current one stays.
 */
export function steadyLevel(ranges, current, distance, margin = kMargin) {
    let level = 0;
    while (level < ranges.length && distance >= ranges[level]) ++level;
    if (current < 0) return level;
    if (level > current && distance < ranges[current] * (1 + margin)) return current;
    if (level < current && distance > ranges[current - 1] * (1 - margin)) return current;
    return level;
}
