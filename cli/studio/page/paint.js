// Colours: every colour of every side as a stop on a bar; stops are dragged along their ramp, painted, added and taken away.
'use strict';
let chosenStop = null;  // {surface, index}: the colour that the pipette fills

function setChosenColor(studio, color) {
  const entry = chosenStop && studio.drawing.surfaces.find(({name}) => name === chosenStop.surface)?.colors[chosenStop.index];
  if (!entry) return false;
  studio.commit({...studio.texts, toml: edited(studio.texts.toml, [{from: entry.from, to: entry.to, text: color}])}, `${chosenStop.surface}: ${color}`);
  return true;
}

/** Colours that lie in one value: a ramp, or a colour alone. Consecutive stops whose places grow belong together. */
function rampsOf({colors}) {
  const ramps = [];
  colors.forEach((color, index) => {
    const last = ramps.at(-1), before = last?.stops.at(-1);
    if (last && color.place && before.place && last.side === color.side && color.place.value > before.place.value && color.from - before.to < 60) last.stops.push({...color, index});
    else ramps.push({side: color.side, stops: [{...color, index}]});
  });
  return ramps;
}

function showPaint(studio) {
  const list = $('paint');
  list.replaceChildren();
  for (const surface of studio.drawing.surfaces) for (const ramp of rampsOf(surface)) {
    const row = document.createElement('div'), name = document.createElement('span'), bar = document.createElement('div');
    row.className = 'ramp';
    bar.className = 'bar';
    name.textContent = `${surface.name} ${ramp.side === 'front' ? 'outside' : 'inside'}`;
    const place = (stop) => (ramp.stops.length === 1 && !stop.place ? 0.5 : stop.place?.value ?? 0);
    bar.style.background = ramp.stops.length === 1 ? ramp.stops[0].text : `linear-gradient(to right, ${ramp.stops.map((s) => `${s.text} ${100 * place(s)}%`).join(', ')})`;
    bar.title = 'Two clicks add a stop';
    bar.addEventListener('dblclick', (event) => { if (event.target === bar) addStop(studio, ramp, event.offsetX / bar.clientWidth); });
    for (const stop of ramp.stops) bar.append(stopOf(studio, surface, stop, place(stop), bar));
    row.append(name, bar);
    list.append(row);
  }
}

function stopOf(studio, surface, stop, place, bar) {
  const button = document.createElement('button');
  Object.assign(button, {type: 'button', className: 'stop', title: `${stop.text}: click to choose, twice for a palette, Delete takes it away`});
  button.setAttribute('aria-label', `${surface.name}, ${stop.side === 'front' ? 'outside' : 'inside'}, ${stop.text}`);
  button.setAttribute('aria-pressed', String(chosenStop?.surface === surface.name && chosenStop.index === stop.index));
  button.style.background = stop.text;
  button.style.left = `${100 * place}%`;
  let from = null, value = place;
  button.addEventListener('pointerdown', (event) => { from = event.clientX; button.setPointerCapture(event.pointerId); });
  button.addEventListener('pointermove', (event) => {
    if (from === null || !stop.place || Math.abs(event.clientX - from) < 3) return;
    value = Math.max(0, Math.min(1, place + (event.clientX - from) / bar.clientWidth));
    button.style.left = `${100 * value}%`;
  });
  button.addEventListener('pointerup', () => {
    from = null;
    if (stop.place && value !== place) {
      studio.commit({...studio.texts, toml: edited(studio.texts.toml, [{from: stop.place.from, to: stop.place.to, text: value.toFixed(2)}])}, `${surface.name}: stop at ${value.toFixed(2)}`);
    } else {
      chosenStop = {surface: surface.name, index: stop.index};
      for (const other of document.querySelectorAll('.stop')) other.setAttribute('aria-pressed', String(other === button));
      studio.say(`${surface.name}: the pipette fills this colour (I)`);
    }
  });
  button.addEventListener('dblclick', () => {
    const input = Object.assign(document.createElement('input'), {type: 'color', value: stop.text});
    input.addEventListener('change', () => setChosenColor(studio, input.value));
    input.click();
  });
  button.addEventListener('keydown', (event) => { if (event.key === 'Delete') { event.stopPropagation(); removeStop(studio, surface, stop); } });
  return button;
}

/** A stop between two others; a colour alone becomes a ramp. */
function addStop(studio, ramp, share) {
  const {toml} = studio.texts, after = ramp.stops.filter((s) => s.place && s.place.value <= share).at(-1), place = share.toFixed(2);
  const first = ramp.stops[0];
  const edit = after ? {from: after.to + 2, to: after.to + 2, text: `, [${place}, "${after.text}"]`}
    : {from: first.from - 1, to: first.to + 1, text: `[[0.0, "${first.text}"], [1.0, "${first.text}"]]`};
  if (!after && first.place) return;
  studio.commit({...studio.texts, toml: edited(toml, [edit])}, 'a stop more');
}
function removeStop(studio, surface, stop) {
  if (!stop.place) return;
  const {toml} = studio.texts, from = toml.lastIndexOf('[', stop.place.from);
  let to = toml.indexOf(']', stop.to) + 1;
  while (/[\s,]/.test(toml[to])) ++to;
  studio.commit({...studio.texts, toml: edited(toml, [{from, to, text: ''}])}, `${surface.name}: a stop less`);
}
