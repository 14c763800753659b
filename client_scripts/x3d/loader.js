import { InlineSectors } from './InlineSectors.js';
import { SectorLoader } from './SectorLoader.js';

// The LOADER Script of the root world (client_scripts/README.md); its fields are in scope by name:
// start, base, ids, inlines, origins, world, sector_changed. Bundled with core/ into /client/loader.js.
/* global Browser, start, base, ids, inlines, origins, world, sector_changed:writable */
let loader = null;
let visitor = null;
let alarm = null;

/** s an alarm rings: long enough for a frame. */
const kRing = 0.1;

function initialize() {
    const sectors = new InlineSectors({ scene: Browser.currentScene, world, base, ids, inlines });
    loader = new SectorLoader(start, sectors, { complain: text => Browser.println(text) });
    const boxes = Array.from(inlines).map(inline => [inline.bboxCenter, inline.bboxSize]);
    Array.from(ids).forEach((id, i) => loader.planner.addNeighbour({
        id, origin: [origins[i].x, -origins[i].z], box: planBox(origins[i], ...boxes[i]) }));
    alarm = Browser.currentScene.createNode('TimeSensor');
    alarm.cycleInterval = kRing;
    world.children[world.children.length] = alarm;
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
    const now = Date.now() / 1000, plan = loader.step(visitor, now);
    if (plan.changed) sector_changed = plan.current;
    setAlarm(Math.max(plan.wakeAt, now + kRing));
}

/** A browser that draws nothing while nothing moves, draws a frame when a TimeSensor starts. */
function setAlarm(time) {
    if (time === Infinity || (alarm.startTime >= Date.now() / 1000 && alarm.startTime <= time)) return;
    alarm.startTime = time;
}
