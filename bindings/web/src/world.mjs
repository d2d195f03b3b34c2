// SPDX-License-Identifier: MIT
// A world: fluid, colliders, and batches of bodies.
import { Batch } from './batch.mjs';
import { LR, structs } from './generated/api.mjs';
import { WorldPlain } from './generated/plain.mjs';
import { list, three, whole } from './heap.mjs';

const leaked = new FinalizationRegistry(end);

function end({ host, address, callbacks }) {
  host.release('lr_world_destroy', address);
  for (const id of callbacks) host.removeCallback(id);
}

/** Ids of bodies or colliders: one bigint, or several. */
export const idsOf = (ids) => (typeof ids === 'bigint' ? [ids] : ids);

export class World extends WorldPlain {
  #host;
  #address = 0;
  #said = '';
  #late = null; // what a callback threw in a call that created something
  #busy = false; // in a call, whose callbacks must not use the world: C++ code in the middle of a step would meet its changes
  #kept; // freed with the world: its address and the numbers of its callbacks
  #placed = { wind: 0, surface: 0, record: 0 }; // numbers of callbacks

  /** @internal The library's log of a refused call becomes part of the thrown message. */
  hear(message) {
    this.#said = message;
  }

  /** @internal */
  static create(host, { log = null, ...desc }) {
    const world = new World();
    world.#host = host;
    const id = host.addCallback(logTo(new WeakRef(world), log));
    try {
      host.scratch((scratch) => {
        const out = scratch.bytes(4);
        const at = scratch.struct('lr_world_desc', { ...desc, log: host.raw.lr_web_log(), logUser: id });
        world.#create('lr_world_create', at, out);
        world.#address = host.heap.view.getUint32(out, true);
      });
    } catch (error) {
      host.removeCallback(id);
      throw error;
    }
    world.#kept = { host, address: world.#address, callbacks: new Set([id]) };
    leaked.register(world, world.#kept, world);
    return world;
  }

  /** @internal */
  get host() {
    return this.#host;
  }

  /** @internal */
  get address() {
    if (this.#address === 0) throw new Error('this world has been disposed of');
    if (this.#busy) throw new Error('a call on this world is running: its own callbacks cannot use it');
    return this.#address;
  }

  #call(name, ...values) {
    this.#said = '';
    this.#busy = true;
    try {
      this.#host.call(() => this.#said, name, ...values);
    } finally {
      this.#busy = false;
    }
  }

  #create(name, ...values) {
    try {
      this.#call(name, ...values);
    } catch (error) {
      if (this.#host.result !== LR.OK) throw error;
      this.#late ??= { error };
    }
  }

  #throwLate() {
    const late = this.#late;
    this.#late = null;
    if (late) throw late.error;
  }

  /** @internal Calls a C function whose first argument is the world. */
  call(name, ...values) {
    this.#call(name, this.address, ...values);
    this.#throwLate();
  }

  /** @internal The same for one that creates something: an exception of a callback would lose the handle, so the next call() throws it. */
  create(name, ...values) {
    this.#create(name, this.address, ...values);
  }

  /** @internal Reads a struct that a C function fills. */
  get(struct, name, ...values) {
    return this.#host.scratch((scratch) => {
      const at = scratch.struct(struct);
      this.call(name, ...values, at);
      return this.#host.heap.read(struct, at);
    });
  }

  /** @internal Reads a number that a C function writes. */
  number(type, name, ...values) {
    return this.#host.scratch((scratch) => {
      const at = scratch.bytes(8);
      this.call(name, ...values, at);
      return this.#host.heap.number(type, at);
    });
  }

  /** @internal Reads an optional struct; null if there is none. */
  getIfPresent(struct, name, ...values) {
    return this.#host.scratch((scratch) => {
      const [at, present] = [scratch.struct(struct), scratch.bytes(4)];
      this.call(name, ...values, at, present);
      return this.#host.heap.view.getInt32(present, true) ? this.#host.heap.read(struct, at) : null;
    });
  }

  /** @internal Calls a C function whose last argument is a struct, or null. */
  set(struct, desc, name, ...values) {
    this.#host.scratch((scratch) => this.call(name, ...values, desc === null ? 0 : scratch.struct(struct, desc)));
  }

  dispose() {
    if (this.#address === 0) return;
    const kept = this.address && this.#kept;
    leaked.unregister(this);
    this.#address = 0; // first: a callback can throw
    end(kept);
    this.#throwLate();
  }

  [Symbol.dispose ?? Symbol.for('Symbol.dispose')]() {
    this.dispose();
  }

  // Information and time.

  step(dt, substeps = 2) {
    this.call('lr_world_step', dt, whole(substeps, 'substeps'));
  }

  setGravity(gravity) {
    this.#host.scratch((scratch) => this.call('lr_world_set_gravity', scratch.copy(Float32Array, three(gravity, 'gravity'))));
  }

  hash() {
    return this.number('big', 'lr_world_hash');
  }

  saveSnapshot() {
    const size = this.#host.invoke('lr_world_snapshot_size', this.address);
    return this.#host.scratch((scratch) => {
      const at = scratch.bytes(Number(size));
      this.call('lr_world_snapshot_save', at, size, 0);
      return this.#host.heap.array(Uint8Array, at, Number(size)).slice();
    });
  }

  restoreSnapshot(bytes) {
    if (bytes instanceof ArrayBuffer) bytes = new Uint8Array(bytes);
    this.#host.scratch((scratch) => this.call('lr_world_snapshot_restore', scratch.copy(Uint8Array, bytes), BigInt(bytes.length)));
  }

  startRecording(write, desc = {}) {
    this.#exchange('record', this.#host.addCallback(write), (id) =>
      this.#host.scratch((scratch) => this.call('lr_world_record_start',
        scratch.struct('lr_recording_desc', { ...desc, write: this.#host.raw.lr_web_record(), user: id }))));
  }

  stopRecording() {
    this.#exchange('record', 0, () => this.call('lr_world_record_stop'));
  }

  // The fluid.

  setUniformWind(velocity) {
    this.call('lr_world_set_uniform_wind', ...three(velocity, 'velocity'));
  }

  get uniformWind() {
    return this.#host.scratch((scratch) => {
      const out = scratch.bytes(12);
      this.call('lr_world_get_uniform_wind', out);
      return [...this.#host.heap.array(Float32Array, out, 3)];
    });
  }

  #windSource(scratch, kind, { samples = null, ...desc }) {
    if (kind !== 'wind_grid') return scratch.struct(`lr_${kind}_desc`, desc);
    const components = (desc.counts ?? [0, 0, 0]).reduce((product, n) => product * n, 3 * (desc.frames ?? 1));
    if (samples && samples.length !== components)
      throw new RangeError(`samples of ${desc.counts} in ${desc.frames ?? 1} frames need ${components} numbers, not ${samples.length}`);
    return scratch.struct('lr_wind_grid_desc', { ...desc, samples: scratch.copy(Float32Array, samples || null) });
  }

  #addSource(kind, desc) {
    return this.#host.scratch((scratch) => {
      const out = scratch.bytes(4);
      this.create(`lr_world_add_${kind}`, this.#windSource(scratch, kind, desc), out);
      return this.#host.heap.view.getUint32(out, true);
    });
  }

  #updateSource(kind, source, desc) {
    this.#host.scratch((scratch) => this.call(`lr_world_update_${kind}`, source, this.#windSource(scratch, kind, desc)));
  }

  // Defines addGusts(desc), updateGusts(source, desc), gusts(source), and the same for other kinds.
  static {
    for (const kind of ['gusts', 'vortex', 'blower', 'turbulence', 'wind_grid', 'ground_wind']) {
      const name = kind.replace(/_./g, (part) => part[1].toUpperCase());
      const method = name[0].toUpperCase() + name.slice(1);
      Object.assign(World.prototype, {
        [`add${method}`](desc = {}) { return this.#addSource(kind, desc); },
        [`update${method}`](source, desc) { this.#updateSource(kind, source, desc); },
        [name](source) { return this.get(`lr_${kind}_desc`, `lr_world_get_${kind}`, source); },
      });
    }
  }

  removeWind(source) {
    this.call('lr_world_remove_wind', source);
  }

  #isValid(name, handle) {
    return this.#host.invoke(name, this.address, handle) === 1;
  }

  windSourceIsValid(source) {
    return this.#isValid('lr_wind_source_is_valid', source);
  }

  /** Replaces the callback of a place, unless `install` is refused: also where a recording's callback throws in the call. */
  #exchange(place, id, install) {
    this.#host.result = null;
    try {
      install(id);
    } finally {
      const [gone, here] = this.#host.result === LR.OK ? [this.#placed[place], id] : [id, this.#placed[place]];
      this.#host.removeCallback(gone);
      this.#kept.callbacks.delete(gone);
      this.#kept.callbacks.add(here);
      this.#placed[place] = here;
    }
  }

  #setCallback(place, callback, name, pointer) {
    const id = callback === null ? 0 : this.#host.addCallback(callback);
    this.#exchange(place, id, () => this.call(name, callback === null ? 0 : this.#host.raw[pointer](), id));
  }

  setWindCallback(callback) {
    this.#setCallback('wind', callback, 'lr_world_set_wind_callback', 'lr_web_wind');
  }

  sampleWind(positions) {
    const count = positions.length / 3;
    if (!Number.isInteger(count)) throw new RangeError(`positions are x, y, z of each point: ${positions.length} is not a multiple of 3`);
    return this.#host.scratch((scratch) => {
      const at = scratch.copy(Float32Array, positions);
      this.call('lr_world_sample_wind', at, count, at);
      return this.#host.heap.array(Float32Array, at, 3 * count).slice();
    });
  }

  /** The water's settings; null without water. */
  get water() {
    return this.getIfPresent('lr_water_desc', 'lr_world_get_water');
  }

  setWaterCallback(callback) {
    this.#setCallback('surface', callback, 'lr_world_set_water_callback', 'lr_web_surface');
  }

  // Bodies of any batch.

  createBatch(desc) {
    return Batch.create(this, desc);
  }

  #withIds(ids, use) {
    const list = idsOf(ids);
    return this.#host.scratch((scratch) => use(scratch.copy(BigUint64Array, list), list.length, scratch));
  }

  destroyBodies(ids) {
    this.#withIds(ids, (at, count) => this.call('lr_body_destroy', at, count));
  }

  bodyIsValid(id) {
    return this.#isValid('lr_body_is_valid', id);
  }

  batchIsValid(batch) {
    return this.#isValid('lr_batch_is_valid', batch.handle);
  }

  /** Fields missing in `state` stay unchanged. */
  setBodyState(id, state) {
    this.#host.scratch((scratch) => {
      const at = scratch.struct('lr_body_state');
      this.call('lr_body_get_state', id, at);
      this.#host.heap.write('lr_body_state', at, state);
      this.call('lr_body_set_state', id, at);
    });
  }

  setSleep(ids, rest) {
    this.#withIds(ids, (at, count) => this.call('lr_body_set_sleep', at, count, rest ? LR.SLEEP_ASLEEP : LR.SLEEP_AWAKE));
  }

  wakeBox(low, high) {
    return this.#host.scratch((scratch) => {
      const woken = scratch.bytes(4);
      this.call('lr_world_wake_box', scratch.copy(Float32Array, three(low, 'low')), scratch.copy(Float32Array, three(high, 'high')), woken);
      return this.#host.heap.view.getUint32(woken, true);
    });
  }

  addForces(forces) {
    this.#host.scratch((scratch) => this.call('lr_body_add_force', scratch.structs('lr_body_force', list(forces, 'forces')), forces.length));
  }

  setBodyContact(a, b, enabled) {
    this.call('lr_batch_set_body_contact', this.#own(a), this.#own(b), enabled ? 1 : 0);
  }

  bodyContact(a, b) {
    return this.number('i32', 'lr_batch_get_body_contact', this.#own(a), this.#own(b)) !== 0;
  }

  // Another world's handle can be that of a batch here.
  #own(batch) {
    if (batch.world !== this) throw new TypeError('the batch is in another world');
    return batch.handle;
  }

  // Colliders.

  createColliders(descs) {
    return this.#host.scratch((scratch) => {
      const out = scratch.bytes(8 * list(descs, 'descs').length);
      const plain = descs.map(({ vertices = null, indices = null, heights = null, ...desc }) => ({
        ...desc,
        ...(vertices && { vertexCount: desc.vertexCount ?? vertices.length / 3, vertices: scratch.copy(Float32Array, vertices) }),
        ...(indices && { triangleCount: desc.triangleCount ?? indices.length / 3, indices: scratch.copy(Uint32Array, indices) }),
        ...(heights && { heights: scratch.copy(Float32Array, checkedHeights(heights, desc.counts)) }),
      }));
      this.create('lr_collider_create', scratch.structs('lr_collider_desc', plain), descs.length, out);
      return this.#host.heap.array(BigUint64Array, out, descs.length).slice();
    });
  }

  createCollider(desc = {}) {
    return this.createColliders([desc])[0];
  }

  destroyColliders(ids) {
    this.#withIds(ids, (at, count) => this.call('lr_collider_destroy', at, count));
  }

  moveColliders(motions) {
    this.#host.scratch((scratch) => this.call('lr_collider_move', scratch.structs('lr_collider_motion', list(motions, 'motions')), motions.length));
  }

  colliderIsValid(id) {
    return this.#isValid('lr_collider_is_valid', id);
  }

  setColliderMaterial(ids, surface) {
    this.#withIds(ids, (at, count, scratch) =>
      this.call('lr_collider_set_material', at, count, scratch.struct('lr_material', surface)));
  }

  // Events and queries.

  setEvents(capacity, kinds = LR.EVENTS_ALL) {
    this.call('lr_world_set_events', whole(capacity, 'capacity'), capacity === 0 ? 0 : whole(kinds, 'kinds'));
  }

  /** The events of the last step. */
  events() {
    const { count, events, ...numbers } = this.get('lr_event_list', 'lr_world_get_events');
    const { size } = structs.lr_event;
    return { events: Array.from({ length: count }, (_, i) => this.#host.heap.read('lr_event', events + size * i)), ...numbers };
  }

  /** The first hit of each ray, or null. */
  rayCast(rays) {
    const { size } = structs.lr_ray_hit;
    return this.#host.scratch((scratch) => {
      const hits = scratch.bytes(size * list(rays, 'rays').length);
      this.call('lr_world_ray_cast', scratch.structs('lr_ray', rays.map(withBatch)), rays.length, hits);
      return rays.map((_, i) => {
        const hit = this.#host.heap.read('lr_ray_hit', hits + size * i);
        return hit.body === 0n && hit.collider === 0n ? null : hit;
      });
    });
  }

  overlap(desc) {
    return this.#host.scratch((scratch) => {
      const at = scratch.struct('lr_overlap_desc', withBatch(desc));
      const out = scratch.bytes(4);
      let count = 64;
      for (;;) {
        const bodies = scratch.bytes(8 * count);
        const capacity = count;
        const status = this.#host.invoke('lr_world_overlap', this.address, at, bodies, capacity, out);
        count = this.#host.heap.view.getUint32(out, true);
        if (status === LR.OK) return this.#host.heap.array(BigUint64Array, bodies, count).slice();
        if (status !== LR.ERROR_BUFFER_TOO_SMALL) throw this.#host.error('lr_world_overlap', status, this.#host.lastError);
      }
    });
  }
}

// Defined outside the world's scope: the host's list of callbacks must not keep a world alive.
const logTo = (world, log) => (level, message) => {
  if (level === LR.LOG_ERROR) world.deref()?.hear(message);
  log?.(level, message);
};

const withBatch = ({ batch, ...desc }) => (batch ? { ...desc, batch: batch.handle ?? batch } : desc);

function checkedHeights(heights, counts) {
  if (counts && heights.length !== counts[0] * counts[1])
    throw new RangeError(`a heightfield of ${counts[0]} by ${counts[1]} samples needs ${counts[0] * counts[1]} heights, not ${heights.length}`);
  return heights;
}
