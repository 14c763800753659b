import { readNumbersQuickly } from './quickFaces.js';

/** ms of a slice. The browser's own idle time is no measure: where the graphics card is behind, it has none for seconds, though the
    page does nothing. */
const kSliceMs = 6;

/**
 * Nodes of an X3D document, made slice by slice between frames: X_ITE's own way makes a whole file at once, 40 ms for 100 kB on a
 * fast machine, in which nothing moves. By X_ITE 15.0.1's own XML parser, one child of Scene at a time, of an
 * LOD one level.
 *
 * `signal`: gives it up. `turn()`: a promise of when the next slice ends.
 * Returns the scene, live, its images perhaps on their way. Fails   Error: no X3D, or given up.
 */
export async function readScene({ X3D, browser }, document, { signal, turn = nextTurn } = {}) {
    const children = sceneOf(document), scene = await emptyScene(browser, document.documentElement);
    const Parser = X3D.require('XMLParser'), parser = new Parser(scene);
    readNumbersQuickly(parser);
    parser.setInput(document);
    parser.pushExecutionContext(scene);
    let end = await turn();
    const read = async (child, parent) => {
        if (signal?.aborted) throw new Error('given up');
        if (performance.now() >= end) end = await turn();
        if (parent) parser.pushParent(parent);
        parser.childElement(child);
        if (parent) parser.popParent();
        parser.setupNodes();
    };
    for (const child of children) {
        if (child.nodeName !== 'LOD') await read(child);
        else {
            await read(child.cloneNode(false));
            const lod = scene.rootNodes.at(-1).getValue();
            for (const level of [...child.children]) await read(level, lod);
        }
    }
    return scene;
}

/** With the profile and components that the document names; addresses in it are relative to the browser's base. */
async function emptyScene(browser, root) {
    const components = [...root.querySelectorAll('head > component')].map(node => browser.getComponent(node.getAttribute('name'), Number(node.getAttribute('level'))));
    const scene = await browser.createScene(browser.getProfile(root.getAttribute('profile')), ...components);
    scene.setWorldURL(browser.getBaseURL());
    return scene;
}

function sceneOf(document) {
    const scene = document.querySelector('X3D > Scene');
    if (!scene) throw new Error(`no X3D file: ${document.documentElement.textContent.slice(0, 100)}`);
    return [...scene.children];
}

/** As soon as frames, clicks and keys that wait have had their turn. */
export function nextTurn() {
    return new Promise(resolve => {
        const { port1, port2 } = new MessageChannel();
        port1.onmessage = () => {
            port1.close();
            resolve(performance.now() + kSliceMs);
        };
        port2.postMessage(null);
    });
}
