// Opens a page from disk in a real browser, without a network: what it shows of a section is held to the C++ field,
// cuts are made by its own keys and buttons, and the part under the pointer is named.
//   node open_page.mjs FOLDER NAME [PICTURE.png]
import assert from 'node:assert/strict';
import {resolve} from 'node:path';

import {launch} from './browser.mjs';
import {errorsOf, holds, line, readSections} from './section_errors.mjs';

const [folder, name, picture] = process.argv.slice(2);
const browser = await launch();
try {
  const tab = await browser.newPage(), faults = [], asked = [];
  await tab.setViewport({width: 480, height: 400});
  await tab.emulateMediaFeatures([{name: 'prefers-reduced-motion', value: 'reduce'}]);
  tab.on('pageerror', (error) => faults.push(error.message));
  tab.on('console', (message) => {
    if (message.type() === 'error') faults.push(message.text());
  });
  tab.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) asked.push(request.url());
  });
  await tab.goto(`file://${resolve(folder)}/${name}.html`);
  await tab.waitForFunction(
    'window.pomona && pomona.loads.cut || document.querySelector(".sorry[role]")', {timeout: 120000});
  assert.equal(
    await tab.evaluate('[...document.querySelectorAll(".sorry[role]")].map((e) => e.textContent).join()'), '');
  const loads = await tab.evaluate('pomona.loads');
  console.log(`skin after ${Math.round(loads.skin)} ms, cut after ${Math.round(loads.cut)} ms`);

  // The bare section, as the card works it out.
  const square = readSections(folder, name)[0], {size, origin, u, v, n, reach} = square;
  const pixels = Buffer.from(await tab.evaluate((frame, side) => {
    let text = '';
    for (const byte of pomona.picture.bare(pomona.board.first.fruit, frame, side)) text += String.fromCharCode(byte);
    return btoa(text);
  }, {origin, u, v, n, reach}, size), 'base64');
  const errors = errorsOf(square, (i) => (pixels[4 * i + 3] === 0 ? null : [...pixels.subarray(4 * i, 4 * i + 3)]));
  console.log(`${name} ${square.name}: ${line(errors)}`);
  assert.ok(errors.pixels > 100 && holds(errors), 'a bar is missed');

  // It opened with one cut; keys make others, and take them back.
  const pieces = () => tab.evaluate('pomona.pieces().length');
  assert.equal(await pieces(), 2);
  await tab.focus('#view');
  await tab.keyboard.press('x');
  assert.equal(await pieces(), 2);
  await tab.keyboard.press('c');
  assert.equal(await pieces(), 4);
  await tab.keyboard.press('Backspace');
  await tab.keyboard.press('Backspace');
  assert.equal(await pieces(), 1);
  await tab.click('#half');
  assert.equal(await tab.evaluate('document.getElementById("state").textContent'), 'one cut, 2 pieces');

  // Half the fruit lies on either side, up to what samples tell; a shifted plane leaves less on one.
  const shares = () => tab.evaluate('pomona.pieces().map(({points}) => points.length)');
  const [a, b] = await shares();
  assert.ok(Math.abs(a - b) < 0.15 * (a + b), `halves are unlike: ${a}, ${b}`);
  await tab.evaluate(
    'document.getElementById("shift").value = 0.5; document.getElementById("shift").dispatchEvent(new Event("input"))');
  const [c, d] = (await shares()).sort((x, y) => x - y);
  assert.ok(c < 0.45 * d, `a shifted knife leaves ${c}, ${d}`);

  // A stroke that is drawn over the whole fruit parts it.
  await tab.keyboard.press('Backspace');
  await tab.click('#draw');
  const {x, y, width, height} = await (await tab.$('#view')).boundingBox();
  await tab.mouse.move(x + 20, y + 0.4 * height);
  await tab.mouse.down();
  for (let i = 1; i <= 12; ++i)
    await tab.mouse.move(x + 20 + (width - 40) * i / 12, y + height * (0.5 + 0.08 * Math.sin(i)));
  await tab.mouse.up();
  assert.equal(await pieces(), 2);

  // What lies under the pointer has a name.
  await tab.click('#half');
  const named = await tab.evaluate(`pomona.finish(), [0.2, 0.3, 0.4, 0.6,
      0.7].map((s) => pomona.nameAt(s * document.getElementById('view').clientWidth,
    0.5 * document.getElementById('view').clientHeight)).filter((found) => found &&
      found.cut).map((found) => found.part)`);
  console.log(`named: ${named.join(', ')}`);
  assert.ok(named.length > 0);
  if (picture) await tab.screenshot({path: picture});
  assert.deepEqual(asked, []);
  assert.deepEqual(faults, []);
} finally { await browser.close(); }
