// What the page's and the studio's scripts mean, without a browser: frames, sides, colours, curves, and an asset read
// back.
//   node page_test.mjs PROGRAM FOLDER      FOLDER holds box.toml and box.ply
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {inflateSync} from 'node:zlib';

import {Bezier} from '../../cli/studio/page/bezier.js';
import {History} from '../../cli/studio/page/history.js';
import {hexOf} from '../../cli/studio/page/ramp.js';
import {A, attributeOf, edited, elementsOf, encoded, offsetOf} from '../../cli/studio/page/svg_text.js';
import {Camera} from '../../render/page/camera.js';
import {linearOf} from '../../render/page/color.js';
import {Knife} from '../../render/page/knives.js';
import {M, V} from '../../render/page/linear.js';
import * as LookUp from '../../render/page/look_up.js';
import {piecesOf} from '../../render/page/pieces.js';
import * as Asset from '../../render/page/read_asset.js';

const [program, folder] = process.argv.slice(2);
const near = (a, b, close, about) => {
  assert.equal(a.length, b.length, about);
  a.forEach((x, k) => assert.ok(Math.abs(x - b[k]) <= close, `${about}: ${[...a]} is not ${[...b]}`));
};

// Turns are those of the right hand; a camera sees its target in the middle, what is right of it on the right.
near(V.turned([1, 0, 0], [0, 1, 0], Math.PI / 2), [0, 0, -1], 1e-12, 'turned');
const through = (m, p) => {
  const q = [0, 1, 2, 3].map((r) => m[r] * p[0] + m[4 + r] * p[1] + m[8 + r] * p[2] + m[12 + r]);
  return q.slice(0, 3).map((v) => v / q[3]);
};
near(through(M.rigid([0, 1, 0], Math.PI / 2, [1, 0, 0], [0, 5, 0]), [2, 3, 0]), [1, 8, -1], 1e-6, 'rigid');
near(
  through(
    M.product(M.rigid([0, 1, 0], 0, [0, 0, 0], [1, 2, 3]), M.rigid([0, 0, 1], Math.PI / 2, [0, 0, 0], [0, 0, 0])),
    [1, 0, 0]),
  [1, 3, 3], 1e-6, 'product: the right one first');
const camera = Object.assign(new Camera(), {yaw: 0.4, pitch: 0.3, target: [3, 4, 5], far: 10});
near(
  camera.eye,
  V.add([3, 4, 5], [10 * Math.cos(0.3) * Math.sin(0.4), 10 * Math.sin(0.3), 10 * Math.cos(0.3) * Math.cos(0.4)]), 1e-9,
  'eye');
const view = camera.view(1.5, 2), {right, up} = camera.directions;
near(through(view, [3, 4, 5]).slice(0, 2), [0, 0], 1e-6, 'the target');
const half = Math.tan(camera.field / 2) * 10;
near(through(view, V.add([3, 4, 5], V.mul(right, half))).slice(0, 2), [1 / 1.5, 0], 1e-5, 'right');
near(through(view, V.add([3, 4, 5], V.mul(up, half))).slice(0, 2), [0, 1], 1e-5, 'up');
const fitted = camera.fit([[0, 0, 0], [4, 2, 1], [1, 5, 2]], 1.5);
Object.assign(camera, fitted);
for (const p of [[0, 0, 0], [4, 2, 1], [1, 5, 2]])
  assert.ok(
    Math.max(...through(camera.view(1.5, 5), p).slice(0, 2).map(Math.abs)) < 1, 'all points are in the picture');

// Colours: IEC 61966-2-1 there and back.
const linearByRule = (byte) => (byte / 255 <= 0.04045 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
near(linearOf('#0a80f0'), [10, 128, 240].map(linearByRule), 1e-9, 'linearOf');
near([...Asset.linear], Array.from({length: 256}, (_, i) => linearByRule(i)), 1e-9, 'linear');
assert.equal(hexOf([0, 5, 17, 130, 251].slice(1, 4).map(linearByRule)), '#051182');

// A knife's plane is the one it was made of; the side is that of its normal, the bit that of its number.
const frame = {
  middle: [5, 6, 7],
  reach: 20,
  size: 30
};
for (const [normal, offset] of [
       [[1, 0, 0], 3], [[0, 1, 0], 8], [[0.6, 0, 0.8], 9], [[0.48, 0.6, 0.64], 12], [[-0.6, 0.8, 0], 2]]) {
  const knife = Knife.ofPlane(frame, normal, offset), {n, u, v, origin} = knife.frame;
  near(n, normal, 1e-9, 'normal');
  near([V.dot(origin, normal)], [offset], 1e-9, 'offset');
  near(V.cross(u, v), n, 1e-9, 'a right-handed frame');
  for (const p of [[0, 0, 0], [9, 9, 9], [5, -3, 20]])
    assert.equal(knife.sideOf(p), V.dot(p, normal) >= offset ? 1 : -1, `side of ${p}`);
  const bits = new Uint8Array(2);
  knife.markSides([...V.add(origin, n), ...V.sub(origin, n)], 2, bits);
  assert.deepEqual([...bits], [4, 0]);
}
const knives = [Knife.ofPlane(frame, [1, 0, 0], 5), Knife.ofPlane(frame, [0, 0, 1], 4)];
const grid =
  Array.from({length: 1000}, (_, i) => [i % 10 + 0.5, Math.floor(i / 10) % 10 + 0.5, Math.floor(i / 100) + 0.5]);
const pieces = piecesOf(grid, knives);
assert.equal(pieces.length, 4);
for (const {cell, keep, points, middle} of pieces) {
  const [over, beyond] = [cell & 1, cell >> 1 & 1];
  assert.deepEqual(keep, [over ? 1 : -1, beyond ? 1 : -1]);
  assert.equal(points.length, 500 * (beyond ? 0.6 : 0.4));
  near(middle, [over ? 7.5 : 2.5, 5, beyond ? 7 : 2], 1e-9, 'middle');
}

// An asset read back: the box's corners, each with its colour; the look-up inside.
execFileSync(program, ['grow', 'box.toml', '-o', 'box.pomona', '--quiet'], {cwd: folder});
const fruit = Asset.decoded(new Uint8Array(inflateSync(readFileSync(join(folder, 'box.pomona')).subarray(8))));
const {origin, spacing} = fruit.header;
const rows = readFileSync(join(folder, 'box.ply'), 'utf8').split('end_header\n')[1].split('\n').slice(0, 8);
const corners = rows.map((row) => row.split(' ').map(Number));
const srgb = (v) => 255 * (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055);
for (let i = 0; i < fruit.position.length / 3; ++i) {
  const place = [0, 1, 2].map((k) => origin[k] + spacing * (fruit.position[3 * i + k] + 0.5) / fruit.units);
  const corner =
    corners.reduce((best, c) => (Math.hypot(...V.sub(c, place)) < Math.hypot(...V.sub(best, place)) ? c : best));
  near(place, corner.slice(0, 3), spacing / fruit.units, 'place');
  near([...fruit.front.slice(3 * i, 3 * i + 3)], corner.slice(3, 6).map(srgb), 2, 'front');
  near([...fruit.back.slice(3 * i, 3 * i + 3)], corner.slice(6, 9).map(srgb), 2, 'back');
}
const lists = LookUp.cells(fruit), hull = LookUp.range(fruit);
const look = (p) => LookUp.at(fruit, lists, hull, [0, 1, 2].map((k) => (p[k] - origin[k]) / spacing));
const middle = look([0.014, 0.002, 0.025]);
assert.equal(fruit.header.parts[middle.part], 'flesh');
near(middle.color, [0.5, 0.4, 0.3], 0.03, 'flesh');
assert.equal(look([0.026, 0.002, 0.025]), null, 'air');
near(look([0.02399, 0.002, 0.025]).color, [0.5, 0.4, 0.3], 0.05, 'the inner side of the skin');

// Curves: every command of a path, relative as absolute; arcs of the right size on the right side; written and read.
const points = (d) => Bezier.read(d).parts.flatMap(
  (part) => Bezier.segments(part).flatMap((pair) => [0, 0.25, 0.5, 0.75, 1].map((t) => Bezier.at(pair, t))));
const same = (a, b) => points(a).forEach((p, i) => near(p, points(b)[i], 1e-9, `${a} and ${b}`));
same(
  'M 1 2 l 3 4 h 2 v -1 c 1 1 2 2 3 0 s 1 2 3 3 q 1 1 2 0 t 2 0 z',
  'M 1 2 L 4 6 H 6 V 5 C 7 6 8 7 9 5 S 10 7 12 8 Q 13 9 14 8 T 16 8 Z');
const circle = points('M 3 0 A 3 3 0 0 1 0 3');
circle.forEach((p) => assert.ok(Math.abs(Math.hypot(...p) - 3) < 2e-3, `${p} is on the circle`));
points('M 3 0 A 3 3 0 0 0 0 3').forEach((p) => assert.ok(Math.abs(Math.hypot(p[0] - 3, p[1] - 3) - 3) < 2e-3));
assert.equal(points('M 3 0 A 3 3 0 1 1 0 -3').length, 15, 'three quarters of a turn');
const drawn = 'M 1,2 C 3,4 5,6 7,8 L 9,1 Z';
assert.equal(Bezier.write(Bezier.read(drawn).parts), 'M 1,2 C 3,4 5,6 7,8 L 9,1 L 1,2 Z');
const part = Bezier.read('M 0 0 C 1 3 4 5 6 2').parts[0],
      was = [0.1, 0.4, 0.9].map((t) => Bezier.at(Bezier.segments(part)[0], t));
Bezier.split(part, 0, 0.4);
near(part.nodes[1].p, was[1], 1e-12, 'a node more');
near(Bezier.at(Bezier.segments(part)[0], 0.25), was[0], 1e-12, 'the same curve before it');
near(Bezier.at(Bezier.segments(part)[1], 5 / 6), was[2], 1e-12, 'and behind it');

// Transforms of SVG: the last is done first; an inverse undoes.
near(A.point(A.read('translate(10,20) rotate(90) scale(2,3)'), [1, 1]), [7, 22], 1e-9, 'transform');
near(A.point(A.read('rotate(90, 5, 5)'), [6, 5]), [5, 6], 1e-9, 'rotate about a place');
near(A.point(A.read('skewX(45)'), [1, 2]), [3, 2], 1e-9, 'skewX');
const turn = A.read('matrix(1 2 3 4 5 6)');
near(A.point(A.inverse(turn), A.point(turn, [7, 9])), [7, 9], 1e-9, 'inverse');

// An SVG's text: what is edited changes, all else stays; names are told and written as XML has them.
const svg =
  '<svg><!-- <path id="no"/> --><g id="a &amp; &#98;" d=\'1\'>\n  <path id="p" d="M 0 0"/></g><path id="q"/></svg>';
const found = elementsOf(svg);
assert.deepEqual(found.map(({tag}) => tag), ['svg', 'g', 'path', 'path']);
assert.equal(attributeOf(found[1], 'id'), 'a & b');
assert.deepEqual(found.map(({parent}) => parent && found.indexOf(parent)), [null, 0, 1, 0]);
assert.equal(svg.slice(found[1].from, found[1].to), svg.slice(svg.indexOf('<g'), svg.indexOf('</g') + 4));
const {d, id} = found[2].attributes;
assert.equal(
  edited(svg, [{...id, text: encoded('<"&>')}, {...d, text: 'M 1 1'}]),
  svg.replace('id="p" d="M 0 0"', 'd="M 1 1"').replace('<path d="M 1 1"', '<path id="&lt;&quot;&amp;&gt;" d="M 1 1"'));
assert.equal(svg.slice(offsetOf(svg, 2, 3)).startsWith('<path id="p"'), true);

// Undo gives back the step before, redo the one behind; a new step forgets what was undone.
const text = (n) => ({toml: String(n), svg: ''}), history = new History(text(0));
[1, 2, 3].forEach((n) => history.push(text(n)));
history.undo();
history.undo();
assert.equal(history.now.toml, '1');
history.redo();
assert.equal(history.now.toml, '2');
history.push(text(9));
assert.equal(history.redo(), false);
history.undo();
assert.equal(history.now.toml, '2');
console.log('the scripts mean what they say');
