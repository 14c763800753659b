#version 300 es
// A quadrant of a BlockMap: the box's far side.
precision highp float;
precision highp int;
uniform mat4 x3d_ModelViewMatrix, x3d_ProjectionMatrix;
uniform sampler2D x3d_Texture2D[1];
in vec4 x3d_Vertex, x3d_TexCoord0;
flat out vec3 eye;   // metres from the tile's corner, X3D's axes
flat out vec2 quadrant;
flat out float header[14];   // core/blockMapTexture.js

float number(int i) {
    uvec4 b = uvec4(texelFetch(x3d_Texture2D[0], ivec2(i, 0), 0) * 255.0 + 0.5);
    return uintBitsToFloat(b.r << 24 | b.g << 16 | b.b << 8 | b.a);
}

void main() {
    eye = (inverse(x3d_ModelViewMatrix) * vec4(0.0, 0.0, 0.0, 1.0)).xyz;
    quadrant = x3d_TexCoord0.st;
    for (int i = 0; i < 14; ++i) header[i] = number(i);
    gl_Position = x3d_ProjectionMatrix * x3d_ModelViewMatrix * x3d_Vertex;
}
