// A body that can be cut: a fruit, or a piece. Its skin, its knives, and the places of its pieces. Lengths are in cells
// of its fruit's grid.
import {Faces} from './faces.js';
import {profilePlace, profilePlaces} from './knives.js';
import {M, V} from './linear.js';
import {PieceMeshes} from './piece_mesh.js';
import {homesOf, piecesOf, placed, samplesOf} from './pieces.js';

/** The low and high corner of `count` points; `at(i, k)`: coordinate k of point i. */
function boxAround(count, at) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < count; ++i)
    for (let k = 0; k < 3; ++k) {
      const x = at(i, k);
      if (x < low[k]) low[k] = x;
      if (x > high[k]) high[k] = x;
    }
  return {low, high};
}
/** The bounds of a skin with ten numbers per corner. */
export const boxOf = (skin) => boxAround(skin.length / 10, (i, k) => skin[10 * i + k]);
export const boxOfPoints = (points) => boxAround(points.length, (i, k) => points[i][k]);

const faceMargin = 0.02;  // faces are also drawn this far beyond the skin: for lines, and for colours at smaller scales

/** Triangles on the card, and what knives need of them: shared by equal bodies. */
export class Shape {
  /**
   * `skin`: ten numbers per corner (skin.js); `index`: the corners of triangles, or none for three after three;
   * `outwards`: see skin.js.
   */
  constructor(card, skin, index, outwards) {
    const {low, high} = boxOf(skin), size = V.sub(high, low), middle = V.mul(V.add(low, high), 0.5);
    this.frame = {middle, low, high, size: Math.max(...size), reach: 0.53 * Math.hypot(...size)};
    this.mesh = card.skin(skin, index, outwards);
    this.skin = skin;
    this.index = index;
  }
}

/**
 * The box of a skin (ten numbers per corner) along a knife's u and v: -1 to 1 of its face, slightly enlarged, and
 * rounded to places of its profile.
 */
function boxWithin({frame: {origin, u, v, reach}}, skin) {
  const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
  for (let i = 0; i < skin.length; i += 10) {
    const x = skin[i] - origin[0], y = skin[i + 1] - origin[1], z = skin[i + 2] - origin[2];
    const s = (x * u[0] + y * u[1] + z * u[2]) / reach, t = (x * v[0] + y * v[1] + z * v[2]) / reach;
    if (s < low[0]) low[0] = s;
    if (s > high[0]) high[0] = s;
    if (t < low[1]) low[1] = t;
    if (t > high[1]) high[1] = t;
  }
  const place = (s, round) => 2 * profilePlace(s, round) / (profilePlaces - 1) - 1;
  return [...low.map((s) => place(s - faceMargin, Math.floor)), ...high.map((s) => place(s + faceMargin, Math.ceil))];
}

export class Body {
  /** `samples`: the number of points of the skin that represent the body. */
  constructor(picture, fruit, shape, samples = 2500) {
    this.fruit = fruit;
    this.frame = shape.frame;
    this.mesh = shape.mesh;
    this.skin = shape.skin;
    this.index = shape.index;
    this.knives = [];
    this.pieces = [];
    this.arranged = [];
    this.place = M.identity();
    this.chosen = false;
    /** Cut faces of a piece end at the piece, not at its fruit. */
    this.isPiece = false;
    /** Spared parts: {stone, socket: meshes; shells; parts}, or null. `homes`: for each shell its cell. */
    this.spared = null;
    this.homes = [];
    this.boxes = new WeakMap();
    this.parts = new PieceMeshes(picture.card, shape);
    this.faces = new Faces(picture.passes, picture.speed, this);
    this.takeSamples(null, samples);
  }

  /** `winding` of the nodes, if known: then inner points count, too. */
  takeSamples(winding, most = 2500) {
    this.samples = samplesOf(this.fruit.header, this.skin, winding, most, this.spared ? this.spared.parts : []);
    this.setKnives(this.knives);
  }
  /** Sets the spared parts; then the fruit's samples exclude them. */
  takeSpared(spared) {
    this.spared = spared;
    this.setKnives(this.knives);
  }
  setKnives(knives) {
    const shells = this.spared ? this.spared.shells : [];
    this.knives = knives;
    this.parts.forget();
    this.homes = homesOf(shells, knives, this.spared?.nearlyAsMuch);
    this.pieces = piecesOf(this.samples, knives, shells, this.homes);
  }
  /** The part of knife k's face within the skin: low and high corner, -1 to 1 along its u and v, with a margin. */
  faceBox(k) {
    const knife = this.knives[k], found = this.boxes.get(knife);
    if (found) return found;
    const box = boxWithin(knife, this.skin);
    this.boxes.set(knife, box);
    return box;
  }
  /** The triangles of the skin that a piece may have. */
  meshOf(piece) { return this.parts.of(piece, this.knives); }
  get cutsSpared() { return this.homes.some(({isCut}) => isCut); }
  /**
   * Walls of a piece besides its skin: of shells that are cut, the shells that it has whole, and the sockets of the
   * others. If stones stick out of a scene's piece, all its stones are drawn so, and not as part of its skin.
   */
  wallsOf(piece) {
    if (!this.cutsSpared) return [];
    const {stone, socket, shells} = this.spared;
    return this.homes.flatMap(({cell, isCut}, i) => {
      if (cell === piece.cell) return isCut || this.isPiece ? [{mesh: stone, range: shells[i].stone, whole: true}] : [];
      return isCut ? [{mesh: socket, range: shells[i].socket, whole: false}] : [];
    });
  }
  /** Parts of the skin that walls replace, as bits. */
  get leftOut() {
    const bits = [0, 0];
    if (this.isPiece && this.cutsSpared)
      for (const part of this.spared.parts) bits[part >> 5] |= 1 << (part & 31);
    return bits;
  }

  /** The matrix of each piece: its arrangement in cells, then `place`. */
  arrange(apart, open) {
    this.arranged = placed(this.pieces, this.knives, this.frame, apart, open)
                      .map((piece) => ({...piece, own: piece.motion, motion: M.product(this.place, piece.motion)}));
  }
  /** Moves the whole arrangement to another place. */
  moveTo(place) {
    this.place = place;
    this.arranged = this.arranged.map((piece) => ({...piece, motion: M.product(place, piece.own)}));
  }
  get outline() { return this.arranged.flatMap(({motion, points}) => points.map((p) => M.point(motion, p))); }
}
