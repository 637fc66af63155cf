// The brush: a stroke along a curve paints the side on which it runs, the ground or a coat over it; in the top view it
// paints how far a coat reaches around the axis.
import {linearOf} from '../../../render/page/color.js';
import {$, $$} from '../../../render/page/messages.js';

import {between} from './bezier.js';
import {showPaint} from './paint.js';
import {foldTurns, nearestOn, onTheRight, paintLines} from './places.js';
import {overTheSeam, paintedOver, rampAt, rampText, shareKind} from './ramp.js';
import {coatPainted, groundPainted, reachPainted, sideNamed, sideWords, withCoat} from './side_text.js';
import {edited} from './svg_text.js';

export class Brush {
  constructor(studio) {
    this.studio = studio;
    this.color = '#c23b22';
    this.size = 36;
    this.soft = 0.6;
    this.strength = 1;
    this.what = 'ground';
    this.fresh = false;
    this.eachFold = false;
    this.coats = {};
    this.stroke = null;
    this.at = null;
  }

  // ---- Under the brush. ----

  /** All paintable lines of a view; kept until the drawing or its scale changes. */
  lines(view) {
    const {studio: {drawing, toMetres}} = this, known = this.known?.[view];
    if (known?.drawing === drawing && known.toMetres === toMetres) return known.lines;
    const lines = paintLines(this.studio, view);
    this.known = {...this.known, [view]: {drawing, toMetres, lines}};
    return lines;
  }

  /**
   * The line and side that a stroke from here paints: the nearest in reach; of two at nearly the same distance, that of
   * the selected curve.
   */
  found(pane, place) {
    const {studio} = this, at = onTheRight(studio, pane.view, place), id = studio.selected?.curve?.id;
    const chosen = studio.selected && studio.drawing.surfaceOf(studio.selected.curve);
    const near = this.lines(pane.view)
                   .map((line) => nearestOn(line, at))
                   .filter(({distance}) => distance * pane.scale <= Math.max(14, this.size / 2 + 6));
    const rank = ({line, distance}) =>
      distance - (line.curve?.id === id || line.surface.name === chosen?.name ? 4 / pane.scale : 0);
    return near.sort((a, b) => rank(a) - rank(b))[0] || null;
  }
  sideAt({line: {surface}, side}) { return sideNamed(this.studio.drawing, surface.name, side); }
  keyOf(surface, side) { return `${surface.name}/${side}`; }
  /** The coat that is painted on a side: the selected one, else the topmost. */
  coatOf(surface, side) {
    const {coats} = sideNamed(this.studio.drawing, surface.name, side) || {coats: []};
    const wanted = this.coats[this.keyOf(surface, side)];
    return this.fresh ? null : coats[Math.min(wanted ?? coats.length - 1, coats.length - 1)] || null;
  }
  wordsFor(found) {
    const {line: {surface, view}, side} = found, coat = this.coatOf(surface, side);
    const what = this.what === 'ground' ? (view === 'side' ? 'ground' : 'around the axis only coats are painted (C)')
      : coat                            ? `coat ${coat.index + 1}`
                                        : 'new coat';
    return `${surface.name} ${sideWords[side]}: ${what}`;
  }

  // ---- Strokes. ----

  hover(pane, place) {
    if (!this.stroke) {
      this.at = {pane, place, found: this.found(pane, place)};
      $('brush-at').textContent = this.at.found ? this.wordsFor(this.at.found) : 'near no curve';
    } else this.at = {...this.at, pane, place};
    pane.drawMarks();
  }
  leave() {
    if (this.stroke) return;
    const {pane} = this.at || {};
    this.at = null;
    $('brush-at').textContent = '';
    pane?.drawMarks();
  }

  down(pane, place, event) {
    const {studio} = this, found = this.found(pane, place);
    if (event.ctrlKey || event.metaKey) {
      this.takeColor(pane, place);
      return;
    }
    if (!found) {
      studio.say(
        Object.keys(studio.toMetres).length ? 'Paint along a curve: there is none under the brush.'
                                            : 'There is something to mend first: see below.');
      return;
    }
    const side = this.sideAt(found), {line} = found, isCoat = this.what === 'coat', erase = event.shiftKey;
    const refused = !side?.ground.along ? 'The colours of this side are not in the template as the brush knows them.'
      : !isCoat && line.view === 'top'  ? 'Around the axis a coat is painted: press C, then paint.'
      : erase && !isCoat                ? 'Only coats are wiped off; the ground is painted over.'
      : isCoat && erase && !this.coatOf(line.surface, found.side) ? 'There is no coat to wipe off here.'
                                                                  : '';
    if (refused) {
      studio.say(refused);
      return;
    }
    if (line.curve && studio.selected?.curve?.id !== line.curve.id) studio.select(line.curve);
    const coat = isCoat ? this.coatOf(line.surface, found.side) : null;
    const key = line.view === 'side' ? 'along' : this.eachFold || line.surface.type === 'in-fold' ? 'around' : 'turn';
    if (coat && (!coat.color || !coat[key])) {
      studio.say('This coat is not written as the brush knows it.');
      return;
    }
    this.stroke = {pane, line, which: found.side, side, coat, isCoat, key, erase, spans: [], last: place};
    this.at = {pane, place, found};
    this.dab(place);
    this.show();
  }
  move(pane, place) {
    const {stroke} = this;
    if (!stroke || stroke.pane !== pane) {
      this.hover(pane, place);
      return;
    }
    const {last} = stroke, way = Math.hypot(place[0] - last[0], place[1] - last[1]) * pane.scale;
    const steps = Math.max(1, Math.ceil(way / Math.max(2, this.size / 6)));
    for (let i = 1; i <= steps; ++i) this.dab(between(last, place, i / steps));
    stroke.last = place;
    this.hover(pane, place);
    this.show();
  }
  up() {
    const {studio, stroke} = this;
    this.stroke = null;
    if (!stroke) return;
    const texts = studio.dragging;
    studio.dragging = null;
    this.fresh &&= !stroke.isCoat;
    const {surface} = stroke.line, count = stroke.side.coats.length;
    if (stroke.isCoat && !stroke.coat) this.coats[this.keyOf(surface, stroke.which)] = count;
    studio.commit(texts, `${surface.name} ${sideWords[stroke.which]} ${stroke.erase ? 'wiped' : 'painted'}`);
    showBrush(studio);
  }

  cancel() {
    if (!this.stroke) return;
    this.stroke = this.studio.dragging = null;
    this.studio.refresh();
    this.studio.redraw();
  }

  /** Continues the stroke to a place of the page: covers the place on the line and all places since the last one. */
  dab(place) {
    const {stroke, studio} = this, {line, pane, key} = stroke;
    const found = nearestOn(line, onTheRight(studio, pane.view, place)), radius = this.size / 2 / pane.scale;
    if (found.distance > 3 * radius + 20 / pane.scale) return;
    if (!stroke.reach) {
      const long = key === 'turn'
        ? 2 * Math.PI * Math.max(radius / 2, Math.hypot(found.point[0] - line.axis[0], found.point[1] - line.axis[1]))
        : line.long;
      stroke.reach = Math.min(0.5, Math.max(0.008, radius / long));
      stroke.hard = Math.min(stroke.reach * (1 - this.soft), stroke.reach - 0.006);
    }
    let middle = key === 'around' ? found.around : found.place;
    const {middle: before = middle, reach} = stroke;
    if (line.circular) middle += Math.round(before - middle);
    const from = Math.abs(middle - before) > 4 * reach ? middle : before;
    stroke.middle = middle;
    stroke.spans = joined([...stroke.spans, [Math.min(from, middle), Math.max(from, middle)]], 2 * stroke.hard);
  }

  /** The covered runs of [place, share], with fading ends. */
  covers() {
    const {spans, reach, hard, line: {circular}} = this.stroke, runs = [];
    for (const [low, high] of joined(
           circular ? [-1, 0, 1].flatMap((turn) => spans.map((span) => span.map((t) => t + turn))) : spans, 2 * hard)) {
      const run = [[low - reach, 0], [low - hard, 1], [high + hard, 1], [high + reach, 0]];
      const last = runs[runs.length - 1], end = last?.[last.length - 1][0];
      if (end > low - reach) {
        // Two fading ends meet where they are equal.
        const middle = (end + low - reach) / 2;
        last.splice(-1, 1, [middle, (end - middle) / (reach - hard)], ...run.slice(1));
      } else runs.push(run);
    }
    return runs.map((run) => clipped(run).map(([t, share]) => [t, share * this.strength]))
      .filter((run) => run.length > 1);
  }

  texts() {
    const {studio, stroke: {side, coat, isCoat, key, erase}} = this, {toml} = studio.texts, covers = this.covers();
    const color = linearOf(this.color);
    if (covers.length === 0) return studio.texts;
    if (!isCoat) return {...studio.texts, toml: groundPainted(toml, side, covers, color)};
    if (!coat) {
      const stops = (kind) => rampText(
        kind,
        covers
          .reduce(
            (r, cover) => ({
              kind,
              constant: false,
              stops: paintedOver(r, cover, (value, share) => Math.max(value, share), key === 'turn')
            }),
            overTheSeamIf(key, {kind, constant: true, stops: [{at: 0, value: 0}]}))
          .stops);
      return {...studio.texts, toml: withCoat(toml, side, {color: `"${this.color}"`, [key]: stops(shareKind)})};
    }
    if (key === 'along' && !erase) return {...studio.texts, toml: coatPainted(toml, coat, covers, color)};
    return {...studio.texts, toml: edited(toml, [reachPainted(toml, coat, key, covers, {erase})])};
  }
  show() {
    const {studio, stroke} = this;
    try {
      studio.dragging = this.texts();
    } catch (error) {
      console.error(error);
      return;
    }
    stroke.pane.drawMarks();
    studio.preview();
    // A side that faces air is not visible in a section.
    if (stroke.side.hidden) studio.assets.ask({texts: studio.dragging});
  }

  takeColor(pane, place) {
    const {studio} = this;
    const color = studio.pictures.colorAt(studio.drawing.images.filter(({view}) => view === pane.view), place) ||
      pane.sectionColor(place);
    if (!color) {
      studio.say('There is no colour here.');
      return;
    }
    this.color = color;
    showBrush(studio);
    studio.say(`the brush has ${color}`);
  }
}
/** Sorted spans; those with a distance of at most `gap` are joined. */
function joined(spans, gap) {
  const all = [];
  for (const [low, high] of [...spans].sort((a, b) => a[0] - b[0])) {
    const last = all[all.length - 1];
    if (last && low <= last[1] + gap) last[1] = Math.max(last[1], high);
    else all.push([low, high]);
  }
  return all;
}
/** The part of a run within 0..1. */
function clipped(run) {
  const at = (t) => rampAt({kind: shareKind, stops: run.map(([place, value]) => ({at: place, value}))}, t);
  const [low, high] = [run[0][0], run[run.length - 1][0]];
  if (high <= 0 || low >= 1) return [];
  return [
    ...(low < 0 ? [[0, at(0)]] : []), ...run.filter(([t]) => t >= 0 && t <= 1), ...(high > 1 ? [[1, at(1)]] : [])
  ];
}
const overTheSeamIf = (key, ramp) => (key === 'turn' ? overTheSeam(ramp) : ramp);

/** The brush's row of the toolbar. */
export function showBrush(studio) {
  const {brush, tool, drawing} = studio;
  $('brush').hidden = tool !== 'brush';
  $('brush-color').value = brush.color;
  $('brush-size').value = brush.size;
  for (const button of $$('[data-what]'))
    button.setAttribute(
      'aria-pressed', String(button.dataset.what === (brush.what === 'coat' && brush.fresh ? 'new' : brush.what)));
  $('brush-folds').parentElement.hidden = !drawing || foldTurns(studio).length === 0 || brush.what !== 'coat';
  $('brush-folds').checked = brush.eachFold;
  if (drawing) {
    showPaint(studio);
    studio.redraw();
  }
}
export function attachBrush(studio) {
  const {brush} = studio;
  const slide = (id, key, scale = 1) => $(id).addEventListener('input', () => {
    brush[key] = Number($(id).value) * scale;
    studio.redraw();
  });
  slide('brush-size', 'size');
  slide('brush-soft', 'soft');
  slide('brush-strength', 'strength');
  $('brush-color').addEventListener('input', () => {
    brush.color = $('brush-color').value;
  });
  $('brush-folds').addEventListener('change', () => {
    brush.eachFold = $('brush-folds').checked;
    studio.redraw();
  });
  for (const button of $$('[data-what]')) button.addEventListener('click', () => setWhat(studio, button.dataset.what));
}
/** "ground", "coat", or "new": the next stroke starts a new coat. */
export function setWhat(studio, what) {
  Object.assign(studio.brush, {what: what === 'new' ? 'coat' : what, fresh: what === 'new'});
  if (studio.tool !== 'brush') studio.setTool('brush');
  else showBrush(studio);
}
export function widenBrush(studio, by) {
  studio.brush.size = Math.round(Math.max(6, Math.min(160, studio.brush.size * by)));
  showBrush(studio);
}
