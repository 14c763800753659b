import { TourWalk } from '../core/TourWalk.js';

const kSpeed = 1.4;       // m/s, as the server counts the time
const kEye = 1.7, kRise = 9;
/** s: a stall longer than this (a sector being parsed) walks no farther. */
const kLongestStep = 0.2;

/**
 * Walks a tour: play, pause, speed, where one is; the steps as a list. Who steers himself pauses it.
 * Needs   the elements of index.html; `view` as XIteAdapter; `heights()`: GroundHeights of what is there, or null.
 */
export class TourPlayer {
    constructor({ view, heights, hud, page = document, moved = () => {}, ended = () => {} }) {
        Object.assign(this, { view, heights, hud, page, moved, ended, tour: null, walk: null, walked: 0, isPlaying: false, speed: 1, line: -1 });
        this.at = id => page.getElementById(id);
        this.at('tour-play').addEventListener('click', () => this.toggle());
        this.at('tour-close').addEventListener('click', () => this.stop());
        this.at('tour-speed').addEventListener('change', event => { this.speed = Number(event.target.value); });
        this.at('tour-steps-button').addEventListener('click', () => this.toggleSteps());
        this.at('tour-progress').addEventListener('input', event => {
            this.walked = Number(event.target.value);
            this.show();
            this.put(1);
            this.moved();
        });
    }

    /** A tour as /tours gives it; begins at once. */
    start(tour) {
        Object.assign(this, { tour, walk: new TourWalk(tour), walked: 0, line: -1 });
        const progress = this.at('tour-progress');
        progress.max = String(Math.max(1, Math.round(tour.length)));
        this.at('tour-name').textContent = tour.name;
        this.at('tour-steps').replaceChildren(...tour.steps.map(step => this.stepLine(step)));
        this.at('player').hidden = false;
        this.put(1);
        this.moved();
        this.setPlaying(true);
        this.show();
    }

    stop() {
        this.setPlaying(false);
        Object.assign(this, { tour: null, walk: null });
        this.at('player').hidden = true;
        this.ended();
        this.at('window').focus();
    }

    toggle() {
        if (!this.walk) return;
        if (!this.isPlaying && this.walked >= this.walk.length) this.walked = 0;
        this.setPlaying(!this.isPlaying);
    }

    setPlaying(isPlaying) {
        this.isPlaying = isPlaying;
        const button = this.at('tour-play');
        button.setAttribute('aria-label', isPlaying ? 'Pause' : 'Play');
        button.classList.toggle('playing', isPlaying);
    }

    toggleSteps(shown = this.at('tour-steps').hidden) {
        this.at('tour-steps').hidden = !shown;
        this.at('tour-steps-button').setAttribute('aria-expanded', String(shown));
    }

    /** One frame; true: it has moved the visitor. `wish`: of the controls. */
    step(wish, seconds) {
        if (!this.isPlaying) return false;
        if (wish.forward || wish.right || wish.turn) {
            this.setPlaying(false);
            return false;
        }
        this.walked = Math.min(this.walk.length, this.walked + kSpeed * this.speed * Math.min(seconds, kLongestStep));
        this.put(Math.min(1, kRise * seconds));
        this.show();
        if (this.walked >= this.walk.length) {
            this.setPlaying(false);
            this.hud.say(this.tour.steps.at(-1).text);
        }
        return true;
    }

    /** The visitor stands where the walk is; the eye follows kerbs and steps by `share` of what is missing. */
    put(share) {
        const { east, north, ground, heading } = this.walk.at(this.walked), pose = this.view.pose();
        const known = this.heights()?.at([east * 1000, north * 1000]) ?? null, up = (known === null ? ground : known / 1000) + kEye;
        this.view.setPose({ ...pose, east, north, heading, pitch: 0, up: pose.up + (up - pose.up) * share });
    }

    show() {
        const { steps, length } = this.tour, line = steps.findLastIndex(({ walked }) => walked <= this.walked + 0.01);
        this.at('tour-progress').value = String(Math.round(this.walked));
        this.at('tour-progress').setAttribute('aria-valuetext', `${Math.round(this.walked)} of ${Math.round(length)} metres`);
        const minutes = Math.max(0, (length - this.walked) / kSpeed / 60);
        this.at('tour-left').textContent = `${Math.round(length - this.walked)} m · ${minutes < 1 ? 'less than a minute' : `${Math.round(minutes)} min`}`;
        if (line === this.line) return;
        this.line = line;
        this.at('tour-now').textContent = steps[Math.max(0, line)].text;
        [...this.at('tour-steps').children].forEach((item, i) => {
            if (i === line) item.setAttribute('aria-current', 'step');
            else item.removeAttribute('aria-current');
        });
    }

    stepLine({ text, walked }) {
        const item = this.page.createElement('li'), button = this.page.createElement('button');
        button.type = 'button';
        button.textContent = `${Math.round(walked)} m  ${text}`;
        button.addEventListener('click', () => {
            this.walked = walked;
            this.put(1);
            this.moved();
            this.show();
        });
        item.append(button);
        return item;
    }
}
