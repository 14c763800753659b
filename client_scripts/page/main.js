import { Controls } from './Controls.js';
import { FrameRate } from './FrameRate.js';
import { Hud } from './Hud.js';
import { Visit } from './Visit.js';
import { Walker } from './Walker.js';
import { XIteAdapter } from './xIteAdapter.js';
import { fetchRootWorld } from './rootWorld.js';
import { placeFromUrl, rootUrl, urlOfPlace } from './sharedPlace.js';

/** The page: steers the visitor, loads the sectors around him, tells him where he is. */
const hud = new Hud();
const place = placeFromUrl(location.href);

async function start() {
    hud.showProgress(0.1);
    const [view, world] = await Promise.all([XIteAdapter.create(document.getElementById('city')), fetchRootWorld(rootUrl(place.start))]);
    hud.showProgress(0.3);
    hud.showCity(world.name);
    hud.showRights(world.rights);
    const frameRate = new FrameRate(scale => view.setContentScale(scale), view.isSoftwareRenderer());
    await view.show(world.text, world.base);
    const visit = new Visit(view, world, { level: null, line: 'auto', test: 'polygon' }, text => console.info(text));
    visit.homePose = view.pose();
    if (place.pose) view.setPose({ ...visit.homePose, ...place.pose });
    const walker = new Walker(view);
    const controls = new Controls(document.getElementById('window'), document.getElementById('stick'), commandsFor(view, visit));
    document.getElementById('share').addEventListener('click', () => share(view, visit));
    document.getElementById('window').focus();
    window.vicus = { view, walker, controls, visit };   // for tests and the curious
    let last = performance.now() / 1000;
    const frame = time => {
        step({ view, visit, walker, controls, frameRate }, time / 1000 - last);
        last = time / 1000;
        requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
}

function step({ view, visit, walker, controls, frameRate }, seconds) {
    const before = visit.records.length;
    visit.step(view.pose(), performance.now() / 1000);
    const { records } = visit;
    walker.setGround(records);
    const hasMoved = walker.step(controls.wish(), seconds);
    const isSettled = records.length > 0 && visit.sectors.every(sector => sector.phase !== 'loading');
    if (!hasMoved) frameRate.rest(isSettled ? seconds : 0);
    else if (records.length === before) frameRate.add(seconds);
    if (visit.here) hud.showPlace(visit.here);
    const { sectors } = visit, settled = sectors.filter(sector => sector.phase !== 'loading').length;
    hud.showProgress(sectors.length ? 0.4 + 0.6 * settled / sectors.length : 0.4);
    hud.showFailures(visit.failed.size);
}

function commandsFor(view, visit) {
    return {
        KeyH: () => hud.toggleHelp(),
        Slash: () => hud.toggleHelp(),
        Escape: () => hud.toggleHelp(false),
        KeyR: () => view.setPose(visit.homePose),
        KeyL: () => share(view, visit),
    };
}

async function share(view, visit) {
    const url = urlOfPlace(location.href, visit.current, view.pose());
    history.replaceState(null, '', url);
    try {
        await navigator.clipboard.writeText(url);
        hud.say('The link to this place is copied.');
    } catch {
        hud.say('The link to this place stands in the address bar.');
    }
}

start().catch(error => {
    hud.showProgress(1);
    hud.showTrouble(error?.message ?? String(error));
    console.info(error);
});
