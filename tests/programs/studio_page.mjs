// The studio in a real browser: a fruit is begun, drawn, cut, undone and done again, kept through a kill of the
// program, saved; and what is saved is what `pomona` makes of it, to the byte. Two windows meet; a mistake stands at
// its curve; the section comes in time.
//   node studio_page.mjs PROGRAM FOLDER [PICTURE.png]
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {existsSync, mkdirSync, readFileSync, rmSync} from 'node:fs';

import {launch} from './browser.mjs';
import {Session, startStudio} from './studio_session.mjs';

const [program, folder, picture] = process.argv.slice(2);
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
const browser = await launch();
let studio = null;
try {
  // A fruit from nothing.
  studio = await startStudio(program, ['plum.toml', '--folds', '5'], folder);
  let session = await Session.open(browser, studio.address);
  await session.settled();
  assert.equal(await session.evaluate('document.getElementById("errors").children.length'), 0);

  // A node of the skin is dragged outwards: the section follows, before and after it is let go.
  const before = await session.nodes('side', 'skin'), middle = 1, beyond = [before[middle][0] + 4, before[middle][1]];
  assert.equal((await session.sectionAt('side', beyond))[3], 0);
  await session.dragNode('side', 'skin', middle, [14, 0]);
  await session.settled({fruit: false});
  assert.equal((await session.sectionAt('side', beyond))[3], 255, 'the section does not follow the curve');
  const after = await session.nodes('side', 'skin');
  assert.ok(Math.abs(after[middle][0] - before[middle][0] - 14) < 0.6, 'the node is not where it was put');

  await session.tab.keyboard.press('f');

  // An end that is let go beside the axis lies on it.
  const axis = (await session.evaluate('studio.drawing.axis("side")'))[0];
  await session.dragNode('side', 'skin', 0, [0.9, 1.5]);
  await session.settled({fruit: false});
  assert.ok(
    Math.abs((await session.nodes('side', 'skin'))[0][0] - axis[0]) < 1e-6, 'the end does not snap to the axis');

  // Undone twice, done again: the texts are letter for letter as they were.
  const now = await session.evaluate('studio.texts.svg');
  await session.tab.keyboard.down('Control');
  await session.tab.keyboard.press('z');
  await session.tab.keyboard.press('z');
  assert.deepEqual(await session.nodes('side', 'skin'), before);
  await session.tab.keyboard.press('y');
  await session.tab.keyboard.press('y');
  await session.tab.keyboard.up('Control');
  assert.equal(await session.evaluate('studio.texts.svg'), now);

  // Two clicks on a line: a node more, and no other curve is touched.
  await session.select('side', 'flesh');
  const flesh = await session.nodes('side', 'flesh');
  const between = await session.evaluate(
    '(() => { const c = studio.drawing.curves.find((k) => k.view === "side" && k.name === "flesh"); ' +
    'const {Bezier} = studio.modules; return Bezier.at(Bezier.segments(c.parts[0])[1], 0.5); })()');
  await session.tab.mouse.click(...await session.where('side', between), {count: 2});
  assert.equal((await session.nodes('side', 'flesh')).length, flesh.length + 1);
  await session.tab.keyboard.press('Delete');
  assert.equal((await session.nodes('side', 'flesh')).length, flesh.length);

  // A curve is drawn with the pen; it becomes a surface.
  await session.tab.keyboard.press('p');
  const [bottom, top] = await session.evaluate('studio.drawing.axis("side")'), height = bottom[1] - top[1];
  for (const [x, share] of [[0.4, 0.3], [9, 0.42], [9, 0.55], [0.4, 0.68]])
    await session.tab.mouse.click(...await session.where('side', [bottom[0] + x, bottom[1] - share * height]));
  await session.tab.keyboard.press('Enter');
  await session.tab.waitForSelector('dialog[open] #curve-name');
  await session.tab.type('#curve-name', 'stone');
  await session.tab.click('#curve-add');
  await session.settled();
  assert.ok(await session.evaluate('studio.drawing.surfaces.some((s) => s.name === "stone")'));
  assert.equal(await session.evaluate('document.getElementById("errors").textContent'), '');

  // A mistake stands at its curve, in the reader's words.
  await session.dragNode('side', 'skin', middle, [-70, 0]);
  await session.tab.waitForFunction('document.querySelector("#errors button")', {timeout: 30000});
  await session.settled({fruit: false});
  const told = await session.evaluate('document.querySelector("#errors button").textContent');
  assert.match(told, /skin/);
  assert.ok(await session.evaluate('document.querySelector("#pane-side .curve.wrong") !== null'), told);
  await session.tab.click('#undo');
  await session.settled();
  assert.equal(await session.evaluate('document.getElementById("errors").textContent'), '');

  // All ways to show it.
  for (const mode of ['whole', 'glass', 'across', 'half']) {
    await session.tab.click(`[data-cut="${mode}"]`);
    await session.settled();
    const colors = await session.evaluate(`(() => { studio.view.stale = true; studio.view.frame();
        const gl = studio.view.picture.gl, {width, height} = studio.view.canvas, p = new Uint8Array(4 * width * height);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, p);
        return new Set(Array.from({length: 4000}, (_, i) => { const k = 4 * Math.floor(i * width * height / 4000);
          return p.slice(k, k + 4).join(); })).size; })()`);
    assert.ok(colors > 30, `${mode}: ${colors} colours`);
  }

  // The program is killed; another finds everything again.
  const texts = await session.evaluate('studio.texts');
  assert.ok(!existsSync(`${folder}/plum.toml`));
  await studio.end();
  await session.tab.waitForFunction('!document.getElementById("bar").hidden', {timeout: 20000});
  assert.match(await session.evaluate('document.getElementById("bar").textContent'), /does not answer/);
  await session.tab.close();
  studio = await startStudio(program, ['plum.toml'], folder);
  session = await Session.open(browser, studio.address);
  assert.deepEqual(await session.evaluate('studio.texts'), texts);
  await session.settled();
  if (picture) await session.tab.screenshot({path: picture});

  // A reload, and a second window: what one draws the other takes in.
  await session.tab.reload();
  await session.tab.waitForFunction('window.studio && studio.loads.section', {timeout: 60000});
  assert.deepEqual(await session.evaluate('studio.texts'), texts);
  const second = await Session.open(browser, studio.address);
  await second.settled();
  await second.dragNode('side', 'core', 1, [1.5, 0]);
  await second.settled({fruit: false});
  await session.tab.bringToFront();
  await session.tab.waitForFunction(
    `studio.texts.svg === ${JSON.stringify(await second.evaluate('studio.texts.svg'))}`, {timeout: 20000});
  await second.tab.close();
  await session.settled();

  // Saved, it is what `check` accepts and what `grow` makes, to the byte.
  const asset = await session.asset();
  await session.save();
  execFileSync(program, ['check', 'plum.toml'], {cwd: folder});
  execFileSync(program, ['grow', 'plum.toml', '-o', 'plum.pomona', '--quiet'], {cwd: folder});
  assert.ok(readFileSync(`${folder}/plum.pomona`).equals(asset), 'what is saved is not what was seen');
  assert.equal(readFileSync(`${folder}/plum.svg`, 'utf8'), await session.evaluate('studio.texts.svg'));
  assert.ok(!existsSync(`${folder}/plum.toml.unsaved`));
  assert.deepEqual(session.strangers, []);
  assert.deepEqual(session.faults.filter((fault) => !/ERR_CONNECTION/.test(fault)), []);
} finally {
  await browser.close();
  if (studio) studio.process.kill('SIGKILL');
}
