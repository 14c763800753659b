import { glidePose, glideSeconds } from '../core/glide.js';
import { landingSpot } from '../core/landingSpot.js';

/** m: how far up one goes who leaves the ground, and back, so that he sees where he was; and how he looks then. */
const kRise = 95, kBack = 70, kLookDown = -0.62;
/** m over the ground at which the street gives way to tiles; s after which it does though tiles are missing. */
const kSwap = 26, kLongestWait = 6;
/** m and rad: from where a place is looked at that was searched for. */
const kAway = 150, kAbove = 130;
/** Back from the middle and up, of half the tree's side. */
const kOverview = [0.75, 0.6];
const kEye = 1.7;
/** m around in which ground to land on is looked for. */
const kReaches = [80, 400, 1200];
/** m: who glides farther rises on the way by this share of it. */
const kFar = 500, kArch = 0.25;
/** m: ground that was clicked so near is landed on; what is farther is flown to first, so near, and looked at so. */
const kLandWithin = 500, kNearest = 60, kNearer = 0.45, kLook = -0.5;
const fetchParts = () => import('./flightParts.js');
/** Pixels of error on screen, by the settings. */
export const kDetails = { coarse: 4, medium: 2, fine: 1 };

/**
 * Flying: leaving the ground, the tiles above, landing. While somebody flies the sectors rest, invisible.
 *
 * phase: 'walking'; 'rising', 'landing': on the way, the street still or already there; 'flying'.
 */
export class Flight {
    /** `form`: 'auto', 'prisms' or 'blockMap'. */
    constructor({ view, visit, walker, plan, hud, frameRate, detail = 'medium', form = 'auto' }) {
        Object.assign(this, { view, visit, walker, plan, hud, frameRate, detail, form, probed: null, phase: 'walking', glide: null, flyover: null, spot: null });
        this.swapped = false;   // tiles are drawn, and not the street
    }

    get isUp() {
        return this.phase !== 'walking';
    }

    setDetail(detail) {
        this.detail = detail;
        if (this.flyover) this.flyover.pixels = kDetails[detail];
    }

    async setForm(form) {
        this.form = form;
        if (!this.flyover) return;
        await this.probe().catch(() => {});
        this.flyover.setForm(this.formNow);
    }

    /** Prisms unless BlockMaps were chosen, or are quicker on this machine. */
    get formNow() {
        const isQuicker = this.probed !== null && this.probed.blockMap < this.probed.prisms;
        return this.form === 'auto' ? (isQuicker ? 'blockMap' : 'prisms') : this.form;
    }

    /** Draws the coarsest tile that is sent in both forms once in each, unless one was chosen; what was fetched for it is kept. */
    async probe() {
        if (this.form !== 'auto' || this.probed) return;
        const tile = [...this.flyover.tree.tiles.values()].find(({ prismError, blockMapError }) => prismError !== null && blockMapError !== null);
        if (!tile) return;
        const { fetchTileShaders, probeForms } = await fetchParts();
        const forms = ['prisms', 'blockMap'], [shaders, ...meshes] = await Promise.all([fetchTileShaders('/client/x3d/'),
            ...forms.map(form => this.load(tile, undefined, form))]);
        forms.forEach((form, i) => this.fetched.set(`${tile.key} ${form}`, meshes[i]));
        this.probed = probeForms({ prisms: meshes[0], blockMap: meshes[1] }, shaders,
            this.view.size().map(pixels => Math.max(1, Math.round(pixels * this.frameRate.scale))));
    }

    /** What flying needs, once: the tree, layouts, the shader. Fails   Error: the city has no tiles. */
    async prepare() {
        this.preparing ??= this.open().catch(error => {
            this.preparing = null;
            throw error;
        });
        return this.preparing;
    }

    async open() {
        const get = async url => {
            const response = await fetch(url);
            if (!response.ok) throw new Error('This city was built without tiles: it cannot be flown over. Build it again with `vicus build`.');
            return response;
        };
        this.parts = await fetchParts();
        const { Flyover, Flyer, TileWorkshop, fetchLayouts, tileLoader } = this.parts;
        const [tree, world, layouts] = await Promise.all([
            get('/blockmaps/tree.json').then(response => response.json()), get('/flyover.x3d').then(response => response.text()),
            fetchLayouts('/client/layout/')]);
        const stage = await this.view.makeTileStage(world, layouts.ground), workshop = new TileWorkshop(layouts);
        this.load = tileLoader('/blockmaps/', tile => workshop.prepare(tile));
        this.fetched = new Map();   // by the probe
        this.flyover = new Flyover({ tree, stage, load: (tile, signal, form) => this.take(tile, form) ?? this.load(tile, signal, form),
            pixels: kDetails[this.detail], complain: text => console.info(text) });
        this.flyer = new Flyer(this.view, this.flyover.heights);
        await this.probe().catch(error => console.info(`no probe: ${error.message}`));
        this.flyover.setForm(this.formNow);
    }

    /** A tile that was fetched already, once. */
    take({ key }, form) {
        const name = `${key} ${form}`, mesh = this.fetched.get(name);
        this.fetched.delete(name);
        return mesh && Promise.resolve(mesh);
    }

    /** Leaves the ground; `goal`: a pose to fly to instead of straight up. */
    async rise(goal = null) {
        if (this.isUp) return goal && this.flyTo(goal);
        try {
            await this.prepare();
        } catch (error) {
            this.hud.showTrouble(error.message);
            return null;
        }
        const pose = this.view.pose();
        const to = goal ?? { east: pose.east - kBack * Math.sin(pose.heading), north: pose.north - kBack * Math.cos(pose.heading),
            up: pose.up + kRise, heading: pose.heading, pitch: kLookDown };
        Object.assign(this, { phase: 'rising', ground: pose.up - kEye, startedAt: performance.now() / 1000 });
        this.startGlide(pose, to);
        this.hud.setFlying(true);
        this.hud.say('You fly. V brings you down again.');
        return null;
    }

    /** In the air at once: a shared link, an overview. */
    async startAt(pose) {
        await this.prepare();
        Object.assign(this, { phase: 'flying', ground: 0 });
        this.view.setPose(pose);
        this.swap(true);
        this.hud.setFlying(true);
    }

    startGlide(from, to) {
        const far = Math.hypot(to.east - from.east, to.north - from.north), arch = far > kFar ? far * kArch : 0;
        this.glide = { from, to, arch, seconds: glideSeconds(from, to), at: 0 };
    }

    flyTo(pose) {
        if (this.phase !== 'flying') return;
        this.startGlide(this.view.pose(), { ...this.view.pose(), ...pose });
    }

    /** Looks at a plan place from above, from where he comes. */
    lookAt([east, north]) {
        const from = this.view.pose(), [x, y] = [east - from.east, north - from.north], away = Math.hypot(x, y);
        const heading = away > 1 ? Math.atan2(x, y) : from.heading;
        const ground = this.flyover?.heights.ground([east, north]) ?? 0;
        return this.rise({ east: east - kAway * Math.sin(heading), north: north - kAway * Math.cos(heading), up: ground + kAbove,
            heading, pitch: -Math.atan2(kAbove, kAway) });
    }

    /**
     * A click: to the ground that is near, else nearer to what was clicked. `spot`: in CSS pixels of `surface`. False: it shows the sky.
     */
    tap([x, y], { clientWidth: width, clientHeight: height }) {
        if (this.phase !== 'flying') return false;
        const found = this.parts.placeBelow(this.eye(), [2 * x / width - 1, 1 - 2 * y / height], this.flyover.heights);
        if (!found) return false;
        if (!found.isRoof && found.away < kLandWithin) this.land(found.point);
        else this.approach(found);
        return true;
    }

    approach({ point: [east, north], up, away }) {
        const from = this.view.pose(), course = Math.atan2(east - from.east, north - from.north), left = Math.max(kNearest, kNearer * away);
        const back = left * Math.cos(kLook);
        this.flyTo({ east: east - back * Math.sin(course), north: north - back * Math.cos(course), up: up - left * Math.sin(kLook), heading: course, pitch: kLook });
    }

    /** All of the city. */
    async overview() {
        await this.prepare().catch(() => {});
        if (!this.flyover) return this.rise();
        const half = this.flyover.tree.rootSide / 2, [s, c] = [Math.sin(this.view.pose().heading), Math.cos(this.view.pose().heading)];
        return this.rise({ east: -kOverview[0] * half * s, north: -kOverview[0] * half * c, up: kOverview[1] * half,
            heading: this.view.pose().heading, pitch: -Math.atan2(kOverview[1], kOverview[0]) });
    }

    toggle() {
        return this.isUp ? this.land() : this.rise();
    }

    /** Down to the ground below, or at `place`, or to the nearest there is, at the same heading. */
    async land(place = null) {
        if (this.phase !== 'flying') return;
        const pose = this.view.pose(), { heading } = pose, [east, north] = place ?? [pose.east, pose.north];
        this.glide = null;
        this.phase = 'landing';
        try {
            const spot = await this.findGround([east, north]);
            await this.visit.learn(spot.id);
            this.visit.isJump = true;
            const ground = this.flyover.heights.ground(spot.point) ?? 0;
            this.spot = { id: spot.id, pose: { east: spot.point[0], north: spot.point[1], up: ground + kEye, heading, pitch: 0 } };
            this.startGlide(this.view.pose(), this.spot.pose);
        } catch (error) {
            this.phase = 'flying';
            this.hud.showTrouble(error.message);
        }
    }

    async findGround(point) {
        for (const reach of kReaches) {
            await this.plan.whole(point[0], point[1], reach);
            const spot = landingSpot([...this.plan.sectors.values()], point);
            if (spot) return spot;
        }
        throw new Error('There is no street near here to land in.');
    }

    /** Back in the street at once, wherever he is: something else takes him elsewhere. */
    end() {
        if (!this.isUp) return;
        Object.assign(this, { phase: 'walking', glide: null, spot: null });
        this.swap(false);
        this.hud.setFlying(false);
    }

    swap(isAbove) {
        this.swapped = isAbove;
        this.view.showSectors(!isAbove);
        if (!isAbove) this.flyover.hide();
    }

    /** One frame; true when he moved. */
    step(wish, seconds) {
        const before = this.view.pose(), isSteering = wish.forward || wish.right || wish.turn || wish.rise || wish.zoom;
        if (isSteering && this.phase === 'flying') this.glide = null;
        let hasMoved = false;
        if (this.glide) hasMoved = this.follow(wish, seconds);
        else if (this.phase === 'flying') hasMoved = this.flyer.step(wish, seconds);
        if (this.phase === 'rising') this.checkRise(before);
        this.flyover.isShown = this.swapped;
        this.flyover.step(this.eye(), performance.now() / 1000);
        if (this.phase === 'landing') this.checkLanding(seconds);
        return hasMoved;
    }

    follow({ look }, seconds) {
        const { glide } = this;
        glide.at += Math.min(seconds, 0.1);
        const share = glide.at / glide.seconds;
        if (this.phase === 'flying' && (look[0] || look[1])) this.glide = null;
        this.view.setPose(glidePose(glide.from, glide.to, share, glide.arch));
        if (share >= 1) this.glide = null;
        return true;
    }

    /** The street is seen until he is above the first roofs and tiles are there. */
    checkRise({ up }) {
        const waited = performance.now() / 1000 - this.startedAt;
        const isReady = this.flyover.isReady || waited > kLongestWait;
        if (!this.swapped && isReady && (up - this.ground > kSwap || !this.glide)) this.swap(true);
        if (this.swapped && !this.glide) this.phase = 'flying';
    }

    /** Sectors load around the place below while he comes down; they are shown when his own is there. */
    checkLanding() {
        if (!this.spot) return;
        this.visit.step(this.spot.pose, performance.now() / 1000);
        if (this.glide || this.visit.here?.id !== this.spot.id) return;
        this.walker.setGround(this.visit.records);
        const { pose } = this.spot, ground = this.walker.heights.at([pose.east * 1000, pose.north * 1000]);
        this.view.setPose({ ...pose, up: ground === null ? pose.up : ground / 1000 + kEye });
        this.end();
        this.hud.say('You are on the ground.');
    }

    /** For TileTree.choose. Pixels are counted as they are drawn while he moves: who stands still gets sharper ones, not other tiles. */
    eye() {
        const { east, north, up, heading, pitch } = this.view.pose(), [width, height] = this.view.size(), t = Math.tan(this.view.fieldOfView() / 2);
        const half = width >= height ? [t * width / height, t] : [t, t * height / width];
        return { eye: [east, north, up], heading, pitch, half, pixelsPerRadian: height / 2 / half[1] * this.frameRate.scale };
    }

    /** { share, bytes }: how much of what the view needs is there. */
    get progress() {
        const missing = this.flyover.chosen.ask.filter(({ rank }) => rank === 'A').length, drawn = this.flyover.chosen.draw.length;
        return missing + drawn === 0 ? 0 : drawn / (missing + drawn);
    }
}
