// The colours of every side as bars of stops: the ground, the coats with their reach, the spots. Stops are dragged
// along their bar, painted, added and removed, by mouse and keys.
import {linearOf} from '../../../render/page/color.js';
import {$, $$} from '../../../render/page/messages.js';

import {element, svgElement} from './elements.js';
import {colorKind, hexOf, overTheSeam, rampAt, rampEdit, rampText, readRamp} from './ramp.js';
import {sideNamed, sideOf, sideWords, withCoat, withoutCoat} from './side_text.js';
import {edited} from './svg_text.js';
import {entryOf, withEntry} from './toml_tree.js';

/** A ramp by its path in a side: ['ground', 'along'], ['coats', 0, 'color'], ['spots', 1]. */
function rampIn(side, path) {
  if (path[0] === 'spots') return readRamp(colorKind, entryOf(side?.spots[path[1]], 'color'), [0, 0, 0]);
  return path.reduce((value, key) => value?.[key], side);
}
const isChosen = ({chosenStop}, at, stop) => chosenStop?.surface === at.surface.name &&
  chosenStop.side === at.side.which && chosenStop.path.join() === at.path.join() && chosenStop.stop === stop;
const wordsFor = ({surface, side, label = ''}) =>
  `${surface.name} ${sideWords[side.which]}${label ? `, ${label}` : ''}`;

export function setChosenColor(studio, color) {
  const {chosenStop} = studio, side = chosenStop && sideNamed(studio.drawing, chosenStop.surface, chosenStop.side);
  const ramp = side && rampIn(side, chosenStop.path), stop = ramp?.stops[chosenStop.stop];
  if (!stop?.node) return false;
  const stops = ramp.stops.map((s) => (s === stop ? {...s, value: linearOf(color)} : s));
  putRamp(studio, {ramp}, stops, `${chosenStop.surface}: ${color}`);
  return true;
}
/** Writes the stops of a ramp; a new ramp becomes a key of its table. */
export function putRamp(studio, {ramp, table = null, key = ''}, stops, words) {
  const {toml} = studio.texts;
  const edit = ramp.node ? rampEdit(toml, ramp, stops) : withEntry(toml, table, key, rampText(ramp.kind, stops));
  studio.commit({...studio.texts, toml: edited(toml, [edit])}, words);
}

export function showPaint(studio) {
  const list = $('paint'), focused = $$('[data-key]:focus', list)[0]?.dataset.key;
  list.replaceChildren(...studio.drawing.surfaces.flatMap((surface, index) => ['front', 'back'].flatMap((which) => {
    const side = sideOf(studio.drawing.tree, index, which);
    return side ? rowsOf(studio, surface, side) : [];
  })));
  if (focused) $$('[data-key]', list).find(({dataset}) => dataset.key === focused)?.focus();
}

function rowsOf(studio, surface, side) {
  const at = (label, path, more = {}) => ({surface, side, label, path, ramp: rampIn(side, path), ...more}), rows = [];
  const more = element('button', {
    className: 'small',
    textContent: '+ coat',
    title: 'A coat of paint more over this side; the brush says where it lies (B, then C)'
  });
  more.setAttribute('aria-label', `${wordsFor({surface, side})}: add a coat`);
  more.addEventListener('click', () => addCoat(studio, surface, side));
  if (side.ground.along)
    rows.push(rowOf(colorBar(studio, at('', ['ground', 'along'])), wordsFor({surface, side}), [more]));
  for (const [key, label] of [['around', '× around'], ['turn', '× whole turn']]) {
    if (side.ground[key]?.node) rows.push(rowOf(colorBar(studio, at(label, ['ground', key])), label, [], true));
  }
  for (const coat of side.coats)
    if (coat.color) rows.push(...coatRows(studio, surface, side, coat, at));
  side.spots.forEach((_, i) => {
    if (rampIn(side, ['spots', i]))
      rows.push(rowOf(colorBar(studio, at(`spots ${i + 1}`, ['spots', i])), `spots ${i + 1}`, [], true));
  });
  return rows;
}
function rowOf(bar, label, buttons = [], inner = false) {
  const name = typeof label === 'string' ? element('span', {textContent: label}) : label;
  const row = element(
    'div', {className: `ramp${inner ? ' inner' : ''}`}, name, bar, element('span', {className: 'more'}, ...buttons));
  return row;
}

/** A coat: its colour with its opacity; for the coat that the brush paints also its reach along and around. */
function coatRows(studio, surface, side, coat, at) {
  const {brush} = studio, label = `coat ${coat.index + 1}`;
  const chosen = brush.coats[brush.keyOf(surface, side.which)] === coat.index && brush.what === 'coat' && !brush.fresh;
  const name =
    element('button', {className: 'small', textContent: label, title: 'Paint this coat, and see how far it reaches'});
  const gone = element('button', {className: 'small', textContent: '×', title: 'Take this coat away'});
  name.setAttribute('aria-pressed', String(chosen));
  name.setAttribute('aria-label', `${wordsFor({surface, side, label})}: paint it`);
  name.dataset.key = `${brush.keyOf(surface, side.which)}/coat${coat.index}`;
  gone.setAttribute('aria-label', `${wordsFor({surface, side, label})}: take it away`);
  name.addEventListener('click', () => chooseCoat(studio, surface, side, coat.index));
  gone.addEventListener(
    'click',
    () => studio.commit(
      {...studio.texts, toml: withoutCoat(studio.texts.toml, side, coat.index)}, `${surface.name}: a coat less`));
  const rows =
    [rowOf(colorBar(studio, at(label, ['coats', coat.index, 'color'], {over: coat.along})), name, [gone], true)];
  if (!chosen) return rows;
  const names = {along: 'along', turn: 'around the axis', around: 'in each fold'};
  for (const key of ['along', 'turn', 'around'])
    if (coat[key]) {
      const bar = reachBar(studio, at(`${label} ${names[key]}`, ['coats', coat.index, key], {table: coat.node, key}));
      rows.push(rowOf(bar, names[key], [], true));
    }
  return rows;
}
function chooseCoat(studio, surface, side, index) {
  const {brush} = studio;
  const curve = studio.drawing.curves.find((c) => c.view === 'side' && studio.drawing.surfaceOf(c) === surface);
  const coat = side.coats[index];
  brush.coats[brush.keyOf(surface, side.which)] = index;
  Object.assign(
    brush, {what: 'coat', fresh: false, color: coat?.color ? hexOf(coat.color.stops[0].value) : brush.color});
  if (curve) studio.select(curve);
  studio.setTool('brush');
  studio.say(`${wordsFor({surface, side})}: paint where coat ${index + 1} lies, from the side and from above`);
}
/** Until it is painted, or its reach is drawn, it covers everything, so that it is visible at once. */
function addCoat(studio, surface, side) {
  const {brush} = studio, index = side.coats.length;
  brush.coats[brush.keyOf(surface, side.which)] = index;
  Object.assign(brush, {what: 'coat', fresh: false});
  studio.commit(
    {...studio.texts, toml: withCoat(studio.texts.toml, side, {color: `"${brush.color}"`})},
    `${surface.name}: a coat more`);
  const now = studio.drawing.surfaces.find(({name}) => name === surface.name);
  const anew = sideNamed(studio.drawing, surface.name, side.which);
  if (anew) chooseCoat(studio, now, anew, index);
}

// ---- Bars. ----

/** The colour mixed as in the program, in linear light, with the coat's opacity there. */
function gradient(ramp, over) {
  const places = [...new Set([0, 1, ...ramp.stops.map(({at}) => at), ...(over?.stops || []).map(({at}) => at)])].sort(
    (a, b) => a - b);
  const color = (t) =>
    hexOf(rampAt(ramp, t)) + (over ? Math.round(255 * rampAt(over, t)).toString(16).padStart(2, '0') : '');
  return `linear-gradient(to right in srgb-linear, ${
    places.map((t) => `${color(t)} ${(100 * t).toFixed(2)}%`).join(', ')})`;
}
function colorBar(studio, at) {
  const {ramp, over} = at;
  const bar = element(
    'div', {className: `bar${over ? ' thin' : ''}`, title: 'Two clicks add a stop'},
    element('div', {className: 'fill'}));
  bar.firstChild.style.background = gradient(ramp, over);
  bar.addEventListener('dblclick', (event) => {
    if (!event.target.closest('.stop')) addStop(studio, at, event.offsetX / bar.clientWidth);
  });
  ramp.stops.forEach((_, i) => bar.append(stopOf(studio, at, i, bar)));
  return bar;
}
/** A share as a line over its bar: higher means more cover. */
function reachBar(studio, at) {
  const {ramp, key} = at, shown = key === 'turn' ? overTheSeam(ramp) : ramp;
  const bar = element('div', {className: 'bar reach', title: 'How far the coat covers; two clicks add a point'});
  const picture = svgElement('svg', {viewBox: '0 0 1 1', preserveAspectRatio: 'none', 'aria-hidden': 'true'});
  const points = [0, ...shown.stops.map((s) => s.at), 1].map(
    (t, i, all) => `${t} ${
      1 -
      (i === 0                  ? shown.stops[0].value
         : i === all.length - 1 ? shown.stops[shown.stops.length - 1].value
                                : shown.stops[i - 1].value)}`);
  picture.append(svgElement('path', {d: `M 0 1 L ${points.join(' L ')} L 1 1 Z`}));
  bar.append(picture);
  bar.addEventListener('dblclick', (event) => {
    if (!event.target.closest('.stop')) addStop(studio, at, event.offsetX / bar.clientWidth);
  });
  if (ramp.node && !ramp.constant) ramp.stops.forEach((_, i) => bar.append(stopOf(studio, at, i, bar)));
  return bar;
}

function stopOf(studio, at, i, bar) {
  const {ramp, path} = at, stop = ramp.stops[i], isColor = ramp.kind === colorKind;
  const button = element('button', {className: `stop${isColor ? '' : ' point'}`});
  const shown = isColor ? hexOf(stop.value) : `${Math.round(100 * stop.value)} %`;
  button.dataset.key = `${at.surface.name}/${at.side.which}/${path.join('/')}/${i}`;
  button.title = isColor ? `${shown}: click to choose, twice for a palette; arrow keys move it, Delete takes it away`
                         : `${shown}: drag, or arrow keys; Delete takes it away`;
  button.setAttribute(
    'aria-label', `${wordsFor(at)}, ${shown}${ramp.constant ? '' : ` at ${Math.round(100 * stop.at)} %`}`);
  if (isColor) button.setAttribute('aria-pressed', String(isChosen(studio, at, i)));
  const lay = (place, value) => {
    button.style.left = `${100 * place}%`;
    if (isColor) button.style.background = shown;
    else button.style.top = `${100 * (1 - value)}%`;
  };
  lay(ramp.constant ? 0.5 : stop.at, stop.value);
  dragStop(studio, at, i, bar, button, lay);
  if (isColor) {
    button.addEventListener('dblclick', () => palette(studio, button, shown));
    button.addEventListener('click', (event) => {
      if (event.detail === 0) {
        if (isChosen(studio, at, i)) palette(studio, button, shown);
        else chooseStop(studio, at, i, button);
      }
    });
  }
  button.addEventListener('keydown', (event) => {
    const by = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    const many = event.shiftKey ? 5 : 1;
    if (event.key === 'Delete' || event.key === 'Backspace') removeStop(studio, at, i);
    else if (by)
      moveStop(studio, at, i, stop.at + 0.01 * many * by[0], isColor ? stop.value : stop.value + 0.02 * many * by[1]);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  return button;
}
function chooseStop(studio, at, i, button) {
  studio.chosenStop = {surface: at.surface.name, side: at.side.which, path: at.path, stop: i};
  for (const other of $$('.stop:not(.point)')) other.setAttribute('aria-pressed', String(other === button));
  studio.say(`${wordsFor(at)}: the pipette fills this colour (I)`);
}
function dragStop(studio, at, i, bar, button, lay) {
  const {ramp} = at, stop = ramp.stops[i], isColor = ramp.kind === colorKind;
  let from = null, place = stop.at, value = stop.value, moved = false;
  button.addEventListener('pointerdown', (event) => {
    from = [event.clientX, event.clientY];
    button.setPointerCapture(event.pointerId);
  });
  button.addEventListener('pointermove', (event) => {
    if (!from || ramp.constant || !moved && Math.hypot(event.clientX - from[0], event.clientY - from[1]) < 3) return;
    moved = true;
    place = within(ramp.stops, i, stop.at + (event.clientX - from[0]) / bar.clientWidth);
    if (!isColor) value = Math.max(0, Math.min(1, stop.value - (event.clientY - from[1]) / bar.clientHeight));
    lay(place, value);
  });
  button.addEventListener('pointerup', () => {
    from = null;
    if (moved) moveStop(studio, at, i, place, value);
    else if (isColor) chooseStop(studio, at, i, button);
  });
}
/** A stop stays between its neighbours. */
function within(stops, i, place) {
  const low = i > 0 ? stops[i - 1].at + 0.002 : 0, high = i + 1 < stops.length ? stops[i + 1].at - 0.002 : 1;
  return Math.max(low, Math.min(high, place));
}
function moveStop(studio, at, i, place, value) {
  const {ramp} = at;
  const to = {
    at: Number(within(ramp.stops, i, place).toFixed(3)),
    value: ramp.kind === colorKind ? value : Math.max(0, Math.min(1, value))
  };
  if (ramp.constant) return;
  putRamp(
    studio, at, ramp.stops.map((stop, k) => (k === i ? to : stop)),
    `${wordsFor(at)}: ${ramp.kind === colorKind ? `stop at ${to.at}` : `${Math.round(100 * to.value)} % at ${to.at}`}`);
}
/** The browser's colour dialog at the stop. */
function palette(studio, button, color) {
  const input = element('input', {type: 'color', value: color, className: 'palette', tabIndex: -1});
  button.parentElement.append(input);
  input.style.left = button.style.left;
  input.addEventListener('change', () => {
    input.remove();
    setChosenColor(studio, input.value);
  });
  input.click();
}

/** Adds a stop between two others, or beyond them; a constant becomes a ramp. */
function addStop(studio, at, share) {
  const {ramp} = at, place = Number(Math.max(0, Math.min(1, share)).toFixed(3));
  const value = rampAt(at.key === 'turn' ? overTheSeam(ramp) : ramp, place);
  if (at.path[0] === 'spots' || ramp.stops.some((s) => !ramp.constant && Math.abs(s.at - place) < 0.004)) return;
  const made = {at: place, value};
  const kept =
    ramp.constant ? [0, 1].filter((end) => Math.abs(end - place) > 0.02).map((end) => ({at: end, value})) : ramp.stops;
  const stops = [...kept, made].sort((a, b) => a.at - b.at);
  if (ramp.kind === colorKind)
    studio.chosenStop = {surface: at.surface.name, side: at.side.which, path: at.path, stop: stops.indexOf(made)};
  putRamp(studio, at, stops, 'a stop more');
}
function removeStop(studio, at, i) {
  const {ramp} = at;
  if (ramp.constant || ramp.stops.length < 2) return;
  putRamp(studio, at, ramp.stops.filter((_, k) => k !== i), `${wordsFor(at)}: a stop less`);
}
