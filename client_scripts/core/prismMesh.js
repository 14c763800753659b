import { triangulate } from './triangulate.js';

/** m: walls go on so far below the ground, so that none hangs over a slope. */
const kBelow = 2;
/** m: a window and the wall around it; walls shorter than kBlind have none. */
const kWindowWidth = 2.7, kStorey = 3.1, kBlind = 2.2;
/**
 * What a corner is, as the fourth number of its colour; the shader has the same (x3d/flyover.frag). Of a wall it also says how
 * much sky is seen: little at the foot, all at the eave.
 */
export const kSurfaces = { roof: 0, beyond: 0.15, foot: 0.35, wall: 0.65, ground: 1 };

const middle = (a, b) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
const between = (a, b, t) => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
const length = (a, b) => Math.hypot(b[0] - a[0], b[1] - a[1]);
/** X3D's axes: x = east, y = up, z = -north. */
const at = ([east, north], up) => [east, up, -north];
const linear = (colour, surface) => [...colour.map(value => value / 255), surface];
/** m: walls so high are as dark at their foot as any; lower ones see more sky. */
const kDeep = 15;
const footOf = height => kSurfaces.wall + (kSurfaces.foot - kSurfaces.wall) * Math.min(1, height / kDeep);

/** Adds the faces of a house (of decodePrisms) to a TriangleBuilder, metres from the tile's corner. */
export function addPrism(builder, house, layout) {
    addWalls(builder, house);
    const roofs = {
        [layout.PRISM_KIND_FLAT]: addFlatRoof, [layout.PRISM_KIND_TENT]: addTent,
        [layout.PRISM_KIND_GABLED]: addGabledRoof, [layout.PRISM_KIND_HIPPED]: addHippedRoof,
        [layout.PRISM_KIND_FACETED]: addOwnRoof };
    roofs[house.kind](builder, house);
}

function addWalls(builder, { rings, ground, eave, wall }) {
    const low = ground - kBelow, height = eave - ground, dark = linear(wall, footOf(height)), light = linear(wall, kSurfaces.wall);
    const storeys = Math.max(1, Math.round(height / kStorey)), foot = -kBelow / height * storeys;
    for (const ring of rings)
        ring.forEach((a, i) => {
            const b = ring[(i + 1) % ring.length], wide = length(a, b);
            const windows = wide < kBlind || height < kBlind ? 0 : Math.max(1, Math.round(wide / kWindowWidth));
            builder.shadedFace([at(a, low), at(b, low), at(b, eave), at(a, eave)], [dark, dark, light, light],
                [[0, foot], [windows, foot], [windows, storeys], [0, storeys]]);
        });
}

function addFlatRoof(builder, { rings, top, roof }) {
    for (const triangle of triangulate(rings)) addSlope(builder, roof, triangle.map(point => at(point, top)));
}

function addSlope(builder, roof, positions) {
    builder.face(positions, linear(roof, kSurfaces.roof), positions.map(([x, , z]) => [x, z]));
}

function addTent(builder, { rings: [ring], eave, top, roof }) {
    const sum = ring.reduce((a, b) => [a[0] + b[0], a[1] + b[1]]), apex = sum.map(value => value / ring.length);
    ring.forEach((a, i) => addSlope(builder, roof, [at(a, eave), at(ring[(i + 1) % ring.length], eave), at(apex, top)]));
}

function addOwnRoof(builder, { rings, points, facets, eave, roof, wall }) {
    const corners = [...rings.flat().map(point => at(point, eave)), ...points.map(([x, y, up]) => at([x, y], up))];
    const gable = linear(wall, kSurfaces.wall);
    for (const { isGable, corners: numbers } of facets) {
        const positions = numbers.map(i => corners[i]);
        if (isGable) builder.face(positions, gable, positions.map(() => [0, 0]));
        else addSlope(builder, roof, positions);
    }
}

/** Its points, from one of the two longer sides on, and the ridge over the middles of the shorter ones. */
function turned(ring) {
    const side = i => length(ring[i % 4], ring[(i + 1) % 4]);
    const first = side(0) + side(2) >= side(1) + side(3) ? 0 : 1;
    const points = [0, 1, 2, 3].map(i => ring[(first + i) % 4]);
    return { points, ridge: [middle(points[1], points[2]), middle(points[3], points[0])], short: (side(first + 1) + side(first + 3)) / 2 };
}

function addGabledRoof(builder, { rings: [ring], eave, top, roof, wall }) {
    const { points: [a, b, c, d], ridge: [p, q] } = turned(ring);
    addSlope(builder, roof, [at(a, eave), at(b, eave), at(p, top), at(q, top)]);
    addSlope(builder, roof, [at(c, eave), at(d, eave), at(q, top), at(p, top)]);
    const blind = [[0, 0], [0, 0], [0, 0]], colour = linear(wall, kSurfaces.wall);
    builder.face([at(b, eave), at(c, eave), at(p, top)], colour, blind);
    builder.face([at(d, eave), at(a, eave), at(q, top)], colour, blind);
}

/** The ridge is drawn in at both ends by half the shorter sides' length; where it is too short for that the roof is lower. */
function addHippedRoof(builder, { rings: [ring], eave, top, roof }) {
    const { points: [a, b, c, d], ridge, short } = turned(ring);
    const drawnIn = short / 2, long = length(...ridge), share = Math.min(0.5, drawnIn / (long || 1));
    const [p, q] = [between(...ridge, share), between(...ridge, 1 - share)];
    const up = eave + (top - eave) * Math.min(1, long / 2 / (drawnIn || 1));
    addSlope(builder, roof, [at(a, eave), at(b, eave), at(p, up), at(q, up)]);
    addSlope(builder, roof, [at(c, eave), at(d, eave), at(q, up), at(p, up)]);
    addSlope(builder, roof, [at(b, eave), at(c, eave), at(p, up)]);
    addSlope(builder, roof, [at(d, eave), at(a, eave), at(q, up)]);
}
