import { blockMapTile } from './blockMapMesh.js';
import { readLayout } from './readLayout.js';
import { tileMesh } from './tileMesh.js';

/** The layouts of tiles, { prisms, ground, blockMap }, from the server's folder of headers. */
export async function fetchLayouts(folder, request = url => fetch(url)) {
    const read = async name => {
        const response = await request(`${folder}${name}_layout.h`);
        if (!response.ok) throw new Error(`${name}_layout.h: ${response.status}`);
        return readLayout(await response.text());
    };
    const [prisms, ground, blockMap] = await Promise.all(['prism_tile', 'ground_tile', 'blockmap'].map(read));
    return { prisms, ground, blockMap };
}

/**
 * The `load` of Flyover: fetches what a tile is sent as and has it made ready. `base`: where /blockmaps/ is.
 * `prepare({ prisms, ground })`, or `prepare({ blockMap })`: a promise of tileMesh's or blockMapMesh's.
 */
export function tileLoader(base, prepare, request = (url, options) => fetch(url, options)) {
    const fetchBytes = async (url, signal) => {
        const response = await request(url, { signal });
        if (!response.ok) throw new Error(`${url}: ${response.status}`);
        const bytes = new Uint8Array(await response.arrayBuffer());
        return { bytes, sent: Number(response.headers.get('Content-Length')) || bytes.length };
    };
    return async ({ key, prismError }, signal, form = 'prisms') => {
        const address = `${base}${key}`, none = { bytes: null, sent: 0 };
        if (form === 'blockMap') {
            const { bytes, sent } = await fetchBytes(address, signal);
            return Object.assign(await prepare({ blockMap: bytes }), { sentBytes: sent });
        }
        const [ground, prisms] = await Promise.all([fetchBytes(`${address}.ground`, signal),
            prismError === null ? none : fetchBytes(`${address}.prisms`, signal)]);
        const mesh = await prepare({ prisms: prisms.bytes, ground: ground.bytes });
        return Object.assign(mesh, { sentBytes: ground.sent + prisms.sent });
    };
}

/** What is drawn of { prisms, ground } or { blockMap }, bytes as they are sent. */
export function readyTile(tile, layouts) {
    return tile.blockMap ? blockMapTile(tile.blockMap, layouts.blockMap) : tileMesh(tile, layouts);
}

/** A prepare that does it here and now. */
export const prepareHere = layouts => async tile => readyTile(tile, layouts);
