import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { TriangleBuilder } from '../../../../client_scripts/core/TriangleBuilder.js';
import { addGround } from '../../../../client_scripts/core/groundMesh.js';
import { addPrism } from '../../../../client_scripts/core/prismMesh.js';
import { addTree } from '../../../../client_scripts/core/treeMesh.js';
import { readLayout } from '../../../../client_scripts/core/readLayout.js';
import { doubledArea, triangulate } from '../../../../client_scripts/core/triangulate.js';

const kLayout = readLayout(readFileSync(new URL('../../../../city_db/prism_tile_layout.h', import.meta.url), 'utf8'));
const near = (a, b, e = 1e-6) => assert.ok(Math.abs(a - b) < e, `${a} instead of ${b}`);
function randomOf(seed) {
    let state = seed;
    return () => ((state = (state * 1103515245 + 12345) % 2147483648) / 2147483648);
}
/** A ring round (x, y), counter-clockwise, that does not cross itself. */
const star = (random, n, [x, y], reach) => Array.from({ length: n }, (_, i) => {
    const r = reach * (0.35 + 0.65 * random()), turn = 2 * Math.PI * (i + 0.6 * random()) / n;
    return [x + r * Math.cos(turn), y + r * Math.sin(turn)];
});

test('triangles cover a polygon with holes exactly: their areas add up, none lies the wrong way', () => {
    for (let seed = 1; seed <= 200; ++seed) {
        const random = randomOf(seed), outer = star(random, 9 + Math.floor(12 * random()), [0, 0], 100);
        const rings = [outer];
        if (seed % 2) rings.push(star(random, 4 + Math.floor(4 * random()), [8, 0], 8).reverse());
        if (seed % 4 === 1) rings.push(star(random, 4, [-12, 0], 7).reverse());
        const triangles = triangulate(rings), whole = rings.reduce((sum, ring) => sum + doubledArea(ring), 0);
        for (const triangle of triangles) assert.ok(doubledArea(triangle) > 0, `seed ${seed}`);
        near(triangles.reduce((sum, triangle) => sum + doubledArea(triangle), 0), whole, 1e-6 * whole);
    }
});

test('rings that cross themselves end, too', () => {
    for (let seed = 1; seed <= 200; ++seed) {
        const random = randomOf(seed), ring = Array.from({ length: 3 + Math.floor(9 * random()) }, () => [Math.floor(5 * random()), Math.floor(5 * random())]);
        assert.ok(triangulate([ring]).length <= ring.length);
    }
});

const houseOf = (kind, rings, more = {}) => ({ kind, rings, ground: 3, eave: 9, top: 13, wall: [200, 190, 180], roof: [150, 70, 50], ...more });
/** Volume over the floor that the faces enclose, by their outward sides: the sum over triangles of |a b c| / 6. */
function volumeOf({ positions, indices }) {
    let sum = 0;
    for (let i = 0; i < indices.length; i += 3) {
        const [a, b, c] = [0, 1, 2].map(k => [0, 1, 2].map(axis => positions[3 * indices[i + k] + axis]));
        sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
    }
    return sum;
}
/** The same house with a floor, so that it is closed. */
function closed(house) {
    const builder = new TriangleBuilder();
    addPrism(builder, house, kLayout);
    for (const [a, b, c] of triangulate(house.rings))
        builder.face([c, b, a].map(([x, y]) => [x, house.ground - 2, -y]), [0, 0, 0, 0], [[0, 0], [0, 0], [0, 0]]);
    return builder.build();
}

test('a house is closed and its faces look outwards: its volume is that of its prism and its roof', () => {
    const ring = [[2, 1], [22, 1], [22, 11], [2, 11]], body = 20 * 10 * 8;   // walls go 2 m below the ground
    near(volumeOf(closed(houseOf(kLayout.PRISM_KIND_FLAT, [ring], { eave: 9, top: 9 }))), body, 0.01);
    near(volumeOf(closed(houseOf(kLayout.PRISM_KIND_TENT, [ring]))), body + 20 * 10 * 4 / 3, 0.01);
    near(volumeOf(closed(houseOf(kLayout.PRISM_KIND_GABLED, [ring]))), body + 20 * 10 * 4 / 2, 0.01);
    near(volumeOf(closed(houseOf(kLayout.PRISM_KIND_HIPPED, [ring]))), body + 10 * 10 * 4 / 2 + 10 * 10 * 4 / 3, 0.01);
    const turned = [...ring.slice(1), ring[0]];   // the longer side is not the first
    near(volumeOf(closed(houseOf(kLayout.PRISM_KIND_GABLED, [turned]))), body + 20 * 10 * 4 / 2, 0.01);
    const yard = [[8, 4], [8, 8], [14, 8], [14, 4]];
    near(volumeOf(closed(houseOf(kLayout.PRISM_KIND_FLAT, [ring, yard], { eave: 9, top: 9 }))), (20 * 10 - 6 * 4) * 8, 0.01);
});

test('a crown is closed, its faces look outwards, and it stays within its height and radius', () => {
    for (const form of [kLayout.PRISM_TREE_ROUND, kLayout.PRISM_TREE_SLIM, kLayout.PRISM_TREE_CONIFER]) {
        const builder = new TriangleBuilder(), tree = { form, at: [40, 30], ground: 5, height: 8, crown: 2.5, leaves: [112, 152, 70] };
        addTree(builder, tree, kLayout);
        const { positions, normals, indices } = builder.build(), edges = new Map();
        const isTrunk = i => Math.hypot(positions[3 * i] - 40, positions[3 * i + 2] + 30) < 0.17 && positions[3 * i + 1] < 5 + 0.31 * 8;
        const crown = [];
        for (let i = 0; i < indices.length; i += 3) if (![0, 1, 2].every(k => isTrunk(indices[i + k]))) crown.push(...indices.slice(i, i + 3));
        for (let i = 0; i < crown.length; i += 3)
            for (const k of [0, 1, 2]) {
                const [a, b] = [crown[i + k], crown[i + (k + 1) % 3]];
                edges.set(`${a} ${b}`, 1);
            }
        for (const edge of edges.keys()) assert.ok(edges.has(edge.split(' ').reverse().join(' ')), `form ${form}: ${edge}`);
        const shifted = { positions: positions.map((v, i) => v - [40, 5, -30][i % 3]), indices: crown };
        const volume = volumeOf(shifted), cylinder = Math.PI * 2.5 * 2.5 * 8;
        assert.ok(volume > 0.15 * cylinder && volume < 0.6 * cylinder, `form ${form}: ${volume / cylinder}`);
        for (const i of crown) {
            const [x, up, z] = [0, 1, 2].map(k => shifted.positions[3 * i + k]);
            assert.ok(Math.hypot(x, z) < 2.5 + 1e-5 && up > 0 && up < 8 + 1e-5);
            near(Math.hypot(...normals.slice(3 * i, 3 * i + 3)), 1, 1e-5);
        }
    }
    assert.throws(() => addTree(new TriangleBuilder(), { form: 3, at: [0, 0], ground: 0, height: 8, crown: 2, leaves: [0, 0, 0] }, kLayout), /form/);
});

test('a house with its own roof is as closed, and its gables have the walls\' colour', () => {
    const ring = [[2, 1], [22, 1], [22, 11], [2, 11]];
    const points = [[22, 6, 13], [2, 6, 13]], facets = [[0, 1, 4, 5], [2, 3, 5, 4], [1, 2, 4], [3, 0, 5]].map((corners, i) => ({ isGable: i > 1, corners }));
    const mesh = closed(houseOf(kLayout.PRISM_KIND_FACETED, [ring], { points, facets }));
    near(volumeOf(mesh), 20 * 10 * 8 + 20 * 10 * 4 / 2, 0.01);
    const steep = [...Array(mesh.positions.length / 3).keys()].filter(i => mesh.positions[3 * i + 1] > 12.9);
    const isWall = i => Math.abs(mesh.colours[4 * i] - 200 / 255) < 1e-6;
    assert.equal(steep.filter(isWall).length, 2);
    assert.equal(steep.filter(i => !isWall(i)).length, 4);
});

test('normals are of length 1 and at right angles to their faces', () => {
    const { positions, normals, indices } = closed(houseOf(kLayout.PRISM_KIND_HIPPED, [[[0, 0], [12, 3], [10, 9], [-1, 6]]]));
    for (let i = 0; i < indices.length; i += 3) {
        const [a, b, c] = [0, 1, 2].map(k => [0, 1, 2].map(axis => positions[3 * indices[i + k] + axis]));
        const n = [0, 1, 2].map(axis => normals[3 * indices[i] + axis]), along = b.map((v, k) => v - a[k]), up = c.map((v, k) => v - a[k]);
        near(Math.hypot(...n), 1, 1e-4);
        const cross = [along[1] * up[2] - along[2] * up[1], along[2] * up[0] - along[0] * up[2], along[0] * up[1] - along[1] * up[0]];
        assert.ok(cross.reduce((sum, v, k) => sum + v * n[k], 0) > 0.99 * Math.hypot(...cross));
    }
});

test('the four quadrants of the ground cover the tile once, at its heights, with the picture the right way up', () => {
    const tile = { side: 100, nodes: 5, heights: Float64Array.from({ length: 25 }, (_, i) => i) };
    let area = 0;
    for (let quadrant = 0; quadrant < 4; ++quadrant) {
        const builder = new TriangleBuilder();
        addGround(builder, tile, quadrant);
        const { positions, places, indices } = builder.build();
        for (let i = 0; i < indices.length; i += 3) {
            const corners = [0, 1, 2].map(k => [positions[3 * indices[i + k]], -positions[3 * indices[i + k] + 2]]);
            area += doubledArea(corners) / 2;   // skirts stand upright: none
        }
        for (let i = 0; i < positions.length / 3; ++i) {
            const [x, up, z] = positions.subarray(3 * i, 3 * i + 3);
            near(places[2 * i], x / 100);
            near(places[2 * i + 1], 1 + z / 100);   // row 0 of a picture is north
            const height = Math.round(-z / 25) * 5 + Math.round(x / 25);
            assert.ok(Math.abs(up - height) < 1e-6 || Math.abs(up - (height - 3)) < 1e-6, `${up} ${height}`);
        }
    }
    near(area, 100 * 100, 1e-6);
});
