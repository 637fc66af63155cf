// A template's TOML as a tree of values with their positions in the text, so that an edit replaces only a value. The
// program's own reader checks the text; this one only finds values, and continues at the next line after something that
// it does not understand.

/**
 * A value: {kind: 'string' | 'plain' | 'array' | 'table', from, to}. Strings have their `text` and where it stands,
 * `inside`; arrays have `items`; tables have `entries`, a Map. Tables know how they are written: `form` is 'inline',
 * 'heading', 'list' (one of
 * [[...]]), 'implied' (by [theirs.below]) or 'dotted'. Headings and lists have their `path`, and `end`, where their
 * last own entry ends; dotted ones have the `host` that has their lines, and the `path` within it.
 */
class TomlReader {
  constructor(text) {
    this.text = text;
    this.at = 0;
  }

  document() {
    const {text} = this, root = this.table('heading', {path: [], from: 0, to: 0, end: 0});
    let current = root;
    for (;;) {
      this.skip();
      if (this.at >= text.length) return root;
      const began = this.at;
      try {
        if (text[began] === '[') current = this.heading(root);
        else this.entry(current);
      } catch (error) {
        if (!(error instanceof SyntaxError)) throw error;
        const next = text.indexOf(
          '\n',
          Math.max(began, Math.min(this.at, text.indexOf('\n', began) < 0 ? text.length : text.indexOf('\n', began))));
        this.at = next < 0 ? text.length : next + 1;
      }
    }
  }

  // ---- Lines. ----

  heading(root) {
    const from = this.at, isList = this.text.startsWith('[[', from);
    this.at += isList ? 2 : 1;
    const path = this.keys(']');
    this.at += isList ? 2 : 1;
    const written = {path, from, to: this.at, end: this.at}, last = path[path.length - 1];
    const parent = path.slice(0, -1).reduce((table, key) => this.inside(table, key, from), root);
    const known = parent.entries.get(last)?.value;
    if (!isList) {
      if (known?.kind === 'table')
        return Object.assign(known, known.form === 'dotted' ? {} : {form: 'heading'}, written);
      return this.put(parent, last, this.table('heading', written), written);
    }
    const list = known?.kind === 'array' && known.form === 'list'
      ? known
      : this.put(parent, last, {kind: 'array', form: 'list', items: [], from, to: from}, written);
    list.items.push(this.table('list', written));
    return list.items[list.items.length - 1];
  }
  /** The table with this name within another; of a list, its last one. */
  inside(table, key, from) {
    const known = table.entries.get(key)?.value;
    if (known?.kind === 'table') return known;
    if (known?.kind === 'array' && known.items.length) return known.items[known.items.length - 1];
    return this.put(
      table, key, this.table('implied', {path: [...table.path || [], key], from, to: from, end: from}), {});
  }
  table(form, more) { return {kind: 'table', form, entries: new Map(), ...more}; }
  put(table, key, value, {from = value.from}) {
    table.entries.set(key, {from, value});
    return value;
  }

  /** Reads key = value, on a line or within braces; dotted keys make tables. */
  entry(table) {
    const from = this.at, path = this.keys('=');
    ++this.at;
    let home = table;
    path.slice(0, -1).forEach((key, k) => {
      const known = home.entries.get(key)?.value;
      home = known?.kind === 'table'
        ? known
        : this.put(home, key, this.table('dotted', {host: table, path: path.slice(0, k + 1), from, to: from}), {});
    });
    const value = this.value();
    home.entries.set(path[path.length - 1], {from, value});
    for (const holder of new Set([home, table])) Object.assign(holder, holder.form === 'inline' ? {} : {end: value.to});
  }

  // ---- Words. ----

  fail() { throw new SyntaxError(`at ${this.at}`); }
  blank() {
    while (/[ \t]/.test(this.text[this.at] || '')) ++this.at;
  }
  /** Skips blanks, line breaks and comments. */
  skip() {
    for (;;) {
      while (/\s/.test(this.text[this.at] || '')) ++this.at;
      if (this.text[this.at] !== '#') return;
      const end = this.text.indexOf('\n', this.at);
      this.at = end < 0 ? this.text.length : end;
    }
  }
  keys(end) {
    const path = [];
    for (;;) {
      this.blank();
      const found = /^(?:([\w-]+)|"([^"\n]*)"|'([^'\n]*)')/.exec(this.text.slice(this.at, this.at + 200));
      if (!found) this.fail();
      path.push(found[1] ?? found[2] ?? found[3]);
      this.at += found[0].length;
      this.blank();
      if (this.text[this.at] === end) return path;
      if (this.text[this.at] !== '.') this.fail();
      ++this.at;
    }
  }
  value() {
    this.blank();
    const {text} = this, from = this.at, first = text[from];
    if (first === '"' || first === '\'') return this.string(first);
    if (first === '[') {
      const items = this.listed(']', () => this.value());
      return {kind: 'array', form: 'inline', items, from, to: this.at};
    }
    if (first === '{') {
      const table = this.table('inline', {from, to: from});
      this.listed('}', () => this.entry(table));
      return Object.assign(table, {to: this.at});
    }
    const found = /^[^\s,\]}#]+/.exec(text.slice(from, from + 100));
    if (!found) this.fail();
    this.at += found[0].length;
    return {kind: 'plain', text: found[0], from, to: this.at};
  }
  listed(end, one) {
    const items = [];
    ++this.at;
    for (;;) {
      this.skip();
      if (this.text[this.at] === end) {
        ++this.at;
        return items;
      }
      items.push(one());
      this.skip();
      if (this.text[this.at] === ',') ++this.at;
      else if (this.text[this.at] !== end) this.fail();
    }
  }
  string(quote) {
    const {text} = this, from = this.at, long = quote.repeat(3), marks = text.startsWith(long, from) ? long : quote;
    for (let at = from + marks.length; at < text.length; ++at) {
      if (quote === '"' && text[at] === '\\') {
        ++at;
        continue;
      }
      if (marks.length === 1 && text[at] === '\n') break;
      if (!text.startsWith(marks, at)) continue;
      this.at = at + marks.length;
      const inside = {from: from + marks.length, to: at};
      return {kind: 'string', text: text.slice(inside.from, inside.to), inside, from, to: this.at};
    }
    return this.fail();
  }
}
export const tomlTree = (text) => new TomlReader(text).document();
export const entryOf = (table, ...path) =>
  path.reduce((value, key) => (value?.kind === 'table' ? value.entries.get(key)?.value : undefined), table);

// ---- Edits, for edited(): {from, to, text}. ----

/** The offset after the line of a place. */
export function lineAfter(toml, at) {
  const end = toml.indexOf('\n', at);
  return end < 0 ? toml.length : end + 1;
}

/** Sets a key of a table to a TOML value: in place if it exists, else after the table's other keys. */
export function withEntry(toml, table, key, text) {
  const known = table.entries.get(key)?.value;
  if (known) return {from: known.from, to: known.to, text};
  const name = table.form === 'dotted' ? [...table.path, key].join('.') : key;
  if (table.form === 'inline' || table.host?.form === 'inline') {
    const last = [...table.entries.values()].reduce((end, {value}) => Math.max(end, value.to), 0);
    const at = last || table.from + 1;
    return {from: at, to: at, text: last ? `, ${name} = ${text}` : ` ${name} = ${text} `};
  }
  if (table.form === 'implied')
    return {from: table.from, to: table.from, text: `[${table.path.join('.')}]\n${name} = ${text}\n\n`};
  const at = lineAfter(toml, table.end);
  return {from: at, to: at, text: `${toml[at - 1] === '\n' ? '' : '\n'}${name} = ${text}\n`};
}

/** Removes a key: its line, or its place between the commas. */
export function withoutEntry(toml, table, key) {
  const {from, value} = table.entries.get(key);
  if (table.form !== 'inline' && table.host?.form !== 'inline') return {from, to: lineAfter(toml, value.to), text: ''};
  return withoutOne(toml, from, value.to);
}
/** Removes an item between commas, and one comma. */
export function withoutOne(toml, from, to) {
  let next = to;
  while (/\s/.test(toml[next])) ++next;
  if (toml[next] === ',') {
    ++next;
    while (/[ \t]/.test(toml[next])) ++next;
    const line = toml.lastIndexOf('\n', from - 1) + 1;
    const alone = toml[next] === '\n' && toml.slice(line, from).trim() === '';
    return alone ? {from: line, to: next + 1, text: ''} : {from, to: next, text: ''};
  }
  let before = from - 1;
  while (/\s/.test(toml[before])) --before;
  return {from: toml[before] === ',' ? before : from, to, text: ''};
}
