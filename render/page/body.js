// A thing that can be cut: a fruit, or a piece of one. Its skin, the knives that go through it, and where what they
// leave lies. Lengths are in cells of its fruit's grid.
import {Faces} from './faces.js';
import {profilePlace, profilePlaces} from './knives.js';
import {M, V} from './linear.js';
import {PieceMeshes} from './piece_mesh.js';
import {homesOf, piecesOf, placed, samplesOf} from './pieces.js';

/** Low and high corner of so many points; `at(i, k)`: the coordinate k of one of them. */
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
/** Of a skin's corners, which follow one another by tens. */
export const boxOf = (skin) => boxAround(skin.length / 10, (i, k) => skin[10 * i + k]);
export const boxOfPoints = (points) => boxAround(points.length, (i, k) => points[i][k]);

const faceMargin =
  0.02;  // beside a skin its faces are drawn, too: there lie lines, and colours for when they are seen smaller

/** Triangles on the card, and what knives go by: shared by all that look alike. */
export class Shape {
  /**
   * `skin`: ten numbers a corner (skin.js); `index`: which corners are triangles, or none: three after three;
   * `outwards`: of skin.js.
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
 * The box, along a knife's u and v, of a skin (ten numbers a corner): -1 to 1 of its face, a little larger, and at
 * places of its profile.
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
  /** `samples`: so many points of its skin stand for it. */
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
    /** Of a piece, cut faces end where it does, not where its fruit did. */
    this.isPiece = false;
    /**
     * What knives go around: {stone, socket: meshes; shells; parts}, or null. `homes`: of each shell the cell that has
     * it.
     */
    this.spared = null;
    this.homes = [];
    this.boxes = new WeakMap();
    this.parts = new PieceMeshes(picture.card, shape);
    this.faces = new Faces(picture.passes, picture.speed, this);
    this.takeSamples(null, samples);
  }

  /** `winding` of the nodes, where these are known: the inside counts, too. */
  takeSamples(winding, most = 2500) {
    this.samples = samplesOf(this.fruit.header, this.skin, winding, most, this.spared ? this.spared.parts : []);
    this.setKnives(this.knives);
  }
  /** Stones and their like; samples of the fruit then have none within them. */
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
  /** What of knife k's face lies within the skin: low and high corner, -1 to 1 along its u and v, with a margin. */
  faceBox(k) {
    const knife = this.knives[k], found = this.boxes.get(knife);
    if (found) return found;
    const box = boxWithin(knife, this.skin);
    this.boxes.set(knife, box);
    return box;
  }
  /** What of its skin a piece may have. */
  meshOf(piece) { return this.parts.of(piece, this.knives); }
  get cutsSpared() { return this.homes.some(({isCut}) => isCut); }
  /**
   * Walls of a piece beside its skin: of the shells that are cut, those that it has whole, and the sockets of the
   * others. Where a scene's piece has stones that stand out of it, all of them are drawn so, and not as part of its
   * skin.
   */
  wallsOf(piece) {
    if (!this.cutsSpared) return [];
    const {stone, socket, shells} = this.spared;
    return this.homes.flatMap(({cell, isCut}, i) => {
      if (cell === piece.cell) return isCut || this.isPiece ? [{mesh: stone, range: shells[i].stone, whole: true}] : [];
      return isCut ? [{mesh: socket, range: shells[i].socket, whole: false}] : [];
    });
  }
  /** Parts of the skin, as bits, that walls stand for. */
  get leftOut() {
    const bits = [0, 0];
    if (this.isPiece && this.cutsSpared)
      for (const part of this.spared.parts) bits[part >> 5] |= 1 << (part & 31);
    return bits;
  }

  /** Pieces where they lie: in cells, then as `place` says. */
  arrange(apart, open) {
    this.arranged = placed(this.pieces, this.knives, this.frame, apart, open)
                      .map((piece) => ({...piece, own: piece.motion, motion: M.product(this.place, piece.motion)}));
  }
  /** Moves all of it to another place, as it is arranged. */
  moveTo(place) {
    this.place = place;
    this.arranged = this.arranged.map((piece) => ({...piece, motion: M.product(place, piece.own)}));
  }
  get outline() { return this.arranged.flatMap(({motion, points}) => points.map((p) => M.point(motion, p))); }
}
