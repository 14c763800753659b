import { buffersOf } from '../core/tileMesh.js';
import { readyTile } from '../core/tileLoad.js';

let layouts = null;

/** Turns tiles into triangles beside the page: { layouts } once, then { id, prisms, ground } or { id, blockMap } -> { id, mesh } or { id, error }. */
addEventListener('message', ({ data }) => {
    if (data.layouts) {
        layouts = data.layouts;
        return;
    }
    try {
        const mesh = readyTile(data, layouts);
        postMessage({ id: data.id, mesh }, { transfer: buffersOf(mesh) });
    } catch (error) {
        postMessage({ id: data.id, error: error.message });
    }
});
