// The brush of the studio in a real browser: strokes become ramps and coats of the template, seen in the section,
// undone and done again; what is saved is what `check` accepts, and `grow` makes of it what the studio made, to the
// byte.
//   node studio_paint.mjs PROGRAM FOLDER [PICTURE.png]
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, rmSync} from 'node:fs';

import {launch} from './browser.mjs';
import {Session, startStudio} from './studio_session.mjs';

const [program, folder, picture] = process.argv.slice(2);
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
// Without the fruit in space, which has nothing to do with it and takes a processor most of the time.
const browser = await launch({flags: ['--disable-3d-apis']});
const studio = await startStudio(program, ['plum.toml', '--folds', '5'], folder);
try {
  const session = await Session.open(browser, studio.address);
  await session.settled();

  // The brush paints the side on which it runs, where it runs: the ground of the flesh's inside, seen in the section at
  // once.
  await session.select('side', 'flesh');
  await session.tab.keyboard.press('b');
  const brush = (values) => session.evaluate((v) => {
    Object.assign(studio.brush, v);
    studio.modules.showBrush(studio);
  }, values);
  await brush({color: '#208040', size: 24, soft: 0.4});
  const old = await session.paintOn('flesh', 'back'), other = await session.paintOn('flesh', 'front');
  const inside = await session.evaluate(([x, y]) => {
    const pane = studio.panes.side, box = pane.root.getBoundingClientRect();
    return pane.onPage([x - box.left, y - box.top]);
  }, (await session.along('side', 'flesh', 0.5, 0.5, -6, 1))[0]);
  const was = await session.sectionAt('side', inside);
  await session.stroke(await session.along('side', 'flesh', 0.4, 0.6, -5));
  await session.settled({fruit: false});
  const ground = (await session.paintOn('flesh', 'back')).ground;
  assert.deepEqual(await session.paintOn('flesh', 'front'), other, 'the other side is painted, too');
  const greens = ground.filter(([, color]) => color === '#208040').map(([at]) => at);
  assert.ok(
    greens.length >= 2 && greens[0] <= 0.42 && greens.at(-1) >= 0.58 && greens[0] > 0.3 && greens.at(-1) < 0.7,
    JSON.stringify(ground));
  assert.ok(ground.length <= (old.ground?.length || 1) + 6, JSON.stringify(ground));
  const greener = await session.sectionAt('side', inside);
  assert.ok(greener[0] - greener[1] < was[0] - was[1] - 25, `the section was ${was} and is ${greener}`);

  // A coat over the skin: from the side where along the curve it lies, from above where around the axis. Each is a step
  // of undo.
  await session.tab.keyboard.press('n');
  await brush({color: '#b01830', size: 60});
  await session.stroke(await session.along('side', 'skin', 0.5, 0.7, 6));
  await session.settled({fruit: false});
  let [coat] = (await session.paintOn('skin', 'front')).coats;
  assert.deepEqual(coat.color, [[0, '#b01830']]);
  assert.ok(
    coat.along.some(([at, share]) => share === 1 && at > 0.4 && at < 0.8) && coat.along[0][1] === 0 &&
      coat.along.at(-1)[1] === 0,
    JSON.stringify(coat));
  await session.stroke(await session.along('top', 'skin', 0.2, 0.35, 6));
  await session.settled({fruit: false});
  [coat] = (await session.paintOn('skin', 'front')).coats;
  const thick = coat.turn.filter(([, share]) => share === 1).map(([at]) => at);
  assert.ok(thick.length >= 1 && thick[0] > 0.1 && thick.at(-1) < 0.45, JSON.stringify(coat));
  await session.tab.click('#undo');
  assert.equal((await session.paintOn('skin', 'front')).coats[0].turn, null);
  await session.tab.click('#redo');
  // Wiped with Shift, it is gone there; taken away on the right, all of it; and undone.
  await session.tab.keyboard.down('Shift');
  await session.stroke(await session.along('side', 'skin', 0.66, 0.72, 6));
  await session.tab.keyboard.up('Shift');
  const wiped = (await session.paintOn('skin', 'front')).coats[0].along;
  assert.ok(
    Math.max(...wiped.filter(([at]) => at > 0.66 && at < 0.72).map(([, share]) => share), 0) < 0.05 &&
      wiped.some(([, share]) => share === 1),
    JSON.stringify(wiped));
  const painted = await session.evaluate('studio.texts.toml');
  await session.tab.click('[aria-label="skin outside, coat 1: take it away"]');
  assert.equal((await session.paintOn('skin', 'front')).coats.length, 0);
  await session.tab.click('#undo');
  assert.equal(await session.evaluate('studio.texts.toml'), painted);
  await session.settled();
  assert.equal(await session.evaluate('document.getElementById("errors").textContent'), '');
  if (picture) await session.tab.screenshot({path: picture});

  // Saved, the reader accepts it, and it is what was seen.
  const asset = await session.asset();
  await session.save();
  assert.equal(readFileSync(`${folder}/plum.toml`, 'utf8'), painted);
  execFileSync(program, ['check', 'plum.toml'], {cwd: folder});
  execFileSync(program, ['grow', 'plum.toml', '-o', 'plum.pomona', '--quiet'], {cwd: folder});
  assert.ok(readFileSync(`${folder}/plum.pomona`).equals(asset), 'what is saved is not what was seen');
  execFileSync(
    program, ['cut', 'plum.toml', '--knife', 'half', '--section', '-o', 'plum.ply', '--quiet'], {cwd: folder});
  assert.deepEqual(session.faults.filter((fault) => !/WebGL/.test(fault)), []);
} finally {
  await browser.close();
  studio.process.kill('SIGKILL');
}
