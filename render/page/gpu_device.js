// The GPU device: programs, textures, buffers.

/** Texels, a power of two. */
const longestRow = 2048;

export class GpuDevice {
  /** `antialias`: true if the canvas has smooth edges; else samples() has them. */
  constructor(canvas, shaders, antialias) {
    this.gl = canvas.getContext('webgl2', {antialias, premultipliedAlpha: true, powerPreference: 'high-performance'});
    this.shaders = shaders;
    if (!this.gl) return;
    const known = this.gl.getExtension('WEBGL_debug_renderer_info');
    const renderer = known ? this.gl.getParameter(known.UNMASKED_RENDERER_WEBGL) : '';
    this.parallel = this.gl.getExtension('KHR_parallel_shader_compile');
    /** A software renderer is known to be slow from the start. */
    this.isSoftware = /swiftshader|llvmpipe|software|basic render/i.test(renderer);
  }

  /** A shader's text with its includes; texel buffers of the pictures' shaders are float textures here. */
  text(name, seen = new Set()) {
    if (seen.has(name)) return '';
    seen.add(name);
    return this.shaders[name]
      .replace(/^#include "(.*)"$/gm, (_, other) => this.text(other, seen))
      .replace(/uniform samplerBuffer/g, 'uniform highp sampler2D')
      .replace(/texelFetch\((noise_styles|materials), ([^()]*)\)/g, 'texelFetch($1, ivec2($2, 0), 0)')
      .replace(
        /texelFetch\(detail_styles, ([^()]*)\)/g,
        `texelFetch(detail_styles, ivec2(($1) & ${longestRow - 1}, ($1) / ${longestRow}), 0)`);
  }

  /** A program that is compiled when it is started, queried or first used. */
  program(name, defines = []) { return {name, defines, program: null, uniforms: null}; }

  /** Starts compilation, in parallel if the browser can. */
  start(made) {
    if (made.program) return;
    const {gl} = this, {name, defines} = made, program = made.program = gl.createProgram(), text = this.text(name);
    const head = '#version 300 es\n#define COMPACT\nprecision highp float;\nprecision highp int;\n' +
      'precision highp sampler2D;\nprecision highp sampler3D;\n';
    for (const [stage, define] of [[gl.VERTEX_SHADER, 'VERTEX'], [gl.FRAGMENT_SHADER, 'FRAGMENT']]) {
      const shader = gl.createShader(stage);
      gl.shaderSource(shader, head + [define, ...defines].map((d) => `#define ${d}\n`).join('') + text);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      program[define] = shader;
    }
    gl.linkProgram(program);
  }

  /** True if a program can be used without waiting, as far as the browser tells. */
  isReady(made) {
    if (made.uniforms !== null || !this.parallel) return true;
    this.start(made);
    if (!this.gl.getProgramParameter(made.program, this.parallel.COMPLETION_STATUS_KHR)) return false;
    this.know(made);
    return true;
  }

  use(made) {
    this.start(made);
    this.know(made);
    this.gl.useProgram(made.program);
    return made.uniforms;
  }
  /**
   * Queries the uniforms once it is compiled or first used, so that programs compile in parallel. The answer comes
   * after all earlier commands to the card.
   */
  know(made) {
    const {gl} = this;
    if (made.uniforms) return;
    if (!gl.getProgramParameter(made.program, gl.LINK_STATUS)) {
      const logs = ['VERTEX', 'FRAGMENT'].map((d) => gl.getShaderInfoLog(made.program[d]));
      throw new Error(`${made.name}: ${logs.join('')} ${gl.getProgramInfoLog(made.program)}`);
    }
    made.uniforms = {};
    for (let i = gl.getProgramParameter(made.program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; --i) {
      const {name} = gl.getActiveUniform(made.program, i);
      made.uniforms[name.replace('[0]', '')] = gl.getUniformLocation(made.program, name);
    }
  }

  texture(target, filter, make) {
    const {gl} = this, texture = gl.createTexture();
    gl.activeTexture(gl.TEXTURE15);
    gl.bindTexture(target, texture);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    make(target);
    gl.texParameteri(target, gl.TEXTURE_MIN_FILTER, filter === 'mipmaps' ? gl.LINEAR_MIPMAP_LINEAR : filter);
    gl.texParameteri(target, gl.TEXTURE_MAG_FILTER, filter === 'mipmaps' ? gl.LINEAR : filter);
    for (const wrap of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T, gl.TEXTURE_WRAP_R])
      gl.texParameteri(target, wrap, gl.CLAMP_TO_EDGE);
    return {texture, target};
  }
  volume(count, format, kind, type, data, filter) {
    const {gl} = this;
    return this.texture(gl.TEXTURE_3D, filter, (t) => gl.texImage3D(t, 0, format, ...count, 0, kind, type, data));
  }
  table(width, format, kind, type, data, perTexel, filter = this.gl.NEAREST) {
    const {gl} = this, rows = data.length / (width * perTexel);
    return this.texture(gl.TEXTURE_2D, filter, (t) => gl.texImage2D(t, 0, format, width, rows, 0, kind, type, data));
  }
  /** In several rows if there are more than one can hold. */
  longFloats(data) {
    const {gl} = this, perRow = 4 * longestRow;
    if (data.length <= perRow) return this.floats(data, gl.NEAREST);
    const rows = new Float32Array(Math.ceil(data.length / perRow) * perRow);
    rows.set(data);
    return this.table(longestRow, gl.RGBA32F, gl.RGBA, gl.FLOAT, rows, 4);
  }
  floats(data, filter) {
    return this.table(
      Math.max(1, data.length / 4), this.gl.RGBA32F, this.gl.RGBA, this.gl.FLOAT,
      data.length ? data : new Float32Array(4), 4, filter);
  }

  /** A render target: colour textures of these formats, and depth if wanted. */
  target(width, height, formats, depth = null) {
    const {gl} = this, target = {width, height, buffer: gl.createFramebuffer()};
    target.colors = formats.map(
      ([format, filter]) => this.texture(
        gl.TEXTURE_2D, filter,
        (t) => gl.texStorage2D(t, filter === 'mipmaps' ? 1 + Math.floor(Math.log2(width)) : 1, format, width, height)));
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.buffer);
    target.colors.forEach(
      ({texture}, i) => gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, texture, 0));
    if (depth) {
      target.depth =
        this.texture(gl.TEXTURE_2D, gl.NEAREST, (t) => gl.texStorage2D(t, 1, gl.DEPTH_COMPONENT24, width, height));
      gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.TEXTURE_2D, target.depth.texture, 0);
    }
    gl.drawBuffers(formats.length ? formats.map((_, i) => gl.COLOR_ATTACHMENT0 + i) : [gl.NONE]);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    return target;
  }
  /** A render target with several samples per pixel, which putOn() resolves onto the canvas. */
  samples(width, height) {
    const {gl} = this, target = {width, height, buffer: gl.createFramebuffer(), layers: []};
    const count = Math.min(4, gl.getParameter(gl.MAX_SAMPLES));
    gl.bindFramebuffer(gl.FRAMEBUFFER, target.buffer);
    target.layers =
      [[gl.RGBA8, gl.COLOR_ATTACHMENT0], [gl.DEPTH_COMPONENT24, gl.DEPTH_ATTACHMENT]].map(([format, place]) => {
        const layer = gl.createRenderbuffer();
        gl.bindRenderbuffer(gl.RENDERBUFFER, layer);
        gl.renderbufferStorageMultisample(gl.RENDERBUFFER, count, format, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, layer);
        return layer;
      });
    return target;
  }
  putOn({width, height, buffer}) {
    const {gl} = this;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, buffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  }
  dropSamples({buffer, layers}) {
    for (const layer of layers) this.gl.deleteRenderbuffer(layer);
    this.gl.deleteFramebuffer(buffer);
  }
  drop(target) {
    if (!target) return;
    for (const {texture} of target.depth ? [...target.colors, target.depth] : target.colors)
      this.gl.deleteTexture(texture);
    this.gl.deleteFramebuffer(target.buffer);
  }

  bind(uniform, unit, {texture, target}) {
    if (!uniform) return;
    this.gl.activeTexture(this.gl.TEXTURE0 + unit);
    this.gl.bindTexture(target, texture);
    this.gl.uniform1i(uniform, unit);
  }

  /** A buffer of numbers per vertex. */
  buffer(data) {
    const {gl} = this, buffer = gl.createBuffer();
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, data, gl.STATIC_DRAW);
    return buffer;
  }
  /**
   * `data` has groups of floats per vertex, at locations 0, 1, ...; `outwards` has three more at the next location;
   * `index` has the corners of triangles, or is null.
   */
  vertices(data, groups, index = null, outwards = null) {
    const stride = groups.reduce((a, b) => a + b, 0);
    return this.mesh(
      {
        buffer: this.buffer(data),
        outwards: outwards && this.buffer(outwards),
        groups,
        stride,
        count: data.length / stride
      },
      index);
  }
  /** A mesh from corners on the card, or with the shared corners of another mesh. */
  mesh({buffer, outwards, groups, stride, count}, index) {
    const {gl} = this, array = gl.createVertexArray();
    const made = {
      buffer,
      outwards,
      groups,
      stride,
      array,
      indices: index && gl.createBuffer(),
      count: index ? index.length : count
    };
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    let at = 0;
    groups.forEach((size, location) => {
      gl.enableVertexAttribArray(location);
      gl.vertexAttribPointer(location, size, gl.FLOAT, false, 4 * stride, 4 * at);
      at += size;
    });
    // Without `outwards`, the normals (the second group) are used.
    if (outwards) gl.bindBuffer(gl.ARRAY_BUFFER, outwards);
    gl.enableVertexAttribArray(groups.length);
    gl.vertexAttribPointer(groups.length, 3, gl.FLOAT, false, outwards ? 0 : 4 * stride, outwards ? 0 : 4 * groups[0]);
    if (index) {
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, made.indices);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, index, gl.STATIC_DRAW);
    }
    gl.bindVertexArray(null);
    return made;
  }
  /** Deletes the mesh of a part; its shared corners stay. */
  dropMesh({array, indices}) {
    this.gl.deleteVertexArray(array);
    this.gl.deleteBuffer(indices);
  }
  /** A mesh of skin.js; without `outwards` it moves along its normals. */
  skin(data, index = null, outwards = null) { return this.vertices(data, [3, 3, 3, 1], index, outwards); }
  /** Draws the whole mesh, or a number of corners without an index. */
  draw({array, indices, count}, first = 0, some = count) {
    const {gl} = this;
    gl.bindVertexArray(array);
    if (indices) gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    else gl.drawArrays(gl.TRIANGLES, first, some);
  }
}
