import { recordFromMetadata } from '../core/recordMetadata.js';

/** The record in a sector's elements (an XML document, or an Inline of X3DOM), or null where there is none. */
export function recordOfElements(root) {
    const metadata = root.querySelector('[DEF="RECORD"]');
    return metadata ? recordFromMetadata(metadataTree(metadata)) : null;
}

/** The triangles of the ground in plan millimetres, for GroundHeights; null where the file has none. A large ground comes in slices. */
export function groundOfElements(root, origin) {
    const slices = root.querySelectorAll('[DEF^="GROUND"] > IndexedFaceSet, [DEF^="GROUND"] > indexedfaceset');
    const numbers = (node, name) => (node?.getAttribute(name) ?? '').trim().split(/[\s,]+/).map(Number);
    const points = [], triangles = [];
    for (const geometry of origin ? slices : []) {
        const coordinates = numbers(geometry.querySelector('Coordinate, coordinate'), 'point'), first = points.length;
        for (let i = 0; i + 2 < coordinates.length; i += 3)
            points.push([1000 * (origin[0] + coordinates[i]), 1000 * (origin[1] - coordinates[i + 2]), 1000 * coordinates[i + 1]]);
        for (const index of numbers(geometry, 'coordIndex')) if (index >= 0) triangles.push(first + index);
    }
    return points.length < 3 ? null : { points, triangles };
}

/** Metadata elements -> { name, value } as recordFromMetadata reads them. */
function metadataTree(node) {
    const name = node.getAttribute('name'), text = node.getAttribute('value') ?? '';
    if (node.localName.toLowerCase() === 'metadataset') return { name, value: [...node.children].map(metadataTree) };
    const isText = node.localName.toLowerCase() === 'metadatastring';
    return { name, value: isText ? quotedTexts(text) : text.trim().split(/[\s,]+/).map(Number) };
}

/** MFString as XML has it: quoted texts, a backslash before quotation marks and backslashes inside. */
export function quotedTexts(text) {
    return [...text.matchAll(/"((?:[^"\\]|\\.)*)"/g)].map(([, inner]) => inner.replace(/\\(.)/g, '$1'));
}
