import assert from 'node:assert/strict';
import test from 'node:test';
import { planFromDegrees } from '../../../../client_scripts/core/planFrame.js';
import { pointInside } from '../../../../client_scripts/core/pointInside.js';

/** By PROJ: +proj=tmerc +lat_0=48.87937 +lon_0=2.3497 +k=1 +ellps=WGS84. */
const kKnown = [
    [[3.7497, 48.87937], 102686.304669, 945.173974], [[2.3497, 49.77937], 0, 100094.500039],
    [[1.2, 48.2], -85463.997063, -74907.23521], [[2.351987, 48.880123], 167.745129, 83.7417]];

test('degrees become plan metres as PROJ makes them, to a millimetre within 100 km', () => {
    const origin = [48.87937, 2.3497];
    for (const [lonLat, east, north] of kKnown) {
        const found = planFromDegrees(lonLat, origin);
        assert.ok(Math.hypot(found[0] - east, found[1] - north) < 0.001, `${lonLat}: ${found}, expected ${[east, north]}`);
    }
    assert.deepEqual(planFromDegrees([2.3497, 48.87937], origin).map(v => Math.abs(Math.round(1e6 * v))), [0, 0]);
});

test('a point inside is inside, off holes, too', () => {
    const hole = [[4, 4], [4, 6], [6, 6], [6, 4]];
    const [x, y] = pointInside([[[0, 0], [10, 0], [10, 10], [0, 10]], hole]);
    assert.ok(x > 0 && x < 10 && y > 0 && y < 10 && !(x >= 4 && x <= 6 && y >= 4 && y <= 6), `${[x, y]}`);
    const [east, north] = pointInside([[[0, 0], [10, 0], [10, 1], [1, 1], [1, 10], [0, 10]]]);
    assert.ok(east > 0 && north > 0 && (east < 1 || north < 1), `${[east, north]}`);
});
