// Bytes, polygons and images of each level of detail, as in paper 004, figure 5:
//   node scripts/level_figures.mjs VICUS CITY.gpkg
// One LOD node is a house's share in a sector. Sent: brotli (quality 6) of 30 shares of one level in a file, a share each.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { brotliCompressSync, constants } from 'node:zlib';

const [vicus, city] = process.argv.slice(2);
if (!city) {
    console.error('usage: node scripts/level_figures.mjs VICUS CITY.gpkg');
    process.exit(2);
}
const kSharesInAFile = 30, kLevels = 4;
const folder = mkdtempSync(join(tmpdir(), 'vicus-levels-'));
try {
    execFileSync(vicus, ['export', city, '--format', 'x3d', '-o', join(folder, 'out'), '--quiet']);
    report(join(folder, 'out'));
} finally {
    rmSync(folder, { recursive: true });
}

function report(out) {
    const texts = readdirSync(join(out, 'sectors')).map(name => readFileSync(join(out, 'sectors', name), 'utf8'));
    const shares = texts.flatMap(sharesIn).filter(levels => levels.length === kLevels);
    const images = readdirSync(join(out, 'textures')).map(name => statSync(join(out, 'textures', name)).size);
    console.log(`${basename(city)}: ${shares.length} shares, ${images.length} images of ${mean(images).toFixed(0)} bytes`);
    console.log('| level | triangles mean | median | bytes raw | sent | images |\n|---|---|---|---|---|---|');
    for (let level = 1; level <= kLevels; ++level) {
        const group = shares.map(levels => levels[kLevels - level]);
        const triangles = group.map(countTriangles).sort((a, b) => a - b);
        console.log(`| LOD${level} | ${mean(triangles).toFixed(0)} | ${triangles[triangles.length >> 1]} | ` +
            `${mean(group.map(text => text.length)).toFixed(0)} | ${sentBytes(group).toFixed(0)} | ` +
            `${mean(group.map(text => new Set(text.match(/IMAGE-\w+/g)).size)).toFixed(1)} |`);
    }
}

/** Of each LOD node the texts of its levels, nearest first. Our writer starts each element on a line of its own. */
function sharesIn(text) {
    return text.split('<LOD ').slice(1).map(rest => {
        const body = rest.slice(rest.indexOf('\n') + 1, rest.indexOf('</LOD>'));
        return body.split('</Group>\n').slice(0, -1);
    });
}

function countTriangles(text) {
    let count = 0;
    for (const [, list] of text.matchAll(/coordIndex='([^']*)'/g))
        for (const face of list.split('-1')) count += Math.max(0, face.trim().split(/\s+/).length - 2);
    return count;
}

function sentBytes(group) {
    const quality = { params: { [constants.BROTLI_PARAM_QUALITY]: 6 } }, sizes = [];
    for (let i = 0; i < group.length; i += kSharesInAFile) {
        const file = group.slice(i, i + kSharesInAFile);
        sizes.push(brotliCompressSync(file.join(''), quality).length / file.length);
    }
    return mean(sizes);
}

function mean(numbers) {
    return numbers.reduce((sum, n) => sum + n, 0) / numbers.length;
}
