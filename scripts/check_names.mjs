// Fails where a type's name is defined twice in namespace vicus: C++ then takes one for the other, without a word.
//   node scripts/check_names.mjs
// Indentation is clang-format's: types of a namespace begin in the first column.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';

const root = fileURLToPath(new URL('..', import.meta.url));
const folders = ['city_db', 'sectorgen', 'x3d_export', 'httpd', 'cli', 'tests'];
const places = new Map();   // 'vicus Segment' -> files
for (const file of folders.flatMap(sourcesIn)) for (const name of typesIn(file)) places.set(name, (places.get(name) ?? new Set()).add(file));

const twice = [...places].filter(([, files]) => files.size > 1);
for (const [name, files] of twice) console.error(`error: ${name} is defined in ${[...files].join(' and ')}`);
console.log(`names: ${places.size} types, ${twice.length} defined twice`);
process.exit(twice.length ? 1 : 0);

function sourcesIn(folder) {
    return readdirSync(join(root, folder), { recursive: true }).filter(name => /\.[ch]pp$/.test(name)).map(name => join(folder, name));
}

/** Types that a file defines in named namespaces, with these; those of unnamed ones are the file's own. */
function typesIn(file) {
    const open = [], found = [];
    for (const line of readFileSync(join(root, file), 'utf8').split('\n')) {
        const namespace = line.match(/^namespace ([\w:]*) ?\{/);
        if (namespace) open.push(namespace[1]);
        else if (line.startsWith('}  // namespace')) open.pop();
        const type = line.match(/^(?:struct|class|union|enum class|enum) (\w+)(?: final)?(?: :.*)? \{/);
        if (type && !open.includes('')) found.push(`${open.join('::')}::${type[1]}`);
    }
    return found;
}
