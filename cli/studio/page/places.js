// The place on a surface of a point of the drawing: along its vertical curve in the side view, around the axis or in
// its fold in the top view; and its side. As in the sweep, the front is away from the axis, or outside of a loop.
import {Bezier} from './bezier.js';
import {A} from './svg_text.js';
import {entryOf} from './toml_tree.js';

const flattened = (part, steps = 24) => {
  const pairs = Bezier.segments(part);
  const points = pairs.flatMap((pair) => Array.from({length: steps}, (_, i) => Bezier.at(pair, i / steps)));
  const {nodes, closed} = part;
  return closed || nodes.length === 0 ? points : [...points, nodes[nodes.length - 1].p];
};
const lengthsOf = (points) => {
  let sum = 0;
  return points.map((p, i) => (sum += i ? Math.hypot(p[0] - points[i - 1][0], p[1] - points[i - 1][1]) : 0));
};
const areaOf = (points) => points.reduce((sum, [x, y], i) => {
  const [u, v] = points[(i + 1) % points.length];
  return sum + x * v - u * y;
}, 0) / 2;
const turnOf = ([x, y]) => (Math.atan2(y, x) / (2 * Math.PI) + 1) % 1;

/**
 * A paintable line: {curve, surface, view, points, places, closed, circular, frontRight, long}. `points` are on the
 * page, `places` 0..1 at each; `long` is the length on the page of a ramp from 0 to 1; `frontRight` is true if the
 * front is on the right in the direction of the line.
 */
function sideLine(studio, curve, surface) {
  const toMetres = studio.toMetres.side;
  const part = (studio.selected?.curve?.id === curve.id && studio.dragged || curve.parts)[0];
  if (!toMetres || !part) return null;
  let points = flattened(part), metres = points.map((p) => A.point(toMetres, p));
  const closed = part.closed, inFold = surface.type === 'in-fold';
  if (points.length < 2) return null;
  if (closed ? inFold && areaOf(metres) < 0 : metres[0][1] > metres[metres.length - 1][1]) {
    points = points.reverse();
    metres = metres.reverse();
  }
  if (closed && inFold) {
    const low = metres.reduce((best, p, i) => (p[1] < metres[best][1] ? i : best), 0);
    [points, metres] = [points, metres].map((list) => [...list.slice(low), ...list.slice(0, low)]);
  }
  if (closed) {
    points.push(points[0]);
    metres.push(metres[0]);
  }
  const length = lengthsOf(points), whole = length[length.length - 1] || 1;
  const top = metres.reduce((best, p, i) => (p[1] > metres[best][1] ? i : best), 0);
  // A loop in a fold is two arcs from its bottom to its top, with the same ramp.
  const places = !(closed && inFold)
    ? length.map((l) => l / whole)
    : length.map((l, i) => (i <= top ? l / (length[top] || 1) : (whole - l) / (whole - length[top] || 1)));
  const swept = metres.reduce((sum, [x, y], i) => {
    const [u, v] = metres[Math.min(i + 1, metres.length - 1)];
    return sum + (v - y) * (x * x + x * u + u * u);
  }, 0);
  return {
    curve,
    surface,
    view: 'side',
    points,
    places,
    circular: closed && !inFold,
    frontRight: inFold || swept >= 0,
    long: closed && inFold ? whole / 2 : whole
  };
}

/**
 * The rings of a surface seen from above: its loops, or a circle. `places` are azimuths; `around` runs in every fold.
 */
function topLines(studio, surface) {
  const toMetres = studio.toMetres.top, {drawing} = studio;
  if (!toMetres) return [];
  const loops = drawing.curves.filter(
    (curve) => curve.view === 'top' && curve.kind === 'curve' && drawing.surfaceOf(curve) === surface &&
      curve.parts[0]?.nodes.length > 1);
  const lines =
    loops.map((curve) => ({
                curve,
                points: flattened(
                  {...(studio.selected?.curve?.id === curve.id && studio.dragged || curve.parts)[0], closed: true})
              }));
  if (loops.length === 0 && surface.type !== 'in-fold') lines.push(...circleOf(studio, surface, A.inverse(toMetres)));
  return lines.filter(({points}) => points.length > 2).map(({curve, points}) => {
    const metres = points.map((p) => A.point(toMetres, p));
    const turned = areaOf(metres) < 0 ? (list) => [list[0], ...list.slice(1).reverse()] : (list) => list;
    const [ring, places] = [turned(points), turned(metres).map(turnOf)], axis = A.point(A.inverse(toMetres), [0, 0]);
    ring.push(ring[0]);
    places.push(places[0]);
    return {
      curve,
      surface,
      view: 'top',
      points: ring,
      places,
      ...aroundOf(studio, surface, ring, places),
      circular: true,
      frontRight: true,
      axis
    };
  });
}
/** A circle as wide as the vertical curve, if no loop is drawn. */
function circleOf(studio, surface, toPage) {
  const curve =
    studio.drawing.curves.find((c) => c.view === 'side' && studio.drawing.surfaceOf(c) === surface && c.parts[0]);
  const toMetres = studio.toMetres.side;
  if (!curve || !toMetres) return [];
  const radius = Math.max(...flattened(curve.parts[0]).map((p) => A.point(toMetres, p)[0]));
  return [{
    curve,
    points: Array.from(
      {length: 96},
      (_, i) => A.point(toPage, [radius * Math.cos(i * Math.PI / 48), radius * Math.sin(i * Math.PI / 48)]))
  }];
}
/** Shares around: in a fold from the loop's first point; around the axis from fold line to fold line, or from +X. */
function aroundOf(studio, surface, ring, turns) {
  const length = lengthsOf(ring), whole = length[length.length - 1] || 1;
  if (surface.type === 'in-fold') return {around: length.map((l) => l / whole), long: whole};
  const lines = foldTurns(studio), starts = lines.length ? lines : [0];
  // The arc length from the ring's first point, as a function of the azimuth.
  const unwrapped = turns.map((t, i) => (i === turns.length - 1 ? turns[0] + 1 : t < turns[0] - 1e-9 ? t + 1 : t));
  const lengthAt = (turn) => {
    const t = turn < turns[0] ? turn + 1 : turn, i = Math.max(1, unwrapped.findIndex((u) => u >= t));
    const [a, b] = [unwrapped[i - 1], unwrapped[i]];
    return length[i - 1] + (length[i] - length[i - 1]) * (b > a ? (t - a) / (b - a) : 0);
  };
  const cuts = starts.map(lengthAt);
  return {
    long: whole / starts.length,
    around: length.map((l) => {
      const past = cuts.map((c) => (l - c + whole) % whole), k = past.indexOf(Math.min(...past));
      const next = (cuts[(k + 1) % cuts.length] - cuts[k] + whole) % whole || whole;
      return Math.min(1, past[k] / next);
    })
  };
}
/** The starts of folds as ascending shares of the turn; none in a cylindrical fruit. */
export function foldTurns(studio) {
  const {drawing} = studio, symmetry = entryOf(drawing.tree, 'symmetry');
  const count = Number(entryOf(symmetry, 'folds')?.text) || 0, toMetres = studio.toMetres.top;
  if (entryOf(symmetry, 'kind')?.text !== 'folds' || count < 1) return [];
  const said = entryOf(symmetry, 'fold_angles')?.items?.map(({text}) => Number(text) / 360), drawn = drawing.folds();
  if (said?.every(Number.isFinite)) return said.map((t) => (t + 1) % 1).sort((a, b) => a - b);
  if (toMetres && drawn.length === count)
    return drawn
      .map(
        (ends) =>
          turnOf(ends.map((p) => A.point(toMetres, p)).reduce((a, b) => (Math.hypot(...b) > Math.hypot(...a) ? b : a))))
      .sort((a, b) => a - b);
  return Array.from({length: count}, (_, k) => k / count);
}

/** The nearest point of a line to a place of the page: {line, distance, point, way, place, around, side}. */
export function nearestOn(line, place) {
  let best = {line, distance: Infinity};
  const {points} = line;
  const blend = (list, i, t) =>
    (Math.abs(list[i + 1] - list[i]) > 0.5 ? list[t < 0.5 ? i : i + 1] : list[i] + (list[i + 1] - list[i]) * t);
  for (let i = 0; i + 1 < points.length; ++i) {
    const [a, b] = [points[i], points[i + 1]], way = [b[0] - a[0], b[1] - a[1]], square = way[0] ** 2 + way[1] ** 2;
    const t = square ? Math.max(0, Math.min(1, ((place[0] - a[0]) * way[0] + (place[1] - a[1]) * way[1]) / square)) : 0;
    const point = [a[0] + t * way[0], a[1] + t * way[1]];
    const distance = Math.hypot(point[0] - place[0], point[1] - place[1]);
    if (distance >= best.distance) continue;
    // On the page y points down, so a positive turn is to the right.
    const right = way[0] * (place[1] - point[1]) - way[1] * (place[0] - point[0]) > 0;
    best = {
      line,
      distance,
      point,
      way,
      place: blend(line.places, i, t),
      around: line.around ? blend(line.around, i, t) : 0,
      side: right === line.frontRight ? 'front' : 'back'
    };
  }
  return best;
}

/** A place left of the axis is mirrored, so that the other half of a fruit can be painted, too. */
export function onTheRight(studio, view, place) {
  const m = view === 'side' && studio.toMetres.side;
  if (!m) return place;
  const [x, y] = A.point(m, place);
  return x < 0 ? A.point(A.inverse(m), [-x, y]) : place;
}

/** All paintable lines of a view. */
export function paintLines(studio, view) {
  const {drawing} = studio;
  if (view === 'top') return drawing.surfaces.flatMap((surface) => topLines(studio, surface));
  return drawing.curves.filter((curve) => curve.view === 'side' && curve.kind === 'curve')
    .map((curve) => [curve, drawing.surfaceOf(curve)])
    .filter(([, surface]) => surface)
    .map(([curve, surface]) => sideLine(studio, curve, surface))
    .filter(Boolean);
}
