import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { pointInside } from '../../client_scripts/core/pointInside.js';
import { openBrowser, openTab } from './support/chromium.js';
import { firstDoor } from './support/cityMap.js';
import { Visitor } from './support/Visitor.js';
import { cities, serveCity } from './support/vicusServer.js';

const kShots = process.env.VICUS_SHOTS ?? 'out';
/** m before the door where the visitor clicks, and at which a shut door stops him at the latest. */
const kStand = 3.2, kStop = 0.29;
const kOpenSeconds = 30, kReleaseSeconds = 40;
const kEye = 1.7;

/** Nothing of ours but the world: X_ITE and an x3d-canvas. */
const bareWorld = file => `<!DOCTYPE html><script type="module" src="/x_ite/15.0.1/dist/x_ite.min.mjs"></script>
<x3d-canvas src="${file}" splashScreen="false" notifications="false" style="width: 640px; height: 480px"></x3d-canvas>`;

const { town } = cities();
test('doors in the town', { timeout: 900000, skip: town ? false : 'another city was asked for' }, async t => {
    mkdirSync(kShots, { recursive: true });
    const server = await serveCity(town), browser = await openBrowser();
    t.after(async () => {
        await browser.close();
        await server.stop();
    });
    const house = await firstDoor(server.origin);
    await t.test('the page: in, through the house, and out again', t => walkThroughHouse(t, browser, server, house));
    await t.test('the world without the page', () => openInWorld(browser, server, house));
    await t.test('a visit may begin inside', () => startInside(browser, server, house));
});

async function walkThroughHouse(t, browser, server, { street, room, door, at, heading }) {
    const visitor = await Visitor.open(browser.context, `${server.origin}/?start=${street}&i=1`), { page } = visitor;
    const shoot = label => page.screenshot({ path: join(kShots, `doors-${label}.png`) });
    await visitor.streetTime();
    await visitor.settle();
    const stand = ([east, north], turn) => page.evaluate(pose => {
        const { view, visit } = window.vicus;
        view.setPose({ ...view.pose(), ...pose });
        visit.isJump = true;
    }, { east, north, heading: turn, pitch: 0 });
    const doors = () => page.evaluate(() => {
        const { doors } = window.vicus.visit.loader;
        return { open: doors.open, phases: [...doors.states.values()].map(({ phase }) => phase) };
    });
    const isOpen = id => page.waitForFunction(id => window.vicus.visit.openDoors.includes(id), id, { timeout: 1000 * kOpenSeconds });
    const isShut = () => page.waitForFunction(() => window.vicus.visit.loader.doors.states.size === 0, null, { timeout: 1000 * kOpenSeconds });

    await stand(at(kStand), heading);
    await visitor.settle();
    await shoot('1-shut');
    assert.ok(!(await visitor.now()).asked.includes(room.id), 'what is behind a shut door was loaded');
    await visitor.hold('KeyW', 3500);
    const { pose } = await visitor.now(), left = (pose.east - at(0)[0]) * Math.sin(heading) + (pose.north - at(0)[1]) * Math.cos(heading);
    assert.ok(-left >= kStop, `a shut door let him to ${-left} m`);

    await stand(at(kStand), heading);
    const window_ = await page.locator('#window').boundingBox();
    await page.mouse.click(window_.x + window_.width / 2, window_.y + window_.height / 2);
    await page.waitForFunction(() => window.vicus.visit.loader.doors.states.size === 1, null, { timeout: 10000 });
    await page.waitForFunction(() => [...window.vicus.visit.loader.doors.states.values()][0].angle > 0.4, null, { timeout: 1000 * kOpenSeconds });
    await shoot('2-opening');
    await isOpen(door.id);
    await page.waitForFunction(() => [...window.vicus.visit.loader.doors.states.values()][0].angle === 1, null, { timeout: 1000 * kOpenSeconds });
    await shoot('3-open');
    assert.ok((await visitor.now()).live.includes(room.id), 'the door opened before the room was there');

    const middle = pointInside(room.ground.map(ring => ring.map(([east, north]) => [1000 * east, 1000 * north])));
    await visitor.walk([at(-0.6).map(v => 1000 * v), middle], { run: false, within: 0.4 });
    await visitor.isIn(room.id);
    await isShut();
    await shoot('4-inside');
    await visitor.face(at(0).map(v => 1000 * v));
    await shoot('5-back');
    const alone = await visitor.waitFor(({ live }) => live.join() === room.id, kReleaseSeconds);
    assert.deepEqual(alone.live, [room.id], 'the street was kept');
    await shoot('6-alone');

    for (const key of ['KeyW', 'KeyA', 'KeyS', 'KeyD']) {
        await visitor.hold(key, 2500);
        const { current, pose: { east, north, up } } = await visitor.now();
        assert.equal(current, room.id, `${key} led out of a shut room`);
        assert.ok(Math.abs(up - kEye) < 0.3, `${key}: the eye is ${up} m up at ${east}, ${north}`);
    }
    const inner = room.doors.find(({ to }) => to !== street);
    if (inner) await lookIntoNextRoom(visitor, inner, { shoot, stand, isOpen, isShut });

    await stand(at(-1.2), heading + Math.PI);
    await visitor.isIn(room.id);
    await page.keyboard.press('KeyI');
    await isOpen(door.id);
    await visitor.settle();
    await shoot('8-leaving');
    await visitor.walk([at(0.8).map(v => 1000 * v), at(3).map(v => 1000 * v)], { run: false });
    await visitor.isIn(street);
    await isShut();
    const outside = await visitor.waitFor(({ asked }) => !asked.includes(room.id), kReleaseSeconds);
    assert.ok(!outside.asked.includes(room.id), 'the room was kept');
    assert.ok(outside.live.includes(street));
    t.diagnostic(`doors at the end: ${JSON.stringify(await doors())}`);
    assert.deepEqual(visitor.complaints, []);
    await page.close();
}

/** From the middle of the room through another door of it. */
async function lookIntoNextRoom(visitor, { id, to, line: [[ax, ay], [bx, by]] }, { shoot, stand, isOpen, isShut }) {
    const length = Math.hypot(bx - ax, by - ay), inwards = [-(by - ay) / length, (bx - ax) / length];
    const at = metres => [(ax + bx) / 2 + metres * inwards[0], (ay + by) / 2 + metres * inwards[1]];
    await stand(at(0.75), Math.atan2(-inwards[0], -inwards[1]));
    await visitor.page.keyboard.press('KeyI');
    await isOpen(id);
    await visitor.walk([at(-0.9).map(v => 1000 * v), at(-2.3).map(v => 1000 * v)], { run: false, within: 0.4 });
    await visitor.isIn(to);
    await isShut();
    await shoot('7-next-room');
}

async function openInWorld(browser, server, { street, room, door, at, heading }) {
    const { page, complaints } = await openTab(browser.context);
    await page.route('**/bare.html', reply => reply.fulfill({ contentType: 'text/html', body: bareWorld(`/city.x3d?start=${street}&i=1`) }));
    await page.goto(`${server.origin}/bare.html`);
    const says = id => page.waitForFunction(id => {
        const scene = document.querySelector('x3d-canvas')?.browser?.currentScene;
        return scene && Array.from(scene.rootNodes).length && scene.getNamedNode('LOADER').sector_changed === id;
    }, id, { timeout: 180000, polling: 100 });
    await says(street);
    await page.waitForFunction(() => document.querySelector('x3d-canvas').browser.activeViewpoint, null, { timeout: 120000 });
    await slide(page, at(kStand), heading);
    await page.waitForFunction(() => document.querySelector('x3d-canvas').browser._loadCount.getValue() === 0, null, { timeout: 60000 });
    await page.mouse.move(330, 250);
    await page.mouse.click(328, 248);
    const angle = () => page.evaluate(({ street, id }) => {
        const world = document.querySelector('x3d-canvas').browser.currentScene.getNamedNode('WORLD');
        for (const place of Array.from(world.children))
            for (const node of Array.from(place.children))
                if (node.url?.[0]?.endsWith(`/${street}.x3d`))
                    return node.getValue().getInternalScene().getNamedNode(`DOOR-LEAF-${id}`).rotation.angle;
        return null;
    }, { street, id: door.id });
    for (const end = Date.now() + 60000; !(Math.abs(await angle()) > 1.6) && Date.now() < end;) await page.waitForTimeout(200);
    await page.screenshot({ path: join(kShots, 'doors-world.png') });
    assert.ok(Math.abs(await angle()) > 1.6, `the leaf stands at ${await angle()} rad`);
    await slide(page, at(-2.6), heading);
    await says(room.id);
    assert.deepEqual(complaints, []);
    await page.close();
}

/** Moves the eye in a straight line, 0.25 m a frame, then turns it. */
async function slide(page, [east, north], heading) {
    await page.evaluate(async ([east, north, heading]) => {
        const { browser } = document.querySelector('x3d-canvas');
        const { default: X3D } = await import('/x_ite/15.0.1/dist/x_ite.min.mjs');
        for (let left = 1; left > 0;) {
            const view = browser.activeViewpoint.getValue(), at = view.getUserPosition().copy();
            const dx = east - at.x, dz = -north - at.z;
            left = Math.hypot(dx, dz);
            const share = Math.min(1, 0.25 / (left || 1));
            at.x += share * dx;
            at.z += share * dz;
            view.setUserPosition(at);
            view.setUserOrientation(new X3D.SFRotation(0, 1, 0, -heading).getValue());
            left -= 0.25;
            await new Promise(requestAnimationFrame);
        }
    }, [east, north, heading]);
}

async function startInside(browser, server, { room }) {
    const visitor = await Visitor.open(browser.context, `${server.origin}/?start=${room.id}`);
    await visitor.streetTime();
    await visitor.settle();
    const { current, live, pose } = await visitor.now();
    assert.equal(current, room.id);
    assert.deepEqual(live, [room.id]);
    assert.ok(Math.abs(pose.up - kEye) < 0.5, `the eye is ${pose.up} m up`);
    await visitor.page.screenshot({ path: join(kShots, 'doors-start.png') });
    assert.deepEqual(visitor.complaints, []);
    await visitor.page.close();
}
