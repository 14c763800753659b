import { urgencyOf } from '../core/loadOrder.js';
import { levelOf } from '../core/sectorRecord.js';
import { SectorTexts } from './SectorTexts.js';

/** Bytes a file has until one of its level has come: medians of two cities, as sent. */
const kTypicalBytes = { near: 13000, far: 3500, tall: 2500 };
/** s from one file put into the world to the next; a longer frame takes as many more, or a slow machine never catches up. */
const kInsertSeconds = 1 / 30, kMostInserted = 4;
/** Files read at a time: while images of one are on their way another goes on. */
const kMostRead = 3;
/** The share of a mean that a new value has. */
const kNew = 0.2;

/**
 * Shows and hides sectors' files for the page: fetches them, so that a request can be given up and its bytes counted, reads
 * a few at a time, and puts at most one into the world per frame, thirty a second where frames are slow. The Script's counterpart is x3d/InlineSectors.
 *
 * Needs   `stage` (XIteAdapter): place(origin), makeScene(text, parts, signal), fill(place, scene), empty(place), recordOf(scene),
 * setImpostor(scene, gateId, opacity), setPanorama(scene, opacity), setDoor(scene, doorId, look), touchTime(scene, doorId).
 */
export class FetchedSectors {
    /** `parcels`: of SectorTexts. `compareNeed(a, b)`, of stems: SectorPlanner's, set by whoever has one. */
    constructor(stage, base, { parcels = null, request = (url, options) => fetch(url, options), clock = () => performance.now() / 1000 } = {}) {
        const told = (bytes, seconds) => this.countSpeed(bytes / Math.max(0.001, seconds));
        const texts = new SectorTexts(base, { parcels, request, clock, told });
        Object.assign(this, { stage, base, texts, clock, files: new Map(), ready: [], made: [], reading: 0 });
        this.means = { ...kTypicalBytes };
        this.loaded = { bytes: 0, files: 0 };
        this.bytesPerSecond = null;
        this.compareNeed = (a, b) => urgencyOf(levelOf(a)) - urgencyOf(levelOf(b));
        this.frameAt = clock();
    }

    show(stem, origin) {
        const file = this.files.get(stem) ?? { stem, place: null, record: null };
        Object.assign(file, { origin, phase: 'loading', hasCome: false, abort: new AbortController(), askedAt: this.clock(), bytes: null, scene: null });
        this.files.set(stem, file);
        this.fetch(file, file.abort).catch(error => fail(file, file.abort, error));
    }

    async fetch(file, abort) {
        const sized = bytes => { file.bytes = bytes; };
        const { text, parts, bytes } = await this.texts.get(file.stem, { signal: abort.signal, sized });
        if (abort.signal.aborted) return;
        this.count(file, bytes);
        this.ready.push({ file, text, parts, abort });
    }

    count(file, bytes) {
        const level = levelOf(file.stem);
        Object.assign(file, { bytes, hasCome: true });
        if (!bytes) return;
        this.loaded.bytes += bytes;
        ++this.loaded.files;
        this.means[level] += kNew * (bytes - this.means[level]);
    }

    countSpeed(speed) {
        this.bytesPerSecond = this.bytesPerSecond === null ? speed : this.bytesPerSecond + kNew * (speed - this.bytesPerSecond);
    }

    /** Once a frame, after all that is asked for in it. */
    send() {
        this.texts.send();
    }

    /** Once a frame: puts what has been made into the world. */
    frame() {
        const now = this.clock(), most = Math.min(kMostInserted, Math.floor((now - this.frameAt) / kInsertSeconds));
        this.frameAt = now;
        this.made = this.made.filter(({ abort }) => !abort.signal.aborted);
        for (const made of this.made.splice(0, Math.max(1, most))) this.insert(made);
        this.readNext();
    }

    /** What is needed most first. */
    readNext() {
        if (this.reading >= kMostRead) return;
        this.ready = this.ready.filter(({ abort }) => !abort.signal.aborted).sort((a, b) => this.compareNeed(a.file.stem, b.file.stem));
        const next = this.ready.shift();
        if (!next) return;
        const { file, text, parts, abort } = next;
        // Only now: a whole ring's places in the frame that asks for it take 100 ms. Not later: X_ITE empties an Inline once it is made.
        file.place ??= this.stage.place(file.origin);
        ++this.reading;
        this.stage.makeScene(text, parts, abort.signal)
            .then(scene => { this.made.push({ file, scene, abort }); }, error => fail(file, abort, error))
            .finally(() => {
                --this.reading;
                this.readNext();
            });
        this.readNext();
    }

    insert({ file, scene }) {
        this.stage.fill(file.place, scene);
        Object.assign(file, { phase: 'live', scene, record: levelOf(file.stem) === 'near' ? this.stage.recordOf(scene) : null });
    }

    hide(stem) {
        const file = this.files.get(stem);
        file.abort.abort();
        if (file.place) this.stage.empty(file.place);
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
    setPanorama(stem, opacity) {
        this.stage.setPanorama(this.files.get(stem).scene, opacity);
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

    /** Files on the line: what has come and waits to be put into the world is none of them. */
    onTheWay() {
        return [...this.files.values()].filter(({ phase, hasCome }) => phase === 'loading' && !hasCome);
    }

    /** Of what is on its way, as far as it is known. */
    get bytesInFlight() {
        return this.onTheWay().reduce((sum, { stem, bytes }) => sum + (bytes ?? this.means[levelOf(stem)]), 0);
    }

    /** s that the line takes: until what is on its way has come, at the speed measured; what it has taken already. */
    get waitSeconds() {
        const oldest = Math.min(...this.onTheWay().map(({ askedAt }) => askedAt)), now = this.clock();
        return Math.max(now - Math.min(oldest, now), this.bytesPerSecond ? this.bytesInFlight / this.bytesPerSecond : 0);
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

function fail(file, abort, error) {
    if (!abort.signal.aborted) Object.assign(file, { phase: 'failed', error });
}
