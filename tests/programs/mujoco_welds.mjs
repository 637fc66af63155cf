// Fruit that is cut already holds together for ten simulated seconds, and comes apart where its welds are let go; the
// areas that pieces share add up to the section's.
//   node mujoco_welds.mjs PROGRAM FOLDER [TEMPLATE:KNIFE...]   without: all templates by slices:8 and wedges:6
import assert from 'node:assert';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';

import {mujoco, opened, run} from './mujoco.mjs';

const [program, folder, ...named] = process.argv.slice(2);
mkdirSync(folder, {recursive: true});
const all = () => JSON.parse(execFileSync(program, ['list', '--json']))
                    .flatMap(({name}) => ['slices:8', 'wedges:6'].map((knife) => `${name}:${knife}`));

/** The area of all faces of a section in .ply, square metres. */
function areaOf(file) {
  const bytes = readFileSync(file);
  const end = bytes.indexOf('end_header\n') + 11;
  const header = bytes.subarray(0, end).toString('latin1');
  const size = {float: 4, uchar: 1, int: 4};
  const count = (what) => Number(new RegExp(`element ${what} (\\d+)`).exec(header)[1]);
  const properties =
    header.slice(header.indexOf('element vertex'), header.indexOf('element face')).matchAll(/property (\w+) (\w+)/g);
  const stride = [...properties].reduce((sum, [, type]) => sum + size[type], 0);
  const point = (i) => [0, 4, 8].map((offset) => bytes.readFloatLE(end + i * stride + offset));
  let at = end + count('vertex') * stride, sum = 0;
  for (let f = 0; f < count('face'); ++f) {
    assert.equal(bytes[at], 3);
    const [a, b, c] = [1, 5, 9].map((offset) => point(bytes.readInt32LE(at + offset)));
    const u = [0, 1, 2].map((k) => b[k] - a[k]), v = [0, 1, 2].map((k) => c[k] - a[k]);
    sum += 0.5 * Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
    at += 13 + 4;
  }
  return sum;
}

const wrong = [];
let welds = 0;
const fruits = named.length ? named : all();
for (const fruit of fruits) {
  const template = fruit.slice(0, fruit.indexOf(':')), knife = fruit.slice(fruit.indexOf(':') + 1);
  const xml = join(folder, 'welded.xml'), list = join(folder, 'welded.json'), section = join(folder, 'section.ply');
  const words = [
    'cut', template, '--seed', '1', '--knife', knife, '--detail', '0.4', '--quality', 'draft', '--faces', 'coarse',
    '--style', 'plain', '--quiet'
  ];
  execFileSync(program, [...words, '--welded', '-o', xml, '--pieces', list]);
  execFileSync(program, [...words, '--section', '-o', section]);
  const {contacts, pieces} = JSON.parse(readFileSync(list));
  const area = contacts.reduce((sum, contact) => sum + contact.area, 0), cut = areaOf(section);
  if (!(Math.abs(area / cut - 1) < 1e-6)) wrong.push(`${fruit}: ${area} m2 are shared of ${cut}`);
  if (contacts.some((contact) => !(contact.strength > 0))) wrong.push(`${fruit}: a weld holds nothing`);
  welds += contacts.length;

  const simulation = opened(xml);
  const {model, data, names} = simulation;
  const placeOf = (body) => data.xpos.slice(3 * body, 3 * body + 3);
  const bodyOf = (name) => names.indexOf(name.replaceAll(/[^A-Za-z0-9]/g, '_'));
  const pairs = contacts.map((contact) => contact.pieces.map(bodyOf));
  mujoco.mj_forward(model, data);
  const apart = () => pairs.map(([a, b]) => Math.hypot(...[0, 1, 2].map((k) => placeOf(a)[k] - placeOf(b)[k])));
  const before = apart();
  run(simulation, 10);
  const after = apart();
  const slip = Math.max(...after.map((distance, i) => Math.abs(distance - before[i])));
  if (!(slip < 1e-3)) wrong.push(`${fruit}: a weld gives way by ${(1000 * slip).toFixed(2)} mm`);

  // The knife passes: all welds are let go, and gravity and a push take the pieces apart.
  data.eq_active.fill(0);
  for (let body = 1; body < model.nbody; ++body) {
    const freedom = 6 * (body - 1);
    for (let k = 0; k < 2; ++k) data.qvel[freedom + k] = 0.3 * Math.sign(Math.sin(7 * body + 3 * k));
  }
  run(simulation, 12);
  const released = Math.max(...apart().map((distance, i) => Math.abs(distance - after[i])));
  if (!(released > 2e-3)) wrong.push(`${fruit}: it holds without welds`);
  if (pieces.length < 2) wrong.push(`${fruit}: one piece`);
  simulation.close();
}
assert.deepEqual(wrong, []);
console.log(`${fruits.length} fruits hold by ${welds} welds, and come apart`);
