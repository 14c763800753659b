import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { decodeBlockMap } from '../../../../client_scripts/core/blockMap.js';
import { decodeGround } from '../../../../client_scripts/core/groundTile.js';
import { decodePrisms } from '../../../../client_scripts/core/prismTile.js';
import { readLayout } from '../../../../client_scripts/core/readLayout.js';

const cityDb = name => readFileSync(new URL(`../../../../city_db/${name}`, import.meta.url), 'utf8');
const kGround = readLayout(cityDb('ground_tile_layout.h'));
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
    assert.equal(kPrisms.PRISM_STREAMS, 15);
});

test('the prism tile of FORMAT.md is read as C++ wrote it', () => {
    const tile = decodePrisms(dump(2), kPrisms);
    assert.deepEqual(tile.corner, [-128, 0]);
    assert.equal(tile.side, 128);
    assert.equal(tile.houses.length, 3);
    const [gabled, flat, own] = tile.houses;
    assert.deepEqual(gabled.rings, [[[10, 65], [20, 65], [20, 73], [10, 73]]]);
    assert.equal(gabled.kind, kPrisms.PRISM_KIND_GABLED);
    assert.deepEqual([gabled.owned, flat.owned], [true, false]);
    assert.deepEqual([gabled.quadrant, flat.quadrant], [2, 0]);
    assert.ok(Math.abs(gabled.eave - 8.7) < 1e-9 && Math.abs(gabled.top - 11.8) < 1e-9);
    assert.deepEqual(gabled.roof, [150, 70, 50]);
    assert.equal(own.kind, kPrisms.PRISM_KIND_FACETED);
    assert.ok(Math.abs(own.top - own.eave - 2) < 1e-9);
    assert.deepEqual(own.points.map(([x, y]) => [x, y]), [[70, 80]]);
    assert.deepEqual(own.facets, [[0, 1, 4], [1, 2, 4], [2, 3, 4], [0, 4, 3]].map((corners, i) => ({ isGable: i === 2, corners })));
    assert.equal(tile.trees.length, 2);
    const [round, conifer] = tile.trees;
    assert.deepEqual([round.at, conifer.at], [[8.0625, 75.0625], [50.0625, 65.0625]]);
    assert.deepEqual([round.form, conifer.form], [kPrisms.PRISM_TREE_ROUND, kPrisms.PRISM_TREE_CONIFER]);
    assert.deepEqual([round.quadrant, conifer.quadrant], [2, 3]);
    assert.deepEqual([round.leaves, conifer.leaves], [[112, 152, 70], [78, 116, 80]]);
    assert.deepEqual([round.ground, round.height, round.crown, conifer.ground].map(m => Math.round(10 * m)), [25, 80, 26, 26]);
    assert.deepEqual(flat.rings[1], [[2.5, 32.5], [2.5, 37.5], [7.5, 37.5], [7.5, 32.5]]);
});

test('a BlockMap counts the columns that its header says, and no other tile passes', () => {
    const n = 16, bytes = new Uint8Array(kBlockMap.BLOCKMAP_HEADER_BYTES + kBlockMap.BLOCKMAP_PLANES * n * n + kBlockMap.BLOCKMAP_LINE_BYTES);
    bytes.set(dump(1));
    const plane = which => kBlockMap.BLOCKMAP_HEADER_BYTES + which * n * n;
    bytes.fill(128, plane(kBlockMap.BLOCKMAP_PLANE_SLOPE_EAST), plane(kBlockMap.BLOCKMAP_PLANE_OFFSET));
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

test('the ground tile of FORMAT.md is read as C++ wrote it, and no other', () => {
    const tile = decodeGround(dump(3), kGround);
    assert.deepEqual([tile.corner, tile.side, tile.nodes], [[-128, 0], 128, 3]);
    assert.deepEqual([...tile.heights], [2, 3, 4, 2, 3, 5, 2, 3, 6]);
    assert.equal(Buffer.from(tile.picture).toString(), 'WebP');
    for (const change of [b => b.subarray(1), b => b.subarray(0, -1), b => (b[kGround.GROUND_VERSION_AT] = 9, b),
        b => (b[kGround.GROUND_NODES_AT] = 4, b), b => b.subarray(0, 20)])
        assert.throws(() => decodeGround(change(dump(3).slice()), kGround), Error);
});

test('damaged prisms are refused or read, never for long', () => {
    for (let seed = 1; seed <= 3000; ++seed) {
        const bytes = dump(2).slice();
        for (let n = 0, state = seed; n < 3; ++n) {
            state = (state * 1103515245 + 12345) % 2147483648;
            bytes[kPrisms.PRISM_HEADER_BYTES + state % (bytes.length - kPrisms.PRISM_HEADER_BYTES)] = state >> 8;
        }
        let tile = null;
        try {
            tile = decodePrisms(bytes, kPrisms);
        } catch (error) {
            assert.match(error.message, /prism tile/);
        }
        for (const { rings, points, facets } of tile?.houses ?? [])
            for (const { corners } of facets ?? []) assert.ok(corners.every(i => i >= 0 && i < rings.flat().length + points.length), `seed ${seed}`);
    }
});

test('prisms of version 1, which knew no quadrants, are refused by name', () => {
    const old = dump(2).slice();
    old[kPrisms.PRISM_VERSION_AT] = 1;
    assert.throws(() => decodePrisms(old, kPrisms), /another version/);
});
