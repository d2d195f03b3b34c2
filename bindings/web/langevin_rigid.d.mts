// SPDX-License-Identifier: MIT
// Langevin Rigid for the web and node. Units are SI; quaternions are x, y, z, w; ids of bodies and colliders are bigints.
import type * as api from './src/generated/api.mjs';
import { BatchPlain, WorldPlain } from './src/generated/plain.mjs';

export * from './src/generated/api.mjs';

/** Argument objects: any of the fields, arrays of any kind. Omitted fields have the library's defaults. */
export type Input<T> = {
  [K in keyof T]?: T[K] extends bigint ? bigint | number : T[K] extends number[] ? ArrayLike<number>
    : T[K] extends Float32Array | Uint32Array ? ArrayLike<number> | null
    : T[K] extends Float32Array[] ? (ArrayLike<number> | null)[]
    : T[K] extends (infer E)[] ? Input<E>[] : T[K] extends object ? Input<T[K]> | null : T[K];
};

/** A refused call. It changed nothing. The message gives its name and the reason. */
export declare class LangevinRigidError extends Error {
  /** LR.ERROR_* */
  readonly status: number;
  /** for example "LR_ERROR_STALE_BODY" */
  readonly statusName: string;
  /** the C function */
  readonly function: string;
}
export declare function statusName(status: number): string;

/** A numbered fault of an asset's bytes: docs/reference/asset_format.md. */
export interface Fault {
  number: number;
  where: string;
  what: string;
  remedy: string;
}

interface Disposable {
  /** Frees the memory at once. Otherwise the garbage collector frees it with the object. */
  dispose(): void;
}

/** An immutable shape, shared by any number of worlds of its module. */
export declare class Asset implements Disposable {
  private constructor();
  readonly info: api.AssetInfo;
  readonly aerodynamics: api.Aerodynamics;
  /** Another object with its own reference. */
  clone(): Asset;
  dispose(): void;
}

/** The fields of WorldDesc, except memory, threads and jobs, which belong to the module: workerCount must be 0. */
export type WorldInput = Omit<Input<api.WorldDesc>, 'allocator' | 'jobs' | 'log' | 'logUser'> & {
  /** LR.LOG_* and a message. Errors are thrown as well. */
  log?: ((level: number, message: string) => void) | null;
};
export type RayInput = Omit<Input<api.Ray>, 'batch'> & { batch?: Batch | number };
export type OverlapInput = Omit<Input<api.OverlapDesc>, 'batch'> & { batch?: Batch | number };
export type WindCallback = (query: api.WindQuery) => void;
export type WaterCallback = (query: Omit<api.WaterQuery, 'height'> & { height: Float32Array }) => void;

export declare class World extends WorldPlain implements Disposable {
  private constructor();
  /** Advances all bodies by dt seconds in `substeps` equal parts, by default 2. At 60 Hz: 2 for leaves, 4 for petals and confetti. */
  step(dt: number, substeps?: number): void;
  setGravity(gravity: ArrayLike<number>): void;
  /** Worlds with equal hashes move the same from here on, on all machines, here and in native programs. */
  hash(): bigint;
  /** A snapshot as bytes, which native programs can restore, and vice versa. */
  saveSnapshot(): Uint8Array;
  restoreSnapshot(bytes: Uint8Array | ArrayBuffer): void;
  /** `write` receives every call that can change the world, for lr_replay. An exception ends the recording. */
  startRecording(write: (bytes: Uint8Array) => void, desc?: { flags?: number; hashInterval?: number }): void;
  stopRecording(): void;

  setUniformWind(velocity: ArrayLike<number>): void;
  /** The uniform wind last set. */
  readonly uniformWind: number[];
  // Wind sources: add returns a handle, update replaces all values, and the kind's name reads the last values.
  addGusts(desc?: Input<api.GustsDesc>): number;
  updateGusts(source: number, desc: Input<api.GustsDesc>): void;
  gusts(source: number): api.GustsDesc;
  addVortex(desc?: Input<api.VortexDesc>): number;
  updateVortex(source: number, desc: Input<api.VortexDesc>): void;
  vortex(source: number): api.VortexDesc;
  addBlower(desc?: Input<api.BlowerDesc>): number;
  updateBlower(source: number, desc: Input<api.BlowerDesc>): void;
  blower(source: number): api.BlowerDesc;
  addTurbulence(desc?: Input<api.TurbulenceDesc>): number;
  updateTurbulence(source: number, desc: Input<api.TurbulenceDesc>): void;
  turbulence(source: number): api.TurbulenceDesc;
  addWindGrid(desc: Input<api.WindGridDesc>): number;
  updateWindGrid(source: number, desc: Input<api.WindGridDesc>): void;
  windGrid(source: number): api.WindGridDesc;
  addGroundWind(desc?: Input<api.GroundWindDesc>): number;
  updateGroundWind(source: number, desc: Input<api.GroundWindDesc>): void;
  groundWind(source: number): api.GroundWindDesc;
  removeWind(source: number): void;
  windSourceIsValid(source: number): boolean;
  /** The query's arrays are valid during the callback. step() is completed, then rethrows the callback's exception. */
  setWindCallback(callback: WindCallback | null): void;
  /** The velocities at points, as x y z of each point. */
  sampleWind(positions: ArrayLike<number>): Float32Array;
  /** The water's settings; null without water. */
  readonly water: api.WaterDesc | null;
  setWaterCallback(callback: WaterCallback | null): void;

  createBatch(desc: Omit<Input<api.BatchDesc>, 'asset'> & { asset: Asset; capacity: number }): Batch;
  destroyBodies(ids: bigint | ArrayLike<bigint>): void;
  /** Whether the body still exists. */
  bodyIsValid(id: bigint): boolean;
  batchIsValid(batch: Batch): boolean;
  /** Fields missing in `state` stay unchanged. */
  setBodyState(id: bigint, state: Input<api.BodyState>): void;
  setSleep(ids: bigint | ArrayLike<bigint>, rest: boolean): void;
  /** Returns the number of woken bodies. */
  wakeBox(low: ArrayLike<number>, high: ArrayLike<number>): number;
  addForces(forces: Input<api.BodyForce>[]): void;
  setBodyContact(a: Batch, b: Batch, enabled: boolean): void;
  bodyContact(a: Batch, b: Batch): boolean;

  createCollider(desc: Input<api.ColliderDesc>): bigint;
  /** Derives numbers of vertices and triangles from the arrays. */
  createColliders(descs: Input<api.ColliderDesc>[]): BigUint64Array;
  destroyColliders(ids: bigint | ArrayLike<bigint>): void;
  moveColliders(motions: Input<api.ColliderMotion>[]): void;
  colliderIsValid(id: bigint): boolean;
  setColliderMaterial(ids: bigint | ArrayLike<bigint>, surface: Input<api.Material>): void;

  setEvents(capacity: number, kinds?: number): void;
  /** The events of the last step. */
  events(): { events: api.Event[]; lost: number; totalLost: number; capacity: number; kinds: number };
  /** The first hit of each ray, or null. */
  rayCast(rays: RayInput[]): (api.RayHit | null)[];
  overlap(desc: OverlapInput): BigUint64Array;
  dispose(): void;
}

/** Values of many bodies: an array per field, with the bodies' values one after the other. */
export interface ManyBodies {
  count: number;
  position?: ArrayLike<number>;
  orientation?: ArrayLike<number>;
  linearVelocity?: ArrayLike<number>;
  angularVelocity?: ArrayLike<number>;
  scale?: ArrayLike<number>;
  age?: ArrayLike<number>;
  noiseSeed?: ArrayLike<number>;
  user?: ArrayLike<bigint>;
}

/** All bodies of one asset in a world. */
export declare class Batch extends BatchPlain {
  private constructor();
  readonly world: World;
  readonly handle: number;
  destroy(): void;
  createBody(desc?: Input<api.BodyDesc>): bigint;
  createBodies(descs: Input<api.BodyDesc>[] | ManyBodies): BigUint64Array;
  /** Spawns bodies from the emitter now. */
  emit(count: number): BigUint64Array;
  /** Spawns bodies at rest, evenly in a box and turned at random, without an emitter. */
  spawnBox(low: ArrayLike<number>, high: ArrayLike<number>, count: number): BigUint64Array;
  /** The bodies' arrays, without a copy. Valid until the world changes; empty after the memory grew. Call it again each frame. */
  view(): api.BatchView;
  /** A copy of all velocities, world frame, in the order of the view: for each body x, y, z of the linear one, m/s, and of the angular one, rad/s. */
  velocities(): Float32Array;
  /** A box around all bodies; null without bodies. */
  bounds(): { low: number[]; high: number[] } | null;
  /** format: LR.TRANSFORM_*, by default 4x4 column-major. capacity: by default the batch's. */
  createTransforms(format?: number, capacity?: number): TransformBuffer;
  setTurbulenceTable(table: Input<api.TurbulenceTable> | null): void;
  /** The k-epsilon samples in use, as setTurbulenceTable takes them. */
  readonly turbulenceTable: { chi: Float32Array; epsilon: Float32Array; dt: number; u0: number; l: number; c0: number; stationary: number };
  addForces(arrays: Input<api.ForceArrays>): void;
  /** The rules, or null. */
  readonly rules: api.BatchRules | null;
  /** The emitter, or null. */
  readonly emitter: api.EmitterDesc | null;
}

/** Transforms of a batch in the module's memory. */
export declare class TransformBuffer implements Disposable {
  private constructor();
  readonly format: number;
  readonly floatsPerBody: number;
  readonly capacity: number;
  /** Number of bodies at the last write. */
  readonly count: number;
  /** The whole buffer; a new array after the memory grew. */
  readonly array: Float32Array;
  /** Writes all bodies that fit, and returns this part of the buffer. */
  write(): Float32Array;
  /** Writes the bodies that can have moved since the last write, and returns this part, which begins at the first body. */
  writeMoved(): Float32Array;
  dispose(): void;
}

/** A loaded module, with its own memory of up to 2 GiB. */
export declare class LangevinRigid {
  private constructor();
  readonly version: string;
  readonly memory: WebAssembly.Memory;
  readonly raw: api.RawFunctions & { malloc(bytes: number): number; free(address: number): void };
  createWorld(desc?: WorldInput): World;
  /** Loads the bytes of an .lrb file. The error lists their faults. */
  loadAsset(bytes: ArrayBuffer | ArrayBufferView): Asset;
  /** Loads an .lrb file from a URL, or in node from a file. */
  fetchAsset(url: string | URL): Promise<Asset>;
  checkAsset(bytes: ArrayBuffer | Uint8Array): Fault[];
  createEllipsoid(desc: Input<api.EllipsoidDesc>): Asset;
  createRigid(desc: Input<api.RigidDesc>): Asset;
  /** A struct with the library's defaults, by its name in C. */
  initial(struct: string): Record<string, unknown>;
  simdTargets(): number[];
  simdTargetName(target: number): string;
  statusString(status: number): string;
}

/** wasm: URL, bytes or compiled module; by default langevin_rigid.wasm beside langevin_rigid.mjs. */
export declare function load(options?: { wasm?: string | URL | ArrayBuffer | ArrayBufferView | WebAssembly.Module }): Promise<LangevinRigid>;
