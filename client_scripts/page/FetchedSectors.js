import { levelOf } from '../core/sectorRecord.js';

/** Bytes a file has until one of its level has come: medians of two cities, as sent. */
const kTypicalBytes = { near: 13000, far: 3500, tall: 2500 };
/** The share of a mean that a new value has. */
const kNew = 0.2;

/**
 * Shows and hides sectors' files for the page: fetches them, so that a request can be given up and its bytes counted, and
 * puts at most one into the world per frame. The Script's counterpart is x3d/InlineSectors.
 *
 * Needs   `stage` (XIteAdapter): place(origin), makeScene(text), fill(place, scene), empty(place), recordOf(scene),
 * setImpostor(scene, gateId, opacity), setDoor(scene, doorId, look), touchTime(scene, doorId).
 */
export class FetchedSectors {
    constructor(stage, base, { request = (url, options) => fetch(url, options), clock = () => performance.now() / 1000 } = {}) {
        Object.assign(this, { stage, base, request, clock, files: new Map(), ready: [], made: [] });
        this.means = { ...kTypicalBytes };
        this.loaded = { bytes: 0, files: 0 };
        this.bytesPerSecond = null;
    }

    show(stem, origin) {
        const file = this.files.get(stem) ?? { stem, place: this.stage.place(origin), record: null };
        Object.assign(file, { phase: 'loading', abort: new AbortController(), askedAt: this.clock(), bytes: null, scene: null });
        this.files.set(stem, file);
        this.fetch(file, file.abort).catch(error => {
            if (!file.abort.signal.aborted) Object.assign(file, { phase: 'failed', error });
        });
    }

    async fetch(file, abort) {
        const priority = levelOf(file.stem) === 'near' ? 'high' : 'low';
        const response = await this.request(`${this.base}${file.stem}.x3d`, { signal: abort.signal, priority });
        if (!response.ok) throw new Error(`${file.stem}.x3d: ${response.status}`);
        file.bytes = Number(response.headers.get('Content-Length')) || null;
        const text = await response.text();
        if (abort.signal.aborted) return;
        this.count(file, file.bytes ?? text.length, secondsOnLine(response.url) ?? this.clock() - file.askedAt);
        this.ready.push({ file, text, abort });
    }

    count(file, bytes, seconds) {
        const level = levelOf(file.stem), speed = bytes / Math.max(0.001, seconds);
        file.bytes = bytes;
        this.loaded.bytes += bytes;
        ++this.loaded.files;
        this.means[level] += kNew * (bytes - this.means[level]);
        this.bytesPerSecond = this.bytesPerSecond === null ? speed : this.bytesPerSecond + kNew * (speed - this.bytesPerSecond);
    }

    /** Once a frame: puts at most one file into the world, and begins to read at most one that has come. */
    frame() {
        const made = this.made.shift();
        if (made && !made.abort.signal.aborted) this.insert(made);
        const next = this.ready.find(({ abort }) => !abort.signal.aborted);
        this.ready = next ? this.ready.slice(this.ready.indexOf(next) + 1) : [];
        if (!next) return;
        const { file, text, abort } = next;
        this.stage.makeScene(text).then(scene => { this.made.push({ file, scene, abort }); }).catch(error => {
            if (!abort.signal.aborted) Object.assign(file, { phase: 'failed', error });
        });
    }

    insert({ file, scene }) {
        this.stage.fill(file.place, scene);
        Object.assign(file, { phase: 'live', scene, record: levelOf(file.stem) === 'near' ? this.stage.recordOf(scene) : null });
    }

    hide(stem) {
        const file = this.files.get(stem);
        file.abort.abort();
        this.stage.empty(file.place);
        this.files.delete(stem);
    }

    phase(stem) {
        return this.files.get(stem).phase;
    }

    /** Needs   phase(stem) == 'live'. Fails   Error: no record in the file. */
    record(stem) {
        const { record } = this.files.get(stem);
        if (!record) throw new Error(`sector ${stem}: its file carries no RECORD that can be read`);
        return record;
    }

    /** Needs   phase(stem) == 'live'. */
    setImpostor(stem, gate, opacity) {
        this.stage.setImpostor(this.files.get(stem).scene, gate, opacity);
    }

    /** Needs   phase(stem) == 'live'. */
    setDoor(stem, door, look) {
        this.stage.setDoor(this.files.get(stem).scene, door, look);
    }

    /** Needs   phase(stem) == 'live'. */
    touchTime(stem, door) {
        return this.stage.touchTime(this.files.get(stem).scene, door);
    }

    links(stem) {
        return this.stage.recordOf(this.files.get(stem).scene);
    }

    /** Everything asked for: { stem, phase, record }, record null unless a near one is there. */
    list() {
        return [...this.files.values()].map(({ stem, phase, record }) => ({ stem, phase, record }));
    }

    /** { stem, scene } of the files of a level that are there. */
    live(level) {
        return [...this.files.values()].filter(({ stem, phase }) => phase === 'live' && levelOf(stem) === level);
    }

    /** Of what is on its way, as far as it is known. */
    get bytesInFlight() {
        let bytes = 0;
        for (const { stem, phase, bytes: own } of this.files.values()) if (phase === 'loading') bytes += own ?? this.means[levelOf(stem)];
        return bytes;
    }

    /** s until what is on its way has come, at the speed measured; 0 while nothing has come. */
    get waitSeconds() {
        return this.bytesPerSecond ? this.bytesInFlight / this.bytesPerSecond : 0;
    }

    /** { bytes there, of all that are wanted: bytes, files there, files }; `missing`: stems not yet asked for. */
    progress(missing) {
        const all = [...this.files.values()], bytesOf = ({ stem, bytes }) => bytes ?? this.means[levelOf(stem)];
        const there = all.filter(({ phase }) => phase !== 'loading');
        const sum = files => files.reduce((bytes, file) => bytes + bytesOf(file), 0);
        return {
            bytes: sum(there), files: there.length, allFiles: all.length + missing.length,
            allBytes: sum(all) + missing.reduce((bytes, stem) => bytes + this.means[levelOf(stem)], 0) };
    }
}

/** How long the request took, without what the page did meanwhile; undefined: the browser does not tell. */
function secondsOnLine(url) {
    const entry = url ? performance.getEntriesByName(url, 'resource').at(-1) : null;
    return entry ? entry.duration / 1000 : undefined;
}
