// The program hardsphere as a function: arguments and standard input in, standard output out. It needs of WASI, the system
// interface, only arguments and the three standard streams; there are no files, and no access to anything outside.

// Numbers of WASI, preview 1.
const SUCCESS = 0, BAD_DESCRIPTOR = 8, NO_SYSTEM_CALL = 52, NO_SEEK = 70;
const CHARACTER_DEVICE = 2;

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
  return new TextDecoder().decode(all);
}

// Run a compiled module: run(module, ['draw', '-', ...], bytes) gives {status, output, errors}.
export function run(module, words, input) {
  const arguments_ = encoded(['hardsphere', ...words]);
  const written = [[], [], []];
  let read = 0;
  let memory;
  const view = () => new DataView(memory.buffer);
  const bytes = (at, length) => new Uint8Array(memory.buffer, at, length);

  // Calls body(address, length) for each of `count` pieces of memory, until it does not use one up; the sum of what it does.
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
    fd_fdstat_get(descriptor, at) {
      if (descriptor > 2) return BAD_DESCRIPTOR;
      bytes(at, 24).fill(0);
      view().setUint8(at, CHARACTER_DEVICE);
      view().setBigUint64(at + 8, ~0n, true); // all rights
      return SUCCESS;
    },
    fd_filestat_get(descriptor, at) {
      if (descriptor > 2) return BAD_DESCRIPTOR;
      bytes(at, 64).fill(0);
      view().setUint8(at + 16, CHARACTER_DEVICE);
      return SUCCESS;
    },
    fd_prestat_get: () => BAD_DESCRIPTOR, // no folder is open
    fd_seek: () => NO_SEEK,
    fd_close: () => SUCCESS,
    fd_read(descriptor, pieces, count, got) {
      if (descriptor !== 0) return BAD_DESCRIPTOR;
      view().setUint32(got, over_pieces(pieces, count, (at, length) => {
        const some = input.subarray(read, read + length);
        bytes(at, some.length).set(some);
        read += some.length;
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
  return {status, output: joined(written[1]), errors: joined(written[2])};
}
