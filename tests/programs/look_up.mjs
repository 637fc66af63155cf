// The look-up in JavaScript against the C++ field, at all points of the squares that write_sections has left.
//   node look_up.mjs FOLDER [--table]    fails if a bar is missed; --table prints a table of all templates, the worst
//   of their seeds, as docs/reference/page.md has it
import {readdirSync, readFileSync, statSync} from 'node:fs';
import {inflateSync} from 'node:zlib';

import * as LookUp from '../../render/page/look_up.js';
import * as Asset from '../../render/page/read_asset.js';
import * as Skin from '../../render/page/skin.js';

import {errorsOf, holds, line, readSections, srgb} from './section_errors.mjs';

const [folder, how] = process.argv.slice(2);
let missed = 0, seen = 0;
const rows = new Map();  // by template: the worst of its planes and seeds

/**
 * An asset's surfaces lie up to half a unit from where they were: nearer than a unit to one, the colours of both its
 * sides are right.
 */
function nearestColor(lookUp, units, place, truth) {
  const away = (color) => (color === null ? Infinity : Math.max(...color.map((c, k) => Math.abs(c - srgb(truth[k])))));
  const here = lookUp(place);
  if (here === null || away(here) < 3) return here;
  const beside =
    [0, 1, 2].flatMap((axis) => [1, -1].map((way) => lookUp(place.map((x, k) => (k === axis ? x + way / units : x)))));
  return beside.reduce((best, color) => (away(color) < away(best) ? color : best), here);
}

/**
 * Parts of nodes are found along rows; that they are much the same from either end is asked of what is sunk in the
 * flesh: behind a stem a row is in the flesh again. The share of its nodes that only one of both ends calls so: a few
 * at soft borders, most where a row took the stem's part along.
 */
function oneSided(fruit, part) {
  const [nx] = fruit.count;
  const mirrored = {
    ...fruit,
    position: fruit.position.map((p, i) => (i % 3 === 0 ? (nx - 1) * fruit.units - p - 1 : p)),
    triangle: fruit.triangle.map((v, i, all) => (i % 3 === 0 ? v : all[i + (i % 3 === 1 ? 1 : -1)]))
  };
  Asset.addWindings(mirrored);
  let either = 0, one = 0;
  fruit.nodePart.forEach((here, i) => {
    const there = mirrored.nodePart[i - i % nx + nx - 1 - i % nx];
    if (here !== part + 1 && there !== part + 1) return;
    ++either;
    if (here !== there) ++one;
  });
  return either > 0 ? one / either : 0;
}
/**
 * An outline stays whole where surfaces meet at a sharp angle: corners at one place move one way, be their normals as
 * they may. Tells how many share a place, and how many of these do not.
 */
let sharing = 0;
function torn(fruit) {
  const {skin, index} = Skin.joined(Skin.built(fruit)), ways = Skin.outwards(skin, index), known = new Map();
  let count = 0;
  for (let v = 0; v < skin.length / 10; ++v) {
    const place = skin.subarray(10 * v, 10 * v + 3).join(), way = ways.subarray(3 * v, 3 * v + 3).join();
    if (known.has(place) && known.get(place) !== way) ++count;
    known.set(place, way);
  }
  sharing += skin.length / 10 - known.size;
  return count;
}
for (const file of readdirSync(folder).filter((name) => name.endsWith('.pomona')).sort()) {
  const name = file.slice(0, -7), packed = readFileSync(`${folder}/${file}`);
  const fruit = Asset.decoded(new Uint8Array(inflateSync(packed.subarray(8)))), lists = LookUp.cells(fruit);
  const hull = LookUp.range(fruit);
  const all = [], stem = fruit.header.parts.indexOf('stem');
  if (stem >= 0 && oneSided(fruit, stem) > 0.3) {
    ++missed;
    console.log(`${name}: nodes beside the stem have its part`);
  }
  if (torn(fruit) > 0) {
    ++missed;
    console.log(`${name}: an outline is torn`);
  }
  for (const square of readSections(folder, name)) {
    const {size, origin, u, v, reach} = square;
    const errors = errorsOf(square, (i) => {
      const s = reach * (2 * (i % size + 0.5) / size - 1), t = reach * (2 * (Math.floor(i / size) + 0.5) / size - 1);
      const lookUp = (place) => {
        const found = LookUp.at(fruit, lists, hull, place);
        return found && found.color.map(srgb);
      };
      return nearestColor(
        lookUp, fruit.units, [0, 1, 2].map((k) => origin[k] + s * u[k] + t * v[k]),
        square.truth.subarray(4 * i, 4 * i + 3));
    });
    ++seen;
    all.push(errors);
    if (!holds(errors)) ++missed;
    if (how !== '--table' || !holds(errors))
      console.log(`${name} ${square.name}: ${line(errors)}${holds(errors) ? '' : ': a bar is missed'}`);
  }
  // Okra is long and thin: of its squares some fifty pixels count; of a leaf, which is thinner than what is left out
  // beside rims, none does.
  const template = name.replace(/-\d+$/, ''), counts = all.some((e) => e.pixels > 40);
  if (!counts && template !== 'spinach') ++missed;
  const row = rows.get(template) ?? {seeds: 0, size: 0, rms: 0, p95: 0, wrong: 0};
  ++row.seeds;
  row.counts ||= counts;
  row.size = Math.max(row.size, statSync(`${folder}/${name}.html`).size);
  for (const key of ['rms', 'p95', 'wrong']) row[key] = Math.max(row[key], ...all.map((e) => e[key]));
  rows.set(template, row);
}
if (how === '--table') {
  console.log('| | seeds | page, KB | RMS | 95th percentile | in or out wrong |\n|---|---|---|---|---|---|');
  for (const [name, row] of rows)
    console.log(`| ${name} | ${row.seeds} | ${Math.round(row.size / 1000)} | ${
      row.counts ? `${row.rms.toFixed(2)} | ${row.p95.toFixed(2)} | ${row.wrong}` : '| |'} |`);
}
if (sharing === 0) console.log('no skin has a sharp edge: outlines were asked nothing');
process.exit(missed > 0 || seen === 0 || sharing === 0 ? 1 : 0);
