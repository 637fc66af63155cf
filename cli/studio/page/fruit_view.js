// The fruit, cut live: the page's own picture (render/page), updated when the drawing changes.
import {Body, boxOfPoints, Shape} from '../../../render/page/body.js';
import {Camera} from '../../../render/page/camera.js';
import {FruitTextures} from '../../../render/page/fruit_textures.js';
import {Knife} from '../../../render/page/knives.js';
import {fitCanvas} from '../../../render/page/page_view.js';
import {Picture} from '../../../render/page/picture.js';

const glassShader = `
uniform mat4 camera;
#ifdef VERTEX
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;
uniform vec3 eye;
out vec4 tint;
void main() {
  float facing = abs(dot(normalize(eye - position), normal));
  tint = vec4(color, mix(0.5, 0.1, facing));
  gl_Position = camera * vec4(position, 1.0);
}
#endif
#ifdef FRAGMENT
in vec4 tint;
out vec4 result;
void main() {
  vec3 c = mix(12.92 * tint.rgb, 1.055 * pow(max(tint.rgb, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, tint.rgb));
  result = vec4(c * tint.a, tint.a);
}
#endif
`;

export class FruitView {
  constructor(canvas, options, workerText, {changed, failed}) {
    this.canvas = canvas;
    this.changed = changed;
    this.failed = failed;
    this.camera = new Camera();
    this.mode = 'half';
    this.shift = 0;
    this.number = 0;
    this.shown = 0;
    this.body = null;
    this.lastMoved = 0;
    this.dark = false;
    this.picture = new Picture(canvas, options);
    if (!this.picture.gl) {
      failed('The fruit is drawn with WebGL 2, which this browser does not have or has switched off.');
      return;
    }
    this.picture.card.shaders['glass.glsl'] = glassShader;
    this.glassProgram = this.picture.card.program('glass.glsl', []);
    this.worker = new Worker(URL.createObjectURL(new Blob([workerText], {type: 'text/javascript'})));
    this.worker.onmessage = ({data}) => {
      if (data.error) failed(`The fruit cannot be unpacked: ${data.error}`);
      else this.take(data);
    };
    Object.assign(this.camera, {yaw: 0.35, pitch: 0.3});
    this.attach();
    new ResizeObserver(() => this.rearrange()).observe(canvas);
  }

  /** Shows an asset; of several in quick succession only the last. */
  show(bytes) {
    if (this.worker) this.worker.postMessage({bytes, number: ++this.number}, [bytes.buffer]);
  }

  take({number, header, skin, outwards, glass, rest}) {
    if (number < this.shown) return;
    this.shown = number;
    this.forget();
    const {picture} = this, fruit = new FruitTextures(picture.card, header);
    this.body = new Body(picture, fruit, new Shape(picture.card, skin, null, outwards));
    // There is no time for them while every stroke redraws the fruit.
    this.body.faces.withDetails = false;
    fruit.takeRest(rest);
    this.body.takeSamples(rest.winding);
    this.body.takeSpared(fruit.spared);
    this.glass = picture.card.vertices(glass, [3, 3, 3, 1]);
    this.setCut(this.mode);
    this.changed();
  }
  /** Frees the textures of the previous fruit. */
  forget() {
    const {body, picture: {gl}} = this;
    if (!body) return;
    body.faces.drop();
    const {grid, cell, list, triangle, guide, shares, look} = body.fruit;
    for (const {texture} of [grid, cell, list, triangle, guide, shares, ...Object.values(look)])
      gl.deleteTexture(texture);
    for (const {array} of [body.mesh, this.glass]) gl.deleteVertexArray(array);
  }

  // ---- What is shown. ----

  /** "whole", "glass", "half" or "across". */
  setCut(mode) {
    this.mode = mode;
    const {body} = this;
    if (!body) return;
    const {frame} = body;
    const knife = mode === 'half' ? new Knife(frame, 0, 0, 0)
      : mode === 'across'         ? new Knife(frame, 0, Math.PI / 2, 0)
                                  : null;
    if (knife) knife.shift = this.shift * 0.5 * frame.size;
    body.setKnives(knife ? [knife] : []);
    this.rearrange();
  }
  setShift(shift) {
    this.shift = shift;
    this.setCut(this.mode);
  }
  rearrange() {
    const {body, camera} = this;
    if (!body) return;
    body.arrange(0, body.knives.length === 1 ? 1 : 0);
    const {zoom} = camera, aspect = this.fitCanvas();
    Object.assign(camera, camera.fit(body.outline, aspect), {zoom});
    this.moved();
  }
  fitCanvas() {
    fitCanvas(this.canvas, 1);
    return this.canvas.width / this.canvas.height;
  }
  moved() {
    this.lastMoved = performance.now();
    this.stale = true;
    this.ask();
  }
  ask() {
    if (this.asked || this.broken) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      try {
        this.frame();
      } catch (error) {
        this.broken = true;
        this.failed(`The fruit cannot be drawn: ${error.message}`);
      }
    });
  }
  frame() {
    const {picture, camera, body} = this;
    if (!body) return;
    const {size, reach} = body.frame, view = camera.view(this.fitCanvas(), 2 * size);
    if (this.mode === 'glass') {
      if (this.stale) this.drawGlass(view);
      this.stale = false;
      this.settled = true;
      return;
    }
    const scale = this.canvas.height / (2 * Math.tan(camera.field / 2) * camera.far / camera.zoom);
    const wanted = Math.max(256, Math.min(2048, Math.ceil(2.1 * reach * scale / 128) * 128));
    const {more, changed} = body.faces.update(wanted, performance.now() - this.lastMoved > 250);
    const bounds = boxOfPoints(body.outline);
    if (this.stale || changed)
      picture.draw({bodies: [body], bounds, size, dark: this.dark, camera: {view, eye: camera.eye, yaw: camera.yaw}});
    this.stale = false;
    this.settled = !more;
    if (more) this.ask();
  }
  /** All surfaces, transparent (paper, Figure 9). */
  drawGlass(view) {
    const {gl, card, passes: {empty}} = this.picture, u = card.use(this.glassProgram);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, this.canvas.width, this.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.disable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.uniformMatrix4fv(u.camera, false, view);
    gl.uniform3fv(u.eye, this.camera.eye);
    gl.bindVertexArray(this.glass.array);
    gl.drawArrays(gl.TRIANGLES, 0, this.glass.count);
    gl.bindVertexArray(empty);
    gl.disable(gl.BLEND);
  }

  attach() {
    const {canvas, camera} = this;
    let last = null;
    canvas.addEventListener('pointerdown', (event) => {
      canvas.setPointerCapture(event.pointerId);
      last = [event.clientX, event.clientY];
    });
    canvas.addEventListener('pointermove', (event) => {
      if (!last) return;
      this.turn(-(event.clientX - last[0]) / 160, (event.clientY - last[1]) / 160);
      last = [event.clientX, event.clientY];
    });
    for (const end of ['pointerup', 'pointercancel'])
      canvas.addEventListener(end, () => {
        last = null;
      });
    canvas.addEventListener('wheel', (event) => {
      event.preventDefault();
      camera.zoom = Math.max(0.5, Math.min(6, camera.zoom * Math.exp(-event.deltaY / 900)));
      this.moved();
    }, {passive: false});
    canvas.addEventListener('keydown', (event) => {
      const way = {ArrowLeft: [0.12, 0], ArrowRight: [-0.12, 0], ArrowUp: [0, 0.12], ArrowDown: [0, -0.12]}[event.key];
      if (way) {
        event.preventDefault();
        event.stopPropagation();
        this.turn(...way);
      }
    });
  }
  turn(yaw, pitch) {
    this.camera.yaw += yaw;
    this.camera.pitch = Math.max(-0.25, Math.min(1.5, this.camera.pitch + pitch));
    this.moved();
  }
}
