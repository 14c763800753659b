// What client_scripts/core/TileTree.js draws: node tests/support/tileChoice.mjs CASES.json > DRAWN.json
// CASES.json: [{ tree: { levels, leafSide_m, tiles }, views: [{ eye, pixelsPerRadian, pixels }] }]; all tiles are there.
// DRAWN.json: for each case, for each view, the paths drawn, in order; each view knows what the last one refined.
import { readFileSync } from 'node:fs';
import { TileTree } from '../../client_scripts/core/TileTree.js';

const cases = JSON.parse(readFileSync(process.argv[2], 'utf8'));
console.log(JSON.stringify(cases.map(({ tree, views }) => {
    const tiles = new TileTree(tree);
    let refined = new Set();
    return views.map(view => {
        const chosen = tiles.choose(view, () => true, refined);
        refined = chosen.refined;
        return chosen.draw.map(path => path.replace('.prisms', '').replace('blockmaps/', ''));
    });
})));
