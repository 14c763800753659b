import { kLines } from './Visit.js';

const kKey = 'vicus';
const kTests = ['polygon', 'box', 'gate'], kDetailNames = ['coarse', 'medium', 'fine'];
const kForms = ['auto', 'prisms', 'blockMap'];

/** What the visitor chose, kept in this browser: { level: i or null, line, test, detail, form }. The address overrules it. */
export function storedSettings(place, storage = localStorage, connection = navigator.connection) {
    const kept = readKept(storage), line = kept.line in kLines ? kept.line : connection?.saveData ? 'slow' : 'auto';
    const settings = { level: levelOr(kept.level, null), line, test: kTests.includes(kept.test) ? kept.test : 'polygon', startLevel: 1,
        detail: kDetailNames.includes(kept.detail) ? kept.detail : 'medium', form: kForms.includes(kept.form) ? kept.form : 'auto' };
    if (place.level !== null) Object.assign(settings, place.isMeasured ? { level: null, startLevel: place.level } : { level: place.level });
    if (kTests.includes(place.test)) settings.test = place.test;
    return settings;
}

function readKept(storage) {
    try {
        return JSON.parse(storage.getItem(kKey)) ?? {};
    } catch {
        return {};   // forbidden, or not ours
    }
}

const levelOr = (level, other) => (Number.isInteger(level) && level >= 0 && level <= 3 ? level : other);

/** The dialog: shows settings and figures, keeps what is chosen, tells the visit. */
export class SettingsDialog {
    constructor(settings, changed, page = document) {
        Object.assign(this, { settings, at: id => page.getElementById(id), page });
        this.at('set-level').value = settings.level ?? '';
        this.at('set-line').value = settings.line;
        this.at('set-test').value = settings.test;
        this.at('set-detail').value = settings.detail;
        this.at('set-form').value = settings.form;
        for (const id of ['set-level', 'set-line', 'set-test', 'set-detail', 'set-form']) this.at(id).addEventListener('change', () => this.change(changed));
    }

    change(changed) {
        const level = this.at('set-level').value;
        const [line, test, detail, form] = ['set-line', 'set-test', 'set-detail', 'set-form'].map(id => this.at(id).value);
        Object.assign(this.settings, { level: level === '' ? null : Number(level), line, test, detail, form });
        try {
            localStorage.setItem(kKey, JSON.stringify({ level: this.settings.level, line, test, detail, form }));
        } catch {
            // a browser that keeps nothing: it holds for this visit
        }
        changed(this.settings);
    }

    /** [[what, value], ...] while the dialog is open. */
    showFigures(figures) {
        const rows = figures.map(([what, value]) => {
            const row = this.page.createElement('div'), term = this.page.createElement('dt'), text = this.page.createElement('dd');
            [term.textContent, text.textContent] = [what, value];
            row.append(term, text);
            return row;
        });
        this.at('figures').replaceChildren(...rows);
    }
}
