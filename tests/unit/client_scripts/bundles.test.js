import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';

const kScript = fileURLToPath(new URL('../../../client_scripts/bundle_loader.cmake', import.meta.url));

test('modules laid end to end are one program: no name is there twice', t => {
    const folder = mkdtempSync(join(tmpdir(), 'vicus-bundles-'));
    t.after(() => rmSync(folder, { recursive: true }));
    for (const which of ['loader', 'flyer']) {
        const out = join(folder, `${which}.js`);
        execFileSync('cmake', [`-DOUT=${out}`, `-DWHICH=${which}`, '-P', kScript]);
        assert.doesNotThrow(() => execFileSync(process.execPath, ['--check', out], { stdio: 'pipe' }), which);
    }
});
