// A thing that can be cut: a fruit, or a piece of one. Its skin, the knives that go through it, and where what they leave
// lies. Lengths are in cells of its fruit's grid.
'use strict';

/** Low and high corner of numbers that follow one another by tens: a skin's. */
function boxOf(data, stride = 10) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < data.length; i += stride) for (let k = 0; k < 3; ++k) {
    low[k] = Math.min(low[k], data[i + k]);
    high[k] = Math.max(high[k], data[i + k]);
  }
  return {low, high};
}

/** Triangles on the card, and what knives go by: shared by all that look alike. */
class Shape {
  /** `skin`: ten numbers a corner (skin.js); `index`: which corners are triangles, or none: three after three. */
  constructor(card, skin, index = null) {
    const {low, high} = boxOf(skin), size = V.sub(high, low), middle = V.mul(V.add(low, high), 0.5);
    this.frame = {middle, low, high, size: Math.max(...size), reach: 0.53 * Math.hypot(...size)};
    this.mesh = card.vertices(skin, [3, 3, 3, 1], index);
    this.skin = skin;
  }
}

class Body {
  /** `samples`: so many points of its skin stand for it. */
  constructor(picture, fruit, shape, samples = 2500) {
    Object.assign(this, {fruit, frame: shape.frame, mesh: shape.mesh, skin: shape.skin, knives: [], pieces: [], arranged: [], place: M.identity(), chosen: false});
    /** Of a piece, cut faces end where it does, not where its fruit did. */
    this.isPiece = false;
    this.faces = new Faces(picture.passes, picture.speed, this);
    this.takeSamples(null, samples);
  }

  /** `winding` of the nodes, where these are known: the inside counts, too. */
  takeSamples(winding, most = 2500) {
    this.samples = samplesOf(this.fruit.header, this.skin, winding, most);
    this.pieces = piecesOf(this.samples, this.knives);
  }
  setKnives(knives) {
    this.knives = knives;
    this.pieces = piecesOf(this.samples, knives);
  }

  /** Pieces where they lie: in cells, then as `place` says. */
  arrange(apart, open) {
    this.arranged = placed(this.pieces, this.knives, this.frame, apart, open).map((piece) =>
      ({...piece, own: piece.motion, motion: M.product(this.place, piece.motion)}));
  }
  /** Moves all of it to another place, as it is arranged. */
  moveTo(place) {
    this.place = place;
    this.arranged = this.arranged.map((piece) => ({...piece, motion: M.product(place, piece.own)}));
  }
  get outline() { return this.arranged.flatMap(({motion, points}) => points.map((p) => M.point(motion, p))); }
}
