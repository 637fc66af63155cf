// Pieces of a scene as they lie, or pulled apart. Lengths are multiples of a fruit's cell, so that light and shadow are
// as on the page of a fruit.
import {boxOfPoints} from './body.js';
import {M, V} from './linear.js';

export class Pile {
  /** `bodies`, each with `instance`: {rotation, translation} in metres; `unit`: the length of 1, in metres. */
  constructor(bodies, unit) {
    this.bodies = bodies;
    this.unit = unit;
    this.takesKnives = false;
    this.size = 1;
    const lying = bodies.map((body) => {
      const {origin, spacing} = body.fruit.header, {rotation: [w, x, y, z], translation} = body.instance;
      const turned = (p) => {
        const t = V.mul(V.cross([x, y, z], p), 2);
        return V.add(V.add(p, V.mul(t, w)), V.cross([x, y, z], t));
      };
      const s = spacing / unit, [a, b, c] = [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map((axis) => V.mul(turned(axis), s));
      return new Float32Array([...a, 0, ...b, 0, ...c, 0, ...V.mul(V.add(turned(origin), translation), 1 / unit), 1]);
    });
    const middles = bodies.map((body, i) => M.point(lying[i], body.frame.middle));
    const moving = middles.filter((_, i) => bodies[i].moves);
    const middle = moving.length ? V.mul(moving.reduce(V.add, [0, 0, 0]), 1 / moving.length) : [0, 0, 0];
    this.lying = lying.map((place, i) => ({place, away: bodies[i].moves ? V.sub(middles[i], middle) : null}));
    this.arrange(0);
    const {low, high} = boxOfPoints(bodies.flatMap((body) => body.outline));
    this.size = 0.5 * Math.max(...V.sub(high, low));
  }

  setKnives() {}
  /** Pieces move away from the common middle and rise out of their dish; dishes stay. */
  arrange(apart) {
    this.bodies.forEach((body, i) => {
      const {place, away} = this.lying[i], moved = place.slice();
      if (away && apart > 0)
        [1.6 * away[0], 1.5 * away[1] + 1.1 * this.size, 1.6 * away[2]].forEach((d, k) => {
          moved[12 + k] += apart * d;
        });
      body.place = moved;
      body.arrange(body.knives.length > 0 ? 0.12 : 0, 0);
    });
  }
}
