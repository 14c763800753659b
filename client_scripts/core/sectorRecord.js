import { latticePoint, millimetres } from './planGeometry.js';

/** The median of two cities. */
const kShapesWhereUnknown = 70;

/**
 * A sector as the core knows it, from its record (client_scripts/README.md): plan lattice throughout.
 * `ground` is null while only a neighbour has told of it.
 *
 * Fails   Error: the record lacks an id, an origin or a box of numbers, or a gate's line.
 */
export function sectorFromRecord(record) {
    const sector = sectorFromNeighbour(record);
    if (!Array.isArray(record.ground) || record.ground.length === 0)
        throw new Error(`sector ${record.id}: its record has no ground`);
    sector.kind = record.kind ?? '';
    sector.name = record.name ?? '';
    sector.ground = record.ground.map(ring => ring.map(latticePoint));
    sector.gates = (record.gates ?? []).map(gate => gateFromRecord(gate, record.id));
    sector.hasPanorama = Boolean(record.panorama);
    sector.isInterior = sector.kind === 'interior';
    sector.doors = (record.doors ?? []).map(door => doorFromRecord(door, record.id));
    sector.bodies = (record.bodies ?? []).map(bodyFromRecord);
    sector.visible = [...(record.visible ?? [])];
    sector.overRoofs = [...(record.over_roofs ?? [])];
    sector.important = [...(record.important ?? [])];
    sector.neighbours = [...record.neighbours ?? [], ...(record.doors ?? []).map(door => ({ ...door, id: door.to }))].map(sectorFromNeighbour);
    const overRoofs = new Set(sector.overRoofs), behind = sector.gates.map(gate => gate.to).filter(Boolean);
    sector.leads = [...new Set([...behind, ...sector.visible.filter(id => !overRoofs.has(id))])];
    return sector;
}

/** A sector of which a far file has told where it leads: no ground yet. `leads`: what it sees and its gates lead to. */
export function sectorFromLinks(record) {
    const sector = sectorFromNeighbour(record), overRoofs = new Set(record.over_roofs);
    sector.neighbours = (record.neighbours ?? []).map(sectorFromNeighbour);
    sector.overRoofs = [...overRoofs];
    sector.leads = sector.neighbours.map(({ id }) => id).filter(id => !overRoofs.has(id));
    return sector;
}

export function sectorFromNeighbour(record) {
    const origin = numbers(record.origin, 2), box = numbers(record.box, 4);
    if (!record.id || !origin || !box)
        throw new Error(`a sector's record needs id, origin and box, found ${JSON.stringify(record).slice(0, 200)}`);
    return { id: record.id, origin, box: box.map(millimetres), shapes: record.shapes ?? kShapesWhereUnknown, ground: null };
}

function gateFromRecord(gate, sectorId) {
    if (!Array.isArray(gate.line) || gate.line.length < 2)
        throw new Error(`sector ${sectorId}: gate ${gate.id} has no line`);
    return { id: gate.id ?? '', to: gate.to || null, kind: gate.kind ?? '', hasImpostor: Boolean(gate.impostor),
        line: gate.line.map(latticePoint) };
}

/** `from`: the sector that it is a door of. */
function doorFromRecord({ id, twin, to, line }, sectorId) {
    if (!id || !twin || !to || !Array.isArray(line) || line.length !== 2)
        throw new Error(`sector ${sectorId}: door ${id} lacks its twin, where it leads or its line`);
    return { id, twin, from: sectorId, to, line: line.map(latticePoint) };
}

function bodyFromRecord([east, north, radius]) {
    return { at: latticePoint([east, north]), radius: millimetres(radius) };
}

function numbers(list, count) {
    const plain = list && Array.from(list).slice(0, count);
    return plain && plain.length === count && plain.every(Number.isFinite) ? plain : null;
}

/**
 * L_1 (paper 004 §5.1) with what to show of each: id -> 'near' for the sector itself, which comes first, and where its
 * gates lead; 'tall', its houses that stand above the roofs before them, for what is seen over roofs alone; 'far' for
 * what else is visible.
 */
export function levelsAround(sector) {
    const levels = new Map([[sector.id, 'near']]);
    for (const gate of sector.gates ?? []) if (gate.to) levels.set(gate.to, 'near');
    const overRoofs = new Set(sector.overRoofs);
    for (const id of sector.visible ?? []) if (!levels.has(id)) levels.set(id, overRoofs.has(id) ? 'tall' : 'far');
    return levels;
}

/** A sector's file at a level, without what tells the format: ID, ID.far, ID.tall. Ids have no dots. */
export function stemOf(id, level) {
    return level === 'near' ? id : `${id}.${level}`;
}

export function idOf(stem) {
    return stem.split('.')[0];
}

export function levelOf(stem) {
    return stem.split('.')[1] ?? 'near';
}
