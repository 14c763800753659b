import { GroundWalls } from '../../../client_scripts/core/GroundWalls.js';
import { distance, nearestOnSegment } from '../../../client_scripts/core/planGeometry.js';
import { levelsAround, sectorFromRecord, stemOf } from '../../../client_scripts/core/sectorRecord.js';
import { sectorsWithin } from '../../../client_scripts/core/sectorSets.js';

const kLeastGateMm = 1500;       // a gate the route uses is at least this wide
const kOffWallMm = [1200, 700];  // way points lie this far off a ground's corners
const kClearMm = 450;            // and every point of the way at least this far off a wall

/** The city as its records tell it, fetched as needed; plans the walks of the browser tests. */
export class CityMap {
    constructor(origin) {
        Object.assign(this, { origin, records: new Map() });
    }

    /** The record as the server sends it. */
    async record(id) {
        if (!this.records.has(id)) {
            const response = await fetch(`${this.origin}/sectors/${id}.json`);
            if (!response.ok) throw new Error(`/sectors/${id}.json: ${response.status}`);
            this.records.set(id, await response.json());
        }
        return this.records.get(id);
    }

    async sector(id) {
        return sectorFromRecord(await this.record(id));
    }

    /** Stems of the files that are to be there around `id`: near ones for it and behind its gates, far and tall by its record. */
    async filesAround(id) {
        return [...levelsAround(await this.sector(id))].map(([near, level]) => stemOf(near, level)).sort();
    }

    /** Stems of L_i around `id`. */
    async filesWithin(id, i) {
        const sectors = new Map(), first = await this.sector(id);
        const rings = [[id]];
        for (let ring = 0; ring < i; ++ring) {
            for (const member of rings[ring]) sectors.set(member, await this.sector(member));
            const found = [...sectorsWithin(withNeighbours(sectors), first, ring + 1)];
            rings.push(found.filter(([, { ring: at, level }]) => at === ring + 1 && level !== 'tall').map(([member]) => member));
        }
        return [...sectorsWithin(withNeighbours(sectors), first, i)].map(([member, { level }]) => stemOf(member, level)).sort();
    }

    /** A chain of `gates` + 1 sectors from `start`, without going back, along streets of one name where it can. */
    async route(start, gates) {
        const visited = new Set([start]);
        const chain = await this.extend([start], gates, visited, { left: 4000 });
        if (!chain) throw new Error(`no way through ${gates} gates from sector ${start}`);
        return chain;
    }

    async extend(chain, gates, visited, tries) {
        if (chain.length > gates) return chain;
        if (--tries.left < 0) return null;
        const here = await this.sector(chain.at(-1));
        const next = [];
        for (const gate of here.gates) {
            if (!gate.to || visited.has(gate.to) || widest(gate).width < kLeastGateMm) continue;
            const there = await this.sector(gate.to);
            const isSameStreet = there.name && there.name === here.name;
            const penalty = (isSameStreet ? 0 : 1) + (there.kind === 'street' ? 0 : 1) + (there.kind === 'yard' ? 2 : 0);
            next.push([penalty, gate.to]);
        }
        next.sort((a, b) => a[0] - b[0] || (a[1] < b[1] ? -1 : 1));
        for (const [, id] of next) {
            visited.add(id);
            const longer = [...chain, id];
            const whole = await this.isWalkable(longer.slice(-3)) && await this.extend(longer, gates, visited, tries);
            if (whole) return whole;
        }
        return null;
    }

    async isWalkable(chain) {
        if (chain.length < 3) return true;
        return (await this.legBetweenGates(chain)) !== null;
    }

    async legBetweenGates([before, id, after]) {
        const from = await this.gateMiddle(id, before), to = await this.gateMiddle(id, after);
        return this.path(id, from, to);
    }

    /** Middle of the widest straight part of the gate from `id` to `to`. */
    async gateMiddle(id, to) {
        const sector = await this.sector(id);
        const parts = sector.gates.filter(gate => gate.to === to).map(widest).sort((a, b) => b.width - a.width);
        return parts[0].middle;
    }

    /** Way points through `id` from one point to another, off the walls; null: too narrow. */
    async path(id, from, to) {
        const sector = await this.sector(id);
        const around = await Promise.all(sector.gates.map(gate => gate.to).filter(Boolean).map(other => this.sector(other)));
        const walls = new GroundWalls([sector, ...around]);
        const spots = kOffWallMm.flatMap(off => cornersOffWalls(sector, off))
            .filter(spot => walls.isOnGround(spot) && walls.clearance(spot) >= kClearMm);
        return shortestPath([from, to, ...spots], (a, b) => isClear(walls, a, b));
    }

    /** The sector's walls (no gates) with room before them, longest first: { stand, wall: [a, b] }; stand is 2.5 m off its middle. */
    async wallsToRunInto(id) {
        const sector = await this.sector(id), walls = new GroundWalls([sector]);
        const isGate = ([a, b]) => sector.gates.some(({ line }) =>
            line.some((point, i) => i > 0 && distance(line[i - 1], a) === 0 && distance(point, b) === 0));
        return walls.walls.filter(wall => distance(...wall) > 3000 && !isGate(wall)).sort((p, q) => distance(...q) - distance(...p))
            .map(([a, b]) => ({ stand: pointBefore(a, b, 2500), wall: [a, b] }))
            .filter(({ stand }) => walls.isOnGround(stand) && walls.clearance(stand) > 1500);
    }

    /** The first of them that can be walked to from a point of the sector: { stand, wall, path }. */
    async wallInReach(id, from) {
        for (const found of await this.wallsToRunInto(id)) {
            const path = await this.path(id, from, found.stand);
            if (path) return { ...found, path };
        }
        throw new Error(`sector ${id} has no wall to walk up to from ${from}`);
    }
}

/** What is known: the sectors, and those that they tell of. */
function withNeighbours(sectors) {
    const neighbours = [...sectors.values()].flatMap(sector => sector.neighbours.map(neighbour => [neighbour.id, neighbour]));
    return new Map([...neighbours, ...sectors]);
}

function pointBefore(a, b, off) {
    const length = distance(a, b);
    return [(a[0] + b[0]) / 2 - off * (b[1] - a[1]) / length, (a[1] + b[1]) / 2 + off * (b[0] - a[0]) / length];
}

/** The first door from a street to an interior: { street, room, door, at(m): plan metres before (> 0) or behind it, heading that leads in }. */
export async function firstDoor(origin) {
    const { features } = await (await fetch(`${origin}/collections/sectors/items?limit=1000`)).json();
    for (const { id } of features.sort((a, b) => (a.id < b.id ? -1 : 1))) {
        const record = await (await fetch(`${origin}/sectors/${id}.json`)).json();
        for (const door of record.doors ?? []) {
            const room = await (await fetch(`${origin}/sectors/${door.to}.json`)).json();
            const [[ax, ay], [bx, by]] = door.line, length = Math.hypot(bx - ax, by - ay);
            const out = [-(by - ay) / length, (bx - ax) / length];
            const at = metres => [(ax + bx) / 2 + metres * out[0], (ay + by) / 2 + metres * out[1]];
            return { street: id, record, room, door, at, heading: Math.atan2(-out[0], -out[1]) };
        }
    }
    throw new Error('the city has no door');
}

/** The server's own start, or the nearest sector from which a route leads. */
export async function startWithRoute(map, gates) {
    const root = await (await fetch(`${map.origin}/city.x3d`)).text();
    const first = root.match(/name='start'[^>]*value='([^']*)'/)?.[1] ?? root.match(/sectors\/([^."]+)\.x3d/)[1];
    const queue = [first];
    for (let i = 0; i < queue.length && i < 50; ++i) {
        const sector = await map.sector(queue[i]);
        if (sector.kind !== 'yard' && await map.route(queue[i], gates).catch(() => null)) return queue[i];
        for (const id of levelsAround(sector).keys()) if (!queue.includes(id)) queue.push(id);
    }
    throw new Error(`no sector near the start leads through ${gates} gates`);
}

function widest(gate) {
    let best = { width: 0, middle: gate.line[0] };
    for (let i = 1; i < gate.line.length; ++i) {
        const [a, b] = [gate.line[i - 1], gate.line[i]], width = distance(a, b);
        if (width > best.width) best = { width, middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2] };
    }
    return best;
}

function cornersOffWalls(sector, off) {
    return sector.ground.flatMap(ring => ring.flatMap((b, i) => {
        const a = ring.at(i - 1), c = ring[(i + 1) % ring.length];
        const turn = [a, c].map(p => [(p[0] - b[0]) / (distance(p, b) || 1), (p[1] - b[1]) / (distance(p, b) || 1)]);
        const sum = [turn[0][0] + turn[1][0], turn[0][1] + turn[1][1]], length = Math.hypot(...sum);
        const along = length > 0.05 ? [sum[0] / length, sum[1] / length] : [-turn[1][1], turn[1][0]];
        return [[b[0] - off * along[0], b[1] - off * along[1]], [b[0] + off * along[0], b[1] + off * along[1]]];
    }));
}

function isClear(walls, a, b) {
    const length = distance(a, b), steps = Math.max(1, Math.ceil(length / 250));
    const near = walls.walls.filter(([p, q]) => distance(nearestOnSegment(p, q, a), a) < length + 1000);
    for (let i = 0; i <= steps; ++i) {
        const point = [0, 1].map(k => a[k] + (b[k] - a[k]) * i / steps);
        const isEnd = i === 0 || i === steps;
        if (!isEnd && (!walls.isOnGround(point) || walls.clearance(point, near) < kClearMm)) return false;
    }
    return true;
}

/** Dijkstra from spots[0] to spots[1]; the points after the first. */
function shortestPath(spots, canGo) {
    const cost = spots.map(() => Infinity), from = spots.map(() => -1), done = new Set();
    cost[0] = 0;
    while (!done.has(1)) {
        let best = -1;
        for (let i = 0; i < spots.length; ++i)
            if (!done.has(i) && cost[i] < Infinity && (best < 0 || cost[i] < cost[best])) best = i;
        if (best < 0) return null;
        done.add(best);
        for (let i = 0; i < spots.length; ++i) {
            const total = cost[best] + distance(spots[best], spots[i]);
            if (!done.has(i) && total < cost[i] && canGo(spots[best], spots[i])) [cost[i], from[i]] = [total, best];
        }
    }
    const path = [];
    for (let i = 1; i !== 0; i = from[i]) path.unshift(spots[i]);
    return path;
}
