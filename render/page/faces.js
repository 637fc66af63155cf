// The cut faces of one body. They are computed into textures once for each place of a knife, so that turning the fruit
// costs little: coarsely while a knife moves, finely when it rests, then with details.

const frameMs = 30;           // for faces in one frame
const longestDetails = 15e3;  // ms; slower cards show no details

/**
 * Measured speed of the card: texels per millisecond, the side of a coarse face, and the time per texel of each stage.
 */
export class FaceSpeed {
  constructor() {
    this.coarse = 256;
    this.perMs = 0;
    this.measured = false;
    this.costs = new Map();
    this.skipsDetails = false;
  }
  take(texels, ms) {
    // The first time includes compilation.
    if (this.measured) {
      this.perMs = texels / Math.max(0.1, ms);
      this.coarse = Math.max(192, Math.min(1024, Math.round(Math.sqrt(this.perMs * 24) / 32) * 32));
    }
    this.measured = true;
  }
  takeStage(name, texels, ms) {
    const {costs} = this, before = costs.get(name), now = ms / texels;
    costs.set(name, before === undefined ? null : before === null ? now : 0.5 * (before + now));
  }
  /** The number of rows of a stage that fit into a frame. */
  rows(name, size) { return Math.max(8, Math.ceil(frameMs / (this.costs.get(name) || 1 / 40) / size)); }
  get isSlow() { return this.perMs > 0 && this.perMs < 1000; }
}

/** The remaining work on a face: stages {name, once, draw}, one after another, each row by row or at once. */
class FaceWork {
  constructor(passes, speed, size, stages) {
    this.passes = passes;
    this.speed = speed;
    this.size = size;
    this.stages = stages;
    this.at = 0;
    this.row = 0;
  }

  /** Computes the next rows; true when all is done. */
  go(rows) {
    const {gl} = this.passes, {size} = this, stage = this.stages[this.at];
    const end = stage.once ? size : Math.min(size, this.row + rows);
    gl.disable(gl.BLEND);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.viewport(0, 0, size, size);
    if (!stage.once) {
      gl.enable(gl.SCISSOR_TEST);
      gl.scissor(0, this.row, size, end - this.row);
    }
    stage.draw();
    gl.disable(gl.SCISSOR_TEST);
    this.row = end;
    if (end === size) {
      ++this.at;
      this.row = 0;
    }
    return this.at === this.stages.length;
  }
  /** Computes everything at once. */
  goThrough() {
    while (!this.go(this.size))
      ;
  }
  finish() {
    this.goThrough();
    this.wait();
  }
  /** Computes as much as fits into a frame; true when all is done. */
  goOn() {
    const {speed, size, stages} = this, {name, once} = stages[this.at];
    const rows = once ? size : Math.min(size - this.row, speed.rows(name, size)), begin = performance.now();
    const done = this.go(rows);
    this.wait();
    speed.takeStage(name, rows * size, performance.now() - begin);
    return done;
  }
  /** Waits for the card, so that times are correct and no frame gets too much work. */
  wait() {
    const {gl} = this.passes;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }
}

export class Faces {
  constructor(passes, speed, body) {
    this.passes = passes;
    this.speed = speed;
    this.body = body;
    this.all = [];
    this.withDetails = true;
  }

  /** A new face, and the work for its bare colours. `filter`: of their texture. */
  begunFace(knife, size, k, filter) {
    const {passes, speed, body} = this, {gl, card} = passes;
    const bare = card.target(size, size, [[gl.SRGB8_ALPHA8, filter], [gl.RGBA8, gl.NEAREST]]);
    const face = {key: knife.key, size, frame: knife.frame, bare, paint: null, isDetailed: false, isBare: false};
    face.work = new FaceWork(passes, speed, size, passes.lookStages(body, face, k));
    return face;
  }
  newFace(knife, size, k) {
    const {passes, body} = this, face = this.begunFace(knife, size, k, passes.gl.NEAREST);
    Object.assign(face, {styled: passes.newStyled(size), paint: passes.newPaint(size)});
    face.work.stages.push(...passes.paintStages(body.fruit, face, k, []));
    return face;
  }
  /** A face with only bare colours, without noise, lines and rims. It does not wait for the card. */
  bareFace(knife, size, k) {
    const {passes} = this, face = this.begunFace(knife, size, k, passes.gl.LINEAR);
    face.work.goThrough();
    return Object.assign(face, {styled: {colors: [face.bare.colors[0], passes.flat]}, isBare: true, work: null});
  }
  dropFace(face) {
    if (!face) return;
    const {card} = this.passes;
    [face.bare, ...(face.isBare ? [] : [face.styled]), ...(face.paint || [])].forEach((target) => card.drop(target));
    if (face.next) card.drop(face.next);
  }
  drop() {
    for (const {now, next} of this.all) {
      this.dropFace(now);
      this.dropFace(next);
    }
    this.all = [];
  }
  done(face) {
    face.paint.forEach((target) => this.passes.card.drop(target));
    Object.assign(face, {paint: null, work: null});
  }

  /** Computes details of a fine face, apart from the shown textures; true when done. */
  goOnWithDetails(face, k) {
    const {passes, speed, body} = this, {fruit} = body;
    if (!face.work) {
      face.next = passes.newStyled(face.size);
      face.paint = passes.newPaint(face.size);
      face.work = new FaceWork(
        passes, speed, face.size, passes.paintStages(fruit, {...face, styled: face.next}, k, fruit.details));
    }
    if (!face.work.goOn()) {
      const cost = Math.max(0, ...fruit.details.map(({kind}) => speed.costs.get(`detail ${kind}`) || 0));
      speed.skipsDetails = cost * face.size ** 2 * fruit.details.length > longestDetails;
      if (!speed.skipsDetails) return false;
      passes.card.drop(face.next);
    } else {
      passes.card.drop(face.styled);
      Object.assign(face, {styled: face.next, isDetailed: true});
    }
    face.next = null;
    this.done(face);
    return true;
  }

  /**
   * Faces for all knives, at least coarse ones; `waited`: there is time for more. Returns {more: work is left, changed:
   * the picture changed}. `rough`: the picture is rough; then the very first faces stay bare, so that only the look-up
   * must be compiled.
   */
  update(wanted, waited, rough = false) {
    const {passes, speed, body} = this, {knives, fruit} = body;
    while (this.all.length > knives.length) {
      const {now, next} = this.all.pop();
      this.dropFace(now);
      this.dropFace(next);
    }
    if (!fruit.ready || knives.length === 0) return {more: false, changed: false};
    passes.setProfiles(knives);
    const firstBare = rough && !speed.measured;
    let more = false, changed = false;
    knives.forEach((knife, k) => {
      const slot = this.all[k] || (this.all[k] = {now: null, next: null});
      if (slot.next && slot.next.key !== knife.key) {
        this.dropFace(slot.next);
        slot.next = null;
      }
      if (!slot.now && firstBare) {
        slot.now = this.bareFace(knife, speed.coarse, k);
        more = changed = true;
        return;
      }
      if (!slot.now || slot.now.key !== knife.key) {
        const face = this.newFace(knife, speed.coarse, k), begin = performance.now();
        face.work.finish();
        this.done(face);
        speed.take(face.size ** 2, performance.now() - begin);
        this.dropFace(slot.now);
        slot.now = face;
        changed = true;
      }
      const {now} = slot, size = Math.min(wanted, speed.isSlow ? 1024 : 2048);
      const wantsDetails = this.withDetails && !speed.skipsDetails && !now.isDetailed && passes.hasDetails(fruit);
      if (now.size >= size && !wantsDetails) return;
      more = true;
      if (!waited) return;
      if (now.size >= size) {
        if (!passes.areReady(fruit)) return;
        waited = false;
        changed = this.goOnWithDetails(now, k) || changed;
        return;
      }
      waited = false;
      slot.next = slot.next || this.newFace(knife, size, k);
      if (!slot.next.work.goOn()) return;
      this.done(slot.next);
      changed = true;
      this.dropFace(slot.now);
      slot.now = slot.next;
      slot.next = null;
    });
    return {more, changed};
  }
}
