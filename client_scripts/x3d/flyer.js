import { Flyover } from '../core/Flyover.js';
import { TileShapes } from '../core/TileShapes.js';
import { fetchLayouts, prepareHere, tileLoader } from '../core/tileLoad.js';

// The FLYER Script of /flyover.x3d (client_scripts/README.md); its fields are in scope by name: base, layouts, shaders, world,
// clock. Bundled with core/ into /client/flyer.js. Needs a browser with the web's fetch, URL and Blob: X_ITE.
/* global Browser, MFInt32, MFNode, MFString, SFColor, SFImage, SFVec3f, base, layouts, shaders, world, clock */
let flyover = null;
let eye = null;
let looks = { heading: 0, pitch: 0 };

/** X3D tells a Script neither the window's size nor its shape: a window of 1280 x 720 is taken for granted. */
const kHalf = [0.915, 0.515], kPixelsPerRadian = 360 / 0.515;

function initialize() {
    start().catch(error => Browser.println(`flyover: ${error.message}`));
}

async function start() {
    const worldUrl = Browser.currentScene.worldURL, absolute = path => new URL(path, worldUrl).href;
    const [tree, formats] = await Promise.all([fetchTree(absolute(`${base}tree.json`)), fetchLayouts(absolute(layouts))]);
    const pictures = { open: bytes => URL.createObjectURL(new Blob([bytes], { type: 'image/webp' })), close: address => URL.revokeObjectURL(address) };
    const types = { MFInt32, MFNode, MFString, SFColor, SFImage, SFVec3f }, scene = Browser.currentScene;
    const stage = new TileShapes({ scene, group: world, shaders: { tiles: shaders[0], blockMaps: shaders[1] }, types, pictures, beyond: formats.ground.GROUND_BEYOND_CITY });
    flyover = new Flyover({ tree, stage, load: tileLoader(absolute(base), prepareHere(formats)), complain: text => Browser.println(text) });
}

async function fetchTree(url) {
    const response = await fetch(url);
    if (!response.ok) throw new Error(`${url}: ${response.status}. Was the city built with tiles?`);
    return response.json();
}

function set_position({ x, y, z }) {
    eye = [x, -z, y];
    wake();
}

/** Where -z, the way a visitor looks, points to after the turn about (x, y, z). */
function set_orientation({ x, y, z, angle }) {
    const c = Math.cos(angle), s = Math.sin(angle);
    const [right, up, back] = [x * z * (1 - c) + y * s, y * z * (1 - c) - x * s, z * z * (1 - c) + c];
    looks = { heading: Math.atan2(-right, back), pitch: Math.asin(Math.min(1, Math.max(-1, -up))) };
    wake();
}

/** The clock draws frames while something is on its way: a browser that draws a still world calls nobody. */
function wake() {
    if (!clock.enabled) clock.enabled = true;
}

function set_fraction() {
    if (!flyover || !eye) return;
    flyover.step({ eye, ...looks, half: kHalf, pixelsPerRadian: kPixelsPerRadian }, Date.now() / 1000);
    if (flyover.isSettled) clock.enabled = false;
}
