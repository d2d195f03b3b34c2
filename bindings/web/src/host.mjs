// SPDX-License-Identifier: MIT
// Starts the module, and stands between it and JavaScript: what it imports, and what happens when a call fails.
import { LangevinRigidError } from './errors.mjs';
import { headerVersion, LR, structs } from './generated/api.mjs';
import { Heap, Scratch } from './heap.mjs';

const outOfMemory = Symbol('out of memory');
const defect = Symbol('defect');

// WASI's error numbers.
const BAD_DESCRIPTOR = 8;
const NOT_CAPABLE = 76;

/** There are no files here: assets are fetched, and given as bytes. */
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
  #thrown = null; // by a callback, kept until the call that it was in has returned
  #broken = null;

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
      throw new Error(`langevin_rigid.wasm is version ${versionText(version)}, its wrapper ${versionText(headerVersion)}: take both from one package`);
    return host;
  }

  get raw() {
    return this.#exports;
  }

  get version() {
    return versionText(this.#exports.lr_version());
  }

  // 0, or 1 where the callback has thrown: a recording ends by that.
  #answer(id, values) {
    if (this.#thrown) return 1;
    try {
      this.#callbacks.get(id)?.(...values());
      return 0;
    } catch (error) { // must not run through frames of C++ in the middle of a step
      this.#thrown = { error };
      return 1;
    }
  }

  /** A number that stands for a function in the module. */
  addCallback(callback) {
    if (typeof callback !== 'function') throw new TypeError(`a callback must be a function, not ${typeof callback}`);
    const id = this.#nextCallback++;
    this.#callbacks.set(id, callback);
    return id;
  }

  removeCallback(id) {
    this.#callbacks.delete(id);
  }

  /** Calls a C function and gives what it returns. */
  invoke(name, ...values) {
    if (this.#broken) throw new Error(`the module stopped in ${this.#broken} and can't be used any more: load() another`);
    const stack = this.#exports.__stack_pointer;
    const top = stack.value;
    let result;
    try {
      result = this.#exports[name](...values);
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
    return result;
  }

  /** Gives something back to the module, if that still works: from finalizers too, which have nobody to throw at. */
  release(name, address) {
    if (!this.#broken) this.invoke(name, address);
  }

  error(name, status, detail = '') {
    return new LangevinRigidError(status, name, this.heap.string(this.#exports.lr_status_string(status)), detail);
  }

  /** Calls a C function that returns a status, and throws what is not LR_OK. `said`: what the library logged of it. */
  call(said, name, ...values) {
    const status = this.invoke(name, ...values);
    if (status !== LR.OK) throw this.error(name, status, said() || this.heap.string(this.#exports.lr_last_error()));
  }

  /** Runs use(scratch), whose memory then ends. */
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

/** The bytes at an address: of the web, or a file where there is a node. */
export async function readBytes(source, what) {
  const url = source instanceof URL ? source : new URL(String(source), globalThis.location?.href ?? `file://${globalThis.process?.cwd()}/`);
  if (url.protocol === 'file:' && globalThis.process?.versions?.node) {
    const fileSystem = 'node:fs/promises'; // not a literal: bundlers for browsers would look for it
    const { readFile } = await import(/* @vite-ignore */ /* webpackIgnore: true */ fileSystem);
    return new Uint8Array(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${what}: ${url.href} answers ${response.status} ${response.statusText}`);
  const bytes = new Uint8Array(await response.arrayBuffer());
  if (response.headers.get('content-type')?.startsWith('text/html'))
    throw new Error(`${what}: ${url.href} is a page, not the file: the server gives index.html for what it doesn't have`);
  return bytes;
}
