// Dishes are hollow for MuJoCo, too: no settled piece lies in a convex part of a dish, and all stay in it.
//   node mujoco_dishes.mjs PROGRAM FOLDER SCENE.toml...
import assert from 'node:assert';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync} from 'node:fs';
import {basename, join} from 'node:path';

import {opened, run} from './mujoco.mjs';

const [program, folder, ...scenes] = process.argv.slice(2);
mkdirSync(folder, {recursive: true});
const deepest = 1e-3;  // metres; settled pieces lie in their dishes by a part of this
const simulated = 2;   // seconds

const numbers = (words) => Float64Array.from(words.trim().split(/\s+/), Number);
const turned = ([w, x, y, z], p) => {
  const t = [2 * (y * p[2] - z * p[1]), 2 * (z * p[0] - x * p[2]), 2 * (x * p[1] - y * p[0])];
  return [
    p[0] + w * t[0] + y * t[2] - z * t[1], p[1] + w * t[1] + z * t[0] - x * t[2], p[2] + w * t[2] + x * t[1] - y * t[0]
  ];
};

/** The planes of a convex part, normals outward. */
function planesOf({points, faces}) {
  const planes = [];
  for (let i = 0; i < faces.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => points.subarray(3 * faces[i + k], 3 * faces[i + k] + 3));
    const u = [0, 1, 2].map((k) => b[k] - a[k]), v = [0, 1, 2].map((k) => c[k] - a[k]);
    const n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const length = Math.hypot(...n);
    if (length > 0)
      planes.push([n[0] / length, n[1] / length, n[2] / length, (n[0] * a[0] + n[1] * a[1] + n[2] * a[2]) / length]);
  }
  return planes;
}

const depthIn = (planes, p) => {
  let depth = Infinity;
  for (const [x, y, z, offset] of planes) {
    depth = Math.min(depth, offset - x * p[0] - y * p[1] - z * p[2]);
    if (depth < 0) break;
  }
  return depth;
};

for (const scene of scenes) {
  const xml = join(folder, 'scene.xml');
  execFileSync(
    program, ['scene', scene, '--detail', '0.4', '--quality', 'draft', '--style', 'plain', '--quiet', '-o', xml]);
  const text = readFileSync(xml, 'utf8');
  const meshes = new Map();
  for (const [, name, rest] of text.matchAll(/<mesh name="([^"]*)"([^>]*)>/g)) {
    const attribute = (which) => numbers(new RegExp(` ${which}="([^"]*)"`).exec(rest)?.[1] ?? '0');
    meshes.set(name, {points: attribute('vertex'), faces: attribute('face')});
  }
  const bodies = [...text.matchAll(/<body name="([^"]*)" pos="([^"]*)" quat="([^"]*)">(.*?)<\/body>/gs)].map(
    ([, name, pos, quat, inside]) => ({
      name,
      pos: numbers(pos),
      quat: numbers(quat),
      moves: inside.includes('<freejoint'),
      geoms: (kind) => [...inside.matchAll(new RegExp(`class="${kind}" mesh="([^"]*)"`, 'g'))].map(
        ([, mesh]) => meshes.get(mesh)),
    }));
  const dishes = bodies.filter((body) => !body.moves), pieces = bodies.filter((body) => body.moves);
  assert(dishes.length && pieces.length, `${scene}: dishes and pieces`);
  let worst = -Infinity, worstName = '', parts = 0;
  for (const dish of dishes) {
    const [w, x, y, z] = dish.quat;
    const hulls = dish.geoms('felt').map(planesOf);
    parts += hulls.length;
    for (const piece of pieces) {
      for (const {points} of piece.geoms('seen')) {
        for (let i = 0; i < points.length; i += 3) {
          const p = turned(piece.quat, points.subarray(i, i + 3));
          const inDish = turned([w, -x, -y, -z], [0, 1, 2].map((k) => p[k] + piece.pos[k] - dish.pos[k]));
          for (const planes of hulls) {
            const depth = depthIn(planes, inDish);
            if (depth > worst) worst = depth, worstName = `${piece.name} in ${dish.name}`;
          }
        }
      }
    }
  }
  assert(worst < deepest, `${basename(scene)}: ${worstName} by ${(1000 * worst).toFixed(2)} mm`);

  // Each piece stays over the ground that its dishes cover, and does not fly.
  const simulation = opened(xml);
  const {data, names} = simulation;
  const placeOf = (name) => data.xpos.slice(3 * names.indexOf(name), 3 * names.indexOf(name) + 3);
  const begin = new Map(pieces.map(({name, pos}) => [name, pos]));
  run(simulation, simulated);
  const moved =
    pieces.map(({name}) => [name, Math.hypot(...[0, 1, 2].map((k) => placeOf(name)[k] - begin.get(name)[k]))]);
  const fled = moved.filter(([, way]) => way > 0.15);
  assert.deepEqual(fled, [], `${basename(scene)}: thrown out`);
  console.log(`${basename(scene)}: ${dishes.length} dishes in ${parts} parts, ${pieces.length} pieces; deepest ${
    (1000 * worst).toFixed(2)} mm`);
  simulation.close();
}
