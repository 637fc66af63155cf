// How long the studio takes from an edited curve to its section, in the browser, template by template: the median of
// several drags.
//   node studio_times.mjs PROGRAM FOLDER NAME...       ends with 1 if a bar is missed: 150 ms for the lemon, 400 for
//   all others
import {mkdirSync, rmSync} from 'node:fs';
import {resolve} from 'node:path';

import {launch} from './browser.mjs';
import {Session, startStudio} from './studio_session.mjs';

const [given, folder, ...names] = process.argv.slice(2), program = resolve(given), browser = await launch();
let missed = false;
try {
  for (const name of names) {
    rmSync(folder, {recursive: true, force: true});
    mkdirSync(folder, {recursive: true});
    const studio = await startStudio(program, [name], folder);
    try {
      const session = await Session.open(browser, studio.address);
      // At rest: the strip of variants is there, and the fruit is drawn, not only asked of the card.
      await session.settled();
      await session.tab.waitForFunction('studio.loads.variants', {timeout: 180000, polling: 100});
      await session.evaluate(() => {
        const {gl} = studio.view.picture.card;
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      });
      const times = [];
      for (let i = 0; i < 7; ++i) {
        times.push(await session.evaluate(async (step) => {
          const curve =
            studio.drawing.curves.find((c) => c.view === 'side' && c.kind === 'curve' && c.parts[0].nodes.length > 2);
          studio.select(curve);
          const parts = studio.nodes.copy(curve.parts), node = parts[0].nodes[1];
          const size =
            Math.max(...curve.parts[0].nodes.map(({p}) => p[0])) - Math.min(...curve.parts[0].nodes.map(({p}) => p[0]));
          for (const key of ['p', 'before', 'after']) node[key][0] += 0.002 * step * size;
          studio.loads.section = 0;
          studio.drag(parts);
          while (!studio.loads.section) await new Promise((done) => setTimeout(done, 2));
          return studio.loads.section;
        }, i + 1));
      }
      const sorted = times.slice(1).sort((a, b) => a - b), median = sorted[sorted.length >> 1];
      const bar = name === 'lemon' ? 150 : 400;
      missed ||= median > bar;
      console.log(`${name.padEnd(14)} ${median.toFixed(0).padStart(5)} ms${median > bar ? `, more than ${bar}` : ''}`);
      await session.tab.close();
    } finally { await studio.end(); }
  }
} finally { await browser.close(); }
process.exit(missed ? 1 : 0);
