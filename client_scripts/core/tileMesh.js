import { TriangleBuilder } from './TriangleBuilder.js';
import { addGround } from './groundMesh.js';
import { decodeGround } from './groundTile.js';
import { addPrism } from './prismMesh.js';
import { decodePrisms } from './prismTile.js';
import { addTree } from './treeMesh.js';

/** Bytes of one corner in the graphics card's memory: place, normal, colour, place in the pattern; and of a texel. */
const kCornerBytes = 4 * (4 + 3 + 4 + 4), kTexelBytes = 4 * 4 / 3;

/**
 * A tile made ready to draw from what the server sends: four quadrants of triangles, each with the houses whose middles
 * lie in it, its trees and its ground. `prisms` may be null: neither stands there.
 *
 * { corner, side, error, parts: [{ positions, normals, colours, places, indices }], picture, roofs, range, bytes }: metres
 * from the corner, X3D's axes; `roofs`: west, south, east, north, top of each house that reaches into the tile, plan
 * metres; `outlines`: the edges of each; `range`: lowest and highest point; `bytes`: what it takes to keep it.
 */
export function tileMesh({ prisms, ground }, layouts) {
    const base = decodeGround(ground, layouts.ground), tile = prisms ? decodePrisms(prisms, layouts.prisms) : { houses: [], trees: [], error: 0 };
    const builders = [0, 1, 2, 3].map(quadrant => {
        const builder = new TriangleBuilder();
        addGround(builder, base, quadrant);
        return builder;
    });
    for (const house of tile.houses) if (house.owned) addPrism(builders[house.quadrant], house, layouts.prisms);
    for (const tree of tile.trees) addTree(builders[tree.quadrant], tree, layouts.prisms);
    const parts = builders.map(builder => builder.build());
    const roofs = Float32Array.from(tile.houses.flatMap(house => roofOf(house, base.corner)));
    const outlines = tile.houses.map(house => outlineOf(house, base.corner));
    const range = [Math.min(...base.heights), tile.houses.reduce((top, house) => Math.max(top, house.top), Math.max(...base.heights, ...tile.trees.map(({ ground, height }) => ground + height)))];
    const corners = parts.reduce((sum, { indices }) => sum + indices.length, 0);
    return { corner: base.corner, side: base.side, error: tile.error, parts, picture: base.picture, roofs, outlines, range,
        heights: base.heights, nodes: base.nodes, bytes: kCornerBytes * corners + kTexelBytes * 256 * 256 + outlines.reduce((sum, { byteLength }) => sum + byteLength, 0) };
}

function roofOf({ rings: [ring], top }, [east, north]) {
    const [x, y] = [0, 1].map(k => ring.map(point => point[k]));
    return [east + Math.min(...x), north + Math.min(...y), east + Math.max(...x), north + Math.max(...y), top];
}

/** Of each edge of a house: its two ends, plan metres. */
function outlineOf({ rings }, [east, north]) {
    return Float32Array.from(rings.flatMap(ring => ring.flatMap(([x, y], i) => {
        const [u, v] = ring[(i + 1) % ring.length];
        return [east + x, north + y, east + u, north + v];
    })));
}

/** What must move, not be copied, when a worker hands a tile over. */
export function buffersOf({ parts, roofs, outlines, heights, picture, image }) {
    return [...outlines.map(({ buffer }) => buffer), ...parts.flatMap(part => Object.values(part).map(array => array.buffer)), roofs.buffer, heights.buffer, (picture ?? image.pixels).buffer];
}
