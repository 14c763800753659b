// Draws what `node tests/bench/throttledTour.js ORIGIN soak KM SPEED` prints: the page's heap and the live Shapes over time.
// usage: ... soak 18 5 | node scripts/plot_memory.mjs > docs/pictures/memory.svg
import { readFileSync } from 'node:fs';

const rows = readFileSync(0, 'utf8').split('\n').map(line => line.split('|').slice(1, -1).map(parseFloat)).filter(row => row.length === 7 && !row.some(Number.isNaN));
if (rows.length < 2) {
    console.error('plot_memory: no rows of a table on the standard input: | walked | time | heap | nodes | listeners | files | Shapes |');
    process.exit(2);
}
const kLeft = 56, kRight = 664, kTop = 30, kBottom = 256, kSteps = 5;
const above = values => {
    const most = Math.max(...values), unit = 10 ** Math.floor(Math.log10(most / kSteps));
    return kSteps * unit * [1, 2, 2.5, 5, 10].find(step => kSteps * unit * step >= most);
};
const minutes = rows.map(row => row[1]), heap = rows.map(row => row[2]), shapes = rows.map(row => row[6]);
const mostMinutes = above(minutes), mostHeap = above(heap), mostShapes = above(shapes);
const x = value => (kLeft + (kRight - kLeft) * value / mostMinutes).toFixed(1);
const y = (value, most) => (kBottom - (kBottom - kTop) * value / most).toFixed(1);
const line = (values, most, style) => `<polyline fill="none" ${style} points="${values.map((value, i) => `${x(minutes[i])},${y(value, most)}`).join(' ')}"/>`;
const grid = Array.from({ length: kSteps + 1 }, (_, i) => {
    const up = y(i, kSteps), label = 4 + Number(up);
    return `<path d="M${kLeft} ${up}H${kRight}" stroke="#ddd"/><text x="50" y="${label}" text-anchor="end" fill="#1f5fa8">${mostHeap * i / kSteps}</text>`
        + `<text x="670" y="${label}" fill="#999">${mostShapes * i / kSteps}</text><text x="${x(mostMinutes * i / kSteps)}" y="274" text-anchor="middle">${mostMinutes * i / kSteps}</text>`;
});
console.log(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 720 300" font-family="sans-serif" font-size="12"><rect width="720" height="300" fill="white"/>
${grid.join('\n')}
<text x="360" y="292" text-anchor="middle">minutes</text>
${line(shapes, mostShapes, 'stroke="#bbb" stroke-width="1.5"')}
${line(heap, mostHeap, 'stroke="#1f5fa8" stroke-width="2"')}
<text x="56" y="18" fill="#1f5fa8">heap after garbage collection, MB</text><text x="664" y="18" text-anchor="end" fill="#999">live Shapes</text>
</svg>`);
