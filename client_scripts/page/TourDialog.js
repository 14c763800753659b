import { degreesFromPlan } from '../core/planFrame.js';
import { PlaceSearch } from './PlaceSearch.js';

/** Asks where to: a place by name, stops on the way, ready-made tours. Needs the elements of index.html. */
export class TourDialog {
    /**
     * `degrees`: of the plan's origin; `pose()`: where the visitor is; `play(tour)`, `jump(place)`, `above(place)`: what was decided;
     * `say(text)`: what went wrong.
     */
    constructor({ degrees, pose, play, jump, above, close, page = document, request = url => fetch(url) }) {
        Object.assign(this, { degrees, pose, play, jump, above, close, page, request, stops: [], isListed: false });
        this.at = id => page.getElementById(id);
        const search = (id, options = {}) => new PlaceSearch(this.at(id), this.at(`${id}-list`), { request, ...options });
        this.to = search('find-to');
        this.from = search('find-from');
        this.via = search('find-via', { take: place => this.addStop(place) });
        this.at('find-form').addEventListener('submit', event => {
            event.preventDefault();
            this.walk();
        });
        this.at('find-jump').addEventListener('click', () => this.goThere(this.jump));
        this.at('find-above').addEventListener('click', () => this.goThere(this.above));
    }

    /** Lists the ready-made tours, once. */
    async open() {
        if (this.isListed) return;
        this.isListed = true;
        const response = await this.request('/tours').catch(() => null), tours = response?.ok ? (await response.json()).tours : [];
        this.at('find-tours').replaceChildren(...tours.map(tour => this.tourLine(tour)));
        this.at('find-ready').hidden = tours.length === 0;
    }

    tourLine({ id, name, length, stops }) {
        const item = this.page.createElement('li'), button = this.page.createElement('button');
        button.type = 'button';
        button.textContent = `${name} · ${stops.length - 1} stops · ${(length / 1000).toFixed(1)} km`;
        button.title = stops.map(stop => stop.name).join(' – ');
        button.addEventListener('click', () => this.start(new URLSearchParams({ tour: id })));
        item.append(button);
        return item;
    }

    addStop(place) {
        this.stops.push(place);
        this.via.clear();
        this.showStops();
    }

    showStops() {
        this.at('find-stops').replaceChildren(...this.stops.map((stop, i) => {
            const item = this.page.createElement('li'), button = this.page.createElement('button');
            button.type = 'button';
            button.textContent = `${stop.name} ×`;
            button.setAttribute('aria-label', `Leave out ${stop.name}`);
            button.addEventListener('click', () => {
                this.stops.splice(i, 1);
                this.showStops();
            });
            item.append(button);
            return item;
        }));
    }

    /** LAT,LON of where the visitor is. */
    here() {
        const { east, north } = this.pose(), [lon, lat] = degreesFromPlan([east, north], this.degrees);
        return `${lat.toFixed(7)},${lon.toFixed(7)}`;
    }

    walk() {
        const isRound = this.at('find-round').checked, to = this.to.text;
        if (!to && !(isRound && this.stops.length)) return this.tell('Say where to: a street, a house, a sight.');
        const query = new URLSearchParams({ from: this.from.text || this.here() });
        for (const stop of this.stops) query.append('via', `${stop.lat},${stop.lon}`);
        if (to) query.set('to', to);
        if (isRound) query.set('round', '1');
        return this.start(query);
    }

    /** Fetches the tour and plays it. */
    async start(query) {
        this.tell('');
        const response = await this.request(`/tours?${query}`).catch(() => null);
        const answer = await response?.json().catch(() => null);
        if (!response?.ok || !answer) return this.tell(answer?.detail ?? 'The way could not be asked for.');
        this.rename(answer, query);
        this.close();
        return this.play(answer, query);
    }

    /** Places were asked for by degrees: names are what was chosen. */
    rename(tour, query) {
        if (query.has('tour')) return;
        const names = [this.from.text ? this.from.name : 'where you are', ...this.stops.map(stop => stop.name)];
        if (this.to.text) names.push(this.to.name);
        if (query.has('round')) names.push(names[0]);
        names.forEach((name, i) => {
            const given = tour.stops[i]?.name;
            if (!given || given === name) return;
            for (const step of tour.steps) step.text = step.text.replace(given, name);
            tour.stops[i].name = name;
        });
        tour.name = `${names[0]} – ${names.at(-1)}`.replace(/^./, c => c.toUpperCase());
    }

    /** `go`: jump or above, with the place that was chosen, else the best of its name. */
    async goThere(go) {
        if (!this.to.chosen) {
            await this.to.ask();
            this.to.choose(0);
        }
        if (!this.to.chosen) return this.tell('No place of that name was found.');
        this.close();
        return go(this.to.chosen);
    }

    tell(text) {
        this.at('find-told').textContent = text;
        this.at('find-told').hidden = !text;
    }
}
