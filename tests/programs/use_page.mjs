// Uses a page as hands do: from disk, by mouse, keys and touch, and looks at what lies there after each. The fruit has
// a part that knives go around: one piece has all of it, and it is the one that the program gives it to.
//   node use_page.mjs FRUIT.html WEDGES.html
import assert from 'node:assert/strict';
import {resolve} from 'node:path';

import {launch} from './browser.mjs';

const [page, wedges] = process.argv.slice(2);
const browser = await launch({flags: ['--touch-events=enabled']});
const faults = [], asked = [];

async function opened(file) {
  const tab = await browser.newPage();
  await tab.setViewport({width: 480, height: 400, hasTouch: true});
  await tab.emulateMediaFeatures([{name: 'prefers-reduced-motion', value: 'reduce'}]);
  tab.on('pageerror', (error) => faults.push(error.message));
  tab.on('console', (message) => {
    if (message.type() === 'error') faults.push(message.text());
  });
  tab.on('request', (request) => {
    if (!/^(file|blob|data):/.test(request.url())) asked.push(request.url());
  });
  await tab.goto(`file://${resolve(file)}`);
  await tab.waitForFunction(
    'window.pomona && pomona.loads.cut || document.querySelector(".sorry[role]")', {timeout: 120000});
  assert.equal(
    await tab.evaluate('[...document.querySelectorAll(".sorry[role]")].map((e) => e.textContent).join()'), '');
  return tab;
}

const tab = await opened(page);
await tab.evaluate('pomona.board.first.faces.withDetails = false');  // until the end: they take their time where
                                                                     // software stands for a card
const ask = (code) => tab.evaluate(code), press = (key) => tab.keyboard.press(key);
/** What the last knife and the camera are. */
const state = () => ask(`(() => {
  const {knives, camera, open, apart, dark, draws} = pomona.board, {shift, turn, tilt,
    drawn} = knives[knives.length - 1] || {};
  return {cuts: knives.length, shift, turn, tilt, drawn: Boolean(drawn), yaw: camera.yaw, pitch: camera.pitch,
    zoom: camera.zoom, open, apart, dark, draws};
})()`);
/** A word for the picture as it is now: equal pictures, equal words. */
const picture = () => ask(`(() => {
  const {board, picture} = pomona, {gl, canvas} = picture;
  board.moveOn();  // the frame that does so may still wait for the one before it
  for (const body of board.bodies) body.faces.update(192, false);
  const scene = board.sceneNow(), pixels = new Uint8Array(4 * canvas.width * canvas.height);
  picture.draw(scene);
  gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  let sum = 0, drawn = 0;
  for (let i = 0; i < pixels.length; i += 4) { if (pixels[i + 3]) ++drawn;
    sum = Math.imul(sum, 31) + (pixels[i] | pixels[i + 1] << 8 | pixels[i + 2] << 16) | 0; }
  return drawn + ':' + sum;
})()`);
let last = '';
/** Does it, and says what it was before and is after; the picture must not stay as it was when last looked at. */
async function changed(act) {
  const before = await state();
  await act();
  const after = await state(), now = await picture();
  assert.notEqual(now, last, `the picture stays as it was after ${act}`);
  last = now;
  return {before, after};
}
const near = (a, b, what, by = 1e-6) => assert.ok(Math.abs(a - b) < by, `${what}: ${a} instead of ${b}`);
const stepOf = () => ask('0.01 * pomona.board.first.frame.size');
const {x, y, width, height} = await (await tab.$('#view')).boundingBox();
async function drag(from, to, steps = 4) {
  await tab.mouse.move(...from);
  await tab.mouse.down();
  for (let i = 1; i <= steps; ++i)
    await tab.mouse.move(from[0] + (to[0] - from[0]) * i / steps, from[1] + (to[1] - from[1]) * i / steps);
  await tab.mouse.up();
}
const begin = performance.now();
const told = (what) => console.log(`${((performance.now() - begin) / 1000).toFixed(1)} s: ${what}`);

try {
  // One half has all of the stone, the one that the program gives it to: behind the plane.
  const owners = () => ask(`(() => {
    const {first} = pomona.board;
    return first.arranged.map((piece) => ({keep: piece.keep, walls: first.wallsOf(piece).map(({whole}) => whole)}));
  })()`);
  assert.deepEqual(
    (await owners()).sort((a, b) => a.keep[0] - b.keep[0]), [{keep: [-1], walls: [true]}, {keep: [1], walls: [false]}]);
  const hole = () => ask(`(() => {
    const {gl} = pomona.picture, {now: {bare, size, frame}} = pomona.board.first.faces.all[0],
      pixels = new Uint8Array(4 * size * size);
    const {points} = pomona.board.first.spared.shells[0], middle = [0, 1, 2].map((k) => { let sum = 0; for (let i = k;
      i < points.length; i += 3) sum += points[i]; return 3 * sum / points.length; });
    gl.bindFramebuffer(gl.FRAMEBUFFER, bare.buffer);
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    const at = (v) => Math.floor(size * (0.5 + 0.5 * v.reduce((sum, x, k) => sum + x * (middle[k] - frame.origin[k]),
      0) / frame.reach));
    return pixels[4 * (at(frame.v) * size + at(frame.u)) + 3];
  })()`);
  assert.equal(await hole(), 0, 'the face goes through the stone');
  told('the stone is whole in one half');

  // Mouse: over the fruit it turns, with Shift it moves the knife, the wheel zooms.
  await tab.focus('#view');
  last = await picture();
  let step =
    await changed(() => drag([x + 0.5 * width, y + 0.4 * height], [x + 0.5 * width + 40, y + 0.4 * height + 16]));
  near(step.after.yaw - step.before.yaw, -40 / 160, 'a drag turns');
  near(step.after.pitch - step.before.pitch, 16 / 160, 'a drag tips');
  step = await changed(async () => {
    await tab.mouse.move(x + 0.5 * width, y + 0.5 * height);
    await tab.mouse.wheel({deltaY: -180});
    await tab.waitForFunction(`pomona.board.camera.zoom > ${step.after.zoom}`);
  });
  near(step.after.zoom / step.before.zoom, Math.exp(0.2), 'the wheel zooms', 1e-3);
  step = await changed(async () => {
    await tab.keyboard.down('Shift');
    await drag([x + 0.5 * width, y + 0.3 * height], [x + 0.5 * width, y + 0.3 * height - 14]);
    await tab.keyboard.up('Shift');
  });
  assert.ok(Math.abs(step.after.shift - step.before.shift) > 0.1, 'Shift and a drag move the knife');
  assert.equal(step.after.yaw, step.before.yaw);

  // The three dots. They move with the picture, which waits while the card works on the one before.
  const drawnAnew = () => ask(`(async () => {
    const {board} = pomona;
    board.changed();
    while (board.stale) await new Promise((done) => requestAnimationFrame(done));
  })()`);
  const dots = async () => {
    await drawnAnew();
    return ask(`['move', 'turn', 'tilt'].map((what) => { const {x, y,
        width} = document.querySelector('circle.' + what).getBoundingClientRect();
          return [x + width / 2, y + width / 2]; })`);
  };
  await ask('pomona.board.zoom(0.7)');
  for (const [i, key] of ['shift', 'turn', 'tilt'].entries()) {
    const from = (await dots())[i];
    step = await changed(() => drag(from, [from[0] + 12, from[1] + 12]));
    assert.notEqual(step.after[key], step.before[key], `the dot does not ${key}`);
    assert.equal(step.after.yaw, step.before.yaw, 'a dot turns the fruit');
    if (key !== 'shift') near(step.after[key] - step.before[key], 0.008 * 12, key);
  }
  told('mouse');

  // Where software stands for a card, what moves has fewer pixels; at rest it has all of them.
  const pixels = () => ask('pomona.picture.canvas.width');
  await tab.waitForFunction('pomona.board.settled', {timeout: 60000});
  assert.deepEqual([await ask('pomona.board.rough'), await pixels()], [false, width]);
  await ask('pomona.board.pace.drawn()');  // a card that is busy would draw only when all has come to rest
  // The first frame with fewer pixels, looked at before it can come to rest.
  const moved = await ask(`(async () => {
    const {board, picture: {canvas}} = pomona;
    board.orbit(0.3, 0);
    for (let frames = 0; frames < 60 && canvas.width === ${
    width}; ++frames) await new Promise((done) => requestAnimationFrame(done));
    return {rough: board.rough, pixels: canvas.width, divisor: board.pace.given};
  })()`);
  assert.ok(moved.divisor >= 2);
  assert.deepEqual([moved.rough, moved.pixels], [true, Math.ceil(width / moved.divisor)]);
  await tab.waitForFunction('!pomona.board.rough', {timeout: 20000});
  assert.equal(await pixels(), width);
  // While the card works on a frame it is given no other.
  const given = await ask(`(async () => {
    const {board, picture} = pomona, own = picture.draw;
    let drawn = 0, busy = 0;
    picture.draw = function (scene) { ++drawn; if (board.pace.fence) ++busy; own.call(this, scene); };
    for (let i = 0; i < 12; ++i) { board.orbit(0.02, 0); await new Promise((done) => requestAnimationFrame(done)); }
    picture.draw = own;
    return {drawn, busy};
  })()`);
  assert.ok(
    given.drawn > 0 && given.busy === 0, `${given.busy} of ${given.drawn} frames were given to a card that was busy`);
  // Frames that are longer apart than a rest is long are no rest, as long as the hand goes on.
  const fineOnes = await ask(`(async () => {
    const {board, picture} = pomona, own = picture.draw;
    let fine = 0;
    picture.draw = function (scene) { if (!scene.rough) ++fine; own.call(this, scene); };
    for (let i = 0; i < 6; ++i) {
      board.orbit(0.02, 0);
      for (const begin = performance.now(); performance.now() - begin < 150;);
      await new Promise((done) => requestAnimationFrame(done));
    }
    picture.draw = own;
    return fine;
  })()`);
  assert.equal(fineOnes, 0, 'a turning fruit is drawn finely');
  told('rough while it moves');

  // Each piece is drawn with the triangles that it may have: of each triangle the piece on whose side its middle lies
  // has it, and no piece has all.
  const missing = await ask(`(() => {
    const {first} = pomona.board, {skin, index, knives, pieces} = first, all = index ? index.length : skin.length / 10;
    const {sidesOf, trianglesOf} = pomona.modules, own = pieces.map((piece) => new Set(trianglesOf(piece,
      sidesOf(skin, knives), index).filter((_, i) => i % 3 === 0)));
    let missing = 0;
    for (let i = 0; i < all; i += 3) {
      const corners = [0, 1, 2].map((k) => index ? index[i + k] : i + k), middle = [0, 1,
        2].map((axis) => corners.reduce((sum, c) => sum + skin[10 * c + axis] / 3, 0));
      const at = pieces.findIndex(({keep}) => knives.every((knife, k) => knife.sideOf(middle) === keep[k]));
      if (at >= 0 && !own[at].has(corners[0])) ++missing;
    }
    return {missing, largest: Math.max(...own.map((one) => one.size)) / (all / 3)};
  })()`);
  assert.ok(missing.missing === 0 && missing.largest < 0.9, JSON.stringify(missing));

  // Keys, as the API says.
  const size = await stepOf();
  for (const [key, what, by] of [
         ['w', 'shift', size], ['s', 'shift', -size], ['a', 'turn', -0.06], ['d', 'turn', 0.06], ['q', 'tilt', -0.06],
         ['e', 'tilt', 0.06]]) {
    step = await changed(() => press(key));
    near(step.after[what] - step.before[what], by, `key ${key}`);
  }
  step = await changed(() => press('h'));
  assert.deepEqual([step.after.cuts, step.after.turn, step.after.tilt, step.after.shift], [1, 0, 0, 0]);
  step = await changed(() => press('x'));
  near(step.after.tilt, Math.PI / 2, 'across');
  const sideways = await picture();
  await ask('pomona.board.cutOnce(0, Math.PI / 2)');
  assert.equal(await picture(), sideways, 'the key and the API cut unlike');
  step = await changed(() => press(' '));
  assert.deepEqual(
    [step.before.open, await ask('pomona.board.wantedOpen')], [await ask('1 - pomona.board.wantedOpen'), 0]);
  await changed(() => press('c'));
  assert.equal((await state()).cuts, 2);
  assert.equal((await owners()).filter(({walls}) => walls.includes(true)).length, 1, 'several pieces have the stone');
  await changed(() => press('Backspace'));
  assert.equal((await state()).cuts, 1);
  step = await changed(() => press('+'));
  near(step.after.zoom / step.before.zoom, 1.12, '+');
  await changed(() => press('-'));
  near((await state()).zoom, step.before.zoom, '-');
  step = await changed(() => press('ArrowLeft'));
  near(step.after.yaw - step.before.yaw, 0.12, 'an arrow');
  await press('l');
  assert.equal((await state()).dark, !step.after.dark);
  await press('l');
  told('keys');

  // A stroke right over the fruit, whose piece keeps a whole stone.
  await press('Backspace');
  await press('b');
  assert.ok((await state()).draws);
  step = await changed(() => drag([x + 8, y + 0.45 * height], [x + width - 8, y + 0.58 * height], 8));
  assert.deepEqual([step.after.cuts, step.after.drawn, step.after.draws], [1, true, false]);
  assert.equal(await ask('pomona.pieces().length'), 2);
  assert.ok((await owners()).every(({walls}) => walls.length <= 1));

  // What lies under a pointer at rest has a name; the stone is found on its own half, and is no cut face.
  await press('h');
  await ask('pomona.board.frame()');
  const found = await ask(`(() => {
    for (let v = 0.25; v < 0.85; v += 0.03) for (let u = 0.15; u < 0.9; u += 0.03) {
      const hit = pomona.nameAt(u * ${width}, v * ${height});
      const isSpared = (part) => pomona.board.first.spared.parts.includes(part);
      if (hit && !hit.cut && isSpared(hit.body.fruit.header.parts.indexOf(hit.part))) return {x: u * ${width}, y: v * ${
    height}, part: hit.part};
    }
    return null;
  })()`);
  assert.ok(found, 'no stone stands out of any half');
  await tab.mouse.move(x + found.x, y + found.y);
  await tab.waitForFunction('!document.getElementById("name").hidden', {timeout: 5000});
  assert.equal(await ask('document.getElementById("name").textContent'), found.part.replaceAll('_', ' '));
  told(`a stroke; the pointer finds the ${found.part}`);

  // Every control that can be used is reached by Tab, in the order of the page.
  const controls = await ask(`[...document.querySelectorAll('canvas, button, input')].filter((e) => !e.disabled &&
      e.offsetParent !== null).map((e) => e.id)`);
  await tab.focus('#view');
  const reached = ['view'];
  while (reached.length < controls.length) {
    await press('Tab');
    reached.push(await ask('document.activeElement.id'));
  }
  assert.deepEqual(reached, controls);

  // Two fingers zoom, one turns.
  const client = await tab.createCDPSession();
  const touch = (type, ...points) =>
    client.send('Input.dispatchTouchEvent', {type, touchPoints: points.map(([px, py], id) => ({x: px, y: py, id}))});
  const [cx, cy] = [x + 0.5 * width, y + 0.9 * height];  // beside the knife's dots
  step = await changed(async () => {
    await touch('touchStart', [cx, cy]);
    await touch('touchMove', [cx + 20, cy]);
    await touch('touchMove', [cx + 32, cy]);
    await touch('touchEnd');
  });
  near(step.after.yaw - step.before.yaw, -32 / 160, 'a finger turns', 0.09);
  step = await changed(async () => {
    await touch('touchStart', [cx - 30, cy], [cx + 30, cy]);
    for (const r of [36, 44, 54, 60]) await touch('touchMove', [cx - r, cy], [cx + r, cy]);
    await tab.waitForFunction(`pomona.board.camera.zoom > ${1.2 * step.after.zoom}`, {timeout: 20000});
    await touch('touchEnd');
  });
  assert.ok(step.after.zoom / step.before.zoom > 1.2, 'two fingers do not zoom');
  told('Tab and touch');

  // At rest details come, and change the picture.
  await press('h');
  const without = await ask('pomona.finish(), pomona.board.first.faces.all[0].now.isDetailed');
  await ask('pomona.board.first.faces.withDetails = true; pomona.finish()');
  assert.deepEqual(
    [without, await ask('pomona.board.first.faces.all[0].now.isDetailed || pomona.picture.speed.skipsDetails')],
    [false, true]);
  told('details');

  // Six wedges hold the stone alike: the first of them, as the program counts, has it.
  await tab.close();
  const six = await opened(wedges);
  const first = await six.evaluate(`(() => {
    const {first} = pomona.board, {middle: m} = first.frame;
    const {middle} = first.arranged.find((one) => first.wallsOf(one).some(({whole}) => whole));
    return {pieces: first.arranged.length, turn: Math.atan2(-(middle[2] - m[2]), middle[0] - m[0]) * 180 / Math.PI};
  })()`);
  assert.equal(first.pieces, 6);
  assert.ok(first.turn > 0 && first.turn < 60, `the stone is in the wedge at ${first.turn} degrees`);
  told('six wedges');
  assert.deepEqual(asked, []);
  assert.deepEqual(faults, []);
} finally { await browser.close(); }
