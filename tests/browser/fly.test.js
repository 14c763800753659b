// The city from above: leaving the ground, tiles, landing; /flyover.x3d without the page.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { faultsOfPage } from './support/accessibility.js';
import { compareWithReference } from './support/blockMapPixels.js';
import { openBrowser, openTab } from './support/chromium.js';
import { cities, largeCities, serveCity } from './support/vicusServer.js';

const kShots = process.env.VICUS_SHOTS ?? 'out';
/** Poses [east, north, up, heading, pitch] that a flight passes, metres and degrees. */
const kPath = [[0, -420, 260, 0, -35], [-60, -160, 90, 25, -22], [80, 60, 70, 120, -12], [150, 150, 400, 225, -50]];

const made = { ...cities(), ...largeCities() };
for (const [name, make] of Object.entries(made)) test(`flying over ${name}`, { timeout: 900000 }, async t => {
    mkdirSync(kShots, { recursive: true });
    const server = await serveCity(make), browser = await openBrowser({ width: 1024, height: 640 });
    t.after(async () => {
        await browser.close();
        await server.stop();
    });
    const open = async rest => {
        const tab = await openTab(browser.context);
        await tab.page.addInitScript(watchBlocks);
        await tab.page.goto(`${server.origin}/${rest}`);
        await tab.page.waitForFunction(() => window.vicus?.visit.firstStreetAt || window.vicus?.flight.isUp, null, { timeout: 180000 });
        return tab;
    };

    await t.test('a shared link begins above; on the path no hole, no error too large, nothing twice', async () => {
        const tab = await open(linkOf(kPath[0])), { page } = tab, figures = [];
        let skies = 0;
        const overview = await page.waitForFunction(() => window.vicus.flight.flyover?.figures.firstAt, null, { timeout: 60000 });
        const bytesToOverview = await page.evaluate(() => window.vicus.flight.flyover.kept.get('0/0/0').mesh.sentBytes);
        assert.ok(bytesToOverview < 40000, `${bytesToOverview} bytes until the overview`);
        for (const [i, pose] of kPath.entries()) {
            await page.evaluate(glideTo, pose);
            await settle(page);
            const drawn = await page.evaluate(stateOfTiles);
            assert.deepEqual(drawn.tooCoarse, [], `pose ${i}`);
            assert.ok(drawn.bytes <= drawn.mostBytes, `${drawn.bytes} bytes kept`);
            figures.push(drawn);
            await page.screenshot({ path: join(kShots, `${name}-fly-${i}.png`) });
            await page.evaluate(paintSky, true);
            await page.waitForTimeout(800);
            const { above, below, holes } = await page.evaluate(countHoles, (await page.screenshot()).toString('base64'));
            await page.evaluate(paintSky, false);
            skies += above;
            assert.ok(below > 20000, `${below} pixels below the horizon`);
            assert.equal(holes, 0, `pose ${i}: ${holes} pixels of ${below} show what lies behind the city`);
        }
        assert.ok(skies > 1000, 'the sky was never seen: holes would not have been, either');
        const fetched = tab.requests.map(({ path }) => path).filter(path => path.startsWith('/blockmaps/'));
        assert.equal(new Set(fetched).size, fetched.length, 'a tile was fetched twice');
        assert.ok(fetched.length > 8);
        assert.deepEqual(tab.complaints, []);
        const block = await page.evaluate(() => window.longestBlock);
        t.diagnostic(`overview after ${Math.round(await overview.jsonValue())} ms and ${bytesToOverview} B; ${figures.at(-1).files} tiles, ${figures.at(-1).sentBytes} B; ` +
            `at most ${Math.max(...figures.map(({ drawn }) => drawn))} drawn; longest block ${Math.round(block)} ms`);
        await page.close();
    });

    await t.test('by keys alone: up, round, down again at the same place and heading', async () => {
        const tab = await open(''), { page } = tab;
        await page.waitForFunction(() => window.vicus.visit.here, null, { timeout: 120000 });
        const before = await page.evaluate(() => window.vicus.view.pose());
        await page.keyboard.press('KeyV');
        await page.waitForFunction(() => window.vicus.flight.phase === 'flying' && window.vicus.flight.swapped, null, { timeout: 120000 });
        const above = await page.evaluate(() => window.vicus.view.pose());
        assert.ok(above.up > before.up + 60, `${above.up} m`);
        assert.equal(await page.evaluate(() => window.vicus.view.browser.currentScene.getNamedNode('WORLD').visible), false);
        assert.match(await page.textContent('#kind'), /\d+ m above the ground/);
        assert.equal(await page.textContent('#fly-button'), 'Land');
        assert.deepEqual(await faultsOfPage(page), []);
        for (const [key, test] of [['Space', p => p.up > above.up + 3], ['KeyW', p => p.north !== above.north], ['KeyC', p => p.up < above.up]]) {
            await page.keyboard.down(key);
            await until(page, test);
            await page.keyboard.up(key);
        }
        const spot = await page.evaluate(async () => {
            const { flight, view } = window.vicus;
            const { point } = await flight.findGround([view.pose().east, view.pose().north]);
            view.setPose({ ...view.pose(), east: point[0], north: point[1] });
            return { point, heading: view.pose().heading };
        });
        await page.keyboard.press('KeyV');
        await page.waitForFunction(() => window.vicus.flight.phase === 'walking', null, { timeout: 180000 });
        const { pose, here, visible } = await page.evaluate(() => ({ pose: window.vicus.view.pose(), here: window.vicus.visit.here?.id,
            visible: window.vicus.view.browser.currentScene.getNamedNode('WORLD').visible }));
        assert.ok(Math.hypot(pose.east - spot.point[0], pose.north - spot.point[1]) < 0.01, JSON.stringify([pose, spot]));
        assert.ok(Math.abs(Math.sin(pose.heading - spot.heading)) < 1e-3);
        assert.ok(here && visible);
        assert.equal(await page.evaluate(() => window.vicus.flight.flyover.stage.shapes), 0, 'tiles are still drawn');
        await page.screenshot({ path: join(kShots, `${name}-fly-landed.png`) });
        await page.keyboard.down('KeyW');
        await until(page, p => Math.hypot(p.east - pose.east, p.north - pose.north) > 0.5);
        await page.keyboard.up('KeyW');
        assert.deepEqual(tab.complaints, []);
        await page.close();
    });

    await t.test('above a roof he lands in the nearest street; who flies cannot sink into roofs', async () => {
        const { page, complaints } = await open(linkOf([0, -200, 150, 0, -40]));
        await settle(page);
        const roof = await page.evaluate(() => {
            const { flight: { flyover } } = window.vicus, mesh = flyover.heights.finest(0, 0);
            const houses = [...Array(mesh.roofs.length / 5).keys()].map(i => [...mesh.roofs.subarray(5 * i, 5 * i + 5)]);
            const [west, south, east, north, up] = houses.sort((a, b) => b[4] - a[4])[0];
            return { east: (west + east) / 2, north: (south + north) / 2, up };
        });
        await page.evaluate(({ east, north, up }) => window.vicus.view.setPose({ ...window.vicus.view.pose(), east, north, up: up + 30 }), roof);
        await settle(page);
        await page.keyboard.down('KeyC');
        await page.waitForTimeout(2500);
        await page.keyboard.up('KeyC');
        const { up } = await page.evaluate(() => window.vicus.view.pose());
        assert.ok(up >= roof.up + 4 && up < roof.up + 30, `${up} m over a roof of ${roof.up} m`);
        await page.keyboard.press('KeyV');
        await page.waitForFunction(() => window.vicus.flight.phase === 'walking', null, { timeout: 180000 });
        const isOnGround = await page.evaluate(() => {
            const { east, north } = window.vicus.view.pose();
            return window.vicus.walker.ground.isOnGround([east * 1000, north * 1000]);
        });
        assert.ok(isOnGround);
        assert.deepEqual(complaints, []);
        await page.close();
    });

    await t.test('a click on the ground lands there, one on a roof flies nearer', async () => {
        const { page, complaints } = await open(linkOf([0, -200, 150, 0, -40]));
        await settle(page);
        const [roof, ground] = await page.evaluate(async () => {
            const { flight } = window.vicus, found = [null, null];
            const { placeBelow } = await import('/client/core/placeBelow.js');
            await flight.plan.whole(0, -100, 300);
            for (let y = -0.6; y < 0.4; y += 0.05)
                for (let x = -0.5; x < 0.5; x += 0.05) {
                    const place = placeBelow(flight.eye(), [x, y], flight.flyover.heights);
                    if (place?.isRoof) found[0] ??= { at: [x, y], ...place };
                    else if (place?.away < 400 && flight.plan.sectorAt(...place.point)) found[1] ??= { at: [x, y], ...place };
                }
            return found;
        });
        const click = async ({ at: [x, y] }) => {
            const { width, height } = await page.evaluate(() => document.getElementById('window').getBoundingClientRect().toJSON());
            await page.mouse.click((x + 1) / 2 * width, (1 - y) / 2 * height);
        };
        await click(ground);
        await page.waitForFunction(() => window.vicus.flight.phase === 'walking', null, { timeout: 180000 });
        const pose = await poseOf(page);
        assert.ok(Math.hypot(pose.east - ground.point[0], pose.north - ground.point[1]) < 1.5, JSON.stringify([pose, ground]));
        await page.goto('about:blank');
        await page.goto(`${server.origin}/${linkOf([0, -200, 150, 0, -40])}`);
        await page.waitForFunction(() => window.vicus?.flight.isUp, null, { timeout: 120000 });
        await settle(page);
        await page.keyboard.press('KeyM');   // the document has a title wherever one is
        await page.waitForFunction(() => /\w/.test(document.getElementById('document-title').textContent), null, { timeout: 30000 });
        await page.keyboard.press('KeyM');
        await click(roof);
        await page.waitForFunction(() => window.vicus.flight.glide, null, { timeout: 30000 });
        await page.waitForFunction(() => !window.vicus.flight.glide, null, { timeout: 60000 });
        const above = await poseOf(page);
        assert.ok(Math.hypot(above.east - roof.point[0], above.north - roof.point[1], above.up - roof.up) < 0.7 * roof.away);
        assert.deepEqual(complaints, []);
        await page.close();
    });

    await t.test('a place that was searched for is seen from above; the link restores it', async () => {
        const { page, complaints } = await open('');
        await page.waitForFunction(() => window.vicus.visit.here?.name, null, { timeout: 120000 });
        const wanted = await page.evaluate(() => window.vicus.visit.here.name);
        await page.keyboard.press('KeyF');
        await page.fill('#find-to', wanted);
        await page.waitForSelector('#find-to-list li');
        await page.keyboard.press('Enter');
        await page.click('#find-above');
        await page.waitForFunction(() => window.vicus.flight.phase === 'flying' && !window.vicus.flight.glide, null, { timeout: 120000 });
        await page.keyboard.press('KeyL');
        await page.waitForFunction(() => location.hash.split(',').length === 5);
        const pose = await page.evaluate(() => window.vicus.view.pose()), url = page.url();
        await page.goto('about:blank');
        await page.goto(url);
        await page.waitForFunction(() => window.vicus?.flight.isUp, null, { timeout: 120000 });
        const again = await page.evaluate(() => window.vicus.view.pose());
        for (const key of ['east', 'north', 'up']) assert.ok(Math.abs(again[key] - pose[key]) < 0.1, key);
        assert.deepEqual(complaints, []);
        await page.close();
    });

    await t.test('the BlockMap shader meets what a slow caster meets', async () => {
        const { page, complaints } = await open(linkOf(kPath[0]));
        await settle(page);
        const [key, side] = await page.evaluate(() => {
            const { tree } = window.vicus.flight.flyover;
            const { key, side } = [...tree.tiles.values()].filter(({ blockMapError }) => blockMapError !== null).at(-1);
            return [key, side];
        });
        const from = (x, y, up, heading, pitch) => ({ eye: [x * side, y * side, up * side], heading, pitch, half: [0.8, 0.5] });
        const views = [from(0.5, -0.4, 0.5, 0, -0.6), from(1.3, 1.2, 0.25, -2.3, -0.25), from(0.5, 0.5, 0.9, 1, -1.45), from(0.4, 0.45, 0.35, 2, -0.7)];
        const found = await page.evaluate(compareWithReference, { path: `/blockmaps/${key}`, views, size: [120, 80] });
        assert.ok(found.hits > 0.4 * found.rays, JSON.stringify(found));
        assert.ok(found.wrong <= 8, JSON.stringify(found));   // rays that graze an edge, of 38,400
        assert.deepEqual(complaints, []);
        const probed = await page.evaluate(() => window.vicus.flight.probed);
        assert.ok(probed.prisms > 0 && probed.blockMap > 0);
        assert.equal(await page.evaluate(() => window.vicus.flight.flyover.form), probed.blockMap < probed.prisms ? 'blockMap' : 'prisms');
        t.diagnostic(`BlockMap ${key}: ${JSON.stringify(found)}; a frame of a tile takes ${JSON.stringify(probed)} ms`);
        await page.evaluate(() => { window.vicus.flight.flyover.pixels = 12; });
        await page.keyboard.press('KeyO');
        await page.selectOption('#set-form', 'blockMap');
        await page.keyboard.press('Escape');
        await page.waitForFunction(() => {
            const { flyover } = window.vicus.flight, { draw } = flyover.chosen;
            return draw.length && draw.every(({ tile }) => flyover.isThere(tile)) && draw.some(({ tile }) => flyover.formOf(tile) === 'blockMap') && flyover.fades.isCalm;
        }, null, { timeout: 120000 });
        await page.screenshot({ path: join(kShots, `${name}-fly-blockmaps.png`) });
        assert.deepEqual(complaints, []);
        await page.close();
    });

    await t.test('/flyover.x3d flies without the page', async () => {
        const tab = await openTab(browser.context), { page } = tab;
        const body = `<!DOCTYPE html><script type="module" src="/x_ite/15.0.1/dist/x_ite.min.mjs"></script>
            <x3d-canvas src="/flyover.x3d" splashScreen="false" notifications="false" style="width: 640px; height: 480px"></x3d-canvas>`;
        await page.route('**/bare.html', reply => reply.fulfill({ contentType: 'text/html', body }));
        await page.goto(`${server.origin}/bare.html`);
        await page.waitForFunction(() => {
            const scene = document.querySelector('x3d-canvas')?.browser?.currentScene;
            const clock = scene && Array.from(scene.rootNodes).length ? scene.getNamedNode('CLOCK') : null;
            const shapes = clock ? Array.from(scene.getNamedNode('TILES').children).reduce((sum, { children }) => sum + children.length, 0) : 0;
            return shapes > 4 && !clock.enabled;
        }, null, { timeout: 180000 });
        await page.screenshot({ path: join(kShots, `${name}-flyover-x3d.png`) });
        assert.deepEqual(tab.complaints, []);
        assert.ok(tab.requests.every(({ path }) => !/^\/client\/(page|bundle)\//.test(path)), 'the page took part');
        await page.close();
    });
});

const linkOf = ([east, north, up, heading, pitch]) => `#${[east, north, heading, pitch, up].join(',')}`;

/** Waits until the pose is as the test wants it. */
async function until(page, test) {
    for (const end = Date.now() + 60000; !test(await poseOf(page));) {
        assert.ok(Date.now() < end, String(test));
        await page.waitForTimeout(100);
    }
}
const poseOf = page => page.evaluate(() => window.vicus.view.pose());

async function settle(page) {
    await page.waitForFunction(() => {
        const { flight } = window.vicus, quiet = !flight.glide && flight.flyover?.isSettled && window.vicus.view.isIdle();
        window.quietSince = quiet ? window.quietSince || performance.now() : 0;
        return quiet && performance.now() - window.quietSince > 1200;   // every pixel is drawn once he rests
    }, null, { timeout: 120000 });
}

/* What follows runs in the page. */

function watchBlocks() {
    window.longestBlock = 0;
    new PerformanceObserver(list => {
        for (const { duration } of list.getEntries()) window.longestBlock = Math.max(window.longestBlock, duration);
    }).observe({ type: 'longtask', buffered: true });
}

function glideTo([east, north, up, heading, pitch]) {
    window.quietSince = 0;
    window.vicus.flight.flyTo({ east, north, up, heading: heading * Math.PI / 180, pitch: pitch * Math.PI / 180 });
}

function stateOfTiles() {
    const { flyover } = window.vicus.flight, { draw } = flyover.chosen;
    const tooCoarse = draw.filter(({ tile, quadrants, onScreen }) =>
        onScreen > flyover.pixels * flyover.strain && tile.children.some((child, q) => child && quadrants & (1 << q) && !flyover.isThere(child) &&
            flyover.chosen.ask.some(({ tile: asked, rank }) => asked === child && rank === 'A')));
    return { tooCoarse: tooCoarse.map(({ tile }) => tile.key), drawn: draw.length, bytes: flyover.bytes, mostBytes: flyover.mostBytes,
        files: flyover.figures.files, sentBytes: flyover.figures.sentBytes };
}

/** Paints the sky behind the city in a colour that nothing else has. */
function paintSky(isMagenta) {
    const { browser, X3D } = window.vicus.view;
    const sky = Array.from(browser.currentScene.rootNodes).find(node => node.getNodeTypeName() === 'Background');
    const values = colours => Array.from(colours, ({ r, g, b }) => [r, g, b]);
    window.skyColours ??= { skyColor: values(sky.skyColor), groundColor: values(sky.groundColor) };
    for (const [field, colours] of Object.entries(window.skyColours))
        sky[field] = new X3D.MFColor(...colours.map(colour => new X3D.SFColor(...(isMagenta ? [1, 0, 1] : colour))));
}

/** Pixels of a picture in which that colour shows: { above, below, holes } the horizon. */
async function countHoles(base64) {
    const picture = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
    const canvas = new OffscreenCanvas(picture.width, picture.height), context = canvas.getContext('2d');
    context.drawImage(picture, 0, 0);
    const { width, height } = picture, { data } = context.getImageData(0, 0, width, height);
    const { pitch, half } = window.vicus.flight.eye(), horizon = height / 2 * (1 - Math.tan(-pitch) / half[1]), found = { above: 0, below: 0, holes: 0 };
    for (let row = 0; row < height; ++row)
        for (let column = 0; column < width; ++column) {
            const i = 4 * (row * width + column), isSky = data[i] > 230 && data[i + 1] < 40 && data[i + 2] > 230;
            if (row < horizon) found.above += isSky;
            else if (row > horizon + 14) found[isSky ? 'holes' : 'below'] += 1;   // the ground ends 20 km away
        }
    return found;
}
