/** m: a roof so near counts as if it were below. */
const kAround = 4;

/** How high the eye must be over tiles that are there (of tileMesh): by their roofs and their ground. */
export class RoofHeights {
    constructor() {
        this.tiles = new Map();   // key -> mesh
    }

    add(key, mesh) {
        this.tiles.set(key, mesh);
    }

    remove(key) {
        this.tiles.delete(key);
    }

    /** m above 0 of the finest tile's ground at a place; null: none is there. */
    ground([east, north]) {
        const mesh = this.finest(east, north);
        if (!mesh) return null;
        const { corner, side, nodes, heights } = mesh, step = side / (nodes - 1);
        const [x, y] = [(east - corner[0]) / step, (north - corner[1]) / step];
        const [i, j] = [x, y].map(v => Math.min(nodes - 2, Math.max(0, Math.floor(v)))), [u, v] = [x - i, y - j];
        const up = (column, row) => heights[row * nodes + column];
        return (1 - v) * ((1 - u) * up(i, j) + u * up(i + 1, j)) + v * ((1 - u) * up(i, j + 1) + u * up(i + 1, j + 1));
    }

    /** m above 0 of the highest roof at a place or just beside; -Infinity: none. */
    roof([east, north]) {
        const mesh = this.finest(east, north);
        let top = -Infinity;
        if (!mesh) return top;
        for (let i = 0; i < mesh.roofs.length; i += 5) {
            const [west, south, e, n, up] = mesh.roofs.subarray(i, i + 5);
            if (east > west - kAround && east < e + kAround && north > south - kAround && north < n + kAround) top = Math.max(top, up);
        }
        return top;
    }

    /** m above 0 of the highest house that stands at a place; -Infinity: none. */
    top([east, north]) {
        const mesh = this.finest(east, north);
        let top = -Infinity;
        mesh?.outlines?.forEach((edges, i) => {
            const [west, south, e, n, up] = mesh.roofs.subarray(5 * i, 5 * i + 5);
            if (up > top && east >= west && east <= e && north >= south && north <= n && isWithin(edges, east, north)) top = up;
        });
        return top;
    }

    finest(east, north) {
        let best = null;
        for (const mesh of this.tiles.values()) {
            const [x, y] = [east - mesh.corner[0], north - mesh.corner[1]];
            if (x >= 0 && y >= 0 && x < mesh.side && y < mesh.side && (!best || mesh.side < best.side)) best = mesh;
        }
        return best;
    }
}

function isWithin(edges, x, y) {
    let inside = false;
    for (let i = 0; i < edges.length; i += 4) {
        const [ax, ay, bx, by] = edges.subarray(i, i + 4);
        if ((ay > y) !== (by > y) && x < ax + (y - ay) / (by - ay) * (bx - ax)) inside = !inside;
    }
    return inside;
}
