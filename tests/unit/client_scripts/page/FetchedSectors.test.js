import assert from 'node:assert/strict';
import test from 'node:test';
import { FetchedSectors } from '../../../../client_scripts/page/FetchedSectors.js';

const kTurn = () => new Promise(resolve => setTimeout(resolve, 0));

/** A stage that writes down what is put into the world, and a server whose answers wait until they are let go. */
function world() {
    const asked = new Map(), shown = [], state = { making: 0, now: 0 };
    const stage = {
        place: origin => ({ origin }),
        makeScene: async text => {
            ++state.making;
            if (text === 'broken') throw new Error('no X3D');
            return { text };
        },
        fill: (place, scene) => shown.push(scene.text), empty: place => shown.push(`- ${place.origin}`),
        recordOf: scene => (scene.text.startsWith('bare') ? null : { id: scene.text }),
    };
    const request = (url, { signal }) => new Promise((resolve, reject) => {
        asked.set(url.slice('sectors/'.length, -'.x3d'.length), (text, status = 200) => resolve({
            ok: status === 200, status, text: async () => text, headers: { get: () => String(1000 * text.length) } }));
        signal.addEventListener('abort', () => reject(new Error('aborted')));
    });
    return { asked, shown, state, files: new FetchedSectors(stage, 'sectors/', { request, clock: () => state.now }) };
}

test('files that come together go into the world one per frame', async () => {
    const { asked, shown, files } = world();
    for (const stem of ['a', 'b', 'c.far']) files.show(stem, [0, 0]);
    for (const [stem, answer] of asked) answer(stem);
    for (let frame = 1; frame <= 4; ++frame) {
        await kTurn();
        files.frame();
        await kTurn();
        assert.equal(shown.length, frame - 1);
    }
    assert.deepEqual(shown, ['a', 'b', 'c.far']);
    assert.deepEqual(files.list().map(({ stem, phase, record }) => [stem, phase, record?.id ?? null]),
        [['a', 'live', 'a'], ['b', 'live', 'b'], ['c.far', 'live', null]]);
    assert.deepEqual(files.links('c.far'), { id: 'c.far' });
});

test('what is given up is aborted at every stage, and never shown', async () => {
    for (const stage of ['asked', 'come', 'read']) {
        const { asked, shown, files, state } = world();
        files.show('a', [1, 2]);
        if (stage !== 'asked') asked.get('a')('a');
        await kTurn();
        if (stage === 'read') files.frame();
        files.hide('a');
        for (let i = 0; i < 3; ++i) {
            await kTurn();
            files.frame();
        }
        assert.deepEqual(shown, stage === 'read' ? ['- 1,2'] : [], stage);
        assert.equal(state.making, stage === 'read' ? 1 : 0, stage);
        assert.deepEqual(files.list(), []);
    }
});

test('a refusal, a file that cannot be read and a near file without a record are told', async () => {
    const { asked, files } = world();
    for (const stem of ['gone', 'bad', 'bare']) files.show(stem, [0, 0]);
    asked.get('gone')('no', 404);
    asked.get('bad')('broken');
    asked.get('bare')('bare');
    for (let i = 0; i < 4; ++i) {
        await kTurn();
        files.frame();
    }
    await kTurn();
    assert.deepEqual(files.list().map(({ stem, phase }) => [stem, phase]), [['gone', 'failed'], ['bad', 'failed'], ['bare', 'live']]);
    assert.throws(() => files.record('bare'), /sector bare: its file carries no RECORD/);
    files.show('gone', [0, 0]);
    assert.equal(files.phase('gone'), 'loading');
});

test('bytes: what is there, what is on its way, and how long it will take', async () => {
    const { asked, files, state } = world();
    files.show('near', [0, 0]);
    files.show('other.far', [0, 0]);
    const typical = files.bytesInFlight;
    assert.ok(typical > 10000 && files.waitSeconds === 0);
    state.now = 2;
    asked.get('near')('near');   // 4000 bytes in 2 s
    await kTurn();
    files.frame();
    await kTurn();
    files.frame();
    assert.deepEqual([files.loaded.bytes, files.loaded.files, files.bytesPerSecond], [4000, 1, 2000]);
    assert.ok(files.means.near < 13000, 'the mean follows what comes');
    assert.equal(files.waitSeconds, 2, 'as long as it has taken, where that is more than what is left should take');
    state.now = 0;
    assert.ok(Math.abs(files.waitSeconds - files.bytesInFlight / 2000) < 1e-9);
    const { bytes, allBytes, files: there, allFiles } = files.progress(['x', 'y.tall']);
    assert.deepEqual([bytes, there, allFiles], [4000, 1, 4]);
    assert.ok(allBytes > 4000 + files.bytesInFlight);
});
