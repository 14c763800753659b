import { TriangleBuilder } from './TriangleBuilder.js';
import { blockMapPictures } from './indexedPicture.js';
import { blockMapTexture } from './blockMapTexture.js';
import { decodeBlockMap } from './blockMap.js';

/** Of the side: boxes overlap so much, that a ray between two of them is cast in one; the shader keeps to its quadrant. */
const kOverlap = 1 / 1000;
/** Bytes of a texel of the texture, and of what goes with each box. */
const kImageTexelBytes = 4, kBoxBytes = 4000;

/** A BlockMap made ready to draw from what the server sends. `layout`: of blockmap_layout.h. */
export function blockMapTile(bytes, layout) {
    const map = decodeBlockMap(bytes, layout);
    return blockMapMesh(map, blockMapTexture(map, blockMapPictures(map, layout), layout));
}

/**
 * A BlockMap made ready to draw: four boxes that the shader casts rays into, one for each quadrant, over the base plane; and
 * the texture of blockMapTexture. As tileMesh has it, but for `image` instead of `picture`, and without roofs: nobody
 * who flies comes near a tile so coarse.
 */
export function blockMapMesh(map, image) {
    const side = map.sideMm / 1000, top = map.top * map.stepUm * 1e-6, base = (x, y) => map.base + map.baseEast * x + map.baseNorth * y;
    const parts = [0, 1, 2, 3].map(quadrant => {
        const x0 = quadrant & 1 ? side / 2 : 0, y0 = quadrant & 2 ? side / 2 : 0, builder = new TriangleBuilder();
        addBox(builder, [x0 - side * kOverlap, x0 + side * (0.5 + kOverlap)], [y0 - side * kOverlap, y0 + side * (0.5 + kOverlap)], base, top, [quadrant & 1, quadrant >> 1]);
        return builder.build();
    });
    const rim = [base(0, 0), base(side, 0), base(0, side), base(side, side)];
    const heights = Float64Array.from({ length: 9 }, (_, i) => base((i % 3) * side / 2, Math.floor(i / 3) * side / 2));
    return { corner: map.corner, side, error: map.error, parts, image, roofs: new Float32Array(0), outlines: [],
        range: [Math.min(...rim), Math.max(...rim) + top], heights, nodes: 3, bytes: kImageTexelBytes * image.pixels.length + 4 * kBoxBytes };
}

/** The six faces seen from inside: the eye may be in the box. `place`: which quadrant. */
function addBox(builder, [x0, x1], [y0, y1], base, top, place) {
    const at = (x, y, up) => [x, base(x, y) + up, -y];
    const corners = up => [at(x0, y0, up), at(x1, y0, up), at(x1, y1, up), at(x0, y1, up)];
    const low = corners(-0.5), high = corners(top + 0.5), colour = [1, 1, 1, 1], places = [place, place, place, place];
    builder.face([...low], colour, places);
    builder.face([...high].reverse(), colour, places);
    for (let i = 0; i < 4; ++i) {
        const j = (i + 1) % 4;
        builder.face([low[i], high[i], high[j], low[j]], colour, places);
    }
}
