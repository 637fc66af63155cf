// One view of the drawing: pixels (the photograph, and the section over or under it), and on them the curves that can
// be dragged.
import {Bezier, near} from './bezier.js';
import {svgElement} from './elements.js';
import {drawBrush} from './ribbon.js';
import {A} from './svg_text.js';

export class Pane {
  constructor(root, view, studio) {
    this.root = root;
    this.view = view;
    this.studio = studio;
    this.scale = 1;
    this.offset = [0, 0];
    this.fitted = false;
    this.section = null;
    this.canvas = root.querySelector('canvas');
    this.overlay = root.querySelector('svg');
    this.overlay.append(
      this.guides = svgElement('g', {class: 'guides'}), this.lines = svgElement('g', {class: 'lines'}),
      this.marks = svgElement('g', {class: 'marks'}));
    root.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.zoom(Math.exp(-event.deltaY / 600), this.placeOn(event));
    }, {passive: false});
    new ResizeObserver(() => {
      this.fitted = false;
      this.draw();
    }).observe(root);
  }

  // ---- Coordinates. ----

  /** @param {number[]} p on the page */
  onScreen([x, y]) { return [x * this.scale + this.offset[0], y * this.scale + this.offset[1]]; }
  /** @param {number[]} p of the pane, pixels */
  onPage([x, y]) { return [(x - this.offset[0]) / this.scale, (y - this.offset[1]) / this.scale]; }
  placeOn(event) {
    const box = this.root.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }
  zoom(by, /** @type {number[]} */[x, y]) {
    const p = this.onPage([x, y]);
    this.scale = Math.max(1e-3, Math.min(1e4, this.scale * by));
    this.offset = [x - p[0] * this.scale, y - p[1] * this.scale];
    this.draw();
  }
  pan(dx, dy) {
    this.offset = [this.offset[0] + dx, this.offset[1] + dy];
    this.draw();
  }

  /** All curves and pictures of this view, with a margin. */
  fit() {
    const points =
      this.studio.drawing.curves.filter(({view, kind}) => view === this.view && kind !== 'scale')
        .flatMap(
          ({parts, dot}) => dot
            ? [dot]
            : parts.flatMap(
                (part) => Bezier.segments(part).flatMap((pair) => [0, 0.5, 1].map((t) => Bezier.at(pair, t)))));
    for (const {view, matrix, x, y, width, height} of this.studio.drawing.images) {
      if (view === this.view)
        points.push(
          ...[[x, y], [x + width, y], [x, y + height], [x + width, y + height]].map((p) => A.point(matrix, p)));
    }
    // Meshes have a section but no curves.
    if (points.length === 0 && this.section?.placement)
      points.push(...[[0, 0], [this.section.canvas.width, this.section.canvas.height]].map(
        (p) => A.point(this.section.placement, p)));
    const {clientWidth, clientHeight} = this.root;
    if (points.length === 0 || clientWidth < 20) return;
    const low = [0, 1].map((k) => Math.min(...points.map((p) => p[k])));
    const high = [0, 1].map((k) => Math.max(...points.map((p) => p[k])));
    // The picture also shows the other half of the fruit.
    const axis = this.view === 'side' && this.studio.drawing.axis('side');
    if (axis) low[0] = Math.min(low[0], 2 * axis[0][0] - high[0]);
    this.scale = 0.86 * Math.min(clientWidth / (high[0] - low[0] || 1), clientHeight / (high[1] - low[1] || 1));
    this.offset =
      [clientWidth / 2 - (low[0] + high[0]) / 2 * this.scale, clientHeight / 2 - (low[1] + high[1]) / 2 * this.scale];
    this.fitted = true;
  }

  // ---- Drawing. ----

  draw() {
    if (!this.studio.drawing) return;
    if (!this.fitted) this.fit();
    this.drawPixels();
    this.drawCurves();
  }

  drawPixels() {
    const {canvas, studio} = this, ratio = Math.min(2, window.devicePixelRatio || 1);
    const {clientWidth, clientHeight} = this.root;
    const [width, height] = [Math.round(clientWidth * ratio), Math.round(clientHeight * ratio)];
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
    const context = canvas.getContext('2d', {willReadFrequently: true});
    const page = [ratio * this.scale, 0, 0, ratio * this.scale, ratio * this.offset[0], ratio * this.offset[1]];
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, width, height);
    const photograph = () => {
      context.globalAlpha = studio.shown.photo;
      for (const picture of studio.drawing.images.filter(({view}) => view === this.view)) {
        const loaded = studio.pictures.get(picture.href);
        if (!loaded) continue;
        context.setTransform(...A.product(page, studio.pictures.placement(picture, loaded)));
        context.drawImage(loaded.image, 0, 0);
      }
    };
    const section = () => {
      if (!this.section || !this.section.placement) return;
      context.globalAlpha = studio.shown.section;
      context.setTransform(...A.product(page, this.section.placement));
      context.imageSmoothingQuality = 'high';
      context.drawImage(this.section.canvas, 0, 0);
    };
    for (const layer of studio.shown.photoOver ? [section, photograph] : [photograph, section]) layer();
    context.globalAlpha = 1;
  }

  /** Shows a section from the server at its place in the drawing, in the reader's scale. */
  takeSection(picture, toMetres) {
    if (!toMetres) {
      this.section = null;
      return;
    }
    const canvas = this.section?.canvas || document.createElement('canvas');
    const {width, height, corner, right, down} = picture;
    Object.assign(canvas, {width, height});
    canvas.getContext('2d', {willReadFrequently: true}).putImageData(picture.image, 0, 0);
    // In the plane of the view: x, and upwards y, or -z in the top view.
    const flat = this.view === 'side' ? (p) => [p[0], p[1]] : (p) => [p[0], -p[2]];
    const [c, r, d] = [flat(corner), flat(right), flat(down)];
    const toPlane = [r[0] / width, r[1] / width, d[0] / height, d[1] / height, c[0], c[1]];
    this.section = {canvas, placement: A.product(A.inverse(toMetres), toPlane)};
  }

  /** The section's colour at a place of the page, or null. */
  sectionColor(place) {
    if (!this.section?.placement) return null;
    const {canvas} = this.section, [x, y] = A.point(A.inverse(this.section.placement), place).map(Math.floor);
    if (x < 0 || y < 0 || x >= canvas.width || y >= canvas.height) return null;
    const [r, g, b, a] = canvas.getContext('2d').getImageData(x, y, 1, 1).data;
    return a < 128 ? null : `#${[r, g, b].map((v) => v.toString(16).padStart(2, '0')).join('')}`;
  }

  pathOf(parts) { return Bezier.write(Bezier.mapped(parts, (p) => this.onScreen(p)), 1); }

  drawCurves() {
    const {studio} = this, {selected} = studio;
    this.lines.replaceChildren();
    for (const curve of studio.drawing.curves.filter(({view}) => view === this.view)) {
      const chosen = selected?.curve?.id === curve.id, wrong = studio.wrong.has(curve.id);
      if (curve.dot) {
        const [cx, cy] = this.onScreen(curve.dot);
        this.lines.append(svgElement('circle', {class: `curve ${curve.kind}`, cx, cy, r: 5, 'data-id': curve.id}));
        continue;
      }
      const d = this.pathOf(chosen && studio.dragged ? studio.dragged : curve.parts);
      this.lines.append(
        svgElement('path', {class: 'grip', d, 'data-id': curve.id}),
        svgElement(
          'path',
          {class: `curve ${curve.kind}${chosen ? ' chosen' : ''}${wrong ? ' wrong' : ''}`, d, 'data-id': curve.id}));
    }
    this.drawMarks();
  }

  drawMarks() {
    const {studio} = this, {selected} = studio;
    this.marks.replaceChildren();
    if (studio.tool === 'brush') {
      drawBrush(this);
      return;
    }
    this.drawBlur();
    if (studio.pen?.pane === this) {
      this.drawPen();
      return;
    }
    if (!selected?.curve || selected.curve.view !== this.view || selected.curve.dot) return;
    const parts = studio.dragged || selected.curve.parts;
    parts.forEach(({nodes}, k) => nodes.forEach((node, i) => {
      const chosen = studio.isChosen(k, i), at = this.onScreen(node.p);
      if (chosen)
        for (const which of ['before', 'after']) {
          if (near(node[which], node.p, 1e-6)) continue;
          const [x, y] = this.onScreen(node[which]);
          this.marks.append(
            svgElement('line', {class: 'handle', x1: at[0], y1: at[1], x2: x, y2: y}),
            svgElement(
              'circle', {class: 'handle', cx: x, cy: y, r: 4.5, 'data-part': k, 'data-node': i, 'data-handle': which}));
        }
      const smooth = !near(node.before, node.p, 1e-6) && !near(node.after, node.p, 1e-6);
      this.marks.append(
        smooth
          ? svgElement(
              'circle',
              {class: `node${chosen ? ' chosen' : ''}`, cx: at[0], cy: at[1], r: 5.2, 'data-part': k, 'data-node': i})
          : svgElement('rect', {
              class: `node${chosen ? ' chosen' : ''}`,
              x: at[0] - 4.6,
              y: at[1] - 4.6,
              width: 9.2,
              height: 9.2,
              'data-part': k,
              'data-node': i
            }));
    }));
  }

  /** The blur as a circle on its curve, as wide as the colours of both sides blend (paper, Figure 2). */
  drawBlur() {
    const {studio} = this, unit = studio.unitOf(this.view);
    if (!studio.shown.blur || !unit) return;
    for (const curve of studio.drawing.curves.filter(
           (c) => c.view === this.view && c.kind === 'curve' && c.parts.length)) {
      const surface = studio.drawing.surfaceOf(curve), metres = surface && metresOf(surface.blur?.text);
      const chosen = studio.selected?.curve?.id === curve.id;
      if (!surface || !(metres > 0 || chosen)) continue;
      const parts = chosen && studio.dragged ? studio.dragged : curve.parts, segments = Bezier.segments(parts[0]);
      if (segments.length === 0) continue;
      const [cx, cy] = this.onScreen(Bezier.at(segments[Math.floor(segments.length / 2)], 0.5));
      const r = Math.max(3, (metres || 0) / unit * this.scale);
      this.marks.append(
        svgElement('circle', {class: 'blur', cx, cy, r}),
        svgElement('circle', {class: 'blur grip', cx: cx + r, cy, r: 4, 'data-blur': curve.id, 'data-x': cx}));
    }
  }

  drawPen() {
    const {nodes, closed} = this.studio.pen;
    if (nodes.length === 0) return;
    this.marks.append(svgElement('path', {class: 'curve chosen', d: this.pathOf([{nodes, closed}])}));
    nodes.forEach(({p}) => {
      const [cx, cy] = this.onScreen(p);
      this.marks.append(svgElement('circle', {class: 'node', cx, cy, r: 5}));
    });
  }
}

/** "1.2mm" in metres. */
function metresOf(text) {
  const found = /^\s*([0-9.]+)\s*(mm|cm|m)\s*$/.exec(text || '');
  return found ? Number(found[1]) * {mm: 1e-3, cm: 1e-2, m: 1}[found[2]] : 0;
}
