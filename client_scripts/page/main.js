import { CityPlan } from './CityPlan.js';
import { Controls } from './Controls.js';
import { Flight } from './Flight.js';
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
    const walker = new Walker(view), travel = new Travel({ view, visit, hud, veil: byId('veil') }), plan = new CityPlan(world.degrees);
    const flight = new Flight({ view, visit, walker, plan, hud, frameRate, detail: settings.detail, form: settings.form });
    travel.leaving = () => flight.end();
    const parts = { view, world, visit, walker, travel, flight, frameRate, plan, ...sideParts({ world, visit, travel, flight, plan }) };
    Object.assign(parts, tourParts(parts));
    if (place.pose?.up !== undefined) await flight.startAt({ ...visit.homePose, ...place.pose });
    else if (place.pose) view.setPose({ ...visit.homePose, ...place.pose });
    const commands = commandsFor(parts);
    const walkTo = spot => travel.walkTo(spot, byId('window'), byId('goal'));
    const tap = (spot, event) => (flight.isUp ? flight.tap(spot, byId('window')) : view.tap(event) || walkTo(spot));
    parts.controls = new Controls(byId('window'), byId('stick'), commands, tap);
    parts.heights = new StepButtons(byId('heights'), { overview: commands.KeyT });
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

function sideParts({ world, visit, travel, flight, plan }) {
    const go = id => travel.toSector(id), goTo = viewpoint => travel.toViewpoint(viewpoint);
    const paper = new PlaceDocument({ plan, base: world.base, go, goTo });
    paper.showRights(world.rights);
    const map = new MapView(byId('map'), plan, (east, north) => {
        const sector = plan.sectorAt(east, north);
        if (flight.isUp) flight.flyTo({ east, north });
        else if (sector) travel.toPlace(sector.id, [east, north]);
        else hud.say('Nobody can walk there.');
    });
    const dialog = new SettingsDialog(settings, ({ level, line, test, detail, form }) => {
        visit.set({ level, line, test });
        if (detail !== flight.detail) return flight.setDetail(detail);
        if (form !== flight.form) return flight.setForm(form);
        return hud.say(level === null ? 'As many sectors as this device can.' : `Sectors around you: L${level}.`);
    });
    return { paper, map, dialog, sideAt: 0 };
}

function tourParts({ view, world, visit, walker, travel, flight, map }) {
    const moved = () => {
        visit.isJump = true;
        flight.end();
    };
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
    const above = ({ at, name }) => {
        flight.lookAt(at);
        hud.say(name);
    };
    const find = new TourDialog({ degrees: world.degrees, pose: () => view.pose(), play, jump, above, close: () => hud.toggleFind(false) });
    const shared = tourFromUrl(location.href);
    if (shared) find.start(shared);
    return { player, find };
}

function step(parts, seconds) {
    const { view, visit, walker, travel, flight, player, controls, pad, heights, frameRate } = parts, before = visit.records.length;
    const wish = heights.addTo(pad.addTo(controls.wish(), seconds), seconds);
    if (flight.isUp) return flyStep(parts, wish, seconds);
    const pose = view.pose();
    visit.step(pose, performance.now() / 1000);
    const { records } = visit;
    walker.setGround(records, visit.openDoors);
    hud.showDoor(visit.doorNear(pose));
    const hasMoved = player.step(wish, seconds) || walker.step(travel.wish(wish, pose, seconds), seconds);
    const isSettled = records.length > 0 && visit.sectors.every(sector => sector.phase !== 'loading');
    if (!hasMoved) frameRate.rest(isSettled ? seconds : 0);
    else if (records.length === before) frameRate.add(seconds);
    if (visit.here) hud.showPlace(visit.here);
    hud.showFailures(visit.failed.size);
    return showSideSometimes(parts);
}

/** The same for who flies: sectors rest, unless he is coming down. */
function flyStep(parts, wish, seconds) {
    const { flight, frameRate } = parts, { arrivals } = flight.flyover, hasMoved = flight.step(wish, seconds);
    if (!hasMoved) frameRate.rest(flight.flyover.isSettled ? seconds : 0);
    else if (flight.flyover.arrivals === arrivals) frameRate.add(seconds);
    hud.showDoor();
    showSideSometimes(parts);
}

function showSideSometimes(parts) {
    const now = performance.now() / 1000;
    if (now - parts.sideAt >= kSideSeconds) {
        parts.sideAt = now;
        showSide(parts);
    }
}

function showSide(parts) {
    if (parts.flight.isUp) return showSideAbove(parts);
    const { view, visit, travel, plan, map, paper, dialog } = parts, pose = view.pose(), progress = visit.files.progress(visit.missing(pose));
    const isShown = visit.sectors.every(({ phase }) => phase !== 'loading');   // what has come may still wait to be read
    hud.showProgress({ share: visit.here ? 0.2 + 0.8 * progress.bytes / progress.allBytes : 0.3, ...progress, isShown });
    for (const record of visit.records) plan.addRecord(record);
    travel.learnViewpoints();
    hud.showStatus({ i: visit.level, isMeasured: settings.level === null, files: visit.sectors.length });
    if (hud.isShown('side')) {
        map.show(pose, visit.sectors, visit.here);
        paper.show(visit.here, travel.viewpoints.around(pose));
    }
    if (hud.isShown('settings')) dialog.showFigures(figuresOf(visit));
    return null;
}

function showSideAbove({ view, world, visit, flight, plan, map, paper, dialog }) {
    const pose = view.pose(), { flyover, flyer } = flight;
    plan.around(pose.east, pose.north, 1);
    const below = plan.sectorAt(pose.east, pose.north);
    hud.showProgress({ share: flyover.isSettled ? 1 : 0.9 * flight.progress });
    hud.showText(`${flyover.figures.files} tiles · ${hud.bytes(flyover.figures.sentBytes)}`);
    hud.showBelow(below, flyer.height(pose));
    if (hud.isShown('side')) {
        map.show(pose, visit.sectors, undefined);
        if (below) paper.show({ names: [], gates: [], ...below }, []);
        else paper.showAbove(world.name);
    }
    if (hud.isShown('settings')) dialog.showFigures(figuresAbove(flight));
}

function figuresAbove({ flyover: { chosen, kept, bytes, figures, stage, mostBytes, form }, probed }) {
    const times = probed ? ` (a tile: ${probed.prisms.toFixed(1)} ms as polygons, ${probed.blockMap.toFixed(1)} ms as an image)` : '';
    return [
        ['Houses', `${form === 'prisms' ? 'polygons' : 'images'}${times}`],
        ['Tiles', `${chosen.draw.length} drawn, ${kept.size} kept, ${chosen.ask.length} asked for`],
        ['Error', `${Math.max(0, ...chosen.draw.filter(({ isFinest }) => !isFinest).map(({ onScreen }) => onScreen)).toFixed(1)} pixels at most`],
        ['Shapes', `${stage.shapes}`],
        ['Loaded', `${hud.bytes(figures.sentBytes)} in ${figures.files} tiles`],
        ['Kept', `${hud.bytes(bytes)} of at most ${hud.bytes(mostBytes)}`],
    ];
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

function commandsFor({ view, visit, travel, flight, player, find }) {
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
        KeyV: () => {
            player.setPlaying(false);
            flight.toggle();
        },
        KeyT: () => flight.overview(),
        KeyN: () => travel.next(), PageDown: () => travel.next(), KeyP: () => travel.previous(), PageUp: () => travel.previous(),
        KeyR: () => travel.to(visit.homePose),
        KeyL: () => share(view, visit, flight),
    };
}

function connectButtons({ map }, commands) {
    const actions = {
        'door-button': commands.KeyI,
        'fly-button': commands.KeyV, 'side-button': commands.KeyM, 'pad-button': commands.KeyB, 'settings-button': commands.KeyO, 'find-button': commands.KeyF, share: commands.KeyL,
        'view-next': commands.KeyN, 'view-previous': commands.KeyP,
        'map-in': () => map.zoomBy(1), 'map-out': () => map.zoomBy(-1), 'map-home': () => map.follow(),
    };
    for (const [id, action] of Object.entries(actions)) byId(id).addEventListener('click', () => action());
    byId('map-seen').addEventListener('change', event => { map.seen = event.target.checked; });
}

async function share(view, visit, flight) {
    const url = urlOfPlace(urlOfTour(location.href, null), visit.current, view.pose(), { level: visit.level, isMeasured: settings.level === null, isFlying: flight.isUp });
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
