/** s a picture takes to fade once what it stands for is there. */
const kFadeSeconds = 0.6;

/**
 * Pictures in gates (paper 004 §4.1.7): shown from the moment a sector is there until what lies behind its gate is, then
 * faded out. What goes away again has its picture back at once.
 *
 * Needs   `show(stem, gateId, opacity)`, 0 ... 1, for gates of sectors whose near file is live.
 */
export class GateImpostors {
    constructor(show) {
        this.show = show;
        this.opacities = new Map();   // stem -> Map of gate id -> opacity
        this.last = null;
    }

    /**
     * One frame, `now` in seconds. `sectors`: id -> sector of the core, `isLive(stem)`. Returns whether a picture is
     * fading, so that another frame is needed.
     */
    step(now, sectors, isLive) {
        const share = this.last === null ? 0 : Math.max(0, now - this.last) / kFadeSeconds;
        this.last = now;
        for (const stem of this.opacities.keys()) if (!isLive(stem)) this.opacities.delete(stem);
        let isFading = false;
        for (const { id, gates } of sectors.values()) {
            const pictured = (gates ?? []).filter(gate => gate.to && gate.hasImpostor);
            if (!pictured.length || !isLive(id)) continue;
            const isNew = !this.opacities.has(id), opacities = this.opacities.get(id) ?? new Map();
            this.opacities.set(id, opacities);
            for (const gate of pictured) {
                const before = opacities.get(gate.id) ?? 0, isThere = isLive(gate.to) || isLive(`${gate.to}.far`);
                const opacity = isThere ? (isNew ? 0 : Math.max(0, before - share)) : 1;
                if (opacity !== before) this.show(id, gate.id, opacity);
                opacities.set(gate.id, opacity);
                isFading ||= isThere && opacity > 0;
            }
        }
        return isFading;
    }
}

/** Makes the nodes of a picture (x3d_export/impostor_nodes, panorama_nodes) show it; its image is fetched when it is needed first. */
export function fadeImpostor(group, opacity) {
    const { texture, material } = group.children[0].appearance;
    if (opacity > 0 && !texture.load) texture.load = true;
    material.transparency = 1 - opacity;
    group.visible = opacity > 0;
}
