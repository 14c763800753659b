import assert from 'node:assert/strict';
import test from 'node:test';
import { RoofHeights } from '../../../../client_scripts/core/RoofHeights.js';
import { placeBelow } from '../../../../client_scripts/core/placeBelow.js';
import { eyeAxes } from '../../../../client_scripts/core/viewCone.js';
import { seededRandom } from '../../../support/random.js';

/** Ground that rises to the east, 1 in 10, and a house of 20 m that stands across the lattice, with a yard in it. */
function heights() {
    const ring = (r, turn) => [0, 1, 2, 3].map(i => [100 + r * Math.cos(turn + i * Math.PI / 2), 100 + r * Math.sin(turn + i * Math.PI / 2)]);
    const edges = [ring(30, 0.3), ring(8, 0.3).reverse()].flatMap(points => points.flatMap((p, i) => [...p, ...points[(i + 1) % 4]]));
    const all = new RoofHeights();
    all.add('0/0/0', { corner: [0, 0], side: 200, nodes: 3, heights: Float64Array.of(0, 10, 20, 0, 10, 20, 0, 10, 20),
        roofs: Float32Array.of(70, 70, 130, 130, 40), outlines: [Float32Array.from(edges)] });
    return all;
}
const straightDown = (east, north) => ({ eye: [east, north, 150], heading: 0, pitch: -Math.PI / 2, half: [0.5, 0.5] });

test('a roof, the yard within it, the ground beside it, the sky', () => {
    const all = heights(), roof = placeBelow(straightDown(118, 100), [0, 0], all), yard = placeBelow(straightDown(100, 100), [0, 0], all);
    assert.ok(roof.isRoof && Math.abs(roof.up - 40) < 0.01 && Math.abs(roof.away - 110) < 0.05);
    assert.ok(!yard.isRoof && Math.abs(yard.up - 10) < 0.01);
    assert.ok(!placeBelow(straightDown(128, 128), [0, 0], all).isRoof, 'the corner of its box is not the house');
    assert.equal(placeBelow({ eye: [100, 100, 150], heading: 0, pitch: 0.2, half: [0.5, 0.5] }, [0, 0], all), null);
});

test('the place lies on the ray through the pixel, and nothing stands before it', () => {
    const all = heights();
    for (let seed = 1; seed <= 200; ++seed) {
        const random = seededRandom(seed), eye = [200 * random(), 200 * random(), 60 + 100 * random()];
        const view = { eye, heading: 6.3 * random(), pitch: -0.4 - random(), half: [0.8, 0.5] }, pixel = [1.6 * random() - 0.8, 1.6 * random() - 0.8];
        const found = placeBelow(view, pixel, all);
        if (!found) continue;
        const { ahead, right, above } = eyeAxes(view.heading, view.pitch);
        const way = ahead.map((value, k) => value + pixel[0] * 0.8 * right[k] + pixel[1] * 0.5 * above[k]), length = Math.hypot(...way);
        const at = t => eye.map((value, k) => value + t * way[k] / length);
        assert.ok(Math.hypot(...at(found.away).slice(0, 2).map((value, k) => value - found.point[k])) < 1e-6, `seed ${seed}`);
        let run = 0;   // what is missed is thinner than a step
        for (let t = 0; t < found.away - 0.01; t += 0.05) {
            const [east, north, up] = at(t);
            run = Math.max(all.top([east, north]), all.ground([east, north]) ?? -Infinity) > up ? run + 0.05 : 0;
            assert.ok(run < 1.4, `seed ${seed}: something stands at ${t} of ${found.away}`);
        }
    }
});
