/** Attributes that hold most of a file's numbers. */
const kLong = new Set(['point', 'coordIndex', 'texCoordIndex', 'color', 'colorIndex']);

/** An XML parser of X_ITE 15.0.1 reads long lists of numbers by a pattern for each; here a list is split at once, a fifth of the time. */
export function readNumbersQuickly(parser) {
    const plain = parser.nodeAttribute;
    parser.nodeAttribute = function (attribute, node) {
        if (!kLong.has(attribute.name)) return plain.call(this, attribute, node);
        const text = attribute.value.trim();
        node.getPredefinedField(attribute.name).setValue(text ? text.split(/[\s,]+/).map(Number) : []);
    };
}

/**
 * Normals and indices of an IndexedFaceSet without an object for every corner; X_ITE 15.0.1 makes several. `type`: the
 * prototype of its nodes. The same numbers come out, but for faces that are not plane: theirs is Newell's normal.
 */
export function buildQuickly(type) {
    const { build, generateNormals } = type;
    type.build = function () {
        const [corners, colours, places] = [this._coordIndex, this._colorIndex, this._texCoordIndex].map(list => list.getValue());
        const { length: countColours } = this._colorIndex, { length: countPlaces } = this._texCoordIndex;
        this.getColorPerFaceIndex = face => (face < countColours ? colours[face] : face);
        this.getTexCoordPerVertexIndex = corner => (corner < countPlaces ? places[corner] : corners[corner]);
        try {
            build.call(this);
        } finally {
            delete this.getColorPerFaceIndex;
            delete this.getTexCoordPerVertexIndex;
        }
    };
    type.generateNormals = function (polygons) {
        if (this._creaseAngle.getValue() > 0) return generateNormals.call(this, polygons);
        const index = this._coordIndex.getValue(), points = this.getCoord()._point.getValue(), normals = this.getNormals();
        const sign = this._ccw.getValue() ? 1 : -1;
        for (const { vertices, triangles } of polygons) {
            const [x, y, z] = newellNormal(vertices, index, points);
            for (let corner = 0; corner < triangles.length; ++corner) normals.push(sign * x, sign * y, sign * z);
        }
    };
}

function newellNormal(vertices, index, points) {
    let [x, y, z] = [0, 0, 0];
    for (let i = 0; i < vertices.length; ++i) {
        const a = 3 * index[vertices[i]], b = 3 * index[vertices[(i + 1) % vertices.length]];
        x += (points[a + 1] - points[b + 1]) * (points[a + 2] + points[b + 2]);
        y += (points[a + 2] - points[b + 2]) * (points[a] + points[b]);
        z += (points[a] - points[b]) * (points[a + 1] + points[b + 1]);
    }
    const length = Math.hypot(x, y, z) || 1;
    return [x / length, y / length, z / length];
}
