// The code of the page while files and options come in faster than the program answers: the last one that was asked for
// is shown, however long earlier ones take. Elements, workers and answers are stand-ins; files named big take longer,
// and so does the first molecule.
//   web_page_order.mjs PAGE.mjs
import {readFileSync} from 'node:fs';

const code = readFileSync(process.argv[2], 'utf8');
const wait = time => new Promise(resolve => setTimeout(resolve, time));
const elements = {};
class Element {
  constructor(id) {
    Object.assign(this, {id, value: '', textContent: '', hidden: true, dataset: {}, listeners: {}, parentNode: {}});
    this.classList = {add() {}, remove() {}, toggle() {}};
  }
  append() {}
  appendChild(child) {
    return child;
  }
  replaceChildren() {}
  setAttribute() {}
  getAttribute() {
    return '0 0 1 1';
  }
  querySelectorAll() {
    return [];
  }
  get firstElementChild() {
    return new Element();
  }
  addEventListener(type, listener) {
    this.listeners[type] = listener;
  }
}
const values = {probe: '1.4', wide: '3', radii: 'bondi', kind: 'balls', colour: 'element'};
const element = id => elements[id] ??= Object.assign(new Element(id), {value: values[id] ?? ''});
const ball = {xyz: [0, 0, 0], radius: 1, area: 1};
const input = {water_atoms: 0, balls: 1, unit: 'angstrom', models: 1, left_out: {water: 0}};
const answers = {measure: {n: 1, area: 1, volume: 1, balls: [ball], means: [], input}, voids: {voids: []},
  pores: {pocket_list: []}};
const commands = []; // those that were answered
class Worker {
  alive = true;
  addEventListener(type, listener) {
    this.listener = listener;
  }
  terminate() {
    this.alive = false;
  }
  async postMessage({words}) {
    if (words === undefined) return; // the module and the files
    await wait(/^(big|crambin)/.test(words[1]) ? 80 : 5);
    if (!this.alive) return;
    commands.push(words.join(' '));
    const output = answers[words[0]] === undefined ? '<svg/>' : JSON.stringify(answers[words[0]]);
    this.listener({data: {status: 0, output: new TextEncoder().encode(output), errors: ''}});
  }
}
Blob.prototype.stream = () => ({pipeThrough: () => ''});
URL.createObjectURL = () => '';
WebAssembly.compile = async () => ({});
Object.assign(globalThis, {Worker, Node: Element, DecompressionStream: class {}, Response: class {
  arrayBuffer = async () => new ArrayBuffer(0);
}, atob: () => '', addEventListener() {}, matchMedia: () => new Element(), document: {getElementById: element,
  createElement: () => new Element(), querySelectorAll: () => [], querySelector: () => new Element(),
  documentElement: new Element(), body: new Element()}});

const AsyncFunction = (async () => {}).constructor;
const page = new AsyncFunction(code)();
const drop = (name, takes = 0) => elements.file.listeners.change({target: {files: [{name, arrayBuffer: async () => {
  await wait(takes);
  return new ArrayBuffer(1);
}}]}});
async function shows(name, what) {
  await wait(2000);
  if (elements.name.textContent === name && elements.message.textContent === '') return;
  throw new Error(`${what}: ${elements.name.textContent} is shown; ${elements.message.textContent}`);
}

await wait(40);
drop('small.pdb');
await page;
await shows('small.pdb', 'a file before the first molecule is there');
if (document.body.dataset.ready !== 'yes') throw new Error('the page is not ready');

drop('big_1.pdb');
await wait(20);
drop('small_1.pdb');
await shows('small_1.pdb', 'a small file after a large one');

drop('slow.pdb', 100);
drop('small_2.pdb');
await shows('small_2.pdb', 'a file after one that takes long to read');

drop('big_2.pdb');
await wait(20);
elements.probe.value = '1.1';
elements.probe.listeners.change();
await shows('big_2.pdb', 'a probe that is changed while a file comes');
if (!commands.some(line => line.startsWith('voids big_2.pdb --probe 1.1'))) throw new Error('the probe is the old one');

drop('slow_2.pdb', 100);
await wait(20);
elements.probe.listeners.change();
await shows('slow_2.pdb', 'a probe that is changed while a file is read');
console.log(`${commands.length} answers, in the order in which they were asked for`);
