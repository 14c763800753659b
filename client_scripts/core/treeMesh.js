import { kSurfaces } from './prismMesh.js';

/**
 * A crown: rings of corners [share of the tree's height, share of the crown's radius, share of the leaves' light], from the top down;
 * the first and the last may be points. The trunk's radius is a share of the height.
 */
const kRound = [[1, 0, 1.1], [0.78, 0.82, 1.02], [0.44, 1, 0.85], [0.24, 0, 0.65]];
const kSlim = [[1, 0, 1.1], [0.6, 0.9, 1], [0.2, 1, 0.75], [0.12, 0, 0.6]];
const kConifer = [[1, 0, 1.1], [0.16, 1, 0.8], [0.14, 0, 0.6]];
const kCrownSides = 6, kTrunk = 0.02, kTrunkTop = 0.3, kBark = [92, 74, 58];

/**
 * Adds a tree (of decodePrisms) to a TriangleBuilder, metres from the tile's corner: a trunk of three faces and a crown of one skin,
 * with normals as of a ball: few corners, and no facets that one would see.
 */
export function addTree(builder, { form, at: [east, north], ground, height, crown, leaves }, layout) {
    const rings = { [layout.PRISM_TREE_ROUND]: kRound, [layout.PRISM_TREE_SLIM]: kSlim, [layout.PRISM_TREE_CONIFER]: kConifer }[form];
    if (!rings) throw new Error('prism tile: a tree of an unknown form');
    addTrunk(builder, [east, north], ground, height);
    const turn = (east * 7 + north * 3) % 1;   // not all alike
    const numbers = rings.map(([up, wide, light], r) => {
        const colour = [...leaves.map(value => Math.min(1, light * value / 255)), kSurfaces.roof];
        const slope = 2 * (r + 0.5) / rings.length - 1;   // -1 at the top, 1 below
        return Array.from({ length: wide === 0 ? 1 : kCrownSides }, (_, i) => {
            const angle = 2 * Math.PI * (i + 0.5 * r + turn) / kCrownSides, x = Math.sin(angle), z = Math.cos(angle), across = wide === 0 ? 0 : Math.sqrt(1 - slope * slope);
            return builder.corner([east + crown * wide * x, ground + height * up, -north + crown * wide * z],
                wide === 0 ? [0, -Math.sign(slope), 0] : [across * x, -slope, across * z], colour, [0, 0]);
        });
    });
    for (let r = 1; r < numbers.length; ++r) addBand(builder, numbers[r - 1], numbers[r]);
}

/** Faces between two rings, or a ring and a point; the lower ring's corners lie behind the upper one's by half a side. */
function addBand(builder, upper, lower) {
    const of = (ring, i) => ring[i % ring.length];
    for (let i = 0; i < kCrownSides; ++i) {
        if (upper.length > 1) builder.triangle(of(lower, i), of(upper, i + 1), of(upper, i));
        if (lower.length > 1) builder.triangle(of(lower, i), of(lower, i + 1), of(upper, i + 1));
    }
}

function addTrunk(builder, [east, north], ground, height) {
    const radius = kTrunk * height, top = ground + kTrunkTop * height, colour = [...kBark.map(value => value / 255), kSurfaces.roof];
    const corners = [0, 1, 2].map(i => [east + radius * Math.sin(i * 2.1), -north + radius * Math.cos(i * 2.1)]);
    corners.forEach(([x, z], i) => {
        const [u, w] = corners[(i + 1) % 3];
        builder.face([[x, ground, z], [u, ground, w], [u, top, w], [x, top, z]], colour, [[0, 0], [0, 0], [0, 0], [0, 0]]);
    });
}
