import assert from 'node:assert/strict';
import test from 'node:test';
import { TileTree } from '../../../../client_scripts/core/TileTree.js';
import { viewCone } from '../../../../client_scripts/core/viewCone.js';

function randomOf(seed) {
    let state = seed;
    return () => ((state = (state * 1103515245 + 12345) % 2147483648) / 2147483648);
}
/** A tree with holes, where errors halve from level to level. */
function randomTree(random, levels = 5) {
    const tiles = [];
    const add = (z, x, y) => {
        if (z > 0 && random() < 0.25) return;
        tiles.push([z, x, y, 3000 >> (2 * z), null, 0, 16 / 2 ** z, 1, 1]);
        if (z + 1 < levels) for (const [dx, dy] of [[0, 0], [1, 0], [0, 1], [1, 1]]) add(z + 1, 2 * x + dx, 2 * y + dy);
    };
    add(0, 0, 0);
    return new TileTree({ levels, leafSide_m: 128, tiles });
}
const errorOf = tile => tile.prismError;
const randomView = random => ({ eye: [random() * 2000 - 1000, random() * 2000 - 1000, 120 + random() * 600],
    heading: 6.28 * random(), pitch: -1.2 * random(), half: [0.8, 0.5], pixelsPerRadian: 579, pixels: 2 });
/** Who draws a point, by the quadrants drawn. */
const drawersOf = (draw, [east, north]) => draw.filter(({ tile, quadrants }) => {
    const [x, y] = [(east - tile.corner[0]) / tile.side, (north - tile.corner[1]) / tile.side];
    return x >= 0 && x < 1 && y >= 0 && y < 1 && quadrants & (1 << ((x >= 0.5 ? 1 : 0) + (y >= 0.5 ? 2 : 0)));
});

test('whatever has arrived, every place of the tree is drawn once', () => {
    for (let seed = 1; seed <= 60; ++seed) {
        const random = randomOf(seed), tree = randomTree(random), there = new Set(['0/0/0']);
        for (const { key } of tree.tiles.values()) if (random() < 0.6) there.add(key);
        const { draw, ask } = tree.choose(randomView(random), { isThere: ({ key }) => there.has(key), errorOf });
        for (let i = 0; i < 200; ++i) {
            const point = [0, 1].map(() => (random() - 0.5) * tree.rootSide);
            assert.equal(drawersOf(draw, point).length, 1, `seed ${seed}: ${point}`);
        }
        for (const { tile } of draw) assert.ok(there.has(tile.key), `seed ${seed}: ${tile.key}`);
        for (const { tile } of ask) assert.ok(!there.has(tile.key), `seed ${seed}: ${tile.key}`);
        assert.equal(new Set(ask.map(({ tile }) => tile.key)).size, ask.length);
    }
});

test('with everything there, what is seen is as fine as was asked for, or there is nothing finer', () => {
    let seen = 0, finest = 0;
    for (let seed = 1; seed <= 60; ++seed) {
        const random = randomOf(seed), tree = randomTree(random), view = randomView(random), sees = viewCone(view);
        const { draw, ask } = tree.choose(view, { isThere: () => true, errorOf });
        assert.deepEqual(ask, []);
        for (const { tile, quadrants, onScreen } of draw) {
            if (!sees(tree.boxOf(tile, [0, 100]))) continue;
            const isMissing = tile.children.some((child, q) => child && quadrants & (1 << q));
            assert.ok(onScreen <= 2 || !isMissing, `seed ${seed}: ${tile.key} ${onScreen}`);
            ++seen;
            finest += onScreen > 2;
        }
    }
    assert.ok(seen > 500 && finest > 0, `${seen} ${finest}`);
});

test('nothing is asked for at the eye\'s back, what is seen comes before what is beside it', () => {
    const ranks = { A: 0, B: 0, C: 0 };
    for (let seed = 1; seed <= 60; ++seed) {
        const random = randomOf(seed), tree = randomTree(random), view = randomView(random), wide = viewCone(view, 1.7), sees = viewCone(view);
        const { ask } = tree.choose({ ...view, pixels: 12 }, { isThere: ({ z }) => z <= seed % 4, errorOf });
        for (const { tile, rank } of ask) {
            const parent = tree.tiles.get(`${tile.z - 1}/${tile.x >> 1}/${tile.y >> 1}`);
            assert.ok(wide(tree.boxOf(parent, [0, 100])), `seed ${seed}: ${tile.key}`);
            if (rank === 'A') assert.ok(sees(tree.boxOf(tile, [0, 100])));
            ++ranks[rank];
        }
    }
    assert.ok(Math.min(...Object.values(ranks)) > 5, JSON.stringify(ranks));
});

test('tiles are drawn from the near to the far', () => {
    for (let seed = 1; seed <= 20; ++seed) {
        const random = randomOf(seed), tree = randomTree(random), view = randomView(random);
        const { draw } = tree.choose(view, { isThere: () => true, errorOf });
        const leaves = draw.filter(({ quadrants }) => quadrants === 15).map(({ tile }) => tile);
        const hides = (a, b) => [0, 1].every(k => {   // a lies between the eye and b along both axes
            const sign = Math.sign(b.corner[k] + b.side / 2 - view.eye[k]) || 1, far = a.corner[k] + (sign > 0 ? a.side : 0);
            return sign * (b.corner[k] + (sign > 0 ? 0 : b.side) - far) >= 0 && sign * (far - view.eye[k]) > 0;
        });
        leaves.forEach((b, i) => leaves.slice(i + 1).forEach(a => assert.ok(!hides(a, b), `seed ${seed}: ${a.key} hides ${b.key}`)));
    }
});

test('an eye that sways at a threshold changes nothing', () => {
    const tree = randomTree(randomOf(3));
    let refined = new Set(), last = '', changes = 0;
    for (let i = 0; i < 300; ++i) {
        const view = { eye: [0, 0, 1000 + 8 * Math.sin(i)], heading: 0, pitch: -1.5, half: [0.8, 0.6], pixelsPerRadian: 579, pixels: 3 };
        const chosen = tree.choose(view, { isThere: () => true, errorOf, refined });
        refined = chosen.refined;
        const now = chosen.draw.map(({ tile, quadrants }) => `${tile.key}:${quadrants}`).sort().join();
        changes += i > 20 && now !== last;
        last = now;
    }
    assert.equal(changes, 0);
});

test('who turns away and back finds everything as fine as it was', () => {
    const tree = randomTree(randomOf(5)), view = { eye: [0, -400, 150], heading: 0, pitch: -0.4, half: [0.8, 0.5], pixelsPerRadian: 579, pixels: 2 };
    const all = { isThere: () => true, errorOf }, first = tree.choose(view, all);
    const away = tree.choose({ ...view, heading: Math.PI }, { ...all, refined: first.refined });
    const sees = viewCone(view);
    for (const { tile } of first.draw)
        if (sees(tree.boxOf(tile, [0, 100]))) assert.ok(away.draw.some(other => other.tile === tile) || away.refined.has(tile.key), tile.key);
});
