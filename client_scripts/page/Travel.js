import { pointInside } from '../core/pointInside.js';
import { GoTo, groundUnder } from './GoTo.js';
import { Viewpoints } from './Viewpoints.js';

const kVeilSeconds = 0.16;

/** Takes the visitor elsewhere: on foot to a spot he clicked, or at once to a viewpoint, a neighbouring place, a point of the map. */
export class Travel {
    constructor({ view, visit, hud, veil }) {
        Object.assign(this, { view, visit, hud, veil, goTo: new GoTo(), viewpoints: new Viewpoints(), marker: null, leaving: () => {} });
    }

    /** A wish of the controls, or where none is, the one that leads to the goal. */
    wish(wish, pose, seconds) {
        const isSteering = wish.forward || wish.right || wish.turn;
        if (isSteering) this.goTo.goal = null;
        const onTheWay = this.goTo.wish(pose, seconds);
        if (this.marker) this.marker.hidden = !onTheWay || performance.now() > this.markerUntil;
        return onTheWay ? { ...onTheWay, look: wish.look } : wish;
    }

    /** `spot`: [x, y] in CSS pixels of the window; the way ends where walls do. */
    walkTo([x, y], surface, marker) {
        const { clientWidth: width, clientHeight: height } = surface;
        const goal = groundUnder(this.view.pose(), [2 * x / width - 1, 1 - 2 * y / height], width / height, this.view.fieldOfView());
        if (!goal) return;
        this.goTo.start(goal);
        Object.assign(marker.style, { left: `${x}px`, top: `${y}px` });
        Object.assign(this, { marker, markerUntil: performance.now() + 900 });
        marker.hidden = false;
    }

    learnViewpoints() {
        const { files, planner } = this.visit;
        for (const { stem, scene } of files.live('near'))
            this.viewpoints.add(stem, this.view.viewpointsOf(scene, planner.sectors.get(stem).origin));
    }

    next() {
        this.toViewpoint(this.viewpoints.next(this.view.pose()));
    }

    previous() {
        this.toViewpoint(this.viewpoints.previous());
    }

    toViewpoint(viewpoint) {
        if (!viewpoint) return this.hud.say('There is no such viewpoint yet.');
        this.to({ ...viewpoint, pitch: 0 }, viewpoint.sectorId);
        return this.hud.say(viewpoint.name);
    }

    /** To a neighbouring sector's viewpoint, or its middle. */
    async toSector(id) {
        const known = this.viewpoints.all.find(viewpoint => viewpoint.sectorId === id);
        if (known) return this.toViewpoint(known);
        return this.toPlace(id, null);
    }

    async toPlace(id, point) {
        try {
            const sector = await this.visit.learn(id), [east, north] = point ?? pointInside(sector.ground).map(mm => mm / 1000);
            await this.to({ east, north }, id);
        } catch (error) {
            this.hud.showTrouble(error.message);
        }
    }

    /** At once, behind a short veil: a jump that is seen as one. */
    async to(pose, sectorId = null) {
        this.goTo.goal = null;
        if (sectorId) await this.visit.learn(sectorId);
        this.veil.classList.add('shut');
        await new Promise(resolve => setTimeout(resolve, 1000 * kVeilSeconds));
        this.leaving();   // he may fly
        this.view.setPose({ ...this.view.pose(), pitch: 0, up: this.visit.homePose.up, ...pose });
        this.visit.isJump = true;
        this.veil.classList.remove('shut');
    }
}
