// Dishes are hollow for MuJoCo, too: nothing begins within anything else, no convex part of a dish stands out into
// where a settled piece lies, no piece is faster than if it fell, and all stay.
//   node mujoco_dishes.mjs PROGRAM FOLDER [--seconds N] SCENE.toml[:SEED]...
// N of simulated time, 2 unless told; piles of a hundred pieces take MuJoCo two minutes a second.
import assert from 'node:assert';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync} from 'node:fs';
import {basename, join} from 'node:path';

import {mujoco, opened, run, speed} from './mujoco.mjs';

const [program, folder, ...words] = process.argv.slice(2);
const simulated = words[0] === '--seconds' ? Number(words.splice(0, 2)[1]) : 2;
const scenes = words;
mkdirSync(folder, {recursive: true});
const deepest = 1e-3;      // metres that a part holds beyond its dish where a piece lies
const overlapping = 1e-4;  // metres by which shapes overlap at the start
const unseen = 2e-4;       // metres by which a part may stand out without a closer look
const thrown = 0.2;        // metres a second beyond those of a fall

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

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** How far a point is from a triangle. */
function wayTo([a, b, c], p) {
  const normal = cross(minus(b, a), minus(c, a)), length = Math.hypot(...normal);
  let way = Infinity, above = length > 0;
  for (const [from, to] of [[a, b], [b, c], [c, a]]) {
    const edge = minus(to, from), q = minus(p, from);
    if (dot(cross(edge, q), normal) < 0) above = false;
    const share = Math.min(1, Math.max(0, dot(q, edge) / (dot(edge, edge) || 1)));
    way = Math.min(way, Math.hypot(q[0] - share * edge[0], q[1] - share * edge[1], q[2] - share * edge[2]));
  }
  return above ? Math.min(way, Math.abs(dot(minus(p, a), normal)) / length) : way;
}

const trianglesOf = ({points, faces}) => Array.from(
  {length: faces.length / 3},
  (_, i) => [0, 1, 2].map((k) => Array.from(points.subarray(3 * faces[3 * i + k], 3 * faces[3 * i + k] + 3))));

/** How deep a point lies within closed meshes, metres; 0 outside, where their solid angles add up to nothing. */
function depthWithin(triangles, p) {
  let angle = 0;
  for (const triangle of triangles) {
    const [a, b, c] = triangle.map((corner) => minus(corner, p)),
                 [x, y, z] = [a, b, c].map((v) => Math.sqrt(dot(v, v)));
    angle += 2 * Math.atan2(dot(a, cross(b, c)), x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y);
  }
  return angle > 2 * Math.PI ? Math.min(...triangles.map((triangle) => wayTo(triangle, p))) : 0;
}

/** The deepest overlap of shapes at the start, metres, and of which bodies; pieces on the ground count nothing. */
function deepestStart({model, data, names}) {
  mujoco.mj_forward(model, data);
  const bodies = Int32Array.from(model.geom_bodyid);
  let worst = {depth: 0, between: 'nothing'};
  for (let i = 0; i < data.ncon; ++i) {
    const contact = data.contact.get(i), [a, b] = [bodies[contact.geom1], bodies[contact.geom2]];
    if (a && b && -contact.dist > worst.depth) worst = {depth: -contact.dist, between: `${names[a]} and ${names[b]}`};
  }
  return worst;
}

for (const asked of scenes) {
  const [scene, seed] = asked.split(':'), title = basename(scene) + (seed ? `, seed ${seed}` : '');
  const xml = join(folder, 'scene.xml');
  execFileSync(program, [
    'scene', scene, ...(seed ? ['--seed', seed] : []), '--detail', '0.4', '--quality', 'draft', '--style', 'plain',
    '--quiet', '-o', xml
  ]);
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
  assert(dishes.length && pieces.length, `${title}: dishes and pieces`);
  let worst = unseen, worstName = '', parts = 0, settled = 0;
  for (const dish of dishes) {
    const [w, x, y, z] = dish.quat;
    const hulls = dish.geoms('felt').map(planesOf), solid = dish.geoms('seen').flatMap(trianglesOf);
    parts += hulls.length;
    for (const piece of pieces) {
      for (const {points} of piece.geoms('seen')) {
        for (let i = 0; i < points.length; i += 3) {
          const p = turned(piece.quat, points.subarray(i, i + 3));
          const inDish = turned([w, -x, -y, -z], [0, 1, 2].map((k) => p[k] + piece.pos[k] - dish.pos[k]));
          for (const planes of hulls) {
            const inPart = depthIn(planes, inDish);
            if (inPart <= worst) continue;
            // The settling lets pieces overlap by up to 2 % of their size. That is no fault of the part.
            const own = depthWithin(solid, inDish), depth = inPart - own;
            settled = Math.max(settled, own);
            if (depth > worst) worst = depth, worstName = `${piece.name} in ${dish.name}`;
          }
        }
      }
    }
  }
  const millimetres = (metres) => `${(1000 * metres).toFixed(2)} mm`;
  assert(worst < deepest, `${title}: ${worstName} by ${millimetres(worst)}`);

  const simulation = opened(xml);
  const {data, names} = simulation;
  const placeOf = (name) => data.xpos.slice(3 * names.indexOf(name), 3 * names.indexOf(name) + 3);
  const begin = new Map(pieces.map(({name, pos}) => [name, pos]));
  const start = deepestStart(simulation);
  assert(start.depth < overlapping, `${title}: ${start.between} begin ${millimetres(start.depth)} within each other`);

  // In the first tenth of a second nothing is faster than if it fell.
  let push = 0;
  run(simulation, 0.1, () => void (push = Math.max(push, speed(simulation, 0) - 9.81 * data.time)));
  assert(push < thrown, `${title}: a piece is faster than if it fell, by ${push.toFixed(2)} m/s`);
  // Each piece stays over the ground that its dishes cover, and does not fly.
  run(simulation, simulated);
  const moved =
    pieces.map(({name}) => [name, Math.hypot(...[0, 1, 2].map((k) => placeOf(name)[k] - begin.get(name)[k]))]);
  const fled = moved.filter(([, way]) => way > 0.15);
  assert.deepEqual(fled, [], `${title}: thrown out`);
  const farthest = Math.max(...moved.map(([, way]) => way));
  console.log([
    `${title}: ${dishes.length} dishes in ${parts} parts, ${pieces.length} pieces`,
    `parts stand out by ${millimetres(worst)} at most, settled ${millimetres(settled)} deep`,
    `shapes begin ${millimetres(start.depth)} deep`,
    `push ${push.toFixed(2)} m/s, move ${millimetres(farthest)}`,
  ].join('; '));
  simulation.close();
}
