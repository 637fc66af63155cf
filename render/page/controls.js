// The page: what is there, what hands and keys do to it, and when it is drawn again.
'use strict';
(() => {
  const $ = (id) => document.getElementById(id), canvas = $('view');
  const options = JSON.parse($('options').textContent), picture = new Picture(canvas, options);
  const started = performance.now(), loads = {};
  const calm = matchMedia('(prefers-reduced-motion: reduce)').matches;
  const sorry = (text) => {
    const p = document.createElement('p');
    p.className = 'sorry';
    p.setAttribute('role', 'alert');
    p.textContent = text;
    document.body.append(p);
  };
  if (!picture.gl) return sorry('This page draws the fruit with WebGL 2, which this browser does not have or has switched off.');
  canvas.addEventListener('webglcontextlost', () => sorry('The graphics card has dropped this page. Load it again.'));

  const camera = new Camera(), most = 4;
  const state = {knives: [], apart: 0, open: 0, wantedApart: 0, wantedOpen: 0, dark: false, draws: false};
  let samples = [], pieces = [], arranged = [], lastMoved = 0, failed = false;

  // ---- Drawing, when something has changed. ----

  let asked = false, stale = true;
  const ask = () => {
    if (asked || failed) return;
    asked = true;
    requestAnimationFrame(() => { asked = false; try { frame(); } catch (error) { failed = true; sorry(`The fruit cannot be drawn: ${error.message}`); } });
  };
  const moved = () => { lastMoved = performance.now(); stale = true; ask(); };

  function fitCanvas() {
    const scale = Math.min(2, window.devicePixelRatio || 1), width = Math.max(1, Math.round(canvas.clientWidth * scale)), height = Math.max(1, Math.round(canvas.clientHeight * scale));
    if (canvas.width !== width || canvas.height !== height) { canvas.width = width; canvas.height = height; }
    return width / height;
  }
  function boundsOf(all) {
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (const {motion, points} of all) for (const p of points) {
      const q = M.point(motion, p);
      for (let k = 0; k < 3; ++k) { low[k] = Math.min(low[k], q[k]); high[k] = Math.max(high[k], q[k]); }
    }
    return {low, high};
  }
  function arrange() {
    arranged = placed(pieces, state.knives, picture.fruit, state.apart, state.open);
    const aspect = fitCanvas(), outline = arranged.flatMap(({motion, points}) => points.map((p) => M.point(motion, p)));
    Object.assign(camera, camera.fit(outline, aspect));
  }
  function changedKnives(keepView = false) {
    pieces = piecesOf(samples, state.knives);
    const before = {target: camera.target, far: camera.far};
    arrange();
    if (keepView) Object.assign(camera, before);
    showKnife();
    moved();
  }

  function sceneNow() {
    const aspect = fitCanvas();
    return {knives: state.knives, pieces: arranged, bounds: boundsOf(arranged), dark: state.dark,
      camera: {view: camera.view(aspect, 2 * picture.fruit.size), eye: camera.eye, yaw: camera.yaw}};
  }
  function frame() {
    if (!picture.skin) return;
    // Move on what moves by itself.
    let moves = false;
    for (const [now, wanted] of [['apart', 'wantedApart'], ['open', 'wantedOpen']]) {
      const way = state[wanted] - state[now];
      if (way === 0) continue;
      state[now] = calm || Math.abs(way) < 0.004 ? state[wanted] : state[now] + 0.16 * way;
      moves = true;
    }
    if (moves) { arrange(); lastMoved = performance.now(); }
    const scale = canvas.height / (2 * Math.tan(camera.field / 2) * camera.far / camera.zoom);
    const wanted = Math.max(512, Math.min(2048, Math.ceil(2.1 * picture.fruit.reach * scale / 128) * 128));
    const {more, changed} = picture.updateFaces(state.knives, wanted, performance.now() - lastMoved > 150);
    if (stale || changed || moves) picture.draw(sceneNow());
    stale = false;
    drawBlade();
    if (picture.ready && !loads.cut) loads.cut = performance.now() - started;
    state.settled = picture.ready && !moves && !more;
    if (moves || more) ask();
  }

  // ---- Knives. ----

  const current = () => state.knives[state.knives.length - 1];
  const names = ['whole', 'one cut', 'two cuts', 'three cuts', 'four cuts'];
  function showKnife() {
    const knife = current();
    for (const id of ['shift', 'turn', 'tilt', 'waves']) $(id).disabled = !knife || knife.drawn !== null;
    $('apart').disabled = $('fewer').disabled = !knife;
    $('more').disabled = !knife || state.knives.length >= most;
    $('lay').disabled = state.knives.length !== 1;
    $('lay').setAttribute('aria-pressed', String(state.wantedOpen > 0.5 && state.knives.length === 1));
    $('apart').value = state.wantedApart;
    if (!knife) return;
    $('shift').value = knife.shift / (0.5 * picture.fruit.size);
    $('turn').value = knife.turn * 180 / Math.PI;
    $('tilt').value = knife.tilt * 180 / Math.PI;
    $('waves').value = knife.waves;
  }
  function say(text) { if ($('state').textContent !== text) $('state').textContent = text; }
  function sayPieces() { say(state.knives.length === 0 ? 'whole' : `${names[state.knives.length]}, ${pieces.length} piece${pieces.length === 1 ? '' : 's'}`); }

  /** Opens what was whole; takes one knife where there is none. */
  function setKnives(knives, {open = state.wantedOpen} = {}) {
    const first = state.knives.length === 0;
    state.knives = knives;
    state.wantedOpen = knives.length === 1 ? open : 0;
    state.wantedApart = knives.length === 0 ? 0 : first || state.wantedApart < 0.05 ? 0.36 : state.wantedApart;
    changedKnives();
    sayPieces();
  }
  const plain = (turn, tilt) => { stopDrawing(); setKnives([new Knife(picture.fruit, turn, tilt, 0)], {open: 1}); lookAtFace(); };
  function cutAgain() {
    const knife = current();
    if (!knife || state.knives.length >= most) return;
    const next = knife.drawn ? new Knife(picture.fruit, 0, 0, 0) : new Knife(picture.fruit, knife.turn + (Math.abs(knife.tilt) > 0.8 ? 0 : Math.PI / 2), Math.abs(knife.tilt) > 0.8 ? 0 : knife.tilt, 0);
    setKnives([...state.knives, next]);
  }
  function undo() { if (state.knives.length > 0) setKnives(state.knives.slice(0, -1)); }
  function changeKnife(change) {
    const knife = current();
    if (!knife || knife.drawn) return;
    const changed = knife.copy();
    change(changed);
    changed.shift = Math.max(-0.5, Math.min(0.5, changed.shift / picture.fruit.size)) * picture.fruit.size;
    changed.tilt = Math.max(-Math.PI / 2, Math.min(Math.PI / 2, changed.tilt));
    changed.turn = Math.atan2(Math.sin(changed.turn), Math.cos(changed.turn));
    state.knives = [...state.knives.slice(0, -1), changed];
    changedKnives(true);
    sayPieces();
  }
  function layOpen(open = state.wantedOpen < 0.5 ? 1 : 0) {
    if (state.knives.length !== 1) return;
    state.wantedOpen = open;
    if (open) lookAtFace();
    showKnife();
    moved();
  }
  /** From before the last knife, somewhat from above and from the side. */
  function lookAtFace() {
    const knife = current();
    if (!knife) return;
    const {n} = knife.frame, level = Math.hypot(n[0], n[2]);
    camera.yaw = level > 0.3 ? Math.atan2(n[0], n[2]) + 0.1 : 0.1;
    camera.pitch = Math.max(0.26, Math.min(0.95, Math.asin(Math.abs(n[1])) * 0.62 + 0.22));
    arrange();
    moved();
  }

  // ---- The blade, and what takes hold of it. ----

  const handles = ['move', 'turn', 'tilt'].map((what) => {
    const circle = document.createElementNS('http://www.w3.org/2000/svg', 'circle');
    circle.setAttribute('class', what);
    circle.setAttribute('r', what === 'move' ? 7 : 6);
    circle.style.display = 'none';
    $('overlay').append(circle);
    circle.addEventListener('pointerdown', (event) => {
      event.preventDefault();
      circle.setPointerCapture(event.pointerId);
      circle.last = [event.clientX, event.clientY];
    });
    circle.addEventListener('pointermove', (event) => {
      if (!circle.last) return;
      const [dx, dy] = [event.clientX - circle.last[0], event.clientY - circle.last[1]];
      circle.last = [event.clientX, event.clientY];
      dragKnife(what, dx, dy);
    });
    for (const end of ['pointerup', 'pointercancel']) circle.addEventListener(end, () => { circle.last = null; });
    return circle;
  });
  function motionOfBlade() {
    const k = state.knives.length - 1, piece = arranged.find(({keep}) => keep[k] < 0) || arranged[0];
    return piece.motion;
  }
  function onScreen(p) {
    const view = camera.view(canvas.width / canvas.height, 2 * picture.fruit.size), w = view[3] * p[0] + view[7] * p[1] + view[11] * p[2] + view[15];
    const [x, y] = M.point(view, p);
    return [(x / w * 0.5 + 0.5) * canvas.clientWidth, (0.5 - 0.5 * y / w) * canvas.clientHeight];
  }
  function dragKnife(what, dx, dy) {
    const knife = current(), {origin, n} = knife.frame, motion = motionOfBlade();
    if (what === 'turn') return changeKnife((k) => { k.turn += 0.008 * dx; });
    if (what === 'tilt') return changeKnife((k) => { k.tilt += 0.008 * dy; });
    const step = 0.05 * picture.fruit.size, a = onScreen(M.point(motion, origin)), b = onScreen(M.point(motion, V.add(origin, V.mul(n, step))));
    const way = [b[0] - a[0], b[1] - a[1]], length = Math.hypot(...way);
    // Seen straight on, a plane moves by going up and down.
    const amount = length < 4 ? -0.4 * dy * step / 6 : (dx * way[0] + dy * way[1]) / length ** 2 * step;
    changeKnife((k) => { k.shift += amount; });
  }
  function drawBlade() {
    const knife = current(), shown = knife && !knife.drawn && !state.draws;
    handles.forEach((h) => { h.style.display = shown ? '' : 'none'; });
    $('blade').setAttribute('d', '');
    if (!shown) return;
    const {origin, u, v} = knife.frame, motion = motionOfBlade(), piece = arranged.find(({keep}) => keep[state.knives.length - 1] < 0) || arranged[0];
    // A frame a little larger than the face.
    const along = (way) => 1.1 * Math.max(...piece.points.map((p) => Math.abs(V.dot(V.sub(p, origin), way)))), [a, b] = [along(u), along(v)];
    const at = (s, t) => onScreen(M.point(motion, V.add(origin, V.add(V.mul(u, s * a), V.mul(v, t * b)))));
    const corners = [at(-1, -1), at(1, -1), at(1, 1), at(-1, 1)];
    $('blade').setAttribute('d', `M${corners.map((c) => c.map((x) => x.toFixed(1)).join(' ')).join('L')}Z`);
    [at(-1, -1), at(-1, 0), at(0, 1)].forEach(([x, y], i) => { handles[i].setAttribute('cx', x.toFixed(1)); handles[i].setAttribute('cy', y.toFixed(1)); });
  }

  // ---- A stroke over the fruit. ----

  let stroke = null;
  function stopDrawing() {
    state.draws = false;
    stroke = null;
    $('draw').setAttribute('aria-pressed', 'false');
    canvas.classList.remove('draws');
    $('stroke').setAttribute('d', '');
  }
  function startDrawing() {
    if (state.draws) { stopDrawing(); sayPieces(); return ask(); }
    state.draws = true;
    state.wantedApart = state.wantedOpen = 0;
    $('draw').setAttribute('aria-pressed', 'true');
    canvas.classList.add('draws');
    say('Draw a line over the fruit, right across it.');
    moved();
  }
  function cutAlongStroke() {
    const aspect = canvas.width / canvas.height, {back} = camera.directions, eye = camera.eye, middle = picture.fruit.middle;
    const points = stroke.map(([x, y]) => {
      const ray = camera.ray(2 * x / canvas.clientWidth - 1, 1 - 2 * y / canvas.clientHeight, aspect);
      return V.add(eye, V.mul(ray, V.dot(V.sub(middle, eye), back) / V.dot(ray, back)));
    });
    const knife = points.length > 2 ? Knife.drawnAlong(picture.fruit, points, back) : null;
    stopDrawing();
    if (!knife) { say('That stroke was too short to cut.'); return ask(); }
    setKnives([...state.knives.slice(0, most - 1), knife], {open: 0});
  }

  // ---- Hands. ----

  const held = new Map();
  let pinch = 0;
  canvas.addEventListener('pointerdown', (event) => {
    canvas.setPointerCapture(event.pointerId);
    held.set(event.pointerId, [event.clientX, event.clientY]);
    pinch = 0;
    if (state.draws) stroke = [[event.offsetX, event.offsetY]];
    canvas.classList.add('held');
    $('name').hidden = true;
  });
  canvas.addEventListener('pointermove', (event) => {
    const before = held.get(event.pointerId);
    if (!before) return nameLater(event);
    const dx = event.clientX - before[0], dy = event.clientY - before[1];
    held.set(event.pointerId, [event.clientX, event.clientY]);
    if (state.draws && stroke) {
      stroke.push([event.offsetX, event.offsetY]);
      $('stroke').setAttribute('d', `M${stroke.map((p) => p.join(' ')).join('L')}`);
    } else if (held.size === 2) {
      const [a, b] = [...held.values()], apart = Math.hypot(a[0] - b[0], a[1] - b[1]);
      if (pinch > 0) zoom(apart / pinch);
      pinch = apart;
    } else if (event.shiftKey || event.buttons === 2) {
      dragKnife('move', dx, dy);
    } else {
      orbit(-dx / 160, dy / 160);
    }
  });
  for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, (event) => {
    held.delete(event.pointerId);
    pinch = 0;
    canvas.classList.remove('held');
    if (state.draws && stroke) cutAlongStroke();
  });
  canvas.addEventListener('pointerleave', () => { $('name').hidden = true; });
  canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  canvas.addEventListener('wheel', (event) => { event.preventDefault(); zoom(Math.exp(-event.deltaY / 900)); }, {passive: false});
  function orbit(yaw, pitch) {
    camera.yaw += yaw;
    camera.pitch = Math.max(-0.25, Math.min(1.5, camera.pitch + pitch));
    moved();
  }
  function zoom(by) { camera.zoom = Math.max(0.5, Math.min(6, camera.zoom * by)); moved(); }

  // The part under the pointer, once it has come to rest.
  let naming = 0;
  function nameLater(event) {
    const [x, y] = [event.offsetX, event.offsetY];
    clearTimeout(naming);
    naming = setTimeout(() => {
      if (!picture.skin || held.size > 0) return;
      const found = nameAt(x, y), label = $('name');
      label.hidden = !found;
      if (!found) return;
      label.textContent = found.part.replaceAll('_', ' ');
      label.style.left = `${x}px`;
      label.style.top = `${y}px`;
    }, 60);
  }
  const nameAt = (x, y) => picture.pick(sceneNow(), x / canvas.clientWidth, y / canvas.clientHeight);

  // ---- Sliders, buttons, keys. ----

  const slide = (id, change) => $(id).addEventListener('input', () => change(Number($(id).value)));
  slide('shift', (value) => changeKnife((k) => { k.shift = value * 0.5 * picture.fruit.size; }));
  slide('turn', (value) => changeKnife((k) => { k.turn = value * Math.PI / 180; }));
  slide('tilt', (value) => changeKnife((k) => { k.tilt = value * Math.PI / 180; }));
  slide('waves', (value) => changeKnife((k) => { k.waves = value; }));
  slide('apart', (value) => { state.apart = state.wantedApart = value; if (value > 0) state.wantedOpen = 0; arrange(); showKnife(); moved(); });
  const setDark = (dark) => {
    state.dark = dark;
    document.documentElement.classList.toggle('dark', dark);
    $('dark').setAttribute('aria-pressed', String(dark));
    layPaper();
    stale = true;
    ask();
  };
  const half = () => plain(0, 0), across = () => plain(0, Math.PI / 2), toggleDark = () => setDark(!state.dark);
  for (const [id, act] of Object.entries({half, across, draw: startDrawing, more: cutAgain, fewer: undo, lay: () => layOpen(), dark: toggleDark})) $(id).addEventListener('click', act);
  const nudge = (change) => () => changeKnife(change), step = () => 0.01 * picture.fruit.size;
  const keys = {
    ArrowLeft: () => orbit(0.12, 0), ArrowRight: () => orbit(-0.12, 0), ArrowUp: () => orbit(0, 0.12), ArrowDown: () => orbit(0, -0.12),
    '+': () => zoom(1.12), '=': () => zoom(1.12), '-': () => zoom(1 / 1.12), h: half, x: across, b: startDrawing, c: cutAgain, Backspace: undo, l: toggleDark, ' ': () => layOpen(),
    w: nudge((k) => { k.shift += step(); }), s: nudge((k) => { k.shift -= step(); }), a: nudge((k) => { k.turn -= 0.06; }), d: nudge((k) => { k.turn += 0.06; }),
    q: nudge((k) => { k.tilt -= 0.06; }), e: nudge((k) => { k.tilt += 0.06; }), Escape: () => { if (state.draws) startDrawing(); },
  };
  window.addEventListener('keydown', (event) => {
    const act = keys[event.key] || keys[event.key.toLowerCase()];
    const onControl = event.target.matches && event.target.matches('input') || event.target.matches && event.target.matches('button') && event.key === ' ';
    if (!act || onControl || event.ctrlKey || event.metaKey || event.altKey || !picture.skin) return;
    event.preventDefault();
    act();
  });
  window.addEventListener('resize', () => { if (picture.skin) { arrange(); moved(); } });

  /** The paper: a tile of soft grain behind everything. */
  function layPaper() {
    const light = options.style.paper, tile = document.createElement('canvas'), size = 192, grain = 255 * 2.2 * options.style.grain * (state.dark ? 0.5 : 1);
    document.documentElement.style.setProperty('--paper', state.dark ? '#211e1b' : light);
    tile.width = tile.height = size;
    const context = tile.getContext('2d'), image = context.createImageData(size, size);
    let seed = 1;
    const noise = Float32Array.from({length: size * size}, () => { seed = Math.imul(seed, 1664525) + 1013904223 >>> 0; return seed / 2 ** 32 - 0.5; });
    for (let i = 0; i < size * size; ++i) {
      const x = i % size, near = noise[i] + noise[i - x + (x + 1) % size] + noise[(i + size) % (size * size)], v = grain * near * 0.5;
      image.data.set([v > 0 ? 255 : 40, v > 0 ? 255 : 30, v > 0 ? 255 : 20, Math.min(255, Math.abs(v) * 1.6)], 4 * i);
    }
    context.putImageData(image, 0, 0);
    document.body.style.backgroundImage = grain > 0 ? `url(${tile.toDataURL()})` : 'none';
  }

  // ---- From the worker. ----

  function takeSkin({header, skin}) {
    picture.takeSkin(header, skin);
    samples = samplesOf(header, skin, null);
    Object.assign(camera, {yaw: 0.35, pitch: 0.3});
    state.knives = options.cuts.map(({normal, offset}) => {
      const inCells = (offset - V.dot(normal, header.origin)) / header.spacing;
      return Knife.ofPlane(picture.fruit, normal, inCells);
    });
    const late = state.knives;
    state.knives = [];
    changedKnives();
    state.knives = late;
    $('tools').hidden = false;
    state.knives = [];
    arrange();
    frame();
    picture.gl.finish();
    loads.skin = performance.now() - started;
    state.first = late;
    showKnife();
  }
  function takeRest(rest) {
    picture.takeRest(rest);
    samples = samplesOf(picture.header, picture.skinData, rest.winding);
    const knives = state.first;
    if (knives.length > 0) {
      setKnives(knives, {open: knives.length === 1 ? 1 : 0});
      if (calm) { state.apart = state.wantedApart; state.open = state.wantedOpen; }
      lookAtFace();
    } else {
      changedKnives();
      sayPieces();
    }
    frame();
    picture.gl.finish();
    loads.cut = performance.now() - started;
  }

  setDark(matchMedia('(prefers-color-scheme: dark)').matches);
  const url = URL.createObjectURL(new Blob([$('worker').textContent], {type: 'text/javascript'})), worker = new Worker(url);
  worker.onmessage = ({data}) => {
    if (data.error) return sorry(`The fruit cannot be unpacked: ${data.error}`);
    try {
      if (data.skin) { picture.skinData = data.skin; takeSkin(data); } else { takeRest(data); worker.terminate(); URL.revokeObjectURL(url); }
    } catch (error) { sorry(`The fruit cannot be drawn: ${error.message}`); throw error; }
  };
  worker.onerror = (event) => sorry(`The fruit cannot be unpacked: ${event.message}`);
  worker.postMessage({text: $('asset').textContent, length: Number($('asset').dataset.length)});

  // For tests and for the curious.
  window.pomona = {state, camera, picture, loads, setKnives, changeKnife, arrange, moved, nameAt, Knife, sceneNow,
    pieces: () => pieces, arranged: () => arranged, finish() { stale = true; do { lastMoved = -1e9; frame(); } while (!state.settled); }};
})();
