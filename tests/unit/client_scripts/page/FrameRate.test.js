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

test('who stands still for a while sees every pixel, until he moves', () => {
    const applied = [], frameRate = new FrameRate(scale => applied.push(scale), true);
    for (let i = 0; i < 5; ++i) frameRate.rest(0.1);
    frameRate.add(0.03);
    assert.deepEqual(applied, [0.5], 'half a second is a pause');
    for (let i = 0; i < 50; ++i) frameRate.rest(0.1);
    assert.deepEqual(applied, [0.5, 1]);
    frameRate.add(0.4);
    assert.deepEqual(applied, [0.5, 1, 0.5]);
    assert.equal(scalesAfter(frameRate, 0.03, 100), 0.5, 'the slow frame of the rest is not judged');
});
