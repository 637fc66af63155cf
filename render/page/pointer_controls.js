// Pointer controls: they turn, zoom, draw, move the knife, and show the name under the pointer.
import {$} from './messages.js';

export class PointerControls {
  /** `nameOf(found)`: the name of a result of board.at(); `onTap(found)`: for a press without motion. */
  constructor(board, blade, stroke, {nameOf, onTap = (_found) => {}}) {
    this.board = board;
    this.blade = blade;
    this.stroke = stroke;
    this.nameOf = nameOf;
    this.onTap = onTap;
    this.held = new Map();
    this.pinch = 0;
    this.naming = 0;
    this.way = 0;
    const {canvas} = board;
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    for (const end of ['pointerup', 'pointercancel'])
      canvas.addEventListener(end, (event) => this.up(event, end === 'pointerup'));
    canvas.addEventListener('pointerleave', () => {
      $('name').hidden = true;
    });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      board.zoom(Math.exp(-event.deltaY / 900));
    }, {passive: false});
  }
  down(event) {
    const {board, stroke} = this;
    board.canvas.setPointerCapture(event.pointerId);
    this.held.set(event.pointerId, [event.clientX, event.clientY]);
    this.pinch = 0;
    this.way = this.held.size > 1 ? Infinity : 0;
    if (board.draws) stroke.begin(event.offsetX, event.offsetY);
    board.canvas.classList.add('held');
    $('name').hidden = true;
  }
  move(event) {
    const {board, stroke, held} = this, before = held.get(event.pointerId);
    if (!before) return this.nameLater(event);
    const dx = event.clientX - before[0], dy = event.clientY - before[1];
    held.set(event.pointerId, [event.clientX, event.clientY]);
    this.way += Math.abs(dx) + Math.abs(dy);
    if (board.draws && stroke.isDrawn) {
      stroke.add(event.offsetX, event.offsetY);
    } else if (held.size === 2) {
      const [a, b] = [...held.values()], apart = Math.hypot(a[0] - b[0], a[1] - b[1]);
      if (this.pinch > 0) board.zoom(apart / this.pinch);
      this.pinch = apart;
    } else if (event.shiftKey || event.buttons === 2) {
      this.blade.drag('move', dx, dy);
    } else {
      board.orbit(-dx / 160, dy / 160);
    }
  }
  up(event, isDone) {
    const {board, stroke, held} = this, wasHeld = held.delete(event.pointerId);
    this.pinch = 0;
    board.canvas.classList.remove('held');
    if (board.draws && stroke.isDrawn) return isDone ? stroke.cut() : stroke.stop();
    if (isDone && wasHeld && this.way < 5) this.onTap(board.at(event.offsetX, event.offsetY));
  }
  /** Shows the name under the pointer once it rests. */
  nameLater(event) {
    const {board, held} = this, [x, y] = [event.offsetX, event.offsetY];
    clearTimeout(this.naming);
    this.naming = setTimeout(() => {
      if (!board.setting || held.size > 0) return;
      const found = board.at(x, y), label = $('name');
      label.hidden = !found;
      if (!found) return;
      label.textContent = this.nameOf(found);
      label.style.left = `${x}px`;
      label.style.top = `${y}px`;
    }, 60);
  }
}
