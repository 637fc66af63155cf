// The view: bodies in their setting, their knives, the camera, and when to draw again.
import {boxOfPoints} from './body.js';
import {Camera} from './camera.js';
import {FrameBudget, restMs} from './frame_budget.js';
import {Knife} from './knives.js';
import {M, V} from './linear.js';
import {say, sorry} from './messages.js';

export const mostKnives = 4;

/** The pixels of a canvas on the page. */
function sizeOf(canvas) {
  const scale = Math.min(2, window.devicePixelRatio || 1);
  return {
    width: Math.max(1, Math.round(canvas.clientWidth * scale)),
    height: Math.max(1, Math.round(canvas.clientHeight * scale))
  };
}
/** Reduces the pixels along each side by a divisor. */
export function fitCanvas(canvas, divisor) {
  const size = sizeOf(canvas), width = Math.ceil(size.width / divisor), height = Math.ceil(size.height / divisor);
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
}

export class PageView {
  /** `setting`: bodies, size of a body, setKnives(), arrange(apart, open). */
  constructor(canvas, picture) {
    this.canvas = canvas;
    this.picture = picture;
    this.camera = new Camera();
    this.setting = null;
    this.knives = [];
    this.apart = 0;
    this.open = 0;
    this.wantedApart = 0;
    this.wantedOpen = 0;
    this.dark = false;
    this.draws = false;
    this.settled = false;
    this.failed = false;
    this.asked = false;
    this.stale = true;
    this.rough = false;
    this.hasMoved = false;
    this.lastMoved = 0;
    this.bounds = null;
    this.pace = new FrameBudget(picture.card);
    this.calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
    /** Callbacks for changed knives and for drawn frames. */
    this.onKnives = this.onFrame = () => {};
  }
  get bodies() { return this.setting.bodies; }
  get knife() { return this.knives[this.knives.length - 1]; }
  /** The body with the handles of the knife. */
  get first() { return this.bodies[0]; }

  /**
   * While a page opens, a software renderer draws nothing fine: it would delay the first view. Frame times are not
   * measured, because they include compilation.
   */
  beginOpening() { this.pace.measures = false; }
  endOpening() {
    this.pace.measures = true;
    this.ask();
  }

  // ---- Drawing after changes. ----

  ask() {
    if (this.asked || this.failed) return;
    this.asked = true;
    requestAnimationFrame(() => {
      this.asked = false;
      if (this.pace.isBusy()) return this.ask();
      try {
        this.frame();
      } catch (error) {
        this.failed = true;
        sorry(`The fruit cannot be drawn: ${error.message}`);
        throw error;
      }
    });
  }
  moved() {
    this.lastMoved = performance.now();
    this.hasMoved = this.stale = true;
    this.ask();
  }
  changed() {
    this.stale = true;
    this.ask();
  }

  /** The width and height of the picture at rest, in pixels. */
  get size() { return sizeOf(this.canvas); }
  get aspect() {
    const {width, height} = this.size;
    return width / height;
  }
  arrange() {
    const {setting, camera} = this;
    setting.arrange(this.apart, this.open);
    const outline = this.bodies.flatMap((body) => body.outline), {aspect} = this;
    this.bounds = boxOfPoints(outline);
    Object.assign(camera, camera.fit(outline, aspect));
  }
  get span() { return Math.max(...V.sub(this.bounds.high, this.bounds.low)); }
  view() { return this.camera.view(this.aspect, 2 * Math.max(this.span, this.setting.size)); }
  /** Draws the picture as at rest, or roughly as during motion. */
  sceneNow(rough = false) {
    fitCanvas(this.canvas, rough ? this.pace.divisor : 1);
    return this.scene(rough);
  }
  scene(rough) {
    const {camera, bounds, dark, setting} = this;
    return {
      bodies: this.bodies,
      bounds,
      dark,
      rough,
      size: setting.size,
      camera: {view: this.view(), eye: camera.eye, yaw: camera.yaw}
    };
  }

  /** Advances animations. */
  moveOn() {
    let moves = false;
    for (const [now, wanted] of [['apart', 'wantedApart'], ['open', 'wantedOpen']]) {
      const way = this[wanted] - this[now];
      if (way === 0) continue;
      this[now] = this.calm || Math.abs(way) < 0.004 ? this[wanted] : this[now] + 0.16 * way;
      moves = true;
    }
    if (moves) {
      this.arrange();
      this.lastMoved = performance.now();
    }
    return moves;
  }
  /**
   * True if nothing has moved since the last frame. Time alone does not tell: during a drag, frames of a slow card are
   * farther apart than the rest time.
   */
  isRough(moves, now) {
    const {picture, pace} = this, rests = !moves && !this.hasMoved && now - this.lastMoved > restMs;
    return pace.divisor > 1 && !(rests && pace.measures && picture.isReady(this.bodies));
  }
  /** `rough` overrides whether the frame is drawn roughly. */
  frame(rough = null) {
    if (!this.setting) return;
    const {picture, camera, pace} = this, begun = performance.now(), moves = this.moveOn();
    if (rough === null) rough = this.isRough(moves, begun);
    const scale = this.size.height / (2 * Math.tan(camera.field / 2) * camera.far / camera.zoom);
    let more = false, changed = false, waited = begun - this.lastMoved > 150;
    for (const body of this.bodies) {
      const wanted =
        Math.max(512, Math.min(2048, Math.ceil(2.1 * body.frame.reach * M.scaleOf(body.place) * scale / 128) * 128));
      const done = body.faces.update(wanted, waited, rough);
      // Refine one body at a time.
      if (done.more) waited = false;
      more = more || done.more;
      changed = changed || done.changed;
    }
    if (this.stale || changed || moves || this.rough && !rough) {
      this.hasMoved = false;
      this.rough = rough;
      picture.draw(this.sceneNow(rough));
      pace.gave(rough ? pace.divisor : 1, begun);
    }
    this.stale = false;
    this.onFrame();
    this.settled =
      this.bodies.every((body) => body.fruit.ready || body.knives.length === 0) && !moves && !more && !this.rough;
    if (moves || more || this.rough) this.ask();
  }
  /** Draws everything at once at the finest level. */
  finish() {
    this.stale = true;
    do {
      this.lastMoved = -1e9;
      this.frame(false);
    } while (!this.settled);
  }

  // ---- Knives. ----

  /** `from`: the camera afterwards: fitted to the contents, unchanged, or in front of the last knife's face. */
  takeKnives(knives, from = 'fit') {
    const {camera} = this, before = {target: camera.target, far: camera.far};
    this.knives = knives;
    this.setting.setKnives(knives);
    if (from === 'face') this.turnToFace();
    this.arrange();
    if (from === 'kept') Object.assign(camera, before);
    this.onKnives();
    this.moved();
  }
  /** Opens a whole fruit; without a knife it adds one. */
  setKnives(knives, {open = this.wantedOpen, from = 'fit'} = {}) {
    const first = this.knives.length === 0;
    this.wantedOpen = knives.length === 1 ? open : 0;
    this.wantedApart = knives.length === 0 ? 0 : first || this.wantedApart < 0.05 ? 0.36 : this.wantedApart;
    if (this.calm) {
      this.apart = this.wantedApart;
      this.open = this.wantedOpen;
    }
    this.takeKnives(knives, from);
    this.sayPieces();
  }
  sayPieces() {
    const names = ['whole', 'one cut', 'two cuts', 'three cuts', 'four cuts'], pieces = this.first.pieces.length;
    const each = this.bodies.length > 1 ? ' each' : '';
    say(
      this.knives.length === 0 ? 'whole'
                               : `${names[this.knives.length]}, ${pieces} piece${pieces === 1 ? '' : 's'}${each}`);
  }
  /** Makes one flat cut and opens the halves. */
  cutOnce(turn, tilt) { this.setKnives([new Knife(this.first.frame, turn, tilt, 0)], {open: 1, from: 'face'}); }
  cutAgain() {
    const {knife} = this, {frame} = this.first;
    if (!knife || this.knives.length >= mostKnives) return;
    const steep = Math.abs(knife.tilt) > 0.8;
    const next = knife.drawn ? new Knife(frame, 0, 0, 0)
                             : new Knife(frame, knife.turn + (steep ? 0 : Math.PI / 2), steep ? 0 : knife.tilt, 0);
    this.setKnives([...this.knives, next]);
  }
  undo() {
    if (this.knives.length > 0) this.setKnives(this.knives.slice(0, -1));
  }
  changeKnife(change) {
    const {knife} = this, {size} = this.first.frame;
    if (!knife || knife.drawn) return;
    const changed = knife.copy();
    change(changed);
    changed.laid = null;
    changed.shift = Math.max(-0.5, Math.min(0.5, changed.shift / size)) * size;
    changed.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, changed.tilt));
    changed.turn = Math.atan2(Math.sin(changed.turn), Math.cos(changed.turn));
    this.takeKnives([...this.knives.slice(0, -1), changed], 'kept');
    this.sayPieces();
  }
  pullApart(value) {
    this.apart = this.wantedApart = value;
    if (value > 0) this.wantedOpen = 0;
    this.arrange();
    this.onKnives();
    this.moved();
  }
  layOpen(open = this.wantedOpen < 0.5 ? 1 : 0) {
    if (this.knives.length !== 1) return;
    this.wantedOpen = open;
    if (open) this.lookAtFace();
    this.onKnives();
    this.moved();
  }

  // ---- The camera. ----

  /** Looks at the face of the last knife, slightly from above and from the side. */
  turnToFace() {
    const {knife, camera} = this;
    if (!knife) return;
    const {n} = knife.frame, level = Math.hypot(n[0], n[2]);
    camera.yaw = level > 0.3 && this.bodies.length === 1 ? Math.atan2(n[0], n[2]) + 0.1 : 0.1;
    camera.pitch = Math.max(0.26, Math.min(0.95, Math.asin(Math.abs(n[1])) * 0.62 + 0.22));
  }
  lookAtFace() {
    if (!this.knife) return;
    this.turnToFace();
    this.arrange();
    this.moved();
  }
  orbit(yaw, pitch) {
    const {camera} = this;
    camera.yaw += yaw;
    camera.pitch = Math.max(-0.25, Math.min(1.5, camera.pitch + pitch));
    this.moved();
  }
  zoom(by) {
    this.camera.zoom = Math.max(0.5, Math.min(6, this.camera.zoom * by));
    this.moved();
  }

  /** What is at a place of the canvas, in pixels: {body, part, cut}, or null. */
  at(x, y) { return this.picture.pick(this.scene(false), x / this.canvas.clientWidth, y / this.canvas.clientHeight); }
}
