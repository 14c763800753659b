import assert from 'node:assert/strict';
import test from 'node:test';
import { steadyLevel } from '../../../../client_scripts/core/steadyLevel.js';

const kRanges = [30, 90, 250];

test('without a level shown, the thresholds alone decide', () => {
    for (const [distance, level] of [[0, 0], [29.9, 0], [30, 1], [89, 1], [90, 2], [249, 2], [250, 3], [1e6, 3]])
        assert.equal(steadyLevel(kRanges, -1, distance), level);
    assert.equal(steadyLevel([], 0, 5), 0);
});

test('a level stays within a tenth of its thresholds and goes beyond', () => {
    assert.equal(steadyLevel(kRanges, 0, 32.9), 0);
    assert.equal(steadyLevel(kRanges, 0, 33), 1);
    assert.equal(steadyLevel(kRanges, 1, 27.1), 1);
    assert.equal(steadyLevel(kRanges, 1, 27), 0);
    assert.equal(steadyLevel(kRanges, 3, 20), 0);
    assert.equal(steadyLevel(kRanges, 0, 300), 3);
    assert.equal(steadyLevel(kRanges, 5, 300), 3, 'a level that there is not');
});

test('steps to and fro at a threshold change nothing', () => {
    let level = steadyLevel(kRanges, -1, 29.5), changes = 0;
    for (let i = 0; i < 1000; ++i) {
        const next = steadyLevel(kRanges, level, 30 + Math.sin(i));
        changes += next !== level;
        level = next;
    }
    assert.equal(changes, 0);
});

test('on any walk a level is never farther from the plain one than the margin allows', () => {
    const seed = 20261124;
    let state = seed, level = -1, distance = 100;
    const random = () => ((state = (state * 1103515245 + 12345) % 2147483648) / 2147483648);
    for (let i = 0; i < 100000; ++i) {
        distance = Math.max(0, distance + (random() - 0.5) * (i % 100 === 0 ? 400 : 4));
        level = steadyLevel(kRanges, level, distance);
        const least = level === 0 ? 0 : kRanges[level - 1] * 0.9, most = level === 3 ? Infinity : kRanges[level] * 1.1;
        assert.ok(distance >= least && distance <= most, `seed ${seed}: level ${level} at ${distance} m`);
    }
});
