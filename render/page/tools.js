// Sliders, buttons and keys for the knife.
import {$} from './messages.js';
import {mostKnives} from './page_view.js';

export class Tools {
  /** `further`: more keys and their actions. */
  constructor(board, blade, stroke, paper, further = {}) {
    this.board = board;
    this.stroke = stroke;
    board.onKnives = () => this.show();
    board.onFrame = () => blade.draw();
    const slide = (id, change) => $(id).addEventListener('input', () => change(Number($(id).value)));
    slide('shift', (value) => board.changeKnife((k) => {
      k.shift = value * 0.5 * board.first.frame.size;
    }));
    slide('turn', (value) => board.changeKnife((k) => {
      k.turn = value * Math.PI / 180;
    }));
    slide('tilt', (value) => board.changeKnife((k) => {
      k.tilt = value * Math.PI / 180;
    }));
    slide('waves', (value) => board.changeKnife((k) => {
      k.waves = value;
    }));
    slide('apart', (value) => board.pullApart(value));
    const acts = this.acts(paper);
    for (const id of ['half', 'across', 'draw', 'more', 'fewer', 'lay', 'dark'])
      $(id).addEventListener('click', acts[id]);
    this.keys = {...this.keysOf(acts), ...further};
    window.addEventListener('keydown', (event) => this.press(event));
    window.addEventListener('resize', () => {
      if (board.setting) {
        board.arrange();
        board.moved();
      }
    });
  }
  acts(paper) {
    const {board, stroke} = this;
    const ifKnives = (act) => () => {
      if (board.setting && board.setting.takesKnives) act();
    };
    return {
      half: ifKnives(() => {
        stroke.stop();
        board.cutOnce(0, 0);
      }),
      across: ifKnives(() => {
        stroke.stop();
        board.cutOnce(0, Math.PI / 2);
      }),
      draw: ifKnives(() => {
        if (board.bodies.length === 1) stroke.toggle();
      }),
      more: ifKnives(() => board.cutAgain()),
      fewer: ifKnives(() => board.undo()),
      lay: ifKnives(() => board.layOpen()),
      dark: () => paper.toggle(),
    };
  }
  keysOf(acts) {
    const {board, stroke} = this, nudge = (change) => () => board.changeKnife(change);
    const step = () => 0.01 * board.first.frame.size;
    return {
      ArrowLeft: () => board.orbit(0.12, 0),
      ArrowRight: () => board.orbit(-0.12, 0),
      ArrowUp: () => board.orbit(0, 0.12),
      ArrowDown: () => board.orbit(0, -0.12),
      '+': () => board.zoom(1.12),
      '=': () => board.zoom(1.12),
      '-': () => board.zoom(1 / 1.12),
      h: acts.half,
      x: acts.across,
      b: acts.draw,
      c: acts.more,
      Backspace: acts.fewer,
      l: acts.dark,
      ' ': acts.lay,
      w: nudge((k) => {
        k.shift += step();
      }),
      s: nudge((k) => {
        k.shift -= step();
      }),
      a: nudge((k) => {
        k.turn -= 0.06;
      }),
      d: nudge((k) => {
        k.turn += 0.06;
      }),
      q: nudge((k) => {
        k.tilt -= 0.06;
      }),
      e: nudge((k) => {
        k.tilt += 0.06;
      }),
      Escape: () => {
        if (board.draws) stroke.toggle();
      },
    };
  }
  press(event) {
    const act = this.keys[event.key] || this.keys[event.key.toLowerCase()], {target} = event;
    const is = (what) => Boolean(target.matches && target.matches(what));
    if (
      !act || is('input') || is('button') && event.key === ' ' || event.ctrlKey || event.metaKey || event.altKey ||
      !this.board.setting)
      return;
    event.preventDefault();
    act();
  }
  show() {
    const {board} = this, {knife} = board, cuts = board.setting.takesKnives, {size} = board.first.frame;
    for (const id of ['half', 'across']) $(id).disabled = !cuts;
    $('draw').disabled = !cuts || board.bodies.length > 1;
    for (const id of ['shift', 'turn', 'tilt', 'waves']) $(id).disabled = !knife || knife.drawn !== null;
    $('fewer').disabled = !knife;
    $('apart').disabled = cuts && !knife;
    $('more').disabled = !knife || board.knives.length >= mostKnives;
    $('lay').disabled = board.knives.length !== 1;
    $('lay').setAttribute('aria-pressed', String(board.wantedOpen > 0.5 && board.knives.length === 1));
    $('apart').value = board.wantedApart;
    if (!knife) return;
    $('shift').value = knife.shift / (0.5 * size);
    $('turn').value = knife.turn * 180 / Math.PI;
    $('tilt').value = knife.tilt * 180 / Math.PI;
    $('waves').value = knife.waves;
  }
}
