const kWaitMilliseconds = 150;   // after the last letter, before it is asked for
const kMost = 8;
const kKinds = {
    street: 'street', square: 'square', house: 'house', sector: 'place', place: 'place', place_of_worship: 'church', room: 'room inside',
};

/**
 * A field that finds places by name: a combobox with a list, after the ARIA pattern. Arrows choose, Enter takes, Escape
 * closes the list. `chosen` is the place taken (as /search gives it), until other letters are typed.
 */
export class PlaceSearch {
    /** `field`: the input; `list`: an empty ul beside it; `take(place)`: one was chosen. */
    constructor(field, list, { take = () => {}, request = url => fetch(url) } = {}) {
        Object.assign(this, { field, list, take, request, chosen: null, places: [], at: -1, timer: 0, asked: 0 });
        for (const [name, value] of Object.entries({
            role: 'combobox', autocomplete: 'off', spellcheck: 'false', 'aria-autocomplete': 'list', 'aria-expanded': 'false',
            'aria-controls': list.id })) field.setAttribute(name, value);
        list.setAttribute('role', 'listbox');
        field.addEventListener('input', () => this.typed());
        field.addEventListener('keydown', event => this.keyDown(event));
        field.addEventListener('blur', () => setTimeout(() => this.close(), kWaitMilliseconds));
    }

    /** What a tour is asked for: the name as it was typed, or the place of the one taken. */
    get text() {
        return this.chosen ? `${this.chosen.lat},${this.chosen.lon}` : this.field.value.trim();
    }

    get name() {
        return this.chosen?.name ?? this.field.value.trim();
    }

    clear() {
        this.field.value = '';
        this.chosen = null;
        this.close();
    }

    typed() {
        this.chosen = null;
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.ask(), kWaitMilliseconds);
    }

    async ask() {
        const typed = this.field.value.trim(), number = ++this.asked;
        if (!typed) return this.close();
        const response = await this.request(`/search?q=${encodeURIComponent(typed.slice(0, 60))}&limit=${kMost}`).catch(() => null);
        const places = response?.ok ? (await response.json()).results : [];
        if (number === this.asked) this.show(places);   // a later question may have been answered first
        return null;
    }

    show(places) {
        this.places = places;
        this.at = -1;
        const option = (place, i) => {
            const line = this.list.ownerDocument.createElement('li'), kind = kKinds[place.kind] ?? place.kind.replaceAll('_', ' ');
            line.id = `${this.list.id}-${i}`;
            line.setAttribute('role', 'option');
            line.setAttribute('aria-selected', 'false');
            line.append(place.name);
            const detail = this.list.ownerDocument.createElement('small');
            detail.textContent = [kind, place.detail].filter(Boolean).join(' · ');
            line.append(' ', detail);
            line.addEventListener('pointerdown', event => {
                event.preventDefault();   // the field keeps the focus
                this.choose(i);
            });
            return line;
        };
        this.list.replaceChildren(...places.map(option));
        this.list.hidden = places.length === 0;
        this.field.setAttribute('aria-expanded', String(places.length > 0));
        this.mark(-1);
    }

    close() {
        if (!this.list.hidden) this.show([]);
    }

    mark(at) {
        this.at = at;
        [...this.list.children].forEach((line, i) => line.setAttribute('aria-selected', String(i === at)));
        if (at >= 0) this.field.setAttribute('aria-activedescendant', `${this.list.id}-${at}`);
        else this.field.removeAttribute('aria-activedescendant');
    }

    choose(at) {
        const place = this.places[at];
        if (!place) return;
        this.chosen = place;
        this.field.value = place.name;
        this.close();
        this.take(place);
    }

    keyDown(event) {
        const count = this.places.length;
        if (event.key === 'Escape' && !this.list.hidden) {
            this.close();
            event.stopPropagation();
        } else if (count && (event.key === 'ArrowDown' || event.key === 'ArrowUp')) {
            const step = event.key === 'ArrowDown' ? 1 : -1;
            this.mark((this.at + step + count + (this.at < 0 && step < 0 ? 1 : 0)) % count);
            event.preventDefault();
        } else if (event.key === 'Enter' && count && !this.chosen) {
            this.choose(Math.max(0, this.at));
            event.preventDefault();
        }
    }
}
