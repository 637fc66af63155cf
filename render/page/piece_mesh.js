// The triangles of a body's skin that each piece may have, so that a piece is drawn without the others' triangles:
// software renderers shade a pixel before they test whether a knife removes it.

/** @import {Knife} from './knives.js' */
/** @import {Piece} from './types.d.ts' */

/** Tolerance in cells: a curved blade rises between the corners of a triangle, a flat one only by rounding. */
const sideMargins = {
  curved: 2,
  flat: 0.01
};

/**
 * Bits for each corner of a skin (ten numbers per corner): k if it may lie on the positive side of knife k, 8 + k for
 * the negative side.
 * @param {Float32Array} skin
 * @param {Knife[]} knives
 */
export function sidesOf(skin, knives) {
  const bits = new Uint16Array(skin.length / 10);
  knives.forEach((knife, k) => {
    const margin = knife.isCurved ? sideMargins.curved : sideMargins.flat, positive = 1 << k, negative = 256 << k;
    knife.overBlade(skin, 10, (i, height) => {
      bits[i] |= (height >= -margin ? positive : 0) | (height <= margin ? negative : 0);
    });
  });
  return bits;
}

/**
 * The corners of triangles that no knife has entirely on the other side. `index`: the corners of triangles, or null for
 * three after three.
 * @param {{keep: number[]}} piece
 * @param {Uint16Array} sides
 * @param {Uint32Array | null} index
 */
export function trianglesOf({keep}, sides, index) {
  const wanted = keep.map((side, k) => (side > 0 ? 1 : 256) << k), corners = index ? index.length : sides.length;
  const kept = new Uint32Array(corners);
  let count = 0;
  for (let i = 0; i < corners; i += 3) {
    const [a, b, c] = index ? [index[i], index[i + 1], index[i + 2]] : [i, i + 1, i + 2];
    const some = sides[a] | sides[b] | sides[c];
    if (wanted.some((bit) => (some & bit) === 0)) continue;
    kept[count++] = a;
    kept[count++] = b;
    kept[count++] = c;
  }
  return kept.subarray(0, count);
}

/** A mesh on the card for each piece, made when it is first drawn. */
export class PieceMeshes {
  /**
   * @param {any} card the GPU device
   * @param {{mesh: any, skin: Float32Array, index: Uint32Array | null}} shape
   */
  constructor(card, {mesh, skin, index}) {
    this.card = card;
    this.mesh = mesh;
    this.skin = skin;
    this.index = index;
    /** @type {Uint16Array | null} */
    this.sides = null;
    this.made = new Map();
  }

  /** Deletes the meshes of other knives. */
  forget() {
    for (const mesh of this.made.values()) this.card.dropMesh(mesh);
    this.made.clear();
    this.sides = null;
  }
  /**
   * @param {Piece} piece
   * @param {Knife[]} knives
   */
  of(piece, knives) {
    const {card, mesh, made} = this;
    if (knives.length === 0) return mesh;
    this.sides = this.sides || sidesOf(this.skin, knives);
    if (!made.has(piece.cell)) made.set(piece.cell, card.mesh(mesh, trianglesOf(piece, this.sides, this.index)));
    return made.get(piece.cell);
  }
}
