// The passes that make a face's textures: bare colours, ways to rims, noise, details, lines.
import {linearOf} from './color.js';
import {byExample} from './fruit_textures.js';
import {profilePlaces} from './knives.js';
import {V} from './linear.js';

const rimReach = 0.004;  // metres; farther from the rim a part has no relief (render/style/face_relief.h)

export class FacePasses {
  constructor(card, style) {
    const {gl} = card;
    this.card = card;
    this.gl = gl;
    this.style = style;
    this.programs = Object.fromEntries([
      ['look', 'LOOK'], ['within', 'WITHIN'], ['ways', 'WAYS'], ['tone', 'TONE'], ['lines', 'INK']
    ].map(([name, mode]) => [name, card.program('section.glsl', [mode])]));
    this.programs.crossed = card.program('skin.glsl', ['CROSSED']);
    this.kinds = new Map();
    this.empty = gl.createVertexArray();
    this.level = card.table(1, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, Uint8Array.of(128, 0, 0, 0), 4);
    /** Default for slopes and rims: level, at the maximum distance from rims. */
    this.flat = card.table(1, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, Uint8Array.of(128, 128, 255, 255), 4);
    this.profiles = card.texture(gl.TEXTURE_2D, gl.NEAREST, (t) => gl.texStorage2D(t, 1, gl.R32F, profilePlaces, 4));
  }

  setProfiles(knives) {
    const {gl} = this;
    gl.activeTexture(gl.TEXTURE15);
    gl.bindTexture(gl.TEXTURE_2D, this.profiles.texture);
    knives.forEach(
      (knife, k) => gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, k, profilePlaces, 1, gl.RED, gl.FLOAT, knife.profile));
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

  /** Draws the bare colours of a face into the bound target. */
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
   * Removes the parts of a face outside of meshes, or inside them. A place lies outside if the ray from it along the
   * knife's normal leaves the meshes as often as it enters them. `draw()` draws the meshes.
   */
  keep(inside, face, k, draw) {
    const {gl, card} = this, {size} = face, crossed = card.target(size, size, [[gl.RGBA8, gl.NEAREST]]);
    gl.bindFramebuffer(gl.FRAMEBUFFER, crossed.buffer);
    gl.viewport(0, 0, size, size);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE);
    this.setFrame(card.use(this.programs.crossed), face.frame, k);
    draw();
    gl.disable(gl.BLEND);
    gl.bindFramebuffer(gl.FRAMEBUFFER, face.bare.buffer);
    const u = card.use(this.programs.within);
    card.bind(u.crossed, 0, crossed.colors[0]);
    gl.uniform1i(u.keeps_inside, inside ? 1 : 0);
    gl.bindVertexArray(this.empty);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    card.drop(crossed);
  }
  /** Limits a piece's face to the piece. */
  keepWithin(body, face, k) { this.keep(true, face, k, () => this.card.draw(body.mesh)); }
  /** Cuts out spared parts. */
  leaveOut({spared, homes}, face, k) {
    this.keep(false, face, k, () => spared.shells.forEach(({stone}, i) => {
      if (homes[i].isCut) this.card.draw(spared.stone, ...stone);
    }));
  }

  // ---- Stages of a face (faces.js), in order; each reads the results of earlier ones. ----

  /** Targets for colours and heights between stages, and for distances along rows. */
  newPaint(size) {
    const {gl, card} = this;
    const left = () => card.target(size, size, [[gl.SRGB8_ALPHA8, gl.NEAREST], [gl.RGBA8, gl.NEAREST]]);
    return [left(), left(), card.target(size, size, [[gl.RGBA8, gl.NEAREST]])];
  }
  /** The textures of a face: its colours; slopes along u and v, and the distance to the part's rim. */
  newStyled(size) {
    const {gl, card} = this;
    return card.target(size, size, [[gl.SRGB8_ALPHA8, 'mipmaps'], [gl.RGBA8, 'mipmaps']]);
  }

  lookStages(body, face, k) {
    const {gl} = this;
    const stages = [{
      name: 'look',
      draw: () => {
        gl.bindFramebuffer(gl.FRAMEBUFFER, face.bare.buffer);
        this.drawLook(body.fruit, face.frame, k);
      }
    }];
    if (body.isPiece) stages.push({name: 'within', once: true, draw: () => this.keepWithin(body, face, k)});
    if (body.cutsSpared) stages.push({name: 'without', once: true, draw: () => this.leaveOut(body, face, k)});
    return stages;
  }

  /** The stages: distances to rims, noise, these details, lines and slopes. */
  paintStages(fruit, face, k, details) {
    const {gl, card, style} = this, {header} = fruit, {guide} = header, [one, other, ways] = face.paint;
    const hasNoise = style.noise && fruit.hasNoise, texel = 2 * face.frame.reach * header.spacing / face.size;
    const reach = fruit.showsRim ? Math.min(127, Math.ceil(rimReach / texel)) : 0, stages = [];
    let left = {colors: [face.bare.colors[0], this.level]}, isOne = false;
    const pass = (name, program, target, set = (_u) => {}) => {
      const before = left;
      stages.push({
        name,
        draw: () => {
          const u = card.use(program);
          this.setFrame(u, face.frame, k);
          card.bind(u.bare, 0, face.bare.colors[0]);
          card.bind(u.tags, 1, face.bare.colors[1]);
          card.bind(u.before, 2, before.colors[0]);
          card.bind(u.heights, 8, before.colors[1]);
          card.bind(u.noise_styles, 5, fruit.look.noise_styles);
          card.bind(u.materials, 6, fruit.look.materials);
          gl.uniform4fv(u.lattice, fruit.lattice);
          gl.uniform1i(u.reach, reach);
          gl.uniform2f(u.texel, texel, rimReach);
          set(u);
          gl.bindFramebuffer(gl.FRAMEBUFFER, target.buffer);
          gl.bindVertexArray(this.empty);
          gl.drawArrays(gl.TRIANGLES, 0, 3);
        }
      });
    };
    const further = (name, program, set) => {
      isOne = !isOne;
      pass(name, program, isOne ? one : other, set);
      left = isOne ? one : other;
    };
    if (reach > 0) pass('ways', this.programs.ways, ways);
    if (hasNoise) further('tone', this.programs.tone);
    for (const {number, kind} of hasNoise ? details : []) {
      further(`detail ${kind}`, this.detail(kind), (u) => {
        gl.uniform1i(u.detail_number, number);
        gl.uniform4fv(u.detail_channel, [0, 1, 2, 3].map((i) => (i === number ? 1 : 0)));
        card.bind(u.detail_styles, 9, fruit.look.detail_styles);
        card.bind(u.guide, 3, fruit.guide);
        card.bind(u.shares, 7, fruit.shares);
        gl.uniform1f(u.guide_scale, 1 / guide.stride);
        gl.uniform2f(u.guide_depth, guide.deepest, header.parts.length);
      });
    }
    pass('lines', this.programs.lines, face.styled, (u) => {
      card.bind(u.ways, 10, ways.colors[0]);
      gl.uniform4f(u.ink, ...linearOf(style.ink || header.ink), style.lines ? style.inner_opacity : 0);
      gl.uniform1f(u.ink_width, 0.34 * style.inner * header.ink_width * face.size);
      gl.uniform1i(u.has_heights, hasNoise && details.length > 0 ? 1 : 0);
    });
    stages.push({
      name: 'mipmaps',
      once: true,
      draw: () => {
        gl.activeTexture(gl.TEXTURE15);
        for (const {texture} of face.styled.colors) {
          gl.bindTexture(gl.TEXTURE_2D, texture);
          gl.generateMipmap(gl.TEXTURE_2D);
        }
      }
    });
    return stages;
  }

  // ---- Details: a program for each kind, compiled when the first face is at rest. ----

  detail(kind) {
    const defines = ['DETAIL', `KIND ${kind}`, ...(kind === byExample ? ['EXAMPLES'] : [])];
    if (!this.kinds.has(kind)) this.kinds.set(kind, this.card.program('section.glsl', defines));
    return this.kinds.get(kind);
  }
  hasDetails(fruit) { return this.style.noise && fruit.hasNoise && fruit.details.length > 0; }
  areReady(fruit) { return fruit.details.map(({kind}) => this.card.isReady(this.detail(kind))).every(Boolean); }
}
