// The drawing: curves and pictures of both views, read from the two texts, and the new texts after a change. Places are
// on the page of the SVG; those of curves in the template itself have its units.
import {Bezier} from './bezier.js';
import {A, attributeOf, edited, elementsOf, encoded, offsetOf} from './svg_text.js';
import {surfacesIn} from './toml_curves.js';
import {tomlTree} from './toml_tree.js';

export const plainName = (name) => (name || '').toLowerCase().replace(/[ _]/g, '-');
const viewNames = {
  'side-view': 'side',
  'top-view': 'top'
};

/** The purpose of a curve, by its name: only curves of surfaces are closed, named and checked. */
function kindOf(name) {
  const plain = plainName(name);
  if (plain === 'axis') return 'axis';
  if (/^scale([-_ :=]|\d|$)/.test(plain)) return 'scale';
  if (/^fold-?\d+$/.test(plain)) return 'fold';
  return /-colou?rs$/.test(plain) ? 'colours' : 'curve';
}

export class Drawing {
  constructor(texts) {
    const tree = tomlTree(texts.toml);
    this.texts = texts;
    this.tree = tree;
    this.curves = [];
    this.images = [];
    this.surfaces = surfacesIn(texts.toml, tree);
    if (texts.svg) this.readSvg();
    else this.readToml();
  }

  readSvg() {
    const matrixOf = (element) =>
      A.product(element.parent ? matrixOf(element.parent) : A.one, A.read(attributeOf(element, 'transform')));
    const nameOf = (element) => attributeOf(element, 'inkscape:label') || attributeOf(element, 'id') || '';
    this.elements = elementsOf(this.texts.svg);
    this.layers = {};
    for (const element of this.elements) {
      const view = viewNames[plainName(attributeOf(element, 'inkscape:label'))] ||
        viewNames[plainName(attributeOf(element, 'id'))];
      if (element.tag === 'g' && view) this.layers[view] = this.layers[view] || element;
    }
    const root = this.elements.find(({tag}) => tag === 'svg');
    this.box = (root && attributeOf(root, 'viewBox') || '0 0 297 210').split(/[\s,]+/).map(Number);
    for (const [view, layer] of Object.entries(this.layers)) {
      const visit = (element, group) => {
        const matrix = matrixOf(element), name = nameOf(element);
        const number = (key) => parseFloat(attributeOf(element, key)) || 0;
        if (element.tag === 'image') {
          this.images.push({
            view,
            matrix,
            x: number('x'),
            y: number('y'),
            width: number('width'),
            height: number('height'),
            href: attributeOf(element, 'xlink:href') || attributeOf(element, 'href') || '',
            aspect: attributeOf(element, 'preserveAspectRatio') || ''
          });
        } else if (element.tag === 'path' && element.attributes.d) {
          const {from, to, value} = element.attributes.d;
          this.curves.push({
            id: `${view}:${group || name}:${this.curves.length}`,
            view,
            name: group || name,
            own: name,
            kind: kindOf(group || name),
            file: 'svg',
            element,
            from,
            to,
            matrix,
            parts:
              Bezier.mapped(Bezier.read(value).parts, (p) => A.point(matrix, p)).filter(({nodes}) => nodes.length > 0)
          });
        } else if (element.tag === 'circle' || element.tag === 'ellipse') {
          this.curves.push({
            id: `${view}:${name}:${this.curves.length}`,
            view,
            name,
            kind: kindOf(name),
            file: 'svg',
            element,
            matrix,
            dot: A.point(matrix, [number('cx'), number('cy')]),
            parts: []
          });
        } else if (element.tag === 'g') {
          for (const child of element.children)
            visit(child, group || (attributeOf(element, 'inkscape:label') || attributeOf(element, 'id')));
        }
      };
      for (const child of layer.children) visit(child, '');
    }
  }

  readToml() {
    this.box = null;
    for (const {name, vertical, horizontal} of this.surfaces) {
      for (const [view, tokens] of [['side', vertical ? [vertical] : []], ['top', horizontal]]) {
        for (const {text, from, to} of tokens)
          if (/^\s*m/i.test(text)) {
            this.curves.push({
              id: `${view}:${name}:${this.curves.length}`,
              view,
              name,
              own: name,
              kind: 'curve',
              file: 'toml',
              from,
              to,
              matrix: A.one,
              parts: Bezier.read(text).parts
            });
          }
      }
    }
    this.curves = this.curves.filter(({parts}) => parts.length > 0 && parts[0].nodes.length > 0);
  }

  /** The axis of a view on the page: [bottom, top] in the side view, twice the point in the top view. */
  axis(view) {
    const drawn = this.curves.find((curve) => curve.view === view && curve.kind === 'axis');
    if (!drawn) return this.texts.svg ? null : [[0, 0], [0, -1]];
    if (drawn.dot) return [drawn.dot, drawn.dot];
    const {nodes} = drawn.parts[0], ends = [nodes[0].p, nodes[nodes.length - 1].p];
    return ends[0][1] >= ends[1][1] ? ends : ends.reverse();
  }
  folds() {
    return this.curves.filter(({view, kind, parts}) => view === 'top' && kind === 'fold' && parts.length)
      .map(({parts: [{nodes}]}) => [nodes[0].p, nodes[nodes.length - 1].p]);
  }

  /** The surface of a curve, if any, by the name in the template. */
  surfaceOf(curve) {
    if (curve.file === 'toml') return this.surfaces.find(({from, to}) => from <= curve.from && curve.to <= to);
    const word = `#${plainName(curve.name)}`;
    return this.surfaces.find(
      ({vertical, horizontal}) =>
        (curve.view === 'side' ? [vertical] : horizontal).some((t) => t && plainName(t.text) === word));
  }

  /** The texts with new nodes of a curve. */
  withParts(curve, parts) {
    const back = A.inverse(curve.matrix), path = Bezier.write(Bezier.mapped(parts, (p) => A.point(back, p)));
    return {
      ...this.texts,
      [curve.file]: edited(this.texts[curve.file], [{from: curve.from, to: curve.to, text: path}])
    };
  }
  withDot(curve, place) {
    const p = A.point(A.inverse(curve.matrix), place), {cx, cy} = curve.element.attributes;
    const text = (v) => String(Number(v.toFixed(3)));
    if (!cx || !cy) return this.texts;
    return {
      ...this.texts,
      svg: edited(
        this.texts.svg, [{from: cx.from, to: cx.to, text: text(p[0])}, {from: cy.from, to: cy.to, text: text(p[1])}])
    };
  }
  /** "scale 42mm" is the size of the fruit, "stone" a curve of this surface. */
  renamed(curve, name) {
    const label = curve.element?.attributes['inkscape:label'] || curve.element?.attributes.id;
    return label ? {...this.texts, svg: edited(this.texts.svg, [{from: label.from, to: label.to, text: encoded(name)}])}
                 : this.texts;
  }
  without(curve) {
    if (curve.file !== 'svg') return this.texts;
    let {from, to} = curve.element;
    while (from > 0 && /[ \t]/.test(this.texts.svg[from - 1])) --from;
    if (this.texts.svg[to] === '\n') ++to;
    return {...this.texts, svg: edited(this.texts.svg, [{from, to, text: ''}])};
  }
  /** Adds a curve at the end of its layer, or of the group with this name in it. */
  withCurve(view, name, parts, color = '#c02050') {
    const layer = this.layers?.[view];
    if (!layer) return null;
    const group = layer.children.find(
      (child) => child.tag === 'g' &&
        plainName(attributeOf(child, 'inkscape:label') || attributeOf(child, 'id')) === plainName(name));
    const home = group || layer;
    const matrix = (element) =>
      A.product(element.parent ? matrix(element.parent) : A.one, A.read(attributeOf(element, 'transform')));
    const back = A.inverse(matrix(home)), path = Bezier.write(Bezier.mapped(parts, (p) => A.point(back, p)));
    const end = this.texts.svg.lastIndexOf('</', home.to - 1);
    const label = group ? `${name} ${group.children.length + 1}` : name;
    const element = `  <path\n       inkscape:label="${encoded(label)}"\n       style="fill:none;stroke:${
      color};stroke-width:0.6"\n       d="${path}" />\n  `;
    return {...this.texts, svg: edited(this.texts.svg, [{from: end, to: end, text: element}])};
  }
  /** The curve at the place of a message in the SVG. */
  curveAt(line, column) {
    const offset = offsetOf(this.texts.svg, line, column);
    return this.curves.find(({element}) => element && element.from <= offset && offset <= element.opened);
  }
}
