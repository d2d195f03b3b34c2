// SPDX-License-Identifier: MIT
// Starts the module and connects it to JavaScript: its imports, callbacks, and failed calls.
import { LangevinRigidError } from './errors.mjs';
import { headerVersion, LR, structs } from './generated/api.mjs';
import { Heap, Scratch } from './heap.mjs';

const outOfMemory = Symbol('out of memory');
const defect = Symbol('defect');

// WASI's error numbers.
const BAD_DESCRIPTOR = 8;
const NOT_CAPABLE = 76;

/** The module has no files: assets are fetched and loaded from bytes. */
function wasiImports(heap) {
  const none = () => BAD_DESCRIPTOR;
  return {
    clock_time_get(_clock, _precision, out) {
      heap().view.setBigUint64(out, BigInt(Math.round(performance.now() * 1e6)), true);
      return 0;
    },
    fd_close: none, fd_fdstat_get: none, fd_fdstat_set_flags: none, fd_prestat_get: none, fd_prestat_dir_name: none, fd_read: none,
    fd_seek: none, fd_write: none,
    path_open: () => NOT_CAPABLE,
    proc_exit() {
      throw defect;
    },
  };
}

function queryArrays(heap, name, address) {
  const query = heap.read(name, address);
  for (const [field, , type, count] of structs[name].fields)
    if (type === 'pointer' && count !== 0)
      query[field] = query[field].map((at) => heap.array(Float32Array, at, query.count));
  query.height &&= heap.array(Float32Array, query.height, query.count);
  return query;
}

export class Host {
  #exports;
  #callbacks = new Map();
  #nextCallback = 1;
  #thrown = null; // by a callback; kept until the call around it has returned
  #broken = null;
  result = null; // of the last C function, also where invoke() throws the exception of a callback

  static async create(source) {
    const host = new Host();
    const imports = {
      langevin_rigid: {
        log: (id, level, message) => host.#answer(id, () => [level, host.heap.string(message)]),
        fault: (id, number, where, what, remedy) => host.#answer(id, () => [{
          number: number >>> 0, where: host.heap.string(where), what: host.heap.string(what), remedy: host.heap.string(remedy),
        }]),
        wind: (id, query) => host.#answer(id, () => [queryArrays(host.heap, 'lr_wind_query', query)]),
        surface: (id, query) => host.#answer(id, () => [queryArrays(host.heap, 'lr_water_query', query)]),
        record: (id, bytes, size) => host.#answer(id, () => [host.heap.array(Uint8Array, bytes, Number(size)).slice()]),
        out_of_memory() {
          throw outOfMemory;
        },
        defect() {
          throw defect;
        },
      },
      wasi_snapshot_preview1: wasiImports(() => host.heap),
    };
    const instance = await instantiate(source, imports);
    host.#exports = instance.exports;
    host.heap = new Heap(instance.exports);
    instance.exports._initialize();
    const version = instance.exports.lr_version();
    if (version >>> 12 !== headerVersion >>> 12)
      throw new Error(`langevin_rigid.wasm is version ${versionText(version)}, but its wrapper is ${versionText(headerVersion)}: take both from the same package`);
    return host;
  }

  get raw() {
    return this.#exports;
  }

  get lastError() {
    return this.heap.string(this.#exports.lr_last_error());
  }

  get version() {
    return versionText(this.#exports.lr_version());
  }

  // 0, or 1 if the callback has thrown, which ends a recording.
  #answer(id, values) {
    if (this.#thrown) return 1;
    try {
      this.#callbacks.get(id)?.(...values());
      return 0;
    } catch (error) { // an exception must not unwind C++ frames in the middle of a step
      this.#thrown = { error };
      return 1;
    }
  }

  /** A number that stands for a JavaScript function in the module. */
  addCallback(callback) {
    if (typeof callback !== 'function') throw new TypeError(`a callback must be a function, not ${typeof callback}`);
    const id = this.#nextCallback++;
    this.#callbacks.set(id, callback);
    return id;
  }

  removeCallback(id) {
    this.#callbacks.delete(id);
  }

  /** Calls a C function and returns its result. */
  invoke(name, ...values) {
    if (this.#broken) throw new Error(`the module stopped in ${this.#broken} and can't be used any more: load() another`);
    const stack = this.#exports.__stack_pointer;
    const top = stack.value;
    this.result = null;
    try {
      this.result = this.#exports[name](...values);
    } catch (error) {
      stack.value = top;
      if (error === outOfMemory) return LR.ERROR_OUT_OF_MEMORY;
      if (error === defect || error instanceof WebAssembly.RuntimeError) {
        this.#broken = name;
        throw this.error(name, LR.ERROR_INTERNAL, error === defect ? '' : String(error.message));
      }
      throw error;
    }
    if (this.#thrown) {
      const { error } = this.#thrown;
      this.#thrown = null;
      throw error;
    }
    return this.result;
  }

  /** Frees an object of the module, if the module still works. Never throws, because finalizers call it too. */
  release(name, address) {
    if (!this.#broken) this.invoke(name, address);
  }

  error(name, status, detail = '') {
    return new LangevinRigidError(status, name, this.heap.string(this.#exports.lr_status_string(status)), detail);
  }

  /** Calls a C function that returns a status, and throws unless it is LR_OK. `said`: the library's log of the call. */
  call(said, name, ...values) {
    const status = this.invoke(name, ...values);
    if (status !== LR.OK) throw this.error(name, status, said() || this.lastError);
  }

  /** Runs use(scratch), then frees the scratch memory. */
  scratch(use) {
    const scratch = new Scratch(this.heap, (init, address, size) => this.#exports[init](address, size),
      () => this.error('malloc', LR.ERROR_OUT_OF_MEMORY));
    try {
      return use(scratch);
    } finally {
      scratch.release();
    }
  }
}

const versionText = (packed) => `${packed >>> 22}.${(packed >>> 12) & 0x3ff}.${packed & 0xfff}`;

async function instantiate(source, imports) {
  if (source instanceof WebAssembly.Module) return WebAssembly.instantiate(source, imports);
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source)) return (await WebAssembly.instantiate(source, imports)).instance;
  return (await WebAssembly.instantiate(await readBytes(source, 'langevin_rigid.wasm'), imports)).instance;
}

/** The bytes at a URL, or in node of a file. */
export async function readBytes(source, what) {
  const url = source instanceof URL ? source : new URL(String(source), globalThis.location?.href ?? `file://${globalThis.process?.cwd()}/`);
  if (url.protocol === 'file:' && globalThis.process?.versions?.node) {
    const fileSystem = 'node:fs/promises'; // not a literal: bundlers for browsers would search for the module
    const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ fileSystem);
    return new Uint8Array(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${what}: ${url.href} returned ${response.status} ${response.statusText}`);
  const bytes = new Uint8Array(await response.arrayBuffer());
  if (response.headers.get('content-type')?.startsWith('text/html'))
    throw new Error(`${what}: ${url.href} is a page, not the file: the server returns index.html for missing files`);
  return bytes;
}
