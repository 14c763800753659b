import { planFromDegrees } from '../core/planFrame.js';

/** m: what is fetched at a time. */
const kCell = 400;
const kMetresPerDegree = 111320;
const kCollections = { sectors: sectorOf, houses: houseOf };

/**
 * The city in plan, for the map and the document: sectors and houses out of /collections, fetched in cells around the
 * visitor, and sectors out of the records that are there. A site without a server has sectors alone: plan.json says
 * where they lie, their records the rest.
 *
 * Frame   plan metres. `version` grows when something has come.
 */
export class CityPlan {
    constructor(degrees, { request = url => fetch(url) } = {}) {
        Object.assign(this, { degrees, request, sectors: new Map(), houses: new Map(), cells: new Map(), site: null, version: 0 });
    }

    /** Fetches what is missing within `reach` metres. */
    around(east, north, reach) {
        for (let i = Math.floor((east - reach) / kCell); i <= Math.floor((east + reach) / kCell); ++i)
            for (let j = Math.floor((north - reach) / kCell); j <= Math.floor((north + reach) / kCell); ++j) {
                const key = `${i},${j}`;
                if (!this.cells.has(key)) this.cells.set(key, this.fetchCell(i, j).catch(() => this.cells.set(key, null)));
            }
    }

    /** The same, and all of it is there when the promise is kept. */
    async whole(east, north, reach) {
        this.around(east, north, reach);
        await Promise.all(this.cells.values());
    }

    async fetchCell(i, j) {
        if (!this.site) {
            const isServed = this.degrees && await this.fetchCollections(i, j).then(() => true, () => false);
            if (isServed) return;
            this.site ??= this.fetchSite();
        }
        await this.fetchRecords(await this.site, [i * kCell, j * kCell, (i + 1) * kCell, (j + 1) * kCell]);
    }

    /** [[id, west, south, east, north], ...] of a site without a server. */
    async fetchSite() {
        try {
            return (await this.fetchJson('/plan.json')).sectors;
        } catch (error) {
            this.site = null;   // a server that did not answer, perhaps: its collections are asked for again
            throw error;
        }
    }

    async fetchRecords(sectors, [west, south, east, north]) {
        const inside = sectors.filter(([id, w, s, e, n]) => !this.sectors.has(id) && w <= east && e >= west && s <= north && n >= south);
        for (const record of await Promise.all(inside.map(([id]) => this.fetchJson(`/sectors/${id}.json`)))) this.addRecord(record);
    }

    async fetchJson(url) {
        const response = await this.request(url);
        if (!response.ok) throw new Error(`${url}: ${response.status}`);
        return response.json();
    }

    async fetchCollections(i, j) {
        const [lat, lon] = this.degrees, width = kMetresPerDegree * Math.cos(lat * Math.PI / 180);
        const corner = (column, row) => [lon + column * kCell / width, lat + row * kCell / kMetresPerDegree];
        const box = [...corner(i, j), ...corner(i + 1, j + 1)];
        for (const [name, read] of Object.entries(kCollections)) {
            const { features } = await this.fetchJson(`/collections/${name}/items?limit=10000&bbox=${box.map(v => v.toFixed(6))}`);
            for (const feature of features)
                if (!this[name].has(feature.id)) this[name].set(feature.id, read(feature, this.degrees));
        }
        ++this.version;
    }

    /** A sector from its record, where no collection has told of it. */
    addRecord({ id, kind, name, ground }) {
        if (this.sectors.has(id)) return;
        this.sectors.set(id, withBox({ id, kind, name: name ?? '', rings: ground }));
        ++this.version;
    }

    sectorAt(east, north) {
        for (const sector of this.sectors.values()) if (holds(sector, east, north)) return sector;
        return null;
    }

    housesOf(sectorId) {
        return [...this.houses.values()].filter(house => house.sectorId === sectorId);
    }
}

function sectorOf({ id, geometry, properties: { kind, name } }, origin) {
    return withBox({ id, kind, name: name ?? '', rings: ringsOf(geometry, origin) });
}

function houseOf({ id, geometry, properties }, origin) {
    const { name, source_id: sourceId, sector_id: sectorId, height_m: height, tags = {} } = properties;
    return withBox({ id, name: name ?? '', sourceId, sectorId, height, tags, rings: ringsOf(geometry, origin) });
}

function ringsOf({ coordinates, type }, origin) {
    const polygons = type === 'MultiPolygon' ? coordinates : [coordinates];
    return polygons.flat().map(ring => ring.map(point => planFromDegrees(point, origin)));
}

function withBox(place) {
    const easts = place.rings[0].map(point => point[0]), norths = place.rings[0].map(point => point[1]);
    return { ...place, box: [Math.min(...easts), Math.min(...norths), Math.max(...easts), Math.max(...norths)] };
}

function holds({ rings, box: [west, south, east, north] }, x, y) {
    if (x < west || x > east || y < south || y > north) return false;
    let inside = false;
    for (const ring of rings)
        for (let i = 0, j = ring.length - 1; i < ring.length; j = i++) {
            const [[ax, ay], [bx, by]] = [ring[j], ring[i]];
            if ((ay > y) !== (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)) inside = !inside;
        }
    return inside;
}
