// The studio: the edited texts, the selection, and the requests to the program with their replies.
import {$, $$} from '../../../render/page/messages.js';

import {Brush, showBrush} from './brush.js';
import {Drawing} from './drawing.js';
import {History} from './history.js';
import {NodeTool} from './node_tool.js';
import {showPaint} from './paint.js';
import {Pane} from './pane.js';
import {Pictures} from './pictures.js';
import {Latest, Refusal} from './server.js';
import {edited, offsetOf} from './svg_text.js';
import {titleIn} from './toml_curves.js';
import {withEntry} from './toml_tree.js';
import {finishPen, tools} from './tools.js';
import {showVariants} from './variants.js';

export class Studio {
  constructor(server) {
    this.server = server;
    this.selected = null;
    this.chosen = new Set();
    this.dragged = null;
    this.wrong = new Set();
    this.tool = 'nodes';
    this.pen = null;
    this.unsent = false;
    this.drawing = null;
    this.shown = {photo: 0.65, section: 0.8, photoOver: false, blur: true, height: 0.5};
    this.look = {seed: 0, folds: 0, ripeness: null, browning: 0};
    this.loads = {};
    this.toMetres = {};
    /** @type {import('./fruit_view.js').FruitView | null} null where WebGL 2 is missing */
    this.view = null;
    /** @type {any} for tests */
    this.modules = null;
    /** The colour that the pipette sets: {surface, side, path, stop}, or null. */
    this.chosenStop = null;
    this.pictures = new Pictures(server, {changed: () => this.redraw(), failed: (text) => this.bar(text)});
    this.panes = {};
    for (const view of ['side', 'top']) this.panes[view] = new Pane($(`pane-${view}`), view, this);
    this.nodes = new NodeTool(this);
    this.brush = new Brush(this);
    for (const pane of Object.values(this.panes)) this.nodes.attach(pane);
    this.sections = new Latest((wanted) => this.fetchSection(wanted));
    this.assets = new Latest((wanted) => this.fetchAsset(wanted));
    this.sending = new Latest(() => this.send());
  }

  async open() {
    const document_ = await this.server.json('/api/document');
    this.files = document_;
    this.version = document_.version;
    this.history = new History({toml: document_.toml, svg: document_.svg});
    this.takeTexts();
    this.showState(document_);
    if (document_.recovered)
      this.bar(
        'What was drawn here before has been taken up again. It is not saved yet.',
        [['Save', () => this.save()], ['Drop it', () => this.revert()]]);
    this.refresh();
  }
  get texts() { return this.history.now; }

  // ---- Editing. ----

  takeTexts() {
    this.drawing = new Drawing(this.texts);
    const id = this.selected?.curve?.id;
    this.selected = id ? {curve: this.drawing.curves.find((curve) => curve.id === id)} : null;
    if (!this.selected?.curve) {
      this.selected = null;
      this.chosen.clear();
    }
    this.dragged = null;
    $('title').textContent = titleIn(this.texts.toml) || this.files.name;
    if (document.activeElement !== $('toml')) $('toml').value = this.texts.toml;
    $('undo').disabled = this.history.past.length === 0;
    $('redo').disabled = this.history.next.length === 0;
    showPaint(this);
    this.redraw();
  }
  redraw() {
    for (const pane of Object.values(this.panes)) pane.draw();
  }
  say(text) { $('kept').textContent = text; }

  /** One edit: it can be undone, is stored on disk, and is displayed. */
  commit(texts, words = '') {
    if (!texts || !this.history.push(texts)) {
      this.dragged = null;
      this.redraw();
      return;
    }
    if (words) this.say(words);
    this.changed();
  }
  changed() {
    this.takeTexts();
    this.unsent = true;
    this.sending.ask();
    this.refresh();
  }
  /** A stroke refers to places in the current text, so it ends before another text comes. */
  undo() {
    this.brush.cancel();
    if (this.history.undo()) this.changed();
  }
  redo() {
    this.brush.cancel();
    if (this.history.redo()) this.changed();
  }

  select(curve) {
    if (this.selected?.curve?.id !== curve?.id) this.chosen.clear();
    this.selected = curve ? {curve} : null;
    if (curve) this.say(`${curve.name}, ${curve.view === 'side' ? 'side view' : 'top view'}`);
    this.showName();
    this.redraw();
  }
  showName() {
    const curve = this.selected?.curve;
    $('name').value = curve ? curve.own || curve.name : '';
    $('name').disabled = curve?.file !== 'svg';
  }
  rename(name) {
    const curve = this.selected?.curve;
    const texts = curve && name.trim() ? this.drawing.renamed(curve, name.trim()) : null;
    if (!texts) return;
    this.commit(texts, `it is called ${name.trim()} now`);
    const {view, from} = curve;
    this.select(
      this.drawing.curves.find((other) => other.view === view && Math.abs((other.from ?? -99) - (from ?? -99)) <= 60) ||
      null);
  }
  isChosen(part, node) { return this.chosen.has(`${part}.${node}`); }
  chooseNode(part, node, more = false) {
    const key = `${part}.${node}`;
    if (!more && !this.chosen.has(key)) this.chosen.clear();
    if (more && this.chosen.has(key)) this.chosen.delete(key);
    else this.chosen.add(key);
    this.redraw();
  }

  // ---- Dragging: displayed at once, stored at the end. ----

  drag(parts) {
    this.dragged = parts;
    this.panes[this.selected.curve.view].drawCurves();
    this.dragging = this.drawing.withParts(this.selected.curve, parts);
    this.preview();
  }
  dragDot(place) {
    this.dragging = this.drawing.withDot(this.selected.curve, place);
    this.preview();
  }
  dragBlur(curve, metres) {
    const surface = this.drawing.surfaceOf(curve), text = `${Number((1000 * metres).toFixed(2))}mm`;
    const {toml} = this.texts;
    const edit = surface.blur ? {from: surface.blur.from, to: surface.blur.to, text}
                              : withEntry(toml, surface.node, 'blur', `"${text}"`);
    this.dragging = {...this.texts, toml: edited(toml, [edit])};
    this.say(`blur ${text}`);
    this.preview();
  }
  preview() { this.sections.ask({texts: this.dragging, draft: true, began: performance.now()}); }
  drop() {
    const texts = this.dragging;
    this.dragging = null;
    if (texts) this.commit(texts);
  }

  // ---- Replies of the program. ----

  /** Embedded pictures are large, and the engine does not need them. */
  bare({toml, svg}) { return {toml, svg: svg.replace(/(xlink:href|href)="data:[^"]*"/g, '$1="data:,"')}; }
  wanted(texts, extra) { return {...this.bare(texts), ...this.look, ...extra}; }

  async fetchSection({texts, draft, began}) {
    try {
      // Under the curves is the fruit as drawn, not a variant.
      const wanted = {
        ...this.wanted(texts, {seed: 0, folds: 0, height: this.shown.height}),
        ...(draft ? {detail: 0.5, size: 192} : {size: 480, final: true})
      };
      const head = await this.server.section(wanted);
      this.toMetres = head.drawing;
      // A fruit with only meshes has no drawing; its section is shown in millimetres.
      const bare = this.drawing.curves.length === 0 ? [1e-3, 0, 0, -1e-3, 0, 0] : null;
      for (const picture of head.pictures)
        this.panes[picture.view].takeSection(picture, head.drawing[picture.view] || bare);
      this.loads.section = performance.now() - began;
      this.showErrors([]);
    } catch (error) { this.showErrors(this.errorsOf(error)); }
  }
  async fetchAsset({texts}) {
    try {
      const began = performance.now();
      this.view?.show(await this.server.bytes('/api/asset', this.wanted(texts, {})));
      this.loads.asset = performance.now() - began;
    } catch (error) { this.errorsOf(error); }
  }
  refresh() {
    const texts = this.texts, began = performance.now();
    this.sections.ask({texts, draft: true, began});
    this.loads.variants = 0;
    clearTimeout(this.later);
    this.later = setTimeout(() => {
      if (this.dragging) return;
      this.assets.ask({texts});
      this.sections.ask({texts, draft: false, began: performance.now()});
      showVariants(this);
    }, 180);
  }
  /** Metres of one unit of the page. */
  unitOf(view) {
    const m = this.toMetres[view];
    return m ? Math.hypot(m[0], m[1]) : 0;
  }

  errorsOf(error) {
    if (!(error instanceof Refusal)) {
      console.error(error);
      return [{message: String(error.message || error)}];
    }
    if (error.status === 0) this.bar(`${error.errors[0].message} ${error.errors[0].hint}`, []);
    return error.errors;
  }
  showErrors(errors) {
    this.wrong = new Set(errors.map((e) => this.curveOf(e)?.id).filter(Boolean));
    $('errors').replaceChildren(...errors.slice(0, 12).map((e) => {
      const item = document.createElement('li'), button = document.createElement('button');
      const hint = document.createElement('small');
      button.type = 'button';
      button.textContent = `${e.line ? `${e.file}:${e.line}:${e.column}: ` : ''}${e.message}`;
      hint.textContent = e.hint || '';
      button.append(hint);
      button.addEventListener('click', () => this.goTo(e));
      item.append(button);
      return item;
    }));
    this.redraw();
  }
  /** The curve of an error: by its place in the drawing, else by its surface in the template, else by its name. */
  curveOf({svg_line: line, svg_column: column, line: tomlLine, message}) {
    const {drawing} = this, drawn = line && drawing.curveAt(line, column);
    if (drawn) return drawn;
    const at = tomlLine ? offsetOf(this.texts.toml, tomlLine, 1) : -1;
    const named = /(?:surface|curve) "([^"]+)"/.exec(message)?.[1];
    const surface =
      drawing.surfaces.find(({from, to}) => from <= at && at < to) || drawing.surfaces.find(({name}) => name === named);
    return surface && drawing.curves.find((curve) => drawing.surfaceOf(curve) === surface);
  }
  goTo(error) {
    const curve = this.curveOf(error);
    if (curve) this.select(curve);
    if (!error.line) return;
    $('text').open = true;
    const at = offsetOf(this.texts.toml, error.line, error.column || 1);
    $('toml').focus();
    $('toml').setSelectionRange(at, at);
  }

  // ---- Saving. ----

  async send() {
    const texts = this.texts;
    try {
      this.version = (await this.server.json('/api/change', {seen: this.version, ...texts})).version;
      this.unsent = this.texts !== texts;
      if (this.unsent) this.sending.ask();
      else this.showState({unsaved: true});
    } catch (error) {
      if (error.status === 409) this.conflict();
      else
        this.bar(
          `This edit is not kept: ${this.errorsOf(error)[0]?.message || error.message}`,
          [['Try again', () => this.sending.ask()]]);
    }
  }
  conflict() {
    this.bar('The fruit was changed in another window.', [
      ['Take theirs', () => this.takeTheirs()],
      [
        'Keep mine',
        async () => {
          this.version = (await this.server.json('/api/state')).version;
          this.bar('');
          this.sending.ask();
        }
      ]
    ]);
  }
  async takeTheirs() {
    const theirs = await this.server.json('/api/document');
    this.version = theirs.version;
    this.unsent = false;
    this.bar('');
    // Undo returns to the previous texts.
    if (this.history.push({toml: theirs.toml, svg: theirs.svg})) {
      this.takeTexts();
      this.refresh();
    }
    this.showState(theirs);
  }
  async save(over = false) {
    if (this.unsent) await this.sending.ask();
    try {
      await this.server.json('/api/save', {seen: this.version, over});
      this.bar('');
      this.showState({unsaved: false});
      this.say('saved');
    } catch (error) {
      if (error.status !== 409) this.bar(`It is not saved: ${this.errorsOf(error)[0]?.message || error.message}`, []);
      else if (/another program/.test(error.message))
        this.bar(
          'Another program has changed the files.',
          [['Save over them', () => this.save(true)], ['Go back to them', () => this.revert()]]);
      else this.conflict();
    }
  }
  async revert() {
    try {
      await this.server.json('/api/revert', {seen: this.version});
    } catch (error) { this.errorsOf(error); }
    await this.takeTheirs();
  }
  /** Checks whether another window or program has changed something. */
  async poll() {
    if (this.unsent) return;
    try {
      const state = await this.server.json('/api/state');
      if (state.version !== this.version && !this.unsent && !this.sending.busy && !this.dragging)
        await this.takeTheirs();
      else if (state.changed_outside)
        this.bar(
          'Another program has changed the files.',
          [['Save over them', () => this.save(true)], ['Go back to them', () => this.revert()]]);
      this.showState(state);
    } catch (error) { this.errorsOf(error); }
  }
  showState({unsaved}) {
    $('kept').textContent = unsaved ? 'kept, not saved' : this.files.toml_file;
    $('save').disabled = !unsaved;
  }
  bar(text, choices = []) {
    const bar = $('bar');
    bar.hidden = !text;
    if (bar.dataset.text === text) return;
    bar.dataset.text = text;
    bar.replaceChildren(text, ...choices.map(([word, act]) => {
      const button = document.createElement('button');
      Object.assign(button, {type: 'button', textContent: word});
      button.addEventListener('click', () => {
        this.bar('');
        act();
      });
      return button;
    }));
  }

  // ---- Other tools. ----

  setTool(tool) {
    this.tool = tool;
    this.pen = null;
    document.body.dataset.tool = tool;
    for (const button of $$('[data-tool]')) button.setAttribute('aria-pressed', String(button.dataset.tool === tool));
    showBrush(this);
    this.redraw();
  }
  toolDown(pane, place, event) { tools[this.tool]?.down?.(this, pane, place, event); }
  toolMove(pane, place, event) { tools[this.tool]?.move?.(this, pane, place, event); }
  toolUp(pane, place, event) { tools[this.tool]?.up?.(this, pane, place, event); }
  finishPen() { finishPen(this); }
}
