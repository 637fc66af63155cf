// The page of a fruit, or of several variants: from their assets to the view.
import {beginPage} from './begin.js';
import {Body, Shape} from './body.js';
import {FruitTextures} from './fruit_textures.js';
import {Knife} from './knives.js';
import {V} from './linear.js';
import {sidesOf, trianglesOf} from './piece_mesh.js';
import {PointerControls} from './pointer_controls.js';
import {Row} from './row.js';
import {Tools} from './tools.js';

(async () => {
  const assets = [...document.querySelectorAll('script.asset')], bodies = [];
  const begun = await beginPage((unpacking) => unpacking.asset(assets[0], takeSkin), 'fruit', 'skin');
  if (!begun) return;
  const {started, loads, unpacking, first, options, picture, board, blade, stroke, paper, drawNow} = begun;
  const nameOf = ({body, part}) =>
    part.replaceAll('_', ' ') + (assets.length > 1 ? `, seed ${body.fruit.header.seed}` : '');
  new PointerControls(board, blade, stroke, {nameOf});
  new Tools(board, blade, stroke, paper);
  board.beginOpening();
  let skinDrawn = null;
  function takeSkin({header, skin, index, outwards}) {
    bodies.push(
      new Body(picture, new FruitTextures(picture.card, header), new Shape(picture.card, skin, index, outwards)));
    board.setting = new Row(bodies);
    if (bodies.length === 1) Object.assign(board.camera, {yaw: assets.length > 1 ? 0.1 : 0.35, pitch: 0.3});
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
    const knives = options.cuts.map(
      ({normal, offset, knife, step}) =>
        Object.assign(Knife.ofPlane(frame, normal, (offset - V.dot(normal, origin)) / spacing), {laid: {knife, step}}));
    board.setKnives(knives, {open: knives.length === 1 && bodies.length === 1 ? 1 : 0, from: 'face'});
    await drawNow('cut');
    board.endOpening();
    picture.startRest();
    paper.lay();
    // Frames during motion may be rough.
    while (board.rough) await new Promise((done) => requestAnimationFrame(done));
    await board.pace.drawn();
    loads.fine = performance.now() - started;
  }
  // For tests and for the console.
  /** @type {any} */ (window).pomona = {
    board,
    picture,
    loads,
    modules: {sidesOf, trianglesOf},
    finish: () => board.finish(),
    nameAt: (x, y) => board.at(x, y),
    pieces: () => board.first.pieces
  };

  // One after another: the first is shown while the others are unpacked.
  for (const asset of assets) {
    const rest = await (asset === assets[0] ? first : unpacking.asset(asset, takeSkin));
    await skinDrawn;
    takeRest(bodies[bodies.length - 1], rest);
  }
  await open();
})();
