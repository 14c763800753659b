/** Texels of a row; a place in the texture is counted through its rows. The shader has the same numbers (x3d/blockmap.frag). */
export const kTextureWidth = 1024;
/** Header: numbers as the four bytes of a float, then the regions one after the other, then the pyramid, then the walls. */
export const kHeaderTexels = 16;

/**
 * A BlockMap (of decodeBlockMap) and its pictures as one texture of bytes for the shader. `pictures`: { roof, ground, ambient,
 * wall } as RGBA bytes, the top row first; ambient may be null. `layout`: of blockmap_layout.h.
 * { width, height, pixels: Uint32Array, red in the highest byte }.
 */
export function blockMapTexture(map, pictures, layout) {
    const { side: n, rows, columns } = map, cells = n * n, pyramid = pyramidOf(map, layout);
    const regions = kHeaderTexels + 5 * cells, walls = regions + pyramid.length, total = walls + columns * rows;
    const height = Math.ceil(total / kTextureWidth), pixels = new Uint32Array(kTextureWidth * height);
    const cellM = map.sideMm / 1000 / n;
    const header = [n, cellM, map.stepUm * 1e-6, map.base, map.baseEast, map.baseNorth, map.wallStepUm * 1e-6, rows, walls,
        layout.BLOCKMAP_SLOPE_ZERO, 1 / layout.BLOCKMAP_SLOPE_ONE, layout.BLOCKMAP_OFFSET_ZERO, Math.SQRT1_2 / layout.BLOCKMAP_OFFSET_STEPS,
        map.top * map.stepUm * 1e-6];
    const bits = new Uint32Array(Float32Array.from(header).buffer);
    pixels.set(bits);
    const at = region => kHeaderTexels + region * cells;
    const rgb = (picture, width, column, row) => {
        const i = 4 * (row * width + column);
        return (picture[i] << 24 | picture[i + 1] << 16 | picture[i + 2] << 8) >>> 0;
    };
    const half = n / 2;
    for (let row = 0, cell = 0; row < n; ++row)
        for (let column = 0; column < n; ++column, ++cell) {
            const halfRow = half - 1 - (row >> 1), ambient = pictures.ambient ? smoothAmbient(pictures.ambient, half, column, n - 1 - row) : 255;
            pixels[at(0) + cell] = (map.height[cell] << 16 | map.foot[cell]) >>> 0;
            pixels[at(1) + cell] = (map.slopeEast[cell] << 24 | map.slopeNorth[cell] << 16 | map.angle[cell] << 8 | map.offset[cell]) >>> 0;
            pixels[at(2) + cell] = (map.firstColumn[cell] << 8 | map.walls[cell]) >>> 0;
            pixels[at(3) + cell] = (rgb(pictures.roof, n, column, n - 1 - row) | ambient) >>> 0;
            const roofCell = footLooksLike(map, cell, layout);
            pixels[at(4) + cell] = roofCell === null ? rgb(pictures.ground, half, column >> 1, halfRow)
                : rgb(pictures.roof, n, roofCell % n, n - 1 - Math.floor(roofCell / n));
        }
    pixels.set(pyramid, regions);
    const wide = Math.min(columns, layout.BLOCKMAP_ATLAS_WIDTH);
    for (let column = 0; column < columns; ++column) {
        const strip = Math.floor(column / layout.BLOCKMAP_ATLAS_WIDTH), x = column % layout.BLOCKMAP_ATLAS_WIDTH;
        for (let row = 0; row < rows; ++row)
            pixels[walls + column * rows + row] = rgb(pictures.wall, wide, x, (strip + 1) * rows - 1 - row);
    }
    return { width: kTextureWidth, height, pixels };
}

/** At a cell's middle, between the four nearest texels of half as many: light has no edges. */
function smoothAmbient(picture, half, column, row) {
    const near = i => i >> 1, beside = i => Math.min(half - 1, Math.max(0, near(i) + (i % 2 ? 1 : -1)));
    const at = (x, y) => picture[4 * (y * half + x)];
    const across = y => 3 * at(near(column), y) + at(beside(column), y);
    return Math.round((3 * across(near(row)) + across(beside(row))) / 16);
}

/** Greatest heights in steps of 1, 2 x 2, 4 x 4 ... cells, each level row by row, one after the other. */
function pyramidOf({ side: n, height, foot, slopeEast, slopeNorth, offset, stepUm, sideMm }, layout) {
    const perSlope = sideMm * 1000 / (2 * layout.BLOCKMAP_SLOPE_ONE * n) / stepUm;
    let level = Float64Array.from(height, (h, i) => {
        const lean = Math.abs(slopeEast[i] - layout.BLOCKMAP_SLOPE_ZERO) + Math.abs(slopeNorth[i] - layout.BLOCKMAP_SLOPE_ZERO);
        return Math.max(Math.ceil(h + lean * perSlope) + 1, offset[i] ? foot[i] + 1 : 0);
    });
    const out = [...level];
    for (let size = n; size > 1; size /= 2) {
        const next = new Float64Array(size * size / 4);
        for (let y = 0; y < size; ++y)
            for (let x = 0; x < size; ++x) {
                const i = (y >> 1) * (size / 2) + (x >> 1);
                next[i] = Math.max(next[i], level[y * size + x]);
            }
        out.push(...next);
        level = next;
    }
    return out;
}

/** The cell whose roof a foot looks like, beyond its line; null: it looks like ground (blockmap_colours.hpp). */
function footLooksLike({ side: n, height, foot, slopeEast, slopeNorth, angle, offset, stepUm, wallStepUm, sideMm }, cell, layout) {
    if (offset[cell] === 0) return null;
    const turn = angle[cell] * 2 * Math.PI / 256, column = cell % n, row = Math.floor(cell / n), step = stepUm * 1e-6;
    for (const far of [1, 2]) {
        const east = Math.round(far * Math.cos(turn)), north = Math.round(far * Math.sin(turn)), c = column + east, r = row + north;
        if (c < 0 || r < 0 || c >= n || r >= n) return null;
        const other = r * n + c, slope = plane => (plane[other] - layout.BLOCKMAP_SLOPE_ZERO) / layout.BLOCKMAP_SLOPE_ONE;
        const up = height[other] * step - (slope(slopeEast) * east + slope(slopeNorth) * north) * sideMm / 1000 / n;
        if (Math.abs(up - foot[cell] * step) <= wallStepUm * 1e-6) return other;
    }
    return null;
}
