import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { TileTree } from '../../../../client_scripts/core/TileTree.js';
import { decodeBlockMap } from '../../../../client_scripts/core/blockMap.js';
import { decodePrisms } from '../../../../client_scripts/core/prismTile.js';
import { readLayout } from '../../../../client_scripts/core/readLayout.js';

const cityDb = name => readFileSync(new URL(`../../../../city_db/${name}`, import.meta.url), 'utf8');
const kPrisms = readLayout(cityDb('prism_tile_layout.h')), kBlockMap = readLayout(cityDb('blockmap_layout.h'));

/** The bytes of FORMAT.md's `which`-th dump: what the C++ encoders write (tests/conformance/city_db). */
function dump(which) {
    const block = cityDb('FORMAT.md').split('```hexdump\n')[which + 1].split('```')[0];
    return Uint8Array.from(block.split('\n').flatMap(line => line.slice(6).split('  ')[0].trim().split(' ').filter(Boolean)),
        text => parseInt(text, 16));
}

test('a layout header is read as it stands', () => {
    assert.equal(kBlockMap.BLOCKMAP_MAGIC, 0x31504d42);
    assert.equal(kBlockMap.BLOCKMAP_HEADER_BYTES, 84);
    assert.equal(kPrisms.PRISM_STREAMS, 7);
});

test('the prism tile of FORMAT.md is read as C++ wrote it', () => {
    const tile = decodePrisms(dump(2), kPrisms);
    assert.deepEqual(tile.corner, [-128, 0]);
    assert.equal(tile.side, 128);
    assert.equal(tile.houses.length, 2);
    const [gabled, flat] = tile.houses;
    assert.deepEqual(gabled.rings, [[[10, 10], [20, 10], [20, 18], [10, 18]]]);
    assert.equal(gabled.kind, kPrisms.PRISM_KIND_GABLED);
    assert.deepEqual([gabled.owned, flat.owned], [true, false]);
    assert.ok(Math.abs(gabled.eave - 8.7) < 1e-9 && Math.abs(gabled.top - 11.8) < 1e-9);
    assert.deepEqual(gabled.roof, [150, 70, 50]);
    assert.deepEqual(flat.rings[1], [[2.5, 32.5], [2.5, 37.5], [7.5, 37.5], [7.5, 32.5]]);
});

test('a BlockMap counts the columns that its header says, and no other tile passes', () => {
    const n = 16, bytes = new Uint8Array(kBlockMap.BLOCKMAP_HEADER_BYTES + kBlockMap.BLOCKMAP_PLANES * n * n);
    bytes.set(dump(1));
    const plane = which => kBlockMap.BLOCKMAP_HEADER_BYTES + which * n * n;
    bytes.fill(128, plane(kBlockMap.BLOCKMAP_PLANE_SLOPE_EAST), plane(kBlockMap.BLOCKMAP_PLANE_ANGLE));
    for (const cell of [17, 18]) {
        bytes[plane(kBlockMap.BLOCKMAP_PLANE_HEIGHT_LOW) + cell] = 40;
        bytes[plane(kBlockMap.BLOCKMAP_PLANE_SLOPE_NORTH) + cell] = 136;
    }
    bytes[plane(kBlockMap.BLOCKMAP_PLANE_OFFSET) + 18] = 128;
    const map = decodeBlockMap(bytes, kBlockMap);
    assert.equal(map.columns, 4);
    assert.deepEqual([map.walls[17], map.walls[18]], [2 | 4 | 8, 16]);
    assert.deepEqual([map.corner, map.error, map.base], [[-128, 0], 1.234, 2.5]);
    for (const change of [b => b.subarray(1), b => b.subarray(0, -1), b => (b[kBlockMap.BLOCKMAP_COLUMNS_AT] ^= 1, b),
        b => (b[kBlockMap.BLOCKMAP_VERSION_AT] = 9, b)])
        assert.throws(() => decodeBlockMap(change(bytes.slice()), kBlockMap), Error);
    for (const size of [0, 10, 76, 90]) assert.throws(() => decodePrisms(dump(2).subarray(0, size), kPrisms), Error);
});

/** A tree with holes, where errors halve from level to level. */
function randomTree(random, levels = 5) {
    const tiles = [];
    const add = (z, x, y) => {
        if (z > 0 && random() < 0.25) return;
        tiles.push([z, x, y, 3000 >> (2 * z), z < 4 ? 32 / 2 ** z : null, 1, 16 / 2 ** z, 1]);
        if (z + 1 < levels) for (const [dx, dy] of [[0, 0], [1, 0], [0, 1], [1, 1]]) add(z + 1, 2 * x + dx, 2 * y + dy);
    };
    add(0, 0, 0);
    return new TileTree({ levels, leafSide_m: 128, tiles });
}
function randomOf(seed) {
    let state = seed;
    return () => ((state = (state * 1103515245 + 12345) % 2147483648) / 2147483648);
}
const tileOf = path => path.replace('blockmaps/', '').replace('.prisms', '');
const isWithin = (inner, outer) => {
    const [z, x, y] = inner.split('/').map(Number), [oz, ox, oy] = outer.split('/').map(Number);
    return z >= oz && x >> (z - oz) === ox && y >> (z - oz) === oy;
};

test('whatever has arrived, nothing is drawn twice and nothing is missing', () => {
    for (let seed = 1; seed <= 60; ++seed) {
        const random = randomOf(seed), tree = randomTree(random), there = new Set([tree.formOf(tree.tiles.get('0/0/0')).path]);
        for (const tile of tree.tiles.values()) if (random() < 0.6) there.add(tree.formOf(tile).path);
        const view = { eye: [random() * 2000 - 1000, random() * 2000 - 1000, 20 + random() * 600], pixelsPerRadian: 579, pixels: 2 };
        const { draw, ask } = tree.choose(view, path => there.has(path));
        for (const tile of tree.tiles.values()) {
            if (tree.childrenOf(tile).length > 0) continue;
            const over = draw.filter(path => isWithin(`${tile.z}/${tile.x}/${tile.y}`, tileOf(path)));
            assert.equal(over.length, 1, `seed ${seed}: tile ${tile.z}/${tile.x}/${tile.y} is drawn by ${over}`);
        }
        for (const path of draw) assert.ok(there.has(path), `seed ${seed}: ${path}`);
        for (const path of ask) assert.ok(!there.has(path), `seed ${seed}: ${path}`);
        assert.equal(new Set(ask).size, ask.length);
    }
});

test('with everything there the error on screen is what was asked for, or there is nothing finer', () => {
    for (let seed = 1; seed <= 60; ++seed) {
        const random = randomOf(seed), tree = randomTree(random);
        const view = { eye: [random() * 2000 - 1000, random() * 2000 - 1000, 100 + random() * 900], pixelsPerRadian: 579, pixels: 3 };
        const { draw, ask } = tree.choose(view, () => true);
        assert.deepEqual(ask, []);
        for (const path of draw) {
            const tile = tree.tiles.get(tileOf(path)), onScreen = tree.formOf(tile).error * 579 / Math.max(tree.distance(tile, view.eye), 10);
            assert.ok(onScreen <= 3 || tree.childrenOf(tile).length === 0, `seed ${seed}: ${path} ${onScreen}`);
        }
    }
});

test('an eye that sways at a threshold changes nothing', () => {
    const tree = randomTree(randomOf(3));
    let refined = new Set(), last = '', changes = 0;
    for (let i = 0; i < 300; ++i) {
        const view = { eye: [0, 0, 1000 + 8 * Math.sin(i)], pixelsPerRadian: 579, pixels: 3 };
        const chosen = tree.choose(view, () => true, refined);
        refined = chosen.refined;
        const now = chosen.draw.sort().join();
        changes += i > 20 && now !== last;
        last = now;
    }
    assert.equal(changes, 0);
});
