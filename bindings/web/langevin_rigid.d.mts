// SPDX-License-Identifier: MIT
// Langevin Rigid for the web and node. Units are SI; quaternions are x, y, z, w; ids of bodies and colliders are bigints.
import type * as api from './src/generated/api.mjs';

export * from './src/generated/api.mjs';

/** What functions take: any of the fields, arrays of any kind. Others have the library's initial values. */
export type Input<T> = {
  [K in keyof T]?: T[K] extends bigint ? bigint | number : T[K] extends number[] ? ArrayLike<number>
    : T[K] extends Float32Array | Uint32Array ? ArrayLike<number> | null
    : T[K] extends Float32Array[] ? (ArrayLike<number> | null)[]
    : T[K] extends (infer E)[] ? Input<E>[] : T[K] extends object ? Input<T[K]> | null : T[K];
};

/** A call that the library refused, and that changed nothing. The message says which, and why. */
export declare class LangevinRigidError extends Error {
  /** LR.ERROR_* */
  readonly status: number;
  /** as "LR_ERROR_STALE_BODY" */
  readonly statusName: string;
  /** the C function */
  readonly function: string;
}
export declare function statusName(status: number): string;

/** One numbered fault of an asset's bytes: docs/reference/asset_format.md. */
export interface Fault {
  number: number;
  where: string;
  what: string;
  remedy: string;
}

interface Disposable {
  /** Gives the memory back at once. Forgotten ones end when they are collected. */
  dispose(): void;
}

/** An immutable shape, for any number of worlds of its module. */
export declare class Asset implements Disposable {
  private constructor();
  readonly info: api.AssetInfo;
  readonly aerodynamics: api.Aerodynamics;
  /** Another object with a reference of its own. */
  clone(): Asset;
  dispose(): void;
}

/** What WorldDesc says, but for memory, threads and jobs, which are the module's own: workerCount must be 0. */
export type WorldInput = Omit<Input<api.WorldDesc>, 'allocator' | 'jobs' | 'log' | 'logUser'> & {
  /** LR.LOG_* and a message. Errors are thrown as well. */
  log?: ((level: number, message: string) => void) | null;
};
export type RayInput = Omit<Input<api.Ray>, 'batch'> & { batch?: Batch | number };
export type OverlapInput = Omit<Input<api.OverlapDesc>, 'batch'> & { batch?: Batch | number };
export type WindCallback = (query: api.WindQuery) => void;
export type SurfaceCallback = (query: Omit<api.SurfaceQuery, 'height'> & { height: Float32Array }) => void;

export declare class World implements Disposable {
  private constructor();
  readonly info: api.WorldInfo;
  readonly stepReport: api.StepReport;
  /** Advances all bodies by dt seconds in `substeps` (2) equal parts: at 60 Hz 2 suit leaves, 4 petals and confetti. */
  step(dt: number, substeps?: number): void;
  setGravity(gravity: ArrayLike<number>): void;
  setSimdTarget(target: number): void;
  setBudget(bodySubsteps: number): void;
  /** Equal hashes: equal motion from here on. The same on all machines, here and in native programs. */
  hash(): bigint;
  /** Bytes that native programs can restore, and the other way round. */
  saveSnapshot(): Uint8Array;
  restoreSnapshot(bytes: Uint8Array): void;
  /** `write` gets every call that can change the world, for lr_replay. What it throws ends the recording. */
  startRecording(write: (bytes: Uint8Array) => void, desc?: { flags?: number; hashInterval?: number }): void;
  stopRecording(): void;

  /** A velocity, or a desc; null: still. */
  setWind(desc: Input<api.WindDesc> | ArrayLike<number> | null): void;
  addWind(desc: Input<api.WindSourceDesc>): number;
  updateWind(source: number, desc: Input<api.WindSourceDesc>): void;
  removeWind(source: number): void;
  /** Its arrays are valid during the call. What it throws, step() throws when it has ended. */
  setWindCallback(callback: WindCallback | null): void;
  /** Velocities, x y z of each point. */
  sampleWind(positions: ArrayLike<number>): Float32Array;
  setSurface(desc: Input<api.SurfaceDesc> | null): void;
  setSurfaceCallback(callback: SurfaceCallback | null): void;

  createBatch(desc: Omit<Input<api.BatchDesc>, 'asset'> & { asset: Asset; capacity: number }): Batch;
  destroyBodies(ids: bigint | ArrayLike<bigint>): void;
  bodyState(id: bigint): api.BodyState;
  /** What `state` does not say stays as it is. */
  setBodyState(id: bigint, state: Input<api.BodyState>): void;
  setRest(ids: bigint | ArrayLike<bigint>, rest: boolean): void;
  /** How many it woke. */
  wakeBox(low: ArrayLike<number>, high: ArrayLike<number>): number;
  addForces(forces: Input<api.BodyForce>[]): void;
  setPairContact(a: Batch, b: Batch, enabled: boolean): void;
  pairContact(a: Batch, b: Batch): boolean;

  createCollider(desc: Input<api.ColliderDesc>): bigint;
  /** Numbers of vertices and triangles are those of the arrays. */
  createColliders(descs: Input<api.ColliderDesc>[]): BigUint64Array;
  destroyColliders(ids: bigint | ArrayLike<bigint>): void;
  moveColliders(motions: Input<api.ColliderMotion>[]): void;
  colliderState(id: bigint): api.ColliderState;
  setColliderSurface(ids: bigint | ArrayLike<bigint>, surface: Input<api.ColliderSurface>): void;

  setContactEvents(capacity: number, kinds?: number): void;
  /** Those of the last step. */
  contactEvents(): { events: api.ContactEvent[]; lost: number; totalLost: number };
  /** One a ray, null where nothing is hit. */
  rayCast(rays: RayInput[]): (api.RayHit | null)[];
  overlap(desc: OverlapInput): BigUint64Array;
  dispose(): void;
}

/** Many bodies: one array a field, with the values of one body after the other's. */
export interface ManyBodies {
  count: number;
  position?: ArrayLike<number>;
  orientation?: ArrayLike<number>;
  linearVelocity?: ArrayLike<number>;
  angularVelocity?: ArrayLike<number>;
  scale?: ArrayLike<number>;
  age?: ArrayLike<number>;
  key?: ArrayLike<number>;
}

/** All bodies of one asset in a world. */
export declare class Batch {
  private constructor();
  readonly world: World;
  readonly handle: number;
  destroy(): void;
  createBody(desc?: Input<api.BodyDesc>): bigint;
  createBodies(descs: Input<api.BodyDesc>[] | ManyBodies): BigUint64Array;
  /** Bears bodies where the emitter says. */
  emit(count: number): BigUint64Array;
  /** The bodies where they lie, without a copy. Valid until the world changes; empty after the memory has grown. Take it anew each frame. */
  view(): api.BatchView;
  /** format: LR.TRANSFORM_*, by default 4x4 column-major. capacity: by default the batch's. */
  createTransforms(format?: number, capacity?: number): TransformBuffer;
  setTurbulenceTable(table: Input<api.TurbulenceTable> | null): void;
  setAerodynamics(aerodynamics: Input<api.Aerodynamics> | null): void;
  readonly aerodynamics: api.Aerodynamics;
  setLoadGains(gains: Input<api.LoadGains> | null): void;
  setRate(divisor: number): void;
  readonly pace: api.BatchPace;
  setForce(force: Input<api.BatchForce> | null): void;
  addForces(arrays: Input<api.ForceArrays>): void;
  setContact(contact: Input<api.BatchContact> | null): void;
  readonly contact: api.BatchContact;
  setRules(rules: Input<api.BatchRules> | null): void;
  setEmitter(emitter: Input<api.EmitterDesc> | null): void;
  /** LR.FAULT_*: what becomes of bodies that have left physics. */
  faultPolicy: number;
  readonly events: api.BatchEvents;
}

/** Transforms of a batch in the module's memory. */
export declare class TransformBuffer implements Disposable {
  private constructor();
  readonly format: number;
  readonly floatsPerBody: number;
  readonly capacity: number;
  /** Bodies, when it was written last. */
  readonly count: number;
  /** The whole buffer; another array after the memory has grown. */
  readonly array: Float32Array;
  /** Writes all bodies, and gives that part of the buffer. */
  write(): Float32Array;
  /** Writes those that may have moved since the last time, and gives that part, which begins at the first body. */
  writeMoved(): Float32Array;
  dispose(): void;
}

/** A loaded module, with a memory of its own of up to 2 GiB. */
export declare class LangevinRigid {
  private constructor();
  readonly version: string;
  readonly memory: WebAssembly.Memory;
  readonly raw: api.RawFunctions & { malloc(bytes: number): number; free(address: number): void };
  createWorld(desc?: WorldInput): World;
  /** From the bytes of an .lrb file. Says what is wrong with them. */
  loadAsset(bytes: ArrayBuffer | ArrayBufferView): Asset;
  /** From an address on the web, or of a file in node. */
  fetchAsset(url: string | URL): Promise<Asset>;
  checkAsset(bytes: ArrayBuffer | Uint8Array): Fault[];
  createEllipsoid(desc: Input<api.EllipsoidDesc>): Asset;
  createRigid(desc: Input<api.RigidDesc>): Asset;
  /** A struct as the library fills it, by its C name. */
  initial(struct: string): Record<string, unknown>;
  simdTargets(): number[];
  simdTargetName(target: number): string;
  statusString(status: number): string;
}

/** wasm: address, bytes or compiled module; by default langevin_rigid.wasm beside langevin_rigid.mjs. */
export declare function load(options?: { wasm?: string | URL | ArrayBuffer | ArrayBufferView | WebAssembly.Module }): Promise<LangevinRigid>;
