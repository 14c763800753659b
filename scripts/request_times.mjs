// How long a server takes to answer for sectors: node scripts/request_times.mjs ADDRESS [REQUESTS]
// One connection, one request after the other, every sector in turn; milliseconds until the last byte.
import http from 'node:http';

const [address, requests = '2000'] = process.argv.slice(2);
if (!address) {
    console.error('usage: node scripts/request_times.mjs ADDRESS [REQUESTS]');
    process.exit(2);
}
const agent = new http.Agent({ keepAlive: true, maxSockets: 1 });

function get(path, headers = {}) {
    return new Promise((resolve, reject) => {
        const began = process.hrtime.bigint();
        http.get(new URL(path, address), { agent, headers }, response => {
            const chunks = [];
            response.on('data', chunk => chunks.push(chunk));
            response.on('end', () => resolve({
                status: response.statusCode, body: Buffer.concat(chunks),
                ms: Number(process.hrtime.bigint() - began) / 1e6,
            }));
        }).on('error', reject);
    });
}

async function sectorIds() {
    const ids = [];
    for (let path = '/collections/sectors/items?limit=1000'; path;) {
        const { body } = await get(path);
        const page = JSON.parse(body);
        ids.push(...page.features.map(feature => feature.id));
        const next = (page.links ?? []).find(link => link.rel === 'next');
        path = next ? next.href : null;
    }
    return ids;
}

const ids = await sectorIds();
for (const [suffix, coding] of [['.x3d', 'br'], ['.x3d', 'gzip'], ['.x3d', 'identity'], ['.json', 'br'], ['.json', 'gzip'],
    ['.wrl', 'br'], ['.wrl', 'gzip'], ['.x3dj', 'gzip']]) {
    const times = [];
    let bytes = 0;
    for (let i = 0; i < Number(requests); ++i) {
        const answer = await get(`/sectors/${ids[i % ids.length]}${suffix}`, { 'Accept-Encoding': coding });
        if (answer.status !== 200) throw new Error(`${ids[i % ids.length]}${suffix}: status ${answer.status}`);
        times.push(answer.ms);
        bytes += answer.body.length;
    }
    times.sort((a, b) => a - b);
    const at = share => times[Math.min(times.length - 1, Math.floor(share * times.length))].toFixed(2);
    console.log(`${suffix} ${coding}: p50 ${at(0.5)} ms, p99 ${at(0.99)} ms, max ${at(1)} ms, ` +
        `${(bytes / times.length / 1000).toFixed(1)} kB`);
}
agent.destroy();
