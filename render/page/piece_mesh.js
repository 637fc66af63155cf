// Which triangles of a body's skin each of its pieces may have, so that a piece is drawn without what others have:
// cards that are software work out what is drawn first and ask then whether a knife has taken it.

/** @import {Knife} from './knives.js' */
/** @import {Piece} from './types.d.ts' */

/** Cells: a curved blade rises between the corners of a triangle; a flat one but by rounding. */
const sideMargins = {
  curved: 2,
  flat: 0.01
};

/**
 * For each corner of a skin (ten numbers a corner) bits: k where it may lie on the positive side of knife k, 8 + k on
 * the negative one.
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
 * Corners of the triangles that no knife has wholly on the other side. `index`: which corners are triangles, or null:
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

/** On the card: a mesh for each piece, made when it is first drawn. */
export class PieceMeshes {
  /**
   * @param {any} card what the graphics card holds
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

  /** What was made for other knives is dropped. */
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
