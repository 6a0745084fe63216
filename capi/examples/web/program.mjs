// The program hardsphere as a function: arguments and files in, standard output out. It needs of WASI, the system
// interface, arguments, three standard streams, and one folder of files in memory that are only read; there is nothing
// outside.

// Numbers of WASI, preview 1.
const SUCCESS = 0, BAD_DESCRIPTOR = 8, NO_FILE = 44, NO_SYSTEM_CALL = 52, READ_ONLY = 69, NO_SEEK = 70;
const CHARACTER_DEVICE = 2, DIRECTORY = 3, REGULAR_FILE = 4;
const FOLDER = 3; // the descriptor of the one folder, behind those of the streams
const CREATE_OR_EMPTY = 1 | 8; // of the flags by which a file is opened

class Exit {
  constructor(status) {
    this.status = status;
  }
}

// Arguments, as bytes that end with 0 each.
function encoded(words) {
  return words.map(word => new TextEncoder().encode(word + '\0'));
}

function joined(chunks) {
  const all = new Uint8Array(chunks.reduce((sum, chunk) => sum + chunk.length, 0));
  let at = 0;
  for (const chunk of chunks) {
    all.set(chunk, at);
    at += chunk.length;
  }
  return all;
}

// Run a compiled module: run(module, ['draw', 'x.pdb', ...], {'x.pdb': bytes}) gives {status, output, errors}, where
// output is bytes.
export function run(module, words, files) {
  const arguments_ = encoded(['hardsphere', ...words]);
  const written = [[], [], []];
  const names = Object.keys(files);
  const open = []; // {name, at} of the descriptors behind the folder's
  let memory;
  const view = () => new DataView(memory.buffer);
  const bytes = (at, length) => new Uint8Array(memory.buffer, at, length);
  const opened = descriptor => open[descriptor - FOLDER - 1];
  const name_at = (at, length) => new TextDecoder().decode(bytes(at, length)).replace(/^(\.?\/)+/, '');

  // Calls body(address, length) for each of `count` pieces of memory, until it does not use one up; the sum of what it
  // does.
  const over_pieces = (pieces, count, body) => {
    let sum = 0;
    for (let k = 0; k < count; ++k) {
      const length = view().getUint32(pieces + 8 * k + 4, true);
      const done = body(view().getUint32(pieces + 8 * k, true), length);
      sum += done;
      if (done < length) break;
    }
    return sum;
  };
  const put_status = (at, kind, name) => {
    bytes(at, 64).fill(0);
    view().setBigUint64(at + 8, BigInt(names.indexOf(name) + 1), true); // what tells files apart
    view().setUint8(at + 16, kind);
    if (kind === REGULAR_FILE) view().setBigUint64(at + 32, BigInt(files[name].length), true);
    return SUCCESS;
  };
  const kind_of = descriptor =>
    descriptor < FOLDER ? CHARACTER_DEVICE : descriptor === FOLDER ? DIRECTORY : opened(descriptor) && REGULAR_FILE;

  const system = {
    args_sizes_get(count, size) {
      view().setUint32(count, arguments_.length, true);
      view().setUint32(size, arguments_.reduce((sum, word) => sum + word.length, 0), true);
      return SUCCESS;
    },
    args_get(places, at) {
      for (const word of arguments_) {
        view().setUint32(places, at, true);
        bytes(at, word.length).set(word);
        places += 4;
        at += word.length;
      }
      return SUCCESS;
    },
    environ_sizes_get(count, size) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return SUCCESS;
    },
    environ_get: () => SUCCESS,
    fd_prestat_get(descriptor, at) {
      if (descriptor !== FOLDER) return BAD_DESCRIPTOR;
      view().setUint32(at, 0, true);
      view().setUint32(at + 4, 1, true); // the length of its name
      return SUCCESS;
    },
    fd_prestat_dir_name(descriptor, at) {
      bytes(at, 1)[0] = '.'.charCodeAt(0);
      return SUCCESS;
    },
    fd_fdstat_get(descriptor, at) {
      const kind = kind_of(descriptor);
      if (!kind) return BAD_DESCRIPTOR;
      bytes(at, 24).fill(0);
      view().setUint8(at, kind);
      view().setBigUint64(at + 8, ~0n, true); // all rights, for files in a folder too
      view().setBigUint64(at + 16, ~0n, true);
      return SUCCESS;
    },
    fd_filestat_get(descriptor, at) {
      const kind = kind_of(descriptor);
      return kind ? put_status(at, kind, opened(descriptor)?.name) : BAD_DESCRIPTOR;
    },
    path_filestat_get(descriptor, flags, path, length, at) {
      const name = name_at(path, length);
      return names.includes(name) ? put_status(at, REGULAR_FILE, name) : NO_FILE;
    },
    path_open(descriptor, look, path, length, flags, rights, inherited, mode, at) {
      const name = name_at(path, length);
      if (flags & CREATE_OR_EMPTY) return READ_ONLY;
      if (!names.includes(name)) return NO_FILE;
      view().setUint32(at, FOLDER + open.push({name, at: 0}), true);
      return SUCCESS;
    },
    fd_seek(descriptor, offset, whence, at) {
      const file = opened(descriptor);
      if (!file) return NO_SEEK;
      file.at = Number(offset) + [0, file.at, files[file.name].length][whence];
      view().setBigUint64(at, BigInt(file.at), true);
      return SUCCESS;
    },
    fd_close: () => SUCCESS,
    fd_read(descriptor, pieces, count, got) {
      const file = opened(descriptor);
      if (!file && descriptor !== 0) return BAD_DESCRIPTOR;
      view().setUint32(got, over_pieces(pieces, count, (at, length) => {
        const some = file ? files[file.name].subarray(file.at, file.at + length) : [];
        bytes(at, some.length).set(some);
        if (file) file.at += some.length;
        return some.length;
      }), true);
      return SUCCESS;
    },
    fd_write(descriptor, pieces, count, done) {
      if (descriptor !== 1 && descriptor !== 2) return BAD_DESCRIPTOR;
      view().setUint32(done, over_pieces(pieces, count, (at, length) => {
        written[descriptor].push(bytes(at, length).slice());
        return length;
      }), true);
      return SUCCESS;
    },
    proc_exit(status) {
      throw new Exit(status);
    },
  };
  // Whatever else the C library may ask for is not there.
  const missing = {};
  for (const {name} of WebAssembly.Module.imports(module)) missing[name] = () => NO_SYSTEM_CALL;

  const instance = new WebAssembly.Instance(module, {wasi_snapshot_preview1: {...missing, ...system}});
  memory = instance.exports.memory;
  let status = 0;
  try {
    instance.exports._start();
  } catch (thrown) {
    if (!(thrown instanceof Exit)) throw thrown;
    status = thrown.status;
  }
  return {status, output: joined(written[1]), errors: new TextDecoder().decode(joined(written[2]))};
}
