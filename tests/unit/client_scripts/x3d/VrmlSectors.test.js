import assert from 'node:assert/strict';
import test from 'node:test';
import { SectorLoader } from '../../../../client_scripts/core/SectorLoader.js';
import { VrmlSectors } from '../../../../client_scripts/x3d/VrmlSectors.js';
import { FakeNode } from '../../../support/fakeScene.js';
import { streetRecords } from '../../../support/streetRecords.js';

/** As much of a VRML97 browser as VrmlSectors uses; fetches nothing whose id is in `broken`. */
function vrmlWorld(start) {
    const records = new Map(streetRecords().map(record => [record.id, record]));
    const first = new FakeNode('Transform');
    const world = { children: [first], fetched: [], broken: new Set(), now: 0 };
    Object.defineProperty(world, 'addChildren', { set: nodes => world.children.push(...nodes) });
    Object.defineProperty(world, 'removeChildren', {
        set: nodes => { world.children = world.children.filter(child => !nodes.includes(child)); } });
    const browser = {
        createVrmlFromString(text) {
            const [east, , south] = text.match(/-?[\d.]+/g) ?? [];
            return [new FakeNode(text.split(' ')[0], { translation: { x: Number(east), y: 0, z: Number(south) } })];
        },
        createVrmlFromURL([url], place, event) {
            assert.equal(event, 'addChildren');
            const id = url.match(/^sectors\/(.*)\.wrl$/)[1];
            world.fetched.push(id);
            if (world.broken.has(id)) return;
            place.children = [new FakeNode('Anchor', { description: 'vicus record', parameter: [JSON.stringify(records.get(id))] })];
        },
    };
    const sectors = new VrmlSectors({ browser, world, base: 'sectors/', ids: [start], places: [first],
        nodes: node => [node], strings: text => [text], clock: () => world.now });
    const loader = new SectorLoader(start, sectors, { keepSeconds: 5, nearOnly: true });
    loader.planner.addNeighbour(records.get(start));
    const frames = (position, count) => { for (let i = 0; i < count; ++i) loader.step(position, world.now += 0.1); };
    return { world, first, sectors, frames };
}

test('sectors are fetched into Transforms at their origins; the one shown at the start gives way to the Script\'s own', () => {
    const { world, first, frames } = vrmlWorld('s2');
    frames([100, 5], 10);
    assert.deepEqual(world.fetched.sort(), ['s1', 's2', 's3', 'yard']);
    assert.equal(world.children.includes(first), false);
    assert.ok(world.children.some(({ translation }) => translation.x === 100 && translation.z === -20));
});

test('a sector left behind is deleted from the world, and fetched again when it is needed again', () => {
    const { world, frames } = vrmlWorld('s0');
    frames([20, 5], 10);
    frames([60, 5], 10);
    frames([100, 5], 70);
    assert.equal(world.children.length, 4);
    frames([60, 5], 10);
    frames([60, 5], 10);
    assert.equal(world.fetched.filter(id => id === 's0').length, 2);
});

test('what does not come within the patience is asked for again', () => {
    const { world, frames } = vrmlWorld('s0');
    world.broken.add('s1');
    frames([20, 5], 190);
    assert.equal(world.fetched.filter(id => id === 's1').length, 1);
    world.broken.clear();
    frames([20, 5], 30);
    assert.equal(world.fetched.filter(id => id === 's1').length, 2);
});

test('a file without a record is refused by name', () => {
    const { sectors } = vrmlWorld('s0');
    sectors.show('s1', [60, 5]);
    sectors.shown.get('s1').place.children = [new FakeNode('Group')];
    assert.throws(() => sectors.record('s1'), /sector s1: the file carries no record/);
});
