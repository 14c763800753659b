import { CityPlan } from './CityPlan.js';
import { Controls } from './Controls.js';
import { FrameRate } from './FrameRate.js';
import { Hud } from './Hud.js';
import { MapView } from './MapView.js';
import { PlaceDocument } from './PlaceDocument.js';
import { SettingsDialog, storedSettings } from './Settings.js';
import { StepButtons } from './StepButtons.js';
import { TourDialog } from './TourDialog.js';
import { TourPlayer } from './TourPlayer.js';
import { Travel } from './Travel.js';
import { Visit } from './Visit.js';
import { Walker } from './Walker.js';
import { XIteAdapter } from './xIteAdapter.js';
import { fetchRootWorld } from './rootWorld.js';
import { placeFromUrl, rootUrl, tourFromUrl, urlOfPlace, urlOfTour } from './sharedPlace.js';

/** s between two looks at what changes slowly: map, document, figures. */
const kSideSeconds = 0.12;
/** CSS pixels from which the map is open at the start. */
const kWideWindow = 1100;

const hud = new Hud();
const place = placeFromUrl(location.href), settings = storedSettings(place);
const byId = id => document.getElementById(id);

/** The page: steers the visitor, loads the sectors around him, shows him where he is. */
async function start() {
    hud.showProgress({ share: 0.1 });
    const [view, world] = await Promise.all([XIteAdapter.create(byId('city')), fetchRootWorld(rootUrl(place.start))]);
    hud.showProgress({ share: 0.2 });
    hud.showCity(world.name);
    hud.showRights(world.rights);
    const frameRate = new FrameRate(scale => view.setContentScale(scale), view.isSoftwareRenderer());
    await view.show(world.text, world.base);
    const visit = new Visit(view, world, settings, text => console.info(text));
    visit.homePose = view.pose();
    if (place.pose) view.setPose({ ...visit.homePose, ...place.pose });
    const walker = new Walker(view), travel = new Travel({ view, visit, hud, veil: byId('veil') });
    const parts = { view, world, visit, walker, travel, frameRate, ...sideParts(world, visit, travel) };
    Object.assign(parts, tourParts(parts));
    const commands = commandsFor(parts);
    const tap = (spot, event) => view.tap(event) || travel.walkTo(spot, byId('window'), byId('goal'));
    parts.controls = new Controls(byId('window'), byId('stick'), commands, tap);
    parts.pad = new StepButtons(byId('pad'), { level: () => view.setPose({ ...view.pose(), pitch: 0 }) });
    connectButtons(parts, commands);
    if (innerWidth >= kWideWindow) hud.toggleSide(true);
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

function sideParts(world, visit, travel) {
    const plan = new CityPlan(world.degrees);
    const go = id => travel.toSector(id), goTo = viewpoint => travel.toViewpoint(viewpoint);
    const paper = new PlaceDocument({ plan, base: world.base, go, goTo });
    paper.showRights(world.rights);
    const map = new MapView(byId('map'), plan, (east, north) => {
        const sector = plan.sectorAt(east, north);
        if (sector) travel.toPlace(sector.id, [east, north]);
        else hud.say('Nobody can walk there.');
    });
    const dialog = new SettingsDialog(settings, ({ level, line, test }) => {
        visit.set({ level, line, test });
        hud.say(level === null ? 'As many sectors as this device can.' : `Sectors around you: L${level}.`);
    });
    return { plan, paper, map, dialog, sideAt: 0 };
}

function tourParts({ view, world, visit, walker, travel, map }) {
    const moved = () => { visit.isJump = true; };
    const ended = () => {
        map.route = null;
        history.replaceState(null, '', urlOfTour(location.href, null));
    };
    const player = new TourPlayer({ view, heights: () => walker.heights, hud, moved, ended });
    const play = async (tour, query) => {
        await visit.learn(tour.sectors[0].id);
        map.route = tour.points;
        map.follow();
        player.start(tour);
        history.replaceState(null, '', urlOfTour(location.href, query));
    };
    const jump = ({ sector, at: [east, north], look, name }) => {
        const [x, y] = [look[0] - east, look[1] - north];
        travel.to({ east, north, ...(Math.hypot(x, y) > 0.5 ? { heading: Math.atan2(x, y) } : {}) }, sector);
        hud.say(name);
    };
    const find = new TourDialog({ degrees: world.degrees, pose: () => view.pose(), play, jump, close: () => hud.toggleFind(false) });
    const shared = tourFromUrl(location.href);
    if (shared) find.start(shared);
    return { player, find };
}

function step(parts, seconds) {
    const { view, visit, walker, travel, player, controls, pad, frameRate } = parts, before = visit.records.length, pose = view.pose();
    visit.step(pose, performance.now() / 1000);
    const { records } = visit;
    walker.setGround(records, visit.openDoors);
    hud.showDoor(visit.doorNear(pose));
    const wish = pad.addTo(controls.wish(), seconds);
    const hasMoved = player.step(wish, seconds) || walker.step(travel.wish(wish, pose, seconds), seconds);
    const isSettled = records.length > 0 && visit.sectors.every(sector => sector.phase !== 'loading');
    if (!hasMoved) frameRate.rest(isSettled ? seconds : 0);
    else if (records.length === before) frameRate.add(seconds);
    if (visit.here) hud.showPlace(visit.here);
    hud.showFailures(visit.failed.size);
    const now = performance.now() / 1000;
    if (now - parts.sideAt >= kSideSeconds) {
        parts.sideAt = now;
        showSide(parts);
    }
}

function showSide({ view, visit, travel, plan, map, paper, dialog }) {
    const pose = view.pose(), progress = visit.files.progress(visit.missing(pose));
    hud.showProgress({ share: visit.here ? 0.2 + 0.8 * progress.bytes / progress.allBytes : 0.3, ...progress });
    for (const record of visit.records) plan.addRecord(record);
    travel.learnViewpoints();
    hud.showStatus({ i: visit.level, isMeasured: settings.level === null, files: visit.sectors.length });
    if (hud.isShown('side')) {
        map.show(pose, visit.sectors, visit.here);
        paper.show(visit.here, travel.viewpoints.around(pose));
    }
    if (hud.isShown('settings')) dialog.showFigures(figuresOf(visit));
}

function figuresOf({ level, planner, files, sectors }) {
    const { choice } = planner, { memory } = performance, speed = files.bytesPerSecond;
    const count = end => sectors.filter(({ stem }) => (stem.split('.')[1] ?? 'near') === end).length;
    return [
        ['Sectors', `L${level}: ${count('near')} near, ${count('far')} far, ${count('tall')} over roofs`],
        ['i', choice.fixed === null ? `measured, at most ${choice.limit} (${choice.reason})` : 'as chosen'],
        ['Shapes', `${planner.liveShapes()} of at most ${planner.options.shapeCap}`],
        ['Frames', choice.median === null ? 'not measured yet' : `${Math.round(1000 * choice.median)} ms`],
        ['Loaded', `${hud.bytes(files.loaded.bytes)} in ${files.loaded.files} files${speed ? `, ${hud.bytes(speed)}/s` : ''}`],
        ['On the way', hud.bytes(files.bytesInFlight)],
        ['Memory', memory ? hud.bytes(memory.usedJSHeapSize) : 'this browser does not tell'],
    ];
}

function commandsFor({ view, visit, travel, player, find }) {
    return {
        KeyH: () => hud.toggleHelp(), Slash: () => hud.toggleHelp(),
        Escape: () => hud.closeDialogs(),
        KeyM: () => hud.toggleSide(), KeyB: () => hud.togglePad(), KeyO: () => hud.toggleSettings(),
        KeyF: () => {
            hud.toggleFind();
            find.open();
        },
        KeyK: () => player.toggle(),
        KeyI: () => visit.touchDoor(view.pose(), performance.now() / 1000),
        KeyN: () => travel.next(), PageDown: () => travel.next(), KeyP: () => travel.previous(), PageUp: () => travel.previous(),
        KeyR: () => travel.to(visit.homePose),
        KeyL: () => share(view, visit),
    };
}

function connectButtons({ map }, commands) {
    const actions = {
        'side-button': commands.KeyM, 'pad-button': commands.KeyB, 'settings-button': commands.KeyO, 'find-button': commands.KeyF, share: commands.KeyL,
        'door-button': commands.KeyI,
        'view-next': commands.KeyN, 'view-previous': commands.KeyP,
        'map-in': () => map.zoomBy(1), 'map-out': () => map.zoomBy(-1), 'map-home': () => map.follow(),
    };
    for (const [id, action] of Object.entries(actions)) byId(id).addEventListener('click', () => action());
    byId('map-seen').addEventListener('change', event => { map.seen = event.target.checked; });
}

async function share(view, visit) {
    const url = urlOfPlace(urlOfTour(location.href, null), visit.current, view.pose(), { level: visit.level, isMeasured: settings.level === null });
    history.replaceState(null, '', url);
    try {
        await navigator.clipboard.writeText(url);
        hud.say('The link to this place is copied.');
    } catch {
        hud.say('The link to this place stands in the address bar.');
    }
}

start().catch(error => {
    hud.showProgress({ share: 1 });
    hud.showTrouble(error?.message ?? String(error));
});
