// The picture: skin, cut faces, shadows. Faces are worked out once for each place of a knife, into textures, so that
// turning the fruit costs little; while a knife moves they are coarse, and fine when it rests.
'use strict';
const colorOf = (hex) => [1, 3, 5].map((at) => {
  const c = parseInt(hex.slice(at, at + 2), 16) / 255;
  return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4;
});

class Picture {
  constructor(canvas, {shaders, style}) {
    this.canvas = canvas;
    this.style = style;
    const card = this.card = new Card(canvas, shaders), gl = this.gl = card.gl;
    if (!gl) return;
    this.programs = Object.fromEntries([['look', 'section.glsl', 'LOOK'], ['tone', 'section.glsl', 'TONE'], ['lines', 'section.glsl', 'INK'], ['face', 'section.glsl', 'SHOW'],
      ['faceDepth', 'section.glsl', 'DEPTH'], ['facePick', 'section.glsl', 'PICK'], ['skin', 'skin.glsl', 'SHOW'], ['hull', 'skin.glsl', 'HULL'],
      ['skinDepth', 'skin.glsl', 'DEPTH'], ['skinPick', 'skin.glsl', 'PICK'], ['ground', 'ground.glsl', 'GROUND']]
      .map(([name, file, mode]) => [name, card.program(file, [mode])]));
    // Patterns have not been seen on any card yet, and programs that stand for one take minutes over them: who wants to try
    // adds #detail to the page's address. All others get noise alone.
    this.wantsDetail = /[#&]detail\b/.test(location.hash);
    this.empty = gl.createVertexArray();
    this.profiles = card.texture(gl.TEXTURE_2D, gl.NEAREST, (t) => gl.texStorage2D(t, 1, gl.R32F, profilePlaces, 4));
    this.sun = card.target(1024, 1024, [[gl.RGBA8, gl.NEAREST]], true);
    this.sky = card.target(256, 256, [[gl.RGBA8, gl.NEAREST]], true);
    this.picked = card.target(1, 1, [[gl.RGBA8, gl.NEAREST]], true);
    this.faces = [];
    this.dragSize = 256;
    this.speed = 0;
  }

  // ---- What arrives from the worker. ----

  takeSkin(header, skin) {
    const {spacing, origin} = header, low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (let i = 0; i < skin.length; i += 10) for (let k = 0; k < 3; ++k) {
      low[k] = Math.min(low[k], skin[i + k]);
      high[k] = Math.max(high[k], skin[i + k]);
    }
    const size = V.sub(high, low), middle = V.mul(V.add(low, high), 0.5);
    this.fruit = {middle, low, high, size: Math.max(...size), reach: 0.53 * Math.hypot(...size)};
    this.header = header;
    this.lattice = [...origin, spacing];
    this.ink = colorOf(this.style.ink || header.ink);
    this.skin = this.card.vertices(skin, [3, 3, 3, 1]);
    // Until the rest is there, nothing is known of noise and materials.
    const plain = [1, 0.3, 1, 0, 1, 1, 1, 0, 0.7, 0.8, 0.8, 100, 0, 0, 0, 0, 0.4, 0, 0, 0];
    this.takeLook({noise: new Float32Array(0), details: new Float32Array(0),
      materials: Float32Array.from(header.parts.flatMap(() => plain))});
  }

  takeRest(rest) {
    const {gl, card} = this, {count} = this.header;
    this.grid = card.volume(count, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, rest.grid, gl.LINEAR);
    this.cell = card.volume(count, gl.RG32UI, gl.RG_INTEGER, gl.UNSIGNED_INT, rest.cell, gl.NEAREST);
    this.list = card.table(2048, gl.R32UI, gl.RED_INTEGER, gl.UNSIGNED_INT, rest.list, 1);
    this.triangle = card.table(4096, gl.RGBA32UI, gl.RGBA_INTEGER, gl.UNSIGNED_INT, rest.triangle, 4);
    this.range = [rest.low, rest.high];
    this.takeLook(rest);
    this.hasNoise = this.style.noise && rest.noise.length > 0;
    const {guide} = this.header;
    this.guide = card.volume(guide ? guide.count : [1, 1, 1], gl.RGBA16F, gl.RGBA, gl.FLOAT, guide ? rest.guide : new Float32Array(4), gl.LINEAR);
    this.shares = card.table(32, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, guide ? rest.share : new Uint8Array(128), 4, gl.LINEAR);
    // A program for each kind of detail that cut faces have: their texels begin with the kind, -1 for none.
    const kinds = new Map();
    this.details = [];
    for (let i = 0; guide && this.wantsDetail && i < 4 && 28 * i < rest.details.length; ++i) {
      const kind = rest.details[28 * i];
      if (kind < 0) continue;
      if (!kinds.has(kind)) kinds.set(kind, card.program('section.glsl', ['DETAIL', `KIND ${kind}`]));
      this.details.push({number: i, program: kinds.get(kind)});
    }
    this.ready = true;
  }

  takeLook({noise, details, materials}) {
    const {gl, card} = this;
    this.look = {noise_styles: card.floats(noise, gl.NEAREST), detail_styles: card.floats(details, gl.NEAREST), materials: card.floats(materials, gl.NEAREST)};
  }

  // ---- Faces. ----

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

  /** The bare colours of rows of a face, into the bound target. */
  drawLook(frame, k) {
    const {gl, card, header} = this, u = card.use(this.programs.look);
    this.setFrame(u, frame, k);
    card.bind(u.pomona_grid, 0, this.grid);
    card.bind(u.pomona_cell, 1, this.cell);
    card.bind(u.pomona_list, 2, this.list);
    card.bind(u.pomona_triangle, 3, this.triangle);
    gl.uniform3fv(u.pomona_count, header.count);
    gl.uniform1i(u.pomona_units, header.units);
    gl.uniform3fv(u.pomona_low, this.range[0]);
    gl.uniform3fv(u.pomona_high, this.range[1]);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  /** Noise, details one by one, lines: each pass reads what the one before it has left. */
  drawPaint(face, k) {
    const {gl, card, header, style} = this, {guide} = header, left = [0, 1].map(() => card.target(face.size, face.size, [[gl.SRGB8_ALPHA8, gl.NEAREST]]));
    let before = face.bare;
    const pass = (program, target, set) => {
      const u = card.use(program);
      this.setFrame(u, face.frame, k);
      card.bind(u.bare, 0, face.bare.colors[0]);
      card.bind(u.tags, 1, face.bare.colors[1]);
      card.bind(u.before, 2, before.colors[0]);
      card.bind(u.noise_styles, 5, this.look.noise_styles);
      gl.uniform4fv(u.lattice, this.lattice);
      if (set) set(u);
      gl.bindFramebuffer(gl.FRAMEBUFFER, target.buffer);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      before = target;
    };
    if (this.hasNoise) pass(this.programs.tone, left[0]);
    for (const {number, program} of this.hasNoise ? this.details : []) {
      pass(program, before === left[0] ? left[1] : left[0], (u) => {
        gl.uniform1i(u.detail_number, number);
        card.bind(u.detail_styles, 6, this.look.detail_styles);
        card.bind(u.guide, 3, this.guide);
        card.bind(u.shares, 7, this.shares);
        gl.uniform1f(u.guide_scale, 1 / guide.stride);
        gl.uniform2f(u.guide_depth, guide.deepest, header.parts.length);
      });
    }
    pass(this.programs.lines, face.styled, (u) => {
      gl.uniform4f(u.ink, ...this.ink, style.lines ? style.inner_opacity : 0);
      gl.uniform1f(u.ink_width, 0.34 * style.inner * header.ink_width * face.size);
    });
    left.forEach((target) => card.drop(target));
  }

  newFace(knife, size) {
    const {gl, card} = this, frame = knife.frame;
    return {key: knife.key, size, frame, row: 0,
      bare: card.target(size, size, [[gl.SRGB8_ALPHA8, gl.NEAREST], [gl.RGBA8, gl.NEAREST]]),
      styled: card.target(size, size, [[gl.SRGB8_ALPHA8, 'mipmaps']])};
  }
  dropFace(face) {
    if (!face) return;
    this.card.drop(face.bare);
    this.card.drop(face.styled);
  }

  /** Goes on with a face for so many rows; true when it is whole. */
  work(face, k, rows) {
    const {gl} = this, end = Math.min(face.size, face.row + rows);
    gl.bindVertexArray(this.empty);
    gl.disable(gl.BLEND);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.viewport(0, 0, face.size, face.size);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, face.row, face.size, end - face.row);
    gl.bindFramebuffer(gl.FRAMEBUFFER, face.bare.buffer);
    this.drawLook(face.frame, k);
    face.row = end;
    if (end === face.size) {
      gl.disable(gl.SCISSOR_TEST);
      this.drawPaint(face, k);
      gl.activeTexture(gl.TEXTURE15);
      gl.bindTexture(gl.TEXTURE_2D, face.styled.colors[0].texture);
      gl.generateMipmap(gl.TEXTURE_2D);
    }
    gl.disable(gl.SCISSOR_TEST);
    return end === face.size;
  }

  /** Faces for all knives, at least coarse ones; `waited` where there is time for more. {more: there is more to do, changed: the picture is}. */
  updateFaces(knives, wanted, waited) {
    if (!this.ready) return {more: false, changed: false};
    const {gl} = this;
    this.setProfiles(knives);
    while (this.faces.length > knives.length) { const {now, next} = this.faces.pop(); this.dropFace(now); this.dropFace(next); }
    let more = false, changed = false;
    knives.forEach((knife, k) => {
      const slot = this.faces[k] || (this.faces[k] = {now: null, next: null});
      if (slot.next && slot.next.key !== knife.key) { this.dropFace(slot.next); slot.next = null; }
      if (!slot.now || slot.now.key !== knife.key) {
        const face = this.newFace(knife, this.dragSize), begin = performance.now();
        this.work(face, k, face.size);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        const ms = Math.max(0.1, performance.now() - begin);
        // The first time takes the compiler's time, too.
        if (this.measured) { this.speed = face.size ** 2 / ms; this.dragSize = Math.max(192, Math.min(1024, Math.round(Math.sqrt(this.speed * 24) / 32) * 32)); }
        this.measured = true;
        this.dropFace(slot.now);
        slot.now = face;
        changed = true;
      }
      const size = Math.min(wanted, this.isSlow ? 1024 : 2048);
      if (slot.now.size >= size) return;
      more = true;
      if (!waited) return;
      slot.next = slot.next || this.newFace(knife, size);
      waited = false;
      const rows = Math.max(8, Math.ceil(30 * Math.max(this.speed, 40) / size));
      const whole = this.work(slot.next, k, rows);
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
      if (!whole) return;
      changed = true;
      this.dropFace(slot.now);
      slot.now = slot.next;
      slot.next = null;
    });
    return {more, changed};
  }
  get isSlow() { return this.speed > 0 && this.speed < 1000; }

  // ---- The scene. ----

  setKnives(u, knives, pieces, piece) {
    const {gl} = this, plane = new Float32Array(16), along = new Float32Array(16), keep = [0, 0, 0, 0];
    knives.forEach((knife, k) => {
      const {origin, n, u: way, reach} = knife.frame;
      plane.set([...n, V.dot(n, origin)], 4 * k);
      along.set([...V.mul(way, 1 / reach), V.dot(way, origin) / reach], 4 * k);
      keep[k] = piece.keep[k];
    });
    gl.uniform4fv(u.knife_plane, plane);
    gl.uniform4fv(u.knife_along, along);
    gl.uniform4fv(u.keep, keep);
    gl.uniformMatrix4fv(u.piece, false, piece.motion);
  }

  drawSkin(program, view, knives, pieces, set) {
    const {gl, card} = this, u = card.use(this.programs[program]);
    gl.uniformMatrix4fv(u.camera, false, view);
    card.bind(u.profiles, 4, this.profiles);
    if (set) set(u);
    gl.bindVertexArray(this.skin.array);
    for (const piece of pieces) {
      this.setKnives(u, knives, pieces, piece);
      gl.drawArrays(gl.TRIANGLES, 0, this.skin.count);
    }
  }
  drawFaces(program, view, knives, pieces, set) {
    const {gl, card} = this;
    if (!this.ready || knives.length === 0) return;
    const u = card.use(this.programs[program]);
    gl.uniformMatrix4fv(u.camera, false, view);
    gl.bindVertexArray(this.empty);
    if (set) set(u);
    knives.forEach((knife, k) => {
      const face = this.faces[k].now, columns = knife.isCurved ? 255 : 1;
      this.setFrame(u, face.frame, k);
      card.bind(u.styled, 0, face.styled.colors[0]);
      card.bind(u.tags, 1, face.bare.colors[1]);
      gl.uniform1i(u.columns, columns);
      for (const piece of pieces) {
        this.setKnives(u, knives, pieces, piece);
        gl.uniform1f(u.side, -piece.keep[k]);
        gl.drawArrays(gl.TRIANGLE_STRIP, 0, 2 * (columns + 1));
      }
    });
  }
  drawDepths(target, view, knives, pieces) {
    const {gl} = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.buffer);
    gl.viewport(0, 0, target.width, target.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.colorMask(false, false, false, false);
    this.drawSkin('skinDepth', view, knives, pieces);
    this.drawFaces('faceDepth', view, knives, pieces);
    gl.colorMask(true, true, true, true);
  }

  /** `scene`: knives, pieces, bounds of all, camera {view, eye, yaw}, dark. */
  draw(scene) {
    const {gl, card, canvas, style, fruit} = this, {knives, pieces, camera, bounds} = scene;
    const azimuth = camera.yaw + style.light.azimuth, e = style.light.elevation;
    const toLight = [Math.cos(e) * Math.sin(azimuth), Math.sin(e), Math.cos(e) * Math.cos(azimuth)];
    const middle = V.mul(V.add(bounds.low, bounds.high), 0.5), radius = 0.62 * Math.hypot(...V.sub(bounds.high, bounds.low)) + 0.1 * fruit.size;
    const across = V.unit(V.cross([0, 1, 0], toLight)), table = bounds.low[1];
    const toSun = M.orthographic(across, V.cross(toLight, across), toLight, middle, radius, radius);
    // From below the table, upwards: depth 0 on it.
    const skyDepth = 1.2 * fruit.size, skyReach = 1.6 * radius;
    const toSky = M.orthographic([1, 0, 0], [0, 0, 1], [0, -1, 0], [middle[0], table + 0.5 * skyDepth, middle[2]], skyReach, 0.5 * skyDepth);
    gl.disable(gl.BLEND);
    gl.disable(gl.CULL_FACE);
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(0, 0, 0, 0);
    this.setProfiles(knives);
    this.drawDepths(this.sun, toSun, knives, pieces);
    this.drawDepths(this.sky, toSky, knives, pieces);

    const light = (u) => {
      gl.uniform3fv(u.to_light, toLight);
      gl.uniform1f(u.gloss, style.gloss);
      gl.uniform2f(u.light_strengths, style.light.strength, style.light.ambient);
      card.bind(u.sun_map, 9, this.sun.depth);
      card.bind(u.sky_map, 10, this.sky.depth);
      gl.uniformMatrix4fv(u.to_sun, false, toSun);
      gl.uniformMatrix4fv(u.to_sky, false, toSky);
      gl.uniform2f(u.shadow_ways, 0.028, 0.004);
      gl.uniform4f(u.ground_plane, table, 0.5 * fruit.size, style.shadow.strength, style.light.occlusion);
      card.bind(u.materials, 7, this.look.materials);
      card.bind(u.noise_styles, 5, this.look.noise_styles);
      gl.uniform4fv(u.lattice, this.lattice);
      gl.uniform3fv(u.eye, camera.eye);
      gl.uniform4f(u.ink, ...this.ink, 1);
      gl.uniform2f(u.paint, style.saturation, style.lightness);
      gl.uniform1i(u.painted_noise, this.hasNoise ? 1 : 0);
    };
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);

    // The table, thin as a wash; then outlines, skins, faces.
    const ground = card.use(this.programs.ground), shadow = colorOf(style.shadow.color).map((c) => c * (scene.dark ? 0.35 : 1));
    light(ground);
    gl.uniformMatrix4fv(ground.camera, false, camera.view);
    gl.uniform4f(ground.ground, middle[0], table, middle[2], 3 * radius);
    gl.uniform4f(ground.wash, ...shadow, style.shadow.strength);
    gl.bindVertexArray(this.empty);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    gl.depthMask(true);
    gl.disable(gl.BLEND);

    const side = Math.min(canvas.width, canvas.height), line = style.lines ? style.outline * this.header.ink_width * side : 0;
    if (line > 0) {
      gl.enable(gl.CULL_FACE);
      gl.cullFace(gl.FRONT);
      this.drawSkin('hull', camera.view, knives, pieces, (u) => {
        gl.uniform4f(u.ink, ...this.ink, 1);
        gl.uniform3f(u.outline, canvas.width / 2, canvas.height / 2, 0.3 * line);
      });
      gl.disable(gl.CULL_FACE);
    }
    this.drawSkin('skin', camera.view, knives, pieces, light);
    this.drawFaces('face', camera.view, knives, pieces, (u) => {
      light(u);
      gl.uniform1f(u.outline, style.lines ? 1 : 0);
      gl.uniform1f(u.rim_width, 0.42 * line);
    });
  }

  /** What lies at a place of the canvas, 0..1 from above: {part, cut}, or null. */
  pick(scene, x, y) {
    const {gl} = this, {knives, pieces, camera} = scene, {width, height} = this.canvas;
    const narrowed = new Float32Array([width, 0, 0, 0, 0, height, 0, 0, 0, 0, 1, 0, width * (1 - 2 * x), height * (2 * y - 1), 0, 1]);
    const view = M.product(narrowed, camera.view), found = new Uint8Array(4);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.picked.buffer);
    gl.viewport(0, 0, 1, 1);
    gl.disable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.drawSkin('skinPick', view, knives, pieces);
    this.drawFaces('facePick', view, knives, pieces);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, found);
    return found[0] === 0 ? null : {part: this.header.parts[found[0] - 1], cut: found[1] > 200};
  }

  /** For tests: the bare colours of a square in a plane, as bytes; `frame` in cells. */
  bare(frame, size) {
    const {gl} = this, target = this.card.target(size, size, [[gl.SRGB8_ALPHA8, gl.NEAREST], [gl.RGBA8, gl.NEAREST]]), pixels = new Uint8Array(4 * size * size);
    this.setProfiles([{profile: new Float32Array(profilePlaces)}]);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.buffer);
    gl.viewport(0, 0, size, size);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.bindVertexArray(this.empty);
    this.drawLook(frame, 0);
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    this.card.drop(target);
    return pixels;
  }
}
