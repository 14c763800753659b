/** s after which a sector that has not come counts as failed: createVrmlFromURL tells of no failure. */
const kPatience = 20;

/**
 * Shows and hides sectors in VRML97, which has no Inline.load: nodes are fetched into a Transform and the Transform is
 * taken away again, as paper 004 §5 does. It has near files only, so stems are ids. The record stands in the Anchor around the sector's geometry.
 *
 * Needs   `browser` (createVrmlFromString, createVrmlFromURL), `nodes` (makes an MFNode of one node), `strings` (an
 *         MFString of one text).
 */
export class VrmlSectors {
    /** ids, places run in step: what the root world shows from the start, replaced as soon as the Script has its own. */
    constructor({ browser, world, base, ids, places, nodes, strings, clock = () => Date.now() / 1000 }) {
        Object.assign(this, { browser, world, base, nodes, strings, clock, shown: new Map() });
        this.initial = new Map(Array.from(ids).map((id, i) => [id, places[i]]));
    }

    show(id, origin) {
        if (this.shown.has(id)) this.hide(id);
        const place = this.browser.createVrmlFromString(`Transform { translation ${origin[0]} 0 ${-origin[1]} }`)[0];
        this.world.addChildren = this.nodes(place);
        this.browser.createVrmlFromURL(this.strings(`${this.base}${id}.wrl`), place, 'addChildren');
        this.shown.set(id, { place, until: this.clock() + kPatience });
    }

    hide(id) {
        this.world.removeChildren = this.nodes(this.shown.get(id).place);
        this.shown.delete(id);
    }

    phase(id) {
        const { place, until } = this.shown.get(id);
        if (place.children.length > 0) return 'live';
        return this.clock() < until ? 'loading' : 'failed';
    }

    /** Needs   phase(id) == 'live'. Fails  Error: no record in the file. */
    record(id) {
        const anchor = Array.from(this.shown.get(id).place.children).find(node => node.description === 'vicus record');
        if (!anchor) throw new Error(`sector ${id}: the file carries no record`);
        this.dropInitial(id);
        return JSON.parse(anchor.parameter[0]);
    }

    dropInitial(id) {
        const place = this.initial.get(id);
        if (place) this.world.removeChildren = this.nodes(place);
        this.initial.delete(id);
    }

    makeAlarm(seconds) {
        const alarm = this.browser.createVrmlFromString(`TimeSensor { cycleInterval ${seconds} }`)[0];
        this.world.addChildren = this.nodes(alarm);
        return alarm;
    }
}
