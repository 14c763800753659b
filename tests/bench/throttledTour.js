/**
 * The table of docs/visitor.md: what a visitor on a thin line misses. Walks a tour in the page, in real time, while the
 * browser's own emulation makes the line thin.
 *
 *     vicus build MAP -o city.gpkg --impostors yes && vicus serve city.gpkg --port 8080 &
 *     node tests/bench/throttledTour.js http://127.0.0.1:8080 [METRES] [SPEEDxMBIT ...]      1.4x20 5x4 ...
 *     node tests/bench/throttledTour.js http://127.0.0.1:8080 soak [KM] [SPEED]         I=2 before it: holds L_2
 *
 * A walk takes METRES / SPEED seconds; nothing is accelerated. Looked at in every frame: is a
 * file there (near, far or tall) of each sector that L_vis of the visitor's sector names; of each of those that it does not see over roofs
 * alone; of each that a gate leads to; and if not, does a picture stand in that gate; and of each of L_i, whatever i is then.
 * `soak` walks on and on and tells the page's heap after each km, garbage collected before.
 */
import { openBrowser, openTab } from '../browser/support/chromium.js';

const [origin, what = '1000', ...more] = process.argv.slice(2);
const kLatency = 40;                    // ms there and back
const kCases = [[1.4, 4], [1.4, 20], [1.4, 100], [5, 4], [5, 20], [5, 100]];
const kSettleSeconds = 90;
/** I=2 holds L_2; else the page chooses i by what it measures. */
const kLevel = process.env.I ? `&i=${process.env.I}` : '';
/** Small: where a program draws, a large view has few frames, and one file is put in per frame. */
const kWindow = { width: 480, height: 300 };

/** A walk of at least `metres` from the city's start: points [east, north]. */
async function routeOf(metres) {
    const root = await (await fetch(`${origin}/city.x3d`)).text(), start = root.match(/name='start'[^>]*value='([^']*)'/)[1];
    const { features } = await (await fetch(`${origin}/collections/sectors/items?limit=10000`)).json();
    let best = null;
    for (const { id } of features.filter((_, i) => i % Math.max(1, Math.floor(features.length / 60)) === 0)) {
        const response = await fetch(`${origin}/tours?from=${start}&to=${id}`);
        const tour = response.ok ? await response.json() : null;
        if (tour && (!best || tour.length > best.length)) best = tour;
    }
    const there = best.points.map(([east, north]) => [east, north]), points = [...there];
    for (let length = best.length, back = true; length < metres; length += best.length, back = !back)
        points.push(...(back ? [...there].reverse() : there).slice(1));
    return { start, points };
}

async function openPage(browser, start, mbit) {
    const tab = await openTab(browser.context), devtools = await browser.context.newCDPSession(tab.page);
    await devtools.send('Network.enable');
    await devtools.send('Network.setCacheDisabled', { cacheDisabled: false });
    if (mbit) await devtools.send('Network.emulateNetworkConditions', {
        offline: false, latency: kLatency, downloadThroughput: mbit * 125000, uploadThroughput: mbit * 125000 });
    await tab.page.goto(`${origin}/?start=${start}${kLevel}`);
    await tab.page.waitForFunction(() => window.vicus?.visit.firstStreetAt, null, { timeout: 180000 });
    await tab.page.waitForFunction(() => window.vicus.view.isIdle() && window.vicus.visit.sectors.every(({ phase }) => phase !== 'loading'),
        null, { timeout: 1000 * kSettleSeconds });
    return { tab, devtools };
}

/* Runs in the page: walks `metres` along the points at `speed` from where it stopped before. */
async function walkAlong({ points, speed, metres }) {
    const { view, visit } = window.vicus, { planner, impostors } = visit.loader;
    const seen = { seconds: 0, ofLevel: 0, levels: [0, 0, 0, 0], blocks: 0, missing: 0, streetMissing: 0, gateMissing: 0, gateBare: 0, frames: 0, shapes: 0, longest: 0 };
    const observer = new PerformanceObserver(list => {
        for (const { duration } of list.getEntries()) {
            seen.longest = Math.max(seen.longest, duration);
            ++seen.blocks;
        }
    });
    observer.observe({ entryTypes: ['longtask'] });
    const walked = window.tourAt ?? { leg: 1, along: 0 };
    let left = metres, last = performance.now();
    while (left > 0 && walked.leg < points.length) {
        await new Promise(requestAnimationFrame);
        const now = performance.now(), seconds = (now - last) / 1000, isLive = stem => planner.states.get(stem)?.phase === 'live';
        last = now;
        const has = id => ['', '.far', '.tall'].some(end => isLive(id + end));
        const here = planner.sectors.get(planner.current);
        const gates = (here?.gates ?? []).filter(({ to }) => to && !has(to));
        const isBare = ({ id }) => !((impostors.opacities.get(here.id)?.get(id) ?? 0) > 0);
        seen.seconds += seconds;
        ++seen.frames;
        const missing = here?.ground ? here.visible.filter(id => !has(id)) : [planner.current], overRoofs = new Set(here?.overRoofs);
        seen.levels[planner.i] += seconds;
        const wanted = planner.wanted([1000 * view.pose().east, 1000 * view.pose().north]);
        if ([...wanted.keys()].some(stem => !has(stem.split('.')[0]))) seen.ofLevel += seconds;
        if (missing.length) seen.missing += seconds;
        if (missing.some(id => !overRoofs.has(id))) seen.streetMissing += seconds;
        if (gates.length) seen.gateMissing += seconds;
        if (gates.some(isBare)) seen.gateBare += seconds;
        seen.shapes = Math.max(seen.shapes, planner.liveShapes());
        for (let step = Math.min(speed * seconds, left); step > 0 && walked.leg < points.length;) {
            const [a, b] = [points[walked.leg - 1], points[walked.leg]], length = Math.hypot(b[0] - a[0], b[1] - a[1]);
            const part = Math.min(step, length - walked.along);
            walked.along += part;
            step -= part;
            left -= part;
            const share = length ? walked.along / length : 1;
            const pose = { ...view.pose(), east: a[0] + share * (b[0] - a[0]), north: a[1] + share * (b[1] - a[1]), pitch: 0 };
            const turn = Math.atan2(b[0] - a[0], b[1] - a[1]) - pose.heading;
            pose.heading += Math.atan2(Math.sin(turn), Math.cos(turn)) * Math.min(1, 3 * seconds);
            view.setPose(pose);
            if (walked.along >= length) Object.assign(walked, { leg: walked.leg + 1, along: 0 });
        }
    }
    observer.disconnect();
    window.tourAt = walked;
    return { ...seen, walked: metres - left };
}

const percent = (part, all) => `${(100 * part / all).toFixed(part && part / all < 0.1 ? 2 : 1)} %`;
/** Which i, and how much of the time. */
const levelsOf = ({ levels, seconds }) => (process.env.I ? `${process.env.I}, held` : levels
    .map((time, i) => `${i} (${Math.round(100 * time / seconds)} %)`).filter((_, i) => levels[i] > 0).join(', '));
const sum = map => [...map.values()].reduce((all, bytes) => all + bytes, 0);

async function tours(metres, cases) {
    const { start, points } = await routeOf(metres);
    console.log('| walk | line | i | a sector of L_i is missing | a sector of L_vis is missing | one seen along streets | one behind a gate is missing | and no picture there | longest block | blocks over 50 ms | frames/s | kB | requests | live Shapes |');
    console.log('|---|---|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|');
    for (const [speed, mbit] of cases) {
        const browser = await openBrowser(kWindow);
        try {
            const { tab } = await openPage(browser, start, mbit);
            const before = { bytes: sum(tab.bytes), requests: tab.requests.length };
            const got = await tab.page.evaluate(walkAlong, { points, speed, metres });
            console.log(`| ${Math.round(got.walked)} m at ${speed} m/s | ${mbit} Mb/s | ${levelsOf(got)} | ${percent(got.ofLevel, got.seconds)} | ${percent(got.missing, got.seconds)} | ${percent(got.streetMissing, got.seconds)} | ${percent(got.gateMissing, got.seconds)} | `
                + `${percent(got.gateBare, got.seconds)} | ${Math.round(got.longest)} ms | ${got.blocks} | ${(got.frames / got.seconds).toFixed(1)} | `
                + `${Math.round((sum(tab.bytes) - before.bytes) / 1000)} | ${tab.requests.length - before.requests} | ${got.shapes} |`);
        } finally {
            await browser.close();
        }
    }
}

async function soak(km, speed) {
    const { start, points } = await routeOf(1000 * km), browser = await openBrowser(kWindow);
    try {
        const { tab, devtools } = await openPage(browser, start, 0);
        await devtools.send('HeapProfiler.enable');
        await devtools.send('Performance.enable');
        const heap = async () => {
            for (let i = 0; i < 3; ++i) {   // what finalizers let go in the first is collected in the next
                await devtools.send('HeapProfiler.collectGarbage');
                await tab.page.waitForTimeout(300);
            }
            const { metrics } = await devtools.send('Performance.getMetrics');
            return [...['Nodes', 'JSEventListeners'].map(name => metrics.find(metric => metric.name === name).value),
                (await devtools.send('Runtime.getHeapUsage')).usedSize / 1e6];
        };
        console.log('| walked | time | heap | nodes | listeners | files there | live Shapes |\n|--:|--:|--:|--:|--:|--:|--:|');
        let seconds = 0;
        for (let done = 0; done <= km; ++done) {
            const now = await tab.page.evaluate(() => ({ files: window.vicus.visit.sectors.length, shapes: window.vicus.visit.planner.liveShapes() }));
            const [nodes, listeners, megabytes] = await heap();
            console.log(`| ${done} km | ${(seconds / 60).toFixed(1)} min | ${megabytes.toFixed(1)} MB | ${nodes} | ${listeners} | ${now.files} | ${now.shapes} |`);
            if (done < km) seconds += (await tab.page.evaluate(walkAlong, { points, speed, metres: 1000 })).seconds;
        }
    } finally {
        await browser.close();
    }
}

if (what === 'soak') await soak(Number(more[0] ?? 5), Number(more[1] ?? 5));
else await tours(Number(what), more.length ? more.map(text => text.split('x').map(Number)) : kCases);
