// Knives: a plane through the fruit, and the heights of the blade over it along one direction: none, waves, or a drawn
// stroke. Lengths are in cells of the grid.
import {V} from './linear.js';

/** @import {Frame, KnifeFrame, Numbers, Point} from './types.d.ts' */

export const profilePlaces = 256;
/**
 * The index of the profile's place nearest to s (-1 to 1), or of the next one below or above, by `round`.
 * @type {(s: number, round?: (s: number) => number) => number}
 */
export const profilePlace = (s, round = Math.round) =>
  Math.max(0, Math.min(profilePlaces - 1, round((s * 0.5 + 0.5) * (profilePlaces - 1))));

export class Knife {
  /**
   * Turn and tilt are angles of the plane's normal, radians; shift is its distance from the middle. `laid`: {knife,
   * step} of a plane that the page opened with; they number the knife's cells (render/page/page.h).
   * @param {Frame} fruit
   */
  constructor(fruit, turn = 0, tilt = 0, shift = 0) {
    this.fruit = fruit;
    this.turn = turn;
    this.tilt = tilt;
    this.shift = shift;
    this.waves = 0;
    /** @type {{frame: KnifeFrame, profile: Float32Array} | null} */
    this.drawn = null;
    /** @type {{knife: number, step: number} | null} */
    this.laid = null;
  }
  /**
   * @param {Frame} fruit
   * @param {Point} normal
   * @param {number} offset
   */
  static ofPlane(fruit, normal, offset) {
    const n = V.unit(normal), tilt = Math.asin(Math.max(-1, Math.min(1, n[1])));
    const turn = Math.abs(n[1]) > 0.9999 ? 0 : Math.atan2(n[0], n[2]);
    return new Knife(fruit, turn, tilt, offset - V.dot(n, fruit.middle));
  }
  copy() { return Object.assign(new Knife(this.fruit), this); }
  /**
   * The same knife in another fruit.
   * @param {Frame} fruit
   */
  within(fruit) { return Object.assign(this.copy(), {fruit, shift: this.shift * fruit.size / this.fruit.size}); }

  /** @returns {KnifeFrame} */
  get frame() {
    if (this.drawn) return this.drawn.frame;
    const {turn, tilt, shift, fruit} = this, c = Math.cos(tilt);
    const n = [Math.sin(turn) * c, Math.sin(tilt), Math.cos(turn) * c], u = [Math.cos(turn), 0, -Math.sin(turn)];
    return {origin: V.add(fruit.middle, V.mul(n, shift)), n, u, v: V.cross(n, u), reach: fruit.reach};
  }
  /** Heights at 256 places from one end of u to the other. */
  get profile() {
    if (this.drawn) return this.drawn.profile;
    const {waves, fruit} = this;
    return Float32Array.from(
      {length: profilePlaces},
      (_, i) => waves * 0.045 * fruit.reach * Math.sin(i / (profilePlaces - 1) * 2 * Math.PI * 9));
  }
  get isCurved() { return this.waves > 0 || this.drawn !== null; }

  /**
   * The side of a point: +1 or -1.
   * @param {Point} p
   */
  sideOf(p, frame = this.frame, profile = this.profile) {
    const q = V.sub(p, frame.origin), s = V.dot(q, frame.u) / frame.reach;
    return V.dot(q, frame.n) >= profile[profilePlace(s)] ? 1 : -1;
  }

  /**
   * Passes to `take` the height over the blade of each point, the first three of `stride` numbers.
   * @param {Numbers} points
   * @param {number} stride
   * @param {(i: number, cells: number) => void} take
   */
  overBlade(points, stride, take) {
    const {frame: {origin, n, u, reach}, profile} = this, along = V.mul(u, 1 / reach), offset = V.dot(n, origin);
    const start = V.dot(along, origin);
    for (let i = 0, at = 0; at < points.length; ++i, at += stride) {
      const x = points[at], y = points[at + 1], z = points[at + 2];
      const s = along[0] * x + along[1] * y + along[2] * z - start;
      take(i, n[0] * x + n[1] * y + n[2] * z - offset - profile[profilePlace(s)]);
    }
  }

  /**
   * Sets bit k of the points (three numbers each) on the positive side.
   * @param {Numbers} points
   * @param {number} k
   * @param {Uint8Array} bits
   */
  markSides(points, k, bits) {
    this.overBlade(points, 3, (i, height) => {
      if (height >= 0) bits[i] |= 1 << k;
    });
  }

  /**
   * The knife of a stroke seen along a direction: places on a plane across it, in order. Both ends are extended
   * straight; parts that run back are ignored.
   * @param {Frame} fruit
   * @param {Point[]} points
   * @param {Point} view
   */
  static drawnAlong(fruit, points, view) {
    const first = points[0], last = points[points.length - 1];
    const across = V.sub(V.sub(last, first), V.mul(view, V.dot(V.sub(last, first), view)));
    if (Math.hypot(...across) < 0.1 * fruit.reach) return null;
    const u = V.unit(across), v = V.mul(V.unit(view), -1), n = V.cross(u, v);
    const origin = V.add(fruit.middle, V.mul(n, V.dot(V.sub(V.mul(V.add(first, last), 0.5), fruit.middle), n)));
    const reach = 1.15 * fruit.reach, profile = new Float32Array(profilePlaces);
    const flat = points.map((p) => {
      const q = V.sub(p, origin);
      return [V.dot(q, u), V.dot(q, n)];
    });
    const way = [flat[0]];
    for (const p of flat)
      if (p[0] > way[way.length - 1][0] + 1e-3 * reach) way.push(p);
    for (let i = 0, k = 0; i < profilePlaces; ++i) {
      const s = (2 * i / (profilePlaces - 1) - 1) * reach;
      while (k + 2 < way.length && way[k + 1][0] < s) ++k;
      const a = way[k], b = way[Math.min(k + 1, way.length - 1)];
      const t = b[0] > a[0] ? Math.max(0, Math.min(1, (s - a[0]) / (b[0] - a[0]))) : 0;
      profile[i] = a[1] + t * (b[1] - a[1]);
    }
    const knife = new Knife(fruit);
    knife.drawn = {frame: {origin, n, u, v, reach}, profile: smoothed(smoothed(profile))};
    return knife;
  }

  /** A key of the faces: equal keys, equal faces. */
  get key() {
    const {turn, tilt, shift, waves, drawn} = this;
    return drawn
      ? `stroke ${drawn.frame.origin} ${drawn.frame.n} ${drawn.profile[64]} ${drawn.profile[128]} ${drawn.profile[192]}`
      : [turn, tilt, shift, waves].join();
  }
}

/** @param {Float32Array} profile */
function smoothed(profile) {
  return profile.map((_, i) => {
    let sum = 0, weight = 0;
    for (let k = -4; k <= 4; ++k)
      if (profile[i + k] !== undefined) {
        sum += (5 - Math.abs(k)) * profile[i + k];
        weight += 5 - Math.abs(k);
      }
    return sum / weight;
  });
}
