#version 300 es
// Tiles of the flown city: walls with windows, the ground's picture, haze, and the dither in which one tile gives way to
// another.
precision highp float;
struct Fade { vec3 diffuseColor; };   // red: 0 not there, 0.5 there, 1 gone (core/TileFades.js)
uniform Fade x3d_Material;
uniform sampler2D x3d_Texture2D[1];
uniform vec3 hazeColour;
uniform float hazeDistance;
in vec4 colour;
in vec2 place;
in vec3 fromEye;
in float light;
out vec4 pixel;

/// Of a wall: what its corners say (core/prismMesh.js, kSurfaces), and the light at its foot in a street.
const float kFoot = 0.35, kEave = 0.65, kDarkest = 0.62;
const float kRoof = 0.08, kBeyond = 0.25;   // up to these: a roof, land beyond the city
const float kMist = 0.8;        // halves of the city's square beyond its rim, where two thirds of a colour are mist
const vec3 kGlass = vec3(0.27, 0.31, 0.36);
const vec2 kWindowLow = vec2(0.29, 0.3), kWindowHigh = vec2(0.71, 0.84);   // of a pattern's cell

/// Place of the pixel in an 8 x 8 matrix whose next value lies far from the one before: bits of x ^ y and y, turned round.
float dither(ivec2 p) {
    int x = p.x ^ p.y, value = 0;
    for (int bit = 0; bit < 3; ++bit) value |= (((x >> bit) & 1) * 2 | ((p.y >> bit) & 1)) << (4 - 2 * bit);
    return (float(value) + 0.5) / 64.0;
}

/// Share of the stretch around p, as wide as a pixel, that windows fill, along one axis: the exact mean.
vec2 windows(vec2 p, vec2 wide) {
    vec2 a = p - wide / 2.0, b = p + wide / 2.0, open = kWindowHigh - kWindowLow;
    vec2 before = floor(a) * open + clamp(fract(a), kWindowLow, kWindowHigh);
    vec2 behind = floor(b) * open + clamp(fract(b), kWindowLow, kWindowHigh);
    return (behind - before) / wide;
}

void main() {
    float state = x3d_Material.diffuseColor.r, threshold = dither(ivec2(gl_FragCoord.xy) & 7);
    if (state <= 0.5 ? threshold > 2.0 * state : threshold < 2.0 * state - 1.0) discard;
    vec3 own = colour.rgb;
    float sky = 1.0;
    vec2 wide = max(fwidth(place), vec2(1e-4));
    if (colour.a > 0.75) {
        own = texture(x3d_Texture2D[0], place).rgb;
    } else if (colour.a > kBeyond) {
        vec2 share = windows(place, wide);
        own = mix(own, kGlass, 0.8 * share.x * share.y);
        sky = mix(kDarkest, 1.0, clamp((colour.a - kFoot) / (kEave - kFoot), 0.0, 1.0));
    }
    float haze = 1.0 - exp(-dot(fromEye, fromEye) / (hazeDistance * hazeDistance));
    if (colour.a > kRoof && colour.a <= kBeyond) {
        vec2 beyond = max(abs(place) - 1.0, 0.0) / kMist;
        haze = 1.0 - (1.0 - haze) * exp(-dot(beyond, beyond));
    }
    pixel = vec4(mix(own * light * sky, hazeColour, haze), 1.0);
}
