/** Names of X_ITE's that the tiles' shaders use, for drawing without X_ITE. */
const kAttributes = { x3d_Vertex: ['positions', 3], x3d_Normal: ['normals', 3], x3d_Color: ['colours', 4], x3d_TexCoord0: ['places', 2] };
const kLights = [0.6, -0.65, -0.5, 0.12, -0.35, 0.75, -0.6, 0.15, -0.25], kIntensities = [1, 0.75, 0.68];

/** A program of a tile's shaders. Fails   Error with what the compiler says. */
export function tileProgram(gl, { vertex, fragment }) {
    const program = gl.createProgram();
    for (const [type, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
}

/** A texture of a BlockMap's `image` (blockMapTexture), every byte as it is. */
export function imageTexture(gl, { width, height, pixels }) {
    const bytes = new Uint8Array(4 * pixels.length);
    pixels.forEach((value, i) => [24, 16, 8, 0].forEach((bits, k) => { bytes[4 * i + k] = value >>> bits; }));
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    for (const name of ['TEXTURE_MIN_FILTER', 'TEXTURE_MAG_FILTER']) gl.texParameteri(gl.TEXTURE_2D, gl[name], gl.NEAREST);
}

/** Column-major: looks along `heading`, `pitch` from `eye`, X3D's axes; far enough for a tile. */
export function viewMatrices({ eye: [east, north, up], heading, pitch, half }, [near, far] = [1, 20000]) {
    const [s, c, sp, cp] = [Math.sin(heading), Math.cos(heading), Math.sin(pitch), Math.cos(pitch)];
    const right = [c, 0, s], above = [-s * sp, cp, c * sp], back = [-s * cp, -sp, c * cp], place = [east, up, -north];
    const away = axis => -axis.reduce((sum, value, k) => sum + value * place[k], 0);
    const modelView = [0, 1, 2].flatMap(k => [right[k], above[k], back[k], 0]).concat(away(right), away(above), away(back), 1);
    const depth = (far + near) / (near - far), projection = [1 / half[0], 0, 0, 0, 0, 1 / half[1], 0, 0, 0, 0, depth, -1, 0, 0, 2 * far * near / (near - far), 0];
    return { modelView, projection };
}

/** The parts of a mesh (tileMesh, blockMapMesh) in the card's memory, for drawParts. */
export function uploadParts(gl, program, parts) {
    return parts.map(part => {
        const array = gl.createVertexArray();
        gl.bindVertexArray(array);
        for (const [name, [field, size]] of Object.entries(kAttributes)) {
            const index = gl.getAttribLocation(program, name);
            if (index < 0) continue;
            gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
            gl.bufferData(gl.ARRAY_BUFFER, part[field], gl.STATIC_DRAW);
            gl.enableVertexAttribArray(index);
            gl.vertexAttribPointer(index, size, gl.FLOAT, false, 0, 0);
        }
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(part.indices), gl.STATIC_DRAW);
        gl.bindVertexArray(null);
        return { array, count: part.indices.length };
    });
}

/** Draws what was uploaded as it is when it is wholly there. `view`: of viewMatrices. */
export function drawParts(gl, program, uploaded, { modelView, projection }) {
    const at = name => gl.getUniformLocation(program, name);
    gl.useProgram(program);
    gl.uniformMatrix4fv(at('x3d_ModelViewMatrix'), false, modelView);
    gl.uniformMatrix4fv(at('x3d_ProjectionMatrix'), false, projection);
    gl.uniform3fv(at('lightDirections'), kLights);
    gl.uniform1fv(at('lightIntensities'), kIntensities);
    gl.uniform3f(at('x3d_Material.diffuseColor'), 0.5, 0, 0);
    gl.uniform1f(at('hazeDistance'), 1e9);
    gl.uniform4iv(at('x3d_Viewport'), gl.getParameter(gl.VIEWPORT));
    gl.enable(gl.DEPTH_TEST);
    gl.enable(gl.CULL_FACE);
    for (const { array, count } of uploaded) {
        gl.bindVertexArray(array);
        gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    }
    gl.bindVertexArray(null);
}
