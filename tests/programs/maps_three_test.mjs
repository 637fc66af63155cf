// scripts/maps_three.mjs draws a file by three.js, with all of it in sight; of what cannot be drawn it leaves no
// picture.
//   node maps_three_test.mjs SCENE.glb FOLDER
import assert from 'node:assert';
import {spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

import {readPng} from '../../scripts/png.mjs';

const [scene, folder] = process.argv.slice(2).map((path) => resolve(path));
const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
const draw = (file, picture) =>
  spawnSync('node', [join(root, 'scripts/maps_three.mjs'), file, picture, 'scene'], {cwd: root, encoding: 'utf8'});

const picture = join(folder, 'scene.png'), {status, stderr} = draw(scene, picture);
assert.equal(status, 0, stderr);
const {width, height, data} = readPng(readFileSync(picture));
/** Paper and shadows are grey. */
const isColored = (x, y) => {
  const at = 4 * (y * width + x), [r, g, b] = data.subarray(at, at + 3);
  return Math.max(r, g, b) - Math.min(r, g, b) > 40;
};
let drawn = 0, onBorder = 0;
for (let y = 0; y < height; ++y) {
  for (let x = 0; x < width; ++x) {
    if (!isColored(x, y)) continue;
    ++drawn;
    onBorder += x === 0 || y === 0 || x === width - 1 || y === height - 1;
  }
}
assert(drawn > 0.05 * width * height, `${drawn} pixels are drawn`);
assert.equal(onBorder, 0, 'nothing is cut off');

for (const [name, bytes] of [['missing.glb', null], ['broken.glb', 'no such file']]) {
  const file = join(folder, name), nothing = join(folder, `${name}.png`);
  if (bytes !== null) writeFileSync(file, bytes);
  const failed = draw(file, nothing);
  assert.equal(failed.status, 1, `${name}: ${failed.stderr}`);
  assert.match(failed.stderr, /was not drawn/);
  assert(!existsSync(nothing), `${name} leaves no picture`);
}
