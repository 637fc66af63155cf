// The page of a fruit, or of several of one family: from their assets to what lies on the board.
'use strict';
(async () => {
  // The worker unpacks while the browser makes a place to draw, which may take as long and keeps the page busy.
  const started = performance.now(), loads = {}, assets = [...document.querySelectorAll('script.asset')], bodies = [];
  const unpacking = new Unpacking(), first = unpacking.asset(assets[0], takeSkin);
  await unpacking.isUp;
  const canvas = $('view'), options = JSON.parse($('options').textContent), picture = new Picture(canvas, options);
  loads.card = performance.now() - started;
  if (!picture.gl) return unpacking.stop(), sorry('This page draws the fruit with WebGL 2, which this browser does not have or has switched off.');
  canvas.addEventListener('webglcontextlost', () => sorry('The graphics card has dropped this page. Load it again.'));

  const board = new Board(canvas, picture), blade = new Blade(board), stroke = new Stroke(board), paper = new Paper(board, options.style);
  const nameOf = ({body, part}) => part.replaceAll('_', ' ') + (assets.length > 1 ? `, seed ${body.fruit.header.seed}` : '');
  new Hands(board, blade, stroke, {nameOf});
  new Tools(board, blade, stroke, paper);
  /** How long after the beginning a picture was there, as far as the card has told. */
  async function drawNow(name) {
    board.frame();
    await board.pace.drawn();
    loads[name] = performance.now() - started;
  }

  let skinDrawn = null;
  function takeSkin({header, skin}) {
    bodies.push(new Body(picture, new FruitTextures(picture.card, header), new Shape(picture.card, skin)));
    board.setting = new Row(bodies);
    if (bodies.length === 1) Object.assign(board.camera, {yaw: assets.length > 1 ? 0.1 : 0.35, pitch: 0.3});
    $('tools').hidden = false;
    board.takeKnives([]);
    if (bodies.length > 1) return;
    skinDrawn = drawNow('skin');
    picture.startCuts();
  }
  function takeRest(body, rest) {
    body.fruit.takeRest(rest);
    body.takeSamples(rest.winding);
    body.takeSpared(body.fruit.spared);
  }
  async function open() {
    const {fruit, frame} = bodies[0], {origin, spacing} = fruit.header;
    const knives = options.cuts.map(({normal, offset, knife, step}) =>
      Object.assign(Knife.ofPlane(frame, normal, (offset - V.dot(normal, origin)) / spacing), {laid: {knife, step}}));
    board.setKnives(knives, {open: knives.length === 1 && bodies.length === 1 ? 1 : 0});
    if (board.calm) { board.apart = board.wantedApart; board.open = board.wantedOpen; }
    board.lookAtFace();
    await drawNow('cut');
    picture.startRest();
    // What is drawn while something moves may be rough.
    while (board.rough) await new Promise((done) => requestAnimationFrame(done));
    await board.pace.drawn();
    loads.fine = performance.now() - started;
  }
  // For tests and for the curious.
  window.pomona = {board, picture, loads, finish: () => board.finish(), nameAt: (x, y) => board.at(x, y), pieces: () => board.first.pieces};

  // One after the other: the first is seen while the next are unpacked.
  for (const asset of assets) {
    const rest = await (asset === assets[0] ? first : unpacking.asset(asset, takeSkin));
    await skinDrawn;
    takeRest(bodies[bodies.length - 1], rest);
  }
  await open();
})();
