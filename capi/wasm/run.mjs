// Runs a program compiled for WASI with this machine's files:
//   node run.mjs PROGRAM.wasm ARGUMENT...
// Standard input, output and the exit status are the program's. It may open what is in the current folder, and in the
// folders of arguments that begin with a slash. (All of / would not do: wasi-libc drops the slash, and would look there for
// relative paths too.)
import {existsSync} from 'node:fs';
import {readFile} from 'node:fs/promises';
import {dirname} from 'node:path';
import {setFlagsFromString} from 'node:v8';
import {WASI} from 'node:wasi';

// Where another thread marks what is in use, Node 20.20 crashes at the end of a program now and then.
setFlagsFromString('--no-concurrent-marking');

const [program, ...rest] = process.argv.slice(2);
const name = program.replace(/^.*\//, '').replace(/\.wasm$/, '');
const folders = rest.filter(word => word.startsWith('/')).map(dirname).filter(existsSync);
const wasi = new WASI({
  version: 'preview1',
  args: [name, ...rest],
  preopens: {'.': '.', ...Object.fromEntries(folders.map(folder => [folder, folder]))},
  returnOnExit: true,
});
const module = await WebAssembly.compile(await readFile(program));
process.exitCode = wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject()));
