const kKindNames = {
    street: 'Street', crossroads: 'Crossroads', square: 'Square', yard: 'Yard', passage: 'Passage', open: 'Open ground',
};
const kMessageSeconds = 4;

/** The words and bars over the 3D view. Needs the elements of index.html. */
export class Hud {
    constructor(page = document) {
        this.at = id => page.getElementById(id);
        this.at('help-button').addEventListener('click', () => this.toggleHelp());
        this.at('help-close').addEventListener('click', () => this.toggleHelp(false));
        this.timer = 0;
        this.city = 'Vicus';
    }

    /** The sector's street name; where it has none, its kind alone. */
    showPlace(record) {
        const kind = kKindNames[record.kind] ?? '', others = (record.names ?? []).filter(name => name !== record.name);
        const street = record.name || kind;
        const detail = record.name ? [kind, ...others].filter(Boolean).join(' · ') : others.join(' · ');
        if (this.at('street').textContent !== street) this.at('street').textContent = street;
        this.at('kind').textContent = detail;
        this.setTitle(street);
    }

    /** `name` may be empty: the city has none. */
    showCity(name) {
        this.city = name || 'Vicus';
        this.setTitle('');
    }

    setTitle(street) {
        document.title = street ? `${street} · ${this.city}` : this.city;
    }

    showRights(text) {
        this.at('rights').textContent = text;
    }

    /** share in 0..1; 1 hides the bar. */
    showProgress(share) {
        this.at('progress').hidden = share >= 1;
        this.at('progress').firstElementChild.style.width = `${Math.round(100 * share)}%`;
    }

    /** A file that failed stays one while it is asked for again. */
    showFailures(count) {
        if (count) this.showTrouble(`${count === 1 ? 'One place nearby' : `${count} places nearby`} cannot be loaded: trying again.`);
        else this.hideTrouble();
    }

    /** A word that goes by itself. */
    say(text) {
        this.showMessage(text, false);
        this.timer = setTimeout(() => this.hideMessage(), 1000 * kMessageSeconds);
    }

    /** Something is wrong; stays until hideTrouble() or another message. */
    showTrouble(text) {
        this.showMessage(text, true);
    }

    hideTrouble() {
        if (this.at('message').classList.contains('trouble')) this.hideMessage();
    }

    showMessage(text, isTrouble) {
        clearTimeout(this.timer);
        const message = this.at('message');
        message.textContent = text;
        message.classList.toggle('trouble', isTrouble);
        message.hidden = false;
    }

    hideMessage() {
        this.at('message').hidden = true;
    }

    toggleHelp(shown = this.at('help').hidden) {
        this.at('help').hidden = !shown;
        this.at('help-button').setAttribute('aria-expanded', String(shown));
        this.at(shown ? 'help-close' : 'window').focus();
    }
}
