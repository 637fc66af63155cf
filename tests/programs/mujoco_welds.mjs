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
const limit = 600;  // seconds of processor time for a fruit's simulations
const burst = 3;    // metres a second: hulls that overlap throw pieces apart
const all = () => JSON.parse(execFileSync(program, ['list', '--json']))
                    .flatMap(({name}) => ['slices:8', 'wedges:6'].map((knife) => `${name}:${knife}`));

/** The area of all surfaces in .obj, square metres. */
function areaOf(file) {
  const points = [];
  let sum = 0;
  for (const line of readFileSync(file, 'latin1').split('\n')) {
    if (line.startsWith('v ')) points.push(line.split(' ').slice(1, 4).map(Number));
    if (!line.startsWith('f ')) continue;
    const [a, b, c] = line.split(' ').slice(1).map((corner) => points[parseInt(corner) - 1]);
    const u = [0, 1, 2].map((k) => b[k] - a[k]), v = [0, 1, 2].map((k) => c[k] - a[k]);
    sum += 0.5 * Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  }
  return sum;
}

function ask(fruit) {
  const template = fruit.slice(0, fruit.indexOf(':')), knife = fruit.slice(fruit.indexOf(':') + 1);
  const wrong = [], inTime = timeLimit(limit);
  const [xml, list, cut, whole] =
    ['welded.xml', 'welded.json', 'cut.obj', 'whole.obj'].map((name) => join(folder, name));
  const words = [template, '--seed', '1', '--detail', '0.4', '--style', 'plain', '--quiet'];
  const knives = ['--knife', knife, '--quality', 'draft', '--faces', 'coarse'];
  execFileSync(program, ['cut', ...words, ...knives, '--welded', '-o', xml, '-o', cut, '--pieces', list]);
  execFileSync(program, ['grow', ...words, '-o', whole]);
  const {contacts, pieces} = JSON.parse(readFileSync(list));
  const area = contacts.reduce((sum, contact) => sum + contact.area, 0), bare = (areaOf(cut) - areaOf(whole)) / 2;
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
  if (!(released > 2e-3)) wrong.push('it holds without welds');
  if (!(fastest < burst)) wrong.push(`it bursts: ${fastest.toFixed(2)} m/s`);
  simulation.close();
  const around = contacts.filter((contact) => contact.cut < 0).length;
  return {wrong, columns: [contacts.length, around, (1000 * slip).toFixed(3), fastest.toFixed(2)]};
}

const verdicts =
  new Verdicts(program, folder, 'welds', ['fruit', 'welds', 'around stones', 'give way, mm', 'fastest then, m/s']);
const fruits = named.length ? named : all();
for (const fruit of fruits) verdicts.take(fruit, () => ask(fruit));
verdicts.finish(fruits);
console.log(`${fruits.length} fruits hold by their welds, and come apart`);
