import assert from 'node:assert/strict';
import { openTab } from './chromium.js';

/**
 * A visitor in a tab: goes where told by pressing keys, as a person would; keeps a diary of sectors and loads.
 * Everything is read through window.vicus (client_scripts/page/main.js).
 */
export class Visitor {
    static async open(context, url) {
        const tab = await openTab(context);
        await tab.page.addInitScript(keepDiary);
        await tab.page.goto(url);
        return new Visitor(tab);
    }

    constructor(tab) {
        Object.assign(this, tab);
    }

    /** ms from navigation until the sector the visitor is in was there. */
    async streetTime() {
        await this.page.waitForFunction(() => window.vicus?.visit.firstStreetAt, null, { timeout: 180000 });
        return this.page.evaluate(() => window.vicus.visit.firstStreetAt);
    }

    /** { current, pose, live, asked, failed } now; the last three are files by their stems: ID, ID.far, ID.tall. */
    now() {
        return this.page.evaluate(() => {
            const { view, visit } = window.vicus, { sectors } = visit;
            const of = (...phases) => sectors.filter(({ phase }) => phases.includes(phase)).map(({ stem }) => stem).sort();
            const [live, asked, failed] = [of('live'), of('live', 'loading'), of('failed')];
            return { current: visit.current, pose: view.pose(), live, asked, failed };
        });
    }

    async settle(seconds = 60) {
        await this.page.waitForFunction(() => {
            const { view, visit } = window.vicus;
            const quiet = view.isIdle() && visit.sectors.every(sector => sector.phase !== 'loading');
            window.quietSince = quiet ? window.quietSince || performance.now() : 0;
            return quiet && performance.now() - window.quietSince > 400;
        }, null, { timeout: 1000 * seconds });
    }

    /** What `now` says as soon as it fulfils the condition, or after some seconds anyway. */
    async waitFor(condition, seconds = 60) {
        const end = Date.now() + 1000 * seconds;
        let state = await this.now();
        while (!condition(state) && Date.now() < end) {
            await this.page.waitForTimeout(200);
            state = await this.now();
        }
        return state;
    }

    /**
     * Walks (or runs, and walks up to each point) along plan points in millimetres. Who turns to the next point too far
     * from this one walks into the corner that it leads round.
     * Fails when it takes longer than a slow machine explains.
     */
    async walk(points, { run = true, within = 0.5, seconds = 240 } = {}) {
        const metres = points.map(([east, north]) => [east / 1000, north / 1000]);
        const result = await this.page.evaluate(pressKeys, { metres, run, within, seconds });
        assert.equal(result.reached, metres.length, `stuck at ${JSON.stringify(result)} on the way ${JSON.stringify(metres)}`);
    }

    /** Turns to face a plan point. */
    async face([east, north]) {
        await this.page.evaluate(pressKeys, { metres: [[east / 1000, north / 1000]], within: 0, seconds: 30, turnOnly: true });
    }

    /** Waits until the world says that the visitor is in `id`. Fails with what it says instead. */
    async isIn(id, seconds = 30) {
        const arrived = this.page.waitForFunction(id => window.vicus.visit.current === id, id, { timeout: 1000 * seconds });
        await arrived.catch(async () => {
            const { sectors } = await this.diary();
            assert.fail(`not in ${id}: ${JSON.stringify(await this.now())} after ${JSON.stringify(sectors)}`);
        });
    }

    async hold(key, milliseconds) {
        await this.page.keyboard.down(key);
        await this.page.waitForTimeout(milliseconds);
        await this.page.keyboard.up(key);
    }

    /** [{ at: ms, current }] and stem -> how often the file's content was given back. */
    diary() {
        return this.page.evaluate(() => window.diary);
    }

    /** Shape nodes that are there, counted in the scenes themselves. */
    shapes() {
        return this.page.evaluate(countShapes);
    }

    fetches(pattern) {
        const counts = new Map();
        for (const { path } of this.requests) if (pattern.test(path)) counts.set(path, (counts.get(path) ?? 0) + 1);
        return counts;
    }
}

/* What follows runs in the page. */

function keepDiary() {
    window.diary = { sectors: [], unloads: {} };
    let before = [];
    const look = () => {
        requestAnimationFrame(look);
        if (!window.vicus) return;
        const { visit } = window.vicus;
        if (visit.current && window.diary.sectors.at(-1)?.current !== visit.current)
            window.diary.sectors.push({ at: performance.now(), current: visit.current });
        const asked = visit.sectors.filter(sector => sector.phase !== 'absent').map(sector => sector.stem);
        for (const stem of before) if (!asked.includes(stem)) window.diary.unloads[stem] = (window.diary.unloads[stem] ?? 0) + 1;
        before = asked;
    };
    look();
}

async function pressKeys({ metres, run, within, seconds, turnOnly }) {
    const held = new Set(), shift = 'ShiftLeft';
    const press = (code, down) => {
        if (down === held.has(code)) return;
        if (down) held.add(code);
        else held.delete(code);
        dispatchEvent(new KeyboardEvent(down ? 'keydown' : 'keyup', { code, shiftKey: held.has(shift), bubbles: true }));
    };
    const { view } = window.vicus, deadline = performance.now() + 1000 * seconds;
    let reached = 0, pose = view.pose();
    while (reached < metres.length && performance.now() < deadline) {
        pose = view.pose();
        const east = metres[reached][0] - pose.east, north = metres[reached][1] - pose.north;
        const error = Math.atan2(east, north) - pose.heading, turn = Math.atan2(Math.sin(error), Math.cos(error));
        if (turnOnly ? Math.abs(turn) < 0.12 : Math.hypot(east, north) < within) {
            ++reached;
            continue;
        }
        press(shift, Boolean(run) && Math.hypot(east, north) > 3);
        press('KeyQ', turn < -0.1);
        press('KeyE', turn > 0.1);
        press('KeyW', !turnOnly && Math.abs(turn) < 0.4);
        await new Promise(requestAnimationFrame);
    }
    for (const code of [...held]) press(code, false);
    return { reached, pose };
}

function countShapes() {
    const { browser } = window.vicus.view;
    let count = 0;
    const visit = node => {
        const type = node?.getNodeTypeName();
        if (type === 'Shape') ++count;
        const inner = type === 'Inline' ? node.getValue().getInternalScene()?.rootNodes : node?.children;
        for (const child of Array.from(inner ?? [])) visit(child);
    };
    for (const node of Array.from(browser.currentScene.rootNodes)) visit(node);
    return count;
}
