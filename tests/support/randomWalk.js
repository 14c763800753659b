import { pointInside } from '../../client_scripts/core/pointInside.js';
import { seededRandom } from './random.js';

/**
 * A visitor's steps over a quarter, as bad as they come: straight runs, turns on the spot, slides along walls, stands on
 * gates and walks to and fro through them, steps that pass several sectors, jumps.
 *
 * Yields { point, kind: stand | step | slide | gate | jump }; every step but a jump stays on the ground.
 * `stepMm`: [least, most] of an ordinary step. Shares: `jumps`, `gates` (a dozen steps at a gate), `long` (up to 4.9 m).
 */
export function* randomWalk(
    sectors, oracle, {seed, steps, stepMm = [10, 1200], jumps = 1 / 2000, gates = 0.0095, long = 0.02}) {
  const random = seededRandom(seed), ids = [...sectors.keys()];
  const spot = () => pointInside(sectors.get(ids[Math.floor(random() * ids.length)]).ground).map(Math.round);
  let at = spot(), heading = random() * 2 * Math.PI;
  yield {point: at, kind: 'jump'};
  for (let i = 1; i < steps;) {
    const lot = random();
    if (lot < jumps) {
      at = spot();
      ++i;
      yield {point: at, kind: 'jump'};
    } else if (lot < jumps + gates) {
      for (const point of throughGate(sectors, oracle, at, random)) {
        ++i;
        yield {point: at = point, kind: 'gate'};
      }
    } else {
      if (lot < 0.05) heading += (random() - 0.5) * 3;
      const length = lot > 1 - long ? 4900 * random() : stepMm[0] + random() * (stepMm[1] - stepMm[0]);
      const next = ahead(at, heading, length), slid = isStep(oracle, at, next) ? null : slide(oracle, at, heading, length);
      if (slid) heading = slid.heading;
      const point = slid ? slid.point : isStep(oracle, at, next) ? next : at;
      if (point === at) heading = random() * 2 * Math.PI;
      ++i;
      const kind = slid ? 'slide' : point === at ? 'stand' : 'step';
      yield {point: at = point, kind};
    }
  }
}

const ahead = (at, heading, length) => [Math.round(at[0] + length * Math.sin(heading)), Math.round(at[1] + length * Math.cos(heading))];
const isStep = (oracle, a, b) => oracle.sectorsAt(b).length > 0 && oracle.isOpen(a, b);

/** Along the wall that is met, as near to it as the lattice lets. */
function slide(oracle, at, heading, length) {
  const hit = oracle.walls.find(([a, b]) => crosses(at, ahead(at, heading, length), a, b));
  if (!hit) return null;
  const along = Math.atan2(hit[1][0] - hit[0][0], hit[1][1] - hit[0][1]);
  const way = Math.cos(along - heading) >= 0 ? along : along + Math.PI, point = ahead(at, way, length);
  return isStep(oracle, at, point) ? {point, heading: way} : null;
}

const turn = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
const crosses = (a, b, c, d) => turn(a, b, c) * turn(a, b, d) <= 0 && turn(c, d, a) * turn(c, d, b) <= 0;

/** To a gate of the sector at `at`, onto its line, to and fro across it. */
function* throughGate(sectors, oracle, at, random) {
  const gates = sectors.get(oracle.sectorsAt(at)[0])?.gates ?? [], gate = gates[Math.floor(random() * gates.length)];
  if (!gate) return;
  const [a, b] = gate.line, share = 0.2 + 0.6 * random(), length = Math.hypot(b[0] - a[0], b[1] - a[1]);
  const on = [Math.round(a[0] + share * (b[0] - a[0])), Math.round(a[1] + share * (b[1] - a[1]))];
  const off = mm => [Math.round(on[0] + mm * (b[1] - a[1]) / length), Math.round(on[1] - mm * (b[0] - a[0]) / length)];
  let from = at;
  for (const point of [on, on, off(300), on, off(-300), off(300), off(900), off(-900), off(1500), on, off(-200)]) {
    if (!isStep(oracle, from, point) || Math.hypot(point[0] - from[0], point[1] - from[1]) > 4900) continue;
    yield from = point;
  }
}
