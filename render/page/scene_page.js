// The page of a scene: the pile, the selected piece, and that piece alone under the knife.
import {beginPage} from './begin.js';
import {Body, Shape} from './body.js';
import {FruitTextures} from './fruit_textures.js';
import {V} from './linear.js';
import {$, say} from './messages.js';
import {sparedOfPiece} from './piece_stones.js';
import {Pile} from './pile.js';
import {PointerControls} from './pointer_controls.js';
import {Row} from './row.js';
import {Tools} from './tools.js';

(async () => {
  const begun = await beginPage((unpacking) => unpacking.scene($('scene')), 'scene', 'pieceSkin');
  if (!begun) return;
  const {loads, unpacking, first, picture, board, blade, stroke, paper, drawNow} = begun;
  let pile = null, picked = null;
  const nameOf = ({body, part}) =>
    body.instance.name === part ? part : `${body.instance.name}, ${part.replaceAll('_', ' ')}`;
  const isOut = () => board.setting !== pile;
  new PointerControls(board, blade, stroke, {
    nameOf,
    onTap: (found) => {
      if (!isOut()) pick(found && found.body);
    }
  });
  new Tools(board, blade, stroke, paper, {
    Enter: () => {
      if (picked && !isOut()) takeOut();
    },
    Escape: () => {
      if (board.draws) stroke.toggle();
      else if (isOut()) putBack();
      else pick(null);
    },
    n: () => pickNext(1),
    p: () => pickNext(-1),
  });
  $('take').addEventListener('click', () => {
    if (isOut()) putBack();
    else takeOut();
  });

  // ---- The selection. ----

  function line(term, text) {
    const dt = document.createElement('dt'), dd = document.createElement('dd');
    dt.textContent = term;
    dd.textContent = text;
    $('told').append(dt, dd);
  }
  const inGrams = (kg) => (kg >= 1 ? `${kg.toFixed(2)} kg` : `${(1000 * kg).toPrecision(3)} g`);
  function tell(body) {
    const {facts} = body.solid;
    $('picked').textContent = body.instance.name;
    $('told').replaceChildren();
    if (facts.template) {
      line('of', body.fruit.header.title + (body.fruit.header.latin ? `, ${body.fruit.header.latin}` : ''));
      line('template', facts.template);
      line('seed', facts.index > 0 ? `${facts.seed}, variant ${facts.index}` : String(facts.seed));
      line('knife', facts.knife || 'none: whole');
      if (facts.pieces > 1) line('piece', `${facts.piece} of ${facts.pieces}`);
    }
    line('mass', `${inGrams(facts.mass)}, ${(1e6 * facts.volume).toPrecision(3)} cm³`);
    if (facts.command) line('again', facts.command);
    $('facts').hidden = false;
    // A single piece needs the space.
    $('facts').classList.toggle('brief', isOut());
    $('take').disabled = body.fruit.header.asset < 0;
    $('take').textContent = body.fruit.header.asset < 0 ? 'No fruit is known of it'
      : isOut()                                         ? 'Back to the pile'
                                                        : 'Cut it';
    say(`${body.instance.name}${facts.template ? `, of ${facts.template}` : ''}, ${inGrams(facts.mass)}`);
  }
  function pick(body) {
    if (picked) picked.chosen = false;
    picked = body;
    if (body) {
      body.chosen = true;
      tell(body);
    } else {
      $('facts').hidden = true;
      sayAll();
    }
    board.changed();
  }
  function pickNext(step) {
    if (isOut()) return;
    const {bodies} = pile, at = bodies.indexOf(picked);
    pick(bodies[(at + step + bodies.length + (at < 0 && step < 0 ? 1 : 0)) % bodies.length]);
  }
  const sayAll = () => say(`${pile.bodies.filter(({moves}) => moves).length} pieces; press one to see what it is`);

  // ---- One piece alone. ----

  const unpacked = new Map();
  function whenUnpacked(fruit) {
    if (!unpacked.has(fruit)) {
      say('Unpacking …');
      unpacked.set(fruit, unpacking.asset($(`asset-${fruit.header.asset}`)).then((rest) => {
        fruit.header = {...fruit.header, ...rest.header, title: fruit.header.title, asset: fruit.header.asset};
        fruit.takeRest(rest);
      }));
    }
    return unpacked.get(fruit);
  }
  function lay(setting, knives) {
    Object.assign(board, {setting, apart: 0, open: 0, wantedApart: 0, wantedOpen: 0});
    board.camera.zoom = 1;
    board.takeKnives(knives);
  }
  let view = null;
  async function takeOut() {
    const body = picked;
    if (!body || body.fruit.header.asset < 0) return;
    picture.startCuts();
    await whenUnpacked(body.fruit);
    if (picked !== body || isOut()) return;
    view = {yaw: board.camera.yaw, pitch: board.camera.pitch};
    body.chosen = false;
    if (!body.hasBeenOut) {
      body.hasBeenOut = true;
      body.takeSpared(sparedOfPiece(body, picture.card));
      body.takeSamples(null);
    }
    Object.assign(board.camera, {yaw: 0.35, pitch: 0.3});
    lay(new Row([body]), body.knives);
    if (body.knives.length > 0) board.wantedApart = 0.36;
    tell(body);
    board.sayPieces();
  }
  function putBack() {
    if (board.draws) stroke.stop();
    Object.assign(board.camera, view);
    lay(pile, []);
    picked.chosen = true;
    tell(picked);
  }

  // ---- From the worker. ----

  async function takeScene({header, solids, looks}) {
    const fruits = header.fruits.map((fruit, i) => {
      const made = new FruitTextures(picture.card, {name: fruit.title, ...fruit});
      made.takeLook(looks[i]);
      return made;
    });
    const shapes = solids.map(({skin, index, outwards}) => new Shape(picture.card, skin, index, outwards));
    const bodies = header.instances.map((instance) => {
      const solid = header.solids[instance.solid], fruit = fruits[solid.fruit];
      const body = new Body(picture, fruit, shapes[instance.solid], 60);
      return Object.assign(body, {instance, solid, isPiece: true, moves: fruit.header.asset >= 0});
    });
    const spacings =
      fruits.filter(({header: {asset}}) => asset >= 0).map(({header: {spacing}}) => spacing).sort((a, b) => a - b);
    pile = new Pile(bodies, spacings.length ? spacings[spacings.length >> 1] : fruits[0].header.spacing);
    const {eye, target} = header.view, back = V.unit(V.sub(eye, target));
    Object.assign(board.camera, {yaw: Math.atan2(back[0], back[2]), pitch: Math.asin(back[1])});
    lay(pile, []);
    sayAll();
    await drawNow('skin');
    loads.cut = loads.skin;
    paper.lay();
  }
  first.then(takeScene);

  // For tests and for the console.
  /** @type {any} */ (window).pomona = {
    board,
    picture,
    loads,
    finish: () => board.finish(),
    nameAt: (x, y) => board.at(x, y),
    pieces: () => board.first.pieces,
    pick: (name) => pick(pile.bodies.find((body) => body.instance.name === name) || null),
    takeOut,
    putBack,
    pile: () => pile,
    picked: () => picked
  };
})();
