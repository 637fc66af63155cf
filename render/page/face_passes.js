// The passes that make a face's texture: bare colours, noise, details, lines.
'use strict';
class FacePasses {
  constructor(card, style) {
    const {gl} = card;
    Object.assign(this, {card, gl, style});
    this.programs = Object.fromEntries([['look', 'LOOK'], ['within', 'WITHIN'], ['tone', 'TONE'], ['lines', 'INK']].map(([name, mode]) => [name, card.program('section.glsl', [mode])]));
    this.programs.crossed = card.program('skin.glsl', ['CROSSED']);
    // Patterns have not been seen on any card yet, and programs that stand for one take minutes over them: who wants to try
    // adds #detail to the page's address. All others get noise alone.
    this.wantsDetail = /[#&]detail\b/.test(location.hash);
    this.kinds = new Map();
    this.empty = gl.createVertexArray();
    this.profiles = card.texture(gl.TEXTURE_2D, gl.NEAREST, (t) => gl.texStorage2D(t, 1, gl.R32F, profilePlaces, 4));
  }

  /** The program for one kind of detail, or none where they are not wanted. */
  get makeDetail() {
    return this.wantsDetail ? (kind) => {
      if (!this.kinds.has(kind)) this.kinds.set(kind, this.card.program('section.glsl', ['DETAIL', `KIND ${kind}`]));
      return this.kinds.get(kind);
    } : null;
  }

  setProfiles(knives) {
    const {gl} = this;
    gl.activeTexture(gl.TEXTURE15);
    gl.bindTexture(gl.TEXTURE_2D, this.profiles.texture);
    knives.forEach((knife, k) => gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, k, profilePlaces, 1, gl.RED, gl.FLOAT, knife.profile));
  }

  setFrame(u, {origin, u: along, v, n, reach}, k) {
    const {gl, card} = this;
    gl.uniform3fv(u.face_origin, origin);
    gl.uniform3fv(u.face_u, V.mul(along, reach));
    gl.uniform3fv(u.face_v, V.mul(v, reach));
    gl.uniform3fv(u.face_n, n);
    gl.uniform1i(u.knife_number, k);
    card.bind(u.profiles, 4, this.profiles);
  }

  /** The bare colours of a face, into the bound target. */
  drawLook(fruit, frame, k) {
    const {gl, card} = this, {header} = fruit, u = card.use(this.programs.look);
    this.setFrame(u, frame, k);
    card.bind(u.pomona_grid, 0, fruit.grid);
    card.bind(u.pomona_cell, 1, fruit.cell);
    card.bind(u.pomona_list, 2, fruit.list);
    card.bind(u.pomona_triangle, 3, fruit.triangle);
    gl.uniform3fv(u.pomona_count, header.count);
    gl.uniform1i(u.pomona_units, header.units);
    gl.uniform3fv(u.pomona_low, fruit.range[0]);
    gl.uniform3fv(u.pomona_high, fruit.range[1]);
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /**
   * Takes from a face what lies outside the body. Rays leave each place of the knife along its normal; where they leave
   * the body as often as they enter it, the place lies outside.
   */
  keepWithin(body, face, k) {
    const {gl, card} = this, {size} = face, crossed = card.target(size, size, [[gl.RGBA8, gl.NEAREST]]);
    gl.bindFramebuffer(gl.FRAMEBUFFER, crossed.buffer);
    gl.viewport(0, 0, size, size);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    this.setFrame(card.use(this.programs.crossed), face.frame, k);
    card.draw(body.mesh);
    gl.disable(gl.BLEND);
    gl.bindFramebuffer(gl.FRAMEBUFFER, face.bare.buffer);
    const u = card.use(this.programs.within);
    card.bind(u.crossed, 0, crossed.colors[0]);
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    card.drop(crossed);
  }

  /** Noise, details one by one, lines: each pass reads what the one before it has left. */
  drawPaint(fruit, face, k) {
    const {gl, card, style} = this, {header} = fruit, {guide} = header;
    const left = [0, 1].map(() => card.target(face.size, face.size, [[gl.SRGB8_ALPHA8, gl.NEAREST]]));
    let before = face.bare;
    const pass = (program, target, set) => {
      const u = card.use(program);
      this.setFrame(u, face.frame, k);
      card.bind(u.bare, 0, face.bare.colors[0]);
      card.bind(u.tags, 1, face.bare.colors[1]);
      card.bind(u.before, 2, before.colors[0]);
      card.bind(u.noise_styles, 5, fruit.look.noise_styles);
      gl.uniform4fv(u.lattice, fruit.lattice);
      if (set) set(u);
      gl.bindFramebuffer(gl.FRAMEBUFFER, target.buffer);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      before = target;
    };
    const hasNoise = style.noise && fruit.hasNoise;
    if (hasNoise) pass(this.programs.tone, left[0]);
    for (const {number, program} of hasNoise ? fruit.details : []) {
      pass(program, before === left[0] ? left[1] : left[0], (u) => {
        gl.uniform1i(u.detail_number, number);
        card.bind(u.detail_styles, 6, fruit.look.detail_styles);
        card.bind(u.guide, 3, fruit.guide);
        card.bind(u.shares, 7, fruit.shares);
        gl.uniform1f(u.guide_scale, 1 / guide.stride);
        gl.uniform2f(u.guide_depth, guide.deepest, header.parts.length);
      });
    }
    pass(this.programs.lines, face.styled, (u) => {
      gl.uniform4f(u.ink, ...colorOf(style.ink || header.ink), style.lines ? style.inner_opacity : 0);
      gl.uniform1f(u.ink_width, 0.34 * style.inner * header.ink_width * face.size);
    });
    left.forEach((target) => card.drop(target));
  }
}
