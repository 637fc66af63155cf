// The spared parts of a scene's piece: whole stones, and their sockets.
import {boxOf} from './body.js';

/** Tests whether points lie in a closed mesh, by counting how often a ray along z leaves it. */
class Inside {
  constructor(skin, index) {
    const {low, high} = boxOf(skin), across = 64, size = [0, 1].map((axis) => (high[axis] - low[axis]) / across || 1);
    const column =
      (p) => [0, 1].map((axis) => Math.max(0, Math.min(across - 1, Math.floor((p[axis] - low[axis]) / size[axis]))));
    this.column = column;
    this.across = across;
    this.columns = Array.from({length: across * across}, () => []);
    for (let t = 0; t < index.length; t += 3) {
      const corners = [0, 1, 2].map((k) => [...skin.subarray(10 * index[t + k], 10 * index[t + k] + 3)]);
      const at = corners.map(column);
      const [x, y] = [0, 1].map((axis) => at.map((c) => c[axis]));
      for (let j = Math.min(...y); j <= Math.max(...y); ++j)
        for (let i = Math.min(...x); i <= Math.max(...x); ++i) this.columns[j * across + i].push(corners);
    }
  }
  has(p) {
    const [x, y] = this.column(p), area = (a, b) => (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
    let winding = 0;
    for (const [a, b, c] of this.columns[y * this.across + x]) {
      const [u, v, w] = [area(b, c), area(c, a), area(a, b)], sum = u + v + w;
      if (sum === 0 || u / sum < 0 || v / sum < 0 || w / sum < 0) continue;
      if ((u * a[2] + v * b[2] + w * c[2]) / sum > p[2]) winding += Math.sign(sum);
    }
    return winding !== 0;
  }
}

/** The part of a triangle (ten numbers per corner) for which `keeps` is true; bisection finds the border. */
function keptOf(corners, keeps) {
  const kept = corners.map(keeps), count = kept.filter(Boolean).length;
  if (count === 0 || count === 3) return count ? [corners] : [];
  const border = (a, b) => {
    let [low, high] = [0, 1];
    const at = (t) => a.map((v, i) => v + t * (b[i] - v));
    for (let i = 0; i < 8; ++i) {
      const t = (low + high) / 2;
      if (keeps(at(t))) low = t;
      else high = t;
    }
    return at(low);
  };
  const first = kept.indexOf(count === 1), [a, b, c] = [0, 1, 2].map((k) => corners[(first + k) % 3]);
  if (count === 1) return [[a, border(a, b), border(a, c)]];
  const [p, q] = [border(b, a), border(c, a)];
  return [[p, b, c], [p, c, q]];
}

/**
 * Like FruitTextures' `spared`, for the parts in this piece; sockets only if the stones do not already stick out of it.
 */
export function sparedOfPiece(body, card) {
  const {spared} = body.fruit, near = 0.04;
  if (!spared) return null;
  const inside = new Inside(body.skin, body.index), socket = [];
  const isHeld = (corner) => inside.has([0, 1, 2].map((k) => corner[k] - near * corner[3 + k]));
  const shells =
    spared.shells
      .filter(({samples}) => {
        const some = samples.slice(0, 200);
        return some.filter((p) => inside.has(p)).length > 0.6 * some.length;
      })
      .map((shell) => {
        const [first, count] = shell.socket, begin = socket.length / 10;
        for (let i = first; i < first + count; i += 3) {
          const corners = [0, 1, 2].map((k) => [...spared.data.socket.subarray(10 * (i + k), 10 * (i + k) + 10)]);
          for (const triangle of keptOf(corners, isHeld))
            for (const corner of triangle)
              for (const v of corner) socket.push(v);
        }
        return {...shell, socket: [begin, socket.length / 10 - begin]};
      });
  return shells.length ? {...spared, shells, socket: card.skin(Float32Array.from(socket))} : null;
}
