// The figures of tests/bench/level_errors.cpp as one picture: error of each level against distance, one panel a city:
//   node scripts/plot_level_errors.mjs OUT.svg NAME=errors.csv ...
// A vertical line stands where a level takes over (x3d_export/house_nodes.hpp).
import { readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

const [out, ...cities] = process.argv.slice(2);
if (!cities.length) {
    console.error('usage: node scripts/plot_level_errors.mjs OUT.svg NAME=errors.csv ...');
    process.exit(2);
}
const header = readFileSync(fileURLToPath(new URL('../x3d_export/house_nodes.hpp', import.meta.url)), 'utf8');
const ranges = header.match(/kLevelRanges_m\[\] = \{([^}]*)\}/)[1].split(',').map(Number);
const kPanel = { width: 300, height: 240, left: 44, top: 30, gap: 26, bottom: 40 };
const kColours = { 1: '#b33a3a', 2: '#c98a1b', 3: '#2f6db3' };
const kMost = 0.5, kNearest = 5, kFarthest = 350;
const x = m => kPanel.width * Math.log(m / kNearest) / Math.log(kFarthest / kNearest);
const y = error => kPanel.height * (1 - Math.min(error, kMost) / kMost);

function rowsOf(path) {
    const [names, ...lines] = readFileSync(path, 'utf8').trim().split('\n').map(line => line.split(','));
    return lines.map(line => Object.fromEntries(names.map((name, i) => [name, Number(line[i])])));
}

const panels = cities.map((city, i) => {
    const [name, path] = city.split('='), rows = rowsOf(path).filter(row => row.from_m > 0 && row.pixels > 500);
    const line = (level, field, dash) => {
        const points = rows.filter(row => row.level === level).map(row => `${x(Math.sqrt(row.from_m * row.to_m)).toFixed(1)},${y(row[field]).toFixed(1)}`);
        return `<polyline points="${points.join(' ')}" fill="none" stroke="${kColours[level]}" stroke-width="1.8"${dash}/>`;
    };
    const ticks = [5, 10, 20, 30, 50, 90, 150, 250].map(m => `<text x="${x(m).toFixed(1)}" y="${kPanel.height + 15}" text-anchor="middle">${m}</text>`);
    const marks = ranges.map(m => `<line x1="${x(m).toFixed(1)}" x2="${x(m).toFixed(1)}" y1="0" y2="${kPanel.height}" stroke="#999" stroke-dasharray="3 3"/>`);
    const levels = [0, 0.1, 0.2, 0.3, 0.4, 0.5].map(v => `<text x="-6" y="${y(v) + 4}" text-anchor="end">${v}</text><line x1="0" x2="${kPanel.width}" y1="${y(v)}" y2="${y(v)}" stroke="#eee"/>`);
    return `<g transform="translate(${kPanel.left + i * (kPanel.width + kPanel.left + kPanel.gap)},${kPanel.top})">
<text x="0" y="-10" font-weight="bold">${name}</text>${levels.join('')}${marks.join('')}
<rect width="${kPanel.width}" height="${kPanel.height}" fill="none" stroke="#444"/>
${[1, 2, 3].map(level => line(level, 'flip', '') + line(level, 'pop', ' stroke-dasharray="5 4" opacity="0.7"')).join('\n')}
${ticks.join('')}<text x="${kPanel.width / 2}" y="${kPanel.height + 32}" text-anchor="middle">metres</text></g>`;
});
const width = kPanel.left + cities.length * (kPanel.width + kPanel.left + kPanel.gap), height = kPanel.top + kPanel.height + kPanel.bottom + 18;
const legend = [1, 2, 3].map((level, i) => `<text x="${kPanel.left + 95 * i}" y="${height - 6}" fill="${kColours[level]}">level ${level}</text>`).join('')
    + `<text x="${kPanel.left + 300}" y="${height - 6}">FLIP against level 4; dashed: against the next finer level</text>`;
writeFileSync(out, `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" font-family="sans-serif" font-size="11">
<rect width="100%" height="100%" fill="#fff"/>
${panels.join('\n')}
${legend}
</svg>
`);
