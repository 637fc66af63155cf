// The pen, the tracer and the pipette.
import {between, Bezier, near, nodeAt} from './bezier.js';
import {plainName} from './drawing.js';
import {setChosenColor} from './paint.js';
import {edited} from './svg_text.js';
import {partsIn, surfacesIn} from './toml_curves.js';
import {traced} from './trace.js';

export const tools = {
  pen: {
    down(studio, pane, place) {
      if (!studio.pen || studio.pen.pane !== pane) studio.pen = {pane, nodes: [], closed: false};
      const {pen} = studio, first = pen.nodes[0];
      if (pen.nodes.length > 1 && Math.hypot(first.p[0] - place[0], first.p[1] - place[1]) * pane.scale < 10) {
        pen.closed = true;
        finishPen(studio);
        return;
      }
      const part = {nodes: [...pen.nodes, nodeAt(place)], closed: false};
      pen.nodes.push(nodeAt(studio.nodes.snapped(pane, place, part, part.nodes.length - 1)));
      pen.held = true;
      pane.drawMarks();
    },
    move(studio, pane, place) {
      const {pen} = studio;
      if (!pen?.held || pen.pane !== pane) return;
      const node = pen.nodes[pen.nodes.length - 1];
      if (Math.hypot(place[0] - node.p[0], place[1] - node.p[1]) * pane.scale < 4) return;
      node.after = place;
      node.before = between(place, node.p, 2);
      pane.drawMarks();
    },
    up(studio) {
      if (studio.pen) studio.pen.held = false;
    },
  },
  brush: {
    down(studio, pane, place, event) { studio.brush.down(pane, place, event);},
    move(studio, pane, place) { studio.brush.move(pane, place);},
    up(studio) { studio.brush.up();},
  },
  pick: {
    up(studio, pane, place) {
      const color = studio.pictures.colorAt(studio.drawing.images.filter(({view}) => view === pane.view), place);
      if (!color) {
        studio.say('There is no picture here.');
        return;
      }
      if (!setChosenColor(studio, color)) studio.say(`${color}: choose a colour on the right first`);
    },
  },
  trace: {
    up(studio, pane, place) {
      const curve = studio.selected?.curve;
      if (!curve || curve.dot || curve.view !== pane.view) {
        studio.say('Choose the curve that is to follow the outline first.');
        return;
      }
      const part = traced(studio, pane.view, place, curve.parts[0].closed);
      if (!part) {
        studio.say('Nothing of that colour has an outline here.');
        return;
      }
      studio.commit(studio.drawing.withParts(curve, [part]), `${curve.name} traced`);
    },
  },
};

export function finishPen(studio) {
  const {pen} = studio;
  studio.pen = null;
  if (!pen || pen.nodes.length < 2) {
    studio.redraw();
    return;
  }
  // The two clicks of a double click add one node.
  const nodes = pen.nodes.filter((node, i) => i === 0 || !near(node.p, pen.nodes[i - 1].p, 3 / pen.pane.scale));
  askName(studio, pen.pane.view, (answer) => addCurve(studio, pen.pane.view, {nodes, closed: pen.closed}, answer));
}

/** The purpose of a new curve: its name, and whether it starts a surface. */
function askName(studio, view, then) {
  const dialog = document.createElement('dialog'), form = document.createElement('form');
  const parts = partsIn(studio.texts.toml);
  const labelled = (text, field) => {
    const label = document.createElement('label');
    label.append(text, field);
    form.append(label);
    return field;
  };
  const name = labelled(
    'Name ',
    Object.assign(
      document.createElement('input'),
      {type: 'text', id: 'curve-name', required: true, pattern: '[A-Za-z0-9 _\\-]{1,60}', value: 'stone'}));
  const choice = labelled('A surface ', document.createElement('select'));
  choice.id = 'curve-surface';
  for (const [value, text] of [
         ['', 'no, only the curve'], ['around-axis', 'around the axis'], ['in-fold', 'in each fold']])
    choice.append(new Option(text, value));
  choice.value = view === 'side' && studio.drawing.layers ? 'around-axis' : '';
  const within = labelled('Inside it is ', document.createElement('select'));
  for (const part of parts) within.append(new Option(part, part));
  within.value = parts[parts.length - 1];
  const ok = Object.assign(document.createElement('button'), {type: 'submit', textContent: 'Add', id: 'curve-add'});
  form.append(ok);
  form.method = 'dialog';
  dialog.append(form);
  document.body.append(dialog);
  form.addEventListener('submit', (event) => {
    event.preventDefault();
    const answer = {name: name.value.trim(), surface: choice.value, inside: within.value};
    dialog.close();
    then(answer);
  });
  dialog.addEventListener('close', () => {
    dialog.remove();
    studio.redraw();
  });
  dialog.showModal();
  name.select();
}

function addCurve(studio, view, part, {name, surface, inside}) {
  const texts = studio.drawing.withCurve(view, name, [part]);
  if (!texts) {
    studio.say('New curves are drawn in a sketch; this template holds its curves itself.');
    return;
  }
  if (surface) {
    const middle = Bezier.at(Bezier.segments(part)[0], 0.5);
    const images = studio.drawing.images.filter((image) => image.view === view);
    const color = studio.pictures.colorAt(images, middle) || '#c8a070', label = plainName(name);
    texts.toml = withSurface(texts.toml, {label, surface, inside, color});
  }
  studio.setTool('nodes');
  studio.commit(texts, `${name} added`);
}

/** After the last surface: later surfaces are inside earlier ones. */
function withSurface(toml, {label, surface, inside, color}) {
  const last = surfacesIn(toml).at(-1), at = last ? last.to : toml.length;
  const horizontal = surface === 'in-fold' ? `horizontal = "#${label}"\n` : '';
  const text = `[[surface]]\nname = "${label.replace(/[^a-z0-9_-]/g, '')}"\ntype = "${surface}"\nvertical = "#${
                 label}"\n${horizontal}` +
    `front = { part = "${inside}", color = "${color}" }\nback = { part = "${inside}", color = "${color}" }\n\n`;
  return edited(toml, [{from: at, to: at, text: (toml[at - 1] === '\n' ? '' : '\n') + text}]);
}
