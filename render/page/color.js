// Colours as people write them, and as light.
import {linear} from './read_asset.js';

/**
 * The light of "#rrggbb": linear red, green and blue, 0..1.
 * @type {(hex: string) => number[]}
 */
export const linearOf = (hex) => [1, 3, 5].map((at) => linear[parseInt(hex.slice(at, at + 2), 16)]);
