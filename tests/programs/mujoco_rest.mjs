// Cut fruit loads in MuJoCo, weighs what the list of pieces says, and comes to rest within five simulated seconds.
//   node mujoco_rest.mjs PROGRAM FOLDER [TEMPLATE...]   without templates: all that the program lists
// Verdicts stand in FOLDER/rest.tsv; of what has passed there, none is asked again.
import assert from 'node:assert';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';

import {opened, run, speed} from './mujoco.mjs';
import {timeLimit, Verdicts} from './verdicts.mjs';

const [program, folder, ...named] = process.argv.slice(2);
const limit = 600;  // seconds of processor time for the simulations of a template
/** Dice are 25 mm, and of what is larger than 10 cm a quarter of it: a volcano of 25 mm dice has 2 500 of them. */
const knives = ['half', 'across', 'wedges:4', 'slices:5', 'dice'];
const diceOf = (extent) => `dice:${Math.ceil(1000 * Math.max(0.025, extent / 4))}mm`;

const templates = named.length ? named : JSON.parse(execFileSync(program, ['list', '--json'])).map((one) => one.name);

const numbers = (words) => words.trim().split(/\s+/).map(Number);

/** The lowest corner of all that one sees of each body, by its name. */
function lowestCorners(text) {
  const ofMesh = new Map();
  for (const [, name, vertices] of text.matchAll(/<mesh name="([^"]*)" inertia="shell" vertex="([^"]*)"/g)) {
    const low = [Infinity, Infinity, Infinity];
    numbers(vertices).forEach((value, i) => low[i % 3] = Math.min(low[i % 3], value));
    ofMesh.set(name, low);
  }
  const ofBody = new Map();
  for (const [, name, body] of text.matchAll(/<body name="([^"]*)"(.*?)<\/body>/gs)) {
    const lows = [...body.matchAll(/class="seen" mesh="([^"]*)"/g)].map(([, mesh]) => ofMesh.get(mesh));
    ofBody.set(name, [0, 1, 2].map((k) => Math.min(...lows.map((low) => low[k]))));
  }
  return ofBody;
}

const plain = (name) => name.replaceAll(/[^A-Za-z0-9]/g, '_');

/** Cuts a template by all knives, and asks where its pieces are, what they weigh, and whether they rest. */
function ask(template) {
  const wrong = [], begin = process.cpuUsage().user, inTime = timeLimit(limit);
  let pieces = 0, longest = 0, contacts = 0, extent = 0;
  for (const knife of knives) {
    const xml = join(folder, 'cut.xml'), list = join(folder, 'pieces.json');
    execFileSync(program, [
      'cut', template, '--seed', '1', '--knife', knife === 'dice' ? diceOf(extent) : knife, '--detail', '0.4',
      '--quality', 'draft', '--faces', 'coarse', '--style', 'plain', '--quiet', '-o', xml, '--pieces', list
    ]);
    const corners = lowestCorners(readFileSync(xml, 'utf8'));
    const simulation = opened(xml);
    const {model, data, names} = simulation;
    for (const piece of JSON.parse(readFileSync(list)).pieces) {
      extent = Math.max(extent, ...[0, 1, 2].map((k) => piece.high[k] - piece.low[k]));
      const body = names.indexOf(plain(piece.name));
      assert(body > 0, `${knife}: ${piece.name} is not there`);
      ++pieces;
      if (!piece.closed) continue;
      assert(Math.abs(model.body_mass[body] / piece.mass - 1) < 1e-6, `${knife}: mass of ${piece.name}`);
      for (let k = 0; k < 3; ++k) {
        const pivot = piece.low[k] - corners.get(names[body])[k];
        const center = pivot + model.body_ipos[3 * body + k];
        assert(Math.abs(center - piece.center[k]) < 1e-6, `${knife}: centre of ${piece.name}`);
      }
    }
    // At rest: for half a second nothing is faster than a centimetre a second.
    let still = 0;
    const half = 0.5 / model.opt.timestep;
    run(simulation, 5, () => {
      inTime();
      contacts = Math.max(contacts, data.ncon);
      still = speed(simulation, 0.03) < 0.01 ? still + 1 : 0;
      return still >= half;
    });
    if (still < half) wrong.push(`${knife}: ${speed(simulation, 0.03).toFixed(4)} m/s after ${data.time.toFixed(2)} s`);
    longest = Math.max(longest, data.time - 0.5);
    simulation.close();
  }
  const seconds = (process.cpuUsage().user - begin) / 1e6;
  return {wrong, columns: [pieces, longest.toFixed(2), contacts, seconds.toFixed(0)]};
}

const verdicts =
  new Verdicts(program, folder, 'rest', ['template', 'pieces', 'to rest, s', 'contacts', 'processor, s']);
for (const template of templates) verdicts.take(template, () => ask(template));
verdicts.finish(templates);
console.log(`${templates.length} templates by ${knives.length} knives: all pieces at rest`);
