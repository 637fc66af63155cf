// The paint on the sides of surfaces in the template's text: the ground's ramps and the coats over it; and the edits
// that paint there.
import {
  colorKind,
  hexOf,
  overTheSeam,
  paintedOver,
  rampAt,
  rampEdit,
  rampText,
  readRamp,
  shareKind,
  withoutSeam
} from './ramp.js';
import {edited} from './svg_text.js';
import {entryOf, lineAfter, withEntry, withoutEntry, withoutOne} from './toml_tree.js';

export const sideWords = {
  front: 'outside',
  back: 'inside'
};
const coatRamps = ['along', 'around', 'turn'];

/**
 * {node, ground: {along, around, turn}, coats: [{node, index, color, along, around, turn}], spots, hidden}; null
 * without this side.
 */
export function sideOf(tree, surfaceIndex, which) {
  const surface = entryOf(tree, 'surface')?.items?.[surfaceIndex], node = entryOf(surface, which);
  if (node?.kind !== 'table') return null;
  const color = entryOf(node, 'color'), ramps = color?.kind === 'table', white = [1, 1, 1];
  const ground = {
    table: ramps ? color : null,
    along: color ? readRamp(colorKind, ramps ? entryOf(color, 'along') : color, [0.5, 0.5, 0.5]) : null
  };
  for (const key of ['around', 'turn'])
    ground[key] = readRamp(colorKind, ramps ? entryOf(color, key) : undefined, white);
  const coats =
    (entryOf(node, 'coats')?.items || [])
      .filter(({kind}) => kind === 'table')
      .map((coat, index) => ({
             node: coat,
             index,
             color: readRamp(colorKind, entryOf(coat, 'color'), white),
             ...Object.fromEntries(coatRamps.map((key) => [key, readRamp(shareKind, entryOf(coat, key), 1)])),
             folds: entryOf(coat, 'folds')
           }));
  return {
    node,
    which,
    ground,
    coats,
    spots: entryOf(node, 'spots')?.items || [],
    hidden: entryOf(node, 'hidden')?.text === 'true'
  };
}

export const sideNamed = (drawing, name, which, tree = drawing.tree) =>
  sideOf(tree, drawing.surfaces.findIndex((surface) => surface.name === name), which);

const meanOf = (ramp) => Array.from({length: 32}, (_, i) => rampAt(ramp, (i + 0.5) / 32))
                           .reduce(
                             (sum, v) => (Array.isArray(v) ? sum.map((s, k) => s + v[k] / 32) : sum + v / 32),
                             ramp.kind === colorKind ? [0, 0, 0] : 0);

/** The colour of a side at a place along, averaged around; linear. */
export function sideColor({ground, coats}, along) {
  const factors = [ground.around, ground.turn].map((ramp) => (ramp && !ramp.constant ? meanOf(ramp) : [1, 1, 1]));
  let color =
    ground.along ? rampAt(ground.along, along).map((v, k) => v * factors[0][k] * factors[1][k]) : [0.5, 0.5, 0.5];
  for (const coat of coats)
    if (coat.color && coat.along) {
      const share = [coat.around, coat.turn].reduce(
        (product, ramp) => product * (ramp && !ramp.constant ? meanOf(ramp) : 1), rampAt(coat.along, along));
      color = colorKind.mix(color, rampAt(coat.color, along), share);
    }
  return color;
}

// ---- Edits: each returns the new text of the template. ----

/** Paints the ground with a colour; `covers`: runs of [place, share]. */
export function groundPainted(toml, side, covers, color) {
  const ramp = covers.reduce(
    (r, cover) =>
      ({...r, constant: false, stops: paintedOver(r, cover, (value, share) => colorKind.mix(value, color, share))}),
    side.ground.along);
  return edited(toml, [rampEdit(toml, side.ground.along, ramp.stops)]);
}

/** Paints or wipes off a coat's reach. A coat without a reach covered everything; it starts anew under the brush. */
export function reachPainted(toml, coat, key, covers, {erase = false} = {}) {
  const known = coat[key], circular = key === 'turn';
  const begun = known.node || erase ? known : {...known, stops: [{at: 0, value: 0}], constant: true};
  const full = circular ? overTheSeam(begun) : begun;
  const over = (value, share) => (erase ? value * (1 - share) : 1 - (1 - value) * (1 - share));
  const ramp =
    covers.reduce((r, cover) => ({...r, constant: false, stops: paintedOver(r, cover, over, circular)}), full);
  const stops = circular ? withoutSeam(shareKind, ramp.stops) : ramp.stops;
  return known.node ? rampEdit(toml, known, stops) : withEntry(toml, coat.node, key, rampText(shareKind, stops));
}

/** Paints a coat along its curve in a colour; the existing colour shows through by the brush's opacity. */
export function coatPainted(toml, coat, covers, color) {
  const edits = [reachPainted(toml, coat, 'along', covers)];
  const old = coat.along.node ? coat.along : {...coat.along, stops: [{at: 0, value: 0}]};
  const hex = hexOf(color), differs = coat.color.stops.some(({value}) => hexOf(value) !== hex);
  if (differs) {
    const over = (value, share, at) => {
      const under = rampAt(old, at) * (1 - share), thick = Math.max(share, 1e-3);
      return colorKind.mix(value, color, thick / (under + thick));
    };
    const ramp = covers.reduce((r, cover) => ({...r, constant: false, stops: paintedOver(r, cover, over)}), coat.color);
    edits.push(rampEdit(toml, coat.color, ramp.stops));
  }
  return edited(toml, edits);
}

/** Adds a coat over all others, in the notation of the existing ones. `fields` are texts of TOML. */
export function withCoat(toml, side, fields) {
  const words = Object.entries(fields).map(([key, text]) => `${key} = ${text}`), inline = `{ ${words.join(', ')} }`;
  const list = entryOf(side.node, 'coats');
  const last = list?.items[list.items.length - 1];
  if (list?.form === 'list') {
    const at = lineAfter(toml, last.end);
    return edited(toml, [{
                    from: at,
                    to: at,
                    text: `${toml[at - 1] === '\n' ? '' : '\n'}\n[[${last.path.join('.')}]]\n${words.join('\n')}\n`
                  }]);
  }
  if (!list) return edited(toml, [withEntry(toml, side.node, 'coats', `[\n  ${inline},\n]`)]);
  if (!last) return edited(toml, [{from: list.from, to: list.to, text: `[\n  ${inline},\n]`}]);
  const comma = /^\s*,/.exec(toml.slice(last.to, list.to)), at = last.to + (comma ? comma[0].length : 0);
  return edited(toml, [{from: at, to: at, text: `${comma ? '' : ','}\n  ${inline}${comma ? ',' : ''}`}]);
}
export function withoutCoat(toml, side, index) {
  const list = entryOf(side.node, 'coats'), {node} = side.coats[index];
  if (list.form === 'list') return edited(toml, [{from: node.from, to: lineAfter(toml, node.end), text: ''}]);
  if (side.coats.length === 1) return edited(toml, [withoutEntry(toml, side.node, 'coats')]);
  return edited(toml, [withoutOne(toml, node.from, node.to)]);
}
