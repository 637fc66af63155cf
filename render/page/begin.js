// How pages begin: a worker unpacks while the browser makes a place to draw.
import {Blade} from './blade.js';
import {Board, fitCanvas} from './board.js';
import {$, sorry} from './messages.js';
import {firstDivisor} from './pace.js';
import {Paper} from './paper.js';
import {Picture} from './picture.js';
import {Stroke} from './stroke.js';
import {Unpacking} from './unpacking.js';

/**
 * `unpack(unpacking)` asks for what is to be unpacked first; `what` is told where it cannot be drawn; `program`: the
 * one that is first drawn with. Null where WebGL 2 is missing. Making a place to draw may take as long as unpacking and
 * keeps the page busy, so the worker is up before.
 */
export async function beginPage(unpack, what, program) {
  const started = performance.now(), loads = {}, unpacking = new Unpacking(), first = unpack(unpacking);
  const canvas = $('view');
  await unpacking.isUp;
  // The tools have their room, and with them the canvas, before the browser makes a place to draw of that size; they
  // are seen when something is.
  $('tools').style.visibility = 'hidden';
  $('tools').hidden = false;
  fitCanvas(canvas, firstDivisor);
  const options = JSON.parse($('options').textContent);
  const picture = new Picture(canvas, options, {program, mayBeRough: true});
  loads.card = performance.now() - started;
  if (!picture.gl) {
    $('tools').hidden = true;
    unpacking.stop();
    sorry(`This page draws the ${what} with WebGL 2, which this browser does not have or has switched off.`);
    return null;
  }
  canvas.addEventListener('webglcontextlost', () => sorry('The graphics card has dropped this page. Load it again.'));
  const board = new Board(canvas, picture), blade = new Blade(board), stroke = new Stroke(board);
  const paper = new Paper(board, options.style);
  /** Draws; `name`: how long after the beginning that was there, as far as the card has told. */
  async function drawNow(name) {
    board.frame();
    await board.pace.drawn();
    loads[name] = performance.now() - started;
    $('tools').style.visibility = '';
  }
  return {started, loads, unpacking, first, options, picture, board, blade, stroke, paper, drawNow};
}
