// The camera, and how the fruit fits into the picture.
import {M, V} from './linear.js';

/** @import {Point} from './types.d.ts' */

export class Camera {
  constructor() {
    this.yaw = 0;
    this.pitch = 0;
    this.zoom = 1;
    this.target = [0, 0, 0];
    this.far = 1;
    this.field = 0.42;
  }

  get directions() {
    const {yaw, pitch} = this, c = Math.cos(pitch), back = [c * Math.sin(yaw), Math.sin(pitch), c * Math.cos(yaw)];
    const right = [Math.cos(yaw), 0, -Math.sin(yaw)];
    return {back, right, up: V.cross(back, right)};
  }
  get eye() { return V.add(this.target, V.mul(this.directions.back, this.far / this.zoom)); }

  /**
   * Moves as near as all points fit, with a margin, in the current direction.
   * @param {Point[]} points
   * @param {number} aspect width by height
   */
  fit(points, aspect, margin = 0.86) {
    const {back, right, up} = this.directions, t = Math.tan(this.field / 2) * margin;
    let target = V.mul(points.reduce(V.add, [0, 0, 0]), 1 / points.length), far = 1;
    for (let round = 0; round < 4; ++round) {
      let left = Infinity, rightmost = -Infinity, low = Infinity, high = -Infinity;
      far = 1;
      for (const p of points) {
        const q = V.sub(p, target), x = V.dot(q, right), y = V.dot(q, up), z = V.dot(q, back);
        far = Math.max(far, z + Math.abs(x) / (t * aspect), z + Math.abs(y) / t);
        left = Math.min(left, x);
        rightmost = Math.max(rightmost, x);
        low = Math.min(low, y);
        high = Math.max(high, y);
      }
      target = V.add(target, V.add(V.mul(right, (left + rightmost) / 2), V.mul(up, (low + high) / 2)));
    }
    return {target, far};
  }

  /**
   * @param {number} aspect width by height
   * @param {number} size of the contents
   */
  view(aspect, size) {
    const distance = this.far / this.zoom, near = Math.max(distance - 2.5 * size, distance / 50);
    return M.product(
      M.perspective(this.field, aspect, near, distance + 4 * size), M.lookAt(this.eye, this.target, [0, 1, 0]));
  }

  /**
   * The direction of the ray through a place of the picture, -1 to 1, from bottom to top.
   * @param {number} x
   * @param {number} y
   * @param {number} aspect width by height
   */
  ray(x, y, aspect) {
    const {back, right, up} = this.directions, t = Math.tan(this.field / 2);
    return V.unit(V.sub(V.add(V.mul(right, x * t * aspect), V.mul(up, y * t)), back));
  }
}
