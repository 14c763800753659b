import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { recordFromMetadata } from '../../../../client_scripts/core/recordMetadata.js';
import { FakeInline, FakeNode, metadataOf } from '../../../support/fakeScene.js';
import { seeingFar, streetRecords } from '../../../support/streetRecords.js';

const kScripts = fileURLToPath(new URL('../../../../client_scripts/', import.meta.url));

/** The text an X3D Script gets: made as the build makes it. */
function bundle() {
    const folder = mkdtempSync(join(tmpdir(), 'vicus-loader-'));
    try {
        execFileSync('cmake', [`-DOUT=${folder}/loader.js`, '-P', `${kScripts}bundle_loader.cmake`]);
        return readFileSync(`${folder}/loader.js`, 'utf8');
    } finally {
        rmSync(folder, { recursive: true });
    }
}

/** Runs the bundle as a browser does: sloppy code with the Script's fields in scope by name. */
function runScript(fields) {
    const text = bundle();
    const run = new Function('fields', `with (fields) { ${text}; return { initialize, set_position, set_orientation, prepareEvents }; }`);
    const script = run(fields);
    script.initialize();
    return script;
}

function rootWorld(start, records) {
    const served = new Map(records.flatMap(record => ['', '.far', '.tall'].map(level => [`sectors/${record.id}${level}.x3d`, record])));
    const inline = new FakeInline(served);
    inline.url = [`sectors/${start}.x3d`];
    Object.assign(inline, { bboxCenter: { x: 0, y: 0, z: 0 }, bboxSize: { x: 40, y: 20, z: 10 } });
    const [east, north] = records.find(record => record.id === start).origin;
    const fields = {
        start, base: 'sectors/', level: '1', sector_test: 'polygon', level_changed: '', ids: [start], inlines: [inline], origins: [{ x: east, y: 0, z: -north }], sector_changed: '',
        world: new FakeNode('Group'), printed: [],
        Browser: { currentScene: { createNode: type => (type === 'Inline' ? new FakeInline(served) : new FakeNode(type)) } },
    };
    fields.Browser.println = text => fields.printed.push(text);
    return fields;
}

const frames = (script, count) => { for (let i = 0; i < count; ++i) script.prepareEvents(); };
const shown = fields => [fields.inlines[0], ...fields.world.children.map(place => place.children[0])]
    .filter(inline => inline?.load).map(inline => inline.url[0]).sort();

test('a MetadataSet gives back the record it was made from', () => {
    const [first, ...others] = streetRecords();
    const full = { ...first, bodies: [[20, 5, 0.5], [22, 6.125, 1.6]], visible: ['s0', 's1', 's4'], over_roofs: ['s4'] };
    for (const record of [full, ...others]) {
        const read = recordFromMetadata(metadataOf(record));
        for (const key of ['id', 'kind', 'name', 'origin', 'box', 'ground', 'shapes']) assert.deepEqual(read[key], record[key], key);
        assert.deepEqual(read.bodies, record.bodies ?? []);
        assert.deepEqual([read.visible, read.over_roofs], [record.visible, record.over_roofs]);
        assert.deepEqual(read.gates.map(({ id, to, line }) => ({ id, to, line })), record.gates);
        assert.deepEqual(read.neighbours.map(({ id, origin, box }) => ({ id, origin, box })),
            record.neighbours.map(({ id, origin, box }) => ({ id, origin, box })));
    }
});

test('ground_counts that do not add up are refused', () => {
    const set = metadataOf(streetRecords()[0]);
    set.value.find(item => item.name === 'ground_counts').value = [5];
    assert.throws(() => recordFromMetadata(set), /sector s0: ground_counts 5 do not add up to its 4 points/);
});

test('neighbours that lack numbers are refused', () => {
    const set = metadataOf(streetRecords()[0]);
    set.value.find(item => item.name === 'neighbour_boxes').value.pop();
    assert.throws(() => recordFromMetadata(set), /sector s0: 1 neighbours, but 2 and 3 numbers of theirs/);
});

test('the bundled Script loads its start, then the neighbours the record tells of, placed at their origins', () => {
    const fields = rootWorld('s2', streetRecords()), script = runScript(fields);
    assert.equal(fields.sector_changed, 's2');
    frames(script, 5);
    assert.deepEqual(shown(fields), ['sectors/s2.x3d'], 'the browser binds the viewpoint when nothing is on its way');
    script.set_position({ x: 100, y: 1.7, z: -5 });
    frames(script, 10);
    assert.deepEqual(shown(fields), ['sectors/s1.x3d', 'sectors/s2.x3d', 'sectors/s3.x3d', 'sectors/yard.x3d']);
    const yard = fields.world.children.find(place => place.children[0]?.url[0] === 'sectors/yard.x3d');
    assert.deepEqual([yard.translation.x, yard.translation.z], [100, -20]);
});

test('the bundled Script shows far and tall files of what the record lists as visible', () => {
    const fields = rootWorld('s1', seeingFar(streetRecords(), { overRoofs: ['s5'] })), script = runScript(fields);
    script.set_position({ x: 60, y: 1.7, z: -5 });
    frames(script, 12);
    assert.deepEqual(shown(fields).map(url => url.slice('sectors/'.length)),
        ['s0.x3d', 's1.x3d', 's2.x3d', 's3.far.x3d', 's4.far.x3d', 's5.tall.x3d', 'yard.far.x3d']);
    const far = fields.world.children.find(place => place.children[0]?.url[0] === 'sectors/s4.far.x3d');
    assert.deepEqual([far.translation.x, far.translation.z], [180, -5]);
});

test('the bundled Script asks first for what lies ahead of the visitor', () => {
    for (const [angle, first] of [[-Math.PI / 2, 's2'], [Math.PI / 2, 's0']]) {
        const fields = rootWorld('s1', streetRecords()), script = runScript(fields);
        script.set_orientation({ x: 0, y: 1, z: 0, angle });
        script.set_position({ x: 60, y: 1.7, z: -5 });
        frames(script, 2);
        assert.deepEqual(shown(fields), [`sectors/${first}.x3d`, 'sectors/s1.x3d'].sort());
    }
});

test('the bundled Script takes i and the sector test from its fields, and tells i', () => {
    for (const [level, files] of [['0', ['s1']], ['2', ['s0', 's1', 's2', 's3.far', 'yard.far']]]) {
        const fields = { ...rootWorld('s1', streetRecords()), level, sector_test: 'gate' }, script = runScript(fields);
        script.set_position({ x: 60, y: 1.7, z: -5 });
        frames(script, 20);
        assert.equal(fields.level_changed, level);
        assert.deepEqual(shown(fields).map(url => url.slice('sectors/'.length, -'.x3d'.length)), files);
    }
    assert.throws(() => runScript({ ...rootWorld('s2', streetRecords()), sector_test: 'sphere' }), /no sector test 'sphere'/);
});

test('the bundled Script follows the visitor and says so', () => {
    const fields = rootWorld('s0', streetRecords()), script = runScript(fields);
    frames(script, 5);
    script.set_position({ x: 41, y: 1.7, z: -5 });
    frames(script, 5);
    assert.equal(fields.sector_changed, 's1');
    assert.ok(shown(fields).includes('sectors/s2.x3d'));
});

test('a sector left behind sets the alarm for the time it is given back, so that a still scene wakes', () => {
    const fields = rootWorld('s0', streetRecords()), script = runScript(fields);
    script.set_position({ x: 20, y: 1.7, z: -5 });
    frames(script, 10);
    const alarm = fields.world.children.find(node => node.type === 'TimeSensor');
    const before = Date.now() / 1000;
    script.set_position({ x: 81, y: 1.7, z: -5 });
    frames(script, 10);
    const wait = alarm.startTime - before;
    assert.ok(wait > 0 && wait < 11, `${wait} s`);
});

test('a sector that fails, or carries no record, is reported by name and does not stop the others', () => {
    const records = streetRecords(), fields = rootWorld('s2', records);
    const script = runScript(fields);
    FakeInline.broken.add('sectors/s1.x3d');
    FakeInline.bare.add('sectors/s3.x3d');
    script.set_position({ x: 100, y: 1.7, z: -5 });
    frames(script, 20);
    FakeInline.broken.clear();
    FakeInline.bare.clear();
    assert.ok(fields.printed.some(text => text.includes('sector s1 cannot be fetched')), fields.printed.join());
    assert.ok(fields.printed.some(text => text.includes('carries no RECORD')), fields.printed.join());
    assert.ok(shown(fields).includes('sectors/yard.x3d'));
});
