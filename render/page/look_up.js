// The triangles of each cell, the four textures of look.glsl, and the same look-up in JavaScript, for tests and for
// programs that need few points. Lengths are in cells of the grid.
import {linear} from './read_asset.js';

/** @import {CellLists, ColorRange, Fruit, Point} from './types.d.ts' */

/**
 * Triangles by cell, as in generator/diffusion/harmonic/cell_triangles.cpp: a cell has the triangles whose plane comes
 * near its box, within the triangles' own boxes; the few that are only near stabilise the fit beside surfaces. Cell (x,
 * y, z) has list[first[i]] to list[first[i + 1]] exclusive, i = (z * ny + y) * nx + x.
 * @param {Fruit} fruit
 * @returns {CellLists}
 */
export function cells(fruit, margin = 4e-3) {
  const {position, triangle, count, units} = fruit, [nx, ny, nz] = count, triangles = triangle.length / 3;
  const first = new Uint32Array(nx * ny * nz + 1), p = new Float64Array(9), low = [0, 0, 0], high = [0, 0, 0];
  const ends = new Uint32Array(triangles);
  // First the cells of each triangle, then the triangles of each cell.
  let met = new Uint32Array(1 << 18), all = 0;
  for (let t = 0; t < triangles; ++t) {
    for (let k = 0; k < 9; ++k) p[k] = (position[3 * triangle[3 * t + (k / 3 | 0)] + k % 3] + 0.5) / units;
    for (let a = 0; a < 3; ++a) {
      low[a] = Math.max(0, Math.floor(Math.min(p[a], p[3 + a], p[6 + a]) - margin));
      high[a] = Math.min(count[a] - 2, Math.floor(Math.max(p[a], p[3 + a], p[6 + a]) + margin));
    }
    const ux = p[3] - p[0], uy = p[4] - p[1], uz = p[5] - p[2], vx = p[6] - p[0], vy = p[7] - p[1], vz = p[8] - p[2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    const reach = (0.5 + margin) * (Math.abs(x) + Math.abs(y) + Math.abs(z));
    for (let k = low[2]; k <= high[2]; ++k)
      for (let j = low[1]; j <= high[1]; ++j) {
        const height = y * (j + 0.5 - p[1]) + z * (k + 0.5 - p[2]) + x * (0.5 - p[0]), row = (k * ny + j) * nx;
        if (all + nx > met.length) {
          const larger = new Uint32Array(2 * met.length);
          larger.set(met);
          met = larger;
        }
        for (let i = low[0]; i <= high[0]; ++i)
          if (Math.abs(height + i * x) <= reach) {
            met[all++] = row + i;
            ++first[row + i + 1];
          }
      }
    ends[t] = all;
  }
  for (let i = 1; i < first.length; ++i) first[i] += first[i - 1];
  const next = first.slice(0, -1), list = new Uint32Array(all);
  for (let t = 0, i = 0; t < triangles; ++t)
    for (; i < ends[t]; ++i) list[next[met[i]]++] = t;
  return {first, list};
}

const two = (/** @type {number} */ winding) => (winding < -1 ? 0 : winding > 2 ? 3 : winding + 1);

/**
 * The arrays of the four textures, as whole rows, and the range of all colours.
 * @param {Fruit} fruit
 * @param {CellLists} lists
 */
export function textures(fruit, {first, list}) {
  const [nx, ny, nz] = fruit.count, nodes = nx * ny * nz, plane = nx * ny, {winding, nodeColor, nodePart} = fruit;
  /** @type {(length: number, width: number) => number} */
  const rows = (length, width) => Math.max(1, Math.ceil(length / width)) * width;
  const grid = new Uint8Array(4 * nodes), cell = new Uint32Array(2 * nodes), [red, green, blue] = nodeColor;
  for (let i = 0, at = 0; i < nodes; ++i) {
    grid[at++] = red[i];
    grid[at++] = green[i];
    grid[at++] = blue[i];
    grid[at++] = nodePart[i];
  }
  // Windings from -1 to 2 fit into two bits; if more bodies overlap, inside stays inside. First of two neighbouring
  // nodes, then of the four nodes of a cell's side.
  const row = new Uint8Array(nodes), side = new Uint8Array(nodes);
  for (let i = 0, low = two(winding[0]); i + 1 < nodes; ++i) {
    const high = two(winding[i + 1]);
    row[i] = low | high << 2;
    low = high;
  }
  for (let i = 0; i + nx < nodes; ++i) side[i] = row[i] | row[i + nx] << 4;
  for (let i = 0; i + plane + nx + 1 < nodes; ++i) {
    cell[2 * i] = first[i];
    cell[2 * i + 1] = Math.min(first[i + 1] - first[i], 4095) | side[i] << 12 | side[i + plane] << 20;
  }
  const triangles = fruit.hidden.length, triangle = new Uint32Array(16 * rows(triangles, 1024));
  const {position: p, triangle: corner, part} = fruit;
  const root = Uint32Array.from(linear, (l) => Math.round(1023 * Math.sqrt(l)));
  /** @type {(color: Uint8Array, v: number) => number} */
  const bits = (color, v) => root[color[3 * v]] | root[color[3 * v + 1]] << 10 | root[color[3 * v + 2]] << 20;
  for (let t = 0; t < triangles; ++t) {
    const at = 16 * t;
    for (let k = 0; k < 9; ++k) triangle[at + (k >> 1)] |= p[3 * corner[3 * t + (k / 3 | 0)] + k % 3] << 16 * (k & 1);
    triangle[at + 4] |= fruit.hidden[t] << 16;
    triangle[at + 5] = part[0][t] | part[1][t] << 16;
    for (let k = 0; k < 3; ++k) {
      triangle[at + 8 + k] = bits(fruit.front, corner[3 * t + k]);
      triangle[at + 12 + k] = bits(fruit.back, corner[3 * t + k]);
    }
  }
  const wholeList = new Uint32Array(rows(list.length, 2048));
  wholeList.set(list);
  return {grid, cell, list: wholeList, triangle, ...range(fruit)};
}

/**
 * @param {Fruit} fruit
 * @returns {ColorRange}
 */
export function range({front, back}) {
  const low = [255, 255, 255], high = [0, 0, 0];
  for (let i = 0; i < front.length; ++i) {
    low[i % 3] = Math.min(low[i % 3], front[i], back[i]);
    high[i % 3] = Math.max(high[i % 3], front[i], back[i]);
  }
  return {low: low.map((v) => linear[v]), high: high.map((v) => linear[v])};
}

// ---- One point, as in look.glsl. ----

/** @type {(a: Point, b: Point) => number} */
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** @type {(a: Point, b: Point) => Point} */
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
/** @type {(a: Point, b: Point) => Point} */
const less = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/**
 * Weights of a triangle's corners at its point nearest to the origin.
 * @param {Point} a
 * @param {Point} b
 * @param {Point} c
 */
function nearestWeights(a, b, c) {
  const ab = less(b, a), ac = less(c, a), a1 = -dot(ab, a), a2 = -dot(ac, a);
  if (a1 <= 0 && a2 <= 0) return [1, 0, 0];
  const b1 = -dot(ab, b), b2 = -dot(ac, b);
  if (b1 >= 0 && b2 <= b1) return [0, 1, 0];
  const acrossC = a1 * b2 - b1 * a2;
  if (acrossC <= 0 && a1 >= 0 && b1 <= 0) return [1 - a1 / (a1 - b1), a1 / (a1 - b1), 0];
  const c1 = -dot(ab, c), c2 = -dot(ac, c);
  if (c2 >= 0 && c1 <= c2) return [0, 0, 1];
  const acrossB = c1 * a2 - a1 * c2;
  if (acrossB <= 0 && a2 >= 0 && c2 <= 0) return [1 - a2 / (a2 - c2), 0, a2 / (a2 - c2)];
  const acrossA = b1 * c2 - c1 * b2;
  if (acrossA <= 0 && b2 - b1 >= 0 && c1 - c2 >= 0) {
    const w = (b2 - b1) / ((b2 - b1) + (c1 - c2));
    return [0, 1 - w, w];
  }
  const sum = acrossA + acrossB + acrossC;
  return [1 - acrossB / sum - acrossC / sum, acrossB / sum, acrossC / sum];
}

/** Fits a linear function to values at places around the origin, by weighted least squares; its value at the origin. */
class Fit {
  constructor() {
    this.matrix = new Float64Array(16);
    this.right = new Float64Array(12);
  }
  /**
   * @param {Point} place
   * @param {number[]} value
   */
  add(place, value) {
    const weight = 1 / (dot(place, place) + 1e-3) ** 2, basis = [1, ...place];
    for (let i = 0; i < 4; ++i) {
      for (let j = i; j < 4; ++j) this.matrix[4 * i + j] += weight * basis[i] * basis[j];
      for (let k = 0; k < 3; ++k) this.right[3 * i + k] += weight * basis[i] * value[k];
    }
  }
  value() {
    const {matrix: m, right: r} = this;
    for (let i = 1; i < 4; ++i) m[5 * i] += 1e-6 * m[0];
    for (let p = 3; p > 0; --p)
      for (let i = 0; i < p; ++i) {
        const share = m[4 * i + p] / m[5 * p];
        for (let j = i; j < p; ++j) m[4 * i + j] -= share * m[4 * j + p];
        for (let k = 0; k < 3; ++k) r[3 * i + k] -= share * r[3 * p + k];
      }
    return [r[0] / m[0], r[1] / m[0], r[2] / m[0]];
  }
}

/**
 * `fruit` from Asset.decoded(), `lists` from cells(), `hull` from range(). Null in air, else the colour (linear), the
 * part, and the number of triangles that were read.
 * @param {Fruit} fruit
 * @param {CellLists} lists
 * @param {ColorRange} hull
 * @param {Point} g
 */
export function at(fruit, lists, hull, g) {
  const {count, units, position, triangle, hidden, winding, nodeColor, nodePart} = fruit, [nx, ny] = count;
  const low = g.map(Math.floor);
  if (low.some((v, axis) => !(v >= 0 && v < count[axis] - 1))) return null;
  const within = less(g, low), cell = (low[2] * ny + low[1]) * nx + low[0];
  const node = (/** @type {number} */ k) => cell + (k & 1) + nx * (k >> 1 & 1) + nx * ny * (k >> 2);
  const colorOf =
    (/** @type {number} */ i) => [linear[nodeColor[0][i]], linear[nodeColor[1][i]], linear[nodeColor[2][i]]];
  const begin = lists.first[cell], end = lists.first[cell + 1];
  if (begin === end) {
    if (winding[cell] === 0) return null;
    const color = [0, 0, 0];
    for (let k = 0; k < 8; ++k) {
      const share = [0, 1, 2].reduce((w, a) => w * (k >> a & 1 ? within[a] : 1 - within[a]), 1), c = colorOf(node(k));
      for (let i = 0; i < 3; ++i) color[i] += share * c[i];
    }
    return {color, part: nodePart[cell] - 1, triangles: 0};
  }

  // Cast rays to the corners, and find the nearest point of all triangles.
  const rays = Array.from({length: 8}, (_, k) => ({
                                         towards: [(k & 1) - within[0], (k >> 1 & 1) - within[1], (k >> 2) - within[2]],
                                         fraction: 2,
                                         t: 0,
                                         side: 0,
                                         weights: [1, 0, 0]
                                       }));
  const reach = 1 + 1.5 / units;
  let inside = 0, nearest = {squared: Infinity, place: [0, 0, 0], weights: [1, 0, 0], t: 0, side: 0};
  for (let k = 0; k < 8; ++k) inside += winding[node(k)];
  for (let i = begin; i < end; ++i) {
    const t = lists.list[i];
    const [a, b, c] = [0, 1, 2].map(
      (k) => [0, 1, 2].map(
        (axis) => (position[3 * triangle[3 * t + k] + axis] + 0.5 - low[axis] * units) / units - within[axis]));
    const qa = cross(b, c), qb = cross(c, a), qc = cross(a, b), volume = dot(a, qa);
    for (const ray of rays) {
      const pa = dot(ray.towards, qa), pb = dot(ray.towards, qb), pc = dot(ray.towards, qc), sum = pa + pb + pc;
      const fraction = volume / sum;
      const meets = (pa >= 0 && pb >= 0 && pc >= 0) || (pa <= 0 && pb <= 0 && pc <= 0);
      if (!meets || !(fraction >= 0)) continue;
      if (fraction <= 1 && hidden[t] !== 0) inside += (volume < 0) === (hidden[t] === 1) ? -1 : 1;
      if (!(fraction <= reach && fraction < ray.fraction)) continue;
      Object.assign(ray, {fraction, t, side: volume < 0 ? 0 : 1, weights: [pa / sum, pb / sum, pc / sum]});
    }
    const weights = nearestWeights(a, b, c);
    const place = [0, 1, 2].map((k) => weights[0] * a[k] + weights[1] * b[k] + weights[2] * c[k]);
    const squared = dot(place, place);
    if (squared < nearest.squared) nearest = {squared, place, weights, t, side: volume <= 0 ? 0 : 1};
  }
  if (Math.abs(inside) < 4) return null;

  // Fit the colours found.
  /** @type {(seen: {t: number, side: number, weights: number[]}) => number[]} */
  const ofSide = ({t, side, weights}) => {
    const from = side === 0 ? fruit.front : fruit.back, color = [0, 0, 0];
    for (let k = 0; k < 3; ++k)
      for (let i = 0; i < 3; ++i) color[i] += weights[k] * linear[from[3 * triangle[3 * t + k] + i]];
    return color;
  };
  const fit = new Fit();
  fit.add(nearest.place, ofSide(nearest));
  rays.forEach((ray, k) => {
    if (ray.fraction < 2) fit.add(ray.towards.map((v) => v * ray.fraction), ofSide(ray));
    else if (nodePart[node(k)] > 0) fit.add(ray.towards, colorOf(node(k)));
  });
  const color = fit.value().map((v, i) => Math.min(hull.high[i], Math.max(hull.low[i], v)));
  return {color, part: fruit.part[nearest.side][nearest.t], triangles: end - begin};
}
