// The surfaces of a template whose curves the studio edits in place, with their positions in the text. The program's
// own reader checks the text; this one only finds what can be edited.
import {entryOf, lineAfter, tomlTree} from './toml_tree.js';

/** The positions of a string's contents. */
const wordsIn = (value) => (value?.kind === 'string' ? {text: value.text, ...value.inside} : null);
/** Where a horizontal curve says its words: one of a list, or at a stop [place, curve]. */
const loopIn = (value) => wordsIn(value?.kind === 'array' ? value.items[1] : value);

/**
 * {name, type, node, from, to, vertical: {text, from, to}, horizontal: [...], blur}: `to` is after the last line of the
 * surface.
 */
export function surfacesIn(toml, tree = tomlTree(toml)) {
  const list = entryOf(tree, 'surface');
  return (list?.form === 'list' ? list.items : []).map((node) => {
    const horizontal = entryOf(node, 'horizontal');
    return {
      name: wordsIn(entryOf(node, 'name'))?.text || '',
      type: wordsIn(entryOf(node, 'type'))?.text || 'around-axis',
      node,
      from: node.from,
      to: lineAfter(toml, endOf(node)),
      vertical: wordsIn(entryOf(node, 'vertical')),
      horizontal: (horizontal?.kind === 'array' ? horizontal.items : [horizontal]).map(loopIn).filter(Boolean),
      blur: blurIn(entryOf(node, 'blur'))
    };
  });
}
/** The end of a table's text, including the tables below it. */
function endOf({end, to, entries}) {
  const below = [...entries.values()].flatMap(
    ({value}) =>
      (value.kind === 'table'    ? [endOf(value)]
         : value.form === 'list' ? value.items.map(endOf)
                                 : [value.to]));
  return Math.max(end || to, ...below);
}
/** The length of a blur; if it changes along its curve, its value in the middle, where its circle is drawn. */
function blurIn(value) {
  if (value?.kind === 'table') return blurIn(entryOf(value, 'along'));
  if (value?.kind !== 'array') return wordsIn(value);
  const away = ({items}) => Math.abs(Number(items?.[0]?.text) - 0.5);
  const stops = value.items.filter((stop) => away(stop) <= 0.5);
  return stops.length ? wordsIn(stops.reduce((a, b) => (away(b) < away(a) ? b : a)).items[1]) : null;
}
export const partsIn = (toml) => {
  const found = /^\s*parts\s*=\s*\[([^\]]*)\]/m.exec(toml);
  return found ? [...found[1].matchAll(/"([^"]*)"/g)].map((m) => m[1]) : [];
};
export const titleIn = (toml) => /^\s*title\s*=\s*"([^"\n]*)"/m.exec(toml)?.[1] || '';
