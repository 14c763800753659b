/**
 * A sector's record out of its file's metadata (client_scripts/README.md), in the shape of /sectors/ID.json.
 *
 * A gate's impostor is seven numbers there: eye (east, north, up), near, far, plane, radius; a panorama six: without plane.
 *
 * Needs   a tree of { name, value }: a set's values are { name, value } again, a leaf's are texts or numbers.
 * Fails   Error: a ground whose counts do not add up, neighbours that lack an origin or a box.
 */
export function recordFromMetadata(set) {
    const record = leavesOf(set);
    record.ground = ringsOf(record.id, record.ground ?? [], record.ground_counts ?? []);
    delete record.ground_counts;
    record.bodies = tuples(record.bodies ?? [], 3);
    record.gates = setsOf(set, 'gate').map(gate => ({ to: null, ...gate, line: tuples(gate.line ?? [], 2), ...impostorOf(gate) }));
    record.doors = setsOf(set, 'door').map(door => ({ ...door, line: tuples(door.line ?? [], 2) }));
    record.neighbours = neighboursOf(record);
    return { ...record, ...panoramaOf(record) };
}

const kLists = ['names', 'visible', 'over_roofs', 'important', 'origin', 'box', 'ground', 'ground_counts', 'line', 'impostor', 'panorama', 'bodies',
    'neighbour_ids', 'neighbour_origins', 'neighbour_boxes'];

function isSet(item) {
    return typeof item.value[0] === 'object';
}

function leavesOf(set) {
    const record = {};
    for (const item of Array.from(set.value)) {
        if (isSet(item)) continue;
        const values = Array.from(item.value);
        record[item.name] = kLists.includes(item.name) ? values : values[0];
    }
    return record;
}

function setsOf(set, name) {
    return Array.from(set.value).filter(item => item.name === name && isSet(item)).map(leavesOf);
}

function impostorOf({ id, impostor }) {
    if (!impostor) return {};
    const [east, north, up, near, far, plane, radius] = impostor;
    return { impostor: { url: `impostors/${id}.png`, eye: [east, north, up], near, far, plane, radius } };
}

function panoramaOf({ id, panorama }) {
    if (!panorama) return {};
    const [east, north, up, near, far, radius] = panorama;
    return { panorama: { url: `panoramas/${id}.png`, eye: [east, north, up], near, far, radius } };
}

function tuples(flat, size) {
    return Array.from({ length: Math.floor(flat.length / size) }, (_, i) => flat.slice(size * i, size * (i + 1)));
}

function neighboursOf(record) {
    const { neighbour_ids: ids = [], neighbour_origins: origins = [], neighbour_boxes: boxes = [] } = record;
    for (const name of ['neighbour_ids', 'neighbour_origins', 'neighbour_boxes']) delete record[name];
    if (origins.length !== 2 * ids.length || boxes.length !== 4 * ids.length)
        throw new Error(`sector ${record.id}: ${ids.length} neighbours, but ${origins.length} and ${boxes.length} numbers of theirs`);
    const places = tuples(origins, 2), areas = tuples(boxes, 4);
    return ids.map((id, i) => ({ id, origin: places[i], box: areas[i] }));
}

function ringsOf(id, flat, counts) {
    const points = tuples(flat, 2);
    if (counts.reduce((sum, count) => sum + count, 0) !== points.length)
        throw new Error(`sector ${id}: ground_counts ${counts} do not add up to its ${points.length} points`);
    let at = 0;
    return counts.map(count => points.slice(at, at += count));
}
