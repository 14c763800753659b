import { paintDoor } from '../core/Doors.js';
import { fadeImpostor } from '../core/GateImpostors.js';
import { steadyLevel } from '../core/steadyLevel.js';
import { axisAngle } from './axisAngle.js';
import { calmGl } from './calmGl.js';
import { buildQuickly } from './quickFaces.js';
import { groundOfElements, recordOfElements } from './sectorElements.js';
import { nextTurn, readScene } from './slicedScene.js';

const kXIteUrl = '/x_ite/15.0.1/dist/x_ite.min.mjs';
/** m: radius (twice the near plane), eye, step. */
const kFlyingAvatar = [4, 1.7, 0.4];
const kPictures = {
    open: bytes => URL.createObjectURL(new Blob([bytes], { type: 'image/webp' })),
    close: address => URL.revokeObjectURL(address),
};
const kWhite = 'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGP4DwABAQEAsTj2FAAAAABJRU5ErkJggg==';
const kSpeck = `<IndexedFaceSet coordIndex='0 1 2 -1 0 1 2 -1'><Coordinate point='0 0 0 1e-4 0 0 0 1e-4 0'/></IndexedFaceSet>`;
/** As sector files have them: plain, with a colour for each face, under an image. */
const kSpecks = `<X3D profile='Interchange' version='4.0'><Scene><Transform>
    <Shape><Appearance><Material/></Appearance>${kSpeck}</Shape>
    <Shape><Appearance><Material/></Appearance>${kSpeck.replace('><C', ` colorPerVertex='false' colorIndex='0 1'><Color color='1 1 1 0 0 0'/><C`)}</Shape>
    <Shape><Appearance><Material/><ImageTexture url='"${kWhite}"'/></Appearance>${kSpeck}</Shape>
</Transform></Scene></X3D>`;
/** ms after a sector went: by then a frame without it has been drawn. */
const kLetGoMs = 1000;
const kTypesToSwallow = ['mousedown', 'mousewheel', 'wheel', 'touchstart', 'dblclick', 'contextmenu', 'keydown'];

/**
 * Everything the page asks of X_ITE beyond the X3D standard. Written for X_ITE 15.0.1: the user's offsets
 * (getUserPosition, ...) and the load states are that version's own; so is what slicedScene.js, calmGl.js and
 * quickFaces.js do.
 *
 * Frame   poses: { east, north, up } in plan metres of the eye, heading and pitch in radians, heading clockwise from
 *         north, pitch up. The root world's axes are x = east, y = up, z = -north.
 */
export class XIteAdapter {
    /** `canvas`: the x3d-canvas element. Its own mouse and key handling is put to sleep: the page steers. */
    static async create(canvas) {
        const { default: X3D } = await import(kXIteUrl);
        await new Promise((resolve, reject) => X3D(resolve, reject));
        const swallow = event => event.stopPropagation();
        for (const type of kTypesToSwallow) canvas.addEventListener(type, swallow, { capture: true, passive: true });
        canvas.tabIndex = -1;   // the window around it has the focus and the keys
        const view = new XIteAdapter(X3D, canvas);
        withoutTangents(view.browser.currentScene);
        const prototypeOf = type => Object.getPrototypeOf(view.browser.currentScene.createNode(type).getValue());
        calmGl(view.browser, prototypeOf('ImageTexture'));
        buildQuickly(prototypeOf('IndexedFaceSet'));
        return view;
    }

    constructor(X3D, canvas) {
        this.X3D = X3D;
        this.canvas = canvas;
        this.browser = canvas.browser;
        this.records = new WeakMap();   // scene -> its record
        this.leaving = [];   // Transforms that go in this frame
    }

    /**
     * Shows the world and takes its navigation: the page moves the eye. X_ITE's own gravity draws the world into a depth
     * buffer and waits for it, each frame. `base`: what addresses in sectors' files are relative to.
     *
     * Fails   Error: the world cannot be read.
     */
    async show(text, base) {
        await this.browser.replaceWorld(await this.browser.createX3DFromString(text));
        this.browser.baseURL = base;
        steadyLevels(this.browser.currentScene);
        const navigation = this.browser.activeNavigationInfo;
        if (navigation) navigation.type = new this.X3D.MFString('NONE');
        await this.warmShaders();
    }

    /**
     * Draws a speck of each kind of Shape while the first files are on their way: a shader is made when the first Shape needs it,
     * and the frame waits for that. fill() takes the specks away.
     */
    async warmShaders() {
        const { SFVec3f } = this.X3D, { east, north, up, heading } = this.pose();
        const specks = (await this.browser.createX3DFromString(kSpecks)).rootNodes[0];
        specks.translation = new SFVec3f(east + 2 * Math.sin(heading), up, -north - 2 * Math.cos(heading));
        this.browser.currentScene.rootNodes.push(specks);
        this.specks = specks;
    }

    /** A place for a sector's file in the world: Transform (the sector's origin) > Inline that fetches nothing itself. */
    place(origin) {
        const scene = this.browser.currentScene, transform = scene.createNode('Transform'), inline = scene.createNode('Inline');
        inline.load = false;
        transform.translation = new this.X3D.SFVec3f(origin[0], 0, -origin[1]);
        transform.children[0] = inline;
        const { children } = scene.getNamedNode('WORLD');
        children[children.length] = transform;
        return { transform, inline };
    }

    /**
     * The scene that a sector's file describes, its images loaded; `parts`: [name, text] of those of its Inlines that are at hand.
     * Made between frames, slice by slice. Fails   Error: it cannot be read, or `signal` gave it up.
     */
    async makeScene(text, parts = [], signal = null) {
        await nextTurn();
        const document = parsed(text), names = new Set(parts.map(([name]) => name));
        for (const inline of document.querySelectorAll('Inline')) if (names.has(nameOf(inline))) inline.setAttribute('load', 'false');
        const scene = await readScene(this, document, { signal }), scenes = [scene];
        await nextTurn();
        this.records.set(scene, recordIn(document));
        const inlines = Array.from(scene.rootNodes).filter(node => node?.getNodeTypeName() === 'Inline');
        for (const [name, part] of parts) {
            await nextTurn();
            scenes.push(await readScene(this, parsed(part), { signal }));
            inlines.find(({ url }) => url[0] === name).getValue().setInternalScene(scenes.at(-1));
        }
        await Promise.all(scenes.map(allLoaded));
        return scene;
    }

    fill({ inline }, scene) {
        const { currentScene } = this.browser;
        if (this.specks) currentScene.rootNodes = new this.X3D.MFNode(...Array.from(currentScene.rootNodes).filter(node => node !== this.specks));
        this.specks = null;
        inline.getValue().setInternalScene(scene);
    }

    /** Taken out before the frame is drawn, all that go in it at once: each change of a list of nodes tells every node of it. */
    empty({ transform, inline }) {
        inline.getValue().requestUnload();
        if (this.leaving.push(transform) === 1) queueMicrotask(() => this.takeOut());
        this.letting ??= setTimeout(() => {
            this.letting = null;
            this.letGo();
        }, kLetGoMs);
    }

    takeOut() {
        const world = this.browser.currentScene.getNamedNode('WORLD'), leaving = new Set(this.leaving.splice(0));
        world.children = new this.X3D.MFNode(...Array.from(world.children).filter(node => !leaving.has(node)));
    }

    /** X_ITE keeps a place for each Shape that it ever drew at a time, and in it the last Shape, whose whole scene then stays. */
    letGo() {
        const { layer0: layer } = this.browser.getWorld();
        for (const kind of ['opaque', 'transparent', 'pointing', 'collision']) {
            const places = layer[`${kind}Shapes`], used = layer[`num${kind[0].toUpperCase()}${kind.slice(1)}Shapes`];
            if (places?.length > used) places.length = used;
        }
    }

    /** The record in a sector's scene, with the triangles of its ground as `surface`; or null. */
    recordOf(scene) {
        return this.records.get(scene);
    }

    /** How much the picture in a gate shows, 0 ... 1. */
    setImpostor(scene, gate, opacity) {
        fadeImpostor(scene.getNamedNode(`IMPOSTOR-${gate}`), opacity);
    }

    /** How much the picture around an open sector shows, 0 ... 1. */
    setPanorama(scene, opacity) {
        fadeImpostor(scene.getNamedNode('PANORAMA'), opacity);
    }

    /** Opens a door and lights what is behind it, as core/Doors has it. */
    setDoor(scene, door, look) {
        const { SFRotation, SFColor } = this.X3D;
        paintDoor(door, look, { find: name => scene.getNamedNode(name), rotation: (...v) => new SFRotation(...v), color: (...v) => new SFColor(...v) });
    }

    /** s: when a door was clicked last, 0: never. */
    touchTime(scene, door) {
        return scene.getNamedNode(`DOOR-TOUCH-${door}`).touchTime;
    }

    /** [{ name, east, north, heading }] in a sector's scene, `origin` its place in plan. */
    viewpointsOf(scene, [east, north]) {
        const nodes = Array.from(scene.rootNodes).filter(node => node?.getNodeTypeName() === 'Viewpoint');
        return nodes.map(({ description, position: p, orientation: turn }) => {
            const ahead = turn.multVec(new this.X3D.SFVec3f(0, 0, -1));
            return { name: description, east: east + p.x, north: north - p.z, heading: Math.atan2(ahead.x, -ahead.z) };
        });
    }

    /**
     * A stage for core/Flyover: its Group in the world, the shaders of `world` (/flyover.x3d). `layout`: of ground tiles.
     * Fails   Error: there is no such shader in it.
     */
    async makeTileStage(world, layout) {
        const xml = new DOMParser().parseFromString(world, 'application/xml'), found = xml.querySelectorAll('ComposedShader[DEF]');
        if (found.length !== 2) throw new Error('The world from above has not the two shaders for its tiles.');
        for (const part of xml.querySelectorAll('ShaderPart')) {
            const [path] = part.getAttribute('url').match(/[^"]+/);
            part.setAttribute('url', `"${new URL(path, document.baseURI).href}"`);
        }
        const texts = [...found].map(shader => `<Shape><Appearance>${new XMLSerializer().serializeToString(shader)}</Appearance></Shape>`);
        const scene = await this.browser.createX3DFromString(`<X3D profile='Interchange' version='4.0'><head>
            <component name='Shaders' level='1'/></head><Scene>${texts.join('')}</Scene></X3D>`);
        const [tiles, blockMaps] = [0, 1].map(i => scene.rootNodes[i].appearance.shaders[0]);
        const group = this.browser.currentScene.createNode('Group');
        this.browser.currentScene.rootNodes.push(group);
        const { TileShapes } = await import('./flightParts.js');
        return new TileShapes({ scene: this.browser.currentScene, group, shaders: { tiles, blockMaps },
            types: this.X3D, pictures: kPictures, beyond: layout.GROUND_BEYOND_CITY });
    }

    /** The sectors are seen, or rest. Who flies is far from everything: depth is told apart better with a far near plane. */
    showSectors(isShown) {
        this.browser.currentScene.getNamedNode('WORLD').visible = isShown;
        const navigation = this.browser.activeNavigationInfo;
        this.avatar ??= Array.from(navigation.avatarSize);
        navigation.avatarSize = new this.X3D.MFFloat(...(isShown ? this.avatar : kFlyingAvatar));
    }

    /** CSS pixels, width and height. */
    size() {
        return [this.canvas.clientWidth, this.canvas.clientHeight];
    }

    pose() {
        const view = this.browser.activeViewpoint.getValue(), p = view.getUserPosition();
        const ahead = view.getUserOrientation().multVecRot(new this.X3D.SFVec3f(0, 0, -1).getValue());
        const heading = Math.atan2(ahead.x, -ahead.z), pitch = Math.asin(clampUnit(ahead.y));
        return { east: p.x, north: -p.z, up: p.y, heading, pitch };
    }

    /** Moves the eye without a transition. */
    setPose({ east, north, up, heading, pitch }) {
        const view = this.browser.activeViewpoint.getValue(), { SFVec3f, SFRotation } = this.X3D;
        view.setUserPosition(new SFVec3f(east, up, -north).getValue());
        view.setUserOrientation(new SFRotation(...axisAngle(heading, pitch)).getValue());
    }

    /** rad, of the smaller side of the view. */
    fieldOfView() {
        return this.browser.activeViewpoint.fieldOfView;
    }

    /** What a click does where the pointer is: a lamp's TouchSensor, a sign's Anchor. True when something was there. */
    tap(event) {
        const { x, y } = this.browser.getPointerFromEvent(event);
        if (!this.browser.buttonPressEvent(x, y)) return false;
        this.browser.buttonReleaseEvent();
        return true;
    }

    /** Pixels drawn per CSS pixel. */
    setContentScale(scale) {
        this.browser.setBrowserOption('ContentScale', scale);
    }

    /** Does a program draw instead of a graphics card? */
    isSoftwareRenderer() {
        const gl = this.browser.getContext?.() ?? this.canvas.shadowRoot?.querySelector('canvas')?.getContext('webgl2');
        const info = gl?.getExtension('WEBGL_debug_renderer_info');
        return info ? /swiftshader|llvmpipe|software/i.test(gl.getParameter(info.UNMASKED_RENDERER_WEBGL)) : false;
    }

    /** Is nothing on its way? */
    isIdle() {
        return this.browser._loadCount.getValue() === 0;
    }
}

function parsed(text) {
    return new DOMParser().parseFromString(text, 'application/xml');
}

/** What an Inline names first. */
function nameOf(inline) {
    return inline.getAttribute('url')?.match(/"([^"]*)"/)?.[1];
}

function recordIn(document) {
    try {
        const record = recordOfElements(document);
        return record && Object.assign(record, { surface: groundOfElements(document, record.origin) });
    } catch {
        return null;   // SectorLoader says of which file
    }
}

const kLookAgainMs = 20;

/** Its images have come, or could not be had. */
async function allLoaded(scene) {
    while (scene._loadCount.getValue() > 0) await new Promise(resolve => setTimeout(resolve, kLookAgainMs));
}

function clampUnit(value) {
    return Math.min(1, Math.max(-1, value));
}

/** X3D's LOD changes level exactly at its range; here all LOD nodes keep their level near a threshold. */
function steadyLevels(scene) {
    const prototype = Object.getPrototypeOf(scene.createNode('LOD').getValue());
    if (prototype.hasSteadyLevels) return;
    const plainLevel = prototype.getLevel;
    prototype.hasSteadyLevels = true;
    prototype.getLevel = function (modelViewMatrix) {
        if (this._range.length === 0) return plainLevel.call(this, modelViewMatrix);
        const distance = modelViewMatrix.translate(this._center.getValue()).origin.norm();
        return steadyLevel(Array.from(this._range), this._level_changed.getValue(), distance);
    };
}

/** X_ITE makes tangents for every lit Shape, by WebAssembly, which the page's policy refuses; only normal maps need them. */
function withoutTangents(scene) {
    for (let type = scene.createNode('IndexedFaceSet').getValue(); type; type = Object.getPrototypeOf(type))
        if (Object.hasOwn(type, 'generateTangents')) type.generateTangents = () => {};
}
