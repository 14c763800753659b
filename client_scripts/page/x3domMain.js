import { SectorLoader } from '../core/SectorLoader.js';
import { Controls } from './Controls.js';
import { Hud } from './Hud.js';
import { Walker } from './Walker.js';
import { X3domSectors } from './X3domSectors.js';
import { X3domView } from './X3domView.js';
import { fetchRootWorld } from './rootWorld.js';
import { placeFromUrl, rootUrl } from './sharedPlace.js';

const byId = id => document.getElementById(id);

/** The city in X3DOM, which has neither Script nor ProximitySensor: the same core, its own shell. */
async function start() {
    const hud = new Hud(), place = placeFromUrl(location.href), world = await fetchRootWorld(rootUrl(place.start));
    hud.showCity(world.name);
    hud.showRights(world.rights);
    const view = await X3domView.create(byId('window'), world), sectors = new X3domSectors(view.world, world.base);
    const loader = new SectorLoader(world.start, sectors, {
        complain: text => console.info(text), limit: 1, fixedLevel: place.level, level: place.level ?? 1 });
    const { start: id, origin, origin: [east, north] } = world;
    loader.planner.addNeighbour({ id, origin, box: [east - 1, north - 1, east + 1, north + 1] });
    const parts = { view, world, sectors, loader, walker: new Walker(view), hud };
    const touchDoor = () => {
        const near = doorNear(parts);
        if (near) loader.doors.touch(near.door, loader.planner.current, performance.now() / 1000);
    };
    parts.controls = new Controls(byId('window'), byId('stick'), { KeyI: touchDoor });
    byId('door-button').addEventListener('click', touchDoor);
    byId('window').focus({ focusVisible: false });
    window.vicus = parts;   // for tests and the curious
    let last = performance.now() / 1000;
    const frame = time => {
        step(parts, time / 1000 - last);
        last = time / 1000;
        requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
}

function step(parts, seconds) {
    const { view, sectors, loader, walker, hud, controls } = parts, pose = view.pose();
    const plan = loader.step([pose.east, pose.north], performance.now() / 1000, { heading: pose.heading });
    const { records } = sectors, here = records.find(({ id }) => id === plan.current);
    walker.setGround(records, loader.doors.open);
    walker.step(controls.wish(), seconds);
    hud.showDoor(doorNear(parts));
    if (here) hud.showPlace(here);
    hud.showStatus({ i: plan.level, isMeasured: true, files: sectors.live().length });
}

function doorNear({ view, loader }) {
    const { east, north, heading } = view.pose();
    return loader.doors.near([1000 * east, 1000 * north], loader.planner.sectors.get(loader.planner.current), heading);
}

start().catch(error => {
    const message = byId('message');
    message.textContent = error?.message ?? String(error);
    message.hidden = false;
});
