// Drives headless Chromium through its debugging pipe (messages of JSON, each ended by a 0) as a person would: chooses each
// file, drags, points; the page has to show the native program's digits and the bytes of its pictures.
//   node web_page.mjs PAGE.html PROFILE-FOLDER HARDSPHERE FILE...
import {execFileSync, spawn} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {resolve} from 'node:path';

const [page, profile, program, ...files] = process.argv.slice(2);
const browser = spawn('chromium', ['--headless', '--no-sandbox', '--disable-gpu', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--disable-dev-shm-usage', '--no-first-run', '--remote-debugging-pipe',
  `--user-data-dir=${profile}`, '--window-size=900,1000', 'about:blank'],
  {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
process.on('exit', () => browser.kill('SIGKILL'));

const waiting = new Map();
let last = 0, unread = '';
browser.stdio[4].setEncoding('utf8').on('data', text => {
  const messages = (unread + text).split('\0');
  unread = messages.pop();
  for (const message of messages.map(one => JSON.parse(one))) {
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

const {targetId} = await send('Target.createTarget', {url: 'file://' + resolve(page)});
({sessionId} = await send('Target.attachToTarget', {targetId, flatten: true}));
async function evaluate(expression) {
  const {result, exceptionDetails} = await send('Runtime.evaluate',
    {expression, returnByValue: true, awaitPromise: true});
  if (exceptionDetails) throw new Error(JSON.stringify(exceptionDetails));
  return result.value;
}
// Until an expression is true of the page.
async function until(expression) {
  for (let tries = 0; tries < 600; ++tries) {
    if (await evaluate(expression)) return;
    await new Promise(done => setTimeout(done, 50));
  }
  throw new Error(`never true: ${expression}; message: ${await evaluate('document.getElementById("message")?.textContent')}`);
}
const text = id => evaluate(`document.getElementById('${id}').textContent`);
const mouse = (type, [x, y], buttons = 0) => send('Input.dispatchMouseEvent',
  {type, x, y, buttons, button: type === 'mouseMoved' ? 'none' : 'left', clickCount: type === 'mouseMoved' ? 0 : 1});
const native = (words, file) => execFileSync(program, words, {input: readFileSync(file), encoding: 'utf8'});
function same(what, shown, wanted) {
  if (shown === wanted) return;
  throw new Error(`${what}: the page has\n${shown.slice(0, 300)}\nthe program has\n${wanted.slice(0, 300)}`);
}
// What part of the picture is black on the screen, in percent: decoded by the browser itself.
async function black(where) {
  const {data} = await send('Page.captureScreenshot', {format: 'png', clip: {...where, scale: 1}});
  return evaluate(`(async () => {
    const image = await createImageBitmap(await (await fetch('data:image/png;base64,${data}')).blob());
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    const rgba = context.getImageData(0, 0, image.width, image.height).data;
    let found = 0;
    for (let k = 0; k < rgba.length; k += 4) found += Math.max(rgba[k], rgba[k + 1], rgba[k + 2]) < 24;
    return 400 * found / rgba.length;
  })()`);
}
// The picture is what the native program draws by the same command line.
async function same_picture(file) {
  const words = JSON.parse(await evaluate('document.getElementById("picture").dataset.command'));
  same('picture', await evaluate('fetch(document.getElementById("save").href).then(answer => answer.text())'),
    native(words, file));
  return words;
}

await until('document.body?.dataset.ready === "yes"');
const {root} = await send('DOM.getDocument');
const {nodeId} = await send('DOM.querySelector', {nodeId: root.nodeId, selector: '#file'});
let pointed = 0;
for (const file of files) {
  const name = file.replace(/^.*\//, '');
  await evaluate('document.getElementById("totals").textContent = ""');
  await send('DOM.setFileInputFiles', {nodeId, files: [resolve(file)]});
  await until('document.getElementById("totals").textContent !== "" && document.querySelector("#picture svg") !== null');

  const format = name.replace(/^.*\./, '');
  const measured = JSON.parse(native(['measure', '-', '--format', format, '--per-ball', '--json'], file)); // no water in them
  same('totals', await text('totals'), `${measured.n} balls, area ${measured.area}, volume ${measured.volume}`);
  const before = await same_picture(file);

  // Turned by dragging: another direction, another picture.
  const {x, y, width, height} = JSON.parse(await evaluate(
    'JSON.stringify(document.getElementById("picture").getBoundingClientRect())'));
  const at = (across, down) => [x + across * width, y + down * height];
  await mouse('mouseMoved', at(0.3, 0.3));
  await mouse('mousePressed', at(0.3, 0.3), 1);
  for (const step of [0.4, 0.5]) await mouse('mouseMoved', at(step, 0.35), 1);
  await until(`document.getElementById("picture").dataset.command !== ${JSON.stringify(JSON.stringify(before))}`);
  await mouse('mouseReleased', at(0.5, 0.35));
  await evaluate('new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))');
  await same_picture(file);

  // The ball under the pointer is named with its area, and nothing is painted over its neighbours.
  const picture = {x, y, width, height};
  await mouse('mouseMoved', at(0.001, 0.001));
  const dark = await black(picture);
  for (const across of [0.35, 0.5, 0.6]) {
    for (const down of [0.4, 0.5, 0.65]) {
      await mouse('mouseMoved', at(across, down));
      const shown = await text('ball');
      const found = await evaluate(`document.elementFromPoint(${at(across, down).join()}).closest('[data-ball]')?.dataset.ball`);
      if (found === undefined) {
        same('no ball', shown, '');
        continue;
      }
      const ball = measured.balls[found];
      if (!shown.endsWith(`: radius ${ball.radius}, area ${ball.area}`)) throw new Error(`ball ${found}: ${shown}`);
      const painted = await black(picture) - dark;
      if (painted > 2) throw new Error(`ball ${found}: ${painted.toFixed(1)} % of the picture are painted black`);
      ++pointed;
    }
  }
  console.log(`${name}: ${await text('totals')}; ${await text('ball')}`);
}
if (pointed < 6) throw new Error(`only ${pointed} balls were under the pointer`);
// Chromium's processes write into the profile until the last of them is gone: it ends by itself, then so does this.
const ended = new Promise(done => browser.once('exit', done));
sessionId = undefined; // a wish to the browser, not to the page
send('Browser.close');
await ended;
process.exit(0);
