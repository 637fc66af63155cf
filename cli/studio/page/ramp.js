// Ramps: read from the template's text, painted over, and written again so that unchanged stops keep their text.
// Colours are mixed as in the program, in linear light.
import {linearOf} from '../../../render/page/color.js';

export const hexOf = (linear) => `#${
  linear
    .map(
      (v) => Math.round(255 * Math.max(0, Math.min(1, v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055)))
               .toString(16)
               .padStart(2, '0'))
    .join('')}`;

/** Kinds of values of ramps: how they are read, written, mixed, and when two look the same. */
export const colorKind = {
  read: (node) => (node?.kind === 'string' && /^#[0-9a-f]{6}$/i.test(node.text) ? linearOf(node.text) : null),
  write: (value) => `"${hexOf(value)}"`,
  mix: (a, b, t) => a.map((v, k) => v + (b[k] - v) * t),
  alike(a, b) {
    const [x, y] = [hexOf(a), hexOf(b)];
    return [1, 3, 5].every((k) => Math.abs(parseInt(x.slice(k, k + 2), 16) - parseInt(y.slice(k, k + 2), 16)) <= 2);
  },
};
export const shareKind = {
  read: (node) => (node?.kind === 'plain' && Number.isFinite(Number(node.text)) ? Number(node.text) : null),
  write: (value) => String(Number(value.toFixed(3))),
  mix: (a, b, t) => a + (b - a) * t,
  alike: (a, b) => Math.abs(a - b) <= 0.012,
};

/**
 * {kind, node, stops: [{at, value, node}], constant}; null for anything else. A missing node is `otherwise` everywhere.
 */
export function readRamp(kind, node, otherwise) {
  if (!node) return {kind, node: null, constant: true, stops: [{at: 0, value: otherwise}]};
  const alone = kind.read(node);
  if (alone !== null) return {kind, node, constant: true, stops: [{at: 0, value: alone, node}]};
  if (node.kind !== 'array' || node.items.length === 0) return null;
  const stops = node.items.map(
    (pair) =>
      (pair.kind === 'array' && pair.items.length === 2
         ? {at: shareKind.read(pair.items[0]), value: kind.read(pair.items[1]), node: pair}
         : {at: null}));
  return stops.every(({at, value}, i) => at !== null && value !== null && (i === 0 || at > stops[i - 1].at))
    ? {kind, node, constant: false, stops}
    : null;
}

export function rampAt({kind, stops}, t) {
  const after = stops.findIndex(({at}) => at > t);
  if (after === 0) return stops[0].value;
  if (after < 0) return stops[stops.length - 1].value;
  const [a, b] = [stops[after - 1], stops[after]];
  return kind.mix(a.value, b.value, (t - a.at) / (b.at - a.at));
}

/**
 * The stops of a ramp around the whole fruit, which continues over the seam from the last stop to the first, with stops
 * at 0 and 1, as in the reader.
 */
export function overTheSeam(ramp) {
  const {kind, stops} = ramp, [first, last] = [stops[0], stops[stops.length - 1]], gap = first.at + 1 - last.at;
  if (!(gap > 0)) return ramp;
  const seam = first.at === 0 ? first.value
    : last.at === 1           ? last.value
                              : kind.mix(last.value, first.value, (1 - last.at) / gap);
  const all = [...stops];
  if (first.at > 0) all.unshift({at: 0, value: seam});
  if (last.at < 1) all.push({at: 1, value: seam});
  return {...ramp, stops: all};
}

/** The points needed to approximate a line within `same`, including the first and the last. */
function fewest(points, same) {
  const keep = (from, to) => {
    let worst = 0, at = -1;
    for (let i = from + 1; i < to; ++i) {
      const off = same(points[from], points[to], points[i]);
      if (off > worst) {
        worst = off;
        at = i;
      }
    }
    return at < 0 ? [] : [...keep(from, at), points[at], ...keep(at, to)];
  };
  return points.length < 3 ? points : [points[0], ...keep(0, points.length - 1), points[points.length - 1]];
}

/**
 * Paints a stroke over a ramp: [[place, share 0..1], ...], ascending, from one end of the stroke to the other. Stops
 * outside it stay; within it values are `mixed(value, share, place)`, with no more stops than needed. A circular ramp
 * has stops at 0 and 1 (overTheSeam).
 */
export function paintedOver(ramp, stroke, mixed, circular = false) {
  const round = (t) => Number(t.toFixed(3));
  const cover = stroke.map(([at, share]) => [round(at), share]).filter(([at], i, all) => i === 0 || at > all[i - 1][0]);
  const {kind, stops} = ramp, [low, high] = [cover[0][0], cover[cover.length - 1][0]];
  const share = (t) => rampAt({kind: shareKind, stops: cover.map(([at, value]) => ({at, value}))}, t);
  const inside = (at) => at > low + 0.002 && at < high - 0.002;
  const places = [
    ...new Set(
      [...cover.map(([at]) => at), ...(ramp.constant ? [] : stops.map(({at}) => at).filter(inside))].map(round))
  ].sort((a, b) => a - b);
  const painted = places.map((at) => ({at, value: mixed(rampAt(ramp, at), share(at), at)}));
  const before = ramp.constant ? [] : stops.filter(({at}) => at < round(low) - 0.0015);
  const after = ramp.constant ? [] : stops.filter(({at}) => at > round(high) + 0.0015);
  const all = [...before, ...painted, ...after];
  // Stops on the line between their neighbours are omitted; existing stops outside the stroke stay.
  const off = (a, b, p) =>
    (kind.alike(kind.mix(a.value, b.value, (p.at - a.at) / (b.at - a.at)), p.value)
       ? 0
       : distance(kind.mix(a.value, b.value, (p.at - a.at) / (b.at - a.at)), p.value));
  const from = Math.max(0, before.length - 1), to = Math.min(all.length, before.length + painted.length + 1);
  return [
    ...all.slice(0, from),
    ...withoutEnds(kind, fewest(all.slice(from, to), off), !circular && from === 0, !circular && to === all.length),
    ...all.slice(to)
  ];
}
const distance = (a, b) =>
  (Array.isArray(a) ? Math.hypot(...a.map((v, k) => Math.cbrt(v) - Math.cbrt(b[k]))) : Math.abs(a - b));
/** A ramp is constant beyond its outermost stops, so two equal stops at an end become one. */
function withoutEnds(kind, stops, atStart, atEnd) {
  const left = [...stops];
  while (atStart && left.length > 1 && kind.alike(left[0].value, left[1].value)) left.shift();
  while (atEnd && left.length > 1 && kind.alike(left[left.length - 1].value, left[left.length - 2].value)) left.pop();
  return left;
}
/** Removes stops at the seam of the whole fruit if the others imply them. */
export function withoutSeam(kind, stops) {
  const inner = stops.filter(({at}) => at > 0 && at < 1), [first, last] = [stops[0], stops[stops.length - 1]];
  if (inner.length === 0 || first.at > 0 || last.at < 1 || !kind.alike(first.value, last.value)) return stops;
  const [a, b] = [inner[inner.length - 1], inner[0]];
  return kind.alike(kind.mix(a.value, b.value, (1 - a.at) / (1 - a.at + b.at)), first.value) ? inner : stops;
}

const placeText = (at) => (Number.isInteger(at) ? at.toFixed(1) : String(Number(at.toFixed(3))));
const stopText = (kind, {at, value}) => `[${placeText(at)}, ${kind.write(value)}]`;
/** A ramp as a TOML value: one stop is a plain value; long ones are wrapped. */
export function rampText(kind, stops) {
  if (stops.length === 1) return kind.write(stops[0].value);
  return `[${brokenList(stops.map((stop) => stopText(kind, stop)))}]`;
}
function brokenList(texts) {
  let line = 0;
  return texts
    .map((text, i) => {
      const breaks = i > 0 && line + text.length > 96;
      line = (breaks ? 4 : line) + text.length + 2;
      return i === 0 ? text : `,${breaks ? '\n    ' : ' '}${text}`;
    })
    .join('');
}

/** The edit of a ramp's text for these stops: unchanged stops at its ends are not touched, and no comment is lost. */
export function rampEdit(toml, {kind, node, constant, stops: old}, stops) {
  if (constant || stops.length === 1) return {from: node.from, to: node.to, text: rampText(kind, stops)};
  const same = (a, b) => a && b && a.node && a.at === b.at && a.value === b.value;
  let start = 0, end = 0;
  while (start < Math.min(old.length, stops.length) && same(old[start], stops[start])) ++start;
  while (end < Math.min(old.length, stops.length) - start &&
         same(old[old.length - 1 - end], stops[stops.length - 1 - end]))
    ++end;
  const texts = stops.slice(start, stops.length - end).map((stop) => stopText(kind, stop));
  const gone = old.slice(start, old.length - end);
  if (texts.length === 0 && gone.length === 0) return {from: node.from, to: node.from, text: ''};
  if (gone.length === 0) {
    const at = start > 0 ? old[start - 1].node.to : old[0].node.from;
    return {from: at, to: at, text: start > 0 ? `, ${brokenList(texts)}` : `${brokenList(texts)}, `};
  }
  const [from, to] = [gone[0].node.from, gone[gone.length - 1].node.to];
  const commentsIn =
    (a, b) => [...toml.slice(a, b).matchAll(/(?<=[\s,])#[^\n]*\n/g)].map(([text]) => `${text}    `).join('');
  if (texts.length > 0) return {from, to, text: commentsIn(from, to) + brokenList(texts)};
  // Remove one comma: at the end of the list the one before, else the one after.
  const [edge, next] = end > 0 ? [from, old[old.length - end].node.from] : [old[start - 1].node.to, to];
  const comments = commentsIn(edge, next);
  return {from: edge, to: next, text: comments && end === 0 ? `  ${comments}` : comments};
}
