// A scene's pieces from its bytes: the JavaScript counterpart of page_scene.h.
import * as Asset from './read_asset.js';

/** @import {JoinedSkin, SceneHeader} from './types.d.ts' */

/**
 * The direction at a place of an unfolded octahedron, 0..1023.
 * @param {number} a
 * @param {number} b
 * @param {Float32Array} out
 * @param {number} at
 */
function direction(a, b, out, at) {
  let x = 2 * a / 1023 - 1, y = 2 * b / 1023 - 1;
  const z = 1 - Math.abs(x) - Math.abs(y);
  if (z < 0) [x, y] = [(1 - Math.abs(y)) * (x < 0 ? -1 : 1), (1 - Math.abs(x)) * (y < 0 ? -1 : 1)];
  const length = Math.hypot(x, y, z) || 1;
  out[at] = x / length;
  out[at + 1] = y / length;
  out[at + 2] = z / length;
}

/**
 * Ten numbers per vertex, as in skin.js, and the corners of triangles.
 * @param {Asset.Reader} reader
 * @param {{vertices: number, triangles: number, fruit: number}} solid
 * @param {{units: number}} fruit
 * @returns {JoinedSkin}
 */
function mesh(reader, {vertices, triangles}, {units}) {
  const position = new Uint16Array(3 * vertices), normal = new Uint16Array(2 * vertices);
  const color = new Uint8Array(3 * vertices), tag = new Uint8Array(vertices);
  const index = new Uint32Array(3 * triangles), skin = new Float32Array(10 * vertices);
  for (let k = 0; k < 3; ++k) reader.numbers(vertices, 1, 2, position, k, 3);
  for (let k = 0; k < 2; ++k) reader.numbers(vertices, 1, 2, normal, k, 2);
  for (let k = 0; k < 3; ++k) reader.numbers(vertices, 1, 1, color, k, 3);
  reader.numbers(vertices, 1, 1, tag);
  for (let k = 0; k < 3; ++k) reader.numbers(triangles, 2, 3, index, k, 3);
  for (let v = 0; v < vertices; ++v) {
    for (let k = 0; k < 3; ++k) {
      skin[10 * v + k] = (position[3 * v + k] + 0.5) / units;
      skin[10 * v + 6 + k] = Asset.linear[color[3 * v + k]];
    }
    direction(normal[2 * v], normal[2 * v + 1], skin, 10 * v + 3);
    skin[10 * v + 9] = (tag[v] & 127) + (tag[v] & 128 ? 1000 : 0);
  }
  return {skin, index};
}

/**
 * The header, the solids, and the looks of the fruits.
 * @param {Uint8Array} bytes
 */
export function decoded(bytes) {
  const head = Asset.header(bytes, bytes.length);
  if (!head) throw new Error('the scene ends within its header');
  const header = /** @type {SceneHeader} */ (/** @type {unknown} */ (head.fields)),
        reader = new Asset.Reader(bytes, head.at);
  const floats = (/** @type {number} */ count) => new Float32Array(reader.take(16 * count).buffer);
  const looks = header.fruits.map(
    ({texels}) => ({noise: floats(texels[0]), materials: floats(texels[1]), details: new Float32Array(0)}));
  const solids = header.solids.map((solid) => mesh(reader, solid, header.fruits[solid.fruit]));
  if (reader.at !== bytes.length) throw new Error('something follows the scene\'s end');
  return {header, solids, looks};
}
