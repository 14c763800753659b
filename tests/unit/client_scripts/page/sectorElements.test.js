import assert from 'node:assert/strict';
import test from 'node:test';
import { quotedTexts } from '../../../../client_scripts/page/sectorElements.js';

test('texts of an MFString come back without their quotation marks', () => {
    assert.deepEqual(quotedTexts('"a" "Rue de l\'Abreuvoir"'), ['a', 'Rue de l\'Abreuvoir']);
    assert.deepEqual(quotedTexts('"\\"Zum <Löwen> & Co\\"" "back\\\\slash"'), ['"Zum <Löwen> & Co"', 'back\\slash']);
    assert.deepEqual(quotedTexts(''), []);
    assert.deepEqual(quotedTexts('""'), ['']);
});
