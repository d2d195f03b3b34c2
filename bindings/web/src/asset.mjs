// SPDX-License-Identifier: MIT
// Assets: baked shapes, ellipsoids and rigid bodies with given coefficients.

const leaked = new FinalizationRegistry(({ host, address }) => host.release('lr_asset_release', address));
const silent = () => '';

/** An immutable shape for any number of worlds and batches, which keep their own references. */
export class Asset {
  #host;
  #address;

  /** @internal */
  constructor(host, address) {
    this.#host = host;
    this.#address = address;
    leaked.register(this, { host, address }, this);
  }

  /** @internal make(scratch, address of the result) calls a C function */
  static create(host, name, values) {
    return host.scratch((scratch) => {
      const out = scratch.bytes(4);
      host.call(silent, name, ...values(scratch), out);
      return new Asset(host, host.heap.view.getUint32(out, true));
    });
  }

  static load(host, bytes) {
    if (bytes instanceof ArrayBuffer) bytes = new Uint8Array(bytes);
    if (!ArrayBuffer.isView(bytes)) throw new TypeError('an asset is loaded from a Uint8Array or an ArrayBuffer');
    const whole = new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
    try {
      return Asset.create(host, 'lr_asset_load_memory', (scratch) => [scratch.copy(Uint8Array, whole), BigInt(whole.length)]);
    } catch (error) {
      const [fault] = error.status <= -12 && error.status >= -15 ? Asset.check(host, whole) : [];
      if (!fault) throw error;
      throw host.error('lr_asset_load_memory', error.status, `${fault.where}: ${fault.what} ${fault.remedy} (fault ${fault.number})`);
    }
  }

  static check(host, bytes) {
    const faults = [];
    const id = host.addCallback((fault) => faults.push(fault));
    try {
      host.scratch((scratch) => host.invoke('lr_asset_check_memory', scratch.copy(Uint8Array, bytes), BigInt(bytes.length),
        host.raw.lr_web_fault(), id));
    } finally {
      host.removeCallback(id);
    }
    return faults;
  }

  static ellipsoid(host, desc) {
    return Asset.create(host, 'lr_asset_create_ellipsoid', (scratch) => [scratch.struct('lr_ellipsoid_desc', desc)]);
  }

  static rigid(host, { aerodynamics = null, ...desc }) {
    return Asset.create(host, 'lr_asset_create_rigid', (scratch) => [scratch.struct('lr_rigid_desc', {
      ...desc, aerodynamics: aerodynamics ? scratch.struct('lr_aerodynamics', aerodynamics) : 0,
    })]);
  }

  /** @internal */
  addressIn(host) {
    if (host !== this.#host) throw new TypeError('the asset is of another load(): its memory is not that of this world');
    return this.address;
  }

  /** @internal */
  get address() {
    if (this.#address === 0) throw new Error('this asset has been disposed of');
    return this.#address;
  }

  #get(struct, name) {
    return this.#host.scratch((scratch) => {
      const at = scratch.struct(struct);
      this.#host.call(silent, name, this.address, at);
      return this.#host.heap.read(struct, at);
    });
  }

  get info() {
    return this.#get('lr_asset_info', 'lr_asset_get_info');
  }

  get aerodynamics() {
    return this.#get('lr_aerodynamics', 'lr_asset_get_aerodynamics');
  }

  /** Another object with its own reference. */
  clone() {
    this.#host.call(silent, 'lr_asset_retain', this.address);
    return new Asset(this.#host, this.#address);
  }

  dispose() {
    if (this.#address === 0) return;
    leaked.unregister(this);
    this.#host.release('lr_asset_release', this.#address);
    this.#address = 0;
  }

  [Symbol.dispose ?? Symbol.for('Symbol.dispose')]() {
    this.dispose();
  }
}
