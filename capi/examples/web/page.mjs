// The page: a file is chosen, turned by dragging, drawn anew each time as exact SVG; the ball under the pointer is named with
// its free area. All geometry comes from the program hardsphere, which runs here, in the page.
import {run} from './program.mjs';

const SIZE = 640; // the picture's sides, in px
const TURN = 0.01; // radians for a px of dragging

const element = id => document.getElementById(id);
const compressed = Uint8Array.from(atob(element('program').textContent.trim()), letter => letter.charCodeAt(0));
const module = await WebAssembly.compile(await new Response(
    new Blob([compressed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());

let file; // what was chosen: its bytes and options, the areas of its balls, and how it is placed in the picture
let right, up; // of the viewer, unit vectors
let waiting = false;

function fail(text) {
  element('totals').textContent = '';
  element('message').textContent = text;
}

function call(words) {
  const result = run(module, words, file.bytes);
  if (result.status !== 0) throw new Error(result.errors);
  return result.output;
}

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = a => a.map(x => x / Math.hypot(...a));
const sum = (a, s, b, t) => a.map((x, i) => s * x + t * b[i]);

function draw() {
  const arguments_ = ['draw', '-', ...file.options, '-o', '-', '--picture', 'svg', '--pieces', 'visible', '--title',
    file.name, '--view', cross(right, up).join(), '--up', up.join(), '--scale', file.scale, '--centre', file.centre,
    '--width', String(SIZE), '--height', String(SIZE)];
  element('picture').innerHTML = file.svg = call(arguments_);
  element('save').href = URL.createObjectURL(new Blob([file.svg], {type: 'image/svg+xml'}));
  element('save').download = file.name.replace(/\.[^.]*$/, '') + '.svg';
  element('picture').dataset.command = JSON.stringify(arguments_);
}

// A picture for each frame of the screen, however many steps the pointer makes.
function draw_soon() {
  if (waiting) return;
  waiting = true;
  requestAnimationFrame(() => {
    waiting = false;
    draw();
  });
}

function show(name, bytes) {
  element('message').textContent = element('ball').textContent = '';
  const format = name.replace(/^.*\./, '').toLowerCase().replace('ent', 'pdb');
  const options = ['--format', format];
  if (/^(pdb|cif|gro|pqr)$/.test(format)) options.push('--no-water'); // the others do not say what is water
  file = {name, bytes, options};
  try {
    const measured = JSON.parse(call(['measure', '-', ...options, '--per-ball', '--json']));
    file.balls = measured.balls;
    element('totals').textContent =
        `${measured.n} balls, area ${measured.area}, volume ${measured.volume}`;
    const middle = [0, 1, 2].map(k => file.balls.reduce((sum, ball) => sum + ball.xyz[k] / measured.n, 0));
    const reach = Math.max(...file.balls.map(
        ({xyz, radius}) => Math.hypot(...sum(xyz, 1, middle, -1)) + radius));
    file.centre = middle.join();
    file.scale = String(0.48 * SIZE / reach);
    right = [1, 0, 0];
    up = [0, 1, 0];
    draw();
  } catch (error) {
    file = undefined;
    element('picture').innerHTML = '';
    fail(error.message);
  }
}

element('file').addEventListener('change', async ({target}) => {
  if (target.files.length > 0) show(target.files[0].name, new Uint8Array(await target.files[0].arrayBuffer()));
});

element('picture').addEventListener('pointermove', ({target, buttons, movementX, movementY}) => {
  if (file === undefined) return;
  if (buttons & 1) {
    // The molecule turns with the pointer, hence the viewer the other way.
    const towards = cross(right, up);
    const across = -TURN * movementX, along = -TURN * movementY;
    right = unit(sum(right, Math.cos(across), towards, -Math.sin(across)));
    const back = cross(right, up);
    up = unit(sum(up, Math.cos(along), back, Math.sin(along)));
    right = unit(cross(up, cross(right, up)));
    draw_soon();
    return;
  }
  const seen = target.closest('[data-ball]');
  if (seen === null) {
    element('ball').textContent = '';
    return;
  }
  const ball = file.balls[seen.dataset.ball];
  const where = ball.atom === undefined ? `ball ${ball.ball}` :
      `${ball.atom} of ${ball.residue ?? ''} ${ball.number ?? ''} ${ball.chain ?? ''}`;
  element('ball').textContent = `${where.trim()}: radius ${ball.radius}, area ${ball.area}`;
});

document.body.dataset.ready = 'yes';
