/** Has tiles made ready by a worker. */
export class TileWorkshop {
    constructor(layouts) {
        Object.assign(this, { worker: new Worker(new URL('./tileWorker.js', import.meta.url), { type: 'module' }), waiting: new Map(), next: 0 });
        this.worker.postMessage({ layouts });
        this.worker.addEventListener('message', ({ data: { id, mesh, error } }) => {
            const { resolve, reject } = this.waiting.get(id);
            this.waiting.delete(id);
            if (mesh) resolve(mesh);
            else reject(new Error(error));
        });
        this.worker.addEventListener('error', event => {
            for (const { reject } of this.waiting.values()) reject(new Error(event.message ?? 'the worker does not run'));
            this.waiting.clear();
        });
    }

    /** `tile`: { prisms, ground } or { blockMap } as bytes, which are gone afterwards. A promise of tileMesh's. */
    prepare(tile) {
        const id = this.next++;
        return new Promise((resolve, reject) => {
            this.waiting.set(id, { resolve, reject });
            this.worker.postMessage({ id, ...tile }, Object.values(tile).filter(Boolean).map(bytes => bytes.buffer));
        });
    }
}
