import assert from 'node:assert/strict';
import test from 'node:test';
import { Flyover } from '../../../../client_scripts/core/Flyover.js';
import { RoofHeights } from '../../../../client_scripts/core/RoofHeights.js';
import { TileFades, kFadeSeconds } from '../../../../client_scripts/core/TileFades.js';
import { TileRequests, compare } from '../../../../client_scripts/core/TileRequests.js';
import { glidePose } from '../../../../client_scripts/core/glide.js';
import { isInside, landingSpot } from '../../../../client_scripts/core/landingSpot.js';

/** Every tile of five levels; errors halve. */
const tiles = [];
for (let z = 0; z < 5; ++z) for (let y = 0; y < 2 ** z; ++y) for (let x = 0; x < 2 ** z; ++x) tiles.push([z, x, y, 50, null, 0, 16 / 2 ** z, 900, 900]);
const kTree = { levels: 5, leafSide_m: 128, tiles };

/** A stage that keeps what is shown, how far it has come, and never shows what is not made. */
class Stage {
    constructor() {
        Object.assign(this, { states: new Map(), dropped: 0, around: false });
    }
    begin(mesh) { return { key: mesh.key, pieces: 0 }; }
    work(made) { return (made.pieces += 1) && 5000; }
    isDone({ pieces }) { return pieces === 4; }
    surround() {}
    showSurroundings(isShown) { this.around = isShown; }
    show({ key, pieces }, quadrant) {
        assert.equal(pieces, 4);
        this.states.set(`${key}#${quadrant}`, 0);
    }
    setState({ key }, quadrant, state) { this.states.set(`${key}#${quadrant}`, state); }
    hide({ key }, quadrant) { this.states.delete(`${key}#${quadrant}`); }
    drop({ key }) {
        for (let q = 0; q < 4; ++q) assert.ok(!this.states.has(`${key}#${q}`), `${key} is drawn and dropped`);
        ++this.dropped;
    }
}

function meshOf({ key, corner, side }, bytes) {
    return { key, corner, side, parts: [], roofs: new Float32Array(0), range: [0, 20], heights: [0, 0, 0, 0, 0, 0, 0, 0, 0], nodes: 3, bytes, sentBytes: 1800 };
}

/** Flies a path; load answers after some frames. */
async function fly({ path, bytes = 1e6, mostBytes = 1e9, fails = () => false }) {
    const stage = new Stage(), loads = [], said = [];
    const load = tile => {
        loads.push(tile.key);
        return fails(tile, loads) ? Promise.reject(new Error('lost')) : Promise.resolve(meshOf(tile, bytes));
    };
    const flyover = new Flyover({ tree: kTree, load, stage, mostBytes, complain: text => said.push(text) });
    const check = [];
    for (let i = 0; i < path.length; ++i) {
        flyover.step({ pitch: -0.5, heading: 0, half: [0.8, 0.5], pixelsPerRadian: 500, ...path[i] }, i / 20);
        await new Promise(setImmediate);
        check.push(coverage(stage, flyover));
    }
    return { flyover, stage, loads, said, check };
}

/** How often the places of a grid are covered: sum of what comes and what has not gone. */
function coverage({ states }, { tree }) {
    let least = Infinity, most = 0;
    for (let i = 0; i < 8; ++i)
        for (let j = 0; j < 8; ++j) {
            const point = [i, j].map(k => (k + 0.5) / 8 * tree.rootSide - tree.rootSide / 2);
            let sum = 0;
            for (const [key, state] of states) {
                const [name, quadrant] = key.split('#'), { corner, side } = tree.tiles.get(name);
                const [x, y] = point.map((v, k) => (v - corner[k]) / side);
                if (x < 0 || y < 0 || x >= 1 || y >= 1 || (x >= 0.5 ? 1 : 0) + (y >= 0.5 ? 2 : 0) !== Number(quadrant)) continue;
                sum += state <= 0.5 ? 2 * state : 2 - 2 * state;
            }
            [least, most] = [Math.min(least, sum), Math.max(most, sum)];
        }
    return { least, most };
}

const kPath = Array.from({ length: 240 }, (_, i) => ({ eye: [600 * Math.sin(i / 60), -900 + 4 * i, 150 + 100 * Math.cos(i / 40)], heading: i / 90 }));

test('on a flight nothing is fetched twice, and every place is covered once from the overview on, also while tiles change', async () => {
    const { loads, check, flyover } = await fly({ path: kPath });
    assert.equal(new Set(loads).size, loads.length);
    assert.ok(loads.length > 60, `${loads.length}`);
    const first = check.findIndex(({ least }) => least > 0.999);
    assert.ok(first > 0 && first < 20, `the overview is there after ${first} frames`);
    for (const { least, most } of check.slice(first)) assert.ok(least > 0.999 && most < 1.001, `${least} ${most}`);
    assert.ok(flyover.figures.sentBytes === 1800 * flyover.figures.files);
});

test('what is kept stays within its bytes, and what is drawn is never dropped', async () => {
    const { flyover, stage, check } = await fly({ path: kPath, bytes: 1e6, mostBytes: 60e6 });
    assert.ok(stage.dropped > 5, `${stage.dropped}`);
    assert.ok(flyover.bytes <= 60e6, `${flyover.bytes}`);
    assert.equal(flyover.bytes, flyover.kept.size * 1e6);
    for (const { least } of check.slice(30)) assert.ok(least > 0.999);
});

test('a tile that fails is asked for again, later each time, and its parent stays in its place', async () => {
    const lost = new Set();
    const { loads, said, check } = await fly({ path: kPath.slice(0, 1).concat(Array(200).fill(kPath[0])),
        fails: ({ key, z }) => z > 0 && !lost.has(key) && lost.add(key) });
    assert.ok(said.length > 5 && said.every(text => text.includes('lost')));
    const times = key => loads.filter(other => other === key).length;
    assert.ok([...lost].every(key => times(key) <= 3));
    assert.ok([...lost].some(key => times(key) === 2));
    for (const { least } of check.slice(20)) assert.ok(least > 0.999);
});

test('requests: the latest first, then by class, then by error; what nobody wants any more is given up', () => {
    const request = (key, at, rank, onScreen) => ({ tile: { key }, at, rank, onScreen });
    const order = [request('a', 1, 'A', 9), request('b', 2, 'B', 9), request('c', 2, 'A', 1), request('d', 2, 'A', 5)].sort(compare);
    assert.deepEqual(order.map(({ tile }) => tile.key), ['d', 'c', 'b', 'a']);
    const signals = new Map(), requests = new TileRequests({ mostInFlight: 2, arrived() {},
        load: ({ key }, signal) => new Promise(() => signals.set(key, signal)) });
    const ask = keys => keys.map(key => ({ tile: { key }, rank: 'A', onScreen: 1 }));
    requests.step(ask(['a', 'b', 'c']), 0);
    assert.deepEqual([...signals.keys()], ['a', 'b']);
    requests.step(ask(['b']), 0.9);
    requests.step(ask(['b', 'd']), 1.8);
    assert.ok(signals.get('a').aborted && !signals.get('b').aborted);
    assert.deepEqual([...signals.keys()], ['a', 'b', 'd']);   // c was forgotten
});

test('a fade goes from nothing to there and from there to gone in its time; one that is under way is not disturbed', () => {
    const fades = new TileFades(), tile = { key: 't' }, other = { key: 'o' };
    assert.ok(fades.set([{ tile, quadrants: 15 }], 0));
    assert.equal(fades.step(kFadeSeconds / 2)[0].state, 0.25);
    assert.ok(!fades.set([{ tile: other, quadrants: 15 }], kFadeSeconds / 2));
    assert.equal(fades.step(kFadeSeconds)[0].state, 0.5);
    assert.ok(fades.set([{ tile, quadrants: 14 }, { tile: other, quadrants: 1 }], 1));
    const [leaving, coming] = fades.step(1 + kFadeSeconds / 2).sort((a, b) => b.state - a.state);
    assert.deepEqual([leaving.tile.key, coming.tile.key], ['t', 'o']);
    assert.ok(Math.abs(leaving.state - 0.75) < 1e-9 && Math.abs(coming.state - 0.25) < 1e-9);
    fades.step(2);
    assert.deepEqual([...fades.parts.keys()].sort(), ['o#0', 't#1', 't#2', 't#3']);
});

test('a landing spot is where he is, if that is ground, else just inside the nearest', () => {
    const square = (x, y, side) => [[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
    const sectors = [{ id: 'a', rings: [square(0, 0, 10)] }, { id: 'b', rings: [square(20, 0, 10), square(24, 4, 2).reverse()] }];
    assert.deepEqual(landingSpot(sectors, [3, 4]), { id: 'a', point: [3, 4] });
    for (const point of [[13, 5], [17, 5], [25, 5], [-50, 80], [40, -3]]) {
        const { id, point: spot } = landingSpot(sectors, point), { rings } = sectors.find(sector => sector.id === id);
        assert.ok(isInside(rings, spot), `${point}: ${spot}`);
    }
    assert.equal(landingSpot(sectors, [13, 5]).id, 'a');
    assert.equal(landingSpot(sectors, [17, 5]).id, 'b');
    assert.ok(Math.hypot(landingSpot(sectors, [13, 5]).point[0] - 9.1, landingSpot(sectors, [13, 5]).point[1] - 5) < 0.2);
    assert.equal(landingSpot([], [0, 0]), null);
});

test('a glide begins and ends where it should, turns the shorter way, and rises in the middle', () => {
    const a = { east: 0, north: 0, up: 10, heading: 3, pitch: 0 }, b = { east: 100, north: 50, up: 20, heading: -3, pitch: -1 };
    assert.deepEqual(glidePose(a, b, 0, 30), a);
    const end = glidePose(a, b, 1, 30);
    for (const key of ['east', 'north', 'up', 'pitch']) assert.ok(Math.abs(end[key] - b[key]) < 1e-9);
    assert.ok(Math.abs(Math.sin(end.heading - b.heading)) < 1e-9 && end.heading > 3);
    assert.equal(glidePose(a, b, 0.5, 30).up, 45);
});

test('heights: the finest tile counts, roofs just beside do, ground is bilinear', () => {
    const heights = new RoofHeights();
    heights.add('0', { corner: [0, 0], side: 100, nodes: 3, heights: [0, 0, 0, 10, 10, 10, 20, 20, 20], roofs: Float32Array.from([10, 10, 20, 20, 30]) });
    heights.add('1', { corner: [0, 0], side: 50, nodes: 3, heights: Array(9).fill(4), roofs: Float32Array.from([10, 10, 20, 20, 31]) });
    assert.equal(heights.roof([15, 15]), 31);
    assert.equal(heights.roof([7, 15]), 31);
    assert.equal(heights.roof([2, 15]), -Infinity);
    assert.equal(heights.ground([60, 75]), 15);
    assert.equal(heights.ground([10, 10]), 4);
    assert.equal(heights.ground([-1, 0]), null);
});

test('tiles are drawn as wanted, where they are sent so; too many houses are a BlockMap where that is known', () => {
    const formsOf = options => {
        const flyover = new Flyover({ tree: kTree, load() {}, stage: new Stage(), ...options });
        return [{ houses: 9, prismError: 1, blockMapError: 2 }, { houses: 9, prismError: 1, blockMapError: null },
            { houses: 5000, prismError: null, blockMapError: 2 }, { houses: 0, prismError: null, blockMapError: null }].map(tile =>
            [flyover.formOf(tile), flyover.errorOf(tile)]);
    };
    assert.deepEqual(formsOf({}), [['prisms', 1], ['prisms', 1], ['blockMap', 2], ['prisms', 0]]);
    assert.deepEqual(formsOf({ form: 'blockMap' }), [['blockMap', 2], ['prisms', 1], ['blockMap', 2], ['prisms', 0]]);
});
