// Fruit on the table: one, or several side by side with the same knives.
import {boxOfPoints} from './body.js';
import {M} from './linear.js';

export class Row {
  constructor(bodies) {
    this.bodies = bodies;
    this.takesKnives = true;
    // All at the same scale.
    this.scales = bodies.map((body) => body.fruit.header.spacing / bodies[0].fruit.header.spacing);
  }
  get size() { return this.bodies[0].frame.size; }

  /** The same knife in every body, at the same distance from the middle relative to its size. */
  setKnives(knives) {
    const [first] = this.bodies;
    for (const body of this.bodies)
      body.setKnives(body === first ? knives : knives.map((knife) => knife.within(body.frame)));
  }
  arrange(apart, open) {
    for (const body of this.bodies) {
      body.place = M.identity();
      body.arrange(apart, open);
    }
    if (this.bodies.length === 1) return;
    // Each stands on the table, slightly away from the previous one; a new row begins in front of a full one.
    const gap = 0.12 * this.size, widest = 4.4 * this.size;
    let right = 0, front = 0, deepest = 0;
    this.bodies.forEach((body, i) => {
      const {low, high} = boxOfPoints(body.outline), scale = this.scales[i];
      const [wide, deep] = [scale * (high[0] - low[0]), scale * (high[2] - low[2])];
      if (right > 0 && right + wide > widest) [right, front, deepest] = [0, front + deepest + gap, 0];
      body.moveTo(M.scaled(scale, [right - scale * low[0], -scale * low[1], front - scale * low[2]]));
      right += wide + gap;
      deepest = Math.max(deepest, deep);
    });
  }
}
