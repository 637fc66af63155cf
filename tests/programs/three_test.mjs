// three.js in a headless Chromium draws a .glb as we do: the same silhouettes, much the same colours; and further files
// of the same scene, whose colours stand in atlases, palettes and KTX2, as the first.
//   node three_test.mjs FILE.glb OUR_PICTURE.png FOLDER [ATLAS.glb...]
// Run where node_modules lies. The picture of three.js is left in FOLDER/three.png.
import {mkdirSync, readFileSync} from 'node:fs';
import {basename, dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

import {launch} from './browser.mjs';
import {served} from './served.mjs';

const [glb, picture, folder, ...others] = process.argv.slice(2).map((path) => resolve(path));
const here = dirname(fileURLToPath(import.meta.url));
const named = {
  '/': join(here, 'three_page.html'),
  '/scene.glb': glb,
  '/picture.png': picture,
  ...Object.fromEntries(others.map((file) => [`/${basename(file)}`, file]))
};
const files = await served((path) => named[path] ? readFileSync(named[path]) : null);

mkdirSync(folder, {recursive: true});
const browser = await launch();
let found;
try {
  const tab = await browser.newPage();
  await tab.setViewport({width: 480, height: 360});
  await tab.goto(`${files.url}/?${others.map((file) => basename(file)).join('&')}`);
  await tab.waitForFunction('document.title', {timeout: 200000});
  found = JSON.parse(await tab.title());
  await tab.screenshot({path: join(folder, 'three.png')});
} finally {
  await browser.close();
  files.close();
}
console.log(JSON.stringify(found, null, 1));

// Our shading and theirs differ: silhouettes must not, hues hardly.
const wrong = [];
if (found.error) wrong.push(found.error);
else {
  if (!(found.share > 0.03)) wrong.push('three.js shows next to nothing');
  if (!(found.overlap > 0.9)) wrong.push('silhouettes differ');
  found.ours.forEach((ours, k) => {
    if (!(Math.abs(ours - found.theirs[k]) < 45)) wrong.push(`mean colours differ: ${found.ours} and ${found.theirs}`);
  });
  // Palettes have the vertices' colours, and KTX2 nearly those of its PNG; texels blur, and normal maps bend the light.
  const most = (file) => file.includes('looks') ? 0.5 : file.includes('ktx2') ? 2 : 6;
  for (const {file, overlap, difference} of found.others) {
    if (!(overlap > 0.99)) wrong.push(`${file}: silhouettes differ from those of ${basename(glb)}`);
    if (!(difference < most(file)))
      wrong.push(`${file}: colours differ by ${difference} of 255 from those of ${basename(glb)}`);
  }
  if (!(found.theirs[0] > found.theirs[2] + 15)) wrong.push('red fruit is not red');
}
wrong.forEach((line) => console.error(`three: error: ${line}`));
process.exit(wrong.length > 0 ? 1 : 0);
