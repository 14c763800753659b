import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

const kScripts = fileURLToPath(new URL('../../../../client_scripts/', import.meta.url));

/** Files that `file` imports, and what those import. */
function importsOf(file, found = new Set()) {
    for (const [, path] of readFileSync(file, 'utf8').matchAll(/^import .* from '(\..*)';$/gm)) {
        const other = join(dirname(file), path);
        if (!found.has(other)) importsOf(other, found.add(other));
    }
    return found;
}

test('index.html names every module of the page, so that a browser asks for all at once', () => {
    const html = readFileSync(join(kScripts, 'page/index.html'), 'utf8');
    const preloaded = [...html.matchAll(/rel="modulepreload" href="\/client\/(.*?)"/g)].map(([, path]) => path);
    const imported = [...importsOf(join(kScripts, 'page/main.js'))].map(path => relative(kScripts, path));
    assert.deepEqual(preloaded.sort(), imported.sort());
    assert.ok(imported.length > 8);
});
