import { SectorLoader } from '../core/SectorLoader.js';
import { InlineSectors } from './InlineSectors.js';
import { VrmlSectors } from './VrmlSectors.js';

// The LOADER Script of the root world (client_scripts/README.md); its fields are in scope by name:
// start, base, level, sector_test, ids, inlines, places, origins, world, sector_changed, level_changed. Bundled with core/
// into /client/loader.js.
/* global Browser, MFNode, MFString, SFColor, SFRotation, start, base, level, sector_test, ids, inlines, places, origins, world,
   sector_changed:writable, level_changed:writable */
let loader = null;
let visitor = null;
let heading = null;
let alarm = null;

/** s an alarm rings: long enough for a frame. */
const kRing = 0.1;
/** m around its origin where a sector may lie that has told nothing yet. */
const kUnknownReach = 100;

function initialize() {
    const isVrml97 = inlines.length === 0;
    const sectors = isVrml97
        ? new VrmlSectors({ browser: Browser, world, base, ids, places,
            nodes: node => new MFNode(node), strings: text => new MFString(text) })
        : new InlineSectors({ scene: Browser.currentScene, world, base, ids, inlines, values: {
            rotation: (...numbers) => new SFRotation(...numbers), color: (...numbers) => new SFColor(...numbers) } });
    loader = new SectorLoader(start, sectors, { complain: text => Browser.println(text), nearOnly: isVrml97,
        fixedLevel: level === '' ? null : Number(level), test: sector_test });
    Array.from(ids).forEach((id, i) => loader.planner.addNeighbour({
        id, origin: [origins[i].x, -origins[i].z], box: boxOf(origins[i], inlines[i]) }));
    alarm = sectors.makeAlarm(kRing);
    sector_changed = start;
    level_changed = String(loader.planner.i);
}

function boxOf(origin, inline) {
    const { bboxCenter: centre, bboxSize: size } = inline ?? { bboxCenter: { x: 0, z: 0 }, bboxSize: { x: -1, z: -1 } };
    const half = [size.x, size.z].map(side => (side < 0 ? kUnknownReach : side / 2));
    const east = origin.x + centre.x, north = -(origin.z + centre.z);
    return [east - half[0], north - half[1], east + half[0], north + half[1]];
}

function set_position(position) {
    visitor = [position.x, -position.z];
}

/** Where -z, the way a visitor looks, points to after the turn about (x, y, z). */
function set_orientation({ x, y, z, angle }) {
    const c = Math.cos(angle), s = Math.sin(angle);
    const east = -(x * z * (1 - c) + y * s), south = -(z * z * (1 - c) + c);
    if (Math.hypot(east, south) > 0.01) heading = Math.atan2(east, -south);
}

function prepareEvents() {
    const now = Date.now() / 1000, plan = loader.step(visitor, now, { heading, memoryShare: memoryShare() });
    if (plan.changed) sector_changed = plan.current;
    if (level_changed !== String(plan.level)) level_changed = String(plan.level);
    setAlarm(Math.max(loader.isFading ? now : plan.wakeAt, now + kRing));
}

/** Of what the browser allows its scripts; 0 where it does not tell. */
function memoryShare() {
    const memory = typeof performance === 'undefined' ? null : performance.memory;
    return memory ? memory.usedJSHeapSize / memory.jsHeapSizeLimit : 0;
}

/** A browser that draws nothing while nothing moves, draws a frame when a TimeSensor starts. */
function setAlarm(time) {
    if (time === Infinity || (alarm.startTime >= Date.now() / 1000 && alarm.startTime <= time)) return;
    alarm.startTime = time;
}
