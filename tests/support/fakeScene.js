/** As much of an X3D browser's scene access as client_scripts/x3d uses. */
export class FakeNode {
  constructor(type, fields = {}) {
    this.type = type;
    this.children = [];
    this.translation = {x: 0, y: 0, z: 0};
    Object.assign(this, fields);
  }

  getNodeTypeName() { return this.type; }
}

/** Loads in one step when `load` turns true or `url` is set, as X_ITE does but for the delay. */
export class FakeInline extends FakeNode {
  static broken = new Set();
  static bare = new Set();
  #load = true;
  #url = [];
  #state = 1006;

  constructor(served) {
    super('Inline');
    this.served = served;
  }

  get load() { return this.#load; }
  set load(value) {
    this.#load = value;
    this.#start();
  }
  get url() { return this.#url; }
  set url(value) {
    this.#url = value;
    this.#start();
  }

  #start() {
    if (!this.#load)
      this.#state = 1006;
    else if (this.#url.length)
      this.#state = this.served.has(this.#url[0]) && !FakeInline.broken.has(this.#url[0]) ? 1008 : 1009;
  }

  getValue() {
    return {
      checkLoadState: () => this.#state,
      getInternalScene: () => ({
        getNamedNode: name => {
          if (name !== 'RECORD' || FakeInline.bare.has(this.#url[0])) throw new Error(`no node ${name}`);
          return metadataOf(this.served.get(this.#url[0]));
        }
      }),
    };
  }
}

/** The record as the MetadataSet of client_scripts/README.md. */
export function metadataOf(record) {
  const leaf = (name, ...value) => new FakeNode('Metadata', {name, value});
  const set = (name, ...value) => new FakeNode('MetadataSet', {name, value});
  const gates = record.gates.map(
      gate => set(
          'gate', leaf('id', gate.id), ...(gate.to ? [leaf('to', gate.to)] : []), leaf('line', ...gate.line.flat())));
  const doors = (record.doors ?? []).map(
      ({ id, to, twin, line, origin, box }) => set(
          'door', leaf('id', id), leaf('to', to), leaf('twin', twin), leaf('line', ...line.flat()), leaf('origin', ...origin), leaf('box', ...box)));
  const all = key => record.neighbours.flatMap(other => other[key]);
  const neighbours = record.neighbours.length === 0 ? [] : [
    leaf('neighbour_ids', ...all('id')), leaf('neighbour_origins', ...all('origin')), leaf('neighbour_boxes', ...all('box'))];
  return set(
      'sector', leaf('id', record.id), leaf('kind', record.kind), leaf('name', record.name),
      leaf('origin', ...record.origin), leaf('box', ...record.box), leaf('shapes', record.shapes),
      ...(record.bodies ? [leaf('bodies', ...record.bodies.flat())] : []), leaf('ground_counts', ...record.ground.map(ring => ring.length)), leaf('ground', ...record.ground.flat(2)),
      ...gates, ...doors, ...neighbours, ...(record.visible ? [leaf('visible', ...record.visible)] : []),
      ...(record.over_roofs?.length ? [leaf('over_roofs', ...record.over_roofs)] : []));
}
