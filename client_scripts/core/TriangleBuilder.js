/** Collects triangles with a normal, colour and place in a pattern for each corner; grows as it needs. */
export class TriangleBuilder {
    constructor() {
        Object.assign(this, { positions: [], normals: [], colours: [], places: [], indices: [] });
    }

    get corners() {
        return this.positions.length / 3;
    }

    /** A corner [x, y, z]; returns its number. `colour`: [r, g, b, what it is], each 0 ... 1; `place`: [u, v]. */
    corner(position, normal, colour, place) {
        this.positions.push(...position);
        this.normals.push(...normal);
        this.colours.push(...colour);
        this.places.push(...place);
        return this.corners - 1;
    }

    triangle(a, b, c) {
        this.indices.push(a, b, c);
    }

    /** A flat convex face, corners counter-clockwise as seen from its front. Faces without area are left out. */
    face(positions, colour, places) {
        this.shadedFace(positions, positions.map(() => colour), places);
    }

    /** The same with a colour for each corner. */
    shadedFace(positions, colours, places) {
        const normal = normalOf(positions);
        if (!normal) return;
        const numbers = positions.map((position, i) => this.corner(position, normal, colours[i], places[i]));
        for (let i = 2; i < numbers.length; ++i) this.triangle(numbers[0], numbers[i - 1], numbers[i]);
    }

    /** As typed arrays. */
    build() {
        const { positions, normals, colours, places, indices } = this;
        return { positions: Float32Array.from(positions), normals: Float32Array.from(normals),
            colours: Float32Array.from(colours), places: Float32Array.from(places), indices: Int32Array.from(indices) };
    }
}

/** Newell's: right for any flat polygon; null where there is no area. */
function normalOf(points) {
    const normal = [0, 0, 0];
    points.forEach((a, i) => {
        const b = points[(i + 1) % points.length];
        for (let k = 0; k < 3; ++k) {
            const [u, v] = [(k + 1) % 3, (k + 2) % 3];
            normal[k] += (a[u] - b[u]) * (a[v] + b[v]);
        }
    });
    const length = Math.hypot(...normal);
    return length < 1e-6 ? null : normal.map(value => value / length);
}
