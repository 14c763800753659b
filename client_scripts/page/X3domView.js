import { axisAngle } from './axisAngle.js';

const kTries = 200, kPause = 50;

/**
 * X3DOM's scene and eye for the page.
 *
 * Frame   poses as XIteAdapter has them: { east, north, up } in plan metres, heading and pitch in radians.
 */
export class X3domView {
    /** Shows what /city.x3d draws in `window`. Fails   Error: X3DOM does not start. */
    static async create(window, { text }) {
        const root = new DOMParser().parseFromString(text, 'application/xml'), scene = document.createElement('scene');
        const first = root.querySelector('Viewpoint');
        for (const node of root.querySelectorAll('Scene > *'))
            if (!/^(WorldInfo|Viewpoint)$/.test(node.localName)) scene.append(document.importNode(node, true));
        for (const node of scene.querySelectorAll('NavigationInfo')) node.setAttribute('type', '"NONE"');
        const eye = document.createElement('viewpoint');
        for (const name of ['position', 'orientation', 'fieldOfView']) if (first.hasAttribute(name)) eye.setAttribute(name, first.getAttribute(name));
        eye.setAttribute('zNear', '0.1');
        eye.setAttribute('zFar', '4000');
        scene.append(eye);
        const x3d = document.createElement('x3d');
        for (const [name, value] of [['width', '100%'], ['height', '100%'], ['showStat', 'false'], ['showLog', 'false'], ['disableKeys', 'true']])
            x3d.setAttribute(name, value);
        x3d.append(scene);
        window.prepend(x3d);
        globalThis.x3dom.reload();
        for (let i = 0; !x3d.runtime?.canvas; ++i) {
            if (i === kTries) throw new Error('X3DOM does not start. Does this browser have WebGL?');
            await new Promise(resolve => { setTimeout(resolve, kPause); });
        }
        return new X3domView(x3d, scene, eye);
    }

    constructor(x3d, scene, eye) {
        Object.assign(this, { x3d, eye, world: scene.querySelector('[DEF="WORLD"]') });
        const [x, y, z] = numbersOf(eye, 'position', [0, 1.7, 0]), [, ay, , angle] = numbersOf(eye, 'orientation', [0, 1, 0, 0]);
        this.at = { east: x, north: -z, up: y, heading: ay < 0 ? angle : -angle, pitch: 0 };
    }

    pose() {
        return { ...this.at };
    }

    setPose(pose) {
        this.at = { ...pose };
        this.eye.setAttribute('position', `${pose.east} ${pose.up} ${-pose.north}`);
        this.eye.setAttribute('orientation', axisAngle(pose.heading, pose.pitch).join(' '));
    }
}

function numbersOf(node, name, otherwise) {
    const numbers = (node.getAttribute(name) ?? '').trim().split(/\s+/).map(Number);
    return numbers.length === otherwise.length && numbers.every(Number.isFinite) ? numbers : otherwise;
}
