const kMostListed = 14;
const kLead = {
    street: 'A street', crossroads: 'A crossroads', square: 'A square', yard: 'A yard', passage: 'A passage', open: 'Open ground', interior: 'Inside a house',
};
/** Words for objects' kinds, in groups. What is not here stands under the last. */
const kGroups = {
    'To eat and drink': ['restaurant', 'cafe', 'bar', 'fast_food', 'pub', 'ice_cream', 'biergarten'],
    'To see': ['artwork', 'attraction', 'memorial', 'monument', 'museum', 'statue', 'fountain', 'gallery', 'theatre', 'cinema',
        'place_of_worship', 'viewpoint', 'arts_centre', 'library'],
    'To stay': ['hotel', 'hostel', 'guest_house'],
    'Under way': ['bus_stop', 'subway_entrance', 'station', 'taxi', 'tram_stop', 'bicycle_rental', 'parking', 'stop_position'],
    'Shops and services': [],
};

/** The document beside the 3D view: it follows the place (paper 004 §3, Fig. 2). */
export class PlaceDocument {
    /** `go(sectorId)`: a neighbouring place was chosen; `goTo(viewpoint)`; `base`: where /sectors/ID.json is. */
    constructor({ plan, base, go, goTo, page = document }) {
        Object.assign(this, { plan, base, go, goTo, page, shown: '', details: new Map(), at: id => page.getElementById(id) });
    }

    showRights(text) {
        this.at('document-rights').textContent = text;
    }

    /** Follows the visitor; asks for a record's details once per sector. `names`: id -> a neighbour's name. */
    show(here, viewpoints) {
        if (!here) return;
        if (!this.details.has(here.id)) {
            this.details.set(here.id, null);
            this.fetchDetails(here.id).then(details => this.details.set(here.id, details)).catch(() => {});
        }
        const key = [here.id, this.plan.version, Boolean(this.details.get(here.id)), viewpoints.map(({ id }) => id)].join(' ');
        if (key === this.shown) return;
        this.shown = key;
        this.write(here, viewpoints);
    }

    /** Of who flies where no place is told of yet: over water, roofs, open land. */
    showAbove(city) {
        if (this.shown) return;
        this.at('document-title').textContent = `Above ${city || 'the city'}`;
        this.at('document-lead').textContent = 'Over streets and squares it says here what is below.';
    }

    async fetchDetails(id) {
        const response = await fetch(`${this.base}${id}.json`);
        if (!response.ok) throw new Error(`${response.status}`);
        return response.json();
    }

    write(here, viewpoints) {
        const others = (here.names ?? []).filter(name => name !== here.name), kind = kLead[here.kind] ?? 'A place';
        this.at('document-title').textContent = here.name || kind;
        const houses = this.plan.housesOf(here.id);
        this.at('document-lead').textContent = [here.name ? kind : '', others.length ? `with ${others.join(', ')}` : '', housesText(houses)]
            .filter(Boolean).join(', ').replace(/^./, c => c.toUpperCase());
        const places = this.placesParts(this.details.get(here.id)?.places ?? []);
        const parts = [...places, this.housesPart(houses), this.waysPart(here), this.viewsPart(viewpoints)];
        this.at('document-parts').replaceChildren(...parts.filter(Boolean));
    }

    placesParts(places) {
        const groups = new Map(Object.keys(kGroups).map(title => [title, new Set()]));
        for (const { kind, name } of places) {
            const title = Object.keys(kGroups).find(group => kGroups[group].includes(kind)) ?? Object.keys(kGroups).at(-1);
            groups.get(title).add(`${name}${kind === 'shop' || kind === 'address' ? '' : ` · ${kind.replaceAll('_', ' ')}`}`);
        }
        const told = [...groups].filter(([, names]) => names.size);
        return told.map(([title, names]) => this.part(title, [...names].map(name => this.text(name))));
    }

    housesPart(houses) {
        const told = houses.map(house => ({ house, text: houseText(house) })).filter(({ text }) => text);
        return told.length ? this.part('Houses', told.map(({ house, text }) => this.houseLine(house, text))) : null;
    }

    houseLine({ sourceId }, text) {
        if (!/^(node|way|relation)\/\d+$/.test(sourceId ?? '')) return this.text(text);
        const link = this.element('a', text);
        const href = `https://www.openstreetmap.org/${sourceId}`, title = 'This house on the map it came from';
        Object.assign(link, { href, title, rel: 'noopener', target: '_blank' });
        return link;
    }

    waysPart(here) {
        const ids = [...new Set(here.gates.map(gate => gate.to).filter(Boolean))];
        const ways = ids.map(id => ({ id, sector: this.plan.sectors.get(id) })).filter(({ sector }) => sector);
        const line = ({ id, sector }) => this.button(sector.name || kLead[sector.kind] || 'A place', () => this.go(id));
        return ways.length ? this.part('From here to', ways.map(line)) : null;
    }

    viewsPart(viewpoints) {
        const nearest = new Map(viewpoints.map(view => [view.name, view]).reverse());   // one of each name
        const views = [...nearest.values()].reverse();
        return views.length ? this.part('Viewpoints', views.map(view => this.button(view.name, () => this.goTo(view)))) : null;
    }

    part(title, items) {
        const section = this.element('section'), list = this.element('ul');
        for (const item of items.slice(0, kMostListed)) list.append(this.element('li', '', item));
        if (items.length > kMostListed) list.append(this.element('li', `and ${items.length - kMostListed} more`));
        section.append(this.element('h3', title), list);
        return section;
    }

    button(text, action) {
        const button = this.element('button', text);
        button.type = 'button';
        button.addEventListener('click', action);
        return button;
    }

    text(text) {
        return this.page.createTextNode(text);
    }

    element(type, text = '', child = null) {
        const element = this.page.createElement(type);
        if (text) element.textContent = text;
        if (child) element.append(child);
        return element;
    }
}

function housesText(houses) {
    if (houses.length === 0) return '';
    const heights = houses.map(({ height }) => height).sort((a, b) => a - b);
    return `${houses.length === 1 ? 'one house' : `${houses.length} houses`} about ${Math.round(heights[heights.length >> 1])} m high`;
}

/** What is worth telling of a house; '' for the others. */
function houseText({ name, tags }) {
    const number = tags['addr:housenumber'] ? `No. ${tags['addr:housenumber']}` : '';
    const kind = ['amenity', 'tourism', 'historic', 'shop', 'office'].map(key => tags[key]).find(value => value && value !== 'yes') ?? '';
    const built = [tags.architect ? `by ${tags.architect}` : '', tags.start_date ? `built ${tags.start_date}` : ''].filter(Boolean).join(', ');
    if (!name && !kind && !built) return '';
    return [name, number, kind.replaceAll('_', ' '), built].filter(Boolean).join(' · ');
}
