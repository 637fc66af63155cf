// Fruit that is cut already holds together for ten simulated seconds, and comes apart where its welds are let go; the
// areas that pieces share add up to what knives have laid bare.
//   node mujoco_welds.mjs PROGRAM FOLDER [TEMPLATE:KNIFE...]   without: all templates by slices:8 and wedges:6
// Verdicts stand in FOLDER/welds.tsv; of what has passed there, none is asked again.
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

import {mujoco, opened, run, speed} from './mujoco.mjs';
import {timeLimit, Verdicts} from './verdicts.mjs';

const [program, folder, ...named] = process.argv.slice(2);
const limit = 300;  // seconds of processor time for the simulations of a fruit
const burst = 3;    // metres a second: hulls that overlap throw pieces apart
const all = () => JSON.parse(execFileSync(program, ['list', '--json']))
                    .flatMap(({name}) => ['slices:8', 'wedges:6'].map((knife) => `${name}:${knife}`));

const areaOf = (a, b, c) => {
  const u = [0, 1, 2].map((k) => b[k] - a[k]), v = [0, 1, 2].map((k) => c[k] - a[k]);
  return 0.5 * Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
};

/** The area of all faces of a section in .ply, square metres. */
function areaOfSection(file) {
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
    if (bytes[at] !== 3) throw new Error(`${file}: no triangle`);
    sum += areaOf(...[1, 5, 9].map((offset) => point(bytes.readInt32LE(at + offset))));
    at += 13 + 4;
  }
  return sum;
}

/** The area of all surfaces in .obj, square metres. */
function areaOfSurfaces(file) {
  const points = [];
  let sum = 0;
  for (const line of readFileSync(file, 'latin1').split('\n')) {
    if (line.startsWith('v ')) points.push(line.split(' ').slice(1, 4).map(Number));
    if (!line.startsWith('f ')) continue;
    sum += areaOf(...line.split(' ').slice(1).map((corner) => points[parseInt(corner) - 1]));
  }
  return sum;
}

function ask(fruit) {
  const template = fruit.slice(0, fruit.indexOf(':')), knife = fruit.slice(fruit.indexOf(':') + 1);
  const wrong = [], inTime = timeLimit(limit);
  const [xml, list, every, cut, whole, section] = [
    'welded.xml', 'welded.json', 'every.json', 'cut.obj', 'whole.obj', 'section.ply'
  ].map((name) => join(folder, name));
  const words = [template, '--seed', '1', '--detail', '0.4', '--style', 'plain', '--quiet'];
  const knives = ['--knife', knife, '--quality', 'draft', '--faces', 'coarse'];
  execFileSync(program, ['cut', ...words, ...knives, '--welded', '-o', xml, '--pieces', list]);
  const {contacts, pieces} = JSON.parse(readFileSync(list));
  const around = contacts.filter((contact) => contact.cut < 0).length;

  // With all crumbs, pieces share what knives have laid bare. That is the section, but for what lies within a spared
  // stone; there it is half of what pieces have more of surface than the fruit.
  execFileSync(program, ['cut', ...words, ...knives, '--welded', '--crumbs', '-o', cut, '--pieces', every]);
  if (around) execFileSync(program, ['grow', ...words, '-o', whole]);
  else execFileSync(program, ['cut', ...words, ...knives, '--crumbs', '--section', '-o', section]);
  const area = JSON.parse(readFileSync(every)).contacts.reduce((sum, contact) => sum + contact.area, 0);
  const bare = around ? (areaOfSurfaces(cut) - areaOfSurfaces(whole)) / 2 : areaOfSection(section);
  if (!(Math.abs(area / bare - 1) < 1e-6)) wrong.push(`${area} m2 are shared of ${bare}`);
  if (contacts.some((contact) => !(contact.strength > 0))) wrong.push('a weld holds nothing');
  if (pieces.length < 2) wrong.push('one piece');

  const simulation = opened(xml);
  const {model, data, names} = simulation;
  const placeOf = (body) => data.xpos.slice(3 * body, 3 * body + 3);
  const bodyOf = (name) => names.indexOf(name.replaceAll(/[^A-Za-z0-9]/g, '_'));
  const pairs = contacts.map((contact) => contact.pieces.map(bodyOf));
  mujoco.mj_forward(model, data);
  const apart = () => pairs.map(([a, b]) => Math.hypot(...[0, 1, 2].map((k) => placeOf(a)[k] - placeOf(b)[k])));
  const before = apart();
  run(simulation, 10, inTime);
  const after = apart();
  const slip = Math.max(...after.map((distance, i) => Math.abs(distance - before[i])));
  if (!(slip < 1e-3)) wrong.push(`a weld gives way by ${(1000 * slip).toFixed(2)} mm`);

  // The knife passes: all welds are let go, and gravity and a push take the pieces apart.
  data.eq_active.fill(0);
  const push = 0.3;  // metres a second, along two axes
  for (let body = 1; body < model.nbody; ++body) {
    const freedom = 6 * (body - 1);
    for (let k = 0; k < 2; ++k) data.qvel[freedom + k] = push * Math.sign(Math.sin(7 * body + 3 * k));
  }
  let fastest = 0;
  run(simulation, 12, () => {
    inTime();
    fastest = Math.max(fastest, speed(simulation, 0));
  });
  const released = Math.max(...apart().map((distance, i) => Math.abs(distance - after[i])));
  if (!(released > 1e-3)) wrong.push('it holds without welds');
  if (!(fastest < burst)) wrong.push(`it bursts: ${fastest.toFixed(2)} m/s`);
  simulation.close();
  return {wrong, columns: [contacts.length, around, (1000 * slip).toFixed(3), fastest.toFixed(2)]};
}

const verdicts =
  new Verdicts(program, folder, 'welds', ['fruit', 'welds', 'around stones', 'give way, mm', 'fastest then, m/s']);
const fruits = named.length ? named : all();
for (const fruit of fruits) verdicts.take(fruit, () => ask(fruit));
verdicts.finish(fruits);
console.log(`${fruits.length} fruits hold by their welds, and come apart`);
