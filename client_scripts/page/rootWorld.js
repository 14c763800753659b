/**
 * The root world for the page: what /city.x3d draws, without its Script. The page loads sectors itself, by the same
 * core: a Script node would need 'unsafe-eval', and could not give up a request or count its bytes.
 *
 * { text, start, origin: [east, north] of the start, base: URL of sectors, parcels: URL of SectorTexts' parcels or null, name,
 * rights, degrees: [lat, lon] or null }.
 * Fails   Error with what the server says, or that it does not answer.
 */
export async function fetchRootWorld(url) {
    const response = await fetch(url).catch(() => { throw new Error('The server does not answer. Is `vicus serve` still running?'); });
    const text = await response.text();
    if (!response.ok) throw new Error(detailOf(text) || response.statusText);
    return rootWorldFrom(new DOMParser().parseFromString(text, 'application/xml'), document.baseURI);
}

export function rootWorldFrom(xml, pageUrl) {
    const field = name => xml.querySelector(`Script field[name="${name}"]`)?.getAttribute('value') ?? '';
    const meta = name => [...xml.querySelectorAll(`head > meta[name="${name}"]`)].map(node => node.getAttribute('content'));
    const start = field('start'), place = field('origins').split(/\s+/).map(Number);
    if (!start || !(place.length >= 3)) throw new Error('The root world has no LOADER that names a start: is it Vicus\'s?');
    const degrees = (meta('origin')[0] ?? '').split(' ').map(Number);
    const world = {
        start, origin: [place[0], -place[2]], base: new URL(field('base') || 'sectors/', pageUrl).href,
        parcels: meta('parcels')[0] ? new URL(meta('parcels')[0], pageUrl).href : null,
        name: meta('subject')[0] ?? '', rights: meta('rights').join(', '),
        degrees: degrees.length === 2 && degrees.every(Number.isFinite) ? degrees : null,
    };
    for (const node of xml.querySelectorAll('Script, ProximitySensor, ROUTE, [DEF="WORLD"] > *')) node.remove();
    return { ...world, text: new XMLSerializer().serializeToString(xml) };
}

function detailOf(text) {
    try {
        return JSON.parse(text).detail ?? '';
    } catch {
        return '';
    }
}
