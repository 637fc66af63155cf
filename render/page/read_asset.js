// From an asset's bytes to arrays: the JavaScript counterpart of asset_file.h, as in docs/reference/asset.md. It has no
// dependencies, so that other programs can use it.

/** @import {AssetHeader, Fruit} from './types.d.ts' */

const magic = [0x70, 0x6f, 0x6d, 0x6f, 0x6e, 0x61, 0];
export const depthSteps = 32;

/** The linear light of each byte of sRGB. */
export const linear = Float64Array.from({length: 256}, (_, i) => {
  const c = i / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
});

/**
 * Decompresses the bytes after the magic number and the kind of file (1 for an asset); `onChunk` may read early what
 * has arrived.
 * @param {Uint8Array} packed
 * @param {((bytes: Uint8Array, length: number) => void) | null} [onChunk]
 */
export async function unpacked(packed, onChunk, kind = 1) {
  if ([...magic, kind].some((byte, i) => packed[i] !== byte)) throw new Error('this is no asset of Pomona\'s');
  const stream = new Blob([/** @type {Uint8Array<ArrayBuffer>} */ (packed.subarray(magic.length + 1))])
                   .stream()
                   .pipeThrough(new DecompressionStream('deflate'));
  const reader = stream.getReader();
  let bytes = new Uint8Array(1 << 22), length = 0;
  for (;;) {
    const {done, value} = await reader.read();
    if (done) return bytes.subarray(0, length);
    while (length + value.length > bytes.length) {
      const larger = new Uint8Array(2 * bytes.length);
      larger.set(bytes);
      bytes = larger;
    }
    bytes.set(value, length);
    length += value.length;
    if (onChunk) onChunk(bytes, length);
  }
}

/**
 * The header and the start of the arrays; null until the header is complete.
 * @param {Uint8Array} bytes
 * @param {number} length the number of bytes so far
 * @returns {{at: number, fields: AssetHeader} | null}
 */
export function header(bytes, length) {
  if (length < 4) return null;
  const size = new DataView(bytes.buffer, bytes.byteOffset).getUint32(0, true);
  if (length < 4 + size) return null;
  return {at: 4 + size, fields: JSON.parse(new TextDecoder().decode(bytes.subarray(4, 4 + size)))};
}

/**
 * The end of the surfaces after a header.
 * @param {{at: number, fields: AssetHeader}} head
 */
export function surfacesEnd({at, fields}) { return at + 12 * fields.vertices + 14 * fields.triangles; }

// ---- Numbers as planes of bytes (byte_planes.h). ----

export class Reader {
  /**
   * @param {Uint8Array} bytes
   * @param {number} at
   */
  constructor(bytes, at) {
    this.bytes = bytes;
    this.at = at;
  }

  /**
   * Writes numbers to out[first], out[first + stride], ...; they are coded as differences from the number `back`
   * before, modulo 2^(8 width).
   * @param {number} count
   * @param {number} back
   * @param {number} width bytes
   * @param {Uint8Array | Uint16Array | Uint32Array} out
   */
  numbers(count, back, width, out, first = 0, stride = 1) {
    const {bytes, at} = this, mask = 2 ** (8 * width) - 1;
    for (let i = 0; i < count; ++i) {
      let symbol = 0;
      for (let b = 0; b < width; ++b) symbol |= bytes[at + b * count + i] << (8 * b);
      const before = i >= back ? out[first + (i - back) * stride] : 0;
      out[first + i * stride] = (before + ((symbol >>> 1) ^ -(symbol & 1))) & mask;
    }
    this.at += width * count;
  }
  /** @param {number} bytes */
  take(bytes) {
    this.at += bytes;
    return this.bytes.slice(this.at - bytes, this.at);
  }
}

/**
 * Vertices and triangles, enough for a skin. The functions below add the rest.
 * @param {Uint8Array} bytes
 * @param {{at: number, fields: AssetHeader}} head
 */
export function surfaces(bytes, {at, fields}) {
  const {vertices: V, triangles: T} = fields, reader = new Reader(bytes, at);
  const fruit = /** @type {Fruit} */ ({
    header: fields,
    count: fields.count,
    units: fields.units,
    position: new Uint16Array(3 * V),
    front: new Uint8Array(3 * V),
    back: new Uint8Array(3 * V),
    triangle: new Uint32Array(3 * T),
    hidden: new Uint8Array(T),
    part: [new Uint16Array(T), new Uint16Array(T)]
  });
  for (let k = 0; k < 3; ++k) reader.numbers(V, 1, 2, fruit.position, k, 3);
  for (let k = 0; k < 3; ++k) reader.numbers(V, 1, 1, fruit.front, k, 3);
  for (let k = 0; k < 3; ++k) reader.numbers(V, V + 1, 1, fruit.back, k, 3);
  for (let i = 0; i < 3 * V; ++i) fruit.back[i] += fruit.front[i];
  for (let k = 0; k < 3; ++k) reader.numbers(T, 2, 3, fruit.triangle, k, 3);
  reader.numbers(T, 1, 1, fruit.hidden);
  for (const part of fruit.part) reader.numbers(T, 1, 2, part);
  return fruit;
}

// ---- Inside and outside (windings.h). ----

/**
 * Adds `winding` (Int8Array) and `nodePart` (Uint8Array: 1 + part, 0 in air) by walking rows of nodes along x. If a row
 * leaves a body and is still in another, as a stem in flesh, it returns to that body's part: the outer side of a body
 * has its own look, not that of its surroundings.
 * @param {Fruit} fruit
 */
export function addWindings(fruit) {
  const {position, triangle, hidden, units} = fruit, [nx, ny, nz] = fruit.count, step = 2 * units;
  const winding = new Int8Array(nx * ny * nz), nodePart = new Uint8Array(nx * ny * nz);
  const last = new Float32Array(nx * ny * nz).fill(-1);  // the last crossing before a node
  const leaves = new Uint8Array(nx * ny * nz);           // 1 + the part of the body that the row leaves there
  /** @type {(ay: number, az: number, by: number, bz: number, y: number, z: number) => boolean} */
  const isLeft = (ay, az, by, bz, y, z) => {
    if (bz < az || (bz === az && by < ay)) return !isLeft(by, bz, ay, az, y, z);
    const twice = (by - ay) * (z - az) - (bz - az) * (y - ay);
    return twice !== 0 ? twice > 0 : az === bz && by > ay;
  };
  /** @type {(ay: number, az: number, by: number, bz: number, y: number, z: number) => number} */
  const area = (ay, az, by, bz, y, z) => (by - ay) * (z - az) - (bz - az) * (y - ay);
  for (let t = 0; t < hidden.length; ++t) {
    const a = 3 * triangle[3 * t], b = 3 * triangle[3 * t + 1], c = 3 * triangle[3 * t + 2];
    const ax = 2 * position[a] + 1, ay = 2 * position[a + 1] + 1, az = 2 * position[a + 2] + 1;
    const bx = 2 * position[b] + 1, by = 2 * position[b + 1] + 1, bz = 2 * position[b + 2] + 1;
    const cx = 2 * position[c] + 1, cy = 2 * position[c + 1] + 1, cz = 2 * position[c + 2] + 1;
    const zEnd = Math.min(Math.floor(Math.max(az, bz, cz) / step), nz - 1);
    const yEnd = Math.min(Math.floor(Math.max(ay, by, cy) / step), ny - 1);
    for (let iz = Math.ceil(Math.min(az, bz, cz) / step); iz <= zEnd; ++iz) {
      for (let iy = Math.ceil(Math.min(ay, by, cy) / step); iy <= yEnd; ++iy) {
        const y = iy * step, z = iz * step, left = isLeft(ay, az, by, bz, y, z);
        if (isLeft(by, bz, cy, cz, y, z) !== left || isLeft(cy, cz, ay, az, y, z) !== left) continue;
        const e1 = area(ay, az, by, bz, y, z), e2 = area(by, bz, cy, cz, y, z), e3 = area(cy, cz, ay, az, y, z);
        const sum = e1 + e2 + e3, x = sum === 0 ? ax : (e2 * ax + e3 * bx + e1 * cx) / sum;
        const first = Math.max(0, Math.floor(x / step) + 1);
        if (first >= nx) continue;
        const node = (iz * ny + iy) * nx + first;
        // The front faces +x if the row passes on the left of all edges.
        if (hidden[t] !== 0) winding[node] += left === (hidden[t] === 1) ? -1 : 1;
        if (x < last[node]) continue;
        const outwards = hidden[t] === (left ? 1 : 2), inner = fruit.part[left === outwards ? 1 : 0][t] + 1;
        last[node] = x;
        nodePart[node] = outwards ? 0 : inner;
        leaves[node] = outwards ? inner : 0;
      }
    }
  }
  for (let row = 0; row < winding.length; row += nx) {
    /** @type {number[]} */
    const around = [];  // for each body around the row, the part before it
    let bodies = 0, part = 0;
    for (let i = row; i < row + nx; ++i) {
      for (let k = 0; k < winding[i]; ++k) around.push(part);
      for (let k = 0; k < -winding[i] && around.length > 0; ++k) {
        const outer = around.pop();
        if (part === leaves[i]) part = outer ?? 0;
      }
      bodies += winding[i];
      winding[i] = bodies;
      if (nodePart[i] !== 0) part = nodePart[i];
      nodePart[i] = part;
    }
  }
  for (let i = 0; i < winding.length; ++i) {
    if (winding[i] === 0) nodePart[i] = 0;
    else if (nodePart[i] === 0) nodePart[i] = 1;
  }
  Object.assign(fruit, {winding, nodePart});
}

// ---- Colours of nodes (node_coding.h). ----

/**
 * The difference of each symbol: 0 and 1 exactly, larger ones in steps of 3, those beyond code `thirds` in steps of 5.
 * @type {(thirds: number) => Int32Array}
 */
const differences = (thirds) => Int32Array.from({length: 256}, (_, symbol) => {
  const code = symbol + 1 >> 1;
  const size = code <= 1 ? code : code <= thirds ? 1 + 3 * (code - 1) : 1 + 3 * (thirds - 1) + 5 * (code - thirds);
  return symbol & 1 ? -size : size;
});
const weightOf = Int32Array.from({length: 256}, (_, d) => Math.max(1, Math.floor(1024 / (1 + d * d))));

/**
 * Decodes one channel of all inner nodes, from coarse to fine; `at`: the starts of its four streams.
 * @param {Int8Array} winding
 * @param {number[]} count
 * @param {Uint8Array} bytes
 * @param {number[]} at
 * @param {Uint8Array} value
 * @param {Int32Array} differenceOf
 */
function decodeChannel(winding, [nx, ny, nz], bytes, at, value, differenceOf) {
  let last = 0;
  const away = [1, nx, nx * ny], count = [nx, ny, nz], place = [0, 0, 0];
  /** @type {(first: number[], every: number, step: number) => void} */
  const each = (first, every, step) => {
    const along = [0, 1, 2].filter((axis) => first[axis] > 0);
    for (let z = first[2]; z < nz; z += every) {
      place[2] = z;
      for (let y = first[1]; y < ny; y += every) {
        place[1] = y;
        for (let x = first[0], node = (z * ny + y) * nx + x; x < nx; x += every, node += every) {
          if (winding[node] === 0) continue;
          place[0] = x;
          let sum = 0, weights = 0, alone = 0, ends = 0, roughest = 0;
          for (const axis of along) {
            const d = step * away[axis], low = winding[node - d] !== 0;
            const high = place[axis] + step < count[axis] && winding[node + d] !== 0;
            if (low && high) {
              const a = value[node - d], b = value[node + d], apart = a < b ? b - a : a - b, weight = weightOf[apart];
              if (apart > roughest) roughest = apart;
              sum += weight * (a + b);
              weights += 2 * weight;
            } else if (low || high) {
              alone += value[low ? node - d : node + d];
              ++ends;
            }
          }
          const guess = weights > 0 ? Math.floor((2 * sum + weights) / (2 * weights))
            : ends > 0              ? Math.floor((2 * alone + ends) / (2 * ends))
                                    : last;
          const stream = weights === 0 ? 3 : roughest <= 1 ? 0 : roughest <= 6 ? 1 : roughest <= 24 ? 2 : 3;
          last = guess + differenceOf[bytes[at[stream]++]];
          value[node] = last = last < 0 ? 0 : last > 255 ? 255 : last;
        }
      }
    }
  };
  each([0, 0, 0], 16, 16);
  for (let step = 8; step > 0; step >>= 1) {
    for (let odd = 1; odd <= 3; ++odd) {
      for (let axes = 1; axes < 8; ++axes) {
        if ((axes & 1) + (axes >> 1 & 1) + (axes >> 2) !== odd) continue;
        each([axes & 1 ? step : 0, axes & 2 ? step : 0, axes & 4 ? step : 0], 2 * step, step);
      }
    }
  }
}

/**
 * Adds `nodeColor`: [red, green, blue], a Uint8Array each. Returns their end.
 * @param {Fruit} fruit
 * @param {Uint8Array} bytes
 * @param {number} at
 */
export function addNodes(fruit, bytes, at) {
  const differenceOf = differences(fruit.header.format === 1 ? 8 : fruit.header.thirds);
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const lengths = Array.from({length: 12}, (_, i) => view.getUint32(at + 4 * i, true));
  at += 48;
  const begins = lengths.map((length) => (at += length) - length);
  fruit.nodeColor = [0, 1, 2].map((channel) => {
    const value = new Uint8Array(fruit.winding.length);
    decodeChannel(fruit.winding, fruit.count, bytes, begins.slice(4 * channel, 4 * channel + 4), value, differenceOf);
    return value;
  });
  return at;
}

// ---- Paint and spared parts. ----

/**
 * A tile's texels as shaders/detail.glsl has them, level after level: linear colour, and share of its luminance.
 * @param {number} side
 * @param {Uint8Array} palette bytes of sRGB
 * @param {Uint8Array} texel
 */
function tileTexels(side, palette, texel) {
  const luminance = (/** @type {ArrayLike<number>} */ c, i = 0) =>
    0.2126 * c[i] + 0.7152 * c[i + 1] + 0.0722 * c[i + 2];
  const color = Float64Array.from(palette, (byte) => linear[byte]), shades = [];
  for (let i = 0; i < color.length; i += 3) shades.push(luminance(color, i));
  const darkest = Math.min(...shades), range = Math.max(Math.max(...shades) - darkest, 1e-6), levels = [];
  let level = new Float64Array(3 * texel.length);
  texel.forEach((number, i) => level.set(color.subarray(3 * number, 3 * number + 3), 3 * i));
  for (;; level = halved(level, side), side = side % 2 ? 1 : side / 2) {
    for (let i = 0; i < level.length; i += 3)
      levels.push(level[i], level[i + 1], level[i + 2], (luminance(level, i) - darkest) / range);
    if (side === 1) return levels;
  }
}

/**
 * Colours of a cube half as fine; an odd side leaves the mean alone.
 * @param {Float64Array} level
 * @param {number} side
 */
function halved(level, side) {
  const step = side % 2 ? side : 2, half = side / step, next = new Float64Array(3 * half ** 3);
  for (let z = 0, at = 0; z < side; ++z) {
    for (let y = 0; y < side; ++y) {
      for (let x = 0; x < side; ++x, at += 3) {
        const [a, b, c] = [x, y, z].map((v) => Math.floor(v / step)), to = 3 * ((c * half + b) * half + a);
        for (let k = 0; k < 3; ++k) next[to + k] += level[at + k] / step ** 3;
      }
    }
  }
  return next;
}

/**
 * Returns their end.
 * @param {Fruit} fruit
 * @param {Uint8Array} bytes
 * @param {number} at
 */
export function addLook(fruit, bytes, at) {
  const {texels, parts, guide, skin_shares: shares, shells, triangles, tiles} = fruit.header;
  const reader = new Reader(bytes, at);
  const floats = (/** @type {number} */ count) => new Float32Array(reader.take(16 * count).buffer);
  fruit.noise = floats(texels[0]);
  fruit.details = floats(texels[1]);
  fruit.materials = floats(texels[2]);
  fruit.skinShare = reader.take(4 * shares);
  if (guide) {
    const size = guide.count[0] * guide.count[1] * guide.count[2], whole = new Uint16Array(4 * size);
    for (let k = 0; k < 4; ++k) reader.numbers(size, 1, 2, whole, k, 4);
    fruit.guide = Float32Array.from(new Int16Array(whole.buffer), (v) => v * guide.unit);
    fruit.share = reader.take(4 * parts.length * depthSteps);
  }
  if (shells) {
    fruit.shell = new Uint16Array(triangles);
    reader.numbers(triangles, 1, 2, fruit.shell);
  }
  if (tiles) {
    const all = [...fruit.details];
    for (const {side, colors} of tiles)
      for (const value of tileTexels(side, reader.take(3 * colors), reader.take(side ** 3))) all.push(value);
    fruit.details = Float32Array.from(all);
  }
  return reader.at;
}

/**
 * Reads a whole decompressed asset.
 * @param {Uint8Array} bytes
 */
export function decoded(bytes) {
  const head = header(bytes, bytes.length);
  if (!head) throw new Error('the asset ends within its header');
  const fruit = surfaces(bytes, head);
  addWindings(fruit);
  const end = addLook(fruit, bytes, addNodes(fruit, bytes, surfacesEnd(head)));
  if (end !== bytes.length) throw new Error('something follows the asset\'s end');
  return fruit;
}
