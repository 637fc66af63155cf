// Ribbons on both sides of a curve while painting: each side's current colours in the template, and the reach of the
// coat that is painted.
import {svgElement} from './elements.js';
import {hexOf, overTheSeam, rampAt} from './ramp.js';
import {sideColor, sideNamed} from './side_text.js';
import {tomlTree} from './toml_tree.js';

/**
 * A strip along a line on the screen between two distances beside it (positive to the right), with one path per run of
 * equal look.
 */
function strip(pane, line, from, to, lookAt) {
  const {points} = line, step = Math.max(1, Math.floor(points.length / 160)), indices = [], paths = [];
  for (let i = 0; i < points.length - 1; i += step) indices.push(i);
  indices.push(points.length - 1);
  const screen = indices.map((i) => pane.onScreen(points[i]));
  const beside = screen.map((p, k) => {
    const a = screen[Math.max(0, k - 1)], b = screen[Math.min(screen.length - 1, k + 1)];
    const long = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1, normal = [-(b[1] - a[1]) / long, (b[0] - a[0]) / long];
    return [from, to].map((d) => `${(p[0] + d * normal[0]).toFixed(1)} ${(p[1] + d * normal[1]).toFixed(1)}`);
  });
  for (let k = 0; k + 1 < screen.length;) {
    const look = lookAt(indices[k]), start = k;
    while (k + 1 < screen.length && (k === start || same(lookAt(indices[k]), look))) ++k;
    if (look.opacity <= 0.004) continue;
    const there = beside.slice(start, k + 1).map(([a]) => a);
    const back = beside.slice(start, k + 1).map(([, b]) => b).reverse();
    paths.push(tinted(svgElement('path', {class: 'ribbon', d: `M ${[...there, ...back].join(' L ')} Z`}), look));
  }
  return paths;
}
/** The page's security policy forbids style attributes, but scripts can set styles. */
function tinted(shape, {fill, opacity}) {
  Object.assign(shape.style, {fill, fillOpacity: opacity.toFixed(2)});
  return shape;
}
const same = (a, b) => a.fill === b.fill && Math.abs(a.opacity - b.opacity) < 0.02;

/** Both sides of the line under the brush, the coat on top, and the brush itself. */
export function drawBrush(pane) {
  const {studio} = pane, {brush} = studio, at = brush.at?.pane === pane ? brush.at : null;
  const shown = at?.found || restingLine(pane);
  if (shown) drawRibbons(pane, shown, at);
  if (!at) return;
  const [cx, cy] = pane.onScreen(at.place), wipes = brush.stroke?.erase;
  const rim = svgElement('circle', {class: `brush${wipes ? ' wipes' : ''}`, cx, cy, r: brush.size / 2});
  pane.marks.append(
    svgElement('circle', {class: 'brush under', cx, cy, r: brush.size / 2}),
    wipes ? rim : tinted(rim, {fill: brush.color, opacity: 0.25}));
}
/** Without a pointer nearby: the ribbons of the selected curve. */
function restingLine(pane) {
  const {studio} = pane, surface = studio.selected?.curve && studio.drawing.surfaceOf(studio.selected.curve);
  const line = surface && studio.brush.lines(pane.view).find(({surface: {name}}) => name === surface.name);
  return line ? {line, side: null} : null;
}

function drawRibbons(pane, {line, side: hovered}, at) {
  const {studio} = pane, {brush} = studio, {drawing} = studio;
  const tree = brush.stroke && studio.dragging ? tomlTree(studio.dragging.toml) : drawing.tree;
  const active = brush.stroke?.which || hovered;
  for (const which of ['front', 'back']) {
    const side = sideNamed(drawing, line.surface.name, which, tree);
    const sign = (which === 'front') === line.frontRight ? 1 : -1;
    if (!side?.ground.along) continue;
    const wide = which === active ? 9 : 5;
    if (line.view === 'side') {
      pane.marks.append(...strip(
        pane, line, sign * 2, sign * (2 + wide), (i) => ({fill: hexOf(sideColor(side, line.places[i])), opacity: 1})));
    }
    if (which !== active && !(line.view === 'top' && !active)) continue;
    const coats = brush.what === 'coat' || line.view === 'top'
      ? side.coats.slice(brush.stroke && brush.stroke.isCoat && !brush.stroke.coat ? -1 : 0)
      : [];
    const target =
      brush.stroke ? brush.stroke.coat?.index ?? side.coats.length - 1 : brush.coatOf(line.surface, which)?.index;
    const coat = coats.find(({index: i}) => i === target);
    if (coat?.color) pane.marks.append(...strip(pane, line, sign * 14, sign * 20, reachOf(coat, line, brush)));
  }
  if (!active || !at) return;
  const point = pane.onScreen(at.found.point);
  pane.marks.append(svgElement('circle', {class: 'brush spot', cx: point[0], cy: point[1], r: 3}));
}
/** The look of a coat's reach along a line: its colour, with its opacity there. */
function reachOf(coat, line, brush) {
  const key = line.view === 'side' ? 'along' : brush.eachFold || line.surface.type === 'in-fold' ? 'around' : 'turn';
  const places = key === 'around' ? line.around : line.places;
  const ramp = coat[key] && key === 'turn' ? overTheSeam(coat[key]) : coat[key];
  return (i) => ({
           fill: hexOf(rampAt(coat.color, line.view === 'side' ? places[i] : 0.5)),
           opacity: ramp ? rampAt(ramp, places[i]) : 1
         });
}
