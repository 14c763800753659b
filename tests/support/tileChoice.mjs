// What client_scripts/core/TileTree.js draws: node tests/support/tileChoice.mjs CASES.json > DRAWN.json
// CASES.json: [{ tree: { levels, leafSide_m, tiles }, views: [{ eye, pixelsPerRadian, pixels }] }]; all tiles are there.
// DRAWN.json: for each case, for each view, the tiles drawn, sorted; each view knows what the last one refined. The eye sees
// everything; of a tile that gives way to its children, quadrants that have none are empty and do not count.
import { readFileSync } from 'node:fs';
import { TileTree } from '../../client_scripts/core/TileTree.js';

const kMostPolygonHouses = 1500;   // cli/measure_tile_choice.hpp
const kAllAround = { heading: 0, pitch: -Math.PI / 2, half: [1e6, 1e6] };
const errorOf = ({ houses, prismError, blockMapError }) =>
    prismError === null || (blockMapError !== null && houses > kMostPolygonHouses) ? blockMapError : prismError;

const cases = JSON.parse(readFileSync(process.argv[2], 'utf8'));
console.log(JSON.stringify(cases.map(({ tree, views }) => {
    const tiles = new TileTree(tree);
    let refined = new Set();
    return views.map(view => {
        const chosen = tiles.choose({ ...view, ...kAllAround }, { isThere: () => true, errorOf, refined });
        refined = chosen.refined;
        return chosen.draw.filter(({ tile, isFinest }) => isFinest || !refined.has(tile.key)).map(({ tile }) => tile.key).sort();
    });
})));
