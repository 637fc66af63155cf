// Details by example on pages, in a real browser: the card's look-up is held to the processor's, on the squares that
// write_sections has left.
//   node page_examples.mjs FOLDER NAME...
import assert from 'node:assert/strict';
import {resolve} from 'node:path';

import {launch} from './browser.mjs';
import {errorsOf, line, readSections, srgb} from './section_errors.mjs';

const [folder, ...names] = process.argv.slice(2);

// The page has guides at every eighth node, the processor at each point; bare colours differ by one.
const rms = 2, p95 = 5;
const browser = await launch();
try {
  for (const name of names) {
    const tab = await browser.newPage(), faults = [];
    tab.on('pageerror', (error) => faults.push(error.message));
    await tab.setViewport({width: 240, height: 200});
    await tab.emulateMediaFeatures([{name: 'prefers-reduced-motion', value: 'reduce'}]);
    await tab.goto(`file://${resolve(folder)}/${name}.html`);
    await tab.waitForFunction('window.pomona && pomona.loads.cut', {timeout: 120000});
    for (const square of readSections(folder, name, 'looks')) {
      const {size, origin, u, v, n, reach} = square;
      const pixels = Buffer.from(await tab.evaluate((frame, side) => {
        let text = '';
        for (const byte of pomona.picture.detailed(pomona.board.first.fruit, frame, side))
          text += String.fromCharCode(byte);
        return btoa(text);
      }, {origin, u, v, n, reach}, size), 'base64');
      const errors = errorsOf(square, (i) => (pixels[4 * i + 3] === 0 ? null : [...pixels.subarray(4 * i, 4 * i + 3)]));
      console.log(`${name} ${square.name}: ${line(errors)}`);
      assert.ok(errors.pixels > 100 && errors.wrong === 0 && errors.rms <= rms && errors.p95 <= p95, 'a bar is missed');
      const bare = readSections(folder, name).find((other) => other.name === square.name);
      const change = errorsOf(
        bare, (i) => (square.truth[4 * i + 3] > 0.5 ? [0, 1, 2].map((k) => srgb(square.truth[4 * i + k])) : null));
      console.log(`  what they change: ${line(change)}`);
      assert.ok(change.rms > 2 * errors.rms, 'the details are hardly seen');
    }
    assert.deepEqual(faults, []);
    await tab.close();
  }
} finally { await browser.close(); }
