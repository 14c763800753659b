import { seededRandom } from './random.js';

const kSpacing = 60000, kJitter = 12000;   // mm

/**
 * A quarter of `side` x `side` crossroads with bent streets between them, no two alike: sectors as the core knows them
 * (sectorRecord.js), id -> sector. Streets are not convex, tight ones are 3 m wide, some are cut in two in the middle.
 * Two neighbouring grounds share a gate's end points exactly; everything is on the lattice.
 */
export function quarterSectors(side, seed) {
  const random = seededRandom(seed), between = (a, b) => Math.round(a + (b - a) * random());
  const sectors = new Map(), nodes = [];
  for (let i = 0; i < side; ++i)
    for (let j = 0; j < side; ++j) {
      const at = [i * kSpacing + between(-kJitter, kJitter), j * kSpacing + between(-kJitter, kJitter)];
      const half = between(1500, 6000), lean = between(-800, 800);
      const [sw, se, ne, nw] = [[-half, -half - lean], [half + lean, -half], [half, half + lean], [-half - lean, half]].map(
          p => [at[0] + p[0], at[1] + p[1]]);
      nodes.push({id: `x${i}-${j}`, ring: [sw, se, ne, nw], east: [se, ne], north: [ne, nw], west: [nw, sw], south: [sw, se]});
    }
  for (const node of nodes) add(sectors, node.id, node.ring);
  for (let i = 0; i < side; ++i)
    for (let j = 0; j < side; ++j) {
      const here = nodes[i * side + j];
      if (i + 1 < side) street(sectors, here.id, here.east, nodes[(i + 1) * side + j], 'west', between);
      if (j + 1 < side) street(sectors, here.id, here.north, nodes[i * side + j + 1], 'south', between);
    }
  return sectors;
}

/** From side [right, left] of one crossroads to the facing side of another, bent in the middle, in one or two sectors. */
function street(sectors, from, [right, left], node, facing, between) {
  const [endLeft, endRight] = node[facing], bend = [between(-9000, 9000), between(-9000, 9000)];
  const middle = (a, b) => [Math.round((a[0] + b[0]) / 2) + bend[0], Math.round((a[1] + b[1]) / 2) + bend[1]];
  const midRight = middle(right, endRight), midLeft = middle(left, endLeft), id = `${from}+${facing}`;
  if (between(0, 2) > 0) {
    add(sectors, id, [right, midRight, endRight, endLeft, midLeft, left]);
    join(sectors, from, id, [right, left]);
    join(sectors, id, node.id, [endRight, endLeft]);
    return;
  }
  add(sectors, `${id}a`, [right, midRight, midLeft, left]);
  add(sectors, `${id}b`, [midRight, endRight, endLeft, midLeft]);
  join(sectors, from, `${id}a`, [right, left]);
  join(sectors, `${id}a`, `${id}b`, [midRight, midLeft]);
  join(sectors, `${id}b`, node.id, [endRight, endLeft]);
}

function add(sectors, id, ring) {
  const easts = ring.map(p => p[0]), norths = ring.map(p => p[1]);
  sectors.set(id, {
    id, ground: [ring], gates: [], visible: [], overRoofs: [], shapes: 50, origin: [0, 0],
    box: [Math.min(...easts), Math.min(...norths), Math.max(...easts), Math.max(...norths)]
  });
}

/** `line` has the first sector's ground on the left. */
function join(sectors, a, b, line) {
  sectors.get(a).gates.push({id: `${a}.${b}`, to: b, line});
  sectors.get(b).gates.push({id: `${b}.${a}`, to: a, line: [...line].reverse()});
}
