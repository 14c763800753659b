/**
 * The page's address: ?start=SECTOR&i=LEVEL&test=TEST, and behind # where exactly the visitor stands:
 * east,north,heading[,pitch[,up]] in metres and degrees, heading clockwise from north. With up (metres above 0) he
 * flies there. A link without # starts at the sector's
 * own viewpoint. i=2 holds L_2; i=auto-2 begins there and goes by what is measured.
 */
export function placeFromUrl(href) {
    const url = new URL(href);
    const numbers = url.hash.slice(1).split(',').map(Number);
    const isPose = url.hash.length > 1 && numbers.length >= 3 && numbers.length <= 5 && numbers.every(Number.isFinite);
    const [east, north, heading, pitch = 0, up] = numbers, radians = degrees => degrees * Math.PI / 180;
    const level = (url.searchParams.get('i') ?? '').match(/^(auto-)?([0-3])$/);
    return {
        start: url.searchParams.get('start') ?? '',
        level: level ? Number(level[2]) : null,
        isMeasured: Boolean(level?.[1]),
        test: url.searchParams.get('test') ?? '',
        pose: isPose ? { east, north, heading: radians(heading), pitch: radians(pitch), ...(up === undefined ? {} : { up }) } : null,
    };
}

/** `level`: i now; `isMeasured`: it goes by what is measured; `isFlying`: the height belongs to the place. */
export function urlOfPlace(href, start, { east, north, heading, pitch = 0, up = 0 }, { level = null, isMeasured = true, isFlying = false } = {}) {
    const url = new URL(href), degrees = angle => Math.round(angle * 180 / Math.PI);
    if (start) url.searchParams.set('start', start);
    if (level !== null) url.searchParams.set('i', `${isMeasured ? 'auto-' : ''}${level}`);
    const tilt = degrees(pitch) || 0, turn = (degrees(heading) % 360 + 360) % 360;
    url.hash = [east.toFixed(2), north.toFixed(2), turn, ...(tilt || isFlying ? [tilt] : []), ...(isFlying ? [up.toFixed(1)] : [])].join(',');
    return url.href;
}

const kTourNames = ['tour', 'from', 'to', 'via', 'round'];

/** The query of /tours that the page's address asks to play; null: none. */
export function tourFromUrl(href) {
    const query = new URLSearchParams([...new URL(href).searchParams].filter(([name]) => kTourNames.includes(name)));
    return query.has('tour') || query.has('from') ? query : null;
}

/** The page's address with that tour, in place of any other; null: with none. */
export function urlOfTour(href, query) {
    const url = new URL(href);
    for (const name of kTourNames) url.searchParams.delete(name);
    for (const [name, value] of query ?? []) url.searchParams.append(name, value);
    return url.href;
}

/** The root world's address for a start. */
export function rootUrl(start) {
    return start ? `/city.x3d?start=${encodeURIComponent(start)}` : '/city.x3d';
}
