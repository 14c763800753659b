#version 300 es
// Casts a ray into a quadrant of a BlockMap: the inner loop walks a pyramid of greatest heights until a cell may be hit, the
// outer one solves the cell (while-while). What a cell is: city_db/blockmap.hpp; its colours: sectorgen/bake/blockmap_colours.hpp.
precision highp float;
precision highp int;
struct Fade { vec3 diffuseColor; };   // red: 0 not there, 0.5 there, 1 gone (core/TileFades.js)
uniform Fade x3d_Material;
uniform mat4 x3d_ModelViewMatrix, x3d_ProjectionMatrix;
uniform sampler2D x3d_Texture2D[1];
uniform vec3 hazeColour;
uniform float hazeDistance;
uniform ivec4 x3d_Viewport;
flat in vec3 eye;
flat in vec2 quadrant;
flat in float header[14];
out vec4 pixel;

const float kDarkest = 0.45;   // of the light where no sky is seen: what walls reflect
const int kHeader = 16, kMostSteps = 600;
const int kEast = 1, kNorth = 2, kWest = 4, kSouth = 8, kLine = 16;   // WallBit
int side;          // cells
float cellM, stepM, wallStepM;

uvec4 texel(int i) { return uvec4(texelFetch(x3d_Texture2D[0], ivec2(i & 1023, i >> 10), 0) * 255.0 + 0.5); }
int cellTexel(int region, ivec2 c) { return kHeader + (region * side + c.y) * side + c.x; }
float steps(uint high, uint low) { return float(high << 8 | low) * stepM; }

struct Cell { float height, foot, east, north, at; vec2 line; bool hasLine; };   // metres; slopes rise over run; line in cells

Cell cellAt(ivec2 c) {
    uvec4 a = texel(cellTexel(0, c)), b = texel(cellTexel(1, c));
    float turn = float(b.b) * (6.283185307 / 256.0);
    return Cell(steps(a.r, a.g), steps(a.b, a.a), (float(b.r) - header[9]) * header[10], (float(b.g) - header[9]) * header[10],
        (float(b.a) - header[11]) * header[12], vec2(cos(turn), sin(turn)), b.a != 0u);
}

/// Greatest height of the square of 2^level cells that c lies in.
float topOf(int level, ivec2 c) {
    int at = kHeader + 5 * side * side, across = side;
    for (int i = 0; i < level; ++i, across >>= 1) at += across * across;
    uvec4 t = texel(at + (c.y >> level) * across + (c.x >> level));
    return float(t.g << 16 | t.b << 8 | t.a) * stepM;
}

const int kNone = 0, kPlane = 1, kFoot = 2, kOnLine = 3, kOnSide = 4;

/// What the ray o + t d (cells, metres above the base plane) meets in a cell between t0 and t1; t0: where.
int solve(Cell cell, ivec2 c, vec3 o, vec3 d, inout float t0, float t1, bool fromSide) {
    vec2 p = o.xy - vec2(c) - 0.5;
    float planeA = o.z - cell.height - (cell.east * p.x + cell.north * p.y) * cellM;
    float planeB = d.z - (cell.east * d.x + cell.north * d.y) * cellM;
    if (!cell.hasLine) {
        if (planeA + planeB * t0 < 0.0) return fromSide ? kOnSide : kPlane;
        if (planeA + planeB * t1 < 0.0) {
            t0 = clamp(-planeA / planeB, t0, t1);
            return kPlane;
        }
        return kNone;
    }
    float lineA = dot(cell.line, p) - cell.at, lineB = dot(cell.line, d.xy);
    bool inside = lineA + lineB * t0 <= 0.0, ends = lineA + lineB * t1 <= 0.0;
    float middle = inside != ends ? clamp(-lineA / lineB, t0, t1) : t1;
    for (int part = 0; part < 2; ++part) {
        float a = inside ? planeA : o.z - cell.foot, b = inside ? planeB : d.z, from = part == 0 ? t0 : middle, to = part == 0 ? middle : t1;
        if (a + b * from < 0.0) {
            t0 = from;
            return part == 1 ? kOnLine : fromSide ? kOnSide : inside ? kPlane : kFoot;
        }
        if (a + b * to < 0.0) {
            t0 = clamp(-a / b, from, to);
            return inside ? kPlane : kFoot;
        }
        if (inside == ends) break;
        inside = ends;
    }
    return kNone;
}

vec3 colourOf(uvec4 t) { return vec3(t.rgb) / 255.0; }

/// A wall's column, between the heights where it begins and ends.
vec3 wallColour(ivec2 c, int bit, float up, float low, float high) {
    uvec4 t = texel(cellTexel(2, c));
    int walls = int(t.a), first = int(t.r << 16 | t.g << 8 | t.b), rows = int(header[7]);
    for (int below = walls & (bit - 1); below != 0; below &= below - 1) ++first;
    int row = clamp(int((up - low) / max(high - low, stepM) * float(rows)), 0, rows - 1);
    return colourOf(texel(int(header[8]) + first * rows + row));
}

float ambientAt(ivec2 c) {
    c = clamp(c, ivec2(0), ivec2(side - 1));
    return float(texel(cellTexel(3, c)).a) / 255.0;
}

float dither(ivec2 p) {
    int x = p.x ^ p.y, value = 0;
    for (int bit = 0; bit < 3; ++bit) value |= (((x >> bit) & 1) * 2 | ((p.y >> bit) & 1)) << (4 - 2 * bit);
    return (float(value) + 0.5) / 64.0;
}

void main() {
    float state = x3d_Material.diffuseColor.r, threshold = dither(ivec2(gl_FragCoord.xy) & 7);
    if (state <= 0.5 ? threshold > 2.0 * state : threshold < 2.0 * state - 1.0) discard;
    side = int(header[0]);
    cellM = header[1];
    stepM = header[2];
    wallStepM = header[6];
    // The ray through the pixel's middle, 1 long ahead: what a rasteriser hands on is rounded to parts of a pixel.
    vec2 onScreen = 2.0 * (gl_FragCoord.xy - vec2(x3d_Viewport.xy)) / vec2(x3d_Viewport.zw) - 1.0;
    vec3 ray = vec3(onScreen / vec2(x3d_ProjectionMatrix[0][0], x3d_ProjectionMatrix[1][1]), -1.0) * mat3(x3d_ModelViewMatrix);
    vec3 origin = vec3(eye.x, -eye.z, eye.y), towardsIt = vec3(ray.x, -ray.z, ray.y);
    vec2 slope = vec2(header[4], header[5]);
    vec3 o = vec3(origin.xy / cellM, origin.z - header[3] - dot(slope, origin.xy));
    vec3 d = vec3(towardsIt.xy / cellM, towardsIt.z - dot(slope, towardsIt.xy));
    d += vec3(equal(d, vec3(0.0))) * 1e-7;
    int half_ = side / 2;
    ivec2 low = ivec2(quadrant + 0.5) * half_, last = low + half_ - 1;
    vec2 inverse_ = 1.0 / d.xy, a = (vec2(low) - o.xy) * inverse_, b = (vec2(low + half_) - o.xy) * inverse_;
    vec2 near = min(a, b), far = max(a, b);
    float t = max(0.0, max(near.x, near.y)), tEnd = min(far.x, far.y);
    if (d.z < 0.0) tEnd = min(tEnd, (-0.5 - o.z) / d.z);
    bool fromSide = t > 0.0;
    int face = near.x > near.y ? (d.x > 0.0 ? kWest : kEast) : (d.y > 0.0 ? kSouth : kNorth);
    if (d.z < 0.0 && o.z + d.z * t > header[13]) {
        t = (header[13] - o.z) / d.z;
        fromSide = false;
    }
    if (t >= tEnd) discard;
    ivec2 towards = ivec2(greaterThan(d.xy, vec2(0.0)));
    ivec2 c = clamp(ivec2(floor(o.xy + d.xy * t)), low, last);
    int level = 0;
    for (int n = half_; n > 1; n >>= 1) ++level;
    int topLevel = level, hit = kNone, count = 0;
    Cell cell;
    float at = t;
    while (count < kMostSteps && hit == kNone) {
        float tOut = tEnd;
        vec2 leaves;
        ivec2 first;
        int size;
        bool isCandidate = false, isOver = false;
        while (count < kMostSteps) {   // until a cell may be hit
            ++count;
            size = 1 << level;
            first = (c >> level) << level;
            leaves = (vec2(first + towards * size) - o.xy) * inverse_;
            tOut = max(t, min(min(leaves.x, leaves.y), tEnd));
            if (o.z + d.z * (d.z < 0.0 ? tOut : t) <= topOf(level, c)) {
                if (level == 0) {
                    isCandidate = true;
                    break;
                }
                --level;
                c = clamp(ivec2(floor(o.xy + d.xy * t)), first, first + size - 1);
                continue;
            }
            if (tOut >= tEnd) {
                isOver = true;
                break;
            }
            t = tOut;
            bool east = leaves.x <= leaves.y;
            ivec2 on = clamp(ivec2(floor(o.xy + d.xy * t)), first, first + size - 1);
            c = east ? ivec2(towards.x == 1 ? first.x + size : first.x - 1, on.y) : ivec2(on.x, towards.y == 1 ? first.y + size : first.y - 1);
            face = east ? (towards.x == 1 ? kWest : kEast) : (towards.y == 1 ? kSouth : kNorth);
            fromSide = true;
            if (any(lessThan(c, low)) || any(greaterThan(c, last))) {
                isOver = true;
                break;
            }
            if (level < topLevel && (c >> (level + 1)) != (first >> (level + 1))) ++level;
        }
        if (!isCandidate || isOver) break;
        cell = cellAt(c);
        at = t;
        hit = solve(cell, c, o, d, at, tOut, fromSide);
        if (hit != kNone || tOut >= tEnd) break;
        t = tOut;
        bool east = leaves.x <= leaves.y;
        ivec2 on = clamp(ivec2(floor(o.xy + d.xy * t)), first, first);
        c = east ? ivec2(towards.x == 1 ? c.x + 1 : c.x - 1, on.y) : ivec2(on.x, towards.y == 1 ? c.y + 1 : c.y - 1);
        face = east ? (towards.x == 1 ? kWest : kEast) : (towards.y == 1 ? kSouth : kNorth);
        fromSide = true;
        if (any(lessThan(c, low)) || any(greaterThan(c, last))) break;
        if (topLevel > 0 && (c >> 1) != (first >> 1)) level = 1;
    }
    if (hit == kNone) discard;

    vec3 p = o + d * at;
    vec2 within = p.xy - vec2(c) - 0.5;
    vec3 own = colourOf(texel(cellTexel(3, c)));   // as the world's lights show it
    float ambient = ambientAt(c);
    int walls = int(texel(cellTexel(2, c)).a), wall = 0;
    ivec2 wallCell = c, aside = face == kEast ? ivec2(1, 0) : face == kNorth ? ivec2(0, 1) : face == kWest ? ivec2(-1, 0) : ivec2(0, -1);
    if (hit == kFoot) {
        own = colourOf(texel(cellTexel(4, c)));
    } else if (hit == kOnLine && (walls & kLine) != 0) {
        wall = kLine;
    } else if (hit == kOnSide) {
        float plane = cell.height + (cell.east * within.x + cell.north * within.y) * cellM;
        ivec2 other = c + aside;
        bool isInside = all(greaterThanEqual(other, ivec2(0))) && all(lessThan(other, ivec2(side)));
        if (plane - p.z > wallStepM) {
            if ((walls & face) != 0) wall = face;
            else if ((walls & kLine) != 0) wall = kLine;
            else if (isInside && (int(texel(cellTexel(2, other)).a) & kLine) != 0) wall = kLine, wallCell = other;
        }
    }
    if (wall != 0) {
        Cell of = cellAt(wallCell);
        float bottom = of.foot, height = of.height;
        vec2 outwards = of.line;
        if (wall != kLine) {
            outwards = vec2(aside);
            height = of.height + dot(outwards, vec2(of.east, of.north)) * cellM / 2.0;
            ivec2 other = c + aside;
            bottom = 0.0;
            if (all(greaterThanEqual(other, ivec2(0))) && all(lessThan(other, ivec2(side)))) {
                Cell beyond = cellAt(other);
                bottom = beyond.height - dot(outwards, vec2(beyond.east, beyond.north)) * cellM / 2.0;
            }
        }
        own = wallColour(wallCell, wall, p.z, bottom, height);
        float foot = ambientAt(wallCell + ivec2(round(2.0 * outwards)));
        ambient = mix(foot, 1.0, clamp((p.z - bottom) / max(height - bottom, stepM), 0.0, 1.0));
    }
    vec3 place = eye + at * ray;
    vec4 seen = x3d_ModelViewMatrix * vec4(place, 1.0), clip = x3d_ProjectionMatrix * seen;
    float haze = 1.0 - exp(-dot(seen.xyz, seen.xyz) / (hazeDistance * hazeDistance));
    pixel = vec4(mix(own * mix(kDarkest, 1.0, ambient), hazeColour, haze), 1.0);
    gl_FragDepth = 0.5 * clip.z / clip.w + 0.5;
}
