// Colours as text and as linear light.
import {linear} from './read_asset.js';

/**
 * Linear red, green and blue of "#rrggbb", 0..1.
 * @type {(hex: string) => number[]}
 */
export const linearOf = (hex) => [1, 3, 5].map((at) => linear[parseInt(hex.slice(at, at + 2), 16)]);
