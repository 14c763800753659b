import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

const kScripts = fileURLToPath(new URL('../../../../client_scripts/', import.meta.url));

const folder = mkdtempSync(join(tmpdir(), 'vicus-page-')), text = name => readFileSync(join(folder, name), 'utf8');
execFileSync('cmake', [`-DOUT=${folder}`, '-P', join(kScripts, 'bundle_page.cmake')]);
test.after(() => rmSync(folder, { recursive: true }));

/** What a bundle asks for by itself, before somebody flies. */
const importsOf = program => [...program.matchAll(/(?:\bfrom|\bimport)\s*"(\.[^"]*)"/g)].map(([, path]) => path);

test('the page is few files: one program and one style sheet, each without imports of its own', () => {
    const made = readdirSync(folder);
    for (const name of ['main.js', 'x3domMain.js']) {
        assert.deepEqual(importsOf(text(name)), [], name);
        assert.match(text(name), /^\/\* Vicus, MIT licence/, name);
    }
    assert.ok(!text('page.css').includes('@import'));
    for (const html of ['index.html', 'x3dom.html'])
        for (const [, name] of readFileSync(join(kScripts, 'page', html), 'utf8').matchAll(/"\/client\/bundle\/(.*?)"/g))
            assert.ok(made.includes(name), `${html} names ${name}`);
});

test('what flying takes comes only when somebody flies, with the worker beside it', () => {
    const [shared] = importsOf(text('flightParts.js'));
    assert.match(text('main.js'), /import\("\.\/flightParts\.js"\)/);
    assert.deepEqual(importsOf(text('tileWorker.js')), [shared]);
    assert.deepEqual(importsOf(text(shared)), []);
    assert.ok(text('main.js').length > 50_000 && text('main.js').length < 150_000, `${text('main.js').length} bytes`);
});
