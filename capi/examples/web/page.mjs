// The page: a file is dropped or chosen, its numbers come into tables, and a picture of it, exact SVG, is drawn anew
// each time that it is turned. All geometry comes from the program hardsphere, which runs here, in two workers: one for
// numbers, which may take long, one for pictures.

const SIZE = 640; // the picture's sides, in px
const TURN = 0.01, STEP = Math.PI / 12; // radians for a px of dragging, for a key
const CLOSEST = 40;
const A_RUN = /\.(xtc|trr|dcd|nc)$/i;

const element = id => document.getElementById(id);
const picture = element('picture');

const packed = id => Uint8Array.from(atob(element(id).textContent.trim()), letter => letter.charCodeAt(0));
const unpacked = async bytes => new Uint8Array(await new Response(
    new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
const module = await WebAssembly.compile(await unpacked(packed('program')));
const worker_code = URL.createObjectURL(new Blob([element('worker').textContent], {type: 'text/javascript'}));

// A worker that answers command lines about these files one after another: with bytes, or by throwing what went wrong.
// notes() is what the last one that succeeded had to say besides.
function program_with(files) {
  const worker = new Worker(worker_code);
  const waiting = [];
  let notes = '';
  worker.addEventListener('message', ({data}) => waiting.shift()(data));
  worker.postMessage({module, files});
  const bytes = words => new Promise((resolve, reject) => {
    waiting.push(({status, output, errors}) => {
      if (status !== 0) reject(new Error(errors.trim()));
      notes = errors;
      resolve(output);
    });
    worker.postMessage({words});
  });
  const text = async words => new TextDecoder().decode(await bytes(words));
  const json = async words => JSON.parse(await text([...words, '--json']));
  return {bytes, text, json, notes: () => notes, end: () => worker.terminate()};
}

let shown; // what is in the page: files, names, options, numbers of its balls, the workers, and the picture's text
let wanted; // what was asked for last: the same, unless it is still on its way
let last_rank = 0; // of what was asked for
let reading = 0; // how many times files are read now
let turned; // how the molecule is turned: a matrix in the viewer's frame
let place; // the middle of what is seen, as parts of the picture, and how close
let drawing = false, draw_again = false;

// ---- tables

function cell(value) {
  const made = document.createElement('td');
  if (typeof value === 'number') {
    const data = made.appendChild(document.createElement('data'));
    data.value = value;
    data.textContent = Number.isInteger(value) ? value : value.toFixed(Math.abs(value) < 10 ? 3 : 2);
  } else if (value instanceof Node) {
    made.append(value);
  } else {
    made.textContent = value;
    made.className = 'text';
  }
  return made;
}

function row(cells) {
  const made = document.createElement('tr');
  made.append(...cells.map(cell));
  return made;
}

// A table of rows; while there are none, and where there is none at all, one line says so. Units stand in the heads.
function table(id, title, explained, heads, rows, otherwise) {
  const caption = document.createElement('caption');
  const name = caption.appendChild(document.createElement('b'));
  name.textContent = title;
  caption.append(explained);
  const head = document.createElement('tr');
  for (const text of rows.length ? heads : []) {
    const made = head.appendChild(document.createElement('th'));
    made.scope = 'col';
    made.textContent = text;
    if (text.startsWith('lined')) made.className = 'text';
  }
  element(id).replaceChildren(caption, head, ...(rows.length ? rows.map(row) : [row([otherwise])]));
}

// ---- what the program is asked

// With the unit, where the file has one: a length, and the head of a column of areas or volumes.
const length = value => `${value}\u00a0${shown.unit}`.trim();
const head = (name, power) => shown.unit && power ? `${name}, ${shown.unit}${power === 2 ? '²' : '³'}` : name;

function residue(ball) {
  const {atom, element: symbol, residue: name, number, insertion, chain} = shown.measured.balls[ball];
  if (name === undefined) return `${atom ?? symbol ?? 'ball'} ${ball}`;
  return `${name} ${number ?? ''}${insertion ?? ''} ${chain ?? ''}`.trim();
}

function lining(balls) {
  const names = [...new Set(balls.map(residue))];
  return names.slice(0, 4).join(', ') + (names.length > 4 ? ` and ${names.length - 4} more` : '');
}

// A button that leaves only these balls of the picture in full colour.
function mark(text, balls) {
  const button = document.createElement('button');
  button.textContent = text;
  button.setAttribute('aria-pressed', 'false');
  button.title = 'Show the atoms around it';
  button.addEventListener('click', () => {
    const now = button.getAttribute('aria-pressed') === 'false';
    for (const other of document.querySelectorAll('td button')) other.setAttribute('aria-pressed', 'false');
    button.setAttribute('aria-pressed', String(now));
    shown.marked = now ? new Set(balls.map(String)) : undefined;
    if (now && !/balls|sticks/.test(element('kind').value)) element('kind').value = 'balls';
    draw();
  });
  return button;
}

function areas(surfaces) {
  table('areas', 'Areas and volumes', '', ['surface', head('area', 2), head('volume', 3)],
    surfaces.map(([name, found]) => [name, found === undefined ? '…' : found.area ?? '', found?.volume ?? '']));
}

// What stands in a table without rows: where the program refused, nothing is known.
const no_rows = found => found instanceof Error ? 'not known' : 'none';

async function fill(file) {
  const {numbers, words} = file;
  const ask = async (...more) => {
    try {
      return await numbers.json([more[0], file.name, ...words, ...more.slice(1)]);
    } catch (error) {
      element('message').textContent += `${error.message}\n`;
      return error;
    }
  };
  const surfaces = [['van der Waals', file.bare], [`solvent-accessible, probe ${length(file.probe)}`, file.measured],
    [`solvent-excluded (smooth), probe ${length(file.probe)}`, undefined]];
  areas(surfaces);
  const voids = [`Voids`, `: closed places for the centre of a probe of ${length(file.probe)}`];
  const pockets = ['Pockets', `: where a probe of ${length(file.probe)} fits, and one of ${length(file.wide)} ` +
    'does not get to from outside'];
  table('voids', ...voids, [], [], '…');
  table('pockets', ...pockets, [], [], '…');
  surfaces[2][1] = await ask('measure', '--probe', file.probe, '--surface', 'ses');
  areas(surfaces);
  const found = await ask('voids', '--probe', file.probe);
  table('voids', ...voids, ['', head('volume', 3), head('area', 2), 'lined by'],
    (found.voids ?? []).map(one => [mark(one.void, one.balls), one.volume, one.area, lining(one.balls)]),
    no_rows(found));
  const held = await ask('pores', '--probe', file.probe, '--pockets', file.wide);
  table('pockets', ...pockets, ['', head('volume', 3), head('area', 2), 'mouths', 'lined by'],
    (held.pocket_list ?? []).map(one => [mark(one.pocket, one.balls), one.volume ?? '-', one.area ?? '-',
      one.mouths.length, lining(one.balls)]), no_rows(held));
  element('run').parentNode.hidden = file.run === undefined;
  if (file.run !== undefined) {
    const mean = await ask('measure', '--probe', file.probe, '--trajectory', file.run, '--mean');
    table('run', file.run, `: ${mean.frames === undefined ? '' : `${mean.frames} frames, `}probe ${length(file.probe)}`,
      ['', 'mean', 'deviation', 'least', 'most'], (mean.means ?? []).map(one => [
        head(one.quantity, {area: 2, volume: 3}[one.quantity]), one.mean, one.deviation, one.least, one.most]),
      no_rows(mean));
  }
  element('numbers').setAttribute('aria-busy', 'false');
}

// ---- files to keep

function save(name, content) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content]));
  link.download = name;
  link.click();
}

function saves(file) {
  const stem = file.name.replace(/\.[^.]*$/, '');
  const asked = [['Picture, SVG', `${stem}.svg`],
    ['Areas of atoms, CSV', `${stem}_areas.csv`, 'measure', '--probe', file.probe, '--csv'],
    ['Smooth surface, PLY', `${stem}.ply`, 'mesh', '--probe', file.probe, '--surface', 'ses', '--triangles', 'ply',
      '-o', '-']];
  if (file.run !== undefined) {
    asked.push(['Frames, CSV', `${stem}_frames.csv`, 'measure', '--probe', file.probe, '--trajectory', file.run]);
  }
  element('saves').replaceChildren(...asked.map(([text, name, command, ...more]) => {
    const button = document.createElement('button');
    button.textContent = `Save: ${text}`;
    button.addEventListener('click', async () => {
      try {
        save(name, command === undefined ? file.svg :
          await file.numbers.bytes([command, file.name, ...file.words, ...more]));
      } catch (error) {
        element('message').textContent = error.message;
      }
    });
    return button;
  }));
}

// ---- the picture

const times = (a, b) => a.map(row => [0, 1, 2].map(k => row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k]));
const identity = () => [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

// Angles about the axes to the right, upwards and towards the viewer, applied in that order.
function angles([[a, , ], [b, , ], [c, d, e]]) {
  return [Math.atan2(d, e), -Math.asin(Math.max(-1, Math.min(1, c))), Math.atan2(b, a)]
    .map(x => (x * 180 / Math.PI).toFixed(3));
}

function words_of_picture() {
  const kind = element('kind').value, dark = document.documentElement.dataset.theme === 'dark';
  const from = ['-o', '-', '--rotate', angles(turned).join()];
  if (kind === 'balls' || kind === 'sticks') {
    const words = ['draw', shown.name, ...shown.words, ...from, '--picture', 'svg', '--pieces', 'visible',
      '--scale', shown.scale, '--centre', shown.centre, '--scale-bar', '--legend', '--colour', element('colour').value,
      ...dark ? ['--look', 'slide'] : [], '--width', String(SIZE), '--height', String(SIZE)];
    if (kind === 'sticks') words.push('--as', 'ball-and-stick');
    if (element('water').checked) words.push('--water');
    return words;
  }
  const edge = shown.measured.n < 100 ? '0.15' : shown.measured.n < 1000 ? '0.4' : '0.8';
  const words = ['mesh', shown.name, ...shown.words, ...from, '--triangles', 'svg', '--probe', shown.probe,
    '--surface', 'ses', '--edge', edge, ...dark ? ['--dark'] : []];
  if (kind !== 'surface') words.push('--pockets', shown.wide);
  if (kind === 'cut') words.push('--cut');
  return words;
}

function look() {
  const svg = picture.firstElementChild;
  if (svg === null) return;
  const [, , width, height] = shown.frame;
  const share = 1 / place.closer;
  const corner = [width * (place.x - share / 2), height * (place.y - share / 2)];
  svg.setAttribute('viewBox', [...corner, width * share, height * share].join(' '));
}

// One picture at a time, however many steps the pointer makes meanwhile: the last one counts.
async function draw() {
  if (drawing) {
    draw_again = true;
    return;
  }
  drawing = true;
  const file = shown;
  const words = words_of_picture();
  try {
    file.svg = await file.pictures.text(words);
    picture.innerHTML = file.svg;
    picture.dataset.command = JSON.stringify(words);
    picture.setAttribute('aria-label', `${file.name}, ${file.measured.n} balls`);
    file.frame = picture.firstElementChild.getAttribute('viewBox').split(' ').map(Number);
    picture.classList.toggle('some', file.marked !== undefined);
    for (const ball of file.marked ? picture.querySelectorAll('[data-ball]') : []) {
      ball.classList.toggle('lining', file.marked.has(ball.dataset.ball));
    }
    look();
  } catch (error) {
    element('message').textContent = error.message;
  }
  drawing = false;
  if (draw_again) {
    draw_again = false;
    draw();
  }
}

// The molecule turns with the pointer: about the axis upwards, then about that to the right.
function turn(across, down) {
  const [c, s, d, t] = [Math.cos(across), Math.sin(across), Math.cos(down), Math.sin(down)];
  turned = times([[1, 0, 0], [0, d, -t], [0, t, d]], times([[c, 0, s], [0, 1, 0], [-s, 0, c]], turned));
  draw();
}

function go_closer(factor, x = 0.5, y = 0.5) {
  const closer = Math.min(CLOSEST, Math.max(1, place.closer * factor));
  const stay = (middle, at) => {
    const moved = middle + (at - 0.5) * (1 / place.closer - 1 / closer);
    return Math.min(1 - 0.5 / closer, Math.max(0.5 / closer, moved));
  };
  place = {closer, x: stay(place.x, x), y: stay(place.y, y)};
  look();
}

function back() {
  turned = identity();
  place = {closer: 1, x: 0.5, y: 0.5};
  if (shown) draw();
}

// ---- a file comes in

// Puts files into the page, with the options that stand there. What was in it stays if they cannot be read. Of several
// that are on their way the one that was asked for last counts, in whatever order they come.
async function load(files, name, run, rank = ++last_rank) {
  if (wanted?.rank > rank) return;
  element('message').textContent = '';
  const file = {files, name, run, rank, probe: element('probe').value, wide: element('wide').value};
  wanted = file;
  const again = shown?.name === name && shown.files[name] === files[name];
  const numbers = file.numbers = program_with(files);
  const radii = element('radii').value;
  file.words = radii === 'bondi' ? [] : ['--radii', radii]; // files that have radii take no set
  if (!element('models').hidden && again) file.words.push('--model', element('model').value);
  try {
    file.bare = await numbers.json(['measure', name, ...file.words]);
    const {water_atoms, balls} = file.bare.input;
    if (water_atoms > 0 && water_atoms < balls && !element('water').checked) {
      file.words.push('--no-water');
      file.bare = await numbers.json(['measure', name, ...file.words]);
    }
    file.measured = await numbers.json(['measure', name, ...file.words, '--probe', file.probe, '--per-ball']);
  } catch (error) {
    numbers.end();
    if (wanted === file) {
      wanted = shown;
      element('message').textContent = error.message;
    }
    return;
  }
  if (shown?.rank > file.rank) {
    numbers.end();
    return;
  }
  if (!(wanted?.rank > file.rank)) wanted = file;
  if (file.rank === last_rank) element('message').textContent = numbers.notes();
  const {n, balls, input} = file.measured;
  const middle = [0, 1, 2].map(k => balls.reduce((sum, ball) => sum + ball.xyz[k] / n, 0));
  const reach = balls.reduce((most, {xyz, radius}) =>
    Math.max(most, Math.hypot(...xyz.map((x, k) => x - middle[k])) + radius), 0);
  file.centre = middle.join();
  file.scale = String(0.48 * SIZE / reach);
  file.unit = input.unit === 'angstrom' ? 'Å' : '';
  const another = shown?.name !== name;
  for (const worker of [shown?.numbers, shown?.pictures]) worker?.end();
  file.pictures = program_with(files);
  shown = file;
  drawing = draw_again = false;
  element('models').hidden = !(input.models > 1);
  element('model').max = element('last_model').textContent = input.models;
  if (!again) element('model').value = 1;
  for (const span of document.querySelectorAll('.unit')) span.textContent = file.unit;
  element('name').textContent = name;
  element('read').textContent = `${n} balls, ` +
    (input.unit === 'angstrom' ? 'lengths in angstrom (Å)' : 'lengths in the unit of the file') +
    (input.left_out.water > 0 ? `; ${input.left_out.water} atoms of water are left out` : '');
  element('numbers').setAttribute('aria-busy', 'true');
  saves(file);
  another ? back() : draw();
  await fill(file);
}

async function take(list, rank) {
  const files = {};
  ++reading;
  try {
    for (const one of list) {
      let bytes = new Uint8Array(await one.arrayBuffer());
      // A name that begins with - would be an option.
      let name = one.name.replace(/^-/, '_');
      if (/\.gz$/i.test(name)) [name, bytes] = [name.slice(0, -3), await unpacked(bytes)];
      files[name] = bytes;
    }
  } finally {
    --reading;
  }
  const names = Object.keys(files);
  const run = names.find(name => A_RUN.test(name));
  const molecule = names.find(name => name !== run);
  if (molecule !== undefined) await load(files, molecule, run, rank);
  else if (run !== undefined && wanted) await load({...wanted.files, ...files}, wanted.name, run, rank);
}

async function take_safely(list) {
  try {
    await take([...list], ++last_rank);
  } catch (error) {
    element('message').textContent = error.message;
  }
}

element('file').addEventListener('change', ({target}) => {
  take_safely(target.files);
  target.value = ''; // so that the same file, which may have changed, can be chosen again
});
addEventListener('dragover', event => {
  event.preventDefault();
  document.body.classList.add('over');
});
addEventListener('dragleave', () => document.body.classList.remove('over'));
addEventListener('drop', event => {
  event.preventDefault();
  document.body.classList.remove('over');
  take_safely(event.dataTransfer.files);
});

element('options').addEventListener('submit', event => event.preventDefault());
for (const id of ['probe', 'wide', 'radii', 'water', 'model']) {
  // What is read comes with the options of then.
  element(id).addEventListener('change', () => reading === 0 && wanted && load(wanted.files, wanted.name, wanted.run));
}
for (const id of ['kind', 'colour']) element(id).addEventListener('change', draw);

for (const button of document.querySelectorAll('[data-turn]')) {
  const [across, down] = button.dataset.turn.split(',').map(Number);
  button.addEventListener('click', () => turn(STEP * across, STEP * down));
}
for (const button of document.querySelectorAll('[data-zoom]')) {
  button.addEventListener('click', () => go_closer(Number(button.dataset.zoom)));
}
document.querySelector('[data-back]').addEventListener('click', back);

const KEYS = {ArrowLeft: () => turn(-STEP, 0), ArrowRight: () => turn(STEP, 0), ArrowUp: () => turn(0, -STEP),
  ArrowDown: () => turn(0, STEP), '+': () => go_closer(1.25), '=': () => go_closer(1.25), '-': () => go_closer(0.8),
  0: back};
picture.addEventListener('keydown', event => {
  if (KEYS[event.key] === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
  event.preventDefault();
  KEYS[event.key]();
});
picture.addEventListener('wheel', event => {
  event.preventDefault();
  const {x, y, width, height} = picture.getBoundingClientRect();
  go_closer(Math.exp(-0.0015 * event.deltaY), (event.clientX - x) / width, (event.clientY - y) / height);
}, {passive: false});
picture.addEventListener('pointerdown', event => picture.setPointerCapture(event.pointerId));
picture.addEventListener('pointermove', event => {
  if (event.buttons & 1) {
    turn(TURN * event.movementX, TURN * event.movementY);
    return;
  }
  const seen = event.target.closest('[data-ball]');
  const ball = seen && shown.measured.balls[seen.dataset.ball];
  element('ball').textContent = !ball ? '' :
    `${ball.residue ? `${ball.atom} of ` : ''}${residue(seen.dataset.ball)}: radius ${length(ball.radius)}, ` +
    `free area with the probe ${length(ball.area.toFixed(3))}${shown.unit && '²'}`;
});

function set_theme(dark) {
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  if (shown) draw();
}
const system = matchMedia('(prefers-color-scheme: dark)');
system.addEventListener('change', () => set_theme(system.matches));
element('theme').addEventListener('click', () => set_theme(document.documentElement.dataset.theme !== 'dark'));

// ---- a first molecule, so that there is something to turn

set_theme(system.matches);
back();
const first = await unpacked(packed('first'));
const about = program_with({}); // not the first molecule's, which another file may end
about.text(['--version']).then(version => {
  element('version').textContent = version;
  about.end();
});
await load({'crambin.pdb': first}, 'crambin.pdb');
document.body.dataset.ready = 'yes';
