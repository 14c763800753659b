import { decodeBlockMap } from '../core/blockMap.js';
import { blockMapMesh } from '../core/blockMapMesh.js';
import { blockMapTexture } from '../core/blockMapTexture.js';
import { buffersOf, tileMesh } from '../core/tileMesh.js';

let layouts = null;

/** Turns tiles into triangles beside the page: { layouts } once, then { id, prisms, ground } or { id, blockMap } -> { id, mesh } or { id, error }. */
async function pixelsOf(webp) {
    if (webp.length === 0) return null;
    const picture = await createImageBitmap(new Blob([webp], { type: 'image/webp' }), { colorSpaceConversion: 'none', premultiplyAlpha: 'none' });
    const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d', { willReadFrequently: true });
    context.drawImage(picture, 0, 0);
    return context.getImageData(0, 0, picture.width, picture.height).data;
}

async function meshOf({ prisms, ground, blockMap }) {
    if (!blockMap) return tileMesh({ prisms, ground }, layouts);
    const map = decodeBlockMap(blockMap, layouts.blockMap);
    const [roof, base, ambient, wall] = await Promise.all([map.roof, map.ground, map.ambient, map.wall].map(pixelsOf));
    return blockMapMesh(map, blockMapTexture(map, { roof, ground: base, ambient, wall }, layouts.blockMap));
}

addEventListener('message', async ({ data }) => {
    if (data.layouts) {
        layouts = data.layouts;
        return;
    }
    try {
        const mesh = await meshOf(data);
        postMessage({ id: data.id, mesh }, { transfer: buffersOf(mesh) });
    } catch (error) {
        postMessage({ id: data.id, error: error.message });
    }
});
