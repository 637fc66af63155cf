// The node tool: drags nodes, handles and whole curves, adds and removes nodes, snaps ends to the axis and loops to
// fold lines.
import {Bezier, near} from './bezier.js';

export class NodeTool {
  constructor(studio) {
    this.studio = studio;
    /** @type {any} what hands hold: {kind, at, ...} */
    this.grab = null;
  }

  attach(pane) {
    const {overlay} = pane;
    overlay.addEventListener('pointerdown', (event) => this.down(event, pane));
    overlay.addEventListener('pointermove', (event) => this.move(event, pane));
    for (const end of ['pointerup', 'pointercancel']) overlay.addEventListener(end, (event) => this.up(event, pane));
    overlay.addEventListener('contextmenu', (event) => event.preventDefault());
    overlay.addEventListener('pointerleave', () => this.studio.brush.leave());
  }

  down(event, pane) {
    const {studio} = this, {dataset} = event.target, at = pane.placeOn(event);
    pane.overlay.setPointerCapture(event.pointerId);
    studio.active = pane;
    if (event.button === 1 || event.button === 2 || event.altKey && !dataset.id) {
      this.grab = {kind: 'pan', at};
      return;
    }
    if (studio.tool !== 'nodes') {
      this.grab = {kind: 'tool', at, moved: false};
      studio.toolDown(pane, pane.onPage(at), event);
      return;
    }
    if (dataset.blur) {
      this.grab =
        {kind: 'blur', curve: studio.drawing.curves.find(({id}) => id === dataset.blur), middle: Number(dataset.x), at};
    } else if (dataset.handle || dataset.node !== undefined) {
      const part = Number(dataset.part), node = Number(dataset.node);
      if (!dataset.handle) studio.chooseNode(part, node, event.shiftKey);
      this.grab = {
        kind: dataset.handle ? 'handle' : 'node',
        which: dataset.handle,
        part,
        node,
        at,
        parts: this.copy(studio.selected.curve.parts)
      };
    } else if (dataset.id) {
      const curve = studio.drawing.curves.find(({id}) => id === dataset.id);
      studio.select(curve);
      this.grab = {kind: curve.dot ? 'dot' : 'curve', at, parts: this.copy(curve.parts), dot: curve.dot};
    } else {
      studio.select(null);
      this.grab = {kind: 'pan', at};
    }
    pane.root.focus();
  }
  copy(parts) {
    return parts.map(
      ({nodes, closed}) =>
        ({closed, nodes: nodes.map(({p, before, after}) => ({p: [...p], before: [...before], after: [...after]}))}));
  }

  move(event, pane) {
    const {studio, grab} = this;
    if (studio.tool === 'pen' || studio.tool === 'brush' && grab?.kind !== 'pan')
      studio.toolMove(pane, pane.onPage(pane.placeOn(event)), event);
    if (!grab) return;
    const at = pane.placeOn(event), by = [(at[0] - grab.at[0]) / pane.scale, (at[1] - grab.at[1]) / pane.scale];
    if (grab.kind === 'pan') {
      pane.pan(at[0] - grab.at[0], at[1] - grab.at[1]);
      grab.at = at;
      return;
    }
    if (grab.kind === 'tool') return;
    if (!grab.moved && Math.hypot(at[0] - grab.at[0], at[1] - grab.at[1]) < 2.5) return;
    grab.moved = true;
    if (grab.kind === 'blur') {
      studio.dragBlur(grab.curve, Math.max(0, Math.abs(at[0] - grab.middle) / pane.scale * studio.unitOf(pane.view)));
      return;
    }
    if (grab.kind === 'dot') {
      studio.dragDot([grab.dot[0] + by[0], grab.dot[1] + by[1]]);
      return;
    }
    const parts = this.copy(grab.parts);
    if (grab.kind === 'curve') this.shift(parts.flatMap(({nodes}) => nodes), by);
    if (grab.kind === 'node') this.dragNodes(pane, parts, grab, by, event);
    if (grab.kind === 'handle') this.dragHandle(parts[grab.part].nodes[grab.node], grab.which, by, event);
    studio.drag(parts);
  }
  shift(nodes, /** @type {number[]} */[dx, dy]) {
    for (const node of nodes)
      for (const key of ['p', 'before', 'after']) node[key] = [node[key][0] + dx, node[key][1] + dy];
  }

  /** Moves all selected nodes; the dragged one snaps, and the others keep their distance to it. */
  dragNodes(pane, parts, {part, node}, by, event) {
    const {studio} = this, held = parts[part].nodes[node], free = [held.p[0] + by[0], held.p[1] + by[1]];
    const snapped = event.ctrlKey ? free : this.snapped(pane, free, parts[part], node);
    const way = [snapped[0] - held.p[0], snapped[1] - held.p[1]];
    parts.forEach(({nodes}, k) => this.shift(nodes.filter((_, i) => studio.isChosen(k, i)), way));
  }
  /** Without Shift, the other handle of a smooth node stays opposite. */
  dragHandle(node, which, /** @type {number[]} */[dx, dy], event) {
    const other = which === 'before' ? 'after' : 'before';
    const length = Math.hypot(node[other][0] - node.p[0], node[other][1] - node.p[1]);
    const back = [node[which][0] - node.p[0], node[which][1] - node.p[1]];
    const ahead = [node[other][0] - node.p[0], node[other][1] - node.p[1]];
    const cross = Math.abs(back[0] * ahead[1] - back[1] * ahead[0]);
    const opposite = cross < 0.02 * Math.hypot(...back) * length && back[0] * ahead[0] + back[1] * ahead[1] < 0;
    node[which] = [node[which][0] + dx, node[which][1] + dy];
    if (!opposite || event.shiftKey || length < 1e-9) return;
    const way = [node.p[0] - node[which][0], node.p[1] - node[which][1]], long = Math.hypot(...way) || 1;
    node[other] = [node.p[0] + way[0] / long * length, node.p[1] + way[1] / long * length];
  }

  /**
   * Snaps ends of open curves of the side view to the axis, and nodes of the top view to fold lines, within eight
   * pixels.
   */
  snapped(pane, place, part, node) {
    const {drawing} = this.studio, lines = [], isEnd = !part.closed && (node === 0 || node === part.nodes.length - 1);
    if (pane.view === 'side' && isEnd && drawing.axis('side')) lines.push({line: drawing.axis('side'), endless: true});
    if (pane.view === 'top')
      for (const line of drawing.folds()) lines.push({line, endless: false});
    let best = place, least = 8 / pane.scale;
    for (const {line: [a, b], endless} of lines) {
      const way = [b[0] - a[0], b[1] - a[1]], square = way[0] ** 2 + way[1] ** 2 || 1;
      let t = ((place[0] - a[0]) * way[0] + (place[1] - a[1]) * way[1]) / square;
      if (!endless) t = Math.max(0, Math.min(1, t));
      const p = [a[0] + t * way[0], a[1] + t * way[1]], distance = Math.hypot(p[0] - place[0], p[1] - place[1]);
      if (distance < least) {
        best = p;
        least = distance;
      }
    }
    return best;
  }

  up(event, pane) {
    const {studio, grab} = this, at = pane.placeOn(event), {last} = this;
    this.grab = null;
    if (!grab) return;
    // The clicked element has been redrawn since, so browsers report no double click.
    this.last = grab.moved ? null : {pane, at, time: event.timeStamp};
    const twice = last?.pane === pane && (studio.tool === 'nodes' || studio.tool === 'pen');
    if (
      twice && !grab.moved && event.timeStamp - last.time < 400 &&
      Math.hypot(at[0] - last.at[0], at[1] - last.at[1]) < 6) {
      this.last = null;
      this.insert(pane, at, grab.kind);
      return;
    }
    if (grab.kind === 'tool') studio.toolUp(pane, pane.onPage(pane.placeOn(event)), event);
    else if (grab.moved) studio.drop();
    else if (grab.kind !== 'pan') pane.draw();
  }

  /** Two clicks on a line add a node. */
  insert(pane, at, kind) {
    const {studio} = this, curve = studio.selected?.curve;
    if (studio.tool === 'pen') {
      studio.finishPen();
      return;
    }
    if (
      studio.tool !== 'nodes' || !curve || curve.dot || curve.view !== pane.view || kind === 'node' ||
      kind === 'handle')
      return;
    const found = Bezier.nearest(curve.parts, pane.onPage(at));
    if (found.distance * pane.scale > 10) return;
    const parts = this.copy(curve.parts);
    Bezier.split(parts[found.part], found.segment, Math.max(0.02, Math.min(0.98, found.t)));
    studio.commit(studio.drawing.withParts(curve, parts), 'a node more');
    studio.chooseNode(found.part, found.segment + 1);
  }
  remove() {
    const {studio} = this, curve = studio.selected?.curve;
    if (!curve || curve.dot) return;
    const parts =
      this.copy(curve.parts).map((part, k) => ({...part, nodes: part.nodes.filter((_, i) => !studio.isChosen(k, i))}));
    const gone = parts.some((part, k) => part.nodes.length < curve.parts[k].nodes.length);
    if (!gone) {
      studio.commit(studio.drawing.without(curve), `${curve.name} deleted`);
      studio.select(null);
      return;
    }
    const left = parts.filter(({nodes, closed}) => nodes.length > (closed ? 2 : 1));
    if (left.length === 0) {
      studio.say('A curve needs two nodes, a loop three.');
      return;
    }
    studio.commit(studio.drawing.withParts(curve, left), 'nodes deleted');
    studio.chosen.clear();
  }
  /** Makes selected nodes smooth, or corners if they are smooth. */
  toggleSmooth() {
    const {studio} = this, curve = studio.selected?.curve;
    if (!curve || curve.dot) return;
    const parts = this.copy(curve.parts), chosen = (k, i) => studio.chosen.size === 0 || studio.isChosen(k, i);
    const corners = parts.some(
      ({nodes}, k) =>
        nodes.some((node, i) => chosen(k, i) && (near(node.before, node.p, 1e-6) || near(node.after, node.p, 1e-6))));
    parts.forEach((part, k) => {
      if (corners) Bezier.smooth(part, (_, i) => chosen(k, i));
      else
        part.nodes.forEach((node, i) => {
          if (chosen(k, i)) {
            node.before = [...node.p];
            node.after = [...node.p];
          }
        });
    });
    studio.commit(studio.drawing.withParts(curve, parts), corners ? 'smooth' : 'corners');
  }
  nudge(dx, dy) {
    const {studio} = this, curve = studio.selected?.curve;
    if (!curve || curve.dot) return;
    const pane = studio.panes[curve.view], parts = this.copy(curve.parts);
    this.shift(
      parts.flatMap(({nodes}, k) => nodes.filter((_, i) => studio.chosen.size === 0 || studio.isChosen(k, i))),
      [dx / pane.scale, dy / pane.scale]);
    studio.commit(studio.drawing.withParts(curve, parts), 'moved');
  }
}
