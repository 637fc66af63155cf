// Buttons, sliders, keys.
import {$, $$} from '../../../render/page/messages.js';

import {attachBrush, setWhat, widenBrush} from './brush.js';
import {markSeed} from './variants.js';

export function attachPanel(studio) {
  const slide = (id, change) => $(id).addEventListener('input', () => change(Number($(id).value)));
  slide('photo', (v) => {
    studio.shown.photo = v;
    studio.redraw();
  });
  slide('section', (v) => {
    studio.shown.section = v;
    studio.redraw();
  });
  slide('height', (v) => {
    studio.shown.height = v;
    studio.sections.ask({texts: studio.texts, draft: false, began: performance.now()});
  });
  $('over').addEventListener('change', () => {
    studio.shown.photoOver = $('over').checked;
    studio.redraw();
  });
  const look = (change) => (v) => {
    change(v);
    studio.refresh();
  };
  slide('seed', (v) => {
    studio.look.seed = Math.max(0, Math.floor(v) || 0);
    markSeed(studio);
    studio.assets.ask({texts: studio.texts});
  });
  slide('folds', look((v) => {
          studio.look.folds = v || 0;
        }));
  slide('ripeness', look((v) => {
          studio.look.ripeness = v;
        }));
  slide('browning', look((v) => {
          studio.look.browning = v;
        }));
  slide('shift', (v) => studio.view?.setShift(v));
  const cut = (mode) => {
    for (const button of $$('[data-cut]')) button.setAttribute('aria-pressed', String(button.dataset.cut === mode));
    studio.view?.setCut(mode);
  };
  const dark = (on) => {
    document.documentElement.classList.toggle('dark', on);
    $('dark').setAttribute('aria-pressed', String(on));
    if (studio.view) {
      studio.view.dark = on;
      studio.view.moved();
    }
  };
  const fit = () => {
    for (const pane of Object.values(studio.panes)) {
      pane.fitted = false;
      pane.draw();
    }
  };
  for (const button of $$('[data-cut]')) button.addEventListener('click', () => cut(button.dataset.cut));
  for (const button of $$('[data-tool]')) button.addEventListener('click', () => studio.setTool(button.dataset.tool));
  const isDark = () => document.documentElement.classList.contains('dark');
  const buttons = {
    undo: () => studio.undo(),
    redo: () => studio.redo(),
    save: () => studio.save(),
    smooth: () => studio.nodes.toggleSmooth(),
    delete: () => studio.nodes.remove(),
    fit,
    dark: () => dark(!isDark())
  };
  for (const [id, act] of Object.entries(buttons)) $(id).addEventListener('click', act);
  dark(matchMedia('(prefers-color-scheme: dark)').matches);

  const keys = {
    v: () => studio.setTool('nodes'),
    p: () => studio.setTool('pen'),
    t: () => studio.setTool('trace'),
    i: () => studio.setTool('pick'),
    b: () => studio.setTool('brush'),
    g: () => setWhat(studio, 'ground'),
    c: () => setWhat(studio, 'coat'),
    n: () => setWhat(studio, 'new'),
    '[': () => widenBrush(studio, 1 / 1.2),
    ']': () => widenBrush(studio, 1.2),
    s: buttons.smooth,
    f: fit,
    l: buttons.dark,
    Delete: buttons.delete,
    Backspace: buttons.delete,
    Enter: () => studio.finishPen(),
    Escape: () => {
      if (studio.brush.stroke) studio.brush.cancel();
      else if (studio.pen) {
        studio.pen = null;
        studio.redraw();
      } else if (studio.tool !== 'nodes') studio.setTool('nodes');
      else studio.select(null);
    },
    1: () => cut('whole'),
    2: () => cut('glass'),
    3: () => cut('half'),
    4: () => cut('across'),
    ArrowLeft: () => studio.nodes.nudge(-1, 0),
    ArrowRight: () => studio.nodes.nudge(1, 0),
    ArrowUp: () => studio.nodes.nudge(0, -1),
    ArrowDown: () => studio.nodes.nudge(0, 1),
    '+': () => zoom(1.15),
    '=': () => zoom(1.15),
    '-': () => zoom(1 / 1.15)
  };
  const zoom = (by) => {
    for (const pane of Object.values(studio.panes))
      pane.zoom(by, [pane.root.clientWidth / 2, pane.root.clientHeight / 2]);
  };
  window.addEventListener('keydown', (event) => {
    const target = /** @type {Element} */ (event.target);
    const command = event.ctrlKey || event.metaKey;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    const writes = target.matches?.('input:not([type="range"]):not([type="checkbox"]), textarea, select, dialog *');
    if (command && key === 's') {
      event.preventDefault();
      studio.save();
      return;
    }
    if (writes || event.altKey) return;
    if (command && (key === 'z' || key === 'y')) {
      event.preventDefault();
      if (key === 'y' || event.shiftKey) studio.redo();
      else studio.undo();
      return;
    }
    const slides = target.matches?.('input[type="range"]') && key.startsWith('Arrow');
    const presses = target.matches?.('button, summary') && (key === 'Enter' || key === ' ');
    if (command || slides || presses || !keys[key]) return;
    event.preventDefault();
    keys[key]();
  });
  attachBrush(studio);
  $('name').addEventListener('change', () => studio.rename($('name').value));
  let typing = 0;
  $('toml').addEventListener('input', () => {
    clearTimeout(typing);
    typing = setTimeout(() => studio.commit({...studio.texts, toml: $('toml').value}, 'template edited'), 400);
  });
  window.addEventListener('beforeunload', (event) => {
    if (studio.unsent) event.preventDefault();
  });
}
