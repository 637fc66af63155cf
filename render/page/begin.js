// The start of pages: a worker unpacks while the browser prepares WebGL.
import {Blade} from './blade.js';
import {firstDivisor} from './frame_budget.js';
import {$, sorry} from './messages.js';
import {fitCanvas, PageView} from './page_view.js';
import {Paper} from './paper.js';
import {Picture} from './picture.js';
import {Stroke} from './stroke.js';
import {Unpacking} from './unpacking.js';

/**
 * `unpack(unpacking)` requests what is unpacked first; `what` names the page's contents in the message without WebGL 2;
 * `program` is the first program to draw with. Returns null without WebGL 2. Making a WebGL context may take as long as
 * unpacking and blocks the page, so the worker starts first.
 */
export async function beginPage(unpack, what, program) {
  const started = performance.now(), loads = {}, unpacking = new Unpacking(), first = unpack(unpacking);
  const canvas = $('view');
  await unpacking.isUp;
  // Lay out the tools, and so the canvas, before the browser makes a context of that size; show the tools when there is
  // something to draw.
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
  const board = new PageView(canvas, picture), blade = new Blade(board), stroke = new Stroke(board);
  const paper = new Paper(board, options.style);
  /** Draws; stores as `name` the time since the start when the card had drawn it. */
  async function drawNow(name) {
    board.frame();
    await board.pace.drawn();
    loads[name] = performance.now() - started;
    $('tools').style.visibility = '';
  }
  return {started, loads, unpacking, first, options, picture, board, blade, stroke, paper, drawNow};
}
