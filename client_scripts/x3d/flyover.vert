#version 300 es
// Tiles of the flown city: light by the world's own lamps, one value for a face.
precision highp float;
uniform mat4 x3d_ModelViewMatrix, x3d_ProjectionMatrix;
uniform vec3 lightDirections[3];
uniform float lightIntensities[3];
in vec4 x3d_Vertex, x3d_Color, x3d_TexCoord0;
in vec3 x3d_Normal;
out vec4 colour;   // alpha: what it is (core/prismMesh.js, kSurfaces)
out vec2 place;
out vec3 fromEye;
out float light;

void main() {
    vec4 position = x3d_ModelViewMatrix * x3d_Vertex;
    light = 0.0;
    for (int i = 0; i < 3; ++i) light += lightIntensities[i] * max(0.0, -dot(x3d_Normal, normalize(lightDirections[i])));
    colour = x3d_Color;
    place = x3d_TexCoord0.st;
    fromEye = position.xyz;
    gl_Position = x3d_ProjectionMatrix * position;
}
