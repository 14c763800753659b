import { levelOf } from '../core/sectorRecord.js';
import { readParcel } from './readParcel.js';

/** Characters of texts kept for who comes back: a walk to and fro asks for nothing twice. */
const kMostKept = 16e6;
/** Images kept as Blobs; a parcel is told of the latest that it need not bring them, by so many letters of their names. */
const kMostImages = 1000, kMostNamed = 120, kNamed = 8;
const kImages = /\.\.\/textures\/([0-9a-f]+)\.png/g;

/**
 * Texts of sectors' files. Where the server gives parcels, what is asked for in one frame comes by one request, near files with
 * their parts and images; else each by its own, and its parts and images are not its matter.
 *
 * The owner calls get() for what it wants and send() once a frame.
 */
export class SectorTexts {
    /** `base`: address of the files' folder; `parcels`: where parcels are asked for, or null; `told(bytes, seconds)`: of each request. */
    constructor(base, { parcels = null, request, clock, told = () => {}, mostKept = kMostKept }) {
        Object.assign(this, { base, parcels, request, clock, told, mostKept, asked: [], requests: 0 });
        Object.assign(this, { kept: new Map(), keptLength: 0, images: new Map() });   // stem -> { text, parts }; name -> a Blob's address
    }

    /**
     * { text, parts: [[name, text], ...], bytes: as sent, 0 for what was kept }. `sized(bytes)` is called as soon as they are known.
     * Fails   Error: it cannot be had; it was given up by `signal`.
     */
    get(stem, { signal, sized = () => {} }) {
        const kept = this.kept.get(stem);
        if (kept) {
            this.keep(stem, kept);
            sized(0);
            return Promise.resolve({ ...this.withImages(kept), bytes: 0 });
        }
        if (!this.parcels) return this.fetchOne(stem, signal, sized);
        return new Promise((resolve, reject) => {
            signal.addEventListener('abort', () => reject(new Error(`${stem} was given up`)));
            this.asked.push({ stem, signal, sized, resolve, reject });
        });
    }

    /** Once a frame. */
    send() {
        const wants = this.asked.filter(({ signal }) => !signal.aborted);
        this.asked = [];
        if (wants.length) this.fetchParcel(wants).catch(error => wants.forEach(({ reject }) => reject(error)));
    }

    async fetchOne(stem, signal, sized) {
        const askedAt = this.clock();
        ++this.requests;
        const response = await this.request(`${this.base}${stem}.x3d`, { signal, priority: priorityOf(stem) });
        if (!response.ok) throw new Error(`${stem}.x3d: ${response.status}`);
        const length = Number(response.headers.get('Content-Length')) || 0;
        if (length) sized(length);
        const text = await response.text(), bytes = length || text.length;
        if (!signal.aborted) this.told(bytes, secondsOnLine(response.url) ?? this.clock() - askedAt);
        this.keep(stem, { text, parts: [] });
        return { text, parts: [], bytes };
    }

    /** A parcel is given up when nobody wants any more of it. */
    async fetchParcel(wants) {
        const askedAt = this.clock(), abort = new AbortController(), byStem = new Map(wants.map(want => [want.stem, want]));
        const pending = new Set(wants);
        for (const want of wants)
            want.signal.addEventListener('abort', () => {
                if (pending.delete(want) && pending.size === 0) abort.abort();
            });
        ++this.requests;
        const response = await this.request(this.urlFor(wants), { signal: abort.signal, priority: priorityOf(wants[0].stem) });
        if (!response.ok) throw new Error(`${this.parcels}: ${response.status}`);
        const parcel = readParcel(response.body, Number(response.headers.get('Content-Length')) || 0);
        const { bytes, missing } = (await parcel.next()).value;
        for (const [stem, size] of bytes) byStem.get(stem).sized(size);
        for (const stem of missing) {
            pending.delete(byStem.get(stem));
            byStem.get(stem).reject(new Error(`${stem}.x3d: there is none`));
        }
        for await (const { stem, text, parts, images } of parcel) {
            for (const image of images) this.keepImage(...image);
            this.keep(stem, { text, parts });
            pending.delete(byStem.get(stem));
            byStem.get(stem).resolve({ ...this.withImages({ text, parts }), bytes: bytes.get(stem) });
        }
        this.told([...bytes.values()].reduce((sum, size) => sum + size, 0), secondsOnLine(response.url) ?? this.clock() - askedAt);
    }

    urlFor(wants) {
        const known = [...this.images.keys()].slice(-kMostNamed).map(name => name.slice(0, kNamed)).sort();
        return `${this.parcels}?files=${wants.map(({ stem }) => stem).join(',')}&without=${known.join(',')}`;
    }

    /** One that came again keeps its address: scenes refer to it. */
    keepImage(name, base64) {
        if (this.images.has(name)) return;
        const bytes = Uint8Array.from(atob(base64), letter => letter.charCodeAt(0));
        this.images.set(name, URL.createObjectURL(new Blob([bytes], { type: 'image/png' })));
        if (this.images.size <= kMostImages) return;
        const [[oldest, address]] = this.images;
        this.images.delete(oldest);
        URL.revokeObjectURL(address);
    }

    /** What is used stays among the latest, of which parcels are told: the city's own images are in every file. */
    imageOf(name) {
        const address = this.images.get(name);
        if (address) {
            this.images.delete(name);
            this.images.set(name, address);
        }
        return address;
    }

    /** Images that are here are taken from here. */
    withImages({ text, parts }) {
        const own = whole => whole.replace(kImages, (address, name) => this.imageOf(name) ?? address);
        return { text: own(text), parts: parts.map(([name, part]) => [name, own(part)]) };
    }

    /** What was used the longest ago goes first. */
    keep(stem, texts) {
        const before = this.kept.get(stem);
        if (before) this.keptLength -= lengthOf(before);
        this.kept.delete(stem);
        this.kept.set(stem, texts);
        this.keptLength += lengthOf(texts);
        for (const [oldest, old] of this.kept) {
            if (this.keptLength <= this.mostKept || oldest === stem) break;
            this.kept.delete(oldest);
            this.keptLength -= lengthOf(old);
        }
    }
}

function lengthOf({ text, parts }) {
    return parts.reduce((sum, [, part]) => sum + part.length, text.length);
}

function priorityOf(stem) {
    return levelOf(stem) === 'near' ? 'high' : 'low';
}

/** The browser lists 250 requests, then no more. */
performance.addEventListener?.('resourcetimingbufferfull', () => performance.clearResourceTimings());

/** How long the request took, without what the page did meanwhile; undefined: the browser does not tell. */
function secondsOnLine(url) {
    const entry = url ? performance.getEntriesByName(url, 'resource').at(-1) : null;
    return entry ? entry.duration / 1000 : undefined;
}
