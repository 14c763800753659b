import assert from 'node:assert/strict';
import test from 'node:test';
import { buildQuickly, readNumbersQuickly } from '../../../../client_scripts/page/quickFaces.js';

const value = list => ({ getValue: () => list });

/** What X_ITE's IndexedFaceSet has of interest here. */
function faces(points, coordIndex, { ccw = true, creaseAngle = 0 } = {}) {
    const type = {
        generateNormals: () => 'plain',
        build() { this.built = [0, 1].map(i => [this.getColorPerFaceIndex(i), this.getTexCoordPerVertexIndex(i)]); },
    };
    const normals = [];
    buildQuickly(type);
    return { node: Object.assign(Object.create(type), {
        _coordIndex: value(coordIndex), _creaseAngle: value(creaseAngle), _ccw: value(ccw), _colorIndex: { ...value([7]), length: 1 },
        _texCoordIndex: { ...value([]), length: 0 }, getCoord: () => ({ _point: value(points) }), getNormals: () => normals }), normals };
}

test('each corner of a face has the face\'s normal; a clockwise face looks the other way', () => {
    const square = [0, 0, 0, 2, 0, 0, 2, 0, -2, 0, 0, -2];   // seen from above, counter-clockwise
    const polygons = [{ vertices: [0, 1, 2, 3], triangles: [0, 1, 2, 0, 2, 3] }];
    const { node, normals } = faces(square, [0, 1, 2, 3, -1]);
    node.generateNormals(polygons);
    assert.deepEqual(normals.map(Math.abs), Array.from({ length: 6 }, () => [0, 1, 0]).flat());
    assert.ok(normals[1] > 0);
    const other = faces(square, [0, 1, 2, 3, -1], { ccw: false });
    other.node.generateNormals(polygons);
    assert.ok(other.normals[1] < 0);
    assert.equal(faces(square, [], { creaseAngle: 1 }).node.generateNormals(polygons), 'plain');
});

test('a face without extent has no direction, and no NaN', () => {
    const { node, normals } = faces([1, 1, 1, 1, 1, 1, 1, 1, 1], [0, 1, 2, -1]);
    node.generateNormals([{ vertices: [0, 1, 2], triangles: [0, 1, 2] }]);
    assert.deepEqual(normals.map(Math.abs), Array(9).fill(0));
});

test('indices come from the lists where they reach, else as X3D has it', () => {
    const { node } = faces([], [4, 5, -1]);
    node.build();
    assert.deepEqual(node.built, [[7, 4], [1, 5]]);
    assert.ok(!Object.hasOwn(node, 'getColorPerFaceIndex'));
});

test('long lists of numbers are read at once, others as before', () => {
    const read = [], parser = { nodeAttribute: ({ name }) => read.push(name) }, fields = {};
    readNumbersQuickly(parser);
    const node = { getPredefinedField: name => ({ setValue: list => { fields[name] = list; } }) };
    parser.nodeAttribute({ name: 'point', value: ' 1 -2.5\n3e-1, 4 ' }, node);
    parser.nodeAttribute({ name: 'coordIndex', value: '' }, node);
    parser.nodeAttribute({ name: 'solid', value: 'false' }, node);
    assert.deepEqual([fields, read], [{ point: [1, -2.5, 0.3, 4], coordIndex: [] }, ['solid']]);
});
