// The look-up in every language it is written in, against the C++ field: GLSL by three.js, HLSL through glslang and
// SPIRV-Cross, Godot's by way of GLSL (no Godot that knows 3D textures runs without a display), WGSL by WebGPU where
// Chromium has it without a graphics card, else as far as a compiler checks it.
//   node look_ups.mjs FOLDER NAME [GLB [PICTURE.png]]     FOLDER: what write_sections has left; GLB: the fruit,
//   cuttable
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {basename, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';

import {launch} from './browser.mjs';
import {errorsOf, holds, line, readSections, srgb} from './section_errors.mjs';
import {served} from './served.mjs';

const [folder, name, glb, picture] = process.argv.slice(2);
const root = resolve(fileURLToPath(import.meta.url), '../../..');
const engines = join(root, 'render/page/engines');
const translated = mkdtempSync(join(tmpdir(), 'look-'));
execFileSync('python3', [join(engines, 'translate_look.py'), translated]);
const text = (file) => readFileSync(join(translated, file), 'utf8');
const square = readSections(folder, name)[0], {size, origin, u, v, reach} = square;

/** Each language's frame around the look-up: a pixel's place in the square, and its colour as bytes of sRGB. */
const encoded = (vec) => `${vec} encoded(${vec} c) { return mix(12.92 * c, 1.055 * pow(max(c, ${vec}(0.0)), ${
  vec}(1.0 / 2.4)) - 0.055, step(${vec}(0.0031308), c)); }`;
const glslMain = `uniform vec4 square_origin, square_u, square_v;
  ${encoded('vec3')}
  out vec4 shown;
  void main() {
    vec3 color;
    int part;
    bool inside = pomona_look(square_origin.xyz + gl_FragCoord.x * square_u.xyz + gl_FragCoord.y * square_v.xyz,
      color, part);
    shown = inside ? vec4(encoded(color), 1.0) : vec4(0.0);
  }`;
const glslHead = '#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler3D;\n' +
  'precision highp usampler3D;\nprecision highp usampler2D;\n';

/** Godot's hints are no part of GLSL; all else is. */
const ofGodot = () => glslHead + text('look.gdshaderinc').replace(/^(uniform \w+ \w+) : [^;]*;/gm, '$1;') + glslMain;

function ofHlsl() {
  const made = mkdtempSync(join(tmpdir(), 'look-'));
  try {
    writeFileSync(join(made, 'look.frag.hlsl'), `${text('look.hlsl')}
      cbuffer square { float4 square_origin; float4 square_u; float4 square_v; };
      float3 encoded(float3 c) { return lerp(12.92 * c, 1.055 * pow(max(c, 0.0), 1.0 / 2.4) - 0.055, step(0.0031308,
        c)); }
      float4 main(float4 at : SV_Position) : SV_Target {
        float3 color;
        int part;
        bool inside = pomona_look(square_origin.xyz + at.x * square_u.xyz + at.y * square_v.xyz, color, part);
        return inside ? float4(encoded(color), 1.0) : float4(0.0, 0.0, 0.0, 0.0);
      }`);
    const run = (program, ...words) => execFileSync(program, words, {cwd: made, encoding: 'utf8'});
    run(
      'glslangValidator', '-D', '-V', '--auto-map-bindings', '--auto-map-locations', '-S', 'frag', '-e', 'main', '-o',
      'look.spv', 'look.frag.hlsl');
    return run('spirv-cross', '--es', '--version', '300', 'look.spv');
  } finally { rmSync(made, {recursive: true}); }
}

const wgsl = () => `${text('look.wgsl')}
  struct Square { origin: vec4f, u: vec4f, v: vec4f }
  @group(0) @binding(6) var<uniform> square: Square;
  fn encoded(c: vec3f) -> vec3f { return mix(12.92 * c, 1.055 * pow(max(c, vec3f(0.0)), vec3f(1.0 / 2.4)) - 0.055,
    step(vec3f(0.0031308), c)); }
  @vertex fn corner(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f { return vec4f(f32(i & 1u) * 4.0 - 1.0,
    f32(i >> 1u) * 4.0 - 1.0, 0.0, 1.0); }
  @fragment fn pixel(@builtin(position) at: vec4f) -> @location(0) vec4f {
    let found = pomona_look(square.origin.xyz + at.x * square.u.xyz + at.y * square.v.xyz);
    return select(vec4f(0.0), vec4f(encoded(found.color), 1.0), found.inside);
  }`;

// ---- A page that has the asset, and everything by http. ----

const inEngines = ['three.html', 'three_cut.mjs'], inPage = ['read_asset.js', 'look_up.js', 'look.glsl'];
const files = (path) => {
  const file = basename(path);
  if (path === '/empty.html')
    return '<!doctype html><title>look-ups</title>' +
      '<script type="module">import * as Asset from "./read_asset.js"; import * as LookUp from "./look_up.js"; ' +
      'Object.assign(window, {Asset, LookUp});</script>';
  if (path === '/fruit.pomona') return readFileSync(join(folder, `${name}.pomona`));
  if (path === '/fruit.glb') return readFileSync(glb);
  if (inEngines.includes(file)) return readFileSync(join(engines, file));
  if (inPage.includes(file)) return readFileSync(join(engines, '..', file));
  return null;
};
const {url, close} = await served(files);

/** In the page: the square through a fragment shader of WebGL; uniforms by their names, in blocks or alone. */
async function throughGl(shader, frame) {
  const packed = new Uint8Array(await (await fetch('fruit.pomona')).arrayBuffer());
  const fruit = Asset.decoded(await Asset.unpacked(packed));
  const {grid, cell, list, triangle, low, high} = LookUp.textures(fruit, LookUp.cells(fruit));
  const canvas = new OffscreenCanvas(frame.size, frame.size), gl = canvas.getContext('webgl2');
  const program = gl.createProgram();
  const corners =
    '#version 300 es\nvoid main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, ' +
    '1.0); }';
  for (const [kind, source] of [[gl.VERTEX_SHADER, corners], [gl.FRAGMENT_SHADER, shader]]) {
    const made = gl.createShader(kind);
    gl.shaderSource(made, source);
    gl.compileShader(made);
    if (!gl.getShaderParameter(made, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(made));
    gl.attachShader(program, made);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  gl.useProgram(program);
  const pixels3 = (t, data, format, kind, type, filter) => {
    gl.texImage3D(t, 0, format, ...fruit.count, 0, kind, type, data);
    return filter;
  };
  const textures = {
    grid: [gl.TEXTURE_3D, (t) => pixels3(t, grid, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, gl.LINEAR)],
    cell: [gl.TEXTURE_3D, (t) => pixels3(t, cell, gl.RG32UI, gl.RG_INTEGER, gl.UNSIGNED_INT, gl.NEAREST)],
    list: [
      gl.TEXTURE_2D,
      (t) => {
        gl.texImage2D(t, 0, gl.R32UI, 2048, list.length / 2048, 0, gl.RED_INTEGER, gl.UNSIGNED_INT, list);
        return gl.NEAREST;
      }
    ],
    triangle: [
      gl.TEXTURE_2D,
      (t) => {
        gl.texImage2D(t, 0, gl.RGBA32UI, 4096, triangle.length / 16384, 0, gl.RGBA_INTEGER, gl.UNSIGNED_INT, triangle);
        return gl.NEAREST;
      }
    ],
  };
  const units = Object.fromEntries(Object.entries(textures).map(([key, [target, fill]], unit) => {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(target, gl.createTexture());
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    const filter = fill(target);
    for (const [what, value] of [
           [gl.TEXTURE_MIN_FILTER, filter], [gl.TEXTURE_MAG_FILTER, filter], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
           [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_R, gl.CLAMP_TO_EDGE]])
      gl.texParameteri(target, what, value);
    return [key, unit];
  }));
  const values = {
    pomona_count: fruit.count,
    pomona_low: low,
    pomona_high: high,
    square_origin: frame.origin,
    square_u: frame.u,
    square_v: frame.v
  };
  for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS) - 1; i >= 0; --i) {
    const {name: called} = gl.getActiveUniform(program, i), at = gl.getUniformLocation(program, called);
    if (!at) continue;
    const key = Object.keys(units).find((k) => called.includes(`pomona_${k}`));
    if (key) gl.uniform1i(at, units[key]);
    else if (called === 'pomona_units') gl.uniform1i(at, fruit.units);
    else if (called.startsWith('square')) gl.uniform4f(at, ...values[called], 0);
    else gl.uniform3f(at, ...values[called]);
  }
  const blocks = {
    pomona: () => {
      const b = new ArrayBuffer(48), f = new Float32Array(b);
      f.set(fruit.count);
      new Int32Array(b)[3] = fruit.units;
      f.set(low, 4);
      f.set(high, 8);
      return b;
    },
    square: () => {
      const f = new Float32Array(12);
      f.set(frame.origin);
      f.set(frame.u, 4);
      f.set(frame.v, 8);
      return f.buffer;
    },
  };
  for (let i = gl.getProgramParameter(program, gl.ACTIVE_UNIFORM_BLOCKS) - 1; i >= 0; --i) {
    const called = gl.getActiveUniformBlockName(program, i), key = called.includes('square') ? 'square' : 'pomona';
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.UNIFORM_BUFFER, buffer);
    gl.bufferData(gl.UNIFORM_BUFFER, blocks[key](), gl.STATIC_DRAW);
    gl.bindBufferBase(gl.UNIFORM_BUFFER, i, buffer);
    gl.uniformBlockBinding(program, i, i);
  }
  gl.viewport(0, 0, frame.size, frame.size);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const pixels = new Uint8Array(4 * frame.size * frame.size);
  gl.readPixels(0, 0, frame.size, frame.size, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
  if (gl.getError()) throw new Error(`WebGL says ${gl.getError()}`);
  return [...pixels];
}

/** In the page: through WebGPU; null where there is none. */
async function throughGpu(shader, frame) {
  const adapter = navigator.gpu && await navigator.gpu.requestAdapter();
  if (!adapter) return null;
  const device = await adapter.requestDevice(), module = device.createShaderModule({code: shader});
  const wrong = (await module.getCompilationInfo())
                  .messages.filter(({type}) => type === 'error')
                  .map(({message, lineNum}) => `${lineNum}: ${message}`);
  if (wrong.length) throw new Error(wrong.join('\n'));
  const packed = new Uint8Array(await (await fetch('fruit.pomona')).arrayBuffer());
  const fruit = Asset.decoded(await Asset.unpacked(packed));
  const {grid, cell, list, triangle, low, high} = LookUp.textures(fruit, LookUp.cells(fruit));
  const use = GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST;
  const texture = (data, extent, format, dimension, bytes) => {
    const made = device.createTexture({size: extent, format, dimension, usage: use});
    device.queue.writeTexture({texture: made}, data, {bytesPerRow: bytes * extent[0], rowsPerImage: extent[1]}, extent);
    return made.createView();
  };
  const buffer = (data) => {
    const made = device.createBuffer({size: 48, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST});
    device.queue.writeBuffer(made, 0, data);
    return {buffer: made};
  };
  const pomona = new ArrayBuffer(48), floats = new Float32Array(pomona), square = new Float32Array(12);
  floats.set(fruit.count);
  new Int32Array(pomona)[3] = fruit.units;
  floats.set(low, 4);
  floats.set(high, 8);
  square.set(frame.origin);
  square.set(frame.u, 4);
  square.set(frame.v, 8);
  const resources = [
    texture(grid, fruit.count, 'rgba8unorm-srgb', '3d', 4),
    device.createSampler({magFilter: 'linear', minFilter: 'linear'}), texture(cell, fruit.count, 'rg32uint', '3d', 8),
    texture(list, [2048, list.length / 2048], 'r32uint', '2d', 4),
    texture(triangle, [4096, triangle.length / 16384], 'rgba32uint', '2d', 16), buffer(pomona), buffer(square)
  ];
  const pipeline = device.createRenderPipeline({
    layout: 'auto',
    vertex: {module, entryPoint: 'corner'},
    fragment: {module, entryPoint: 'pixel', targets: [{format: 'rgba8unorm'}]}
  });
  const target = device.createTexture({
    size: [frame.size, frame.size],
    format: 'rgba8unorm',
    usage: GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC
  });
  const back =
    device.createBuffer({size: 4 * frame.size * frame.size, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
  const encoder = device.createCommandEncoder();
  const pass = encoder.beginRenderPass(
    {colorAttachments: [{view: target.createView(), loadOp: 'clear', storeOp: 'store', clearValue: [0, 0, 0, 0]}]});
  pass.setPipeline(pipeline);
  pass.setBindGroup(
    0,
    device.createBindGroup(
      {layout: pipeline.getBindGroupLayout(0), entries: resources.map((resource, binding) => ({binding, resource}))}));
  pass.draw(3);
  pass.end();
  encoder.copyTextureToBuffer({texture: target}, {buffer: back, bytesPerRow: 4 * frame.size}, [frame.size, frame.size]);
  device.queue.submit([encoder.finish()]);
  await back.mapAsync(GPUMapMode.READ);
  return [...new Uint8Array(back.getMappedRange())];
}

const browser =
  await launch({flags: ['--enable-unsafe-webgpu', '--use-webgpu-adapter=swiftshader', '--enable-features=Vulkan']});
try {
  const tab = await browser.newPage(), step = 2 * reach / size;
  const frame = {
    size,
    origin: [0, 1, 2].map((k) => origin[k] - reach * (u[k] + v[k])),
    u: u.map((x) => step * x),
    v: v.map((x) => step * x)
  };
  // What three.js draws went through its own materials, and through eight bits once more: a twentieth is allowed for
  // that.
  // It also rounds the centres of pixels elsewhere: on the edge of a seed one may show the other side, whose colour is
  // then between those of the pixels around. Four may.
  const trueColor = (i) => [0, 1, 2].map((k) => srgb(square.truth[4 * i + k]));
  const isAway = (color, i) => Math.max(...trueColor(i).map((c, k) => Math.abs(color[k] - c))) > 20;
  const isAcrossAnEdge = (color, i) => {
    const around = [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => trueColor(i + dy * size + dx)));
    return isAway(color, i) && color.every((c, k) => {
      const values = around.map((beside) => beside[k]);
      return c > Math.min(...values) - 3 && c < Math.max(...values) + 3;
    });
  };
  const held = (language, pixels, allowed = 1) => {
    let across = 0;
    const errors = errorsOf(square, (i) => {
      if (pixels[4 * i + 3] === 0) return null;
      const color = pixels.slice(4 * i, 4 * i + 3);
      if (allowed === 1 || !isAcrossAnEdge(color, i)) return color;
      ++across;
      return trueColor(i);
    });
    assert.ok(across <= 4, `${language}: ${across} pixels are across an edge`);
    console.log(`${language}: ${line(errors)}`);
    assert.ok(
      errors.pixels > 100 && (allowed === 1 ? holds(errors) : errors.rms <= allowed && errors.p95 <= 1.5 * allowed),
      `${language}: a bar is missed`);
  };
  await tab.goto(`${url}/empty.html`);
  await tab.waitForFunction('window.LookUp');
  for (const [language, shader] of [['Godot', ofGodot()], ['HLSL', ofHlsl()]])
    held(language, await tab.evaluate(throughGl, shader, frame));
  const byGpu = await tab.evaluate(throughGpu, wgsl(), frame);
  if (byGpu) held('WGSL', byGpu);
  else console.log('WGSL: no WebGPU here, not run');

  // The sample.
  if (glb) {
    const faults = [];
    tab.on('pageerror', (error) => faults.push(error.message));
    await tab.setViewport({width: 480, height: 400});
    await tab.goto(`${url}/three.html`);
    await tab.waitForFunction('window.cut', {timeout: 120000});
    if (picture) await tab.screenshot({path: picture});
    // The face alone, seen straight on, as large as the square.
    const pixels = await tab.evaluate(({place, half, side}) => {
      const {THREE, renderer, scene, face} = window.cut;
      const camera = new THREE.OrthographicCamera(-half, half, half, -half, 0, 4 * half);
      scene.children.forEach((thing) => {
        thing.visible = thing === face;
      });
      scene.background = null;
      renderer.setClearColor(0, 0);
      face.position.set(...place);
      camera.position.set(place[0], place[1], place[2] + 2 * half);
      renderer.setPixelRatio(1);
      renderer.setSize(side, side);
      renderer.render(scene, camera);
      const gl = renderer.getContext(), read = new Uint8Array(4 * side * side);
      gl.readPixels(0, 0, side, side, gl.RGBA, gl.UNSIGNED_BYTE, read);
      return [...read];
    }, await tab.evaluate(({origin: at, reach: cells, size: side}) => {
      const {origin: low, spacing} = window.cut.fruit.header;
      return {place: at.map((x, k) => low[k] + spacing * x), half: spacing * cells, side};
    }, {origin, reach, size}));
    held('three.js', pixels, 1.05);
    assert.deepEqual(faults, []);
  }
} finally {
  await browser.close();
  close();
  rmSync(translated, {recursive: true});
}
