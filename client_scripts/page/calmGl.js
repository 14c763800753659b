/** What a drawing context always answers alike. */
const kConstants = ['MAX_TEXTURE_SIZE', 'MAX_TEXTURE_IMAGE_UNITS', 'MAX_COMBINED_TEXTURE_IMAGE_UNITS', 'MAX_SAMPLES', 'MAX_VIEWPORT_DIMS'];

/**
 * Spares X_ITE 15.0.1 questions to the graphics card in the midst of a frame: each waits until all that was drawn before is done,
 * 100 ms and more where a program draws. It asks for limits with every image, and reads every image back to learn whether any
 * of it is transparent.
 */
export function calmGl(browser, textureType) {
    const gl = browser.getContext(), ask = gl.getParameter.bind(gl), known = new Map();
    const anisotropy = gl.getExtension('EXT_texture_filter_anisotropic')?.MAX_TEXTURE_MAX_ANISOTROPY_EXT;
    const constants = new Set([anisotropy, ...kConstants.map(name => gl[name])]);
    gl.getParameter = name => {
        if (!constants.has(name)) return ask(name);
        if (!known.has(name)) known.set(name, ask(name));
        return known.get(name);
    };
    const { setImage } = textureType;
    textureType.setImage = function () {
        this.getTextureData = () => pixelsOf(this.image[0]);
        setImage.call(this);
        delete this.getTextureData;
    };
}

const kNothing = new Uint8Array(4).fill(255);
let canvas = null;

/** The pixels of an image, without the graphics card; opaque ones where it may not be read. */
function pixelsOf(image) {
    const { width, height } = image;
    canvas ??= document.createElement('canvas').getContext('2d', { willReadFrequently: true });
    Object.assign(canvas.canvas, { width, height });   // empties it
    canvas.drawImage(image, 0, 0);
    return width && height ? canvas.getImageData(0, 0, width, height).data : kNothing;
}
