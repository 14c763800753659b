import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import test from 'node:test';
import { openBrowser } from './support/chromium.js';
import { CityMap, startWithRoute } from './support/cityMap.js';
import { cities, serveCity } from './support/vicusServer.js';
import { Visitor } from './support/Visitor.js';

const kShots = process.env.VICUS_SHOTS ?? 'out';
const [[name, make]] = Object.entries(cities());

test(`the page of ${name}`, { timeout: 600000 }, async t => {
    mkdirSync(kShots, { recursive: true });
    const server = await serveCity(make), browser = await openBrowser();
    const phone = await openBrowser({ width: 390, height: 760, hasTouch: true });
    t.after(async () => {
        await browser.close();
        await phone.close();
        await server.stop();
    });
    const map = new CityMap(server.origin), start = await startWithRoute(map, 2), [, neighbour] = await map.route(start, 1);
    const open = (context, rest) => Visitor.open(context, `${server.origin}/${rest}`);

    await t.test('says what is wrong with an unknown start', async () => {
        const visitor = await open(browser.context, '?start=no_such_sector');
        await visitor.page.waitForSelector('#message.trouble:not([hidden])');
        const text = await visitor.page.textContent('#message');
        assert.match(text, /no_such_sector/);
        await visitor.page.close();
    });

    await t.test('says that a place cannot be loaded, tries again, and then has it', async () => {
        const visitor = await Visitor.open(browser.context, 'about:blank');
        let refusals = 0;
        const later = () => new Promise(resolve => setTimeout(resolve, 300));   // long enough to see what is said meanwhile
        const refuseTwice = route => (++refusals <= 2 ? later().then(() => route.abort()) : route.continue());
        await visitor.page.route(new RegExp(`/parcels\\?files=([^&]*,)?${neighbour}[,&]`), refuseTwice);
        await visitor.page.goto(`${server.origin}/?start=${start}`);
        await visitor.page.waitForSelector('#message.trouble:not([hidden])');
        assert.match(await visitor.page.textContent('#message'), /cannot be loaded: trying again/);
        await visitor.page.waitForSelector('#message', { state: 'hidden', timeout: 30000 });
        assert.ok((await visitor.now()).live.includes(neighbour));
        assert.equal(refusals, 3);
        await visitor.page.close();
    });

    await t.test('shows the street\'s name and who made the map', async () => {
        const visitor = await open(browser.context, `?start=${start}`), record = await map.record(start);
        await visitor.streetTime();
        await visitor.page.waitForFunction(() => document.getElementById('street').textContent);
        if (record.name) assert.equal(await visitor.page.textContent('#street'), record.name);
        const rights = await visitor.page.evaluate(() => window.vicus.world.rights);
        assert.equal(await visitor.page.textContent('#rights'), rights);
        const city = await visitor.page.evaluate(() => window.vicus.world.name);
        assert.ok(city, 'the city has no name');
        assert.match(await visitor.page.title(), new RegExp(`^.+ · ${city}$`));
        await visitor.page.close();
    });

    await t.test('help opens by key, closes by key and by button', async () => {
        const visitor = await open(browser.context, `?start=${start}`), { page } = visitor;
        await visitor.streetTime();
        await page.keyboard.press('KeyH');
        assert.equal(await page.isVisible('#help'), true);
        await page.screenshot({ path: join(kShots, `${name}-help.png`) });
        await page.keyboard.press('Escape');
        assert.equal(await page.isVisible('#help'), false);
        await page.click('#help-button');
        await page.click('#help-close');
        assert.equal(await page.isVisible('#help'), false);
        await page.close();
    });

    await t.test('dragging the mouse looks round and moves nobody', async () => {
        const visitor = await open(browser.context, `?start=${start}`), { page } = visitor;
        await visitor.streetTime();
        const before = (await visitor.now()).pose;
        await page.mouse.move(500, 300);
        await page.mouse.down();
        await page.mouse.move(300, 260, { steps: 5 });
        await page.mouse.up();
        await page.waitForTimeout(500);
        const after = (await visitor.now()).pose;
        assert.ok(turned(before, after) > 0.8 && turned(before, after) < 1.2, `${turned(before, after)} rad`);
        assert.ok(Math.hypot(after.east - before.east, after.north - before.north) < 0.01);
        await page.close();
    });

    await t.test('a shared link leads to the same place and the same view', async () => {
        const visitor = await open(browser.context, `?start=${start}`), { page } = visitor;
        await visitor.streetTime();
        await visitor.settle();
        await visitor.hold('KeyE', 700);
        await page.keyboard.press('KeyL');
        await page.waitForFunction(() => location.hash);
        const { pose } = await visitor.now(), guest = await Visitor.open(browser.context, page.url());
        await guest.streetTime();
        const there = (await guest.now()).pose;
        assert.ok(Math.hypot(there.east - pose.east, there.north - pose.north) < 0.02 && turned(pose, there) < 0.02);
        await guest.page.close();
        await page.close();
    });

    await t.test('nobody falls where no ground is', async () => {
        const visitor = await open(browser.context, `?start=${start}`);
        await visitor.streetTime();
        await visitor.settle();
        await visitor.page.evaluate(() => {
            const { view } = window.vicus, pose = view.pose();
            view.setPose({ ...pose, east: pose.east + 20000, up: 1.7 });
        });
        await visitor.hold('KeyE', 3000);
        const { up } = (await visitor.now()).pose;
        assert.ok(up > 1.6 && up < 1.8, `eye at ${up} m`);
        await visitor.page.close();
    });

    await t.test('a thumb on the left walks, one on the right looks', async () => {
        const visitor = await open(phone.context, `?start=${start}`), { page } = visitor;
        await visitor.streetTime();
        await visitor.settle();
        const touch = await phone.context.newCDPSession(page), before = (await visitor.now()).pose;
        await drag(touch, [100, 600], [100, 550], 1500);
        const walked = (await visitor.now()).pose;
        assert.ok(Math.hypot(walked.east - before.east, walked.north - before.north) > 0.5, 'did not walk');
        assert.ok(turned(before, walked) < 0.01, 'turned while walking');
        await drag(touch, [300, 400], [200, 400], 300);
        assert.ok(turned(walked, (await visitor.now()).pose) > 0.3, 'did not look');
        await page.screenshot({ path: join(kShots, `${name}-phone.png`) });
        await page.close();
    });
});

function turned(a, b) {
    const angle = b.heading - a.heading;
    return Math.abs(Math.atan2(Math.sin(angle), Math.cos(angle)));
}

async function drag(devtools, [x, y], [x1, y1], milliseconds) {
    const send = (type, points) => devtools.send('Input.dispatchTouchEvent', { type, touchPoints: points });
    await send('touchStart', [{ x, y }]);
    for (let i = 1; i <= 5; ++i) await send('touchMove', [{ x: x + (x1 - x) * i / 5, y: y + (y1 - y) * i / 5 }]);
    await new Promise(resolve => setTimeout(resolve, milliseconds));
    await send('touchEnd', []);
    await new Promise(resolve => setTimeout(resolve, 500));
}
