// Opens a scene's page from disk in a real browser, without a network: a piece is picked, told of, taken out, cut by
// keys, and put back; the cut face ends where the piece does.
//   node open_scene.mjs FILE.html FILE.json [PICTURE.png]      FILE.json: the scene's layout
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {resolve} from 'node:path';

import {launch} from './browser.mjs';

const [page, layout, picture] = process.argv.slice(2);
const {instances} = JSON.parse(readFileSync(layout));
const browser = await launch();
try {
  const tab = await browser.newPage(), faults = [], asked = [];
  await tab.setViewport({width: 480, height: 400});
  await tab.emulateMediaFeatures([{name: 'prefers-reduced-motion', value: 'reduce'}]);
  tab.on('pageerror', (error) => faults.push(error.message));
  tab.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) asked.push(request.url());
  });
  await tab.goto(`file://${resolve(page)}`);
  await tab.waitForFunction(
    'window.pomona && pomona.loads.cut || document.querySelector(".sorry[role]")', {timeout: 120000});
  assert.equal(
    await tab.evaluate('[...document.querySelectorAll(".sorry[role]")].map((e) => e.textContent).join()'), '');
  const text = (id) => tab.evaluate(`document.getElementById('${id}').textContent`);

  // Everything lies where the layout says: its middle of all, turned as it says.
  const places = await tab.evaluate(
    `pomona.pile().bodies.map(({instance}) => ({name: instance.name, translation: instance.translation}))`);
  assert.deepEqual(places, instances.map(({name, translation}) => ({name, translation})));
  const far = await tab.evaluate('pomona.board.span');
  await tab.evaluate(
    'document.getElementById("apart").value = 1; ' +
    'document.getElementById("apart").dispatchEvent(new Event("input")); pomona.finish()');
  if (places.length > 2) assert.ok(await tab.evaluate('pomona.board.span') > 1.2 * far, 'the pile is not pulled apart');
  await tab.evaluate('pomona.board.pullApart(0); pomona.finish()');

  // A press picks what lies there, and tells what it is.
  const hit = await tab.evaluate(`(() => {
    const {clientWidth: w, clientHeight: h} = document.getElementById('view');
    for (let y = 0.3; y < 0.8; y += 0.05) for (let x = 0.2; x < 0.8; x += 0.04) {
      const found = pomona.nameAt(x * w, y * h);
      if (found && found.body.fruit.header.asset >= 0) return {x: x * w, y: y * h, name: found.body.instance.name,
        of: found.body.solid.facts.template};
    }
    return null;
  })()`);
  assert.ok(hit, 'nothing lies under the pointer');
  const {x, y} = await (await tab.$('#view')).boundingBox();
  await tab.mouse.click(x + hit.x, y + hit.y);
  assert.equal(await text('picked'), hit.name);
  assert.match(await text('told'), new RegExp(`template${hit.of}seed\\d+`));
  assert.match(await text('told'), /mass[\d.]+ k?g, [\d.e+]+ cm³/);
  console.log(`picked ${hit.name}: ${await text('told')}`);

  // Taken out and cut: two pieces, and a face that ends within the piece.
  await tab.click('#take');
  await tab.waitForFunction('pomona.board.setting !== pomona.pile()', {timeout: 120000});
  await tab.focus('#view');
  await tab.keyboard.press('h');
  await tab.evaluate('pomona.finish()');
  const face = await tab.evaluate(`(() => {
    const {gl, card} = pomona.picture, body = pomona.picked(), face = body.faces.all[0].now, {size, frame} = face,
      pixels = new Uint8Array(4 * size * size);
    gl.bindFramebuffer(gl.FRAMEBUFFER, face.bare.buffer);
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const {low, high} = body.frame;
    let inside = 0, beyond = 0;
    for (let i = 0; i < size * size; ++i) {
      if (pixels[4 * i + 3] === 0) continue;
      const s = 2 * (i % size + 0.5) / size - 1, t = 2 * (Math.floor(i / size) + 0.5) / size - 1;
      const p = frame.origin.map((o, k) => o + frame.reach * (s * frame.u[k] + t * frame.v[k]));
      if (p.some((c, k) => c < low[k] - 0.5 || c > high[k] + 0.5)) ++beyond; else ++inside;
    }
    return {inside, beyond, size};
  })()`);
  console.log(`of ${face.size ** 2} texels ${face.inside} are fruit`);
  assert.ok(face.inside > 0.005 * face.size ** 2 && face.beyond === 0, 'the face does not end where the piece does');
  assert.equal(await tab.evaluate('pomona.pieces().length'), 2);
  if (picture) await tab.screenshot({path: picture});

  // Back in the pile it is still cut.
  await tab.keyboard.press('Escape');
  assert.ok(await tab.evaluate('pomona.board.setting === pomona.pile() && pomona.picked().arranged.length === 2'));
  await tab.evaluate('pomona.finish()');
  assert.deepEqual(asked, []);
  assert.deepEqual(faults, []);
} finally { await browser.close(); }
