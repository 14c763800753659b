/** s in which one comes or goes. */
const kPanoramaSeconds = 0.6;

/**
 * What an open sector sees beyond its L_vis, as a picture around it (paper 004 §4.1.7, §6): shown while the visitor is in that
 * sector, faded in and out.
 *
 * Needs   `show(stem, opacity)`, 0 ... 1, for sectors whose near file is live.
 */
export class Panoramas {
    constructor(show) {
        this.show = show;
        this.opacities = new Map();   // stem -> opacity
        this.last = null;
    }

    /** One frame, `now` in seconds. Returns whether one is fading, so that another frame is needed. */
    step(now, current, sectors, isLive) {
        const share = this.last === null ? 0 : Math.max(0, now - this.last) / kPanoramaSeconds;
        this.last = now;
        if (sectors.get(current)?.hasPanorama && isLive(current) && !this.opacities.has(current)) this.opacities.set(current, 0);
        let isFading = false;
        for (const [stem, before] of this.opacities) {
            const wanted = stem === current ? 1 : 0;
            const opacity = wanted ? Math.min(1, before + share) : Math.max(0, before - share);
            if (!isLive(stem)) this.opacities.delete(stem);   // it comes again as its file has it: not shown
            else if (opacity !== before) {
                this.show(stem, opacity);
                if (opacity > 0) this.opacities.set(stem, opacity);
                else this.opacities.delete(stem);
            }
            isFading ||= this.opacities.has(stem) && opacity !== wanted;
        }
        return isFading;
    }
}
