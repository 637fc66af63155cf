// The pieces that the knives leave, and their places when they are pulled apart or opened.
import {M, V} from './linear.js';

/** @import {Knife} from './knives.js' */
/** @import {Frame, Home, Piece, Point, Shell} from './types.d.ts' */

/**
 * Points that represent the fruit: some of its skin, except for the parts `without`, and some of its inner nodes.
 * @param {{count: number[]}} header
 * @param {Float32Array} skin
 * @param {Int8Array | null} winding
 * @param {number} most
 * @param {number[]} without
 */
export function samplesOf(header, skin, winding, most = 2500, without = []) {
  const /** @type {Point[]} */ points = [], corners = skin.length / 10, every = Math.max(1, Math.floor(corners / most));
  for (let i = 0; i < corners; i += every)
    if (!without.includes(skin[10 * i + 9])) points.push([skin[10 * i], skin[10 * i + 1], skin[10 * i + 2]]);
  if (winding) {
    const [nx, ny, nz] = header.count, step = Math.max(2, Math.round(Math.cbrt(nx * ny * nz / 8000)));
    for (let z = 0; z < nz; z += step)
      for (let y = 0; y < ny; y += step)
        for (let x = 0; x < nx; x += step) {
          if (winding[(z * ny + y) * nx + x] !== 0) points.push([x, y, z]);
        }
  }
  return points;
}

/**
 * The place of a cell in the order of cutting, as generator/knife numbers cells: the first knife varies slowest.
 * `bits`: the knives on whose positive side the cell lies. Planes of one knife are ordered by their steps; wedges,
 * whose steps are 0, by their angle.
 * @param {number} bits
 * @param {Knife[]} knives
 */
function cellNumber(bits, knives) {
  let number = 0;
  for (let k = 0, end = 0; k < knives.length; k = end) {
    const {laid} = knives[k], first = k;
    for (end = k + 1; laid && end < knives.length && knives[end].laid?.knife === laid.knife;) ++end;
    let cell = 0, positive = 0;
    for (let i = first; i < end; ++i)
      if (bits >> i & 1) {
        ++positive;
        cell += laid ? laid.step : 1;
      }
    if (laid && laid.step === 0) cell = bits >> first & 1 ? positive - 1 : 2 * (end - first) - 1 - positive;
    number = 64 * number + cell;
  }
  return number;
}

/**
 * For each shell around a spared part its cell, and whether a knife passes through it. The cell is the one that has
 * most of it; of those that have `nearlyAsMuch`, the first in the order of cutting (generator/cut/spared.cpp).
 * @param {Shell[]} shells
 * @param {Knife[]} knives
 * @param {number} nearlyAsMuch as a share of the largest
 * @returns {Home[]}
 */
export function homesOf(shells, knives, nearlyAsMuch) {
  return shells.map(({points, rim}) => {
    const bits = new Uint8Array(points.length / 3), onRim = new Uint8Array(rim.length / 3);
    const counts = new Int32Array(1 << knives.length);
    knives.forEach((knife, k) => {
      knife.markSides(points, k, bits);
      knife.markSides(rim, k, onRim);
    });
    if (bits.length === 0) return {cell: onRim[0], isCut: false};
    if (bits.every((b) => b === bits[0]) && onRim.every((b) => b === bits[0])) return {cell: bits[0], isCut: false};
    for (const b of bits) ++counts[b];
    const most = Math.max(...counts);
    const cells = [...counts.keys()].filter((cell) => counts[cell] >= nearlyAsMuch * most);
    return {cell: cells.reduce((a, b) => (cellNumber(b, knives) < cellNumber(a, knives) ? b : a)), isCut: true};
  });
}

/**
 * Pieces by their sides of all knives. A piece with less than a hundredth of the points is a crumb. All of a shell that
 * is cut goes to one cell (`homes`).
 * @param {Point[]} samples
 * @param {Knife[]} knives
 * @param {Shell[]} shells
 * @param {Home[]} homes
 * @returns {Piece[]}
 */
export function piecesOf(samples, knives, shells = [], homes = []) {
  const laid = knives.map((knife) => ({knife, frame: knife.frame, profile: knife.profile}));
  const found = /** @type {Map<number, {cell: number, keep: number[], points: Point[]}>} */ (new Map());
  const add = (/** @type {Point} */ p, /** @type {Home | null} */ home) => {
    const cell = home?.cell ??
      laid.reduce(
        (bits, {knife, frame, profile}, k) => (knife.sideOf(p, frame, profile) > 0 ? bits | 1 << k : bits), 0);
    const piece = found.get(cell) ??
      {cell, keep: knives.map((_, k) => (cell >> k & 1 ? 1 : -1)), points: /** @type {Point[]} */ ([])};
    piece.points.push(p);
    found.set(cell, piece);
  };
  for (const p of samples) add(p, null);
  shells.forEach(({samples: own}, i) => own.forEach((p) => add(p, homes[i])));
  const all = [...found.values()].reduce((sum, {points}) => sum + points.length, 0);
  return [...found.values()]
    .filter(({points}) => points.length > 0.004 * all)
    .map((piece) => ({...piece, middle: V.mul(piece.points.reduce(V.add, [0, 0, 0]), 1 / piece.points.length)}));
}

/**
 * The rigid motion of each piece. Pulled apart, pieces move away from the common middle; opened, the half in front of a
 * single knife swings like the cover of a book, so that both faces are visible, and each half stands on the table.
 * @param {Piece[]} pieces
 * @param {Knife[]} knives
 * @param {Frame} fruit
 * @param {number} apart
 * @param {number} open
 */
export function placed(pieces, knives, fruit, apart, open) {
  const upright = [0, 1, 0];
  /** @type {(points: Point[], at: (p: Point) => number) => number} */
  const least = (points, at) => points.reduce((x, p) => Math.min(x, at(p)), Infinity);
  /** @type {(points: Point[], at: (p: Point) => number) => number} */
  const most = (points, at) => points.reduce((x, p) => Math.max(x, at(p)), -Infinity);
  const low = Math.min(...pieces.map(({points}) => least(points, (p) => p[1])));
  const book = knives.length === 1 && pieces.length === 2 ? open : 0;
  return pieces.map((piece) => {
    const away = V.mul(V.sub(piece.middle, fruit.middle), 1.5 * apart * (1 - book));
    if (book === 0) return {...piece, motion: M.rigid(upright, 0, fruit.middle, away)};
    const {origin, u, v, n} = knives[0].frame;
    const edge = Math.max(...pieces.map(({points}) => most(points, (p) => V.dot(V.sub(p, origin), u))));
    const hinge = V.add(origin, V.mul(u, edge + 0.06 * fruit.reach)), front = piece.keep[0] > 0;
    // Both halves lean inwards slightly.
    const angle = front ? book * (Math.PI - 0.32) : 0, back = V.mul(u, -book * (edge + 0.06 * fruit.reach));
    let motion = M.product(M.rigid(v, book * 0.16, hinge, V.add(back, away)), M.rigid(v, angle, hinge, [0, 0, 0]));
    const lowest = least(piece.points, (p) => M.point(motion, p)[1]);
    motion = M.product(M.rigid(upright, 0, [0, 0, 0], [0, book * (low - lowest), 0]), motion);
    return {...piece, motion, n};
  });
}
