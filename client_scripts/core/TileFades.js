/** s in which one tile takes another's place. */
export const kFadeSeconds = 0.3;

/**
 * Which quadrants of which tiles are drawn, and how far each has come: 0 not there, 0.5 there, 1 gone. Between, a dither of the
 * screen's pixels shows the one that comes where it does not show the one that goes, so that together they leave no hole.
 * A change begins when the one before is over: nothing that is half gone is replaced.
 */
export class TileFades {
    constructor() {
        Object.assign(this, { parts: new Map(), begun: -Infinity, isCalm: true });
    }

    /** `draw` of TileTree.choose; does nothing while a change is under way. True: it was taken. */
    set(draw, now) {
        if (!this.isCalm) return false;
        const wanted = new Map();
        for (const { tile, quadrants } of draw)
            for (let q = 0; q < 4; ++q) if (quadrants & (1 << q)) wanted.set(`${tile.key}#${q}`, { tile, quadrant: q });
        for (const [key, part] of wanted)
            if (!this.parts.has(key)) {
                this.parts.set(key, { ...part, from: 0, state: 0 });
                this.isCalm = false;
            }
        for (const [key, part] of this.parts)
            if (!wanted.has(key)) {
                part.from = 0.5;
                this.isCalm = false;
            }
        if (!this.isCalm) this.begun = now;
        return true;
    }

    /** [{ tile, quadrant, state }] of those that have changed since the last call; one that is gone comes once, with 1. */
    step(now) {
        if (this.isCalm) return [];
        const share = Math.min(1, (now - this.begun) / kFadeSeconds), changed = [];
        for (const [key, part] of this.parts) {
            const isSteady = part.from === 0 ? part.state === 0.5 : false;
            if (isSteady) continue;
            part.state = part.from + share / 2;
            changed.push(part);
            if (part.state === 1) this.parts.delete(key);
        }
        this.isCalm = share === 1;
        return changed;
    }

    clear() {
        this.parts.clear();
        this.isCalm = true;
    }
}
