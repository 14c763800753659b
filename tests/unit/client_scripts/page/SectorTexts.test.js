import assert from 'node:assert/strict';
import test from 'node:test';
import { SectorTexts } from '../../../../client_scripts/page/SectorTexts.js';
import { readParcel } from '../../../../client_scripts/page/readParcel.js';
import { seededRandom } from '../../../support/random.js';

/** Files of a server: name -> text; an image's text is base64. What comes behind a near file is given with it. */
const kFiles = {
    'a.x3d': "<i url='../textures/aa11.png'/>", 'textures/aa11.png': 'AAAA', 'a.1.x3d': "é<i url='../textures/bb22.png'/>",
    'textures/bb22.png': 'BBBB', 'b.far.x3d': '<b/>', 'c.tall.x3d': '<c/>',
};
const kOf = { a: ['a.x3d', 'textures/aa11.png', 'a.1.x3d', 'textures/bb22.png'], 'b.far': ['b.far.x3d'], 'c.tall': ['c.tall.x3d'] };

function parcelFor(url) {
    const { searchParams } = new URL(url, 'http://here'), stems = searchParams.get('files').split(','), without = searchParams.get('without').split(',');
    const names = stems.flatMap(stem => kOf[stem] ?? []).filter(name => !without.some(begin => begin && name.startsWith(`textures/${begin}`)));
    const size = name => Buffer.byteLength(kFiles[name]);
    return [{ files: names.map(name => [name, size(name)]), missing: stems.filter(stem => !kOf[stem]) }, ...names.map(name => [name, kFiles[name]])]
        .map(line => `${JSON.stringify(line)}\n`).join('');
}

/** Bytes in chunks as a line brings them: anywhere, also within a letter. */
function streamOf(text, sizes) {
    const bytes = new TextEncoder().encode(text), body = new TransformStream(), writer = body.writable.getWriter();
    (async () => {
        for (let at = 0; at < bytes.length;) {
            const size = sizes();
            await writer.write(bytes.slice(at, at + size));
            at += size;
        }
        await writer.close();
    })().catch(() => {});
    return body.readable;
}

function server({ textOf = parcelFor, status = 200, mostKept } = {}) {
    const asked = [], told = [], signals = [];
    const request = async (url, { signal }) => {
        asked.push(url);
        signals.push(signal);
        const text = textOf(url);
        return { ok: status === 200, status, url: '', text: async () => text, body: streamOf(text, () => 7), headers: { get: () => String(text.length) } };
    };
    const texts = new SectorTexts('sectors/', { parcels: '/parcels', request, clock: () => 0, told: bytes => told.push(bytes), mostKept });
    return { asked, told, signals, texts };
}

const free = () => new AbortController().signal;

test('what is asked for in a frame comes by one request, with parts and images', async () => {
    const { asked, told, texts } = server(), sizes = new Map();
    const files = ['a', 'b.far'].map(stem => texts.get(stem, { signal: free(), sized: bytes => sizes.set(stem, bytes) }));
    assert.equal(asked.length, 0);
    texts.send();
    texts.send();
    const [a, b] = await Promise.all(files);
    assert.deepEqual(asked, ['/parcels?files=a,b.far&without=']);
    assert.match(a.text, /^<i url='blob:/);
    assert.equal(a.parts[0][0], 'a.1.x3d');
    assert.match(a.parts[0][1], /^é<i url='blob:/);
    assert.equal(b.text, '<b/>');
    assert.ok(Math.abs(a.bytes + b.bytes - parcelFor(asked[0]).length) < 1e-6, 'what was sent is shared out among the files');
    assert.deepEqual([...sizes.values()], [a.bytes, b.bytes]);
    await new Promise(resolve => setTimeout(resolve));
    assert.equal(told.length, 1);
});

test('who comes back is asked for nothing, and images that are here are not sent again', async () => {
    const { asked, texts } = server();
    const get = async stem => {
        const file = texts.get(stem, { signal: free() });
        texts.send();
        return file;
    };
    const first = await get('a'), again = await get('a');
    assert.deepEqual([again.text, again.parts, again.bytes], [first.text, first.parts, 0]);
    await get('b.far');
    assert.deepEqual(asked, ['/parcels?files=a&without=', '/parcels?files=b.far&without=aa11,bb22']);
});

test('an image that every file shows stays among those that parcels need not bring', async () => {
    const { texts } = server(), name = i => i.toString(16).padStart(16, '0');
    texts.keepImage('abcdef0123456789', 'AA==');
    for (let i = 0; i < 300; ++i) {
        texts.keepImage(name(i), 'AA==');
        texts.withImages({ text: "<i url='../textures/abcdef0123456789.png'/>", parts: [] });
    }
    const without = texts.urlFor([{ stem: 'a' }]).split('without=')[1].split(',');
    assert.ok(without.includes('abcdef01'));
    assert.equal(without.length, 120);
});

test('an image that two parcels bring has one address', async () => {
    const { texts } = server({ mostKept: 1 }), files = [];
    for (let i = 0; i < 2; ++i) {
        files.push(texts.get('a', { signal: free() }));
        texts.send();
    }
    const [first, second] = await Promise.all(files);
    assert.equal(first.text, second.text);
    assert.match(first.text, /blob:/);
});

test('texts are kept up to a length, the latest used', async () => {
    const { asked, texts } = server({ mostKept: 9 });
    for (const stem of ['b.far', 'c.tall', 'b.far', 'a', 'b.far', 'a']) {
        const file = texts.get(stem, { signal: free() });
        texts.send();
        await file;
    }
    assert.deepEqual(asked.map(url => url.match(/files=([^&]*)/)[1]), ['b.far', 'c.tall', 'a', 'b.far', 'a']);
    assert.ok(texts.keptLength > 9, 'a single long one is kept all the same');
});

test('a file that there is none of fails alone; a parcel that ends too early fails what has not come', async () => {
    const { texts } = server(), files = ['gone', 'b.far'].map(stem => texts.get(stem, { signal: free() }));
    texts.send();
    await assert.rejects(files[0], /gone.x3d: there is none/);
    assert.equal((await files[1]).text, '<b/>');
    const cut = server({ textOf: url => parcelFor(url).split('\n').slice(0, 2).join('\n') });
    const two = ['b.far', 'c.tall'].map(stem => cut.texts.get(stem, { signal: free() }));
    cut.texts.send();
    assert.equal((await two[0]).text, '<b/>');
    await assert.rejects(two[1], /holds nothing more where it says that c.tall.x3d comes/);
    const refused = server({ status: 404 }), one = refused.texts.get('a', { signal: free() });
    refused.texts.send();
    await assert.rejects(one, /404/);
});

test('a parcel is given up when nobody wants any of it, no sooner', async () => {
    const { signals, texts } = server(), aborts = [new AbortController(), new AbortController()];
    const files = ['a', 'b.far'].map((stem, i) => texts.get(stem, { signal: aborts[i].signal }));
    texts.send();
    aborts[0].abort();
    assert.equal(signals[0].aborted, false);
    await assert.rejects(files[0], /a was given up/);
    aborts[1].abort();
    assert.equal(signals[0].aborted, true);
    await assert.rejects(files[1], /given up/);
});

test('without parcels each file comes by itself', async () => {
    const { asked, texts } = server({ textOf: () => '<x/>' });
    texts.parcels = null;
    assert.deepEqual(await texts.get('a', { signal: free() }), { text: '<x/>', parts: [], bytes: 4 });
    assert.equal((await texts.get('a', { signal: free() })).bytes, 0);
    assert.deepEqual(asked, ['sectors/a.x3d']);
});

test('a parcel reads the same however the line cuts it', async () => {
    const text = parcelFor('/parcels?files=a,b.far,nix,c.tall&without=');
    const read = async sizes => {
        const parts = [];
        for await (const part of readParcel(streamOf(text, sizes), text.length)) parts.push(part);
        return parts;
    };
    const whole = await read(() => text.length * 2);
    assert.deepEqual(whole.slice(1).map(({ stem }) => stem), ['a', 'b.far', 'c.tall']);
    assert.deepEqual(whole[0].missing, ['nix']);
    for (let seed = 1; seed <= 50; ++seed) {
        const random = seededRandom(seed);
        assert.deepEqual(await read(() => 1 + Math.floor(random() * 20)), whole, `seed ${seed}`);
    }
});
