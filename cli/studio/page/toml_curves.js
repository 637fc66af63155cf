// A template's TOML as far as the studio edits it in place: its surfaces with their curves, blurs and colours, each with where it
// stands in the text. The program's own reader judges it; this only finds what can be taken hold of.
'use strict';

/** Strings and headings in their order: {kind: 'heading', text, from} or {kind: 'string', key, text, from, to}. */
function tomlTokens(toml) {
  const tokens = [], pattern = /#[^\n]*|^[ \t]*(\[\[?[^\]\n]+\]\]?)|"""([\s\S]*?)"""|'''([\s\S]*?)'''|"((?:\\.|[^"\\\n])*)"|'([^'\n]*)'|([\w.-]+)[ \t]*=/gm;
  let key = '';
  for (const found of toml.matchAll(pattern)) {
    const [all, heading, long, raw, text, literal, name] = found, at = found.index, words = [long, raw, text, literal].find((w) => w !== undefined);
    if (heading && /^\[\[?[\w."-]+(\.[\w"-]+)*\]\]?$/.test(heading.trim())) tokens.push({kind: 'heading', text: heading.replace(/[[\]\s]/g, ''), from: at, isList: heading.startsWith('[[')});
    else if (name) key = name;
    else if (words !== undefined) { const quotes = (long ?? raw) === undefined ? 1 : 3; tokens.push({kind: 'string', key, text: words, from: at + quotes, to: at + all.length - quotes}); }
  }
  return tokens;
}

/**
 * The surfaces: {name, type, from, to, vertical: {text, from, to}, horizontal: [...], blur, colors: [{side, text, from, to, place}]}.
 * A colour's side is "front" or "back"; `place` is the number before it in a ramp, if there is one: {value, from, to}.
 */
function surfacesIn(toml) {
  const surfaces = [];
  let surface = null, side = '';
  for (const token of tomlTokens(toml)) {
    if (token.kind === 'heading') {
      const [table, , ...rest] = token.text.split('.');
      if (token.text === 'surface' && token.isList) {
        if (surface) surface.to = token.from;
        surfaces.push(surface = {name: '', type: 'around-axis', vertical: null, horizontal: [], blur: null, colors: [], from: token.from, to: toml.length});
        side = '';
      } else if (table === 'surface') {
        side = token.text.split('.')[1];
      } else if (surface) {
        surface.to = token.from;
        surface = null;
      }
      continue;
    }
    if (!surface) continue;
    const {key, text, from, to} = token;
    if (key === 'name') surface.name = text;
    else if (key === 'type') surface.type = text;
    else if (key === 'vertical') surface.vertical = token;
    else if (key === 'horizontal') surface.horizontal.push(token);
    else if (key === 'blur') surface.blur = token;
    else if (/^#[0-9a-f]{6}$/i.test(text)) {
      const line = toml.slice(Math.max(surface.from, from - 400), from), inlineSide = /(?:^|[\n,{])\s*(front|back)\s*=\s*\{[^\n]*$/.exec(line);
      const stop = /\[\s*([0-9.]+)\s*,\s*"$/.exec(line);
      surface.colors.push({side: inlineSide ? inlineSide[1] : side || 'front', key, text, from, to,
        place: stop && {value: Number(stop[1]), from: from - stop[0].length + stop[0].indexOf(stop[1]), to: from - stop[0].length + stop[0].indexOf(stop[1]) + stop[1].length}});
    }
  }
  return surfaces;
}
const partsIn = (toml) => { const found = /^\s*parts\s*=\s*\[([^\]]*)\]/m.exec(toml); return found ? [...found[1].matchAll(/"([^"]*)"/g)].map((m) => m[1]) : []; };
const foldsIn = (toml) => Number(/^\s*folds\s*=\s*(\d+)/m.exec(toml)?.[1] || 0);
const titleIn = (toml) => /^\s*title\s*=\s*"([^"\n]*)"/m.exec(toml)?.[1] || '';
if (typeof module !== 'undefined') module.exports = {tomlTokens, surfacesIn, partsIn, foldsIn, titleIn};
