import { drawParts, imageTexture, tileProgram, uploadParts, viewMatrices } from './tileCanvas.js';

/** Of the tile's side: from where the probe looks at it, so that it fills the window. */
const kBack = 0.5, kUp = 0.45;

/** The two shaders' texts, from the server. */
export async function fetchTileShaders(folder) {
    const read = async name => {
        const response = await fetch(`${folder}${name}`);
        if (!response.ok) throw new Error(`${name}: ${response.status}`);
        return response.text();
    };
    const of = async name => ({ vertex: await read(`${name}.vert`), fragment: await read(`${name}.frag`) });
    const [prisms, blockMap] = await Promise.all([of('flyover'), of('blockmap')]);
    return { prisms, blockMap };
}

/**
 * How long this machine takes for one frame of the same tile in both forms, ms: { prisms, blockMap }. The tile fills a window of
 * `size` pixels. The first frame of each compiles and uploads and is not counted. Null where there is no WebGL 2 beside X_ITE's.
 */
export function probeForms(meshes, shaders, size) {
    const canvas = new OffscreenCanvas(...size), gl = canvas.getContext('webgl2');
    if (!gl) return null;
    const times = {};
    for (const form of ['prisms', 'blockMap']) {
        const { parts, side, image } = meshes[form], program = tileProgram(gl, shaders[form]);
        if (image) imageTexture(gl, image);
        const uploaded = uploadParts(gl, program, parts);
        const view = viewMatrices({ eye: [side / 2, -kBack * side, kUp * side], heading: 0, pitch: -Math.atan2(kUp, kBack + 0.5), half: [0.8, 0.5] });
        for (let frame = 0; frame < 2; ++frame) {
            const begin = performance.now();
            gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
            drawParts(gl, program, uploaded, view);
            gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));   // waits until it is drawn
            times[form] = performance.now() - begin;
        }
    }
    gl.getExtension('WEBGL_lose_context')?.loseContext();
    return times;
}
