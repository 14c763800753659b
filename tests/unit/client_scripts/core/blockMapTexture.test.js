import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { blockMapMesh } from '../../../../client_scripts/core/blockMapMesh.js';
import { blockMapTexture, kHeaderTexels, kTextureWidth } from '../../../../client_scripts/core/blockMapTexture.js';
import { readLayout } from '../../../../client_scripts/core/readLayout.js';

const kLayout = readLayout(readFileSync(new URL('../../../../city_db/blockmap_layout.h', import.meta.url), 'utf8'));
const kSide = 16, kCells = kSide * kSide;
/** Sloping cells, one with a line whose foot lies as high as the roof beside it. */
function sample() {
    const plane = value => new Uint8Array(kCells).fill(value), map = { side: kSide, rows: 2, corner: [-64, 0], sideMm: 128000, base: 3, baseEast: 0.01, baseNorth: 0,
        stepUm: 250000, wallStepUm: 3000000, error: 1, top: 300, height: new Uint16Array(kCells), foot: new Uint16Array(kCells),
        slopeEast: plane(128), slopeNorth: plane(128), angle: plane(0), offset: plane(0), walls: plane(0), firstColumn: new Uint32Array(kCells), columns: 3 };
    map.height[18] = 258;
    map.slopeEast[18] = 144;
    map.height[17] = 80;
    map.offset[17] = 100;   // its line's normal looks east, to 18
    map.foot[17] = 226;     // 18's plane, carried on 8 m to the west: 258 - 16
    map.walls[17] = 16;
    map.firstColumn[17] = 2;
    return map;
}
const picture = (w, h, of) => Uint8ClampedArray.from({ length: 4 * w * h }, (_, i) => of((i >> 2) % w, Math.floor((i >> 2) / w))[i & 3] ?? 255);
const pictures = () => ({ roof: picture(16, 16, (x, y) => [x, y, 1]), ground: picture(8, 8, (x, y) => [x, y, 2]),
    ambient: picture(8, 8, (x, y) => [10 * y + x, 0, 0]), wall: picture(3, 2, (x, y) => [x, y, 3]) });

test('header, planes, colours and columns lie where the shader looks for them', () => {
    const map = sample(), { width, pixels } = blockMapTexture(map, pictures(), kLayout), floats = new Float32Array(pixels.buffer, 0, 14);
    assert.equal(width, kTextureWidth);
    assert.equal(pixels.length % width, 0);
    assert.deepEqual([...floats.slice(0, 4)], [16, 8, 0.25, 3]);
    assert.equal(floats[13], 75);
    const at = (region, cell) => pixels[kHeaderTexels + region * kCells + cell].toString(16).padStart(8, '0');
    assert.equal(at(0, 18), '01020000');
    assert.equal(at(1, 17), '80800064');
    assert.equal(at(2, 17), '00000210');
    assert.equal(at(3, 18), '020e0144');   // column 2, row 1 from the south: the picture's row 14, light between its texels 0 and 1, 6 and 7
    assert.equal(at(4, 0), '00070200');    // ground
    const walls = floats[8];
    assert.equal(pixels[walls + 2 * 2].toString(16), '2010300');      // column 2, its foot: the picture's last row
    assert.equal(pixels[walls + 2 * 2 + 1].toString(16), '2000300');
});

test('a foot that goes on as a roof has its colour', () => {
    const map = sample();
    map.foot[17] = 242;
    const { pixels } = blockMapTexture(map, pictures(), kLayout), foot = pixels[kHeaderTexels + 4 * kCells + 17];
    assert.equal(foot.toString(16).padStart(8, '0'), '020e0100');
});

test('no cell is higher than the pyramid says, on any level', () => {
    const map = sample(), { pixels } = blockMapTexture(map, pictures(), kLayout);
    let at = kHeaderTexels + 5 * kCells;
    for (let level = 0, across = kSide; across >= 1; ++level, at += across * across, across /= 2)
        for (let cell = 0; cell < kCells; ++cell) {
            const x = (cell % kSide) >> level, y = Math.floor(cell / kSide) >> level;
            const highest = map.height[cell] + Math.abs(map.slopeEast[cell] - 128) / 32 * 4 / 0.25;
            assert.ok(pixels[at + y * across + x] >= highest, `level ${level}, cell ${cell}`);
        }
});

test('the four boxes hold the tile from its base plane to its top, and are seen from inside', () => {
    const map = sample(), mesh = blockMapMesh(map, blockMapTexture(map, pictures(), kLayout));
    assert.deepEqual(mesh.range.map(value => value.toFixed(2)), ['3.00', '79.28']);
    for (const { positions, indices } of mesh.parts) {
        let volume = 0;
        for (let i = 0; i < indices.length; i += 3) {
            const [a, b, c] = [0, 1, 2].map(k => [0, 1, 2].map(axis => positions[3 * indices[i + k] + axis]));
            volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
        }
        assert.ok(volume < -64 * 64 * 75 && volume > -64.5 * 64.5 * 76.1, `${volume}`);
    }
});
