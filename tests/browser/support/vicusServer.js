import { spawn, execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const kRoot = fileURLToPath(new URL('../../../', import.meta.url));
export const vicusProgram = process.env.VICUS ?? join(kRoot, 'build/release/cli/vicus');
const kData = process.env.VICUS_DATA ?? join(kRoot, '../shared/data');

/** The program's path. Fails  Error: it is not built. */
function program() {
    if (!existsSync(vicusProgram)) throw new Error(`no program at ${vicusProgram}: build it, or set VICUS to its path`);
    return vicusProgram;
}

/**
 * The cities to walk: name -> function that makes the city file in `folder` and returns its path.
 * Rochechouart only where the real data is. VICUS_CITY: that city file alone; VICUS_ORIGIN: what runs there already.
 */
export function cities() {
    if (process.env.VICUS_ORIGIN) return { running: () => '' };
    if (process.env.VICUS_CITY) return { [basename(process.env.VICUS_CITY, '.gpkg')]: () => process.env.VICUS_CITY };
    const made = { town: folder => {
        execFileSync(program(), ['town', '--houses', '300', '--seed', '7', '-o', join(folder, 'town.osm'), '--quiet']);
        return build(folder, join(folder, 'town.osm'));
    } };
    const rochechouart = join(kData, 'paris-rochechouart', 'paris-rochechouart.osm.pbf');
    if (existsSync(rochechouart)) made.rochechouart = folder => build(folder, rochechouart);
    return made;
}

/** Cities that take minutes to build: Berlin Mitte, where the data is and VICUS_LARGE is set. */
export function largeCities() {
    const folder = join(kData, 'berlin-mitte'), isWanted = process.env.VICUS_LARGE && !process.env.VICUS_ORIGIN && !process.env.VICUS_CITY;
    const files = ['buildings', 'streets', 'water'].map(name => join(folder, `${name}.geojsonl.gz`));
    return isWanted && files.every(existsSync) ? { berlin: place => build(place, ...files) } : {};
}

function build(folder, ...inputs) {
    const city = join(folder, 'city.gpkg');
    execFileSync(program(), ['build', ...inputs, '-o', city, '--quiet', ...(process.env.VICUS_BUILD_OPTIONS ?? '').split(' ').filter(Boolean)], { stdio: ['ignore', 'ignore', 'inherit'] });
    return city;
}

/** Serves what `make(folder)` returns until stop(): { origin, stop }. */
export async function serveCity(make) {
    if (process.env.VICUS_ORIGIN) return { origin: process.env.VICUS_ORIGIN, async stop() {} };
    const folder = mkdtempSync(join(tmpdir(), 'vicus-city-'));
    const city = make(folder);
    const child = spawn(program(), ['serve', city, '--bind', '127.0.0.1', '--port', '0'], { stdio: ['ignore', 'pipe', 'pipe'] });
    const origin = await printedAddress(child);
    return {
        origin,
        async stop() {
            const ended = new Promise(resolve => child.once('exit', resolve));
            child.kill('SIGTERM');
            await ended;
            rmSync(folder, { recursive: true, force: true });
        },
    };
}

function printedAddress(child) {
    return new Promise((resolve, reject) => {
        let said = '';
        const timer = setTimeout(() => reject(new Error(`vicus serve printed no address in 30 s: ${said}`)), 30000);
        const listen = chunk => {
            said += chunk;
            const address = said.match(/http:\/\/[^\s"]+:\d+/);
            if (!address) return;
            clearTimeout(timer);
            resolve(address[0]);
        };
        child.stdout.on('data', listen);
        child.stderr.on('data', listen);
        child.once('exit', code => reject(new Error(`vicus serve ended with ${code}: ${said}`)));
    });
}
