const kKindNames = {
    street: 'Street', crossroads: 'Crossroads', square: 'Square', yard: 'Yard', passage: 'Passage', open: 'Open ground', interior: 'Inside a house',
};
const kMessageSeconds = 4;

/** The words and bars over the 3D view. Needs the elements of index.html; dialogs may be missing (x3dom.html). */
export class Hud {
    constructor(page = document) {
        this.page = page;
        this.loading = '';
        this.at = id => page.getElementById(id);
        this.at('help-button')?.addEventListener('click', () => this.toggleHelp());
        this.at('help-close')?.addEventListener('click', () => this.toggleHelp(false));
        this.at('settings-close')?.addEventListener('click', () => this.toggleSettings(false));
        this.at('find-close')?.addEventListener('click', () => this.toggleFind(false));
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

    /** Who flies: what lies below him, and how far. `below`: a sector of the CityPlan, or null. */
    showBelow(below, height) {
        const street = below?.name ? `Above ${below.name}` : 'Above the city', rounded = height < 100 ? Math.round(height) : 10 * Math.round(height / 10);
        if (this.at('street').textContent !== street) this.at('street').textContent = street;
        this.at('kind').textContent = `${rounded} m above the ground`;
        this.setTitle(street);
    }

    /** Buttons and help are those of who flies, or walks. */
    setFlying(isFlying) {
        this.page.body.classList.toggle('flying', isFlying);
        this.at('heights').hidden = !isFlying;
        const button = this.at('fly-button');
        button.textContent = isFlying ? 'Land' : 'Fly';
        button.title = isFlying ? 'Land in the street below (V)' : 'Leave the ground and fly (V)';
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

    /** `share` in 0..1; 1 hides the bar, unless what has come is not all shown. With `files` of `allFiles`, `bytes` of `allBytes`: in words, too. */
    showProgress({ share, files = 0, allFiles = 0, bytes = 0, allBytes = 0, isShown = true }) {
        const bar = this.at('progress'), percent = Math.round(100 * Math.min(isShown ? 1 : 0.99, share));
        const isDone = isShown && (share >= 1 || (allFiles > 0 && files === allFiles));
        bar.hidden = isDone;
        bar.firstElementChild.style.width = `${percent}%`;
        bar.setAttribute('aria-valuenow', String(percent));
        this.loading = isDone || !allFiles ? '' : `loading ${percent} % · ${this.bytes(bytes)} of ${this.bytes(allBytes)}`;
    }

    /** What is around: i of L_i, how many files; or what is being loaded. */
    showStatus({ i, isMeasured, files }) {
        const text = this.loading || `L${i}${isMeasured ? '' : ' (chosen)'} · ${files} files around you`;
        if (this.at('status').textContent !== text) this.at('status').textContent = text;
    }

    showText(text) {
        if (this.at('status').textContent !== text) this.at('status').textContent = text;
    }

    bytes(count) {
        if (count < 1e6) return `${Math.round(count / 1e3)} kB`;
        return `${(count / 1e6).toFixed(count < 1e7 ? 1 : 0)} MB`;
    }

    /** What one can do to the door that one stands before; null: there is none. */
    showDoor(near) {
        const button = this.at('door-button'), text = near?.isShut ? 'Open the door' : 'Shut the door';
        if (button.hidden !== !near) button.hidden = !near;
        if (near && button.firstChild.data !== text) button.firstChild.data = text;
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

    isShown(id) {
        return !this.at(id).hidden;
    }

    toggleHelp(shown = this.at('help').hidden) {
        this.toggleDialog('help', shown);
    }

    toggleSettings(shown = this.at('settings').hidden) {
        this.toggleDialog('settings', shown);
    }

    toggleFind(shown = this.at('find').hidden) {
        this.toggleDialog('find', shown, 'find-to');
    }

    /** The focus goes into a dialog when it opens and back to the window when it closes. */
    toggleDialog(id, shown, first = `${id}-close`) {
        if (shown === this.isShown(id)) return;
        if (shown) this.closeDialogs();
        this.toggle(id, shown);
        this.at(shown ? first : 'window').focus();
    }

    closeDialogs() {
        for (const id of ['help', 'settings', 'find']) if (this.isShown(id)) this.toggleDialog(id, false);
    }

    toggleSide(shown = this.at('side').hidden) {
        this.toggle('side', shown);
        this.page.body.classList.toggle('with-side', shown);
    }

    togglePad(shown = this.at('pad').hidden) {
        this.toggle('pad', shown);
    }

    toggle(id, shown) {
        this.at(id).hidden = !shown;
        this.at(`${id}-button`).setAttribute('aria-expanded', String(shown));
    }
}
