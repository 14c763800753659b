/** s without being asked for again: a request that waits is forgotten, one on its way is given up (001 §6, life time). */
const kLifeTime = 1;
/** s until what failed is asked for again: this, twice this, ... at most the other. */
const kRetry = 2, kLongestRetry = 60;

/**
 * Fetches tiles: what was asked for last first, then by class (A, B, C), then by error on screen (001 §6).
 * `load(tile, signal)`: returns a promise of what it makes of the tile. `arrived(tile, made)`: it is there.
 */
export class TileRequests {
    constructor({ load, arrived, mostInFlight = 4, complain = () => {} }) {
        Object.assign(this, { load, arrived, mostInFlight, complain, waiting: new Map(), inFlight: new Map(), failures: new Map() });
    }

    /** `ask` as TileTree.choose has it; `now`: s. */
    step(ask, now) {
        for (const { tile, rank, onScreen } of ask) {
            const flying = this.inFlight.get(tile.key);
            if (flying) flying.at = now;
            else this.waiting.set(tile.key, { tile, rank, onScreen, at: now });
        }
        for (const [key, { at }] of this.waiting) if (now - at > kLifeTime) this.waiting.delete(key);
        for (const [key, { at, abort }] of this.inFlight)
            if (now - at > kLifeTime) {
                abort.abort();
                this.inFlight.delete(key);
            }
        const order = [...this.waiting.values()].filter(({ tile }) => (this.failures.get(tile.key)?.until ?? 0) <= now).sort(compare);
        while (this.inFlight.size < this.mostInFlight && order.length) this.start(order.shift(), now);
    }

    start({ tile }, now) {
        const abort = new AbortController(), flight = { at: now, abort };
        this.waiting.delete(tile.key);
        this.inFlight.set(tile.key, flight);
        const isCurrent = () => this.inFlight.get(tile.key) === flight;
        this.load(tile, abort.signal).then(made => {
            if (!isCurrent()) return;
            this.inFlight.delete(tile.key);
            this.failures.delete(tile.key);
            this.arrived(tile, made);
        }).catch(error => {
            if (!isCurrent()) return;
            this.inFlight.delete(tile.key);
            const times = (this.failures.get(tile.key)?.times ?? 0) + 1;
            this.failures.set(tile.key, { times, until: now + Math.min(kLongestRetry, kRetry * 2 ** (times - 1)) });
            this.complain(`tile ${tile.key}: ${error.message}`);
        });
    }

    cancel() {
        for (const { abort } of this.inFlight.values()) abort.abort();
        this.inFlight.clear();
        this.waiting.clear();
    }
}

export function compare(a, b) {
    return b.at - a.at || (a.rank < b.rank ? -1 : a.rank > b.rank ? 1 : 0) || b.onScreen - a.onScreen || (a.tile.key < b.tile.key ? -1 : 1);
}
