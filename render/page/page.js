// The page of a fruit: from its asset to what lies on the board.
'use strict';
(() => {
  const canvas = $('view'), options = JSON.parse($('options').textContent), picture = new Picture(canvas, options);
  const started = performance.now(), loads = {};
  if (!picture.gl) return sorry('This page draws the fruit with WebGL 2, which this browser does not have or has switched off.');
  canvas.addEventListener('webglcontextlost', () => sorry('The graphics card has dropped this page. Load it again.'));

  const board = new Board(canvas, picture), blade = new Blade(board), stroke = new Stroke(board), paper = new Paper(board, options.style);
  const nameOf = ({part}) => part.replaceAll('_', ' ');
  new Hands(board, blade, stroke, {nameOf});
  new Tools(board, blade, stroke, paper);
  const drawNow = () => { board.frame(); picture.gl.finish(); };
  let body = null;

  function takeSkin({header, skin}) {
    body = new Body(picture, new FruitTextures(picture.card, header), skin);
    board.setting = new Row([body]);
    Object.assign(board.camera, {yaw: 0.35, pitch: 0.3});
    $('tools').hidden = false;
    board.takeKnives([]);
    drawNow();
    loads.skin = performance.now() - started;
  }
  function takeRest(rest) {
    const {fruit, frame} = body, {origin, spacing} = fruit.header;
    fruit.takeRest(rest, picture.passes.makeDetail);
    body.takeSamples(rest.winding);
    const knives = options.cuts.map(({normal, offset}) => Knife.ofPlane(frame, normal, (offset - V.dot(normal, origin)) / spacing));
    board.setKnives(knives, {open: knives.length === 1 ? 1 : 0});
    if (board.calm) { board.apart = board.wantedApart; board.open = board.wantedOpen; }
    board.lookAtFace();
    drawNow();
    loads.cut = performance.now() - started;
  }
  new Unpacking().asset($('asset'), takeSkin).then(takeRest);

  // For tests and for the curious.
  window.pomona = {board, picture, loads, finish: () => board.finish(), nameAt: (x, y) => board.at(x, y), pieces: () => board.first.pieces};
})();
