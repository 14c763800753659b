import { TriangleBuilder } from './TriangleBuilder.js';
import { kSurfaces } from './prismMesh.js';

/** X_ITE's words for a texture that is there, and one that never will be (X3DConstants.COMPLETE_STATE, FAILED_STATE). */
const kComplete = 1008, kFailed = 1009;
/** m: ground around the city, until haze hides it. */
const kHorizon = 20000;

/**
 * Draws the tiles of a flown city (Flyover's stage): a Transform for each tile, a Shape for each quadrant, one shader for
 * all of a kind. A quadrant's material tells the shader how far it has come or gone: its red.
 *
 * Needs   X_ITE's SAI, of a page or a Script, handed in: `setValue` of fields takes typed arrays, checkLoadState is its own. `scene`,
 * `group`: where Transforms go; `shaders`: { tiles, blockMaps }, the
 * ComposedShaders of /flyover.x3d; `types`: { MFInt32, MFNode, MFString, SFImage, SFVec3f, SFColor };
 * `pictures`: open(bytes of a WebP) -> an address, close(address); `beyond`: GROUND_BEYOND_CITY of the layout.
 */
export class TileShapes {
    constructor({ scene, group, shaders, types, pictures, beyond }) {
        Object.assign(this, { scene, group, shaders, types, pictures, beyond, shapes: 0, around: null, isAroundShown: false });
        this.properties = this.node('TextureProperties', {
            boundaryModeS: 'CLAMP_TO_EDGE', boundaryModeT: 'CLAMP_TO_EDGE', generateMipMaps: true,
            minificationFilter: 'AVG_PIXEL_AVG_MIPMAP', magnificationFilter: 'AVG_PIXEL', anisotropicDegree: 4 });
        this.bits = this.node('TextureProperties', { boundaryModeS: 'CLAMP_TO_EDGE', boundaryModeT: 'CLAMP_TO_EDGE', generateMipMaps: false,
            minificationFilter: 'NEAREST_PIXEL', magnificationFilter: 'NEAREST_PIXEL' });
    }

    node(type, fields) {
        return Object.assign(this.scene.createNode(type), fields);
    }

    begin(mesh) {
        return mesh.image ? this.beginBlockMap(mesh) : this.beginTile(mesh);
    }

    /** The pyramid, planes and colours of a BlockMap as a texture that keeps every bit. */
    beginBlockMap({ corner: [east, north], parts, image: { width, height, pixels } }) {
        const { SFVec3f, SFImage, MFInt32 } = this.types, numbers = new MFInt32();
        numbers.setValue(pixels);
        const texture = this.node('PixelTexture', { textureProperties: this.bits, image: new SFImage(width, height, 4, numbers) });
        const place = this.node('Transform', { translation: new SFVec3f(east, 0, -north) });
        this.group.children.push(place);
        return { place, address: null, texture, parts, shader: this.shaders.blockMaps, quadrants: [], shown: [false, false, false, false] };
    }

    beginTile({ corner: [east, north], parts, picture }) {
        const { SFVec3f, MFString } = this.types;
        const place = this.node('Transform', { translation: new SFVec3f(east, 0, -north) });
        const address = this.pictures.open(picture);
        const texture = this.node('ImageTexture', { textureProperties: this.properties, url: new MFString(address) });
        this.group.children.push(place);
        return { place, address, texture, parts, shader: this.shaders.tiles, quadrants: [], shown: [false, false, false, false] };
    }

    /** One quadrant at a time, then the picture is waited for. */
    work(made) {
        if (made.quadrants.length < 4) {
            const part = made.parts[made.quadrants.length];
            made.quadrants.push(this.quadrant(made, part));
            return part.indices.length;
        }
        const state = made.texture.getValue().checkLoadState();
        if (state !== kComplete && state !== kFailed) return null;
        if (made.address) this.pictures.close(made.address);
        Object.assign(made, { address: null, parts: null });
        return 0;
    }

    isDone({ parts }) {
        return parts === null;
    }

    quadrant({ texture, shader }, { positions, normals, colours, places, indices }) {
        const filled = (type, field, values) => {
            const node = this.scene.createNode(type);
            node[field].setValue(values);
            return node;
        };
        const geometry = this.node('IndexedTriangleSet', {
            coord: filled('Coordinate', 'point', positions), normal: filled('Normal', 'vector', normals),
            color: filled('ColorRGBA', 'color', colours), texCoord: filled('TextureCoordinate', 'point', places) });
        const numbers = new this.types.MFInt32();
        numbers.setValue(indices);
        geometry.set_index = numbers;
        const material = this.scene.createNode('Material');
        const appearance = this.node('Appearance', { alphaMode: 'OPAQUE', material, texture, shaders: new this.types.MFNode(shader) });
        return { shape: this.node('Shape', { appearance, geometry }), material };
    }

    /**
     * Ground as far as one sees around the root's square, as low as its lowest rim. Its places count from the square's middle in halves of
     * its side: the shader lets the land fade into mist beyond the rim.
     */
    surround({ corner: [east, north], side, nodes, heights }) {
        const rim = Array.from(heights).filter((_, i) => i < nodes || i >= nodes * (nodes - 1) || i % nodes === 0 || i % nodes === nodes - 1);
        const up = Math.min(...rim), builder = new TriangleBuilder(), { beyond } = this;
        const colour = [16, 8, 0].map(bits => (beyond >> bits & 255) / 255).concat(kSurfaces.beyond);
        const [west, south, right, top] = [-kHorizon, -kHorizon, side + kHorizon, side + kHorizon];
        for (const [a, b, c, d] of [[west, south, right, 0], [west, side, right, top], [west, 0, 0, side], [side, 0, right, side]])
            builder.face([[a, b], [c, b], [c, d], [a, d]].map(([x, y]) => [x, up, -y]), colour,
                [[a, b], [c, b], [c, d], [a, d]].map(([x, y]) => [2 * x / side - 1, 2 * y / side - 1]));
        const { shape, material } = this.quadrant({ texture: null, shader: this.shaders.tiles }, builder.build());
        material.diffuseColor = new this.types.SFColor(0.5, 0, 0);
        this.around = this.node('Transform', { translation: new this.types.SFVec3f(east, 0, -north) });
        this.around.children.push(shape);
    }

    showSurroundings(isShown) {
        if (!this.around || isShown === this.isAroundShown) return;
        this.isAroundShown = isShown;
        if (isShown) this.group.children.push(this.around);
        else this.remove(this.around);
    }

    remove(place) {
        this.group.children = new this.types.MFNode(...Array.from(this.group.children).filter(node => node !== place));
    }

    show(made, quadrant) {
        if (made.shown[quadrant]) return;
        made.shown[quadrant] = true;
        ++this.shapes;
        made.place.children.push(made.quadrants[quadrant].shape);
    }

    setState(made, quadrant, state) {
        made.quadrants[quadrant].material.diffuseColor = new this.types.SFColor(state, 0, 0);
    }

    hide(made, quadrant) {
        if (!made.shown[quadrant]) return;
        made.shown[quadrant] = false;
        --this.shapes;
        const shapes = made.quadrants.filter((_, q) => made.shown[q]).map(({ shape }) => shape);
        made.place.children = new this.types.MFNode(...shapes);
    }

    drop(made) {
        for (let q = 0; q < 4; ++q) this.hide(made, q);
        if (made.address) this.pictures.close(made.address);
        this.remove(made.place);
    }
}
