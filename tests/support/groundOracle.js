/**
 * Which grounds hold a point, and whether a step stays on the ground: the obvious way, with nothing of client_scripts, so
 * that it can judge it. Sides by whole numbers below 2^53. A grid of cells keeps 10^6 steps quick.
 */
export class GroundOracle {
  constructor(sectors, cell = 20000) {
    Object.assign(this, {cell, cells: new Map(), walls: []});
    const gates = new Set();
    for (const {gates: list} of sectors.values())
      for (const {line} of list) {
        for (let i = 1; i < line.length; ++i) gates.add(`${line[i - 1]};${line[i]}`).add(`${line[i]};${line[i - 1]}`);
      }
    for (const sector of sectors.values()) {
      this.each(sector.box, here => here.sectors.push(sector));
      for (const ring of sector.ground)
        for (let i = 0; i < ring.length; ++i) {
          const a = ring[i], b = ring[(i + 1) % ring.length];
          if (gates.has(`${a};${b}`)) continue;
          this.walls.push([a, b]);
          this.each(boxOf(a, b), here => here.walls.push([a, b]));
        }
    }
  }

  each([west, south, east, north], use) {
    for (let i = Math.floor(west / this.cell); i <= Math.floor(east / this.cell); ++i)
      for (let j = Math.floor(south / this.cell); j <= Math.floor(north / this.cell); ++j) {
        const key = i * 100003 + j;
        if (!this.cells.has(key)) this.cells.set(key, {sectors: [], walls: []});
        use(this.cells.get(key));
      }
  }

  /** Ids of the sectors whose closed ground holds the point: two on a gate, more where gates meet. */
  sectorsAt(point) {
    const here = this.cells.get(Math.floor(point[0] / this.cell) * 100003 + Math.floor(point[1] / this.cell));
    return (here?.sectors ?? []).filter(({ground}) => holds(ground, point)).map(({id}) => id);
  }

  /** Does the closed segment meet no wall? Both ends are on the ground, or this says nothing. */
  isOpen(a, b) {
    let open = true;
    this.each(boxOf(a, b), ({walls}) => { open &&= walls.every(([c, d]) => !meets(a, b, c, d)); });
    return open;
  }
}

const side = (a, b, c) => Math.sign((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
const boxOf = (a, b) => [Math.min(a[0], b[0]), Math.min(a[1], b[1]), Math.max(a[0], b[0]), Math.max(a[1], b[1])];
const isOn = (a, b, p) => side(a, b, p) === 0 && boxOf(a, b).every((v, i) => (i < 2 ? p[i] >= v : p[i - 2] <= v));

function holds(ground, p) {
  let crossings = 0;
  for (const ring of ground)
    for (let i = 0; i < ring.length; ++i) {
      const a = ring[i], b = ring[(i + 1) % ring.length];
      if (isOn(a, b, p)) return true;
      if (a[1] <= p[1] && b[1] > p[1] && side(a, b, p) > 0) ++crossings;
      if (b[1] <= p[1] && a[1] > p[1] && side(a, b, p) < 0) ++crossings;
    }
  return crossings % 2 === 1;
}

function meets(a, b, c, d) {
  if (isOn(a, b, c) || isOn(a, b, d) || isOn(c, d, a) || isOn(c, d, b)) return true;
  return side(a, b, c) !== side(a, b, d) && side(c, d, a) !== side(c, d, b);
}
