// The page of a batch: its items as a sheet that can be filtered, sorted and looked at.
export {};

// Each row: folder, template, seed, knives, pieces, volume in millilitres, files, why it failed.
const rows = JSON.parse(document.getElementById('items').textContent);
const batch = JSON.parse(document.getElementById('batch').textContent);
const items = rows.map(([folder, template, seed, knives, pieces, volume, files, error], number) => ({
                         number,
                         folder,
                         template,
                         seed,
                         knives,
                         pieces,
                         volume,
                         files,
                         error,
                         words: [folder, template, seed, knives || 'whole', error && 'failed'].join(' ').toLowerCase()
                       }));
/** @type {(id: string) => any} */
const at = id => document.getElementById(id);
const sheet = at('sheet'), filter = at('filter'), sort = at('sort'), size = at('size'), about = at('about');
const footing = 46;  // pixels below a picture
let shown = items, chosen = -1, down = false;

// Text only ever becomes text.
function element(kind, text, attributes = {}) {
  const made = document.createElement(kind);
  made.textContent = text;
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  return made;
}
// Data sets show their pictures, batches a thumbnail.
const shownFile = item => ['thumbnail.png', 'picture.png'].find(name => item.files.includes(name));
const href = (item, file) => item.folder.split('/').concat(file).map(encodeURIComponent).join('/');
const amount = millilitres => millilitres >= 100 ? millilitres.toFixed(0) + ' ml' : millilitres.toPrecision(3) + ' ml';

function chooseItems() {
  const words = filter.value.toLowerCase().split(/\s+/).filter(word => word);
  shown = items.filter(item => words.every(word => item.words.includes(word)));
  const key = sort.value;
  const compare = (a, b) => a[key] < b[key] ? -1 : a[key] > b[key] ? 1 : a.number - b.number;
  shown.sort(down ? (a, b) => compare(b, a) : compare);
  const failed = shown.filter(item => item.error).length;
  at('count').textContent =
    (shown.length === items.length ? `${items.length} items` : `${shown.length} of ${items.length} items`) +
    (failed ? `, ${failed} failed` : '');
  chosen = Math.min(chosen, shown.length - 1);
  draw();
}

function layout() {
  const cell = Number(size.value), columns = Math.max(1, Math.floor(sheet.clientWidth / (cell + 8)));
  return {cell, columns, row: cell + footing + 8, rows: Math.ceil(shown.length / columns)};
}

// Only what is near the window is there; so thousands cost no more than dozens.
function draw() {
  const {cell, columns, row, rows: count} = layout();
  document.documentElement.style.setProperty('--cell', cell + 'px');
  sheet.style.height = count * row + 'px';
  const top = window.scrollY - sheet.offsetTop;
  const first = Math.max(0, Math.floor(top / row) - 2),
        last = Math.min(count, Math.ceil((top + window.innerHeight) / row) + 2);
  const made = [];
  for (let i = first * columns; i < Math.min(last * columns, shown.length); ++i)
    made.push(cellOf(i, columns, row, cell));
  sheet.replaceChildren(...made);
  sheet.setAttribute('aria-activedescendant', chosen >= 0 ? 'item' + shown[chosen].number : '');
}

const kept = new Map();  // pictures that were shown lately are not read twice
function picture(item) {
  const file = shownFile(item);
  if (!file) return element('span', item.error || 'no picture', {class: 'none'});
  if (!kept.has(item.number)) {
    if (kept.size > 2000) kept.clear();
    kept.set(
      item.number, element('img', '', {loading: 'lazy', decoding: 'async', alt: item.template, src: href(item, file)}));
  }
  return kept.get(item.number);
}

function cellOf(i, columns, row, cell) {
  const item = shown[i];
  const made = element('div', '', {
    class: 'cell' + (item.error ? ' failed' : '') + (i === chosen ? ' chosen' : ''),
    role: 'option',
    id: 'item' + item.number,
    'aria-selected': i === chosen,
    title: item.folder
  });
  made.style.left = (i % columns) * (cell + 8) + 'px';
  made.style.top = Math.floor(i / columns) * row + 'px';
  const what = item.error ? 'failed' : [item.knives || 'whole', amount(item.volume)].join(', ');
  made.append(picture(item), element('div', item.template), element('div', what, {class: 'what'}));
  made.onclick = () => {
    chosen = i;
    draw();
    show();
  };
  return made;
}

function choose(i) {
  if (!shown.length) return;
  chosen = Math.max(0, Math.min(shown.length - 1, i));
  const {columns, row} = layout();
  const top = sheet.offsetTop + Math.floor(chosen / columns) * row,
        head = document.querySelector('header').offsetHeight;
  if (top - head < window.scrollY) window.scrollTo(0, top - head - 8);
  if (top + row > window.scrollY + window.innerHeight) window.scrollTo(0, top + row - window.innerHeight + 8);
  draw();
}

function show() {
  const item = shown[chosen];
  if (!item) return;
  const list = document.createElement('dl');
  const line = (name, ...values) => {
    const dd = document.createElement('dd');
    dd.append(...values);
    list.append(element('dt', name), dd);
  };
  line('item', item.folder);
  line('template', item.template);
  line('seed', String(item.seed));
  line('knives', item.knives || 'none: whole');
  if (item.error) line('failed', item.error);
  else line('pieces', `${item.pieces}, ${amount(item.volume)} together`);
  line('files', ...[...item.files, 'item.json'].flatMap(file => [element('a', file, {href: href(item, file)}), ' ']));
  about.replaceChildren(
    ...(shownFile(item) ? [element('img', '', {src: href(item, shownFile(item)), alt: item.template})] : []), list);
  if (!about.open) about.showModal();
}

document.addEventListener('keydown', event => {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const {columns, row} = layout(), page = columns * Math.max(1, Math.floor(window.innerHeight / row) - 1);
  const steps = {
    ArrowLeft: -1,
    ArrowRight: 1,
    ArrowUp: -columns,
    ArrowDown: columns,
    PageUp: -page,
    PageDown: page,
    Home: -Infinity,
    End: Infinity
  };
  if (event.key === '/' && document.activeElement !== filter) {
    event.preventDefault();
    filter.focus();
    return;
  }
  if (event.key === 'Escape' && document.activeElement === filter) {
    sheet.focus();
    return;
  }
  if (['INPUT', 'SELECT', 'BUTTON'].includes(document.activeElement.tagName)) return;
  if (event.key === 'Enter' && !about.open) {
    event.preventDefault();
    show();
  }
  if (event.key in steps) {
    event.preventDefault();
    choose(Math.max(chosen, 0) + (chosen < 0 ? 0 : steps[event.key]));
    if (about.open) show();
  }
});
filter.oninput = chooseItems;
sort.onchange = chooseItems;
size.oninput = draw;
at('turn').onclick = () => {
  down = !down;
  at('turn').textContent = down ? '\u2193' : '\u2191';
  chooseItems();
};
at('shade').onclick = () => {
  const root = document.documentElement, dark = matchMedia('(prefers-color-scheme: dark)').matches;
  const isDark = root.classList.contains('dark') || dark && !root.classList.contains('light');
  root.classList.toggle('dark', !isDark);
  root.classList.toggle('light', isDark);
};
about.onclose = () => sheet.focus({preventScroll: true});
about.onclick = event => {
  if (event.target === about) about.close();
};
addEventListener('scroll', draw, {passive: true});
addEventListener('resize', draw);
at('keys').append(` ${batch.program}, batch ${batch.name}, seed ${batch.seed}.`);
chooseItems();
