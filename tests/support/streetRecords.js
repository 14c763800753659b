/**
 * A street of `count` sectors, 40 m long and 10 m wide each, running east; a yard hangs on the north side of sector 2.
 * Records as the server sends them (client_scripts/README.md).
 */
export function streetRecords(count = 6) {
  const records = [];
  for (let i = 0; i < count; ++i) {
    const west = 40 * i, east = west + 40;
    records.push({
      id: `s${i}`,
      kind: 'street',
      name: `Long Street ${i}`,
      origin: [west + 20, 5],
      box: [west, 0, east, 10],
      shapes: 5,
      ground: [[[west, 0], [east, 0], [east, 10], [west, 10]]],
      gates: [
        {id: `g${i}e`, to: i + 1 < count ? `s${i + 1}` : null, line: [[east, 0], [east, 10]]},
        {id: `g${i}w`, to: i > 0 ? `s${i - 1}` : null, line: [[west, 10], [west, 0]]}
      ],
    });
  }
  if (count > 2) addYard(records);
  for (const record of records) record.neighbours = neighboursOf(record, records);
  return records;
}

/** The same, each sector seeing every other; `overRoofs`: ids that are seen over roofs alone. */
export function seeingFar(records, {overRoofs = []} = {}) {
  return records.map(record => ({
                       ...record,
                       visible: records.map(({id}) => id),
                       over_roofs: overRoofs.filter(id => id !== record.id),
                       neighbours: records.filter(({id}) => id !== record.id)
                                       .map(({id, origin, box, shapes}) => ({id, origin, box, shapes})),
                     }));
}

function addYard(records) {
  const street = records[2];
  street.ground = [[[80, 0], [120, 0], [120, 10], [104, 10], [96, 10], [80, 10]]];
  street.gates.push({id: 'g2n', to: 'yard', line: [[104, 10], [96, 10]]});
  records.push({
    id: 'yard',
    kind: 'yard',
    name: '',
    origin: [100, 20],
    box: [90, 10, 110, 30],
    shapes: 5,
    ground:
        [[[90, 10], [96, 10], [104, 10], [110, 10], [110, 30], [90, 30]], [[98, 18], [98, 22], [102, 22], [102, 18]]],
    gates: [{id: 'gys', to: 's2', line: [[96, 10], [104, 10]]}],
  });
}

function neighboursOf(record, records) {
  const ids = record.gates.map(gate => gate.to).filter(Boolean);
  return records.filter(other => ids.includes(other.id))
      .map(({id, origin, box, shapes}) => ({id, origin, box, shapes}));
}
