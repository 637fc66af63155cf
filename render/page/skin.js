// The triangles of the skin: the boundary seen from air, with smooth normals.
import {linear} from './read_asset.js';

/** @import {Fruit, JoinedSkin, Numbers} from './types.d.ts' */

/**
 * Finds equal items among `count`: returns a function from an item to its number, the same for equal items, in order of
 * first use, up to `most` numbers. A hash table with open addressing.
 * @param {number} count
 * @param {number} most
 * @param {(i: number) => number} hashOf
 * @param {(i: number, k: number) => boolean} alike
 * @returns {(i: number) => number}
 */
function numbering(count, most, hashOf, alike) {
  const size = 1 << Math.ceil(Math.log2(4 * most / 3 + 4)), slot = new Int32Array(size).fill(-1);
  const number = new Int32Array(count).fill(-1);
  let all = 0;
  return (i) => {
    if (number[i] >= 0) return number[i];
    const hash = hashOf(i);
    let at = (hash ^ hash >>> 16) & size - 1;
    for (; slot[at] >= 0; at = at + 1 & size - 1)
      if (alike(slot[at], i)) return number[i] = number[slot[at]];
    slot[at] = i;
    return number[i] = all++;
  };
}

/**
 * Numbers points by place, up to `most`. `p`: coordinates, `stride` numbers per point; `bits`: integers for them.
 * @type {(p: Numbers, stride: number, most: number, bits?: Numbers) => (i: number) => number}
 */
const places = (p, stride, most, bits = p) => numbering(
  p.length / stride, most,
  (v) => Math.imul(bits[stride * v], 0x8da6b343) ^ Math.imul(bits[stride * v + 1], 0xd8163841) ^
    Math.imul(bits[stride * v + 2], 0xcb1ab31f),
  (v, w) => p[stride * v] === p[stride * w] && p[stride * v + 1] === p[stride * w + 1] &&
    p[stride * v + 2] === p[stride * w + 2]);

/**
 * For triangles of three `corners` each: `face`, their normals, as long as twice the area; `sum`, for each of `most`
 * places the sum of the normals that meet there.
 * @param {Numbers} p
 * @param {number} stride
 * @param {Numbers} corners
 * @param {(i: number) => number} placeOf
 * @param {number} most
 */
function areas(p, stride, corners, placeOf, most) {
  const face = new Float32Array(corners.length), sum = new Float64Array(3 * most);
  for (let i = 0; i < corners.length; i += 3) {
    const a = stride * corners[i], b = stride * corners[i + 1], c = stride * corners[i + 2];
    const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
    const wx = p[c] - p[a], wy = p[c + 1] - p[a + 1], wz = p[c + 2] - p[a + 2];
    face[i] = uy * wz - uz * wy;
    face[i + 1] = uz * wx - ux * wz;
    face[i + 2] = ux * wy - uy * wx;
    for (let k = i; k < i + 3; ++k) {
      const at = 3 * placeOf(corners[k]);
      sum[at] += face[i];
      sum[at + 1] += face[i + 1];
      sum[at + 2] += face[i + 2];
    }
  }
  return {face, sum};
}

/**
 * The skin of all triangles with a hidden side.
 * @param {Fruit} fruit
 */
export function built(fruit) {
  const {hidden} = fruit, /** @type {number[]} */ faces = [];
  for (let t = 0; t < hidden.length; ++t)
    if (hidden[t] !== 0) faces.push(t);
  return skinOf(fruit, faces, (t) => ({turned: hidden[t] === 2, front: hidden[t] === 1}));
}

/**
 * Ten numbers per corner, nothing shared: position (cells of the grid), normal, colour (linear), part. Normals are
 * smooth over equal places, except where surfaces meet at a sharp angle. `seen(t)`: whether a triangle's corners are
 * reversed, and whether it has the colour and part of its front.
 * @param {Fruit} fruit
 * @param {number[]} faces
 * @param {(t: number) => {turned: boolean, front: boolean}} seen
 */
export function skinOf(fruit, faces, seen) {
  const {position, triangle, units} = fruit, corners = new Int32Array(3 * faces.length);
  const placeOf = places(position, 3, corners.length);
  faces.forEach((t, f) => {
    const {turned} = seen(t);
    corners.set([triangle[3 * t], triangle[3 * t + (turned ? 2 : 1)], triangle[3 * t + (turned ? 1 : 2)]], 3 * f);
  });
  const {face, sum} = areas(position, 3, corners, placeOf, corners.length);

  const data = new Float32Array(10 * corners.length);
  for (let i = 0; i < corners.length; ++i) {
    const v = corners[i], f = 3 * (i / 3 | 0), t = faces[i / 3 | 0], {front} = seen(t);
    const n = [face[f], face[f + 1], face[f + 2]], at = 3 * placeOf(v), s = [sum[at], sum[at + 1], sum[at + 2]];
    const along = n[0] * s[0] + n[1] * s[1] + n[2] * s[2];
    const smooth = along > 0.25 * Math.hypot(...n) * Math.hypot(...s);
    const m = smooth ? s : n, length = Math.hypot(...m) || 1, color = front ? fruit.front : fruit.back;
    for (let k = 0; k < 3; ++k) {
      data[10 * i + k] = (position[3 * v + k] + 0.5) / units;
      data[10 * i + 3 + k] = m[k] / length;
      data[10 * i + 6 + k] = linear[color[3 * v + k]];
    }
    data[10 * i + 9] = fruit.part[front ? 0 : 1][t];
  }
  return data;
}

/**
 * Joins corners that are equal in all ten numbers.
 * @param {Float32Array} data
 * @returns {JoinedSkin}
 */
export function joined(data) {
  const bits = new Uint32Array(data.buffer, data.byteOffset, data.length), index = new Uint32Array(data.length / 10);
  const skin = new Float32Array(data.length);
  const hashOf = (/** @type {number} */ i) => {
    let hash = 0;
    for (let k = 10 * i; k < 10 * i + 10; ++k) hash = Math.imul(hash ^ bits[k], 0x9e3779b1) ^ hash >>> 15;
    return hash;
  };
  const alike = (/** @type {number} */ i, /** @type {number} */ j) => {
    for (let k = 0; k < 10; ++k)
      if (data[10 * i + k] !== data[10 * j + k]) return false;
    return true;
  };
  const numberOf = numbering(index.length, index.length, hashOf, alike);
  let count = 0;
  for (let i = 0; i < index.length; ++i) {
    index[i] = numberOf(i);
    if (index[i] === count) skin.set(data.subarray(10 * i, 10 * i + 10), 10 * count++);
  }
  return {skin: skin.slice(0, 10 * count), index};
}

/**
 * Three numbers per corner of a skin: the sum of the normals of all triangles at its place, weighted by area. An
 * outline moves outwards along it, and stays closed where surfaces meet at a sharp angle.
 * @param {Float32Array} skin
 * @param {Uint32Array | null} index
 */
export function outwards(skin, index = null) {
  const bits = new Uint32Array(skin.buffer, skin.byteOffset, skin.length), count = skin.length / 10;
  const placeOf = places(skin, 10, count, bits);
  const {sum} = areas(skin, 10, index || Uint32Array.from({length: count}, (_, i) => i), placeOf, count);
  const ways = new Float32Array(3 * count);
  for (let v = 0; v < count; ++v)
    for (let k = 0; k < 3; ++k) ways[3 * v + k] = sum[3 * placeOf(v) + k];
  return ways;
}
