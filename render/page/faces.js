// The cut faces of one body: worked out once for each place of a knife, into textures, so that turning the fruit costs
// little; while a knife moves they are coarse, and fine when it rests.
'use strict';

/** How fast the card is, as faces have shown it: texels a millisecond, and the side of a coarse face. */
class FaceSpeed {
  constructor() { Object.assign(this, {coarse: 256, perMs: 0, measured: false}); }
  take(texels, ms) {
    // The first time takes the compiler's time, too.
    if (this.measured) {
      this.perMs = texels / Math.max(0.1, ms);
      this.coarse = Math.max(192, Math.min(1024, Math.round(Math.sqrt(this.perMs * 24) / 32) * 32));
    }
    this.measured = true;
  }
  get isSlow() { return this.perMs > 0 && this.perMs < 1000; }
}

class Faces {
  constructor(passes, speed, body) { Object.assign(this, {passes, speed, body, all: []}); }

  newFace(knife, size) {
    const {gl, card} = this.passes;
    return {key: knife.key, size, frame: knife.frame, row: 0,
      bare: card.target(size, size, [[gl.SRGB8_ALPHA8, gl.NEAREST], [gl.RGBA8, gl.NEAREST]]),
      styled: card.target(size, size, [[gl.SRGB8_ALPHA8, 'mipmaps']])};
  }
  dropFace(face) {
    if (!face) return;
    this.passes.card.drop(face.bare);
    this.passes.card.drop(face.styled);
  }
  drop() {
    for (const {now, next} of this.all) { this.dropFace(now); this.dropFace(next); }
    this.all = [];
  }

  /** Goes on with a face for so many rows; true when it is whole. */
  work(face, k, rows) {
    const {passes, body} = this, {gl} = passes, end = Math.min(face.size, face.row + rows);
    gl.disable(gl.BLEND);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.viewport(0, 0, face.size, face.size);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, face.row, face.size, end - face.row);
    gl.bindFramebuffer(gl.FRAMEBUFFER, face.bare.buffer);
    passes.drawLook(body.fruit, face.frame, k);
    face.row = end;
    gl.disable(gl.SCISSOR_TEST);
    if (end < face.size) return false;
    if (body.isPiece) passes.keepWithin(body, face, k);
    passes.drawPaint(body.fruit, face, k);
    gl.activeTexture(gl.TEXTURE15);
    gl.bindTexture(gl.TEXTURE_2D, face.styled.colors[0].texture);
    gl.generateMipmap(gl.TEXTURE_2D);
    return true;
  }
  /** Waits until the card is done, so that times are true and no frame has more to do than it should. */
  wait() {
    const {gl} = this.passes;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** Faces for all knives, at least coarse ones; `waited` where there is time for more. {more: there is more to do, changed: the picture is}. */
  update(wanted, waited) {
    const {passes, speed, body} = this, {knives} = body;
    while (this.all.length > knives.length) { const {now, next} = this.all.pop(); this.dropFace(now); this.dropFace(next); }
    if (!body.fruit.ready || knives.length === 0) return {more: false, changed: false};
    passes.setProfiles(knives);
    let more = false, changed = false;
    knives.forEach((knife, k) => {
      const slot = this.all[k] || (this.all[k] = {now: null, next: null});
      if (slot.next && slot.next.key !== knife.key) { this.dropFace(slot.next); slot.next = null; }
      if (!slot.now || slot.now.key !== knife.key) {
        const face = this.newFace(knife, speed.coarse), begin = performance.now();
        this.work(face, k, face.size);
        this.wait();
        speed.take(face.size ** 2, performance.now() - begin);
        this.dropFace(slot.now);
        slot.now = face;
        changed = true;
      }
      const size = Math.min(wanted, speed.isSlow ? 1024 : 2048);
      if (slot.now.size >= size) return;
      more = true;
      if (!waited) return;
      slot.next = slot.next || this.newFace(knife, size);
      waited = false;
      const whole = this.work(slot.next, k, Math.max(8, Math.ceil(30 * Math.max(speed.perMs, 40) / size)));
      this.wait();
      if (!whole) return;
      changed = true;
      this.dropFace(slot.now);
      slot.now = slot.next;
      slot.next = null;
    });
    return {more, changed};
  }
}
