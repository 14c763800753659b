import { Controls } from './Controls.js';
import { FrameRate } from './FrameRate.js';
import { Hud } from './Hud.js';
import { Walker } from './Walker.js';
import { XIteAdapter } from './xIteAdapter.js';
import { placeFromUrl, rootUrl, urlOfPlace } from './sharedPlace.js';

/** The page: the LOADER Script of the root world owns the sectors; here the visitor is moved and told where he is. */
const hud = new Hud();
const place = placeFromUrl(location.href);
const visit = { current: '', sectors: [], failed: new Set(), homePose: null, firstStreetAt: 0, lastFrame: 0 };

async function start() {
    hud.showProgress(0.1);
    const view = await XIteAdapter.create(document.getElementById('city'));
    hud.showProgress(0.3);
    const frameRate = new FrameRate(scale => view.setContentScale(scale), view.isSoftwareRenderer());
    await view.load(rootUrl(place.start));
    hud.showCity(view.meta('subject'));
    hud.showRights(view.meta('rights'));
    view.onSectorChanged(id => { visit.current = id; });
    visit.homePose = view.pose();
    if (place.pose) view.setPose({ ...visit.homePose, ...place.pose });
    const walker = new Walker(view);
    const controls = new Controls(document.getElementById('window'), document.getElementById('stick'), commandsFor(view));
    document.getElementById('share').addEventListener('click', () => share(view));
    document.getElementById('window').focus();
    window.vicus = { view, walker, controls, visit };   // for tests and the curious
    const frame = time => {
        step(view, walker, controls, frameRate, time / 1000);
        requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
}

function step(view, walker, controls, frameRate, now) {
    const seconds = now - visit.lastFrame;
    visit.lastFrame = now;
    const before = visit.sectors.filter(sector => sector.record).length;
    visit.sectors = view.sectors();
    const records = visit.sectors.map(sector => sector.record).filter(Boolean);
    walker.setGround(records);
    const hasMoved = walker.step(controls.wish(), seconds);
    const isSettled = records.length > 0 && visit.sectors.every(sector => sector.phase !== 'loading');
    if (!hasMoved) frameRate.rest(isSettled ? seconds : 0);
    else if (records.length === before) frameRate.add(seconds);
    show(records);
}

function show(records) {
    const here = records.find(record => record.id === visit.current);
    if (here) {
        if (!visit.firstStreetAt) visit.firstStreetAt = performance.now();
        hud.showPlace(here);
    }
    const wanted = visit.sectors.filter(sector => sector.phase !== 'absent');
    const settled = wanted.filter(sector => sector.phase !== 'loading').length;
    hud.showProgress(wanted.length ? 0.4 + 0.6 * settled / wanted.length : 0.4);
    showFailures();
}

/** A file that failed stays one while it is asked for again. */
function showFailures() {
    const isFailed = ({ stem, phase }) => phase === 'failed' || (phase === 'loading' && visit.failed.has(stem));
    visit.failed = new Set(visit.sectors.filter(isFailed).map(sector => sector.stem));
    const { size } = visit.failed;
    const places = size === 1 ? 'One place nearby' : `${size} places nearby`;
    if (size) hud.showTrouble(`${places} cannot be loaded: trying again.`);
    else hud.hideTrouble();
}

function commandsFor(view) {
    return {
        tap: event => view.tap(event),
        KeyH: () => hud.toggleHelp(),
        Slash: () => hud.toggleHelp(),
        Escape: () => hud.toggleHelp(false),
        KeyR: () => view.setPose(visit.homePose),
        KeyL: () => share(view),
    };
}

async function share(view) {
    const url = urlOfPlace(location.href, visit.current, view.pose());
    history.replaceState(null, '', url);
    try {
        await navigator.clipboard.writeText(url);
        hud.say('The link to this place is copied.');
    } catch {
        hud.say('The link to this place stands in the address bar.');
    }
}

/** What the server says about the root world, when it says no. */
async function reasonOf(error) {
    try {
        const response = await fetch(rootUrl(place.start));
        if (!response.ok) return (await response.json()).detail ?? response.statusText;
    } catch {
        return 'The server does not answer. Is `vicus serve` still running?';
    }
    return error?.message ?? String(error);
}

start().catch(async error => {
    hud.showProgress(1);
    hud.showTrouble(await reasonOf(error));
});
