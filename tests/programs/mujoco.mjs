// MuJoCo, from npm, and what tests ask of it.
import load from 'mujoco-js';
import {readFileSync} from 'node:fs';

export const mujoco = await load();
mujoco.FS.mkdir('/models');

/** A model and its state. Free them by close(). */
export function opened(file) {
  const inside = '/models/model.xml';
  mujoco.FS.writeFile(inside, readFileSync(file));
  let model;
  try {
    model = mujoco.MjModel.loadFromXML(inside);
  } catch (fault) {
    // A pointer to the message, as Emscripten throws it.
    throw new Error(`MuJoCo refuses ${file}: ${fault?.message ?? fault}`);
  }
  const data = new mujoco.MjData(model);
  const names = [];
  for (let body = 1; body < model.nbody; ++body) names[body] = mujoco.mj_id2name(model, 1, body);
  return {model, data, names, close: () => (data.delete(), model.delete())};
}

/** Steps until the time, seconds; calls watch() after each, which may end it by returning true. */
export function run({model, data}, until, watch = () => false) {
  while (data.time < until) {
    mujoco.mj_step(model, data);
    if (watch()) break;
  }
}

/** The largest speed of any body, metres a second and radians a second times `reach`, metres. */
export function speed({model, data}, reach) {
  let largest = 0;
  const velocity = data.qvel;
  for (let i = 0; i + 5 < model.nv; i += 6) {
    largest = Math.max(
      largest, Math.hypot(velocity[i], velocity[i + 1], velocity[i + 2]),
      reach * Math.hypot(velocity[i + 3], velocity[i + 4], velocity[i + 5]));
  }
  return largest;
}
