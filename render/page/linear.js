// Vectors and matrices as arrays; matrices by columns, as in OpenGL.

/** @import {Matrix, Numbers, Point} from './types.d.ts' */

export const V = {
  /** @type {(a: Point, b: Point) => Point} */
  add: (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]],
  /** @type {(a: Point, b: Point) => Point} */
  sub: (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]],
  /** @type {(a: Point, s: number) => Point} */
  mul: (a, s) => [a[0] * s, a[1] * s, a[2] * s],
  /** @type {(a: Point, b: Point) => number} */
  dot: (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2],
  /** @type {(a: Point, b: Point) => Point} */
  cross: (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]],
  /** @type {(a: Point) => Point} */
  unit: (a) => V.mul(a, 1 / (Math.hypot(...a) || 1)),
  /**
   * `a` rotated about a unit axis.
   * @param {Point} a
   * @param {Point} axis
   * @param {number} angle radians
   */
  turned(a, axis, angle) {
    const c = Math.cos(angle), s = Math.sin(angle);
    return V.add(V.add(V.mul(a, c), V.mul(V.cross(axis, a), s)), V.mul(axis, V.dot(axis, a) * (1 - c)));
  },
};
export const M = {
  /** @type {() => Matrix} */
  identity: () => new Float32Array([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]),
  /**
   * @param {Numbers} a
   * @param {Numbers} b
   */
  product(a, b) {
    const out = new Float32Array(16);
    for (let c = 0; c < 4; ++c)
      for (let r = 0; r < 4; ++r)
        for (let k = 0; k < 4; ++k) out[4 * c + r] += a[4 * k + r] * b[4 * c + k];
    return out;
  },
  /**
   * @param {number} field radians, of the height
   * @param {number} aspect width by height
   * @param {number} near
   * @param {number} far
   */
  perspective(field, aspect, near, far) {
    const t = 1 / Math.tan(field / 2);
    return new Float32Array(
      [t / aspect, 0, 0, 0, 0, t, 0, 0, 0, 0, (far + near) / (near - far), -1, 0, 0, 2 * far * near / (near - far), 0]);
  },
  /**
   * A box of half-size `reach` around `at`, along directions x, y and z.
   * @param {Point} x
   * @param {Point} y
   * @param {Point} z
   * @param {Point} at
   * @param {number} reach
   * @param {number} depth
   */
  orthographic(x, y, z, at, reach, depth) {
    const rows = [V.mul(x, 1 / reach), V.mul(y, 1 / reach), V.mul(z, -1 / depth)];
    return new Float32Array(
      [0, 1, 2].flatMap((c) => [...rows.map((r) => r[c]), 0]).concat([...rows.map((r) => -V.dot(r, at)), 1]));
  },
  /**
   * @param {Point} eye
   * @param {Point} at
   * @param {Point} up
   */
  lookAt(eye, at, up) {
    const z = V.unit(V.sub(eye, at)), x = V.unit(V.cross(up, z)), y = V.cross(z, x);
    return new Float32Array([
      x[0], y[0], z[0], 0, x[1], y[1], z[1], 0, x[2], y[2], z[2], 0, -V.dot(x, eye), -V.dot(y, eye), -V.dot(z, eye), 1
    ]);
  },
  /**
   * Rotates about an axis through `at`, then moves.
   * @param {Point} axis
   * @param {number} angle radians
   * @param {Point} at
   * @param {Point} move
   */
  rigid(axis, angle, at, move) {
    const x = V.turned([1, 0, 0], axis, angle), y = V.turned([0, 1, 0], axis, angle);
    const z = V.turned([0, 0, 1], axis, angle);
    const moved = V.add(V.sub(at, V.turned(at, axis, angle)), move);
    return new Float32Array([...x, 0, ...y, 0, ...z, 0, ...moved, 1]);
  },
  /**
   * @param {number} scale
   * @param {Point} move
   */
  scaled(scale, move) {
    return new Float32Array([scale, 0, 0, 0, 0, scale, 0, 0, 0, 0, scale, 0, ...move, 1]);
  },
  /**
   * The scale of a matrix that rotates, moves and scales uniformly.
   * @type {(m: Numbers) => number}
   */
  scaleOf: (m) => Math.hypot(m[0], m[1], m[2]),
  /** @type {(m: Numbers, p: Point) => Point} */
  point: (m, [x, y, z]) =>
    [m[0] * x + m[4] * y + m[8] * z + m[12], m[1] * x + m[5] * y + m[9] * z + m[13],
     m[2] * x + m[6] * y + m[10] * z + m[14]],
};
