// A cut drawn over the fruit.
import {Knife} from './knives.js';
import {M, V} from './linear.js';
import {$, say} from './messages.js';
import {mostKnives} from './page_view.js';

export class Stroke {
  constructor(board) {
    this.board = board;
    this.points = null;
  }
  /** True while drawing, when it has points. */
  get isDrawn() { return this.points !== null; }

  stop() {
    this.board.draws = false;
    this.points = null;
    $('draw').setAttribute('aria-pressed', 'false');
    this.board.canvas.classList.remove('draws');
    $('stroke').setAttribute('d', '');
  }
  toggle() {
    const {board} = this;
    if (board.draws) {
      this.stop();
      board.sayPieces();
      return board.ask();
    }
    board.draws = true;
    board.wantedApart = board.wantedOpen = 0;
    $('draw').setAttribute('aria-pressed', 'true');
    board.canvas.classList.add('draws');
    say('Draw a line over the fruit, right across it.');
    board.moved();
  }
  begin(x, y) { this.points = [[x, y]]; }
  add(x, y) {
    this.points.push([x, y]);
    $('stroke').setAttribute('d', `M${this.points.map((p) => p.join(' ')).join('L')}`);
  }
  /** Cuts along the stroke, straight away from the viewer. */
  cut() {
    const {board} = this, {canvas, camera} = board, {frame, place} = board.first, {aspect} = board;
    const {back} = camera.directions, {eye} = camera;
    const middle = M.point(place, frame.middle);
    const points = this.points.map(([x, y]) => {
      const ray = camera.ray(2 * x / canvas.clientWidth - 1, 1 - 2 * y / canvas.clientHeight, aspect);
      return V.add(eye, V.mul(ray, V.dot(V.sub(middle, eye), back) / V.dot(ray, back)));
    });
    const knife = points.length > 2 ? Knife.drawnAlong(frame, points, back) : null;
    this.stop();
    if (!knife) {
      say('That stroke was too short to cut.');
      return board.ask();
    }
    board.setKnives([...board.knives.slice(0, mostKnives - 1), knife], {open: 0});
  }
}
