import { InlineSectors } from './InlineSectors.js';
import { SectorLoader } from './SectorLoader.js';

// The LOADER Script of the root world (client_scripts/README.md); its fields are in scope by name:
// start, base, ids, inlines, origins, world, sector_changed. Bundled with core/ into /client/loader.js.
/* global Browser, start, base, ids, inlines, origins, world, sector_changed:writable */
let loader = null;
let visitor = null;

function initialize() {
    const sectors = new InlineSectors({ scene: Browser.currentScene, world, base, ids, inlines });
    loader = new SectorLoader(start, sectors, { complain: text => Browser.println(text) });
    const boxes = Array.from(inlines).map(inline => [inline.bboxCenter, inline.bboxSize]);
    Array.from(ids).forEach((id, i) => loader.planner.addNeighbour({
        id, origin: [origins[i].x, -origins[i].z], box: planBox(origins[i], ...boxes[i]) }));
    sector_changed = start;
}

function planBox(origin, centre, size) {
    const east = origin.x + centre.x, north = -(origin.z + centre.z);
    return [east - size.x / 2, north - size.z / 2, east + size.x / 2, north + size.z / 2];
}

function set_position(position) {
    visitor = [position.x, -position.z];
}

function prepareEvents() {
    const plan = loader.step(visitor, Date.now() / 1000);
    if (plan.changed) sector_changed = plan.current;
}
