/** ms: of a slice where the browser does not say how long it has time. */
const kSliceMs = 8;
/** ms after which a slice is due even though the browser has no time. */
const kPatienceMs = 60;

/**
 * Nodes of an X3D document, made slice by slice between frames: X_ITE's own way makes a whole file at once, 40 ms for 100 kB on a
 * fast machine, in which nothing moves. By X_ITE 15.0.1's own XML parser, one child of Scene at a time.
 *
 * `signal`: gives it up. `turn()`: a promise of the time of a slice, { timeRemaining() }.
 * Returns the scene, live, its images perhaps on their way. Fails   Error: no X3D, or given up.
 */
export async function readScene({ X3D, browser }, document, { signal, turn = idleTurn } = {}) {
    const head = document.cloneNode(false), root = document.documentElement, children = sceneOf(document);
    head.append(skeletonOf(head, root));
    const scene = await browser.createX3DFromString(new XMLSerializer().serializeToString(head));
    const Parser = X3D.require('XMLParser'), parser = new Parser(scene);
    parser.setInput(document);
    parser.pushExecutionContext(scene);
    let deadline = await turn();
    for (const child of children) {
        if (signal?.aborted) throw new Error('given up');
        if (deadline.timeRemaining() <= 0) deadline = await turn();
        parser.childElement(child);
        parser.setupNodes();
    }
    return scene;
}

/** X3D, head and an empty Scene. */
function skeletonOf(document, root) {
    const skeleton = document.importNode(root, false), head = root.querySelector('head');
    if (head) skeleton.append(document.importNode(head, true));
    skeleton.append(document.createElement('Scene'));
    return skeleton;
}

function sceneOf(document) {
    const scene = document.querySelector('X3D > Scene');
    if (!scene) throw new Error(`no X3D file: ${document.documentElement.textContent.slice(0, 100)}`);
    return [...scene.children];
}

/** The next time that the browser has nothing better to do. */
function idleTurn() {
    return new Promise(resolve => {
        if (globalThis.requestIdleCallback) requestIdleCallback(deadline => resolve(sliceFrom(deadline)), { timeout: kPatienceMs });
        else setTimeout(() => resolve(sliceFrom({ timeRemaining: () => kSliceMs })));
    });
}

/** Ends with the browser's idle time, after kSliceMs at the latest; where there is no idle time, too. */
function sliceFrom(idle) {
    const end = performance.now() + kSliceMs;
    const hasTime = idle.didTimeout ? () => true : () => idle.timeRemaining() > 0;
    return { timeRemaining: () => (hasTime() ? end - performance.now() : 0) };
}
