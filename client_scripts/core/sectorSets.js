import { levelsAround } from './sectorRecord.js';

/**
 * L_i of paper 004 §5.1 around a sector: L_0 = {C}, L_{i+1} = L_i and all that its members' L_vis lists; breadth-first,
 * as far as records are known: the sets grow as records arrive.
 *
 * Returns id -> { ring: the first set it is in, level: which of its files to show }, known sectors only, C first.
 *         'near' is for C and what its gates lead to, 'far' for the others, 'tall' for what is seen over roofs alone.
 * Differs a sector seen over roofs alone leads no further: of it only the upper parts of some houses show.
 */
export function sectorsWithin(sectors, current, i) {
    const found = new Map([[current.id, { ring: 0, level: 'near' }]]);
    if (i < 1) return found;
    for (const [id, level] of levelsAround(current))
        if (id !== current.id && sectors.has(id)) found.set(id, { ring: 1, level });
    let rim = [...found.keys()].filter(id => id !== current.id && found.get(id).level !== 'tall');
    for (let ring = 2; ring <= i && rim.length > 0; ++ring) rim = nextRing(sectors, found, rim, ring);
    return found;
}

/** Adds what the sectors of `rim` see; returns those that lead further. */
function nextRing(sectors, found, rim, ring) {
    const next = [];
    for (const { leads = [] } of rim.map(id => sectors.get(id)))
        for (const id of leads) {
            const there = found.get(id);
            if (!sectors.has(id) || (there && there.level !== 'tall')) continue;
            found.set(id, { ring: there?.ring ?? ring, level: 'far' });
            next.push(id);
        }
    for (const { overRoofs = [] } of rim.map(id => sectors.get(id)))
        for (const id of overRoofs) if (sectors.has(id) && !found.has(id)) found.set(id, { ring, level: 'tall' });
    return next;
}
