// Does a city answer there? node scripts/check_address.mjs http://127.0.0.1:8080/
// Asks for the page, X_ITE, the root world and the sector it starts in. Exit 1 with the reason when one is missing.
const [origin] = process.argv.slice(2);

async function get(path, part) {
    const response = await fetch(new URL(path, origin));
    const text = await response.text();
    if (!response.ok) throw new Error(`${path}: status ${response.status}`);
    if (!text.includes(part)) throw new Error(`${path}: has no "${part}"`);
    console.log(`check: ${path} ${text.length} characters, ${response.headers.get('content-type')}`);
    return text;
}

try {
    const page = await get('/', '<html');
    const browser = page.match(/["'](\/x_ite\/[^"']+\.m?js)["']/)?.[1];
    if (browser) await get(browser, 'X3D');
    const root = await get('/city.x3d', '<X3D');
    const sector = root.match(/sectors\/[^"'\s.]+\.x3d/)?.[0];
    if (!sector) throw new Error('/city.x3d: names no sector');
    await get(`/${sector}`, '<X3D');
    console.log(`check: ${origin} serves a city`);
} catch (error) {
    console.error(`check: ${origin} does not serve a city: ${error.message}`);
    process.exit(1);
}
