/**
 * A sector's record out of its file's MetadataSet (client_scripts/README.md), in the shape of /sectors/ID.json.
 *
 * Fails   Error: the scene has no RECORD, or a ground whose counts do not add up.
 */
export function recordFromScene(scene) {
    let set = null;
    try {
        set = scene.getNamedNode('RECORD');
    } catch {
        set = null;
    }
    if (!set) throw new Error('the sector file carries no RECORD');
    return recordFromMetadata(set);
}

/** Needs   a MetadataSet node: name, value (MFNode); leaves have name and value (MFString, MFDouble, ...). */
export function recordFromMetadata(set) {
    const record = leavesOf(set);
    record.ground = ringsOf(record.id, record.ground ?? [], record.ground_counts ?? []);
    delete record.ground_counts;
    record.gates = setsOf(set, 'gate').map(gate => ({ to: null, ...gate, line: pairs(gate.line ?? []) }));
    record.neighbours = setsOf(set, 'neighbour');
    return record;
}

const kLists = ['names', 'visible', 'over_roofs', 'origin', 'box', 'ground', 'ground_counts', 'line'];

function leavesOf(set) {
    const record = {};
    for (const item of Array.from(set.value)) {
        const values = Array.from(item.value);
        if (item.getNodeTypeName() === 'MetadataSet') continue;
        record[item.name] = kLists.includes(item.name) ? values : values[0];
    }
    return record;
}

function setsOf(set, name) {
    return Array.from(set.value)
        .filter(item => item.getNodeTypeName() === 'MetadataSet' && item.name === name).map(leavesOf);
}

function pairs(flat) {
    return Array.from({ length: Math.floor(flat.length / 2) }, (_, i) => [flat[2 * i], flat[2 * i + 1]]);
}

function ringsOf(id, flat, counts) {
    const points = pairs(flat);
    if (counts.reduce((sum, count) => sum + count, 0) !== points.length)
        throw new Error(`sector ${id}: ground_counts ${counts} do not add up to its ${points.length} points`);
    let at = 0;
    return counts.map(count => points.slice(at, at += count));
}
