// The picture: table, shadows, skins and cut faces of bodies.
import {linearOf} from './color.js';
import {FacePasses} from './face_passes.js';
import {FaceSpeed} from './faces.js';
import {GpuDevice} from './gpu_device.js';
import {profilePlaces} from './knives.js';
import {M, V} from './linear.js';

/** The sides of four knives on which a piece lies; 0 for missing knives. */
const keepOf = ({keep}) => [0, 1, 2, 3].map((k) => keep[k] || 0);

/** The programs for a fine cut face, from its texture to the narrow gap between face and skin. */
const fineFaces = ['within', 'face', 'ways', 'tone', 'lines'];

export class Picture {
  /**
   * `program`: the first program to draw with. `mayBeRough`: scenes are drawn roughly until all programs are compiled,
   * on software renderers, and during motion on slow cards. Rough frames have no smooth edges, which take software
   * renderers long to compile and draw.
   */
  constructor(canvas, {shaders, style}, {program = 'skin', mayBeRough = false} = {}) {
    this.canvas = canvas;
    this.style = style;
    const card = this.card = new GpuDevice(canvas, shaders, !mayBeRough), gl = this.gl = card.gl;
    if (!gl) return;
    this.passes = new FacePasses(card, style);
    this.speed = new FaceSpeed();
    this.programs = Object.fromEntries(
      [
        ['face', 'section.glsl', 'SHOW'], ['quickFace', 'section.glsl', 'SHOW', 'QUICK'],
        ['quickSkin', 'skin.glsl', 'SHOW', 'QUICK'], ['faceDepth', 'section.glsl', 'DEPTH'],
        ['facePick', 'section.glsl', 'PICK'], ['skin', 'skin.glsl', 'SHOW'],
        ['pieceSkin', 'skin.glsl', 'SHOW', 'PIECES'], ['within', 'skin.glsl', 'WITHIN'], ['hull', 'skin.glsl', 'HULL'],
        ['skinDepth', 'skin.glsl', 'DEPTH'], ['skinPick', 'skin.glsl', 'PICK'], ['ground', 'ground.glsl', 'GROUND'],
        ['quickGround', 'ground.glsl', 'GROUND', 'QUICK']
      ]
        .map(
          ([name, file, ...modes]) =>
            [name, card.program(file, style.saturation === 1 && style.lightness === 0 ? [...modes, 'AS_IS'] : modes)]));
    // Until all programs are compiled, software renderers draw plainly.
    this.isQuick = mayBeRough && card.isSoftware;
    this.samples = mayBeRough ? {width: 0, height: 0, buffer: null, layers: []} : null;
    this.start([
      'skinDepth', this.isQuick ? 'quickGround' : 'ground', this.isQuick && program === 'skin' ? 'quickSkin' : program,
      ...(style.lines ? ['hull'] : [])
    ]);
    this.suns = [1024, 512].map((size) => card.target(size, size, [], true));
    this.sky = card.target(256, 256, [], true);
    /** The contents of the depth maps (drawMap). */
    this.mapped = new Map();
    this.picked = card.target(1, 1, [[gl.RGBA8, gl.NEAREST]], true);
  }

  programOf(name) { return this.programs[name] || this.passes.programs[name]; }
  start(names) {
    for (const name of names) this.card.start(this.programOf(name));
  }
  /** Starts compiling the programs for the first cut, then the others. */
  startCuts() { this.start(['look', 'faceDepth', ...(this.isQuick ? ['quickFace'] : fineFaces)]); }
  startRest() { this.start(['ground', 'skin', ...fineFaces]); }
  /** True if bodies can be drawn finely without waiting for the compiler. */
  isReady(bodies) {
    if (!this.isQuick) return true;
    const skins = new Set(bodies.map(({isPiece}) => (isPiece ? 'pieceSkin' : 'skin')));
    const faces = bodies.some(({knives}) => knives.length > 0) ? fineFaces : [];
    return ['ground', ...skins, ...faces].map((name) => this.card.isReady(this.programOf(name))).every(Boolean);
  }

  inkOf(fruit) { return linearOf(this.style.ink || fruit.header.ink); }

  /** Sets the knives of a body, and the sides of them on which its piece lies. */
  setPiece(u, body, piece) {
    const {gl} = this, plane = new Float32Array(16), along = new Float32Array(16);
    body.knives.forEach((knife, k) => {
      const {origin, n, u: way, reach} = knife.frame;
      plane.set([...n, V.dot(n, origin)], 4 * k);
      along.set([...V.mul(way, 1 / reach), V.dot(way, origin) / reach], 4 * k);
    });
    gl.uniform4fv(u.knife_plane, plane);
    gl.uniform4fv(u.knife_along, along);
    gl.uniform1i(u.knives, body.knives.length);
    gl.uniform4fv(u.keep, keepOf(piece));
    gl.uniformMatrix4fv(u.piece, false, piece.motion);
  }

  /** `set(u, body, index)` is called for each body. */
  drawSkins(program, view, bodies, set) {
    if (bodies.length === 0) return;
    const {gl, card, passes} = this, u = card.use(this.programs[program]);
    gl.uniformMatrix4fv(u.camera, false, view);
    bodies.forEach((body, index) => {
      if (body.knives.length > 0) passes.setProfiles(body.knives);
      card.bind(u.profiles, 4, passes.profiles);
      if (set) set(u, body, index);
      for (const piece of body.arranged) {
        this.setPiece(u, body, piece);
        gl.uniform2uiv(u.left_out, body.leftOut);
        card.draw(body.meshOf(piece));
        gl.uniform2uiv(u.left_out, [0, 0]);
        for (const {mesh, range, whole} of body.wallsOf(piece)) {
          gl.uniform4fv(u.keep, whole ? [0, 0, 0, 0] : keepOf(piece));
          card.draw(mesh, ...range);
        }
      }
    });
  }
  drawFaces(program, view, bodies, set) {
    const {gl, card, passes} = this;
    bodies.forEach((body, index) => {
      if (!body.fruit.ready || body.knives.length === 0) return;
      const u = card.use(this.programs[program]);
      gl.uniformMatrix4fv(u.camera, false, view);
      passes.setProfiles(body.knives);
      if (set) set(u, body, index);
      gl.bindVertexArray(passes.empty);
      body.knives.forEach((knife, k) => {
        const face = body.faces.all[k] && body.faces.all[k].now, box = body.faceBox(k);
        if (!face) return;
        const columns = knife.isCurved ? Math.max(1, Math.round((box[2] - box[0]) / 2 * (profilePlaces - 1))) : 1;
        passes.setFrame(u, face.frame, k);
        card.bind(u.styled, 0, face.styled.colors[0]);
        card.bind(u.tags, 1, face.bare.colors[1]);
        card.bind(u.slopes, 2, face.styled.colors[1]);
        gl.uniform1i(u.columns, columns);
        gl.uniform4fv(u.box, box);
        for (const piece of body.arranged) {
          this.setPiece(u, body, piece);
          gl.uniform1f(u.side, -piece.keep[k]);
          gl.drawArrays(gl.TRIANGLE_STRIP, 0, 2 * (columns + 1));
        }
      });
    });
  }
  drawDepths(target, view, bodies) {
    const {gl} = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.buffer);
    gl.viewport(0, 0, target.width, target.height);
    gl.clear(gl.DEPTH_BUFFER_BIT);
    this.drawSkins('skinDepth', view, bodies);
    this.drawFaces('faceDepth', view, bodies);
  }
  /** Draws a depth map unless it is current: the sky's map stays while the fruit is turned. */
  drawMap(target, view, bodies) {
    const now = [...view, ...bodies.flatMap((body) => [body.arranged, ...body.faces.all.map(({now}) => now)])];
    const before = this.mapped.get(target);
    if (before && before.length === now.length && before.every((one, i) => one === now[i])) return;
    this.drawDepths(target, view, bodies);
    this.mapped.set(target, now);
  }

  /** Sets the light's direction and the reach of shadows. `size`: of a fruit, in the scene's lengths. */
  lightOf({camera, bounds, size, rough = false}) {
    const {azimuth: turn, elevation: e} = this.style.light, azimuth = camera.yaw + turn;
    const toLight = [Math.cos(e) * Math.sin(azimuth), Math.sin(e), Math.cos(e) * Math.cos(azimuth)];
    const middle = V.mul(V.add(bounds.low, bounds.high), 0.5);
    const radius = 0.62 * Math.hypot(...V.sub(bounds.high, bounds.low)) + 0.1 * size;
    const across = V.unit(V.cross([0, 1, 0], toLight)), table = bounds.low[1];
    const toSun = M.orthographic(across, V.cross(toLight, across), toLight, middle, radius, radius);
    // From the table upwards; depth 0 is on the table.
    const skyDepth = 1.2 * size, skyReach = 1.6 * radius;
    const toSky = M.orthographic(
      [1, 0, 0], [0, 0, 1], [0, -1, 0], [middle[0], table + 0.5 * skyDepth, middle[2]], skyReach, 0.5 * skyDepth);
    return {toLight, toSun, toSky, middle, radius, table, size, rough};
  }
  setLight(u, {toLight, toSun, toSky, table, size, rough}, {eye}) {
    const {gl, card, style} = this;
    gl.uniform3fv(u.to_light, toLight);
    gl.uniform1f(u.gloss, style.gloss);
    gl.uniform2f(u.light_strengths, style.light.strength, style.light.ambient);
    card.bind(u.sun_map, 9, this.suns[rough ? 1 : 0].depth);
    card.bind(u.sky_map, 10, this.sky.depth);
    gl.uniformMatrix4fv(u.to_sun, false, toSun);
    gl.uniformMatrix4fv(u.to_sky, false, toSky);
    gl.uniform2f(u.shadow_ways, 0.028, 0.004);
    gl.uniform4f(u.ground_plane, table, 0.5 * size, style.shadow.strength, style.light.occlusion);
    gl.uniform3fv(u.eye, eye);
    gl.uniform2f(u.paint, style.saturation, style.lightness);
  }
  /** Sets the uniforms of a fruit. */
  setFruit(u, {fruit}) {
    const {gl, card} = this;
    card.bind(u.materials, 7, fruit.look.materials);
    card.bind(u.noise_styles, 5, fruit.look.noise_styles);
    gl.uniform4fv(u.lattice, fruit.lattice);
    gl.uniform4f(u.ink, ...this.inkOf(fruit), 1);
    gl.uniform1i(u.painted_noise, this.style.noise && fruit.hasNoise ? 1 : 0);
  }

  /**
   * `scene`: bodies, their bounds, size of a fruit, camera {view, eye, yaw}, dark, rough (during motion on slow cards).
   */
  draw(scene) {
    const {gl, canvas, card} = this, {bodies, camera} = scene, light = this.lightOf(scene);
    gl.disable(gl.BLEND);
    gl.disable(gl.CULL_FACE);
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(0, 0, 0, 0);
    this.drawMap(this.suns[light.rough ? 1 : 0], light.toSun, bodies);
    this.drawMap(this.sky, light.toSky, bodies);
    const isQuick = this.isQuick = this.isQuick && light.rough, smooth = this.samples && !light.rough;
    gl.bindFramebuffer(gl.FRAMEBUFFER, smooth ? this.samplesOf(canvas).buffer : null);
    gl.viewport(0, 0, canvas.width, canvas.height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    this.drawGround(scene, light);
    this.drawOutlines(scene);
    let lit = null;
    const set = (u, body) => {
      if (lit !== u) this.setLight(u, light, camera);
      lit = u;
      this.setFruit(u, body);
    };
    gl.enable(gl.CULL_FACE);
    gl.cullFace(gl.BACK);
    this.drawSkins(isQuick ? 'quickSkin' : 'skin', camera.view, bodies.filter(({isPiece}) => !isPiece), set);
    this.drawSkins('pieceSkin', camera.view, bodies.filter(({isPiece}) => isPiece), set);
    gl.cullFace(gl.FRONT);
    if (!isQuick && bodies.some(({knives}) => knives.length > 0))
      this.drawSkins('within', camera.view, bodies, (u, {fruit}) => gl.uniform4f(u.ink, ...this.inkOf(fruit), 1));
    gl.disable(gl.CULL_FACE);
    this.drawFaces(isQuick ? 'quickFace' : 'face', camera.view, bodies, (u, body) => {
      set(u, body);
      gl.uniform1f(u.outline, this.style.lines ? 1 : 0);
      gl.uniform1f(u.rim_width, 0.42 * this.lineOf(body));
    });
    if (smooth) card.putOn(this.samples);
  }
  /** Resizes the targets to the canvas. */
  samplesOf({width, height}) {
    const {card, samples} = this;
    if (samples.width === width && samples.height === height) return samples;
    card.dropSamples(samples);
    this.samples = card.samples(width, height);
    return this.samples;
  }
  /** Draws the table as a thin wash. */
  drawGround({camera, dark}, light) {
    const {gl, card, style} = this, u = card.use(this.programs[this.isQuick ? 'quickGround' : 'ground']);
    const shadow = linearOf(style.shadow.color).map((c) => c * (dark ? 0.35 : 1));
    this.setLight(u, light, camera);
    gl.uniformMatrix4fv(u.camera, false, camera.view);
    gl.uniform4f(u.ground, light.middle[0], light.table, light.middle[2], 3 * light.radius);
    gl.uniform4f(u.wash, ...shadow, style.shadow.strength);
    gl.bindVertexArray(this.passes.empty);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    gl.drawArrays(gl.TRIANGLE_STRIP, 0, 4);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }
  lineOf({fruit}) {
    const {canvas, style} = this;
    return style.lines ? style.outline * fruit.header.ink_width * Math.min(canvas.width, canvas.height) : 0;
  }
  drawOutlines({bodies, camera}) {
    const {gl, canvas, style} = this;
    const drawn = bodies.filter((body) => style.lines || body.chosen);
    if (drawn.length === 0) return;
    gl.enable(gl.CULL_FACE);
    gl.cullFace(gl.FRONT);
    // The selected body has a strong outline.
    this.drawSkins('hull', camera.view, drawn, (u, body) => {
      gl.uniform4f(u.ink, ...(body.chosen ? linearOf('#c8442c') : this.inkOf(body.fruit)), 1);
      gl.uniform3f(
        u.outline, canvas.width / 2, canvas.height / 2, body.chosen ? 0.006 * canvas.height : 0.3 * this.lineOf(body));
    });
    gl.disable(gl.CULL_FACE);
  }

  /** What is at a place of the canvas, 0..1 from the top: {body, part, cut}, or null. */
  pick({bodies, camera}, x, y) {
    const {gl} = this, {width, height} = this.canvas;
    const narrowed =
      new Float32Array([width, 0, 0, 0, 0, height, 0, 0, 0, 0, 1, 0, width * (1 - 2 * x), height * (2 * y - 1), 0, 1]);
    const view = M.product(narrowed, camera.view), found = new Uint8Array(4);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.picked.buffer);
    gl.viewport(0, 0, 1, 1);
    gl.disable(gl.BLEND);
    gl.enable(gl.DEPTH_TEST);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    // The number of the body takes two bytes.
    const number = (u, _, index) => gl.uniform2f(u.body, (index & 255) / 255, (index >> 8) / 255);
    this.drawSkins('skinPick', view, bodies, number);
    this.drawFaces('facePick', view, bodies, number);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, found);
    if (found[0] === 0) return null;
    const body = bodies[found[2] + 256 * found[3]];
    return {body, part: body.fruit.header.parts[found[0] - 1], cut: found[1] > 200};
  }

  /** For tests: the bare colours of a square in a plane, as bytes; `frame` is in cells. */
  bare(fruit, frame, size) {
    return this.squareBytes(size, (target) => {
      this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, target.buffer);
      this.passes.drawLook(fruit, frame, 0);
      return [target];
    });
  }

  /** For tests: the same with noise and details, without lines. */
  detailed(fruit, frame, size) {
    const {passes} = this;
    return this.squareBytes(size, (bare) => {
      const face = {frame, size, bare, paint: passes.newPaint(size), styled: passes.newStyled(size)};
      const stages = [...passes.lookStages({fruit}, face, 0), ...passes.paintStages(fruit, face, 0, fruit.details)];
      const lines = stages.findIndex(({name}) => name === 'lines');
      stages.slice(0, lines < 0 ? stages.length : lines).forEach(({draw}) => draw());
      return [bare, face.styled, ...face.paint];
    });
  }

  /** The bytes of a square of so many pixels: `draw` leaves bound what is read, and says which targets to drop. */
  squareBytes(size, draw) {
    const {gl, card} = this, pixels = new Uint8Array(4 * size * size);
    const target = card.target(size, size, [[gl.SRGB8_ALPHA8, gl.NEAREST], [gl.RGBA8, gl.NEAREST]]);
    this.passes.setProfiles([{profile: new Float32Array(profilePlaces)}]);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.BLEND);
    gl.viewport(0, 0, size, size);
    const targets = draw(target);
    gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    targets.forEach((used) => card.drop(used));
    return pixels;
  }
}
