// Parts that knives go around (generator/cut/spared.h), in the worker: the closed shells that enclose them, as
// triangles to be drawn, and points within each that tell which piece has most of it.
import * as Skin from './skin.js';

const most = 60000;  // points of all shells together

/** Triangles with a spared part behind them and another before them, shell by shell: those that hang together. */
function shellsOf(fruit) {
  const {triangle, hidden, part, header} = fruit, spared = new Set(header.spared || []), found = [];
  for (let t = 0; t < hidden.length; ++t)
    if (hidden[t] === 0 && spared.has(part[1][t]) && !spared.has(part[0][t])) found.push(t);
  const placeOf = Skin.places(fruit.position, 3, 3 * found.length), parent = [];
  const root = (v) => {
    while (parent[v] !== v) v = parent[v] = parent[parent[v]];
    return v;
  };
  const cornersOf = (t) => [0, 1, 2].map((k) => {
    const v = placeOf(triangle[3 * t + k]);
    if (parent[v] === undefined) parent[v] = v;
    return v;
  });
  for (const t of found) {
    const [a, b, c] = cornersOf(t);
    parent[root(a)] = root(b);
    parent[root(b)] = root(c);
  }
  const shells = new Map();
  for (const t of found) {
    const at = root(cornersOf(t)[0]);
    if (!shells.has(at)) shells.set(at, []);
    shells.get(at).push(t);
  }
  return [...shells.values()].filter((faces) => isClosed(faces.map(cornersOf), parent.length));
}
/** Each edge is passed as often one way as the other. */
function isClosed(corners, places) {
  const passed = new Map();
  for (const corner of corners) {
    for (let k = 0; k < 3; ++k) {
      const a = corner[k], b = corner[(k + 1) % 3], key = Math.min(a, b) * places + Math.max(a, b);
      if (a !== b) passed.set(key, (passed.get(key) || 0) + (a < b ? 1 : -1));
    }
  }
  return [...passed.values()].every((sum) => sum === 0);
}

/**
 * Calls `visit(x, y, z)` for the points inside of a shell on a lattice that divides each cell by `fine`; whole numbers,
 * half a step away from the cells' corners where fine is even.
 */
function eachWithin(fruit, faces, fine, visit) {
  const {position, triangle, units} = fruit, columns = new Map();
  for (const t of faces) {
    const [a, b, c] =
      [0, 1, 2].map((k) => [0, 1, 2].map((axis) => (position[3 * triangle[3 * t + k] + axis] + 0.5) / units * fine));
    const area = (p, q, y, z) => (q[1] - p[1]) * (z - p[2]) - (q[2] - p[2]) * (y - p[1]);
    const whole = area(a, b, c[1], c[2]);
    if (whole === 0) continue;
    const range =
      (axis) => [Math.ceil(Math.min(a[axis], b[axis], c[axis])), Math.floor(Math.max(a[axis], b[axis], c[axis]))];
    const [lowY, highY] = range(1), [lowZ, highZ] = range(2);
    for (let z = lowZ; z <= highZ; ++z)
      for (let y = lowY; y <= highY; ++y) {
        // A little aside: no column meets an edge.
        const u = area(b, c, y + 1.3e-4, z + 2.9e-4) / whole, v = area(c, a, y + 1.3e-4, z + 2.9e-4) / whole;
        if (u < 0 || v < 0 || u + v > 1) continue;
        const key = z * 65536 + y;
        if (!columns.has(key)) columns.set(key, []);
        columns.get(key).push([u * a[0] + v * b[0] + (1 - u - v) * c[0], whole < 0 ? 1 : -1]);
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

/** The volume of all of them, cells. */
function volumeOf({position, triangle, units}, faces) {
  let six = 0;
  for (const t of faces) {
    const [a, b, c] = [0, 1, 2].map((k) => 3 * triangle[3 * t + k]), p = position;
    six += p[a] * (p[b + 1] * p[c + 2] - p[b + 2] * p[c + 1]) + p[a + 1] * (p[b + 2] * p[c] - p[b] * p[c + 2]) +
      p[a + 2] * (p[b] * p[c + 1] - p[b + 1] * p[c]);
  }
  return Math.abs(six) / 6 / units ** 3;
}

/**
 * {stone, socket: skins (skin.js) of all shells one after another, seen from outside and from inside; shells: [{first,
 * count of their corners, points within: three numbers each, cells}]}, or null where nothing is spared. What crosses
 * another shell or leaves the fruit is cut through, as by the program. Nodes within shells become air in `free`, a copy
 * of the windings.
 */
export function built(fruit) {
  const {winding, count: [nx, ny]} = fruit;
  if (!(fruit.header.spared || []).length) return null;
  const owner = new Map(), free = winding.slice();
  let shells = shellsOf(fruit).map((faces) => ({faces, isWhole: true}));
  for (const shell of shells) {
    eachWithin(fruit, shell.faces, 1, (x, y, z) => {
      const node = (z * ny + y) * nx + x, other = owner.get(node);
      if (other) other.isWhole = shell.isWhole = false;
      if (winding[node] !== 1) shell.isWhole = false;
      owner.set(node, shell);
    });
  }
  shells = shells.filter(({isWhole}) => isWhole);
  if (shells.length === 0) return null;
  for (const [node, shell] of owner)
    if (shell.isWhole) free[node] = 0;
  const volume = shells.reduce((sum, {faces}) => sum + volumeOf(fruit, faces), 0);
  const fine = Math.max(1, Math.min(8, Math.floor(Math.cbrt(most / volume))));
  let first = 0;
  const all = shells.flatMap(({faces}) => faces);
  const told = shells.map(({faces}) => {
    const points = [], at = first;
    eachWithin(fruit, faces, fine, (x, y, z) => points.push(x / fine, y / fine, z / fine));
    first += 3 * faces.length;
    return {first: at, count: 3 * faces.length, points: Float32Array.from(points)};
  });
  return {
    stone: Skin.skinOf(fruit, all, () => ({turned: false, front: false})),
    socket: Skin.skinOf(fruit, all, () => ({turned: true, front: true})),
    shells: told,
    free
  };
}
