// SPDX-License-Identifier: MIT
// All bodies of one asset in a world.
import { LR, structs } from './generated/api.mjs';
import { BatchPlain } from './generated/plain.mjs';
import { Asset } from './asset.mjs';
import { three, whole } from './heap.mjs';

const arrayTypes = { f32: Float32Array, u32: Uint32Array, big: BigUint64Array };
const floats = [7, 8, 12, 12, 16, 16]; // per body, by LR.TRANSFORM_*
const bodyArrays = { position: 3, orientation: 4, linearVelocity: 3, angularVelocity: 3, scale: 1, age: 1, noiseSeed: 1, user: 1 };

export class Batch extends BatchPlain {
  #world;
  #host;

  /** @internal */
  static create(world, { asset, ...desc }) {
    if (!(asset instanceof Asset)) throw new TypeError('createBatch needs an asset from loadAsset, fetchAsset, createEllipsoid or createRigid');
    const batch = new Batch();
    batch.#world = world;
    batch.#host = world.host;
    batch.handle = world.host.scratch((scratch) => {
      const out = scratch.bytes(4);
      world.create('lr_batch_create', scratch.struct('lr_batch_desc', { ...desc, asset: asset.addressIn(world.host) }), out);
      return world.host.heap.view.getUint32(out, true);
    });
    return batch;
  }

  get world() {
    return this.#world;
  }

  #call(name, ...values) {
    this.#world.call(name, this.handle, ...values);
  }

  #get(struct, name) {
    return this.#world.get(struct, name, this.handle);
  }

  destroy() {
    this.#call('lr_batch_destroy');
  }

  // Bodies.

  /** Creates bodies and returns their ids. descs: an array of objects, or for many bodies an object of arrays with `count`. */
  createBodies(descs) {
    return this.#host.scratch((scratch) => {
      const count = Array.isArray(descs) ? descs.length : descs?.count;
      if (typeof descs !== 'object' || count === undefined) throw new TypeError('createBodies needs an array of objects, or an object of arrays with a count');
      const at = Array.isArray(descs) ? scratch.structs('lr_body_desc', descs) : this.#manyDescs(scratch, descs);
      const out = scratch.bytes(8 * count);
      this.#world.create('lr_body_create', this.handle, at, count, out);
      return this.#host.heap.array(BigUint64Array, out, count).slice();
    });
  }

  createBody(desc = {}) {
    return this.createBodies([desc])[0];
  }

  #manyDescs(scratch, { count, ...arrays }) {
    whole(count, 'count');
    const { size, fields } = structs.lr_body_desc;
    const first = scratch.struct('lr_body_desc');
    const at = scratch.bytes(size * count);
    const bytes = this.#host.heap.array(Uint8Array, at, size * count);
    if (count > 0) bytes.set(this.#host.heap.array(Uint8Array, first, size));
    for (let filled = size; filled < bytes.length; filled *= 2) bytes.copyWithin(filled, 0, Math.min(filled, bytes.length - filled));
    for (const [name, values] of Object.entries(arrays)) {
      const width = bodyArrays[name];
      if (!width) throw new TypeError(`bodies have no ${name}; they have ${Object.keys(bodyArrays).join(', ')}`);
      if (values.length !== width * count) throw new RangeError(`${name} of ${count} bodies has ${width * count} elements, not ${values.length}`);
      const [, offset, type] = fields.find(([field]) => field === name);
      const Type = arrayTypes[type], step = size / Type.BYTES_PER_ELEMENT;
      const to = this.#host.heap.array(Type, at, step * count);
      for (let i = 0, from = 0, place = offset / Type.BYTES_PER_ELEMENT; i < count; ++i, place += step)
        for (let k = 0; k < width; ++k) to[place + k] = values[from++];
    }
    return at;
  }

  /** Spawns bodies from the emitter now. */
  emit(count) {
    return this.#host.scratch((scratch) => {
      const out = scratch.bytes(8 * whole(count, 'count'));
      this.#world.create('lr_batch_spawn', this.handle, count, out);
      return this.#host.heap.array(BigUint64Array, out, count).slice();
    });
  }

  /** Spawns bodies at rest, evenly in a box and turned at random, without an emitter. */
  spawnBox(low, high, count) {
    return this.#host.scratch((scratch) => {
      const out = scratch.bytes(8 * whole(count, 'count'));
      const corners = [three(low, 'low'), three(high, 'high')].map((corner) => scratch.copy(Float32Array, corner));
      this.#world.create('lr_batch_spawn_box', this.handle, ...corners, count, out);
      return this.#host.heap.array(BigUint64Array, out, count).slice();
    });
  }

  /** The bodies' arrays without a copy, valid until the world changes. */
  view() {
    const { heap } = this.#host;
    const { position, orientation, scale, age, noiseSeed, ids, user, ...numbers } = this.#get('lr_batch_view', 'lr_batch_get_view');
    const { count } = numbers;
    const one = (Type, address) => heap.array(Type, address, count);
    const all = (addresses) => addresses.map((address) => one(Float32Array, address));
    return {
      ...numbers, position: all(position), orientation: all(orientation), scale: one(Float32Array, scale), age: one(Float32Array, age),
      noiseSeed: one(Uint32Array, noiseSeed), ids: one(BigUint64Array, ids),
      user: user ? one(BigUint64Array, user) : new BigUint64Array(count),
    };
  }

  /** A copy of all velocities, world frame, in the order of the view: for each body the linear one, m/s, and the angular one, rad/s. */
  velocities() {
    const { count } = this.#get('lr_batch_view', 'lr_batch_get_view');
    return this.#host.scratch((scratch) => {
      const at = scratch.bytes(24 * count);
      this.#call('lr_batch_write_velocities', at, 0n, count, 0);
      return this.#host.heap.array(Float32Array, at, 6 * count).slice();
    });
  }

  /** A box around all bodies; null without bodies. */
  bounds() {
    return this.#host.scratch((scratch) => {
      const at = scratch.bytes(24);
      this.#call('lr_batch_get_bounds', at, at + 12);
      const [low, high] = [at, at + 12].map((corner) => Array.from(this.#host.heap.array(Float32Array, corner, 3)));
      return low[0] <= high[0] ? { low, high } : null;
    });
  }

  /** A buffer of transforms in the module's memory, for a GPU's instance buffer. */
  createTransforms(format = LR.TRANSFORM_4X4_COLUMN_MAJOR, capacity = undefined) {
    return new TransformBuffer(this, format, capacity);
  }

  // Forces and loads.

  setTurbulenceTable(table) {
    if (table === null) return this.#call('lr_batch_set_turbulence_table', 0);
    const { chi, epsilon, ...rest } = table;
    if (chi.length !== epsilon.length) throw new RangeError(`chi has ${chi.length} samples, epsilon ${epsilon.length}`);
    this.#host.scratch((scratch) => this.#call('lr_batch_set_turbulence_table', scratch.struct('lr_turbulence_table', {
      count: chi.length, ...rest, chi: scratch.copy(Float32Array, chi), epsilon: scratch.copy(Float32Array, epsilon),
    })));
  }

  /** The k-epsilon samples in use, as setTurbulenceTable takes them. */
  get turbulenceTable() {
    return this.#host.scratch((scratch) => {
      const at = scratch.struct('lr_turbulence_table');
      const read = (...room) => this.#call('lr_batch_get_turbulence_table', at, ...room);
      read(0, 0, 0);
      const { count, dt, u0, l, c0, stationary } = this.#host.heap.read('lr_turbulence_table', at);
      const [chi, epsilon] = [scratch.bytes(4 * count), scratch.bytes(4 * count)];
      read(chi, epsilon, count);
      const copy = (from) => this.#host.heap.array(Float32Array, from, count).slice();
      return { chi: copy(chi), epsilon: copy(epsilon), dt, u0, l, c0, stationary };
    });
  }

  /** Adds forces to many bodies in the order of the view: x, y, z of each are arrays. */
  addForces({ force = null, torque = null, ...rest }) {
    const lengths = [...(force ?? []), ...(torque ?? [])].map((values) => values.length);
    const count = rest.count ?? lengths[0] ?? 0;
    if (lengths.some((length) => length !== count)) throw new RangeError(`arrays have different lengths: ${lengths.join(', ')}`);
    this.#host.scratch((scratch) => {
      const arrays = (three) => (three ?? [null, null, null]).map((values) => scratch.copy(Float32Array, values));
      this.#call('lr_batch_add_forces', scratch.struct('lr_force_arrays', { ...rest, count, force: arrays(force), torque: arrays(torque) }));
    });
  }

  // Emitter and rules.

  /** The rules, or null. */
  get rules() {
    return this.#world.getIfPresent('lr_batch_rules', 'lr_batch_get_rules', this.handle);
  }

  /** The emitter, or null. */
  get emitter() {
    return this.#world.getIfPresent('lr_emitter_desc', 'lr_batch_get_emitter', this.handle);
  }
}

const buffers = new FinalizationRegistry(({ host, address }) => host.release('free', address));

/** Transforms of a batch in the module's memory. */
export class TransformBuffer {
  #batch;
  #heap;
  #address;
  #array = new Float32Array(0);
  #last = { revision: -1, awakeCount: 0 };

  /** @internal */
  constructor(batch, format, capacity) {
    if (!floats[format]) throw new RangeError(`${format} is not an LR.TRANSFORM_*`);
    const { host } = batch.world;
    this.#batch = batch;
    this.#heap = host.heap;
    this.format = format;
    this.floatsPerBody = floats[format];
    this.capacity = whole(capacity ?? batch.view().capacity, 'capacity');
    this.count = 0;
    this.#address = this.#heap.allocate(4 * this.floatsPerBody * this.capacity);
    if (this.#address === 0) throw host.error('malloc', LR.ERROR_OUT_OF_MEMORY);
    buffers.register(this, { host, address: this.#address }, this);
  }

  get #live() {
    if (this.#address === 0) throw new Error('this buffer has been disposed of');
    return this.#address;
  }

  /** The whole buffer; a new array after the memory grew. */
  get array() {
    const address = this.#live;
    if (this.#array.buffer !== this.#heap.buffer)
      this.#array = this.#heap.array(Float32Array, address, this.floatsPerBody * this.capacity);
    return this.#array;
  }

  #write(number) {
    const { host } = this.#batch.world;
    return host.scratch((scratch) => {
      const written = scratch.bytes(4);
      this.#batch.world.call('lr_batch_write_transforms', this.#batch.handle, this.format, this.#live, 0n, number, written);
      return host.heap.view.getUint32(written, true);
    });
  }

  /** Writes all bodies that fit, and returns this part of the buffer. */
  write() {
    this.count = this.#write(this.capacity);
    return this.array.subarray(0, this.floatsPerBody * this.count);
  }

  /** Writes the bodies that can have moved since the last write, and returns this part, from the first body on. The others are unchanged. */
  writeMoved() {
    const view = this.#batch.view();
    if (view.count > this.capacity) throw this.#batch.world.host.error('lr_batch_write_transforms', LR.ERROR_BUFFER_TOO_SMALL);
    const moved = view.revision === this.#last.revision ? Math.max(view.awakeCount, this.#last.awakeCount) : view.count;
    const written = this.#write(moved);
    this.#last = { revision: view.revision, awakeCount: view.awakeCount };
    this.count = view.count;
    return this.array.subarray(0, this.floatsPerBody * written);
  }

  dispose() {
    if (this.#address === 0) return;
    buffers.unregister(this);
    this.#batch.world.host.release('free', this.#address);
    this.#address = 0;
    this.#array = new Float32Array(0);
  }

  [Symbol.dispose ?? Symbol.for('Symbol.dispose')]() {
    this.dispose();
  }
}
