// Curves as nodes with handles, like in Inkscape: {p, before, after}; a handle on its node means no handle.

export const near = (a, b, d = 1e-9) => Math.hypot(a[0] - b[0], a[1] - b[1]) <= d;
export const between = (a, b, t) => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
export const nodeAt = (p) => ({p: [...p], before: [...p], after: [...p]});

export const Bezier = {
  /** {parts: [{nodes, closed}]}: all commands of SVG's path data become cubic curves. */
  read(d) {
    const words = d.match(/[a-z]|[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi) || [], parts = [];
    let i = 0, command = '', at = [0, 0], start = [0, 0], part = null, lastCubic = null, lastQuad = null;
    const number = () => Number(words[i++]);
    const place = (relative) => {
      const x = number(), y = number();
      return relative ? [at[0] + x, at[1] + y] : [x, y];
    };
    const cubic = (b, c, p) => {
      if (!part) parts.push(part = {nodes: [nodeAt(at)], closed: false});
      part.nodes[part.nodes.length - 1].after = b;
      part.nodes.push({p, before: c, after: [...p]});
      at = p;
    };
    while (i < words.length) {
      if (/[a-z]/i.test(words[i])) command = words[i++];
      else if (!command) break;
      const kind = command.toUpperCase(), relative = command !== kind;
      const [wasCubic, wasQuad] = [lastCubic, lastQuad];
      lastCubic = lastQuad = null;
      if (kind === 'Z') {
        if (part) {
          const last = part.nodes[part.nodes.length - 1];
          if (part.nodes.length > 1 && near(last.p, part.nodes[0].p, 1e-6)) {
            part.nodes[0].before = last.before;
            part.nodes.pop();
          }
          part.closed = true;
        }
        part = null;
        at = start;
        command = '';
      } else if (kind === 'M') {
        at = start = place(relative);
        parts.push(part = {nodes: [nodeAt(at)], closed: false});
        command = relative ? 'l' : 'L';
      } else if (kind === 'L') {
        const p = place(relative);
        cubic([...at], [...p], p);
      } else if (kind === 'H') {
        const x = number(), p = [relative ? at[0] + x : x, at[1]];
        cubic([...at], [...p], p);
      } else if (kind === 'V') {
        const y = number(), p = [at[0], relative ? at[1] + y : y];
        cubic([...at], [...p], p);
      } else if (kind === 'C' || kind === 'S') {
        const b = kind === 'C' ? place(relative) : wasCubic ? between(wasCubic, at, 2) : [...at], c = place(relative);
        const p = place(relative);
        cubic(b, c, p);
        lastCubic = c;
      } else if (kind === 'Q' || kind === 'T') {
        const q = kind === 'Q' ? place(relative) : wasQuad ? between(wasQuad, at, 2) : [...at], p = place(relative);
        cubic(between(at, q, 2 / 3), between(p, q, 2 / 3), p);
        lastQuad = q;
      } else if (kind === 'A') {
        const [rx, ry, turn, large, sweep] = [number(), number(), number(), number(), number()], p = place(relative);
        for (const [b, c, q] of Bezier.arc(at, rx, ry, turn * Math.PI / 180, large, sweep, p)) cubic(b, c, q);
      } else break;
      if (![...at].every(Number.isFinite)) break;
    }
    return {parts};
  },
  /** An arc of an ellipse as cubic curves of at most a quarter turn (SVG 1.1, appendix F.6.5). */
  arc(from, rx, ry, turn, large, sweep, to) {
    rx = Math.abs(rx);
    ry = Math.abs(ry);
    if (!rx || !ry || near(from, to)) return [[[...from], [...to], to]];
    const c = Math.cos(turn), s = Math.sin(turn), dx = (from[0] - to[0]) / 2, dy = (from[1] - to[1]) / 2;
    const x = c * dx + s * dy, y = c * dy - s * dx, over = Math.sqrt(Math.max(1, x * x / rx / rx + y * y / ry / ry));
    rx *= over;
    ry *= over;
    const rest =
      Math.max(0, (rx * rx * ry * ry - rx * rx * y * y - ry * ry * x * x) / (rx * rx * y * y + ry * ry * x * x));
    const k = Math.sqrt(rest) * (Boolean(large) === Boolean(sweep) ? -1 : 1), cx = k * rx * y / ry;
    const cy = -k * ry * x / rx;
    const middle = [c * cx - s * cy + (from[0] + to[0]) / 2, s * cx + c * cy + (from[1] + to[1]) / 2];
    const a = Math.atan2((y - cy) / ry, (x - cx) / rx);
    let way = Math.atan2((-y - cy) / ry, (-x - cx) / rx) - a;
    if (sweep && way < 0) way += 2 * Math.PI;
    if (!sweep && way > 0) way -= 2 * Math.PI;
    const count = Math.max(1, Math.ceil(Math.abs(way) / (Math.PI / 2) - 1e-9)), step = way / count;
    const h = 4 / 3 * Math.tan(step / 4);
    const on = (angle, t) => {
      const u = rx * (Math.cos(angle) - t * Math.sin(angle)), v = ry * (Math.sin(angle) + t * Math.cos(angle));
      return [middle[0] + c * u - s * v, middle[1] + s * u + c * v];
    };
    return Array.from(
      {length: count},
      (_, i) => [on(a + i * step, h), on(a + (i + 1) * step, -h), i + 1 === count ? to : on(a + (i + 1) * step, 0)]);
  },
  write(parts, digits = 3) {
    const text = (p) => p.map((v) => String(Number(v.toFixed(digits)))).join(',');
    return parts
      .map(({nodes, closed}) => {
        const segment = (a, b) => near(a.after, a.p, 1e-6) && near(b.before, b.p, 1e-6)
          ? `L ${text(b.p)}`
          : `C ${text(a.after)} ${text(b.before)} ${text(b.p)}`;
        const all = nodes.slice(1).map((node, i) => segment(nodes[i], node));
        if (closed && nodes.length > 1) all.push(`${segment(nodes[nodes.length - 1], nodes[0])} Z`);
        return [`M ${text(nodes[0].p)}`, ...all].join(' ');
      })
      .join(' ');
  },
  mapped: (parts, map) => parts.map(
    ({nodes, closed}) =>
      ({closed, nodes: nodes.map(({p, before, after}) => ({p: map(p), before: map(before), after: map(after)}))})),
  segments: ({nodes, closed}) =>
    nodes.slice(0, closed ? nodes.length : -1).map((a, i) => [a, nodes[(i + 1) % nodes.length]]),
  at([a, b], t) {
    const p = between(a.p, a.after, t), q = between(a.after, b.before, t), r = between(b.before, b.p, t);
    return between(between(p, q, t), between(q, r, t), t);
  },
  /** The nearest point of the curve: {part, segment, t, p, distance}. */
  nearest(parts, place) {
    let best = {distance: Infinity};
    parts.forEach((part, k) => Bezier.segments(part).forEach((pair, i) => {
      for (let n = 0; n <= 32; ++n) {
        const p = Bezier.at(pair, n / 32), distance = Math.hypot(p[0] - place[0], p[1] - place[1]);
        if (distance < best.distance) best = {part: k, segment: i, t: n / 32, p, distance};
      }
    }));
    return best;
  },
  /** The same curve with one more node (de Casteljau). */
  split(part, i, t) {
    const {nodes} = part, a = nodes[i], b = nodes[(i + 1) % nodes.length];
    const p = between(a.p, a.after, t), q = between(a.after, b.before, t), r = between(b.before, b.p, t);
    const s = between(p, q, t), u = between(q, r, t);
    a.after = p;
    b.before = r;
    nodes.splice(i + 1, 0, {p: between(s, u, t), before: s, after: u});
  },
  /** Handles that make a curve smooth at its nodes; ends of open curves have none. */
  smooth(part, which = (_node, _i) => true) {
    const {nodes, closed} = part, n = nodes.length;
    nodes.forEach((node, i) => {
      if (!which(node, i)) return;
      const a = nodes[closed ? (i + n - 1) % n : i - 1], b = nodes[closed ? (i + 1) % n : i + 1];
      if (!a || !b) {
        node.before = [...node.p];
        node.after = [...node.p];
        return;
      }
      const way = [b.p[0] - a.p[0], b.p[1] - a.p[1]], length = Math.hypot(...way) || 1;
      const back = Math.hypot(node.p[0] - a.p[0], node.p[1] - a.p[1]) / 3;
      const on = Math.hypot(b.p[0] - node.p[0], b.p[1] - node.p[1]) / 3;
      node.before = [node.p[0] - way[0] / length * back, node.p[1] - way[1] / length * back];
      node.after = [node.p[0] + way[0] / length * on, node.p[1] + way[1] / length * on];
    });
  },
};
