// A studio and a browser that has it open: what tests and the pictures of docs/guides/studio.md work with.
import {spawn} from 'node:child_process';

/** {process, address, end(signal)} */
export async function startStudio(program, words, folder) {
  const child = spawn(program, ['studio', ...words], {cwd: folder, stdio: ['ignore', 'pipe', 'inherit']});
  const address = await new Promise((resolve, reject) => {
    let text = '';
    child.stdout.on('data', (data) => {
      text += data;
      if (text.includes('\n')) resolve(text.trim());
    });
    child.on('exit', (code) => reject(new Error(`the studio ended with ${code}`)));
  });
  return {
    process: child,
    address,
    end: (signal = 'SIGKILL') => new Promise((done) => {
      child.on('exit', done);
      child.kill(signal);
    })
  };
}

export class Session {
  constructor(tab) {
    this.tab = tab;
    this.faults = [];
    this.strangers = [];
  }

  static async open(browser, address, {width = 1280, height = 800, dark = false} = {}) {
    const tab = await browser.newPage(), session = new Session(tab), origin = new URL(address).origin;
    await tab.setViewport({width, height});
    await tab.emulateMediaFeatures([{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'}]);
    tab.on('pageerror', (error) => session.faults.push(error.message));
    tab.on('console', (message) => {
      if (message.type() === 'error' && !/Failed to load resource/.test(message.text()))
        session.faults.push(message.text());
    });
    tab.on('request', (request) => {
      if (!request.url().startsWith(origin) && !/^(blob|data):/.test(request.url()))
        session.strangers.push(request.url());
    });
    await tab.goto(address);
    await tab.waitForFunction('window.studio && studio.drawing && studio.loads.section', {timeout: 120000});
    return session;
  }
  evaluate(code, ...rest) { return this.tab.evaluate(code, ...rest); }

  /** Until nothing is on its way: sections, the fruit, what is kept. */
  async settled({fruit = true} = {}) {
    const quiet = '!studio.unsent && !studio.dragging && ' +
      '![studio.sections, studio.assets, studio.sending].some((one) => one.busy)';
    const shown = '(!studio.view || ' +
      'studio.view.shown === studio.view.number && studio.view.shown > 0 && studio.view.settled)';
    await this.tab.waitForFunction(fruit ? `${quiet} && ${shown}` : quiet, {timeout: 180000, polling: 100});
  }
  async clear() { await this.evaluate('studio.loads.section = 0'); }

  /** The fruit that the studio shows, as the bytes of a .pomona. */
  async asset() {
    return Buffer.from(
      await this.evaluate(
        `(async () => { const b = await studio.server.bytes('/api/asset', studio.wanted(studio.texts, {final: true}));
          let t = ''; for (const c of b) t += String.fromCharCode(c); return btoa(t); })()`),
      'base64');
  }
  /** Control and S, until all is saved. */
  async save() {
    await this.tab.keyboard.down('Control');
    await this.tab.keyboard.press('s');
    await this.tab.keyboard.up('Control');
    await this.tab.waitForFunction('document.getElementById("save").disabled', {timeout: 20000});
  }

  /** Where a place of the page of the drawing is in the window. */
  where(view, place) {
    return this.evaluate((name, p) => {
      const pane = window.studio.panes[name], box = pane.root.getBoundingClientRect(), [x, y] = pane.onScreen(p);
      return [x + box.left, y + box.top];
    }, view, place);
  }
  /** Nodes of a curve, on the page. */
  nodes(view, name) {
    return this.evaluate(
      (v, n) => window.studio.drawing.curves.find((c) => c.view === v && c.name === n).parts[0].nodes.map(({p}) => p),
      view, name);
  }
  select(view, name) {
    return this.evaluate(
      (v, n) => window.studio.select(window.studio.drawing.curves.find((c) => c.view === v && c.name === n)), view,
      name);
  }
  async dragNode(view, name, index, by, steps = 6) {
    await this.select(view, name);
    const [p] = (await this.nodes(view, name)).slice(index).slice(0, 1);
    const from = await this.where(view, p), to = await this.where(view, [p[0] + by[0], p[1] + by[1]]);
    await this.tab.mouse.move(...from);
    await this.tab.mouse.down();
    for (let i = 1; i <= steps; ++i)
      await this.tab.mouse.move(from[0] + (to[0] - from[0]) * i / steps, from[1] + (to[1] - from[1]) * i / steps);
    await this.tab.mouse.up();
  }
  /** The mouse pressed at the first of some places in the window, drawn over the others, and let go. */
  async stroke(places) {
    const {mouse} = this.tab, [first, ...rest] = places;
    await mouse.move(...first);
    await mouse.down();
    for (const place of rest) await mouse.move(...place, {steps: 4});
    await mouse.up();
  }
  /**
   * Where a surface's curve is in the window, from one place along it to another, `beside` pixels to the outside (or,
   * negative, the inside).
   */
  along(view, name, from, to, beside, count = 6) {
    return this.evaluate((v, n, a, b, d, steps) => {
      const {panes, brush} = window.studio, pane = panes[v], box = pane.root.getBoundingClientRect();
      const line = brush.lines(v).find(({surface}) => surface.name === n), sign = line.frontRight ? 1 : -1;
      return Array.from({length: steps + 1}, (_, k) => {
        const t = a + (b - a) * k / steps;
        const i = line.places.findIndex(
          (place, j) =>
            j > 0 && (place - t) * (line.places[j - 1] - t) <= 0 && Math.abs(place - line.places[j - 1]) < 0.5);
        const [p, q] = [line.points[i - 1], line.points[i]].map((point) => pane.onScreen(point));
        const long = Math.hypot(q[0] - p[0], q[1] - p[1]) || 1;
        return [p[0] + box.left - sign * d * (q[1] - p[1]) / long, p[1] + box.top + sign * d * (q[0] - p[0]) / long];
      });
    }, view, name, from, to, beside, count);
  }
  /** What is painted on a side: {ground, coats}, each ramp as [[place, colour or share], ...]. */
  paintOn(name, which) {
    return this.evaluate((n, w) => {
      const {drawing, modules: {hexOf, sideOf}} = window.studio;
      const side = sideOf(drawing.tree, drawing.surfaces.findIndex((s) => s.name === n), w);
      const told = (ramp) =>
        ramp && ramp.node && ramp.stops.map(({at, value}) => [at, Array.isArray(value) ? hexOf(value) : value]);
      return {
        ground: told(side.ground.along),
        coats: side.coats.map(
          ({color, along, turn, around}) =>
            ({color: told(color), along: told(along), turn: told(turn), around: told(around)}))
      };
    }, name, which);
  }
  /** The colours of the section under the drawing at a place of the page: [r, g, b, a]. */
  sectionAt(view, place) {
    return this.evaluate((name, p) => {
      const {A} = window.studio.modules, {section} = window.studio.panes[name];
      const [x, y] = A.point(A.inverse(section.placement), p).map(Math.floor);
      return [...section.canvas.getContext('2d').getImageData(x, y, 1, 1).data];
    }, view, place);
  }
}
