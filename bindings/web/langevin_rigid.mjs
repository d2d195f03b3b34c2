// SPDX-License-Identifier: MIT
// Langevin Rigid for the web and node: `const lr = await load()`.
import { Asset } from './src/asset.mjs';
import { Host, readBytes } from './src/host.mjs';
import { World } from './src/world.mjs';

export { Asset } from './src/asset.mjs';
export { Batch, TransformBuffer } from './src/batch.mjs';
export { LangevinRigidError, statusName } from './src/errors.mjs';
export { LR } from './src/generated/api.mjs';
export { World } from './src/world.mjs';

/** A loaded module, with its own memory. */
export class LangevinRigid {
  #host;

  /** @internal */
  constructor(host) {
    this.#host = host;
  }

  get version() {
    return this.#host.version;
  }

  /** The C functions, for calls without a wrapper. */
  get raw() {
    return this.#host.raw;
  }

  get memory() {
    return this.#host.raw.memory;
  }

  createWorld(desc = {}) {
    return World.create(this.#host, desc);
  }

  /** Loads the bytes of an .lrb file. */
  loadAsset(bytes) {
    return Asset.load(this.#host, bytes);
  }

  /** Loads an .lrb file from a URL, or in node from a file. */
  async fetchAsset(url) {
    return this.loadAsset(await readBytes(url, 'asset'));
  }

  /** All faults of an asset's bytes; empty if it is valid. */
  checkAsset(bytes) {
    return Asset.check(this.#host, bytes instanceof ArrayBuffer ? new Uint8Array(bytes) : bytes);
  }

  createEllipsoid(desc) {
    return Asset.ellipsoid(this.#host, desc);
  }

  createRigid(desc) {
    return Asset.rigid(this.#host, desc);
  }

  /** A struct with the library's defaults, by its name in C. */
  initial(struct) {
    return this.#host.scratch((scratch) => this.#host.heap.read(struct, scratch.struct(struct)));
  }

  simdTargets() {
    return this.#host.scratch((scratch) => {
      const capacity = 16;
      const targets = scratch.bytes(4 * capacity);
      const count = scratch.bytes(4);
      this.#host.call(() => '', 'lr_simd_targets', targets, capacity, count);
      return [...this.#host.heap.array(Int32Array, targets, this.#host.heap.view.getUint32(count, true))];
    });
  }

  simdTargetName(target) {
    return this.#host.heap.string(this.#host.invoke('lr_simd_target_name', target));
  }

  statusString(status) {
    return this.#host.heap.string(this.#host.invoke('lr_status_string', status));
  }
}

/**
 * Loads the module.
 * @param wasm its URL, its bytes, or a compiled WebAssembly.Module; by default langevin_rigid.wasm beside this file
 */
export async function load({ wasm = new URL('./langevin_rigid.wasm', import.meta.url) } = {}) {
  return new LangevinRigid(await Host.create(wasm));
}
