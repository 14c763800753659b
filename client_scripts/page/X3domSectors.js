import { paintDoor } from '../core/Doors.js';
import { levelOf } from '../core/sectorRecord.js';
import { groundOfElements, recordOfElements } from './sectorElements.js';

/**
 * Shows and hides sectors' files in X3DOM: Transform (the sector's origin) > Inline, as elements of the page's document,
 * which X3DOM watches. It fetches an Inline however its `load` stands, so elements come and go.
 *
 * A file's content lies in its Inline's element (nameSpaceName), so that records and doors are read there.
 * Differs from x3d/InlineSectors: pictures in gates are not shown (X3DOM has no UnlitMaterial).
 */
export class X3domSectors {
    /** `world`: the element that holds the sectors; `base`: URL of sectors. */
    constructor(world, base) {
        Object.assign(this, { world, base, files: new Map() });
    }

    show(stem, origin) {
        if (this.files.has(stem)) this.hide(stem);
        const place = element('transform', { translation: `${origin[0]} 0 ${-origin[1]}` });
        const inline = element('inline', { nameSpaceName: stem.replace('.', '-'), mapDEFToID: 'true', url: `"${this.base}${stem}.x3d"` });
        const file = { stem, place, inline, phase: 'loading', record: null, touched: new Map() };
        // X3DOM hears of listeners only on elements that it has taken up already; of these at any time.
        inline.onload = () => this.arrive(file);
        inline.onerror = () => { file.phase = 'failed'; };
        this.files.set(stem, file);
        place.append(inline);
        this.world.append(place);
    }

    arrive(file) {
        if (file.phase !== 'loading') return;
        file.phase = 'live';
        file.record = recordOfElements(file.inline);
        multiplyGreyTextures(file.inline);
        if (levelOf(file.stem) === 'near') file.surface = groundOfElements(file.inline, file.record?.origin);
        for (const touch of file.inline.querySelectorAll('[DEF^="DOOR-TOUCH-"]'))
            touch.parentNode.onclick = () => file.touched.set(touch.getAttribute('DEF'), performance.now() / 1000);
    }

    hide(stem) {
        this.files.get(stem).place.remove();
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

    links(stem) {
        return this.files.get(stem).record;
    }

    /** Needs   phase(stem) == 'live'. */
    setDoor(stem, door, look) {
        const { inline } = this.files.get(stem);
        paintDoor(door, look, { find: name => writer(inline.querySelector(`[DEF="${name}"]`)), rotation: list, color: list });
    }

    touchTime(stem, door) {
        return this.files.get(stem).touched.get(`DOOR-TOUCH-${door}`) ?? 0;
    }

    /** Records of the near files that are there, each with its `surface`. */
    get records() {
        const near = [...this.files.values()].filter(({ stem, phase, record }) => phase === 'live' && record && levelOf(stem) === 'near');
        return near.map(({ record, surface }) => ({ ...record, surface }));
    }

    live() {
        return [...this.files.values()].filter(({ phase }) => phase === 'live').map(({ stem }) => stem).sort();
    }
}

function element(type, attributes) {
    const made = document.createElement(type);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    return made;
}

const list = (...numbers) => numbers.join(' ');

/** Fields that are set become attributes: X3DOM takes them from there. */
function writer(node) {
    return new Proxy(node, { set: (target, field, value) => {
        target.setAttribute(field, String(value));
        return true;
    } });
}

/** Those over colours by face are grey: they multiply. X3DOM would show them alone, as it cannot tell how many channels an image has. */
function multiplyGreyTextures(inline) {
    for (const shape of inline.querySelectorAll('Shape'))
        if (shape.querySelector('Color')) shape.querySelector('ImageTexture, PixelTexture')?.setAttribute('origChannelCount', '1');
}
