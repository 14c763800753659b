/**
 * The page's address: ?start=SECTOR, and behind # where exactly the visitor stands: east,north,heading in metres and
 * degrees clockwise from north. A link without # starts at the sector's own viewpoint.
 */
export function placeFromUrl(href) {
    const url = new URL(href);
    const numbers = url.hash.slice(1).split(',').map(Number);
    const isPose = url.hash.length > 1 && numbers.length === 3 && numbers.every(Number.isFinite);
    const radians = isPose ? numbers[2] * Math.PI / 180 : 0;
    return {
        start: url.searchParams.get('start') ?? '',
        pose: isPose ? { east: numbers[0], north: numbers[1], heading: radians } : null,
    };
}

export function urlOfPlace(href, start, { east, north, heading }) {
    const url = new URL(href);
    if (start) url.searchParams.set('start', start);
    const degrees = (Math.round(heading * 180 / Math.PI) % 360 + 360) % 360;
    url.hash = `${east.toFixed(2)},${north.toFixed(2)},${degrees}`;
    return url.href;
}

/** The root world's address for a start. */
export function rootUrl(start) {
    return start ? `/city.x3d?start=${encodeURIComponent(start)}` : '/city.x3d';
}
