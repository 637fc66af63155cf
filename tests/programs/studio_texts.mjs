// What the studio's page does to texts, without a browser: a template's TOML as a tree that knows its places, ramps
// painted over, coats added and taken away, in all the ways in which templates spell them. With a PROGRAM, its reader
// judges what comes of it.
//   node studio_texts.mjs TEMPLATES [PROGRAM FOLDER]
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {copyFileSync, cpSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

import {colorKind, hexOf, overTheSeam, rampAt, rampEdit, readRamp, shareKind} from '../../cli/studio/page/ramp.js';
import {
  coatPainted,
  groundPainted,
  reachPainted,
  sideOf,
  withCoat,
  withoutCoat
} from '../../cli/studio/page/side_text.js';
import {edited} from '../../cli/studio/page/svg_text.js';
import {surfacesIn} from '../../cli/studio/page/toml_curves.js';
import {entryOf, tomlTree, withEntry, withoutEntry} from '../../cli/studio/page/toml_tree.js';
import {linearOf} from '../../render/page/color.js';

const [templates, program, folder] = process.argv.slice(2);
const files = readdirSync(templates).filter((name) => name.endsWith('.toml'));
const near = (a, b, eps, words) => assert.ok(Math.abs(a - b) <= eps, `${words}: ${a} is not ${b}`);

// Every value of every template stands where the tree says.
for (const name of files) {
  const toml = readFileSync(join(templates, name), 'utf8'), tree = tomlTree(toml);
  const visit = (value) => {
    if (value.kind === 'string') assert.equal(toml.slice(value.inside.from, value.inside.to), value.text);
    if (value.kind === 'plain') assert.equal(toml.slice(value.from, value.to), value.text);
    if (value.items) value.items.forEach(visit);
    if (value.entries)
      for (const [key, entry] of value.entries) {
        if (entry.value.form === undefined) assert.ok(toml.slice(entry.from).includes(key));
        visit(entry.value);
      }
  };
  visit(tree);
  assert.equal(surfacesIn(toml).length, toml.match(/^\[\[surface\]\]/gm)?.length || 0, name);
  for (const surface of surfacesIn(toml)) {
    assert.ok(surface.name && surface.vertical && /^(#|\s*M)/.test(surface.vertical.text), `${name}: ${surface.name}`);
    assert.equal(toml.slice(surface.vertical.from, surface.vertical.to), surface.vertical.text);
    assert.ok(toml.startsWith('[[surface]]', surface.from));
  }
}

// Half a text, broken anywhere, is still read as far as it goes, and never for ever.
const tomato = readFileSync(join(templates, 'tomato.toml'), 'utf8');
for (let at = 0; at < tomato.length; at += 97) surfacesIn(tomato.slice(0, at) + '"[{' + tomato.slice(at));
assert.deepEqual(
  surfacesIn(`[[surface]]\nname = "a\nvertical = "#a"\n[[surface]]\nname = "b"\n`)
    .map(({vertical, name}) => vertical?.text || name),
  ['#a', 'b']);

// The same side, spelled in every way TOML has.
const coats = '{ color = "#102030", along = [[0.2, 0], [0.5, 1], [0.8, 0]] }';
const spelled = {
  inline: `[[surface]]\nname = "skin"\n` +
    `front = { part = "skin", color = [[0.0, "#ff0000"], [0.5, "#00ff00"], [1.0, "#0000ff"]] }  # mine\n`,
  'inline with ramps': `[[surface]]\nname = "skin"\n` +
    `front = { part = "skin", color = { along = [[0.0, "#ff0000"], [0.5, "#00ff00"], [1.0, "#0000ff"]], ` +
    `around = "#ffffff" }, coats = [${coats}] }\n`,
  table: `[[surface]]\nname = "skin"\n\n[surface.front]\npart = "skin"\ncolor = [\n    [0.0, "#ff0000"],  # low\n` +
    `    [0.5, "#00ff00"],\n    [1.0, "#0000ff"],  # high\n]\n# the coats\ncoats = [\n  ${coats},\n]\n`,
  dotted: `[[surface]]\nname = "skin"\n\n[surface.front]\npart = "skin"\n` +
    `color.along = [[0.0, "#ff0000"], [0.5, "#00ff00"], [1.0, "#0000ff"]]\n\n# one\n[[surface.front.coats]]\n` +
    `color = "#102030"\nalong = [[0.2, 0], [0.5, 1], [0.8, 0]]\n\n[surface.back]\npart = "flesh"\n` +
    `color = "#ffffff"\n`,
  'dotted from the surface': `[[surface]]\nname = "skin"\nfront.part = "skin"\n` +
    `front.color.along = [[0.0, "#ff0000"], [0.5, "#00ff00"], [1.0, "#0000ff"]]\nfront.coats = [${coats}]\n`,
  'a table of its own': `[[surface]]\nname = "skin"\n[surface.front]\npart = "skin"\n[surface.front.color]\n` +
    `along = [[0.0, "#ff0000"], [0.5, "#00ff00"], [1.0, "#0000ff"]]\n`,
};
const red = linearOf('#ff0000'), white = linearOf('#ffffff'), stroke = [[[0.3, 0], [0.4, 1], [0.6, 1], [0.7, 0]]];
for (const [how, toml] of Object.entries(spelled)) {
  const front = (text) => sideOf(tomlTree(text), 0, 'front'), before = front(toml);
  assert.ok(before.ground.along, how);

  // Paint covers where the stroke was thick, is mixed in linear light where it was thin, and leaves the rest alone.
  const painted = groundPainted(toml, before, stroke, white), ramp = front(painted).ground.along;
  for (const t of [0.4, 0.5, 0.6]) assert.equal(hexOf(rampAt(ramp, t)), '#ffffff', how);
  for (const t of [0, 0.1, 0.3, 0.7, 0.9, 1])
    rampAt(ramp, t).forEach((v, k) => near(v, rampAt(before.ground.along, t)[k], 0.02, `${how} at ${t}`));
  rampAt(ramp, 0.35)
    .forEach((v, k) => near(v, 0.5 + 0.5 * rampAt(before.ground.along, 0.35)[k], 0.06, `${how}, the soft edge`));
  assert.equal(ramp.stops.length, 6, how);
  for (const line of toml.split('\n').filter((text) => text.includes('#') && !text.includes('#00ff00')))
    assert.ok(painted.includes(line), `${how} loses: ${line}`);

  // A coat more, over the others; painted, wiped, taken away again: the text is as it was.
  const added = withCoat(toml, before, {color: '"#abcdef"', along: '[[0.1, 0], [0.2, 1]]'});
  const count = before.coats.length;
  assert.equal(front(added).coats.length, count + 1, how);
  const coat = front(added).coats[count];
  assert.equal(hexOf(coat.color.stops[0].value), '#abcdef');
  assert.equal(withoutCoat(added, front(added), count).replace(/\n+/g, '\n'), toml.replace(/\n+/g, '\n'), how);
  const turned = edited(added, [reachPainted(added, coat, 'turn', [[[0.5, 0], [0.6, 1], [0.7, 0]]])]);
  const turn = overTheSeam(front(turned).coats[count].turn);
  near(rampAt(turn, 0.6), 1, 0, how);
  near(rampAt(turn, 0.2), 0, 0, how);
  near(rampAt(turn, 0.95), 0, 0, how);
  const wiped = edited(turned, [reachPainted(
                                 turned, front(turned).coats[count], 'turn',
                                 [[[0.5, 0], [0.55, 1], [0.65, 1], [0.7, 0]]], {erase: true})]);
  near(rampAt(overTheSeam(front(wiped).coats[count].turn), 0.6), 0, 0.02, how);

  // In another colour: this one there, the old one elsewhere.
  const two = coatPainted(added, coat, [[[0.5, 0], [0.6, 1], [0.8, 1], [0.9, 0]]], red);
  const both = front(two).coats[count];
  assert.equal(hexOf(rampAt(both.color, 0.7)), '#ff0000', how);
  assert.equal(hexOf(rampAt(both.color, 0.2)), '#abcdef', how);
  near(rampAt(both.along, 0.7), 1, 0, how);
  if (count > 0) assert.ok(!withoutCoat(toml, before, 0).includes('102030'));
}

// Painted over with what is there already, a ramp stays as it was; stops are no more than are needed after many
// strokes.
let text = `[[surface]]\nfront = { color = [[0.0, "#ff0000"], [0.5, "#ff0000"], [1.0, "#ff0000"]] }\n`;
for (let k = 0; k < 60; ++k)
  text = groundPainted(
    text, sideOf(tomlTree(text), 0, 'front'),
    [[[k / 100, 0], [k / 100 + 0.05, 1], [k / 100 + 0.3, 1], [k / 100 + 0.35, 0]]], red);
assert.ok(sideOf(tomlTree(text), 0, 'front').ground.along.stops.length <= 3, text);

// A ramp around the whole fruit goes over the seam as the reader has it.
const seam = readRamp(shareKind, tomlTree('a = [[0.2, 0.0], [0.6, 1.0]]').entries.get('a').value, 1);
near(rampAt(overTheSeam(seam), 0), 1 / 3, 1e-9, 'the seam');
near(rampAt(overTheSeam(seam), 0.9), 0.5, 1e-9, 'beyond the last stop');

// A stop is taken away or put in anywhere, and comments stay.
const listed = 'a = [\n  [0.0, "#000000"],  # first\n  [0.5, "#111111"],  # middle\n  [1.0, "#222222"]  # last\n]\n';
for (let gone = 0; gone < 3; ++gone) {
  const old = readRamp(colorKind, tomlTree(listed).entries.get('a').value);
  const left = edited(listed, [rampEdit(listed, old, old.stops.filter((_, k) => k !== gone))]);
  const again = readRamp(colorKind, tomlTree(left).entries.get('a').value);
  assert.deepEqual(again.stops.map(({at}) => at), [0, 0.5, 1].filter((_, k) => k !== gone), left);
  for (const word of ['first', 'middle', 'last']) assert.ok(left.includes(`# ${word}`), left);
}

// Keys come and go in tables of every kind.
for (const [toml, path] of [
       ['[a]\nb = 1\n', ['a']], ['a = { b = 1 }\n', ['a']], ['a.b = 1\n', ['a']], ['a = { b.c = 1 }', ['a', 'b']],
       ['[a.b]\nc = 1\n', ['a']]]) {
  const more = edited(toml, [withEntry(toml, entryOf(tomlTree(toml), ...path), 'x', '2')]);
  assert.equal(entryOf(tomlTree(more), ...path, 'x')?.text, '2', more);
  const less = edited(more, [withoutEntry(more, entryOf(tomlTree(more), ...path), 'x')]);
  assert.equal(entryOf(tomlTree(less), ...path, 'x'), undefined, less);
}

// Every side of every template, painted, coated and wiped, is accepted by the program.
if (program) {
  rmSync(folder, {recursive: true, force: true});
  mkdirSync(folder, {recursive: true});
  for (const name of readdirSync(templates).filter(
         (file) => !file.endsWith('.toml') && /\.(svg|ply|glb|obj)$/.test(file)))
    copyFileSync(join(templates, name), join(folder, name));
  // What some of them place, and the textures of others.
  for (const beside of ['organs', 'textures']) cpSync(join(templates, beside), join(folder, beside), {recursive: true});
  for (const name of files) {
    let toml = readFileSync(join(templates, name), 'utf8');
    surfacesIn(toml).forEach((_, index) => ['front', 'back'].forEach((which) => {
      const side = () => sideOf(tomlTree(toml), index, which), type = surfacesIn(toml)[index].type;
      if (!side()?.ground.along) return;
      toml = groundPainted(toml, side(), stroke, white);
      toml = withCoat(toml, side(), {color: '"#abcdef"'});
      toml = coatPainted(toml, side().coats.at(-1), stroke, red);
      toml = edited(toml, [reachPainted(
                            toml, side().coats.at(-1), type === 'in-fold' ? 'around' : 'turn',
                            [[[0, 1], [0.1, 0]], [[0.8, 0], [1, 1]]])]);
      if (side().coats.length > 1) toml = withoutCoat(toml, side(), 0);
    }));
    writeFileSync(join(folder, name), toml);
  }
  execFileSync(program, ['check', ...files, '--quiet'], {cwd: folder, stdio: ['ignore', 'ignore', 'inherit']});
}
