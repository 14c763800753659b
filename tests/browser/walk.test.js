import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { idOf } from '../../client_scripts/core/sectorRecord.js';
import { GroundWalls } from '../../client_scripts/core/GroundWalls.js';
import { boxContains, distance, distanceToEdges, isInside, nearestOnSegment } from '../../client_scripts/core/planGeometry.js';
import { openBrowser } from './support/chromium.js';
import { CityMap, startWithRoute } from './support/cityMap.js';
import { cities, serveCity } from './support/vicusServer.js';
import { Visitor } from './support/Visitor.js';

const kGates = 4;
const kRestSeconds = 3;   // SectorPlanner: who stands so long walks to no gate any more
const kKeepSeconds = 10;
const kLagSeconds = 6;                // a slow machine's frames between leaving and giving back
const kShapeCap = 1500;
const kWellInsideMm = 2500;             // more than the hysteresis and what Visitor.walk calls reached
const kFirstSectorBytes = 150000;
const kTries = 3;
const kShots = process.env.VICUS_SHOTS ?? 'out';

for (const [name, make] of Object.entries(cities())) test(`a walk in ${name}`, { timeout: 1200000 }, async t => {
    mkdirSync(kShots, { recursive: true });
    const server = await serveCity(make), browser = await openBrowser();
    t.after(async () => {
        await browser.close();
        await server.stop();
    });
    const map = new CityMap(server.origin);
    const start = await startWithRoute(map, kGates);
    const route = await map.route(start, kGates);
    // L_1 by choice: what a slow machine measures is no matter of this test.
    const visitor = await Visitor.open(browser.context, `${server.origin}/?start=${start}&i=1`);
    const shoot = label => visitor.page.screenshot({ path: join(kShots, `${name}-${label}.png`) });

    await t.test('starts in the given sector, complete within the byte budget', async () => {
        await visitor.streetTime();
        assert.equal((await visitor.now()).current, start);
        await visitor.settle();
        const page = bytesBeside(visitor, ['/city.x3d', '/']), sector = await bytesOfParcel(server.origin, start);
        t.diagnostic(`${start}: ${page} bytes of page and root world without X_ITE, ${sector} of the sector with its images`);
        assert.ok(page > 20000 && sector > 5000 && page + sector <= kFirstSectorBytes, `${page} and ${sector} bytes`);
        await shoot('start');
    });

    await t.test(`walks through ${kGates} gates and back, with L_1 around at each`, async () => {
        const there = [...route], back = [...route].reverse();
        for (const chain of [there, back])
            for (let i = 1; i < chain.length; ++i) {
                await walkThroughGate(visitor, map, chain, i);
                await assertSurroundings(visitor, map, chain[i]);
                if (chain === there) await shoot(`gate-${i}`);
            }
        const visited = (await visitor.diary()).sectors.map(entry => entry.current);
        t.diagnostic(`walked ${visited.join(' > ')}`);
        await shoot('back');
    });

    await t.test('walls stop the visitor', async () => {
        const { current, pose } = await visitor.now();
        const { wall, path } = await map.wallInReach(current, [pose.east * 1000, pose.north * 1000]);
        await visitor.walk(path, { within: 0.5, run: false });
        await visitor.face([(wall[0][0] + wall[1][0]) / 2, (wall[0][1] + wall[1][1]) / 2]);
        await visitor.hold('KeyW', 3000);
        const end = (await visitor.now()).pose, point = [end.east * 1000, end.north * 1000];
        assert.ok(new GroundWalls([await map.sector(current)]).isOnGround(point), `off the ground at ${point}`);
        const gap = distance(nearestOnSegment(wall[0], wall[1], point), point) / 1000;
        assert.ok(gap >= 0.2 && gap < 1.5, `${gap} m from the wall`);
        assert.ok(end.up > 1 && end.up < 2.5, `eye at ${end.up} m`);
        await shoot('wall');
    });

    await t.test('after a while only L_1 is left: gate neighbours near, the rest of its list far or tall', async () => {
        await visitor.page.waitForTimeout(1000 * (kRestSeconds + kKeepSeconds + 2));
        await visitor.settle();
        const { current, asked } = await visitor.now(), record = await map.record(current);
        const near = new Set([current, ...record.gates.map(gate => gate.to).filter(Boolean)]);
        const beyond = (record.visible ?? []).filter(id => !near.has(id));
        const tall = beyond.filter(id => record.over_roofs?.includes(id)), far = beyond.filter(id => !tall.includes(id));
        t.diagnostic(`around ${current}: ${near.size} near, ${far.length} far, ${tall.length} tall`);
        assert.deepEqual(asked, [...near, ...far.map(id => `${id}.far`), ...tall.map(id => `${id}.tall`)].sort());
    });

    await t.test('nothing is fetched twice but what was given back; Shapes stay under the cap', async () => {
        const { unloads } = await visitor.diary();
        for (const [path, count] of visitor.fetches(/^\/sectors\/[^.]+(\.far|\.tall)?\.x3d$/)) {
            const stem = path.slice('/sectors/'.length, -'.x3d'.length);
            const unloaded = unloads[stem] ?? 0;
            assert.ok(count <= 1 + unloaded, `${path} fetched ${count} times, given back ${unloaded} times`);
        }
        for (const [path, count] of visitor.fetches(/^\/(client|x_ite|city)/))
            assert.equal(count, 1, `${path} fetched ${count} times`);
        const shapes = await visitor.shapes();
        t.diagnostic(`${shapes} Shapes`);
        assert.ok(shapes > 0 && shapes < kShapeCap, `${shapes} Shapes`);
    });

    await t.test('L_2, chosen by the address: breadth-first, near, far and tall; L_0 again by the settings', async () => {
        const { current } = await visitor.now(), guest = await Visitor.open(browser.context, `${server.origin}/?start=${current}&i=2`);
        await guest.streetTime();
        const wanted = await map.filesWithin(current, 2);
        const { live } = await guest.waitFor(({ live: there }) => there.length === wanted.length, 240);
        assert.deepEqual(live, wanted);
        t.diagnostic(`L_2 of ${current}: ${wanted.length} files, ${await guest.shapes()} Shapes`);
        await shoot('l2');
        await guest.page.keyboard.press('KeyO');
        await guest.page.selectOption('#set-level', '0');
        const left = await guest.waitFor(({ asked }) => asked.length < 6, 60);
        assert.ok(left.live.includes(current) && left.live.length < 6, `${left.live}`);
        assert.deepEqual(guest.complaints, []);
        await guest.page.close();
    });

    await t.test('the console stays silent', () => assert.deepEqual(visitor.complaints, []));

    // A figure, not a judgement: how fast the machine is says nothing about the program (docs/figures.md).
    await t.test('tells how soon a warm browser is in the street', async () => {
        const times = [];
        for (let i = 0; i < kTries; ++i) {
            const next = await Visitor.open(browser.context, `${server.origin}/?start=${start}`);
            times.push(await next.streetTime());
            await next.page.close();
        }
        t.diagnostic(`warm browser, page to street: ${times.map(Math.round).join(', ')} ms`);
        assert.ok(times.every((ms) => ms > 0));
    });
});

function bytesBeside(visitor, paths) {
    let sum = 0;
    for (const [path, bytes] of visitor.bytes) if (paths.includes(path) || path.startsWith('/client/')) sum += bytes;
    return sum;
}

/** As sent: what the page asks for first (page/SectorTexts.js). */
async function bytesOfParcel(origin, id) {
    const response = await fetch(`${origin}/parcels?files=${id}&without=`, { headers: { 'Accept-Encoding': 'br' } });
    await response.arrayBuffer();
    return Number(response.headers.get('Content-Length'));
}

/** From where the visitor is in chain[i - 1] through the gate into chain[i], beyond the hysteresis. */
async function walkThroughGate(visitor, map, chain, i) {
    const { pose } = await visitor.now(), from = [pose.east * 1000, pose.north * 1000];
    const gate = await map.gateMiddle(chain[i - 1], chain[i]);
    const onward = i + 1 < chain.length
        ? await map.path(chain[i], gate, await map.gateMiddle(chain[i], chain[i + 1]))
        : (await map.wallInReach(chain[i], gate)).path;
    const leg = await map.path(chain[i - 1], from, gate);
    assert.ok(leg && onward, `no way from ${chain[i - 1]} to ${chain[i]}`);
    await visitor.walk([...leg, ...untilWellInside(await map.sector(chain[i - 1]), gate, onward)]);
    await visitor.isIn(chain[i]);
}

/** The way from the gate until the visitor is well off the ground that was left: beyond the hysteresis. */
function untilWellInside(left, gate, onward) {
    const way = [];
    let from = gate;
    for (const to of onward) {
        const steps = Math.ceil(distance(from, to) / 250);
        for (let i = 1; i <= steps; ++i) {
            const point = [0, 1].map(k => Math.round(from[k] + (to[k] - from[k]) * i / steps));
            const isOff = !(boxContains(left.box, point) && isInside(left.ground, point));
            if (isOff && distanceToEdges(left.ground, point) > kWellInsideMm) return [...way, point];
        }
        way.push(to);
        from = to;
    }
    return way;
}

/** The file or a fuller one of the same sector: what was needed a moment ago is kept for a while. */
function isShown(stem, live) {
    const id = idOf(stem);
    return live.includes(stem) || live.includes(id) || (stem === `${id}.tall` && live.includes(`${id}.far`));
}

/** L_1 is there; what else is there belonged to a sector left no longer ago than the hysteresis allows. */
async function assertSurroundings(visitor, map, current) {
    const wanted = await map.filesAround(current);
    const { live, failed } = await visitor.waitFor(({ live: there }) => wanted.every(stem => isShown(stem, there)));
    for (const stem of wanted) assert.ok(isShown(stem, live), `${stem} of L_1(${current}) is not there: ${live}`);
    assert.deepEqual(failed, []);
    await visitor.settle();
    const { sectors } = await visitor.diary();
    const now = await visitor.page.evaluate(() => performance.now());
    const allowed = new Set(wanted);
    for (const [i, { current: id }] of sectors.entries()) {
        const leftAt = sectors[i + 1]?.at ?? now;
        if (now - leftAt > 1000 * (kKeepSeconds + kLagSeconds)) continue;
        for (const stem of await map.filesAround(id)) allowed.add(stem);
    }
    // What is seen from behind a gate that he walked to, too.
    const recent = new Set([current]);
    for (const [i, { current: id }] of sectors.entries())
        if (now - (sectors[i + 1]?.at ?? now) <= 1000 * (kKeepSeconds + kLagSeconds)) recent.add(id);
    for (const id of recent)
        for (const { to } of (await map.record(id)).gates)
            for (const stem of to ? await map.filesAround(to) : []) allowed.add(stem).add(`${idOf(stem)}.far`);
    // Asked for after the time it is judged by: what was there before the page settled may be gone since.
    const { live: still } = await visitor.now();
    for (const stem of still) assert.ok(allowed.has(stem), `${stem} is there in ${current}, though left long ago`);
}
