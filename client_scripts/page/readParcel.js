const kEnd = '.x3d', kImage = /^textures\/([0-9a-f]+)\.png$/;

/**
 * Reads the answer of /parcels (httpd/parcels.hpp) as it comes. First { bytes: stem -> bytes, missing: stems }, then each file once
 * it is whole: { stem, text, parts: [[name, text], ...], images: [[name, base64], ...] }.
 *
 * `length`: bytes as sent, 0 where nobody tells: then those of the texts count.
 * Fails   Error: it ends too early, or is in another order than it says.
 */
export async function* readParcel(body, length) {
    const lines = linesOf(body), head = (await lines.next()).value;
    if (!head) throw new Error('a parcel is empty');
    const { files, missing } = JSON.parse(head), groups = groupsOf(files), all = files.reduce((sum, [, size]) => sum + size, 0);
    yield { missing, bytes: new Map(groups.map(({ stem, size }) => [stem, (length || all) * size / all])) };
    for (const { stem, names } of groups) {
        const file = { stem, text: null, parts: [], images: [] };
        for (const name of names) {
            const { value: line, done } = await lines.next();
            const [found, text] = done ? [] : JSON.parse(line), image = name.match(kImage)?.[1];
            if (found !== name) throw new Error(`a parcel holds ${found ?? 'nothing more'} where it says that ${name} comes`);
            if (image) file.images.push([image, text]);
            else if (name === stem + kEnd) file.text = text;
            else file.parts.push([name, text]);
        }
        yield file;
    }
}

/** Names in order, by the file that they belong to: its parts and images come behind it. */
function groupsOf(files) {
    const groups = [];
    for (const [name, size] of files) {
        const stem = kImage.test(name) ? groups.at(-1)?.stem : name.slice(0, -kEnd.length).replace(/\.\d+$/, '');
        if (groups.at(-1)?.stem !== stem) groups.push({ stem, names: [], size: 0 });
        groups.at(-1).names.push(name);
        groups.at(-1).size += size;
    }
    return groups;
}

/** Lines of a stream of bytes, as they come. */
async function* linesOf(body) {
    const reader = body.pipeThrough(new TextDecoderStream()).getReader();
    let rest = [];
    for (let next = await reader.read(); !next.done; next = await reader.read()) {
        const pieces = next.value.split('\n');
        rest.push(pieces[0]);
        for (const piece of pieces.slice(1)) {
            yield rest.join('');
            rest = [piece];
        }
    }
    if (rest.join('')) yield rest.join('');
}
