// Drives headless Chromium through its debugging pipe (messages of JSON, each ended by a 0) as a person would: drops
// each file, turns, points, types; the page has to show the native program's digits and the bytes of its pictures, on
// screens of several kinds, and to ask no other machine for anything.
//   node web_page.mjs PAGE.html WORK-FOLDER HARDSPHERE FILE...
// FILE may be two that are dropped together, STRUCTURE+RUN. Screenshots are left in the folder.
import {execFileSync, spawn} from 'node:child_process';
import {copyFileSync, writeFileSync} from 'node:fs';
import {basename, resolve} from 'node:path';

const [page, work, program, ...files] = process.argv.slice(2);
const browser = spawn('chromium', ['--headless', '--no-sandbox', '--disable-gpu', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage', '--no-first-run',
  '--remote-debugging-pipe', `--user-data-dir=${work}/profile`, 'about:blank'],
  {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
process.on('exit', () => browser.kill('SIGKILL'));

const waiting = new Map(), heard = [];
let last = 0, unread = '';
browser.stdio[4].setEncoding('utf8').on('data', text => {
  const messages = (unread + text).split('\0');
  unread = messages.pop();
  for (const message of messages.map(one => JSON.parse(one))) {
    if (message.method) heard.push(message);
    const {resolve, reject} = waiting.get(message.id) ?? {};
    waiting.delete(message.id);
    if (message.error) reject?.(new Error(JSON.stringify(message.error)));
    else resolve?.(message.result);
  }
});
let sessionId;
const send = (method, params = {}) => new Promise((resolve, reject) => {
  waiting.set(++last, {resolve, reject});
  browser.stdio[3].write(JSON.stringify({id: last, method, params, sessionId}) + '\0');
});

async function evaluate(expression) {
  const {result, exceptionDetails} = await send('Runtime.evaluate',
    {expression, returnByValue: true, awaitPromise: true});
  if (exceptionDetails) throw new Error(JSON.stringify(exceptionDetails));
  return result.value;
}
// Until an expression is true of the page.
async function until(expression) {
  for (let tries = 0; tries < 1200; ++tries) {
    if (await evaluate(expression)) return;
    await new Promise(done => setTimeout(done, 50));
  }
  const message = await evaluate('document.getElementById("message")?.textContent');
  throw new Error(`never true: ${expression}; message: ${message}`);
}
const text = id => evaluate(`document.getElementById('${id}').textContent`);
const numbers = id => evaluate(`[...document.querySelectorAll('#${id} data')].map(one => Number(one.value))`);
const command = () => evaluate('document.getElementById("picture").dataset.command');
const mouse = (type, [x, y], buttons = 0) => send('Input.dispatchMouseEvent',
  {type, x, y, buttons, button: type === 'mouseMoved' ? 'none' : 'left', clickCount: type === 'mouseMoved' ? 0 : 1});
async function key(name) {
  for (const type of ['keyDown', 'keyUp']) await send('Input.dispatchKeyEvent', {type, key: name, code: name});
}
async function put(id, value) { // as a person does: the field changes, and the page hears of it
  await evaluate(`document.getElementById('${id}').value = '${value}';
    document.getElementById('${id}').dispatchEvent(new Event('change'))`);
}
const native = (words) => execFileSync(program, words, {cwd: work, encoding: 'utf8', maxBuffer: 1 << 28});
const native_json = words => JSON.parse(native([...words, '--json']));
function same(what, shown, wanted) {
  [shown, wanted] = [shown, wanted].map(one => typeof one === 'string' ? one : JSON.stringify(one));
  if (shown === wanted) return;
  throw new Error(`${what}: the page has\n${shown.slice(0, 300)}\nthe program has\n${wanted.slice(0, 300)}`);
}
// Shares of a part of the screen in percent, decoded by the browser itself: what is black, and what is not as its
// corner, and how light that is.
async function seen(where) {
  const {data} = await send('Page.captureScreenshot', {format: 'png', ...where && {clip: {...where, scale: 1}}});
  return {data, ...await evaluate(`(async () => {
    const image = await createImageBitmap(new Blob([Uint8Array.from(atob('${data}'), one => one.charCodeAt(0))]));
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    const rgba = context.getImageData(0, 0, image.width, image.height).data;
    let black = 0, drawn = 0;
    for (let k = 0; k < rgba.length; k += 4) {
      black += Math.max(rgba[k], rgba[k + 1], rgba[k + 2]) < 24;
      drawn += Math.abs(rgba[k] - rgba[0]) + Math.abs(rgba[k + 1] - rgba[1]) + Math.abs(rgba[k + 2] - rgba[2]) > 24;
    }
    return {black: 400 * black / rgba.length, drawn: 400 * drawn / rgba.length, ground: rgba[0]};
  })()`)};
}
// Whether the page has all of a file.
const whole = name => `document.getElementById("name").textContent === "${name}"
  && document.getElementById("numbers").ariaBusy === "false"
  && JSON.parse(document.getElementById("picture").dataset.command)[1] === "${name}"`;
const box = async () => JSON.parse(await evaluate(
  'JSON.stringify(document.getElementById("picture").getBoundingClientRect())'));
// The picture is what the native program draws by the same command line, and it fills its frame.
async function same_picture() {
  const words = JSON.parse(await command());
  same('picture', await evaluate(`(() => {
    let kept;
    const {createObjectURL} = URL, {click} = HTMLAnchorElement.prototype;
    URL.createObjectURL = blob => (kept = blob, '');
    HTMLAnchorElement.prototype.click = () => {};
    document.querySelector('#saves button').click();
    URL.createObjectURL = createObjectURL;
    HTMLAnchorElement.prototype.click = click;
    return kept.text();
  })()`), native(words));
  return words;
}
const screen = (width, height, mobile, dark) => Promise.all([
  send('Emulation.setDeviceMetricsOverride', {width, height, deviceScaleFactor: 1, mobile}),
  send('Emulation.setEmulatedMedia', {features: [{name: 'prefers-color-scheme', value: dark ? 'dark' : 'light'}]})]);

const {targetId} = await send('Target.createTarget', {url: 'about:blank'});
({sessionId} = await send('Target.attachToTarget', {targetId, flatten: true}));
await send('Network.enable');
await send('Page.enable');
await screen(1200, 1000, false, false);
const begun = Date.now();
await send('Page.navigate', {url: 'file://' + resolve(page)});
await until('document.querySelector("#picture svg") !== null');
console.log(`a picture after ${((Date.now() - begun) / 1000).toFixed(1)} s`);
await until('document.body?.dataset.ready === "yes"');

let pointed = 0;
for (const both of files) {
  const paths = both.split('+').map(path => resolve(path));
  const [name, run] = paths.map(path => basename(path));
  for (const path of paths) copyFileSync(path, `${work}/${basename(path)}`);
  const data = {items: [], files: paths, dragOperationsMask: 1};
  for (const type of ['dragEnter', 'dragOver', 'drop']) {
    await send('Input.dispatchDragEvent', {type, x: 600, y: 500, data});
  }
  await until(whole(name));
  same('message', await text('message'), '');

  const words = JSON.parse(await command());
  const options = words.slice(2, words.indexOf('-o'));
  const asked = (verb, ...more) => native_json([verb, name, ...options, ...more]);
  const measured = asked('measure', '--probe', '1.4', '--per-ball');
  const surfaces = [asked('measure'), measured, asked('measure', '--probe', '1.4', '--surface', 'ses')];
  same('areas', await numbers('areas'), surfaces.flatMap(one => [one.area, one.volume]));
  same('voids', await numbers('voids'), asked('voids', '--probe', '1.4').voids.flatMap(one => [one.volume, one.area]));
  same('pockets', await numbers('pockets'), asked('pores', '--probe', '1.4', '--pockets', '3').pocket_list
    .flatMap(one => [one.volume, one.area, one.mouths.length]));
  if (run) {
    same('run', await numbers('run'), asked('measure', '--probe', '1.4', '--trajectory', run, '--mean').means
      .flatMap(one => [one.mean, one.deviation, one.least, one.most]));
  }
  const in_angstrom = measured.input.unit === 'angstrom';
  if ((await text('areas')).includes('volume, Å³') !== in_angstrom) throw new Error(`units: ${await text('areas')}`);
  await same_picture();

  // Turned by dragging and by keys: another direction, another picture, and back.
  const {x, y, width, height} = await box();
  const at = (across, down) => [x + across * width, y + down * height];
  await mouse('mouseMoved', at(0.3, 0.3));
  await mouse('mousePressed', at(0.3, 0.3), 1);
  for (const step of [0.4, 0.5]) await mouse('mouseMoved', at(step, 0.35), 1);
  await mouse('mouseReleased', at(0.5, 0.35));
  await until(`document.getElementById("picture").dataset.command !== ${JSON.stringify(JSON.stringify(words))}`);
  await evaluate('document.getElementById("picture").focus()');
  await key('0');
  await until(`document.getElementById("picture").dataset.command === ${JSON.stringify(JSON.stringify(words))}`);
  await key('ArrowLeft');
  await until(`document.getElementById("picture").dataset.command.includes('"0.000,-15.000,0.000"')`);
  await same_picture();

  // The ball under the pointer is named with its area, and nothing is painted over its neighbours.
  const picture = {x, y, width, height};
  await mouse('mouseMoved', at(0.001, 0.001));
  const still = await seen(picture);
  if (still.drawn < 10) throw new Error(`${name}: ${still.drawn.toFixed(1)} % of the picture are drawn`);
  for (const across of [0.35, 0.5, 0.6]) {
    for (const down of [0.4, 0.5, 0.65]) {
      await mouse('mouseMoved', at(across, down));
      const shown = await text('ball');
      const found = await evaluate(
        `document.elementFromPoint(${at(across, down).join()}).closest('[data-ball]')?.dataset.ball`);
      if (found === undefined) {
        same('no ball', shown, '');
        continue;
      }
      if (!shown.includes(`probe ${measured.balls[found].area.toFixed(3)}`)) throw new Error(`ball ${found}: ${shown}`);
      const painted = (await seen(picture)).black - still.black;
      if (painted > 2) throw new Error(`ball ${found}: ${painted.toFixed(1)} % of the picture are painted black`);
      ++pointed;
    }
  }
  console.log(`${name}: ${await text('read')}; ${await text('ball')}`);
}
if (pointed < 6) throw new Error(`only ${pointed} balls were under the pointer`);

// A file at fault: what was there stays, and a line says why.
const before = await command();
writeFileSync(`${work}/wrong.pdb`, 'ATOM      1  CA\n');
const {root} = await send('DOM.getDocument');
const {nodeId} = await send('DOM.querySelector', {nodeId: root.nodeId, selector: '#file'});
await send('DOM.setFileInputFiles', {nodeId, files: [resolve(`${work}/wrong.pdb`)]});
await until('document.getElementById("message").textContent.includes("wrong.pdb")');
same('what was there', await command(), before);

// What the program says besides is shown, and a file of several molecules has a field for which.
const atoms = ['0.0000    0.0000', '1.4000    0.0000', '2.1000    1.2000', '1.4000    2.4000'];
const flat = `one\n\n\n  4  0\n${atoms.map(one => `    ${one}    0.0000 C\n`).join('')}M  END\n$$$$\n`;
writeFileSync(`${work}/flat.sdf`, flat.repeat(2));
await send('DOM.setFileInputFiles', {nodeId, files: [resolve(`${work}/flat.sdf`)]});
await until(whole('flat.sdf'));
if (!(await text('message')).includes('all z are 0')) throw new Error(`no note: ${await text('message')}`);
same('models', await evaluate('document.getElementById("models").hidden'), false);
await put('model', '2');
await until('JSON.parse(document.getElementById("picture").dataset.command).includes("--model")');

// Another file of that name, which has one molecule only, is not asked for the second one.
writeFileSync(`${work}/flat.sdf`, flat);
await send('DOM.setFileInputFiles', {nodeId, files: [resolve(`${work}/flat.sdf`)]});
await until('document.getElementById("models").hidden');
await until(whole('flat.sdf'));

// Where the program refuses to look for pockets it is not said that there are none.
await put('wide', '1');
await until('document.getElementById("message").textContent.includes("--pockets")');
if (!(await text('pockets')).endsWith('not known')) throw new Error(`pockets: ${await text('pockets')}`);
await put('wide', '3');
await until('document.getElementById("pockets").textContent.endsWith("none")');

// Of files that are on their way the last one counts, though a large one comes later.
const row = k => `${3 * (k % 30)} ${3 * (Math.floor(k / 30) % 30)} ${3 * Math.floor(k / 900)} 1.6\n`;
writeFileSync(`${work}/large.xyzr`, Array.from({length: 27000}, (_, k) => row(k)).join(''));
for (const name of ['large.xyzr', 'flat.sdf']) {
  await send('DOM.setFileInputFiles', {nodeId, files: [resolve(`${work}/${name}`)]});
}
await new Promise(done => setTimeout(done, 5000));
await until(whole('flat.sdf'));

// Screens: the first molecule in each kind of picture, light and dark, on a desk and on a telephone. Nothing is wider
// than the screen, the page is as light or dark as it should be, and the picture is not empty.
await send('DOM.setFileInputFiles', {nodeId, files: [resolve(`${work}/crambin.pdb`)]});
await until(whole('crambin.pdb'));
for (const [kind, word, width, height, mobile, dark] of [['balls', '--scale', 1200, 1000, false, false],
  ['sticks', 'ball-and-stick', 1200, 1000, false, true], ['surface', '--edge', 390, 844, true, false],
  ['cut', '--cut', 390, 844, true, true], ['pockets', '--pockets', 768, 1024, true, false]]) {
  await screen(width, height, mobile, dark);
  await until(`document.documentElement.dataset.theme === '${dark ? 'dark' : 'light'}'`);
  await evaluate('delete document.getElementById("picture").dataset.command; scrollTo(0, 0)');
  await put('kind', kind);
  await until(`(drawn => drawn?.includes("${word}") && /slide|--dark/.test(drawn) === ${dark})
    (document.getElementById("picture").dataset.command)`);
  await evaluate('new Promise(done => setTimeout(done, 300))');
  await same_picture();
  const wide = await evaluate('document.documentElement.scrollWidth');
  const whole = await send('Page.captureScreenshot', {format: 'png', captureBeyondViewport: true});
  writeFileSync(`${work}/${kind}.png`, Buffer.from(whole.data, 'base64'));
  if (wide > width) throw new Error(`${kind}: the page is ${wide} px wide on a screen of ${width}`);
  const {ground} = await seen();
  if (dark ? ground > 40 : ground < 240) throw new Error(`${kind}: the page is ${ground} of 255 light`);
  const {x, y, width: across, height: down} = await box();
  const {drawn} = await seen({x, y: y + await evaluate('scrollY'), width: across, height: down});
  if (drawn < 8) throw new Error(`${kind}: ${drawn.toFixed(1)} % of the picture are drawn`);
  console.log(`${kind}.png: ${width} px, ${dark ? 'dark' : 'light'}, ${drawn.toFixed(0)} % of the picture drawn`);
}

// By keys alone: every field and button is reached, and each is seen when it is.
const reached = new Set();
await evaluate('document.body.focus(); document.activeElement.blur()');
for (let k = 0; k < 60; ++k) {
  await key('Tab');
  reached.add(await evaluate(`(one => one.id || one.textContent || one.tagName)(document.activeElement)`));
}
for (const wanted of ['file', 'probe', 'radii', 'kind', 'theme', 'picture', 'Save: Picture, SVG']) {
  if (!reached.has(wanted)) throw new Error(`no key gets to ${wanted}: ${[...reached].join(', ')}`);
}

// Nothing was asked of any other machine.
const asked = heard.filter(({method}) => method === 'Network.requestWillBeSent').map(({params}) => params.request.url);
const outside = asked.filter(url => !/^(file|blob|data):/.test(url));
if (outside.length || !asked.length) throw new Error(`the page asked for ${outside.join(' ')} of ${asked.length}`);

// Chromium's processes write into the profile until the last of them is gone: it ends by itself, then so does this.
const ended = new Promise(done => browser.once('exit', done));
sessionId = undefined; // a wish to the browser, not to the page
send('Browser.close');
await ended;
process.exit(0);
