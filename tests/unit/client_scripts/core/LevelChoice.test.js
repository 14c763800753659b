import assert from 'node:assert/strict';
import test from 'node:test';
import { LevelChoice } from '../../../../client_scripts/core/LevelChoice.js';

/** A device whose frames take `frame(i)` seconds; lets `seconds` pass. */
function run(choice, seconds, { frame = () => 0.016, from = 0, moves = true, ...given } = {}) {
    const seen = [choice.i];
    for (let now = from; now < from + seconds; now += Math.max(0.016, frame(choice.i))) {
        if (moves) choice.addFrame(frame(choice.i));
        choice.judge({ now, isSettled: true, waitSeconds: 0, shapes: 300, nextShapes: 350, shapeCap: 1500, memoryShare: 0.1, ...given });
        if (seen.at(-1) !== choice.i) seen.push(choice.i);
    }
    return seen;
}

test('with fast frames and room i grows to its limit, one at a time, and stays', () => {
    assert.deepEqual(run(new LevelChoice(), 60), [1, 2]);
    assert.deepEqual(run(new LevelChoice({ start: 0, limit: 3 }), 60), [0, 1, 2, 3]);
});

test('who stands still is given more, too; who waits for files is not', () => {
    assert.deepEqual(run(new LevelChoice(), 5, { moves: false }), [1, 2]);
    assert.deepEqual(run(new LevelChoice(), 60, { isSettled: false }), [1]);
});

test('frames that a smaller set makes faster: it is kept', () => {
    const choice = new LevelChoice({ start: 2 });
    assert.deepEqual(run(choice, 110, { frame: i => 0.03 + 0.04 * i }), [2, 1]);
    assert.match(choice.reason, /frames/);
});

test('what is no longer wanted stays for 8 s: frames are judged only then', () => {
    const choice = new LevelChoice({ start: 2 });
    let since = null;
    const frame = i => (i === 1 && since !== null && choice.trialNow - since > 8 ? 0.05 : 0.2);
    for (let now = 0; now < 100; now += 0.2) {
        choice.trialNow = now;
        if (choice.i === 1) since ??= now;
        choice.addFrame(frame(choice.i));
        choice.judge({ now, isSettled: true, waitSeconds: 0, shapes: 300, nextShapes: 350, shapeCap: 1500, memoryShare: 0.1 });
    }
    assert.equal(choice.i, 1);
});

test('for the frames\' sake alone nothing that is seen from here is given up', () => {
    assert.deepEqual(run(new LevelChoice({ start: 1, limit: 1 }), 110, { frame: i => 0.03 + 0.3 * i }), [1]);
});

test('frames that a smaller set makes no faster: it is given up, and not tried again soon', () => {
    const seen = run(new LevelChoice({ start: 2 }), 110, { frame: () => 0.2 });
    assert.deepEqual(seen, [2, 1, 2]);
});

test('too many Shapes, memory that runs full, a line that keeps files waiting: one less', () => {
    for (const [given, least] of [[{ shapes: 1600 }, 0], [{ memoryShare: 0.9 }, 0], [{ waitSeconds: 9 }, 1]])
        assert.deepEqual(run(new LevelChoice({ start: 2 }), 30, given), least === 0 ? [2, 1, 0] : [2, 1], JSON.stringify(given));
});

test('no ring more where it would not fit', () => {
    assert.deepEqual(run(new LevelChoice(), 60, { nextShapes: 1200 }), [1]);
    assert.deepEqual(run(new LevelChoice(), 60, { memoryShare: 0.7 }), [1]);
});

test('a fixed i is kept whatever is measured; given back to measuring it goes on from there', () => {
    const choice = new LevelChoice({ fixed: 3 });
    assert.deepEqual(run(choice, 60, { shapes: 1600 }), [3]);
    choice.set(null, 2);
    assert.deepEqual(run(choice, 3, { from: 60 }), [2]);
});
