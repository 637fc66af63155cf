// The blade that is drawn over the fruit, and its handles.
import {M, V} from './linear.js';
import {$} from './messages.js';

export class Blade {
  constructor(board) {
    this.board = board;
    this.handles = ['move', 'turn', 'tilt'].map((what) => this.handle(what));
  }
  handle(what) {
    const circle = document.createElementNS('http://www.w3.org/2000/svg', 'circle');
    circle.setAttribute('class', what);
    circle.setAttribute('r', what === 'move' ? '7' : '6');
    circle.style.display = 'none';
    $('overlay').append(circle);
    let last = null;
    circle.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      circle.setPointerCapture(event.pointerId);
      last = [event.clientX, event.clientY];
    });
    circle.addEventListener('pointermove', (event) => {
      if (!last) return;
      const [dx, dy] = [event.clientX - last[0], event.clientY - last[1]];
      last = [event.clientX, event.clientY];
      this.drag(what, dx, dy);
    });
    for (const end of ['pointerup', 'pointercancel'])
      circle.addEventListener(end, () => {
        last = null;
      });
    return circle;
  }

  /** The piece behind the last knife. */
  get piece() {
    const {board} = this, {arranged} = board.first, last = board.knives.length - 1;
    return arranged.find(({keep}) => keep[last] < 0) || arranged[0];
  }
  onScreen(p) {
    const {board} = this, {canvas} = board, view = board.view();
    const w = view[3] * p[0] + view[7] * p[1] + view[11] * p[2] + view[15];
    const [x, y] = M.point(view, p);
    return [(x / w * 0.5 + 0.5) * canvas.clientWidth, (0.5 - 0.5 * y / w) * canvas.clientHeight];
  }
  drag(what, dx, dy) {
    const {board} = this, {knife} = board;
    if (!knife || knife.drawn) return;
    if (what === 'turn')
      return board.changeKnife((k) => {
        k.turn += 0.008 * dx;
      });
    if (what === 'tilt')
      return board.changeKnife((k) => {
        k.tilt += 0.008 * dy;
      });
    const {origin, n} = knife.frame, {motion} = this.piece, step = 0.05 * board.first.frame.size;
    const a = this.onScreen(M.point(motion, origin));
    const b = this.onScreen(M.point(motion, V.add(origin, V.mul(n, step))));
    const way = [b[0] - a[0], b[1] - a[1]], length = Math.hypot(...way);
    // A plane seen at right angles moves when the pointer goes up or down.
    const amount = length < 4 ? -0.4 * dy * step / 6 : (dx * way[0] + dy * way[1]) / length ** 2 * step;
    board.changeKnife((k) => {
      k.shift += amount;
    });
  }
  draw() {
    const {board, handles} = this, {knife} = board;
    const shown = knife && !knife.drawn && !board.draws && board.setting.takesKnives;
    handles.forEach((h) => {
      h.style.display = shown ? '' : 'none';
    });
    $('blade').setAttribute('d', '');
    if (!shown) return;
    const {origin, u, v} = knife.frame, {motion, points} = this.piece;
    // A frame slightly larger than the face.
    const along = (way) => 1.1 * Math.max(...points.map((p) => Math.abs(V.dot(V.sub(p, origin), way))));
    const [a, b] = [along(u), along(v)];
    const at = (s, t) => this.onScreen(M.point(motion, V.add(origin, V.add(V.mul(u, s * a), V.mul(v, t * b)))));
    const corners = [at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)];
    $('blade').setAttribute('d', `M${corners.map((c) => c.map((x) => x.toFixed(1)).join(' ')).join('L')}Z`);
    [at(-1, -1), at(-1, 0), at(0, 1)].forEach(([x, y], i) => {
      handles[i].setAttribute('cx', x.toFixed(1));
      handles[i].setAttribute('cy', y.toFixed(1));
    });
  }
}
