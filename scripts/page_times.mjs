// Measures how long a page takes to open and to draw, in Chromium without a graphics card, and how much its look-up
// reads.
//   node scripts/page_times.mjs FILE.html FILE.pomona [RUNS [WAIT]]      medians; wants an idle machine; needs `npm ci`
//   and chromium
// WAIT: milliseconds for which the browser has been open before. One that has just been started is still busy with
// itself.
import {readdirSync, readFileSync} from 'node:fs';
import {loadavg} from 'node:os';
import {resolve} from 'node:path';
import {inflateSync} from 'node:zlib';

import * as LookUp from '../render/page/look_up.js';
import * as Asset from '../render/page/read_asset.js';
import {launch} from '../tests/programs/browser.mjs';

const [page, asset, runs = '5', wait = '0'] = process.argv.slice(2), side = 256;
const median = (numbers) => [...numbers].sort((a, b) => a - b)[numbers.length >> 1];
console.log(`load average before: ${loadavg()[0].toFixed(1)}`);

// Texture reads of a section across the middle: one for the cell and the eight corners' colours, or, beside surfaces,
// an entry of the list and two texels for each triangle, and up to nine sides or nodes.
const fruit = Asset.decoded(new Uint8Array(inflateSync(readFileSync(asset).subarray(8))));
const lists = LookUp.cells(fruit), hull = LookUp.range(fruit), reads = [];
for (let j = 0; j < side; ++j)
  for (let i = 0; i < side; ++i) {
    const [x, y, z] = fruit.count;
    const found =
      LookUp.at(fruit, lists, hull, [(i + 0.5) / side * (x - 1), 0.5 * (y - 1) + 0.01, (j + 0.5) / side * (z - 1)]);
    if (found) reads.push(found.triangles === 0 ? 3 : 1 + 3 * found.triangles + 9);
  }
reads.sort((a, b) => a - b);
console.log(`reads for a pixel of a section: mean ${
  (reads.reduce((a, b) => a + b, 0) / reads.length).toFixed(1)}, 95th percentile ${
  reads[Math.floor(0.95 * reads.length)]}, most ${reads[reads.length - 1]}`);

/** Seconds of processor time of a process and its children, independent of other processes. */
function processorTime(root) {
  const found = new Map();
  for (const pid of readdirSync('/proc').filter((name) => /^\d+$/.test(name))) {
    try {
      const stat = readFileSync(`/proc/${pid}/stat`, 'utf8').replace(/^.*\) /, '').split(' ');
      found.set(Number(pid), {parent: Number(stat[1]), ticks: Number(stat[11]) + Number(stat[12])});
    } catch { /* It has ended. */
    }
  }
  const isOurs = (pid) => pid === root || (found.has(pid) && isOurs(found.get(pid).parent));
  return [...found].reduce((sum, [pid, {ticks}]) => sum + (isOurs(pid) ? ticks / 100 : 0), 0);
}

const loads = {
  card: [],
  skin: [],
  cut: [],
  fine: [],
  face: [],
  frame: [],
  turning: [],
  rest: [],
  processor: []
};
for (let run = 0; run < Number(runs); ++run) {
  const browser = await launch({timeout: 600000});
  try {
    const tab = await browser.newPage();
    await tab.setViewport({width: 640, height: 480});
    await tab.emulateMediaFeatures([{name: 'prefers-reduced-motion', value: 'reduce'}]);
    await new Promise((done) => setTimeout(done, Number(wait)));
    const before = processorTime(browser.process().pid);
    await tab.goto(`file://${resolve(page)}`);
    await tab.waitForFunction('window.pomona && pomona.loads.cut', {polling: 5, timeout: 300000});
    const processor = 1000 * (processorTime(browser.process().pid) - before);
    await tab.waitForFunction('pomona.loads.fine', {timeout: 300000});
    // Simulate a drag: the pointer moves at every frame. Then it rests, and the picture becomes fine.
    await tab.waitForFunction('pomona.board.settled', {timeout: 300000});
    const turned = await tab.evaluate(`(async () => {
      const {board, picture} = pomona, own = picture.draw,
        nextFrame = () => new Promise((done) => requestAnimationFrame(done)), begin = performance.now();
      let frames = 0;
      picture.draw = function (scene) { ++frames; own.call(this, scene); };
      while (performance.now() - begin < 4000) { board.orbit(0.01, 0); await nextFrame(); }
      await board.pace.drawn();
      const end = performance.now(), turning = (end - begin) / frames;
      while (board.rough) await nextFrame();
      await board.pace.drawn();
      picture.draw = own;
      return {turning, rest: performance.now() - end};
    })()`);
    const times = await tab.evaluate(`(() => {
      const {board, picture, loads} = pomona, {gl} = picture, {fruit, frame: {middle, reach}} = board.first,
        timed = (act) => {
        const all = [];
        for (let i = 0; i < 5; ++i) {
          const begin = performance.now();
          act();
          gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
          all.push(performance.now() - begin);
        }
        return all.sort((a, b) => a - b)[2];
      };
      pomona.finish();
      const face = timed(() => picture.bare(fruit, {origin: middle, u: [1, 0, 0], v: [0, 0, -1], n: [0, 1, 0], reach},
        512));
      const frame = timed(() => picture.draw(board.sceneNow()));
      return {...loads, face, frame};
    })()`);
    for (const key of Object.keys(loads)) loads[key].push(key === 'processor' ? processor : {...times, ...turned}[key]);
  } finally { await browser.close(); }
}
const said = {
  card: 'a place to draw after',
  skin: 'skin drawn after',
  cut: 'cut drawn after',
  fine: 'cut drawn finely after',
  turning: 'a frame while the fruit is turned',
  rest: 'fine again after its rest',
  face: 'bare section of 512 x 512',
  frame: 'a frame of 640 x 480, less the tools, faces known',
  processor: 'processor time of all of Chromium until the cut is drawn'
};
for (const [key, all] of Object.entries(loads))
  console.log(`${said[key]}: ${Math.round(median(all))} ms (${all.map(Math.round).join(', ')})`);
console.log(`load average after: ${loadavg()[0].toFixed(1)}`);
