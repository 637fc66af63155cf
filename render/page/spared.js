// Spared parts, in the worker: the shells around them, which the program has found (generator/cut/spared.h), as
// triangles, and points within each shell that tell which piece has most of it.
import * as Skin from './skin.js';

/** @import {Fruit, Point} from './types.d.ts' */

const most = 60000;  // points of all shells together

/**
 * The triangles of each shell, from the asset.
 * @param {Fruit} fruit
 */
function shellsOf({shell, header}) {
  const shells = Array.from({length: header.shells?.count ?? 0}, () => /** @type {number[]} */ ([]));
  shell?.forEach((number, t) => {
    if (number > 0) shells[number - 1].push(t);
  });
  return shells;
}

/**
 * Calls `visit(x, y, z)` for the points inside a shell on a lattice that divides each cell by `fine`; integers, half a
 * step off the cells' corners if `fine` is even.
 * @param {Fruit} fruit
 * @param {number[]} faces
 * @param {number} fine
 * @param {(x: number, y: number, z: number) => void} visit
 */
function eachWithin(fruit, faces, fine, visit) {
  const {position, triangle, units} = fruit, columns = /** @type {Map<number, number[][]>} */ (new Map());
  for (const t of faces) {
    const [a, b, c] =
      [0, 1, 2].map((k) => [0, 1, 2].map((axis) => (position[3 * triangle[3 * t + k] + axis] + 0.5) / units * fine));
    /** @type {(p: Point, q: Point, y: number, z: number) => number} */
    const area = (p, q, y, z) => (q[1] - p[1]) * (z - p[2]) - (q[2] - p[2]) * (y - p[1]);
    const whole = area(a, b, c[1], c[2]);
    if (whole === 0) continue;
    const range = (/** @type {number} */ axis) =>
      [Math.ceil(Math.min(a[axis], b[axis], c[axis])), Math.floor(Math.max(a[axis], b[axis], c[axis]))];
    const [lowY, highY] = range(1), [lowZ, highZ] = range(2);
    for (let z = lowZ; z <= highZ; ++z)
      for (let y = lowY; y <= highY; ++y) {
        // Slightly shifted, so that no column meets an edge.
        const u = area(b, c, y + 1.3e-4, z + 2.9e-4) / whole, v = area(c, a, y + 1.3e-4, z + 2.9e-4) / whole;
        if (u < 0 || v < 0 || u + v > 1) continue;
        const key = z * 65536 + y;
        const met = columns.get(key) ?? [];
        met.push([u * a[0] + v * b[0] + (1 - u - v) * c[0], whole < 0 ? 1 : -1]);
        columns.set(key, met);
      }
  }
  for (const [key, met] of columns) {
    met.sort((p, q) => p[0] - q[0]);
    let winding = 0;
    for (let i = 0; i + 1 < met.length; ++i) {
      winding += met[i][1];
      if (winding !== 0)
        for (let x = Math.ceil(met[i][0]); x <= met[i + 1][0]; ++x) visit(x, key % 65536, Math.floor(key / 65536));
    }
  }
}

/**
 * {stone, socket: skins (skin.js) of all shells, from outside and from inside; shells: [{first, count of their corners,
 * points within: three numbers each, cells}]}, or null without spared parts. In `free`, a copy of the windings, nodes
 * within shells become air.
 * @param {Fruit} fruit
 */
export function built(fruit) {
  if (!fruit.header.shells) return null;
  const {count: [nx, ny]} = fruit, free = fruit.winding.slice(), shells = shellsOf(fruit);
  let nodes = 0;
  for (const faces of shells)
    eachWithin(fruit, faces, 1, (x, y, z) => {
      free[(z * ny + y) * nx + x] = 0;
      ++nodes;
    });
  const fine = Math.max(1, Math.min(8, Math.floor(Math.cbrt(most / Math.max(1, nodes)))));
  let first = 0;
  const told = shells.map((faces) => {
    const /** @type {number[]} */ points = [], at = first;
    eachWithin(fruit, faces, fine, (x, y, z) => points.push(x / fine, y / fine, z / fine));
    first += 3 * faces.length;
    return {first: at, count: 3 * faces.length, points: Float32Array.from(points)};
  });
  const all = shells.flat();
  return {
    stone: Skin.skinOf(fruit, all, () => ({turned: false, front: false})),
    socket: Skin.skinOf(fruit, all, () => ({turned: true, front: true})),
    shells: told,
    free
  };
}
