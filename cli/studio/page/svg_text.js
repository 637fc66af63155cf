// An SVG file as text with the positions of elements and attributes. Edits replace text, so that everything else stays
// the same, letter by letter.

const entities = {
  amp: '&',
  lt: '<',
  gt: '>',
  quot: '"',
  apos: '\''
};
const decoded = (text) => text.replace(/&(#x[0-9a-f]+|#\d+|\w+);/gi, (all, name) => {
  if (name[0] !== '#') return entities[name] ?? all;
  const code = name[1] === 'x' || name[1] === 'X' ? parseInt(name.slice(2), 16) : Number(name.slice(1));
  return code > 0 && code < 0x110000 ? String.fromCodePoint(code) : all;
});
export const encoded = (text) =>
  text.replace(/[&<>"\u0000-\u001f]/g, (c) => ({'&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;'})[c] ?? ' ');

/** {tag, from, opened, to, parent, children, attributes: {name: {value, from, to}}}; from..opened is the start tag. */
export function elementsOf(text) {
  const elements = [], open = [];
  let at = 0;
  const skip = (end) => {
    const found = text.indexOf(end, at);
    at = found < 0 ? text.length : found + end.length;
  };
  for (;;) {
    at = text.indexOf('<', at);
    if (at < 0 || elements.length > 200000) return elements;
    if (text.startsWith('<!--', at)) {
      skip('-->');
      continue;
    }
    if (text.startsWith('<![CDATA[', at)) {
      skip(']]>');
      continue;
    }
    if (text[at + 1] === '?' || text[at + 1] === '!') {
      skip('>');
      continue;
    }
    if (text[at + 1] === '/') {
      skip('>');
      const closed = open.pop();
      if (closed) closed.to = at;
      continue;
    }
    const from = at, name = /^[\w:.-]+/.exec(text.slice(at + 1, at + 80)), attributes = {};
    if (!name) {
      ++at;
      continue;
    }
    at += 1 + name[0].length;
    for (;;) {
      while (at < text.length && /\s/.test(text[at])) ++at;
      if (at >= text.length || text[at] === '>' || text[at] === '/') break;
      const start = at;
      while (at < text.length && !/[\s=/>]/.test(text[at])) ++at;
      const key = text.slice(start, at);
      while (at < text.length && /[\s=]/.test(text[at])) ++at;
      const quote = text[at];
      if (quote !== '"' && quote !== '\'') {
        if (at === start) ++at;
        continue;
      }
      const end = text.indexOf(quote, at + 1);
      if (end < 0) {
        at = text.length;
        break;
      }
      attributes[key] = {from: at + 1, to: end, get value() { return decoded(text.slice(this.from, this.to)); }};
      at = end + 1;
    }
    const single = text[at] === '/';
    skip('>');
    const element = {
      tag: name[0].replace(/^svg:/, ''),
      from,
      opened: at,
      to: at,
      parent: open[open.length - 1] || null,
      children: [],
      attributes
    };
    elements.push(element);
    if (element.parent) element.parent.children.push(element);
    if (!single) open.push(element);
  }
}
export const attributeOf = (element, name) => element.attributes[name]?.value;

/** Applies replacements {from, to, text} that do not overlap. */
export function edited(text, edits) {
  let result = '', at = 0;
  for (const {from, to, text: by} of [...edits].sort((a, b) => a.from - b.from)) {
    result += text.slice(at, from) + by;
    at = to;
  }
  return result + text.slice(at);
}
/**
 * The offset of a line and a column, both from 1. Columns are bytes of UTF-8 in messages and letters here, which is
 * close enough.
 */
export function offsetOf(text, line, column) {
  let at = 0;
  for (let i = 1; i < line; ++i) {
    const next = text.indexOf('\n', at);
    if (next < 0) return at;
    at = next + 1;
  }
  return at + column - 1;
}

/**
 * SVG's transform attribute, [a, b, c, d, e, f].
 * @type {{one: number[], product: (m: number[], n: number[]) => number[], point: (m: number[], p: number[]) =>
 *   number[], inverse: (m: number[]) => number[], read: (text: string) => number[]}}
 */
export const A = {
  one: [1, 0, 0, 1, 0, 0],
  product: (m, n) =>
    [m[0] * n[0] + m[2] * n[1], m[1] * n[0] + m[3] * n[1], m[0] * n[2] + m[2] * n[3], m[1] * n[2] + m[3] * n[3],
     m[0] * n[4] + m[2] * n[5] + m[4], m[1] * n[4] + m[3] * n[5] + m[5]],
  point: (m, [x, y]) => [m[0] * x + m[2] * y + m[4], m[1] * x + m[3] * y + m[5]],
  inverse([a, b, c, d, e, f]) {
    const det = a * d - b * c;
    return det ? [d / det, -b / det, -c / det, a / det, (c * f - d * e) / det, (b * e - a * f) / det] : A.one;
  },
  read(text) {
    let m = A.one;
    for (const [, kind, inside] of (text || '').matchAll(/(\w+)\s*\(([^)]*)\)/g)) {
      const v = inside.split(/[\s,]+/).filter(Boolean).map(Number), r = (v[0] || 0) * Math.PI / 180;
      const turn = [Math.cos(r), Math.sin(r), -Math.sin(r), Math.cos(r), 0, 0];
      m = A.product(m, {
        matrix: v,
        translate: [1, 0, 0, 1, v[0] || 0, v[1] || 0],
        scale: [v[0], 0, 0, v[1] ?? v[0], 0, 0],
        rotate: v.length < 3 ? turn : A.product(A.product([1, 0, 0, 1, v[1], v[2]], turn), [1, 0, 0, 1, -v[1], -v[2]]),
        skewX: [1, 0, Math.tan(r), 1, 0, 0],
        skewY: [1, Math.tan(r), 0, 1, 0, 0]
      }[kind] || A.one);
    }
    return m;
  },
};
