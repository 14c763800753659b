import { SectorFinder } from '../core/SectorFinder.js';
import { SectorLoader } from '../core/SectorLoader.js';
import { FetchedSectors } from './FetchedSectors.js';

/** How much is asked for at a time, and how far around, by how fast the line is. */
export const kLines = {
    auto: { loadsInFlight: 3, filesAtOnce: 48, limit: 2 },
    slow: { loadsInFlight: 1, filesAtOnce: 16, limit: 1 },
    fast: { loadsInFlight: 6, filesAtOnce: 64, limit: 3 },
};

/** Where the visitor is and what is there: the loader of core/, the files of the page. */
export class Visit {
    /** `world`: of fetchRootWorld; `settings`: { level: null or i, line, test }. */
    constructor(stage, world, settings, complain) {
        const { parcels } = world, { loadsInFlight, filesAtOnce, limit } = lineOf(settings.line, parcels);
        this.files = new FetchedSectors(stage, world.base, { parcels });
        this.loader = new SectorLoader(world.start, this.files, {
            complain, loadsInFlight, filesAtOnce, limit, fixedLevel: settings.level, level: settings.startLevel ?? 1, test: settings.test });
        this.files.compareNeed = (a, b) => this.planner.compareNeed(a, b);
        const { start: id, origin: [east, north] } = world;
        this.planner.addNeighbour({ id, origin: world.origin, box: [east - 1, north - 1, east + 1, north + 1] });
        Object.assign(this, { current: world.start, level: this.planner.i, isJump: false, firstStreetAt: 0, failed: new Set() });
        this.sectors = [];   // { stem, phase, record } of every file asked for
    }

    get planner() {
        return this.loader.planner;
    }

    /** Records of the near sectors that are there. */
    get records() {
        return this.sectors.map(sector => sector.record).filter(Boolean);
    }

    /** The record of the sector the visitor is in, or undefined. */
    get here() {
        return this.records.find(record => record.id === this.current);
    }

    /** Ids of doors that let him through. */
    get openDoors() {
        return this.loader.doors.open;
    }

    /** { door, isShut } that he stands before, or null. */
    doorNear(pose) {
        return this.loader.doors.near([pose.east * 1000, pose.north * 1000], this.planner.sectors.get(this.current), pose.heading);
    }

    /** Opens the door that he stands before, or shuts it. */
    touchDoor(pose, now) {
        const near = this.doorNear(pose);
        if (near) this.loader.doors.touch(near.door, this.current, now);
    }

    /** One frame: what is asked for, given up, put into the world. */
    step(pose, now) {
        this.files.frame();   // first: the planner hears of it in the same frame
        const { waitSeconds } = this.files;
        const plan = this.loader.step(pose && [pose.east, pose.north], now, {
            heading: pose?.heading ?? null, isJump: this.isJump, waitSeconds, memoryShare: memoryShare() });
        Object.assign(this, { current: plan.current, level: plan.level, isJump: false });
        this.files.send();
        this.sectors = this.files.list();
        if (!this.firstStreetAt && this.here) this.firstStreetAt = performance.now();
        const isFailed = ({ stem, phase }) => phase === 'failed' || (phase === 'loading' && this.failed.has(stem));
        this.failed = new Set(this.sectors.filter(isFailed).map(sector => sector.stem));
        return plan;
    }

    /** Files that should be there and were not asked for yet. */
    missing(pose) {
        const point = [pose.east * 1000, pose.north * 1000];
        return [...this.planner.wanted(point).keys()].filter(stem => !this.planner.states.has(stem));
    }

    /** The visitor is put to a place in a sector that need not be known yet. Fails   Error: there is no such sector. */
    async learn(id) {
        if (this.planner.sectors.get(id)?.ground) return this.planner.sectors.get(id);
        const response = await fetch(`${this.files.base}${id}.json`);
        if (!response.ok) throw new Error(`There is no sector ${id}.`);
        this.planner.learn(id, await response.json());
        return this.planner.sectors.get(id);
    }

    /** Applies settings that may change on the way. */
    set({ level, line, test }) {
        const { loadsInFlight, filesAtOnce, limit } = lineOf(line, this.files.texts.parcels);
        if (test !== this.planner.finder.test) this.planner.finder = new SectorFinder(test);
        Object.assign(this.planner.options, { loadsInFlight, filesAtOnce });
        this.planner.choice.set(level, limit);
    }
}

/** A site without a server gives one file by each request. */
function lineOf(name, parcels) {
    return parcels ? kLines[name] : { ...kLines[name], filesAtOnce: 1 };
}

/** Of what the browser allows its scripts; 0 where it does not tell. */
function memoryShare() {
    const { memory } = performance;
    return memory ? memory.usedJSHeapSize / memory.jsHeapSizeLimit : 0;
}
