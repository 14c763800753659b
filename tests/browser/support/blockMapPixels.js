/**
 * Runs in the page: what the BlockMap shader draws of a tile, pixel by pixel, against a slow caster that tries every cell along
 * the ray. `views`: of viewMatrices, the eye in metres from the tile's corner, and `size`.
 * { rays, hits, wrong: pixels whose depth is off by more than 0.02 m + 1/2000, or that one of both misses, worst: m }.
 */
export async function compareWithReference({ path, views, size: [width, height] }) {
    const [{ decodeBlockMap }, { blockMapTexture }, { blockMapMesh }, { fetchLayouts }, canvas, { fetchTileShaders }] = await Promise.all([
        '/client/core/blockMap.js', '/client/core/blockMapTexture.js', '/client/core/blockMapMesh.js', '/client/core/tileLoad.js',
        '/client/page/tileCanvas.js', '/client/page/probeForms.js'].map(url => import(url)));
    const layout = (await fetchLayouts('/client/layout/')).blockMap, shaders = await fetchTileShaders('/client/x3d/');
    const map = decodeBlockMap(new Uint8Array(await (await fetch(path)).arrayBuffer()), layout), n = map.side;
    const grey = (w, h) => new Uint8ClampedArray(4 * w * h).fill(128), strips = Math.ceil(map.columns / layout.BLOCKMAP_ATLAS_WIDTH);
    const pictures = { roof: grey(n, n), ground: grey(n / 2, n / 2), ambient: null, wall: grey(layout.BLOCKMAP_ATLAS_WIDTH, strips * map.rows) };
    const mesh = blockMapMesh(map, blockMapTexture(map, pictures, layout));

    const gl = new OffscreenCanvas(width, height).getContext('webgl2'), program = canvas.tileProgram(gl, shaders.blockMap);
    canvas.imageTexture(gl, mesh.image);
    const uploaded = canvas.uploadParts(gl, program, mesh.parts), depth = gl.createTexture(), kNear = 0.05 * mesh.side, kFar = 8 * mesh.side;
    const copier = canvas.tileProgram(gl, { vertex: `#version 300 es
        void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0, 1); }`, fragment: `#version 300 es
        precision highp float; precision highp int; uniform highp sampler2D depth; out vec4 pixel;
        void main() { uint b = floatBitsToUint(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r);
            pixel = vec4(b >> 24, (b >> 16) & 255u, (b >> 8) & 255u, b & 255u) / 255.0; }` });
    const picture = gl.createTexture(), frame = gl.createFramebuffer();
    gl.activeTexture(gl.TEXTURE1);
    gl.bindTexture(gl.TEXTURE_2D, depth);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.DEPTH_COMPONENT32F, width, height, 0, gl.DEPTH_COMPONENT, gl.FLOAT, null);
    for (const name of ['TEXTURE_MIN_FILTER', 'TEXTURE_MAG_FILTER']) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.NEAREST);
    gl.activeTexture(gl.TEXTURE2);
    gl.bindTexture(gl.TEXTURE_2D, picture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
    gl.activeTexture(gl.TEXTURE0);

    const found = { rays: 0, hits: 0, wrong: 0, worst: 0 };
    for (const view of views) {
        gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, picture, 0);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, depth, 0);
        gl.viewport(0, 0, width, height);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        canvas.drawParts(gl, program, uploaded, canvas.viewMatrices(view, [kNear, kFar]));
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.disable(gl.DEPTH_TEST);
        gl.disable(gl.CULL_FACE);
        gl.useProgram(copier);
        gl.uniform1i(gl.getUniformLocation(copier, 'depth'), 1);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        const bytes = new Uint8Array(4 * width * height);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        const bits = new DataView(bytes.buffer);
        for (let row = 0; row < height; ++row)
            for (let column = 0; column < width; ++column) {
                const z = bits.getFloat32(4 * (row * width + column));   // the bytes lie as the shader wrote them: highest first
                const ndc = 2 * z - 1, drawn = z >= 1 ? Infinity : 2 * kFar * kNear / (kFar + kNear - ndc * (kFar - kNear));
                const truth = castSlowly(view, [(column + 0.5) / width * 2 - 1, (row + 0.5) / height * 2 - 1]);
                ++found.rays;
                found.hits += truth < Infinity;
                if (truth === drawn) continue;   // both see nothing
                const off = Math.abs(truth - drawn);
                if (!(off <= 0.02 + Math.min(truth, drawn) / 2000)) ++found.wrong;
                else found.worst = Math.max(found.worst, off);
            }
    }
    return found;

    /** m ahead of the eye; Infinity: nothing. */
    function castSlowly({ eye, heading, pitch, half }, [x, y]) {
        const [s, c, sp, cp] = [Math.sin(heading), Math.cos(heading), Math.sin(pitch), Math.cos(pitch)], [u, v] = [x * half[0], y * half[1]];
        const d = [s * cp + u * c - v * s * sp, c * cp - u * s - v * c * sp, sp + v * cp], cell = map.sideMm / 1000 / n;
        const o = [eye[0] / cell, eye[1] / cell, eye[2] - map.base - map.baseEast * eye[0] - map.baseNorth * eye[1]];
        const g = [d[0] / cell, d[1] / cell, d[2] - map.baseEast * d[0] - map.baseNorth * d[1]];
        let best = Infinity;
        for (let row = 0; row < n; ++row) {
            const rows = span(o[1], g[1], row, row + 1);
            if (rows[0] >= rows[1] || rows[1] <= 0) continue;
            for (let column = 0; column < n; ++column) {
                const columns = span(o[0], g[0], column, column + 1), from = Math.max(0, rows[0], columns[0]), to = Math.min(rows[1], columns[1]);
                if (from < to && from < best) best = Math.min(best, inCell(row * n + column, [o[0] - column - 0.5, o[1] - row - 0.5, o[2]], g, from, to, cell));
            }
        }
        return best;
    }

    function span(at, step, low, high) {
        if (Math.abs(step) < 1e-12) return at >= low && at <= high ? [-Infinity, Infinity] : [1, 0];
        const a = (low - at) / step, b = (high - at) / step;
        return [Math.min(a, b), Math.max(a, b)];
    }

    /** Where the ray is below the surface first, cut at the line. */
    function inCell(i, o, g, from, to, cell) {
        const step = map.stepUm * 1e-6, slope = plane => (plane[i] - layout.BLOCKMAP_SLOPE_ZERO) / layout.BLOCKMAP_SLOPE_ONE;
        const turn = map.angle[i] * 2 * Math.PI / 256, line = [Math.cos(turn), Math.sin(turn)];
        const at = (map.offset[i] - layout.BLOCKMAP_OFFSET_ZERO) * Math.SQRT1_2 / layout.BLOCKMAP_OFFSET_STEPS;
        const beyond = t => map.offset[i] !== 0 && line[0] * (o[0] + t * g[0]) + line[1] * (o[1] + t * g[1]) > at;
        const over = (t, isBeyond) => o[2] + t * g[2] - (isBeyond ? map.foot[i] * step
            : map.height[i] * step + (slope(map.slopeEast) * (o[0] + t * g[0]) + slope(map.slopeNorth) * (o[1] + t * g[1])) * cell);
        const cut = (at - line[0] * o[0] - line[1] * o[1]) / (line[0] * g[0] + line[1] * g[1]);
        const ends = map.offset[i] !== 0 && cut > from && cut < to ? [from, cut, to] : [from, to];
        const isUnder = o[2] + from * g[2] < -0.5;   // through the rim of the base: the box ends there
        for (let k = 0; k + 1 < ends.length && !isUnder; ++k) {
            const side = beyond((ends[k] + ends[k + 1]) / 2), first = over(ends[k], side), last = over(ends[k + 1], side);
            if (first < 0) return ends[k];
            if (last < 0) return ends[k] + (ends[k + 1] - ends[k]) * first / (first - last);
        }
        return Infinity;
    }
}
