// All that flying takes beyond what the street does: fetched by who flies, so that the street comes sooner.
export { Flyover } from '../core/Flyover.js';
export { TileShapes } from '../core/TileShapes.js';
export { placeBelow } from '../core/placeBelow.js';
export { fetchLayouts, tileLoader } from '../core/tileLoad.js';
export { Flyer } from './Flyer.js';
export { TileWorkshop } from './TileWorkshop.js';
export { fetchTileShaders, probeForms } from './probeForms.js';
