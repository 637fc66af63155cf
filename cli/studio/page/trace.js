// Traces outlines in a picture: the area with a colour like the clicked one, its rim, and a curve of few nodes along
// it.
import {Bezier, nodeAt} from './bezier.js';
import {A} from './svg_text.js';

/**
 * The outline on the page around the area of this colour; for an open curve of the side view, its half right of the
 * axis.
 */
export function traced(studio, view, place, closed) {
  for (const picture of studio.drawing.images.filter((image) => image.view === view).reverse()) {
    const loaded = studio.pictures.get(picture.href);
    if (!loaded) continue;
    const {width, height} = loaded.image, toPage = studio.pictures.placement(picture, loaded);
    const [x, y] = A.point(A.inverse(toPage), place).map(Math.floor);
    if (x < 0 || y < 0 || x >= width || y >= height) continue;
    const rim = rimOf(filled(loaded.pixels.getImageData(0, 0, width, height), x, y), width, height);
    if (rim.length < 24) return null;
    const outline = simplified(rim.map((p) => A.point(toPage, p)), 0.006);
    const part = closed || view === 'top' ? {nodes: outline.map(nodeAt), closed: true}
                                          : rightHalf(outline, studio.drawing.axis('side'));
    if (!part || part.nodes.length < 3) return null;
    Bezier.smooth(part, (_, i) => turnAt(part, i) < 0.9);
    return part;
  }
  return null;
}

/** The turning angle at a node, radians: sharp ones stay corners, because a smooth curve would swing out there. */
function turnAt({nodes, closed}, i) {
  const a = nodes[closed ? (i + nodes.length - 1) % nodes.length : i - 1];
  const b = nodes[closed ? (i + 1) % nodes.length : i + 1], {p} = nodes[i];
  if (!a || !b) return 0;
  const before = [p[0] - a.p[0], p[1] - a.p[1]], after = [b.p[0] - p[0], b.p[1] - p[1]];
  return Math.abs(Math.atan2(before[0] * after[1] - before[1] * after[0], before[0] * after[0] + before[1] * after[1]));
}

/**
 * 1 where the picture is similar to the clicked place and connected to it. Similar is a Euclidean distance in sRGB of
 * up to a fifth of its range.
 */
function filled({data, width, height}, x, y, reach = 52) {
  const mask = new Uint8Array(width * height), stack = [y * width + x], at = 4 * (y * width + x);
  const seed = [data[at], data[at + 1], data[at + 2], data[at + 3]];
  const like = (i) =>
    (data[4 * i] - seed[0]) ** 2 + (data[4 * i + 1] - seed[1]) ** 2 + (data[4 * i + 2] - seed[2]) ** 2 <
      reach * reach &&
    (data[4 * i + 3] > 127) === (seed[3] > 127);
  mask[stack[0]] = 1;
  while (stack.length) {
    const i = stack.pop(), column = i % width;
    for (const j of [column > 0 ? i - 1 : -1, column < width - 1 ? i + 1 : -1, i - width, i + width]) {
      if (j < 0 || j >= mask.length || mask[j] || !like(j)) continue;
      mask[j] = 1;
      stack.push(j);
    }
  }
  return mask;
}

/** The outer rim of the filled area, once around, by Moore's neighbours, from the leftmost filled pixel of the row. */
function rimOf(mask, width, height) {
  // The rim starts at the outermost pixel, so holes are ignored.
  const start = mask.indexOf(1);
  const inside = (px, py) => px >= 0 && py >= 0 && px < width && py < height && mask[py * width + px] === 1;
  const ways = [[1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1], [0, -1], [1, -1]], rim = [];
  let [px, py] = [start % width, Math.floor(start / width)], way = 0;
  const [sx, sy] = [px, py];
  for (let steps = 0; steps < 4 * mask.length; ++steps) {
    rim.push([px + 0.5, py + 0.5]);
    let k = 0;
    for (; k < 8; ++k) {
      const [dx, dy] = ways[(way + 6 + k) % 8];
      if (inside(px + dx, py + dy)) {
        way = (way + 6 + k) % 8;
        px += dx;
        py += dy;
        break;
      }
    }
    if (k === 8 || px === sx && py === sy && rim.length > 2) break;
  }
  return rim;
}

/** Douglas and Peucker's algorithm on a loop: no place is farther off than a share of the outline's size. */
function simplified(points, share) {
  const low = [0, 1].map((k) => Math.min(...points.map((p) => p[k])));
  const high = [0, 1].map((k) => Math.max(...points.map((p) => p[k])));
  const most = share * Math.hypot(high[0] - low[0], high[1] - low[1]), kept = new Set([0]), stack = [];
  let far = 0;
  points.forEach((p, i) => {
    if (
      Math.hypot(p[0] - points[0][0], p[1] - points[0][1]) >
      Math.hypot(points[far][0] - points[0][0], points[far][1] - points[0][1]))
      far = i;
  });
  kept.add(far);
  stack.push([0, far], [far, points.length]);
  while (stack.length) {
    const [a, b] = stack.pop(), p = points[a], q = points[b % points.length], way = [q[0] - p[0], q[1] - p[1]];
    const length = Math.hypot(...way) || 1;
    let worst = 0, at = -1;
    for (let i = a + 1; i < b; ++i) {
      const d = Math.abs((points[i][0] - p[0]) * way[1] - (points[i][1] - p[1]) * way[0]) / length;
      if (d > worst) {
        worst = d;
        at = i;
      }
    }
    if (worst <= most) continue;
    kept.add(at);
    stack.push([a, at], [at, b]);
  }
  return [...kept].sort((a, b) => a - b).map((i) => points[i]);
}

/** The curve from the bottom of the axis to its top; both ends are put onto the axis. */
function rightHalf(outline, axis) {
  if (!axis) return null;
  const [bottom, top] = axis, way = [top[0] - bottom[0], top[1] - bottom[1]], length = Math.hypot(...way) || 1;
  const up = way.map((v) => v / length);
  const along = (p) => (p[0] - bottom[0]) * up[0] + (p[1] - bottom[1]) * up[1];
  const beside = (p) => -(p[0] - bottom[0]) * up[1] + (p[1] - bottom[1]) * up[0];
  const onAxis = (s) => [bottom[0] + s * up[0], bottom[1] + s * up[1]], crossings = [];
  outline.forEach((p, i) => {
    const q = outline[(i + 1) % outline.length], [a, b] = [beside(p), beside(q)];
    if (a < 0 !== b < 0) crossings.push({i, s: along(p) + (along(q) - along(p)) * a / (a - b)});
  });
  if (crossings.length < 2) return null;
  const low = crossings.reduce((a, b) => (b.s < a.s ? b : a)), high = crossings.reduce((a, b) => (b.s > a.s ? b : a));
  const sides = [];
  for (const step of [1, -1]) {
    const points = [];
    for (let n = 0, i = step > 0 ? low.i + 1 : low.i; n < outline.length; ++n, i += step) {
      const k = ((i % outline.length) + outline.length) % outline.length;
      points.push(outline[k]);
      if (k === (step > 0 ? high.i : (high.i + 1) % outline.length)) break;
    }
    sides.push(points);
  }
  // Take the side that is mostly on the right of the page.
  const right = (points) => points.reduce((sum, p) => sum + p[0] - onAxis(along(p))[0], 0);
  const chosen = right(sides[0]) > right(sides[1]) ? sides[0] : sides[1];
  return {
    closed: false,
    nodes: [onAxis(low.s), ...chosen.filter((p) => p[0] > onAxis(along(p))[0]), onAxis(high.s)].map(nodeAt)
  };
}
