import assert from 'node:assert/strict';
import test from 'node:test';
import { FrameRate } from '../../../../client_scripts/page/FrameRate.js';

function scalesAfter(frameRate, seconds, frames) {
    for (let i = 0; i < frames; ++i) frameRate.add(seconds);
    return frameRate.scale;
}

test('slow frames take pixels away step by step, fast ones give them back, neither goes past the ends', () => {
    const applied = [], frameRate = new FrameRate(scale => applied.push(scale), false);
    assert.equal(scalesAfter(frameRate, 0.1, 19), 1);
    assert.equal(scalesAfter(frameRate, 0.1, 1), 0.75);
    assert.equal(scalesAfter(frameRate, 0.1, 200), 0.35);
    assert.equal(scalesAfter(frameRate, 0.03, 200), 0.35);
    assert.equal(scalesAfter(frameRate, 0.016, 200), 1);
    assert.deepEqual(applied, [0.75, 0.5, 0.35, 0.5, 0.75, 1]);
});

test('one long frame among fast ones is no reason', () => {
    const frameRate = new FrameRate(() => {}, false);
    for (let i = 0; i < 100; ++i) frameRate.add(i % 10 ? 0.016 : 1);
    assert.equal(frameRate.scale, 1);
});

test('without a graphics card the first picture has half the pixels', () => {
    const applied = [];
    assert.equal(new FrameRate(scale => applied.push(scale), true).scale, 0.5);
    assert.deepEqual(applied, [0.5]);
});
