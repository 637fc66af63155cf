// Makes the pictures of docs/guides/studio.md: draws an orange over two pictures of one, by mouse and keys, and saves
// each step.
//   node scripts/studio_pictures.mjs build/pomona docs/pictures/studio [FOLDER]      needs `npm ci` and chromium
// The pictures that are drawn over are Pomona's own, of a template that this script writes: CC0, as everything in
// templates is.
import {execFileSync} from 'node:child_process';
import {mkdirSync, mkdtempSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join, resolve} from 'node:path';

import {launch} from '../tests/programs/browser.mjs';
import {Session, startStudio} from '../tests/programs/studio_session.mjs';

const program = resolve(process.argv[2]), pictures = resolve(process.argv[3]);
const folder = process.argv[4] ? resolve(process.argv[4]) : mkdtempSync(join(tmpdir(), 'orange-'));
const folds = 10;
mkdirSync(folder, {recursive: true});
mkdirSync(pictures, {recursive: true});

/** A segment between two membranes, as a loop with rounded corners. */
function segment(k) {
  const middle = 2 * Math.PI * (k + 1) / folds, half = Math.PI / folds - 0.06, long = 1 - 0.03 * Math.cos(2.3 * k);
  const at = (r, a) => `${(r * Math.cos(middle + a)).toFixed(2)} ${(-r * Math.sin(middle + a)).toFixed(2)}`;
  const outer = 32.6 * long;
  return `M ${at(5, 0)} C ${at(8, -half * 0.5)} ${at(16, -half)} ${at(outer * 0.92, -half)} C ${at(outer, -half)} ${
           at(outer, -half * 0.9)} ${at(outer, -half * 0.5)} ` +
    `C ${at(outer, -half * 0.2)} ${at(outer, half * 0.2)} ${at(outer, half * 0.5)} C ${at(outer, half * 0.9)} ${
           at(outer, half)} ${at(outer * 0.92, half)} C ${at(16, half)} ${at(8, half * 0.5)} ${at(5, 0)} Z`;
}
const round = (r, low, high) => `M 0 ${- low} C ${0.58 * r} ${- low} ${r} ${- (low + 0.2 * (high - low))} ${r} ${
  - (low + high) / 2} C ${r} ${- (high - 0.2 * (high - low))} ${0.58 * r} ${- high} 0 ${- high}`;
writeFileSync(join(folder, 'picture.toml'), `format = 1
name = "picture"
unit = "1mm"
parts = ["skin", "pith", "pulp", "core"]
[symmetry]
kind = "folds"
folds = ${folds}
fold_angles = [${Array.from({length: folds}, (_, k) => (360 * (k + 0.5) / folds).toFixed(0)).join(', ')}]
[[surface]]
name = "skin"
type = "around-axis"
vertical = "${round(38, 0, 73)}"
front = { part = "skin", hidden = true, color = "#e8811a" }
back = { part = "skin", color = "#ee8d1e" }
[[surface]]
name = "zest"
type = "around-axis"
vertical = "${round(36.2, 1.8, 71.2)}"
blur = "0.3mm"
front = { part = "skin", color = "#f09a2c" }
back = { part = "pith", color = "#fbeccb" }
[[surface]]
name = "segment"
type = "in-fold"
vertical = "M 5 -36 C 5 -52 12 -66 17 -66 C 26 -65 33 -50 33 -36.5 C 33 -23 26 -8 17 -7 C 12 -7 5 -20 5 -36 Z"
horizontal = [${Array.from({length: folds}, (_, k) => `"${segment(k)}"`).join(', ')}]
blur = "0.1mm"
front = { part = "pith", color = "#fbe9c4" }
back = { part = "pulp", color = "#f5a12b" }
[[surface]]
name = "core"
type = "around-axis"
vertical = "M 0 -7 C 3 -10 3.6 -20 3.6 -36 C 3.6 -52 3 -62 0 -66"
blur = "0.3mm"
front = { part = "pith", color = "#fdf0d4" }
back = { part = "core", color = "#f6e2b4" }
`);
for (const knife of ['half', 'across']) {
  execFileSync(
    program,
    [
      'cut', 'picture.toml', '--knife', knife, '--section', '--style', 'plain', '--size', '640x640', '-o',
      `${knife}.png`, '--quiet'
    ],
    {cwd: folder});
}

const browser = await launch();
const studio = await startStudio(
  program, ['orange.toml', '--picture', 'half.png', '--picture', 'across.png', '--folds', String(folds)], folder);
try {
  const session = await Session.open(browser, studio.address, {width: 1440, height: 860}), {tab} = session;
  const keep = async (name) => {
    await session.settled();
    await tab.waitForFunction('studio.loads.variants > 0', {timeout: 120000, polling: 200});
    await tab.screenshot({path: join(pictures, `${name}.png`)});
    console.log(name);
  };
  const key = (name) => tab.keyboard.press(name);
  await keep('start');

  // The place of the orange in the pictures: the box of all pixels that are not paper.
  const boxes = await session.evaluate(() => Object.fromEntries(studio.drawing.images.map((picture) => {
    const loaded = studio.pictures.get(picture.href), {width, height} = loaded.image;
    const {data} = loaded.pixels.getImageData(0, 0, width, height);
    const low = [width, height], high = [0, 0];
    for (let i = 0; i < width * height; ++i)
      if (data[4 * i + 3] > 128 && data[4 * i + 2] < 150) {
        const p = [i % width, Math.floor(i / width)];
        for (const k of [0, 1]) {
          low[k] = Math.min(low[k], p[k]);
          high[k] = Math.max(high[k], p[k]);
        }
      }
    const m = studio.pictures.placement(picture, loaded);
    const {A} = studio.modules;
    return [picture.view, [A.point(m, low), A.point(m, high)]];
  })));
  console.log(JSON.stringify(boxes));

  // Put the axis on the middle of the fruit, the scale along its width, and set its length.
  for (const view of ['side', 'top']) {
    const [low, high] = boxes[view], middle = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
    await session.evaluate((v, l, h, m) => {
      const put = (name, places) => {
        const curve = studio.drawing.curves.find((c) => c.view === v && c.kind === name);
        studio.select(curve);
        if (curve.dot) studio.commit(studio.drawing.withDot(curve, m));
        else
          studio.commit(studio.drawing.withParts(curve, [{closed: false, nodes: places.map(studio.modules.nodeAt)}]));
      };
      put('axis', [[m[0], h[1]], [m[0], l[1]]]);
      put('scale', [[l[0], h[1] + 6], [h[0], h[1] + 6]]);
      studio.rename('scale 76mm');
    }, view, low, high, middle);
  }
  await session.evaluate((boxes) => {
    // Put fold lines on the membranes.
    const [low, high] = boxes.top, middle = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
    const reach = 0.55 * (high[0] - low[0]);
    for (let k = 0; k < 10; ++k) {
      const fold = studio.drawing.curves.filter((c) => c.kind === 'fold')[k], a = 2 * Math.PI * (k + 0.5) / 10;
      studio.commit(studio.drawing.withParts(
        fold, [{
          closed: false,
          nodes: [middle, [middle[0] + reach * Math.cos(a), middle[1] - reach * Math.sin(a)]].map(studio.modules.nodeAt)
        }]));
    }
    studio.select(null);
  }, boxes);
  await key('f');
  await keep('measure');

  // Trace the outlines by the colours inside them.
  const [low, high] = boxes.side, size = high[0] - low[0], middle = [(low[0] + high[0]) / 2, (low[1] + high[1]) / 2];
  const [tlow, thigh] = boxes.top, tsize = thigh[0] - tlow[0];
  const tmiddle = [(tlow[0] + thigh[0]) / 2, (tlow[1] + thigh[1]) / 2];
  const trace = async (view, name, place, index = 0) => {
    await session.evaluate(
      (v, n, i) => studio.select(studio.drawing.curves.filter((c) => c.view === v && c.name === n)[i]), view, name,
      index);
    await key('t');
    await tab.mouse.click(...await session.where(view, place));
  };
  await trace('side', 'skin', [high[0] - 0.01 * size, middle[1]]);
  await trace('top', 'skin', [tmiddle[0] + 0.49 * tsize, tmiddle[1]]);
  await session.settled();
  await trace('side', 'flesh', [middle[0] + 0.465 * size, middle[1]]);
  await trace('top', 'flesh', [tmiddle[0] + 0.465 * tsize, tmiddle[1]]);
  await trace('side', 'chamber', [middle[0] + 0.25 * size, middle[1]]);
  for (let k = 0; k < folds; ++k) {
    const a = 2 * Math.PI * (k + 1) / folds;
    await trace(
      'top', 'chambers', [tmiddle[0] + 0.28 * tsize * Math.cos(a), tmiddle[1] - 0.28 * tsize * Math.sin(a)], k);
  }
  await key('v');
  // Draw the core by hand: move its curve, node by node, into the white around the axis.
  await session.evaluate((m, s) => {
    const core = studio.drawing.curves.find((c) => c.view === 'side' && c.name === 'core'), x = m[0];
    const part = {
      closed: false,
      nodes: [
        [x, m[1] + 0.38 * s], [x + 0.047 * s, m[1] + 0.2 * s], [x + 0.047 * s, m[1] - 0.2 * s], [x, m[1] - 0.38 * s]
      ].map(studio.modules.nodeAt)
    };
    studio.modules.Bezier.smooth(part);
    studio.commit(studio.drawing.withParts(core, [part]), 'core');
    studio.select(studio.drawing.curves.find((c) => c.view === 'side' && c.name === 'chamber'));
  }, middle, size);
  await keep('outlines');

  // Colours: select each on the right, then take it from the picture.
  const pick = async (surface, side, view, place) => {
    await session.evaluate((name, of) => {
      // One colour for the whole side.
      const {putRamp, sideNamed} = studio.modules, ramp = sideNamed(studio.drawing, name, of).ground.along;
      if (!ramp.constant) putRamp(studio, {ramp}, [ramp.stops[0]], 'one colour');
      studio.chosenStop = {surface: name, side: of, path: ['ground', 'along'], stop: 0};
    }, surface, side);
    await key('i');
    await tab.mouse.click(...await session.where(view, place));
  };
  await pick('skin', 'front', 'side', [high[0] - 0.008 * size, middle[1]]);
  await pick('skin', 'back', 'side', [high[0] - 0.012 * size, middle[1]]);
  await pick('flesh', 'front', 'top', [tmiddle[0] + 0.487 * tsize, tmiddle[1]]);
  await pick('flesh', 'back', 'top', [tmiddle[0] + 0.455 * tsize, tmiddle[1]]);
  await pick('chamber', 'front', 'top', [tmiddle[0] + 0.455 * tsize, tmiddle[1]]);
  await pick('chamber', 'back', 'top', [tmiddle[0] + 0.28 * tsize, tmiddle[1]]);
  await pick('core', 'front', 'top', [tmiddle[0] + 0.05 * tsize, tmiddle[1]]);
  await pick('core', 'back', 'top', tmiddle);
  await key('v');
  await session.evaluate('studio.select(null)');
  await keep('colours');

  // A blush: a coat over the skin, painted in the side view along its curve and in the top view around the axis.
  await tab.click('[data-cut="whole"]');
  await key('n');
  await session.evaluate(() => {
    Object.assign(studio.brush, {color: '#c23a12', size: 110, soft: 1, strength: 0.8});
    studio.modules.showBrush(studio);
  });
  await session.stroke(await session.along('side', 'skin', 0.5, 0.75, 8));
  await session.stroke(await session.along('top', 'skin', 0.9, 0.98, 8));
  await tab.mouse.move(...(await session.along('side', 'skin', 0.7, 0.7, 10, 1))[0]);
  await session.evaluate('document.querySelector(".ramp [aria-pressed=true]")?.scrollIntoView({ block: "center" })');
  await keep('painted');
  await key('v');

  await tab.click('[data-cut="across"]');
  await session.evaluate(
    'document.getElementById("seed").value = 3, document.getElementById("seed").dispatchEvent(new Event("input"))');
  await session.evaluate(
    'document.getElementById("over").click(), document.getElementById("photo").value = 0.35, ' +
    'document.getElementById("photo").dispatchEvent(new Event("input"))');
  await session.save();
  await keep('variant');
  console.log(await session.evaluate('document.getElementById("errors").textContent') || 'no mistakes', session.faults);
} finally {
  await browser.close();
  studio.process.kill('SIGKILL');
}
