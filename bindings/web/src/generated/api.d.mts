// Made by bindings/generator/javascript.py from include/langevin_rigid.h: changes here are lost.
// SPDX-License-Identifier: MIT

import type { Asset } from '../../langevin_rigid.mjs';

/** Constants of the C header, without LR_. */
export declare const LR: {
  /** success */
  readonly OK: 0;
  /** a required pointer is null */
  readonly ERROR_NULL_ARGUMENT: -1;
  /** struct_size is of no release, or an unknown tail is not 0: see LR_..._INIT */
  readonly ERROR_STRUCT_SIZE: -2;
  /** a value is out of range */
  readonly ERROR_INVALID_ARGUMENT: -3;
  /** a number is NaN or infinite */
  readonly ERROR_NOT_FINITE: -4;
  /** out of memory: the allocator returned null */
  readonly ERROR_OUT_OF_MEMORY: -5;
  /** the body was destroyed, or never existed */
  readonly ERROR_STALE_BODY: -6;
  /** the batch was destroyed, or never existed */
  readonly ERROR_STALE_BATCH: -7;
  /** the batch, or the world's table of batches, is full */
  readonly ERROR_CAPACITY: -8;
  /** the caller's buffer cannot hold the result */
  readonly ERROR_BUFFER_TOO_SMALL: -9;
  /** no file at that path */
  readonly ERROR_FILE_NOT_FOUND: -10;
  /** the file exists but cannot be read */
  readonly ERROR_FILE_READ: -11;
  /** not an asset file: too short, or another kind of file */
  readonly ERROR_ASSET_FORMAT: -12;
  /** made for a newer library */
  readonly ERROR_ASSET_VERSION: -13;
  /** an asset file, but damaged */
  readonly ERROR_ASSET_CORRUPT: -14;
  /** an undamaged asset file with numbers that no body can have */
  readonly ERROR_ASSET_INVALID: -15;
  /** not a snapshot, damaged, or of another version */
  readonly ERROR_SNAPSHOT_FORMAT: -16;
  /** the snapshot's world has other batches, capacities or assets */
  readonly ERROR_SNAPSHOT_MISMATCH: -17;
  /** not available on this processor or in this build */
  readonly ERROR_UNSUPPORTED: -18;
  /** the worker threads could not be started */
  readonly ERROR_THREADS: -19;
  /** dt is 0: while paused, do not step */
  readonly ERROR_TIMESTEP_ZERO: -20;
  /** dt is negative */
  readonly ERROR_TIMESTEP_NEGATIVE: -21;
  /** dt is NaN or infinite */
  readonly ERROR_TIMESTEP_NOT_FINITE: -22;
  /** dt / substeps exceeds LR_MAX_SUBSTEP */
  readonly ERROR_TIMESTEP_TOO_LARGE: -23;
  /** substeps is 0 or exceeds LR_MAX_SUBSTEPS */
  readonly ERROR_SUBSTEPS: -24;
  /** a bug in the library: please report it */
  readonly ERROR_INTERNAL: -25;
  /** the wind source was removed, or never existed */
  readonly ERROR_STALE_WIND_SOURCE: -26;
  /** the collider was destroyed, or never existed */
  readonly ERROR_STALE_COLLIDER: -27;
  /** another thread is inside a call on this world: see LR_CHECK_THREADS */
  readonly ERROR_CONCURRENT_USE: -28;
  /** called from one of this world's callbacks: see LR_CHECK_THREADS */
  readonly ERROR_REENTRANT: -29;
  /** s: the largest dt / substeps */
  readonly MAX_SUBSTEP: 1;
  /** the most substeps in one step */
  readonly MAX_SUBSTEPS: 65536;
  /** a call failed: the message names it and gives the reason */
  readonly LOG_ERROR: 1;
  /** a call succeeded, but probably does not do what was meant */
  readonly LOG_WARNING: 2;
  readonly LOG_INFO: 3;
  readonly SIMD_AUTO: 0;
  /** with SSE4.2, AES and PCLMUL: the minimum on x86-64 */
  readonly SIMD_SSE4: 1;
  readonly SIMD_AVX2: 2;
  readonly SIMD_AVX512: 3;
  readonly SIMD_NEON: 4;
  readonly SIMD_WASM: 5;
  /** plain C++, only in test builds */
  readonly SIMD_PLAIN: 6;
  /** diagonal in body axes, buoyancy at the centre of mass: the fastest path for all loads */
  readonly ASSET_DIAGONAL: 1;
  /** its own mirror image across its widest face: the fastest path for AERODYNAMIC loads */
  readonly ASSET_SYMMETRIC: 2;
  readonly CHECK_THREADS: 1;
  readonly MAX_WIND_SOURCES: 64;
  /** a smooth core, as viscosity spreads it */
  readonly VORTEX_LAMB_OSEEN: 0;
  /** a core that rotates as a solid */
  readonly VORTEX_RANKINE: 1;
  /** a grid adds nothing outside its samples */
  readonly WIND_OUTSIDE_ZERO: 0;
  /** the values at its border continue outside */
  readonly WIND_OUTSIDE_CLAMP: 1;
  /** the grid repeats: its first sample follows its last */
  readonly WIND_OUTSIDE_REPEAT: 2;
  /** of one grid, all frames together */
  readonly MAX_WIND_SAMPLES: 67108864;
  readonly MAX_WAVES: 8;
  readonly RECORD_CALLBACKS: 1;
  /** LR_LOADS_AERODYNAMIC in this version */
  readonly LOADS_DEFAULT: 0;
  /** gravity, buoyancy and added mass only: Kirchhoff's equations */
  readonly LOADS_NONE: 1;
  /** the paper's turbulent loads, dimensionally repaired; docs/maintainers/physics.md, 4 */
  readonly LOADS_LANGEVIN: 2;
  /** quasi-steady drag and lift in a turbulent fluid; docs/maintainers/physics.md, 5 */
  readonly LOADS_AERODYNAMIC: 3;
  /** turbulence scales with the body's current speed through the fluid */
  readonly CLOCK_SPEED: 0;
  /** the paper's: turbulence follows the table by the body's age */
  readonly CLOCK_AGE: 1;
  /** LR_CLOCK_AGE: hold the last sample after the end of the table */
  readonly TABLE_CLAMP: 0;
  /** LR_CLOCK_AGE: start over */
  readonly TABLE_LOOP: 1;
  /** LR_INTEGRATOR_SPLITTING in this version */
  readonly INTEGRATOR_DEFAULT: 0;
  /** the paper's: fourth order, slow, unstable at long steps. In water: splitting */
  readonly INTEGRATOR_RK4: 1;
  /** second order, stable at any step; docs/maintainers/numerics.md */
  readonly INTEGRATOR_SPLITTING: 2;
  /** 7 floats: position, quaternion x y z w */
  readonly TRANSFORM_POSITION_QUATERNION: 0;
  /** 8 floats: position, quaternion x y z w, scale */
  readonly TRANSFORM_POSITION_QUATERNION_SCALE: 1;
  /** 12 floats: three rows, rotation times scale and translation */
  readonly TRANSFORM_3X4_ROW_MAJOR: 2;
  /** 12 floats: four columns of three */
  readonly TRANSFORM_3X4_COLUMN_MAJOR: 3;
  /** 16 floats; column vectors, translation in elements 3, 7, 11 */
  readonly TRANSFORM_4X4_ROW_MAJOR: 4;
  /** 16 floats; column vectors, translation in elements 12, 13, 14 */
  readonly TRANSFORM_4X4_COLUMN_MAJOR: 5;
  readonly SLEEP_AWAKE: 0;
  readonly SLEEP_ASLEEP: 1;
  /** read only: diverged, and held where it was by lr_batch_set_divergence_policy */
  readonly SLEEP_HELD: 2;
  /** N, N m */
  readonly FORCE_MODE_FORCE: 0;
  /** m/s^2, rad/s^2 */
  readonly FORCE_MODE_ACCELERATION: 1;
  /** N s, N m s */
  readonly FORCE_MODE_IMPULSE: 2;
  /** m/s, rad/s: added to the body's */
  readonly FORCE_MODE_VELOCITY: 3;
  readonly FRAME_WORLD: 0;
  /** rotates with the body */
  readonly FRAME_BODY: 1;
  /** `force` acts at `point`, not at the centre of mass; forces and impulses only */
  readonly FORCE_AT_POINT: 1;
  readonly COLLIDER_PLANE: 1;
  readonly COLLIDER_SPHERE: 2;
  readonly COLLIDER_CAPSULE: 3;
  readonly COLLIDER_BOX: 4;
  readonly COLLIDER_HULL: 5;
  readonly COLLIDER_HEIGHTFIELD: 6;
  readonly COLLIDER_MESH: 7;
  /** in a world, at a time */
  readonly MAX_COLLIDERS: 67108864;
  /** of one hull */
  readonly MAX_HULL_VERTICES: 256;
  /** vertices or triangles of one mesh, or heights of one heightfield */
  readonly MAX_COLLIDER_VERTICES: 67108864;
  /** sweeps to this pose during the next step, then stands still */
  readonly MOVE_TO: 1;
  /** teleports to this pose, and moves with these velocities from now on */
  readonly MOVE_PLACE: 2;
  /** keeps its pose, and moves with these velocities from now on */
  readonly MOVE_VELOCITY: 3;
  /** bodies never fall asleep by themselves, only by lr_body_set_sleep */
  readonly CONTACT_NEVER_SLEEP: 1;
  /** an emitter, lr_batch_spawn or lr_batch_spawn_box added it since the previous step */
  readonly EVENT_SPAWNED: 1;
  /** the body touches a collider that it did not touch at the end of the step before */
  readonly EVENT_HIT: 2;
  /** it no longer touches the collider, or the collider was destroyed: its id is stale */
  readonly EVENT_LIFTED: 3;
  /** it fell asleep by itself */
  readonly EVENT_LANDED: 4;
  /** it woke since the previous step, for any reason */
  readonly EVENT_WOKE: 5;
  /** its batch's rules or its divergence destroyed it: its id is stale */
  readonly EVENT_KILLED: 6;
  /** its batch's rules or its divergence ended it, and it restarted with its id */
  readonly EVENT_RESPAWNED: 7;
  /** it diverged: lr_batch_set_divergence_policy */
  readonly EVENT_DIVERGED: 8;
  readonly EVENTS_SPAWNED: 1;
  readonly EVENTS_HIT: 2;
  readonly EVENTS_LIFTED: 4;
  readonly EVENTS_LANDED: 8;
  readonly EVENTS_WOKE: 16;
  readonly EVENTS_KILLED: 32;
  readonly EVENTS_RESPAWNED: 64;
  readonly EVENTS_DIVERGED: 128;
  readonly EVENTS_ALL: 255;
  readonly RAY_BODIES: 1;
  readonly RAY_COLLIDERS: 2;
  /** size[0]: radius */
  readonly OVERLAP_SPHERE: 1;
  /** size: half extents along its own axes */
  readonly OVERLAP_BOX: 2;
  /** the body is destroyed and its id becomes stale */
  readonly END_DESTROY: 0;
  /** the body restarts where the batch's emitter puts it, at age 0, with its id and noise seed */
  readonly END_RESPAWN: 1;
  /** `size` is its normal, `center` a point of it; inside: behind it, away from the normal */
  readonly VOLUME_PLANE: 0;
  /** axis-aligned; size: half extents */
  readonly VOLUME_BOX: 1;
  /** size[0]: radius */
  readonly VOLUME_SPHERE: 2;
  readonly KILL_INSIDE: 0;
  readonly KILL_OUTSIDE: 1;
  readonly MAX_KILL_VOLUMES: 8;
  /** LR_DIVERGENCE_REMOVE in a batch with rules, else LR_DIVERGENCE_FREEZE */
  readonly DIVERGENCE_AUTO: 0;
  /** the body is held where it was last valid */
  readonly DIVERGENCE_FREEZE: 1;
  /** the body respawns if the batch's rules respawn, else it is destroyed */
  readonly DIVERGENCE_REMOVE: 2;
  readonly EMIT_POINT: 0;
  /** filled evenly */
  readonly EMIT_BOX: 1;
  /** filled evenly */
  readonly EMIT_SPHERE: 2;
  /** filled evenly, in the plane of the shape's x and y axes */
  readonly EMIT_DISC: 3;
  /** covered evenly */
  readonly EMIT_BOX_SURFACE: 4;
  /** covered evenly if its three sizes are equal */
  readonly EMIT_SPHERE_SURFACE: 5;
  /** every orientation is equally likely */
  readonly POSE_RANDOM: 0;
  /** body_orientation */
  readonly POSE_FIXED: 1;
};

/**
 * The allocator of a world. Set both functions, or neither to use the C library's.
 * `allocate` returns `size` bytes aligned to `alignment` (a power of two, at most 128), or null.
 * `release` receives the same size and alignment as the matching `allocate`. Both are called only on the thread that
 * calls the library. lr_world_step calls them only when more bodies touch each other than ever before
 * (lr_batch_set_body_contact). Neither may call the library on the same world.
 */
export interface Allocator {
  user: number;
  allocate: number;
  release: number;
}

export interface JobSystem {
  user: number;
  enqueue: number;
  finish: number;
}

/**
 * A solid ellipsoid: the quickest way to a first falling body. Mass, added mass (Lamb) and the decay of k and epsilon
 * in a uniform stream come from closed forms.
 */
export interface EllipsoidDesc {
  /** 3 elements. m, each 1e-6 to 1e3, along body x, y, z */
  semiAxes: number[];
  /** kg/m^3 of the body, > 0 */
  density: number;
  /** kg/m^3, > 0; default 1.2, air */
  fluidDensity: number;
  /** m^2/s, kinematic, > 0; default 1.5e-5, air */
  fluidViscosity: number;
  /** turbulence intensity I of k0 = 3/2 (I U0)^2, 0 to 10; default 1, as in the paper */
  intensity: number;
  /** 3 elements. m, from the ellipsoid's centre, inside it; default 0. For ballast: the centre of buoyancy and the moments of inertia stay those of the uniform solid */
  centerOfMass: number[];
}

/** Properties of an asset. Matrices are row-major and symmetric. */
export interface AssetInfo {
  /** LR_ASSET_* */
  flags: number;
  /** UTF-8, ends with 0 */
  name: string;
  /** kg */
  mass: number;
  /** m^3 */
  volume: number;
  /** kg/m^3 */
  density: number;
  /** 3 elements. m, in the frame of the mesh: the position of the body's origin in it */
  centerOfMass: number[];
  /** 3 elements. m, from the centre of mass, body axes */
  centerOfBuoyancy: number[];
  /** 9 elements. kg m^2, about the centre of mass, body axes */
  inertia: number[];
  /** 36 elements. about the centre of mass, order vx vy vz wx wy wz, fluid density included: kg for the 3x3 block of v, kg m for the coupling, kg m^2 for the block of w */
  addedMass: number[];
  /** kg/m^3, of the fluid that the asset was baked in */
  fluidDensity: number;
  /** m^2/s, kinematic */
  fluidViscosity: number;
  /** m, characteristic length: the largest extent */
  lengthD: number;
  /** m, thickness */
  lengthB: number;
  /** m, turbulence length; see docs/maintainers/physics.md */
  lengthL: number;
  /** m/s, fall velocity scale sqrt(|density ratio - 1| g b), paper Eq. 1 */
  u0: number;
  /** u0 d / viscosity */
  reynolds: number;
  /** Kolmogorov constant of the Langevin model, paper Eq. 10 */
  c0: number;
  /** s between table samples */
  turbulenceDt: number;
  /** number of table samples */
  turbulenceCount: number;
  /** 0: no hull */
  hullVertexCount: number;
  hullTriangleCount: number;
  /** of the file; 0: created without a file */
  formatVersion: number;
  /** of everything that affects motion; equal for equal assets */
  contentHash: bigint;
}

export interface WorldDesc {
  /** threads besides the caller's, 0 to 64; default 0: everything runs on the caller's thread. With `jobs`: threads of the job system besides the caller's, and the most indices in one enqueue; 0 guesses the machine's threads less one, from 1 to 64, and logs a warning */
  workerCount: number;
  /** of all noise; default 0 */
  seed: bigint;
  /** 3 elements. m/s^2; default 0, -9.81, 0 */
  gravity: number[];
  /** kg/m^3, >= 0; default 0: each batch uses the fluid that its asset was baked in. For a vacuum set 1e-6 */
  fluidDensity: number;
  /** LR_SIMD_*; default LR_SIMD_AUTO */
  simdTarget: number;
  /** m^2/s, kinematic, >= 0; default 0: each batch uses the value its asset was baked with */
  fluidViscosity: number;
  /** copied; default null functions: the C library's */
  allocator: Allocator;
  /** default null: no messages */
  log: number;
  logUser: number;
  /** copied; default null functions: the world starts worker_count threads of its own */
  jobs: JobSystem;
  /** bits LR_CHECK_*: misuse to detect, for development; default 0 */
  checks: number;
}

export interface WorldInfo {
  /** LR_SIMD_*: in use, never LR_SIMD_AUTO */
  simdTarget: number;
  /** as in the desc; with `jobs` and 0: the guess */
  workerCount: number;
  batchCount: number;
  bodyCount: number;
  /** substeps since creation; the time index of the noise */
  substepCount: number;
  /** s since creation: the sum of all dt, in double */
  time: number;
  /** currently allocated */
  memoryBytes: number;
  colliderCount: number;
  /** bodies that are not asleep: lr_body_set_sleep */
  awakeCount: number;
  /** as set by lr_world_set_budget */
  budget: number;
  /** 3 elements. m/s^2, as set by lr_world_set_gravity */
  gravity: number[];
}

/**
 * Gusts: fluctuations of the uniform wind in time, with mean 0. They start from 0 when added, the fast ones first, and
 * reach full strength after 4 integral times; an update continues them.
 */
export interface GustsDesc {
  /** combined with the world's; default 0 */
  seed: number;
  /** 3 elements. mean direction, any length but 0; default 1, 0, 0 */
  direction: number[];
  /** m/s, root mean square speed, 0 to 1000; default 1 */
  rms: number;
  /** rad, root mean square angle from `direction`, 0 to 1; default 0.1 */
  angleRms: number;
  /** s, up to 1e6; default 0: 4 s. IEC 61400-1: 5.67 times height over wind speed */
  integralTime: number;
}

/** A straight vortex. */
export interface VortexDesc {
  /** LR_VORTEX_*; default LR_VORTEX_LAMB_OSEEN */
  core: number;
  /** 3 elements. m, a point on the axis, its middle if half_length > 0; default 0 */
  position: number[];
  /** 3 elements. right-hand rule, any length but 0; default 0, 1, 0 */
  axis: number[];
  /** 3 elements. m/s, of the vortex itself; default 0 */
  velocity: number[];
  /** m^2/s, up to 1e6 and up to 6000 * core_radius in magnitude; default 1 */
  circulation: number;
  /** m, >= 1e-4; default 1 */
  coreRadius: number;
  /** m: fades from half this distance to nothing at it; default 0: no limit */
  outerRadius: number;
  /** m: likewise along the axis; default 0: no limit */
  halfLength: number;
}

/** A blower: a turbulent jet, round or from a slot. */
export interface BlowerDesc {
  /** 3 elements. m, the middle of the nozzle; default 0 */
  position: number[];
  /** 3 elements. of the jet, any length but 0; default 1, 0, 0 */
  direction: number[];
  /** 3 elements. along the slot; not parallel to `direction`; default 0, 0, 1. Unused by a round jet */
  side: number[];
  /** 3 elements. m/s, of the blower itself; default 0 */
  velocity: number[];
  /** m/s at the nozzle, 0 to 1000; default 1 */
  speed: number;
  /** m, >= 1e-4: of a round nozzle, half the width of a slot; default 1 */
  nozzleRadius: number;
  /** m: half the length of the slot; default 0: a round jet */
  halfLength: number;
  /** m, >= nozzle_radius: fades from half this distance to nothing at it; default 10 */
  range: number;
  /** widening of the jet per length, 0 to 1; default 0.1, measured as 0.11 */
  spread: number;
}

/**
 * Turbulence: random eddies everywhere, divergence-free, carried along by the uniform wind. An update continues them,
 * also with another velocity; only another size moves them.
 */
export interface TurbulenceDesc {
  /** combined with the world's; default 0 */
  seed: number;
  /** each half the size of the one before, 1 to 4; default 2 */
  octaves: number;
  /** 3 elements. m/s, of the pattern, besides the uniform wind; default 0 */
  velocity: number[];
  /** m/s, root mean square of each component, 0 to 1000; default 1 */
  rms: number;
  /** m, >= 1e-4; default 1 */
  integralLength: number;
  /** s, of the largest eddies, up to 1e6; default 0: integral_length/rms */
  eddyLife: number;
}

/**
 * Samples of wind on a lattice, in one or more frames that are played in a loop, from the first at world time 0. An
 * update with another frame_time, but as many frames, goes on from the present one.
 */
export interface WindGridDesc {
  /** LR_WIND_OUTSIDE_*; default LR_WIND_OUTSIDE_ZERO */
  outside: number;
  /** 3 elements. m, of the first sample; default 0 */
  position: number[];
  /** 3 elements. m/s, of the grid itself; default 0 */
  velocity: number[];
  /** 3 elements. m between samples, >= 1e-4; default 1 */
  spacing: number[];
  /** 3 elements. samples along x, y, z, each >= 1 */
  counts: number[];
  /** >= 1; default 1 */
  frames: number;
  /** s between frames, up to 1e6; default 0: 1 s */
  frameTime: number;
  /** m/s, each up to 1000 in magnitude: x y z of each sample; x varies fastest, then y, z, frame; copied. Null in an update: keeps the samples, if counts and frames are unchanged. lr_world_get_wind_grid gives null */
  samples: Float32Array;
}

/** A logarithmic profile over the ground, a plane: scales the uniform wind and the gusts. */
export interface GroundWindDesc {
  /** 3 elements. m, a point on the ground; default 0 */
  position: number[];
  /** 3 elements. upward, any length but 0; default 0, 1, 0 */
  normal: number[];
  /** 3 elements. m/s, of the plane itself; default 0 */
  velocity: number[];
  /** m, >= 1e-4; default 0.03, grass (0.0001 water, 1 town) */
  roughnessLength: number;
  /** m, >= roughness_length: the height at which the factor is 1; default 10 */
  referenceHeight: number;
}

/** Input and output of a wind callback. Arrays hold one value per body. */
export interface WindQuery {
  /** bodies, 1 to 256 */
  count: number;
  /** of these bodies; id 0 in lr_world_sample_wind */
  batch: number;
  /** s, of the middle of the substep */
  time: number;
  /** 3 elements. m: expected positions of the bodies at that time; finite */
  position: Float32Array[];
  /** 3 elements. m/s, preset to 0: write the velocity to add to the other sources' */
  velocity: Float32Array[];
  /** 3 elements. m/s^2, preset to 0: write its partial derivative in time, if known */
  rate: Float32Array[];
  /** 9 elements. 1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without rate and gradient the callback's wind causes drag, but neither shear nor the force of accelerating fluid */
  gradient: Float32Array[];
}

/**
 * A long-crested deep-water wave. Heights of waves add up. The frequency in the water, sqrt(2 pi g/length), uses the
 * world's gravity at the time of lr_world_set_water. The current carries the waves along; a change of it leaves them
 * where they are.
 */
export interface Wave {
  /** 3 elements. of travel: any vector not along the normal; only its part in the plane counts */
  direction: number[];
  /** m, crest to crest, 1e-3 to 1e6 */
  length: number;
  /** m, half of crest to trough, 0 to length/7: steeper waves break */
  amplitude: number;
  /** rad, up to 1e6 in magnitude; 0 puts a crest at `position` at world time 0 */
  phase: number;
}

/** The water surface. Water fills everything below it; above it is the fluid of the world or of each batch's asset. */
export interface WaterDesc {
  /** elements of `waves` in use; the others are not kept; default 0 */
  waveCount: number;
  /** 3 elements. m, a point of the plane, each up to 1e9 in magnitude; default 0 */
  position: number[];
  /** 3 elements. upward, any length but 0; default 0, 1, 0 */
  normal: number[];
  /** kg/m^3, 1e-3 to 1e6; default 998. A batch whose own fluid is denser keeps its own density */
  density: number;
  /** m^2/s, kinematic, 1e-12 to 1e3; default 1e-6 */
  viscosity: number;
  /** 3 elements. m/s, of the water, and of a plane that you move; each up to 1000 in magnitude; default 0 */
  current: number[];
  /** m, 0 to 1e6: the farthest that a callback's surface lies from the plane; default 0 */
  reach: number;
  /** 8 elements. */
  waves: Wave[];
}

/**
 * Input and output of a water surface callback. Arrays hold one value per body; outputs are preset to the values of the
 * plane and its waves, each wave as its mean over the body.
 */
export interface WaterQuery {
  /** bodies, 1 to 256 */
  count: number;
  /** of these bodies */
  batch: number;
  /** s */
  time: number;
  /** 3 elements. m; finite */
  position: Float32Array[];
  /** m, of the surface above the plane, along the plane's normal */
  height: Float32Array;
  /** 3 elements. unit, of the surface, less than 80 degrees from the plane's */
  normal: Float32Array[];
  /** 3 elements. m/s, of the water at the position */
  velocity: Float32Array[];
  /** 3 elements. m/s^2, du/dt + u . grad u of the water: lets bodies slide down slopes, follow eddies */
  rate: Float32Array[];
}

/** Work done and postponed by the last step. Batches without bodies are not counted. */
export interface StepReport {
  batchesStepped: number;
  /** not due, because of their divisors */
  batchesWaiting: number;
  /** due, but out of budget */
  batchesPassedOver: number;
  /** done in this step */
  bodySubsteps: number;
  /** that the batches which were due would need without a budget */
  bodySubstepsWanted: number;
  /** s: the longest time by which a batch is behind the world */
  behind: number;
  /** s: the most simulated time that a batch lost in this step: rather than take substeps that are too long, bodies move in slow motion */
  lost: number;
}

/**
 * Seconds that the phases of the last step took on the stepping thread, by a monotonic clock. `total` also includes
 * the work between phases. Phases that did not occur are 0. Neither part of snapshots nor of the world's hash.
 */
export interface Timings {
  total: number;
  /** waking bodies about to be hit, moving colliders, sorting them for the search */
  colliders: number;
  /** preparing the wind's fields; bodies evaluate them as part of their motion */
  wind: number;
  /** of batches without body contact: loads, wind, water, contact with colliders */
  motion: number;
  /** of batches with body contact: their motion, and the contact between their bodies */
  bodyContact: number;
  /** finding sleeping bodies that wind or water moves */
  wake: number;
  /** ends, spawns, divergence, and falling asleep */
  emitAndRules: number;
  /** listing and sorting them */
  events: number;
}

export interface RecordingDesc {
  /** bits LR_RECORD_*; default LR_RECORD_CALLBACKS */
  flags: number;
  /** steps between recorded hashes of the world; 0: none; default 1 */
  hashInterval: number;
  /** required */
  write: number;
  user: number;
}

export interface BatchDesc {
  /** the most bodies at a time, 1 to 2^26; memory for all is allocated at creation */
  capacity: number;
  /** required; the batch keeps a reference until it is destroyed */
  asset: Asset;
  /** LR_LOADS_*; default LR_LOADS_DEFAULT */
  loadModel: number;
  /** LR_CLOCK_*; default LR_CLOCK_SPEED */
  clock: number;
  /** LR_TABLE_*; default LR_TABLE_CLAMP */
  tableEnd: number;
  /** LR_INTEGRATOR_*; default LR_INTEGRATOR_DEFAULT */
  integrator: number;
  /** multiplies the turbulent damping, 0 to 100; default 1 */
  dampingGain: number;
  /** multiplies the turbulent noise, 0 to 100; default 1; 0 makes single falls repeatable */
  noiseGain: number;
  /** natural spread of AERODYNAMIC loads from body to body, as by thickness and curl: relative standard deviation, 0 to 0.5; default 0.15; 0: all bodies are alike. A body's loads follow from its noise seed and the world's seed, and never change */
  variation: number;
}

/** Artistic control of AERODYNAMIC loads. The factors multiply the coefficients, so bodies still move physically. */
export interface LoadGains {
  /** on translation, 0 to 100; default 1 */
  drag: number;
  /** and its moment, 0 to 100; default 1 */
  lift: number;
  /** 0 to 100; default 1 */
  spinDrag: number;
  /** intensity of the body's own wake, 0 to 100; default 1 */
  turbulence: number;
}

/** How a batch keeps pace with its world. */
export interface BatchPace {
  /** as set */
  divisor: number;
  /** in the world's last step; 0: it waited */
  substeps: number;
  /** steps since it was last stepped */
  waited: number;
  /** s since it was last stepped */
  behind: number;
  /** s, simulated time lost in total */
  lost: number;
  /** in total */
  bodySubsteps: number;
}

/**
 * Read access to a batch's state without a copy: arrays of `count` values, one per body, 64-byte aligned. Awake bodies
 * come first, then sleeping ones, without gaps. A body that leaves either part is replaced by the last one of that
 * part. Pointers are valid until the next call that is not a query. Velocities: lr_batch_write_velocities.
 */
export interface BatchView {
  /** bodies */
  count: number;
  /** 3 elements. m, world frame: x, y, z */
  position: Float32Array[];
  /** 4 elements. unit quaternion x, y, z, w, body to world */
  orientation: Float32Array[];
  /** uniform scale */
  scale: Float32Array;
  /** s; outdated for sleeping bodies: lr_body_get_state gives their exact age */
  age: Float32Array;
  /** bodies with different seeds have independent noise */
  noiseSeed: Uint32Array;
  ids: BigUint64Array;
  /** lr_body_desc.user; null until a body of the batch is given one */
  user: BigUint64Array;
  capacity: number;
  /** changes whenever sleeping bodies wake, end or change places */
  revision: number;
  /** bodies [0, awake_count) are awake, [awake_count, count) asleep: lr_body_set_sleep */
  awakeCount: number;
}

export interface BodyDesc {
  /** default 0: the world assigns each body the next one */
  noiseSeed: number;
  /** 3 elements. m, of the centre of mass; default 0 */
  position: number[];
  /** 4 elements. quaternion x y z w, normalised by the call; default 0 0 0 1 */
  orientation: number[];
  /** 3 elements. m/s, of the centre of mass; default 0 */
  linearVelocity: number[];
  /** 3 elements. rad/s, world frame; default 0 */
  angularVelocity: number[];
  /** uniform, 0.001 to 1000; mass scales with its cube; default 1 */
  scale: number;
  /** s, 0 to 1e9, where it stops growing; default 0 */
  age: number;
  /** the caller's own number, also in views, events and ray hits; default 0. A respawn keeps it. It does not affect motion: part of snapshots, not of the world's hash */
  user: bigint;
}

export interface BodyState {
  /** read only: ignored by lr_body_set_state */
  noiseSeed: number;
  /** 3 elements. m, of the centre of mass, world frame */
  position: number[];
  /** 4 elements. unit quaternion x y z w, body to world */
  orientation: number[];
  /** 3 elements. m/s, of the centre of mass, world frame */
  linearVelocity: number[];
  /** 3 elements. rad/s, world frame */
  angularVelocity: number[];
  /** 0.001 to 1000 */
  scale: number;
  /** s, 0 to 1e9 */
  age: number;
  /** LR_SLEEP_*; read only */
  sleepState: number;
  /** as in lr_body_desc */
  user: bigint;
}

/** A force and a torque on one body. Scale matters: a body of scale 2 has eight times the mass. */
export interface BodyForce {
  /** LR_FORCE_MODE_*; default LR_FORCE_MODE_FORCE */
  mode: number;
  body: bigint;
  /** LR_FRAME_*, of force, torque and point; default LR_FRAME_WORLD */
  frame: number;
  /** LR_FORCE_*; default 0 */
  flags: number;
  /** 3 elements. default 0 */
  force: number[];
  /** 3 elements. about the centre of mass; default 0 */
  torque: number[];
  /** 3 elements. m; world frame: a position, body frame: from the centre of mass. The lever arm is fixed by the call */
  point: number[];
}

/** Forces on consecutive bodies of one batch, in the order of its view. */
export interface ForceArrays {
  /** LR_FORCE_MODE_*; default LR_FORCE_MODE_FORCE */
  mode: number;
  /** LR_FRAME_*; default LR_FRAME_WORLD */
  frame: number;
  /** index in the view of the first body; default 0 */
  first: number;
  /** bodies */
  count: number;
  /** bytes from one body's value to the next, a multiple of 4; default 0: 4, no gaps */
  stride: number;
  /** 3 elements. x, y, z: `count` values each, not kept; all three or none */
  force: Float32Array[];
  /** 3 elements. x, y, z: `count` values each, not kept; all three or none */
  torque: Float32Array[];
}

/** Forces on every body of a batch, until changed. All default to 0; each component up to 1e9 in magnitude. */
export interface BatchForce {
  /** 3 elements. N, world frame */
  force: number[];
  /** 3 elements. N m, world frame */
  torque: number[];
  /** 3 elements. m/s^2, world frame; of the body, whatever its mass */
  acceleration: number[];
  /** 3 elements. rad/s^2, world frame */
  angularAcceleration: number[];
  /** 3 elements. N, body frame */
  bodyForce: number[];
  /** 3 elements. N m, body frame */
  bodyTorque: number[];
  /** 3 elements. m/s^2, body frame */
  bodyAcceleration: number[];
  /** 3 elements. rad/s^2, body frame */
  bodyAngularAcceleration: number[];
}

/** A collider. Fields that its kind does not use are ignored. Arrays are copied. */
export interface ColliderDesc {
  /** LR_COLLIDER_*; must be set: the default 0 is no kind */
  kind: number;
  /** 3 elements. m, up to 1e9 in magnitude; default 0 */
  position: number[];
  /** 4 elements. quaternion x y z w, normalised by the call; default 0 0 0 1 */
  orientation: number[];
  /** 3 elements. m/s, of the frame's origin, up to 1e6; default 0. Lasts until changed */
  linearVelocity: number[];
  /** 3 elements. rad/s, world frame, up to 1e6; default 0. Lasts until changed */
  angularVelocity: number[];
  /** 3 elements. m, > 0, up to 1e6; default 0 */
  size: number[];
  /** 0 to 10; default 0.5 */
  friction: number;
  /** 0 to 1; default 0.2 */
  restitution: number;
  /** bits: collides with bodies that share at least one; default 1 */
  layers: number;
  /** 0 */
  flags: number;
  /** hull: 4 to LR_MAX_HULL_VERTICES; mesh: 3 to LR_MAX_COLLIDER_VERTICES */
  vertexCount: number;
  /** mesh: 1 to LR_MAX_COLLIDER_VERTICES */
  triangleCount: number;
  /** 2 elements. heightfield: samples along x and z, each >= 2 */
  counts: number[];
  /** 2 elements. heightfield: m between samples, 1e-6 to 1e6; default 1 */
  spacing: number[];
  /** m, x y z each, up to 1e6 in magnitude */
  vertices: Float32Array;
  /** 3 per triangle, each < vertex_count */
  indices: Uint32Array;
  /** m, up to 1e6 in magnitude; x varies fastest */
  heights: Float32Array;
}

/**
 * A motion of one collider. Within a step its position moves linearly and its orientation follows the normalised linear
 * quaternion, the shorter way round: rotations of more than half a turn per step appear shorter.
 */
export interface ColliderMotion {
  /** LR_MOVE_*; default LR_MOVE_TO */
  mode: number;
  collider: bigint;
  /** 3 elements. m, as in lr_collider_desc; LR_MOVE_TO and LR_MOVE_PLACE; default 0 */
  position: number[];
  /** 4 elements. quaternion x y z w; LR_MOVE_TO and LR_MOVE_PLACE; default 0 0 0 1 */
  orientation: number[];
  /** 3 elements. m/s; LR_MOVE_PLACE and LR_MOVE_VELOCITY; default 0 */
  linearVelocity: number[];
  /** 3 elements. rad/s; LR_MOVE_PLACE and LR_MOVE_VELOCITY; default 0 */
  angularVelocity: number[];
}

export interface ColliderState {
  /** LR_COLLIDER_* */
  kind: number;
  /** 3 elements. m, world frame */
  position: number[];
  /** 4 elements. unit quaternion x y z w, collider to world */
  orientation: number[];
  /** 3 elements. m/s, that lasts until changed; 0 while LR_MOVE_TO is pending */
  linearVelocity: number[];
  /** 3 elements. rad/s, world frame, that lasts until changed; 0 while LR_MOVE_TO is pending */
  angularVelocity: number[];
  friction: number;
  restitution: number;
  layers: number;
  /** 0 */
  flags: number;
}

/** The material of a collider. */
export interface Material {
  /** as in lr_collider_desc; default 1 */
  layers: number;
  /** as in lr_collider_desc; default 0.5 */
  friction: number;
  /** as in lr_collider_desc; default 0.2 */
  restitution: number;
}

/**
 * How bodies of a batch collide. A contact uses the geometric mean of both frictions and the larger restitution. A body
 * collides as its hull, reduced to at most 32 points, or as an ellipsoid if its asset is one.
 */
export interface BatchContact {
  /** bits: collides with colliders that share at least one; default all; 0: none */
  layers: number;
  /** coefficient of Coulomb friction, 0 to 10; default 0.5 */
  friction: number;
  /** speed after an impact over speed before it, 0 to 1; default 0.1 */
  restitution: number;
  /** moment against rolling and spinning over normal force times lever, 0 to 10; default 0.05. The lever is the geometric mean of reach and half the thickness: of a sphere, its radius */
  rollingResistance: number;
  /** bits: LR_CONTACT_NEVER_SLEEP; default 0 */
  flags: number;
  /** air cushion under a sheet that settles on a plane or heightfield, as a share of theory, 0 to 1; default 0. docs/maintainers/contact.md */
  groundEffect: number;
  /** m, at scale 1, -1 to 10: sheets thinner than this meet other bodies as if they were so thick, at most a tenth of their reach; 0: 1/32 of it, at most 1.25 mm; below 0: as thick as they are, for decks of cards; default 0 */
  minThickness: number;
}

/** One event: 64 bytes in arrays without gaps. This struct never changes after 0.2. */
export interface Event {
  /** LR_EVENT_* */
  kind: number;
  batch: number;
  /** stale if it was destroyed */
  body: bigint;
  /** the body's: lr_body_desc.user */
  user: bigint;
  /** LR_EVENT_HIT, LR_EVENT_LIFTED; else id 0 */
  collider: bigint;
  /** 3 elements. m, world frame: the point of contact in LR_EVENT_HIT; where it ended in LR_EVENT_KILLED and LR_EVENT_RESPAWNED; the last valid centre of mass in LR_EVENT_DIVERGED; else the centre of mass */
  position: number[];
  /** 3 elements. LR_EVENT_HIT: unit, world frame, from the collider to the body; else 0 */
  normal: number[];
  /** m/s, LR_EVENT_HIT: approach speed along the normal, >= 0; else 0 */
  speed: number;
  /** N s, LR_EVENT_HIT: along the normal, in the substep of first contact; else 0 */
  impulse: number;
}

export interface EventList {
  count: number;
  /** of the last step; null before lr_world_set_events */
  events: Event;
  /** events of the last step beyond capacity: those last in order are dropped */
  lost: number;
  /** since lr_world_set_events */
  totalLost: number;
  /** as set by lr_world_set_events */
  capacity: number;
  /** bits LR_EVENTS_*, likewise */
  kinds: number;
}

export interface Ray {
  /** bits LR_RAY_*: what it can hit; default both */
  flags: number;
  /** 3 elements. m, up to 1e9 in magnitude; default 0 */
  origin: number[];
  /** 3 elements. any length from 1e-6 to 1e6; default 0, -1, 0 */
  direction: number[];
  /** m, 0 to 1e9; default 1e9 */
  maxDistance: number;
  /** hits bodies of this batch only; default id 0: of all batches */
  batch: number;
  /** bits: hits colliders that share at least one; default all */
  colliderLayers: number;
}

/**
 * The first hit of a ray, all 0 if there is none: 56 bytes in arrays without gaps. This struct never changes after
 * 0.2.
 */
export interface RayHit {
  /** id 0: it hit a collider */
  body: bigint;
  /** the body's: lr_body_desc.user */
  user: bigint;
  /** id 0: it hit a body */
  collider: bigint;
  /** m, from the ray's origin */
  distance: number;
  /** 3 elements. m, world frame */
  position: number[];
  /** 3 elements. unit, world frame, outward. If the ray starts inside: against the ray, at distance 0 */
  normal: number[];
}

export interface OverlapDesc {
  /** LR_OVERLAP_*; default LR_OVERLAP_SPHERE */
  shape: number;
  /** 3 elements. m, of its centre, up to 1e9 in magnitude; default 0 */
  position: number[];
  /** 4 elements. of a box, x y z w, normalised by the call; default 0 0 0 1 */
  orientation: number[];
  /** 3 elements. m, > 0, up to 1e6; default 1 */
  size: number[];
  /** finds bodies of this batch only; default id 0: of all batches */
  batch: number;
}

export interface KillVolume {
  /** LR_VOLUME_* */
  shape: number;
  /** LR_KILL_*: the side on which bodies end */
  side: number;
  /** 3 elements. m, up to 1e9 in magnitude */
  center: number[];
  /** 3 elements. m; of a plane its normal, any length but 0 */
  size: number[];
}

/**
 * When the bodies of a batch end. Diverged bodies end under any rules, unless lr_batch_set_divergence_policy holds
 * them.
 */
export interface BatchRules {
  /** LR_END_*; default LR_END_DESTROY */
  action: number;
  /** s, up to 1e9; default 0: no limit */
  maxAge: number;
  /** elements of `volumes` in use; default 0 */
  volumeCount: number;
  /** 8 elements. tested with the centre of mass */
  volumes: KillVolume[];
}

/**
 * How bodies of a batch spawn. Random values depend only on the world's seed, the body's noise seed, and the number of
 * times it has respawned.
 */
export interface EmitterDesc {
  /** LR_EMIT_*; default LR_EMIT_POINT */
  shape: number;
  /** 3 elements. m, centre of the shape; default 0 */
  position: number[];
  /** 4 elements. of the shape, x y z w, normalised by the call; default 0 0 0 1 */
  orientation: number[];
  /** 3 elements. m, half extents or semi-axes along the shape's own axes, 0 to 1e9; default 0 */
  size: number[];
  /** LR_POSE_*, of the bodies; default LR_POSE_RANDOM */
  pose: number;
  /** 4 elements. body to world, normalised by the call; default 0 0 0 1 */
  bodyOrientation: number[];
  /** 3 elements. of the velocity, world frame, any length but 0; default 0, -1, 0 */
  direction: number[];
  /** rad, half angle of a cone about `direction`, filled evenly, 0 to pi; default 0 */
  spread: number;
  /** m/s, uniform in this range; default 0 */
  speedMin: number;
  /** m/s, uniform in this range; default 0 */
  speedMax: number;
  /** rad/s, uniform in this range, about a random axis; default 0 */
  spinMin: number;
  /** rad/s, uniform in this range, about a random axis; default 0 */
  spinMax: number;
  /** uniform in this range; default 1 */
  scaleMin: number;
  /** uniform in this range; default 1 */
  scaleMax: number;
  /** spawns per second, 0 to 1e9; default 0: bodies respawn, but none are added */
  rate: number;
  /** s between bursts, >= 1e-4 */
  burstInterval: number;
  /** spawns in each burst; default 0: no bursts */
  burstCount: number;
}

/**
 * Numbers of bodies that rules ended and the emitter spawned in the last step, and totals since the batch was created.
 * lr_world_get_events names the bodies.
 */
export interface BatchCounts {
  /** by rate and bursts */
  spawned: number;
  /** by the rules */
  destroyed: number;
  respawned: number;
  /** spawns dropped for lack of room */
  missed: number;
  /** diverged: lr_batch_set_divergence_policy */
  byDivergence: number;
  byAge: number;
  /** 8 elements. */
  byVolume: number[];
  /** bodies that diverged in the last step, held or ended */
  diverged: number;
  /** including lr_batch_spawn, lr_batch_spawn_box */
  totalSpawned: number;
  totalDestroyed: number;
  totalRespawned: number;
  totalMissed: number;
  totalDiverged: number;
}

/**
 * Coefficients of the quasi-steady loads (LR_LOADS_AERODYNAMIC) at scale 1; equations: docs/maintainers/physics.md,
 * AERODYNAMIC. All loads act at `center`, along `axes`, which rotate with the body. Arrays hold one value per axis.
 * Symbols: v is the velocity through the fluid and w the spin, both along the axes; s = |v|; (i, j, k) are cyclic; d is
 * lr_asset_info.length_d; rho and nu are the fluid's density and kinematic viscosity.
 */
export interface Aerodynamics {
  /** 9 elements. rows: unit vectors in the body frame, right-handed */
  axes: number[];
  /** 3 elements. m^2, drag coefficient times area */
  drag: number[];
  /** 3 elements. m^2, the part of rounded bodies, which grows with the Reynolds number */
  dragBlunt: number[];
  /** 3 elements. m^(3/2), boundary layer */
  dragLayer: number[];
  /** 3 elements. m, creeping flow */
  dragStokes: number[];
  /** 3 elements. m^2, positive where the body is thinner along j than along i */
  lift: number[];
  /** 3 elements. m^3 */
  spinLift: number[];
  /** 3 elements. ignored since 0.3 */
  liftMoment: number[];
  /** 3 elements. m^5 */
  spinDrag: number[];
  /** 3 elements. m^4 */
  spinDragStream: number[];
  /** 3 elements. m^3 */
  spinDragStokes: number[];
  /** velocity fluctuations in the body's own wake, per axis, over s. Above 0.4, gains included, it acts as 0.4: a stronger wake would feed itself */
  intensity: number;
  /** m: the fluctuations are correlated over length/s */
  length: number;
  /** scales the fluctuations by Re/(Re + wake_reynolds): slow wakes are laminar */
  wakeReynolds: number;
  /** 3 elements. 0 to 1: the fluctuations grow with sum_i broadside_i (v_i/s)^2 */
  broadside: number[];
  /** ignored since 0.3 */
  liftStall: number;
  /** 3 elements. ignored since 0.3 */
  liftMomentStalled: number[];
  /** 3 elements. ignored since 0.3 */
  rollDamping: number[];
  /** 3 elements. m, where the loads act, from the centre of buoyancy, body frame; within 2 d; default 0 */
  center: number[];
  /** 3 elements. m^2, >= 0 */
  plateLift: number[];
  /** 3 elements. m^2, >= 0 */
  plateVortex: number[];
  /** 3 elements. 0 to 1 */
  plateStall: number[];
  /**
   * This share of the added momentum along n, 0 to 1, does not move with the body while the stream is separated and sheds
   * vortices: it reduces the Munk moment.
   */
  plateSeparatedShedding: number;
  /** m^2, >= 0: drag coefficient broadside times area */
  plateDrag: number;
  /** >= 0: adds to N start_drag plate_drag |u - v| ((v - u) . v/s^2) v_n */
  startDrag: number;
  /** m, > 0 */
  wakeLength: number;
  /** > 0 */
  wakeLag: number;
  /** 0 to 1 */
  wakeShare: number;
  /**
   * Vortex shedding above the Reynolds number shedding_reynolds of wake_length: an oscillator q in the plate with the
   * frequency strouhal s/wake_length and the moment rho v_n^2 n x (shedding_moment q + shedding_rate_moment r), r the
   * rate of q over 2 pi times the frequency. It starts from the fluctuations. At shedding_reynolds and below, the wake
   * remembers for 2.5 times as long, and the stream stalls later: 1/plate_stall - 1 counts 0.4 times.
   */
  strouhal: number;
  /** >= 0 */
  sheddingGrowth: number;
  /** >= 0 */
  sheddingReynolds: number;
  /** >= 0: of r by the fluctuations */
  sheddingNoise: number;
  /** m^3 */
  sheddingMoment: number;
  /** m^3 */
  sheddingRateMoment: number;
  /** 3 elements. m^(7/2), boundary layer: see spin_drag */
  spinDragLayer: number[];
}

/**
 * A body of known numbers without a mesh or file: from another solver, from measurements, or the cross-section of a
 * card in two dimensions. Matrices are row-major, symmetric, about the centre of mass, in body axes.
 */
export interface RigidDesc {
  /** kg, > 0 */
  mass: number;
  /** m^3, > 0 */
  volume: number;
  /** 9 elements. kg m^2, positive definite */
  inertia: number[];
  /** 36 elements. kg, kg m, kg m^2: order vx vy vz wx wy wz, fluid density included, as in lr_asset_info; positive semi-definite; default 0 */
  addedMass: number[];
  /** 3 elements. m, from the centre of mass; default 0 */
  centerOfBuoyancy: number[];
  /** kg/m^3, > 0; default 1.2, air */
  fluidDensity: number;
  /** m^2/s, kinematic, > 0; default 1.5e-5, air */
  fluidViscosity: number;
  /** 3 elements. m, full size along the body axes, > 0 */
  extents: number[];
  /** of the turbulence table, as in lr_ellipsoid_desc; default 1 */
  intensity: number;
  /** copied; default null: an ellipsoid's with these extents */
  aerodynamics: Aerodynamics;
}

/** k-epsilon samples in the units of the bake. Arrays are copied. */
export interface TurbulenceTable {
  /** samples, 1 to 65536 */
  count: number;
  /** 1/s, turbulent frequency epsilon / k, `count` values >= 0 */
  chi: Float32Array;
  /** m^2/s^3, dissipation rate, `count` values >= 0 */
  epsilon: Float32Array;
  /** s between samples, > 0 */
  dt: number;
  /** m/s, the speed that the table was made at, > 0; LR_CLOCK_SPEED scales by it */
  u0: number;
  /** m, the length that the table was made with, > 0 */
  l: number;
  /** Kolmogorov constant, > 0; default 6.5, its limit at high Reynolds number */
  c0: number;
  /** the sample that LR_CLOCK_SPEED uses, < count; default 0 */
  stationary: number;
}

/**
 * The loads of the flow on a body and the state of its wake, for inspectors and debug arrows: what AERODYNAMIC loads do
 * to it now. Weight, buoyancy and added mass are not among them, but what turning costs where added momentum is left in
 * the wake is. World frame.
 */
export interface BodyLoads {
  /** 1 to 8: 1 where one stream describes the shape; 0: no AERODYNAMIC loads */
  stationCount: number;
  /** 3 elements. m/s, velocity of the fluid relative to the body, its own fluctuations included */
  stream: number[];
  /** 3 elements. m/s, the stream that the wake remembers: it follows `stream` */
  wake: number[];
  /** 3 elements. q of the vortex shedding (lr_aerodynamics), up to 1.4; 0: a steady wake */
  shedding: number[];
  /** 3 elements. N, sum of all stations */
  force: number[];
  /** 3 elements. N m, about the centre of mass, with the couples of spin and shed vortices */
  torque: number[];
  /** 24 elements. m, x y z of each station */
  stationPosition: number[];
  /** 24 elements. N, x y z of each station's force */
  stationForce: number[];
}

/** The C functions as the module exports them: addresses are numbers, 64 bits are bigints. */
export interface RawFunctions {
  /**
   * Version of the loaded library: major << 22 | minor << 12 | patch. Compare it with the macros above when you load the
   * library at run time. A different major version has a different ABI; before 1.0, so has a different minor version.
   */
  lr_version(): number;
  /**
   * A short English phrase for a status, without a full stop. Unknown values give "unknown status". Never null; static
   * storage.
   */
  lr_status_string(status: number): number;
  /**
   * The text of the calling thread's last failed call: the function and the reason, as the log has it. Calls that succeed
   * leave it alone. Never null, empty before the first failure, cut after 255 bytes. Valid until the thread's next failed
   * call.
   */
  lr_last_error(): number;
  /**
   * Lists the instruction sets that this build contains and this processor supports, best first.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL (count is set).
   */
  lr_simd_targets(targets: number, capacity: number, count: number): number;
  /**
   * A display name: "AVX-512", "AVX2", "SSE4", "NEON", "WebAssembly", "plain", "auto" or "unknown". Never null; static
   * storage.
   */
  lr_simd_target_name(target: number): number;
  /**
   * Loads an asset made by `lr_bake` from a regular file. The whole file is verified before any of it is used.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_FILE_NOT_FOUND, LR_ERROR_FILE_READ, LR_ERROR_ASSET_FORMAT,
   * LR_ERROR_ASSET_VERSION, LR_ERROR_ASSET_CORRUPT, LR_ERROR_ASSET_INVALID, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_asset_load_file(path_utf8: number, out: number): number;
  /**
   * Loads an asset from memory.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_ASSET_*, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_asset_load_memory(bytes: number, size: bigint, out: number): number;
  /**
   * Checks the bytes of an asset and calls `report`, which may be null, once for each fault found.
   * Returns what lr_asset_load_memory would.
   */
  lr_asset_check_memory(bytes: number, size: bigint, report: number, user: number): number;
  /**
   * Sets the defaults, those of LR_ELLIPSOID_DESC_INIT. All other _init functions work alike. struct_size:
   * sizeof(lr_ellipsoid_desc) in the caller's header.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
   */
  lr_ellipsoid_desc_init(desc: number, struct_size: number): number;
  /**
   * Creates an asset from an ellipsoid. Formulas: Lamb, Hydrodynamics, art. 114-115; docs/maintainers/physics.md.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
   * LR_ERROR_OUT_OF_MEMORY.
   */
  lr_asset_create_ellipsoid(desc: number, out: number): number;
  /**
   * Adds a reference, which lr_asset_release gives back.
   * LR_OK, LR_ERROR_NULL_ARGUMENT.
   */
  lr_asset_retain(asset: number): number;
  /** Gives back a reference. The last one frees the asset. Each batch holds its own. Null is allowed. */
  lr_asset_release(asset: number): void;
  lr_asset_info_init(info: number, struct_size: number): number;
  /**
   * Reads an asset's properties.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
   */
  lr_asset_get_info(asset: number, info: number): number;
  lr_world_desc_init(desc: number, struct_size: number): number;
  /**
   * Creates a world.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
   * LR_ERROR_UNSUPPORTED (simd_target), LR_ERROR_OUT_OF_MEMORY, LR_ERROR_THREADS.
   */
  lr_world_create(desc: number, out: number): number;
  /** Destroys a world with its batches and bodies, stops its worker threads and ends its recording. Null is allowed. */
  lr_world_destroy(world: number): void;
  lr_world_info_init(info: number, struct_size: number): number;
  /**
   * Reads counts, time and settings of the world.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
   */
  lr_world_get_info(world: number, info: number): number;
  /**
   * Sets gravity from the next step on. A change wakes all bodies (lr_body_set_sleep).
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_world_set_gravity(world: number, gravity: number): number;
  /**
   * Sets the instruction set from the next step on. Results do not change.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_UNSUPPORTED.
   */
  lr_world_set_simd_target(world: number, target: number): number;
  /**
   * Sets the uniform wind, the same velocity everywhere; 0 before the first call. A change is spread evenly over the next
   * step, in which bodies feel the fluid accelerate (Froude-Krylov force and added mass): a body as dense as the fluid is
   * carried along, a heavy one keeps most of its velocity. A wind set before the world's first step is there from the
   * beginning and accelerates nothing. Setting the same wind again changes nothing.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_world_set_uniform_wind(world: number, x: number, y: number, z: number): number;
  /**
   * Reads the uniform wind that was set last.
   * LR_OK, LR_ERROR_NULL_ARGUMENT.
   */
  lr_world_get_uniform_wind(world: number, velocity: number): number;
  lr_gusts_desc_init(desc: number, struct_size: number): number;
  /**
   * Adds gusts. The struct is copied.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
   * LR_ERROR_CAPACITY (of sources), LR_ERROR_OUT_OF_MEMORY.
   */
  lr_world_add_gusts(world: number, desc: number, out: number): number;
  /**
   * Replaces all values of a source of this kind.
   * LR_OK, LR_ERROR_STALE_WIND_SOURCE, LR_ERROR_INVALID_ARGUMENT (also a source of another kind), and every status of
   * lr_world_add_gusts but LR_ERROR_CAPACITY.
   */
  lr_world_update_gusts(world: number, source: number, desc: number): number;
  /**
   * Reads a source of this kind as it was added or last updated, but with the position where it is now. desc:
   * initialised, or with struct_size set; unchanged after an error.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_STALE_WIND_SOURCE, LR_ERROR_INVALID_ARGUMENT (a source
   * of another kind).
   */
  lr_world_get_gusts(world: number, source: number, desc: number): number;
  lr_vortex_desc_init(desc: number, struct_size: number): number;
  /** Adds a vortex. Returns what lr_world_add_gusts would. */
  lr_world_add_vortex(world: number, desc: number, out: number): number;
  /** Updates a vortex. Returns what lr_world_update_gusts would. */
  lr_world_update_vortex(world: number, source: number, desc: number): number;
  /** Reads a vortex as last set. Returns what lr_world_get_gusts would. */
  lr_world_get_vortex(world: number, source: number, desc: number): number;
  lr_blower_desc_init(desc: number, struct_size: number): number;
  /** Adds a blower. Returns what lr_world_add_gusts would. */
  lr_world_add_blower(world: number, desc: number, out: number): number;
  /** Updates a blower. Returns what lr_world_update_gusts would. */
  lr_world_update_blower(world: number, source: number, desc: number): number;
  /** Reads a blower as last set. Returns what lr_world_get_gusts would. */
  lr_world_get_blower(world: number, source: number, desc: number): number;
  lr_turbulence_desc_init(desc: number, struct_size: number): number;
  /** Adds turbulence. Returns what lr_world_add_gusts would. */
  lr_world_add_turbulence(world: number, desc: number, out: number): number;
  /** Updates turbulence. Returns what lr_world_update_gusts would. */
  lr_world_update_turbulence(world: number, source: number, desc: number): number;
  /** Reads turbulence as last set. Returns what lr_world_get_gusts would. */
  lr_world_get_turbulence(world: number, source: number, desc: number): number;
  lr_wind_grid_desc_init(desc: number, struct_size: number): number;
  /** Adds a grid. Returns what lr_world_add_gusts would. */
  lr_world_add_wind_grid(world: number, desc: number, out: number): number;
  /** Updates a grid. Returns what lr_world_update_gusts would. */
  lr_world_update_wind_grid(world: number, source: number, desc: number): number;
  /** Reads a grid as last set. Returns what lr_world_get_gusts would. */
  lr_world_get_wind_grid(world: number, source: number, desc: number): number;
  lr_ground_wind_desc_init(desc: number, struct_size: number): number;
  /** Adds the wind over a ground. Returns what lr_world_add_gusts would. */
  lr_world_add_ground_wind(world: number, desc: number, out: number): number;
  /** Updates the wind over a ground. Returns what lr_world_update_gusts would. */
  lr_world_update_ground_wind(world: number, source: number, desc: number): number;
  /** Reads the wind over a ground as last set. Returns what lr_world_get_gusts would. */
  lr_world_get_ground_wind(world: number, source: number, desc: number): number;
  /**
   * Removes a source of any kind.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_WIND_SOURCE.
   */
  lr_world_remove_wind(world: number, source: number): number;
  /** Returns 1 if the wind source exists in this world, else 0. Never an error: see lr_body_is_valid. */
  lr_wind_source_is_valid(world: number, source: number): number;
  /**
   * Sets a callback that adds an engine's own wind field to all other wind. Null removes it. Not part of snapshots.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world).
   */
  lr_world_set_wind_callback(world: number, callback: number, user: number): number;
  /**
   * Evaluates the fluid's velocity from all sources at the world's current time, for particles, cloth or debug arrows.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_world_sample_wind(world: number, positions: number, count: number, velocities: number): number;
  lr_water_desc_init(desc: number, struct_size: number): number;
  /**
   * Sets the water from the next step on. The struct is copied; null removes the water. Bodies keep their velocities,
   * even if they are now in another fluid. A batch whose mass matrix would be singular in water stays in its own fluid,
   * and a warning is logged. Part of snapshots and of the world's hash. A change wakes sleeping bodies that feel it.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
   * LR_ERROR_OUT_OF_MEMORY.
   */
  lr_world_set_water(world: number, desc: number): number;
  /**
   * Reads the water.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
   */
  lr_world_get_water(world: number, desc: number, present: number): number;
  /**
   * Sets a callback for an engine's own water, used while lr_world_set_water has set a surface. Null removes it. Not
   * part of snapshots.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world).
   */
  lr_world_set_water_callback(world: number, callback: number, user: number): number;
  /**
   * Advances all bodies by dt, in `substeps` equal parts. At 60 Hz use 1 substep for flat leaves and paper of a
   * few centimetres, 2 for bent leaves, 4 for petals and confetti (docs/maintainers/numerics.md). Rules end bodies and
   * emitters spawn them at the end of the step. Allocates only in the case that lr_allocator describes. Saves, sets and
   * restores the calling thread's floating-point mode. Needs 192 KB of stack.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_TIMESTEP_*, LR_ERROR_SUBSTEPS, LR_ERROR_OUT_OF_MEMORY: the step was taken, so
   * do not repeat it, but bodies may have passed through each other. The next step asks for the memory again.
   */
  lr_world_step(world: number, dt: number, substeps: number): number;
  /**
   * Limits the work of each step to a number of substeps of single bodies: the same work, so the same bits, on every
   * machine. Takes effect at the next step. Part of snapshots. If the batches that are due need more, each first gets the
   * fewest substeps that preserve its fall statistics (lr_batch_set_rate); batches that have waited longest come first,
   * and none waits forever. A batch with forces on single bodies is stepped at once, even beyond the budget.
   * docs/reference/stepping.md.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_world_set_budget(world: number, body_substeps: bigint): number;
  lr_step_report_init(report: number, struct_size: number): number;
  /**
   * Reads the report of the last step: zeros before the first step and after a snapshot is restored.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
   */
  lr_world_get_step_report(world: number, report: number): number;
  lr_timings_init(timings: number, struct_size: number): number;
  /**
   * Reads the timings of the last step: zeros before the first one.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
   */
  lr_world_get_timings(world: number, timings: number): number;
  /**
   * Computes a hash of the world's time index, bodies, colliders, pairs of touching bodies, water and wind sources (grids
   * by the hash of their samples). It does not depend on the order of bodies in memory, the processor or worker_count.
   * Worlds with equal settings and equal hashes move alike from here on.
   * LR_OK, LR_ERROR_NULL_ARGUMENT.
   */
  lr_world_hash(world: number, out: number): number;
  /**
   * Bytes that lr_world_snapshot_save needs at present; 0 for null. With body contact 120 of them for each pair of awake
   * bodies that touch or nearly do.
   */
  lr_world_snapshot_size(world: number): bigint;
  /**
   * Writes the world's state into `size` bytes at `memory`, of any alignment: time, gravity, wind, water, budget; bodies
   * and colliders with their handles; pairs of touching bodies; each batch's turbulence table, loads, forces, rules,
   * emitter, rate and contact settings. Not included: assets, the descs of batches, threads, callbacks, the samples of
   * wind grids, and the data of hulls, heightfields and meshes; samples and data are identified by their hash.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL.
   */
  lr_world_snapshot_save(world: number, memory: number, size: bigint, written: number): number;
  /**
   * Restores a saved state. The world may be another one, also in another process, if its batches were created in the
   * same order from equal assets with equal capacities. Bodies, wind sources and colliders get their handles back. Wind
   * grids, hulls, heightfields and meshes must already be in the world, anywhere. The snapshot is checked as a whole
   * before anything changes. Allocates nothing in a world that has held as much before. docs/reference/snapshots.md says
   * which versions restore which snapshots.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_SNAPSHOT_FORMAT, LR_ERROR_SNAPSHOT_MISMATCH, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_world_snapshot_restore(world: number, memory: number, size: bigint): number;
  lr_recording_desc_init(desc: number, struct_size: number): number;
  /**
   * Starts a recording, at any time. First writes the world's present state and the assets of its batches, then each call
   * that can change the world: its arguments, as a rule before it is carried out, and its status after it. Allocates 64
   * KiB and a few bytes per asset; while starting, also a copy of the assets and a snapshot. If `write` refuses, the
   * recording ends, a message is logged, and the world goes on.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->write), LR_ERROR_STRUCT_SIZE, LR_ERROR_INVALID_ARGUMENT (unknown flags;
   * already recording; `write` has refused), LR_ERROR_OUT_OF_MEMORY.
   */
  lr_world_record_start(world: number, desc: number): number;
  /**
   * Ends a recording.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (not recording, also after `write` has refused).
   */
  lr_world_record_stop(world: number): number;
  lr_batch_desc_init(desc: number, struct_size: number): number;
  /**
   * Creates a batch.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->asset), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_create(world: number, desc: number, out: number): number;
  /**
   * Destroys a batch with all its bodies. Wakes the bodies of batches that had body contact with it
   * (lr_batch_set_body_contact).
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH.
   */
  lr_batch_destroy(world: number, batch: number): number;
  /** Returns 1 if the batch exists in this world, else 0. Never an error: see lr_body_is_valid. */
  lr_batch_is_valid(world: number, batch: number): number;
  lr_load_gains_init(gains: number, struct_size: number): number;
  /**
   * Sets the gains of a batch from the next step on; null sets all to 1. The gains of LANGEVIN loads are in
   * lr_batch_desc.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_set_load_gains(world: number, batch: number, gains: number): number;
  /**
   * Reads the gains of a batch.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
   */
  lr_batch_get_load_gains(world: number, batch: number, gains: number): number;
  /**
   * Sets how often a batch is stepped: level of detail for bodies that are far away, small or out of sight. A batch of
   * divisor n takes one substep where other batches take n: fewer in each step or, if n exceeds the world's substeps, one
   * every few steps that covers them all. Substeps are never so long that fall statistics change: at most 1/60 s, and
   * length_d / 2 m/s for bodies under 3.3 cm. Larger divisors have no further effect. docs/reference/stepping.md.
   * Takes effect at the next step and may change at any time: a waiting batch catches up when it is next stepped. Part of
   * snapshots. While a batch waits
   *  - views and lr_body_get_state show bodies as of their last step, lr_batch_pace.behind ago;
   *  - bodies that are created or set count as of that time too;
   *  - lr_batch_write_transforms extrapolates to the present by the bodies' velocities;
   *  - a force on one of its bodies ends the wait, and acts with the impulse that it would have had in one step;
   *  - a collider that moves within the bounds of its bodies ends the wait, since it would pass through them;
   *  - its rules, emitter and events wait too.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_set_rate(world: number, batch: number, divisor: number): number;
  lr_batch_pace_init(pace: number, struct_size: number): number;
  /**
   * Reads a batch's rate and backlog.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
   */
  lr_batch_get_pace(world: number, batch: number, pace: number): number;
  lr_batch_view_init(view: number, struct_size: number): number;
  /**
   * Gets the view of a batch.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
   */
  lr_batch_get_view(world: number, batch: number, view: number): number;
  /**
   * Computes a box around all bodies of a batch, awake or asleep, for culling. Each body counts as the sphere that
   * contains it in any orientation; the box of a waiting batch (lr_batch_set_rate) also contains the places that
   * lr_batch_write_transforms extrapolates to. The cost is proportional to the number of bodies.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH.
   */
  lr_batch_get_bounds(world: number, batch: number, low: number, high: number): number;
  /**
   * Writes the transforms of a batch's first `count` bodies, or of all if there are fewer, in the order of its view. Draw
   * a mesh whose origin is the centre of mass (lr_asset_info.center_of_mass). Bodies of a waiting batch
   * (lr_batch_set_rate) are extrapolated to the world's time.
   * An instance buffer that still holds the last write needs no rewrite of sleeping bodies. While lr_batch_view.revision
   * is unchanged, `count` may be the greater of the old and the new awake_count; otherwise write all bodies. Remember
   * both numbers per buffer. docs/reference/bodies.md.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (dst may be null only when nothing is to be written), LR_ERROR_STALE_BATCH,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_write_transforms(world: number, batch: number, format: number, dst: number, stride: bigint, count: number, written: number): number;
  /**
   * Writes the velocities of a batch's first `count` bodies, or of all if there are fewer, in the order of its view. An
   * element is 6 floats, world frame: the linear velocity of the centre of mass, m/s, and the angular velocity, rad/s; bit
   * for bit those of lr_body_get_state. Sleeping bodies have 0, bodies of a waiting batch (lr_batch_set_rate) the
   * velocities of their last step.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (dst may be null only when nothing is to be written), LR_ERROR_STALE_BATCH,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_write_velocities(world: number, batch: number, dst: number, stride: bigint, count: number, written: number): number;
  lr_body_desc_init(desc: number, struct_size: number): number;
  /**
   * Creates `count` bodies, all or none.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_body_create(world: number, batch: number, descs: number, count: number, out_ids: number): number;
  /**
   * Destroys `count` bodies of any batches, all or none: a stale or repeated id fails the call. Wakes the bodies that lay
   * on them.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY.
   */
  lr_body_destroy(world: number, bodies: number, count: number): number;
  /**
   * Returns 1 if the body exists in this world, else 0. Never an error: a null world gives 0, and so does a call
   * that lr_world_desc.checks refuses. Not recorded.
   */
  lr_body_is_valid(world: number, body: bigint): number;
  lr_body_state_init(state: number, struct_size: number): number;
  /**
   * Reads the state of a body.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE.
   */
  lr_body_get_state(world: number, body: bigint, state: number): number;
  /**
   * Sets everything but the noise seed, and wakes the body. The quaternion is normalised. Limits, also of lr_body_create:
   * positions up to 1e9 m, velocities up to 1e6 m/s and rad/s. To steer bodies every frame, prefer forces and wind:
   * setting the state bypasses physics.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY (of `user`, as for lr_body_create).
   */
  lr_body_set_state(world: number, body: bigint, state: number): number;
  /**
   * Puts bodies of any batches to sleep or wakes them, all or none. Bodies may already be in that state, and ids may
   * repeat. A sleeping body does not move, whatever acts on it, and adds no cost to a step. Its velocities and pending
   * forces are cleared. It still ages, and its batch's rules still apply: they check sleeping bodies in every 16th step
   * of the batch. Falling asleep and waking change a body's index in the view, not its id. Part of snapshots. A batch's
   * first sleeping body allocates up to 25 bytes for each body of the batch's capacity. A body is woken by
   *  - this function, lr_world_wake_box and lr_body_set_state;
   *  - a force, impulse or velocity other than zero (lr_body_add_force, lr_batch_add_forces);
   *  - a change by lr_batch_set_force, lr_world_set_gravity or lr_batch_set_body_contact that concerns it;
   *  - a respawn by its batch's rules;
   *  - contact with colliders or other bodies, and wind: docs/reference/bodies.md.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_INVALID_ARGUMENT,
   * LR_ERROR_OUT_OF_MEMORY.
   */
  lr_body_set_sleep(world: number, bodies: number, count: number, sleep_state: number): number;
  /**
   * Wakes all sleeping bodies that touch a box, for events that the world does not know about, such as footsteps and
   * explosions. Each body counts as the cube that contains it in any orientation. The cost depends on the bodies near the
   * box alone.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_world_wake_box(world: number, low: number, high: number, woken: number): number;
  lr_body_force_init(force: number, struct_size: number): number;
  /**
   * Applies `count` forces to bodies of any batches, all or none. A body may occur more than once. Each element may give
   * its body at most 1e9 m/s^2 (torques: 1e9 m/s^2 over its length), an impulse at most 1e6 m/s and rad/s. Pending forces
   * are part of snapshots and of the world's hash. The first force or acceleration on a body of a batch allocates 96
   * bytes for each body of the batch's capacity.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_body_add_force(world: number, forces: number, count: number): number;
  lr_force_arrays_init(arrays: number, struct_size: number): number;
  /**
   * Applies forces to many bodies of a batch; limits, snapshots and memory as for lr_body_add_force.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (some of three pointers), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE,
   * LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also if first + count exceeds the batch's bodies),
   * LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_add_forces(world: number, batch: number, arrays: number): number;
  lr_batch_force_init(force: number, struct_size: number): number;
  /**
   * Sets the forces on a batch from the next step on. The struct is copied; null clears them. A change wakes the batch's
   * sleeping bodies. Part of snapshots.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_set_force(world: number, batch: number, force: number): number;
  /**
   * Reads the forces on every body of a batch.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
   */
  lr_batch_get_force(world: number, batch: number, force: number): number;
  lr_collider_desc_init(desc: number, struct_size: number): number;
  /**
   * Creates `count` colliders, all or none, which collide from the next step on. Equal hulls, heightfields and meshes
   * share one copy of their data.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT (also for arrays that the kind needs), LR_ERROR_STRUCT_SIZE,
   * LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also for a flat hull, thinner than 1e-4 of its largest extent, and
   * for a mesh with an index out of range or no triangle with an area), LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_collider_create(world: number, descs: number, count: number, out_ids: number): number;
  /**
   * Destroys `count` colliders, all or none: a stale or repeated handle fails the call.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER.
   */
  lr_collider_destroy(world: number, colliders: number, count: number): number;
  /** Returns 1 if the collider exists in this world, else 0. Never an error: see lr_body_is_valid. */
  lr_collider_is_valid(world: number, collider: bigint): number;
  lr_collider_motion_init(motion: number, struct_size: number): number;
  /**
   * Moves `count` colliders, all or none, in order: the last motion of a collider wins. While a plane rotates, no body of
   * the world can use the fast path.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_STALE_COLLIDER, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_collider_move(world: number, motions: number, count: number): number;
  lr_collider_state_init(state: number, struct_size: number): number;
  /**
   * Reads the state of a collider.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE.
   */
  lr_collider_get_state(world: number, collider: bigint, state: number): number;
  lr_material_init(material: number, struct_size: number): number;
  /**
   * Sets one material for `count` colliders, all or none, from the next step on. A change wakes bodies asleep on them.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_collider_set_material(world: number, colliders: number, count: number, material: number): number;
  lr_batch_contact_init(contact: number, struct_size: number): number;
  /**
   * Sets how a batch collides from the next step on. The struct is copied; null restores the defaults. Wakes the batch's
   * sleeping bodies. Part of snapshots.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_set_contact(world: number, batch: number, contact: number): number;
  /**
   * Reads how a batch collides.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
   */
  lr_batch_get_contact(world: number, batch: number, contact: number): number;
  /**
   * Turns body contact on or off from the next step on: collisions between bodies of `a` and bodies of `b`, in either
   * order. Pass the same batch twice for collisions within it. Off by default. Contacts use friction, restitution and
   * rolling resistance of lr_batch_contact, combined as there; layers apply to colliders only. Bodies of batches stepped
   * at different rates (lr_batch_set_rate), or waiting for the budget, collide only while one of the two is asleep. A
   * change wakes the sleeping bodies of both batches. Part of snapshots. A batch's first pair allocates 28 bytes for each
   * body of its capacity, and up to 75 more if the world has never had colliders. docs/maintainers/contact.md.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH (either), LR_ERROR_INVALID_ARGUMENT (enabled),
   * LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_set_body_contact(world: number, a: number, b: number, enabled: number): number;
  /**
   * Reads whether bodies of two batches collide.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH (either).
   */
  lr_batch_get_body_contact(world: number, a: number, b: number, enabled: number): number;
  /**
   * Enables events; at most `capacity` are stored per step. Contacts that already exist do not begin again. capacity 0
   * disables events. All memory is allocated here and by lr_batch_create, none in steps: 64 bytes per event, and 233 for
   * each body of a batch's capacity. Not part of the world's hash. Snapshots contain only events that calls since the
   * last step have left for the next one, 33 bytes for each body of a batch's capacity.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (unknown bits, or no bits with a capacity),
   * LR_ERROR_OUT_OF_MEMORY.
   */
  lr_world_set_events(world: number, capacity: number, kinds: number): number;
  lr_event_list_init(list: number, struct_size: number): number;
  /**
   * Gets the events of the last step. Valid until the next call that is not a query; empty after
   * lr_world_snapshot_restore. Sorted by batch (its place in the world's table), noise seed, kind and collider slot, so
   * the order does not depend on workers, processor or memory. Bodies with the same noise seed are sorted by slot.
   * Contacts are checked after each substep but end only at the end of a step: a body that bounces within a step begins
   * one contact, and one that touches and leaves begins and ends it. A sleeping body still touches its support. A body
   * that ends has one LR_EVENT_KILLED or LR_EVENT_RESPAWNED, and before it at most LR_EVENT_SPAWNED, after it at most
   * LR_EVENT_DIVERGED. lr_body_destroy and lr_batch_destroy cause no event. A body has at most four contacts, those that
   * press it most. Contact with other bodies takes one of the four and causes no events, but a body that falls asleep on
   * other bodies has landed.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
   */
  lr_world_get_events(world: number, list: number): number;
  lr_ray_init(ray: number, struct_size: number): number;
  /**
   * Finds the first hit of each ray. Bodies have their contact shape, the hull of their asset or an ellipsoid
   * (docs/maintainers/contact.md); bodies of waiting batches (lr_batch_set_rate) are where they were last stepped. Planes
   * and heightfields are solid below their surface; meshes are hit from both sides. Colliders are where the last step or
   * lr_collider_move put them. Hits at equal distances are sorted: bodies before colliders, then by batch and noise seed
   * or by collider slot.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_STALE_BATCH.
   */
  lr_world_ray_cast(world: number, rays: number, count: number, hits: number): number;
  lr_overlap_desc_init(desc: number, struct_size: number): number;
  /**
   * Finds all bodies that overlap a sphere or box, sorted by batch, noise seed and slot. Shapes and places of bodies are
   * as for rays.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
   * LR_ERROR_STALE_BATCH, LR_ERROR_BUFFER_TOO_SMALL: *count is set, and the contents of `bodies` are undefined.
   */
  lr_world_overlap(world: number, desc: number, bodies: number, capacity: number, count: number): number;
  lr_batch_rules_init(rules: number, struct_size: number): number;
  /**
   * Sets the rules of a batch. Awake bodies are checked at the end of each step, sleeping ones in every 16th step of
   * their batch. The struct is copied; null removes the rules. Part of snapshots. A batch's first rules or emitter
   * allocate 8 bytes for each body of its capacity; later calls, such as moving a volume along with a camera, allocate
   * nothing.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT (also LR_END_RESPAWN without an emitter), LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_set_rules(world: number, batch: number, rules: number): number;
  /**
   * Reads the rules of a batch.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
   */
  lr_batch_get_rules(world: number, batch: number, rules: number, present: number): number;
  /**
   * Sets how a batch treats diverged bodies: those with a number that is not finite, a coordinate over 1e10 m, a velocity
   * over 2e6 m/s or 1e9 rad/s, or an invalid orientation. Bodies diverge through extreme forces, an unstable integrator,
   * or a collider that shoots them out of the world. Every body is checked in each step and after impulses, so such
   * values are never visible and never affect other bodies. At the end of the step the body causes LR_EVENT_DIVERGED and
   * counts in lr_batch_counts; one message is logged for all. docs/reference/bodies.md
   * A held body stays at its position and orientation from the beginning of that step or substep, without velocity. It
   * collides with nothing, and forces on it are accepted without effect. It ages, and rules can end it. lr_body_set_state
   * frees it, lr_body_set_sleep can put it to sleep, and lr_body_state.sleep_state shows that it is held.
   * Takes effect at the next step; bodies already held stay held. Part of snapshots and of the world's hash.
   * LR_DIVERGENCE_REMOVE allocates as lr_batch_set_rules does.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_set_divergence_policy(world: number, batch: number, policy: number): number;
  /**
   * Reads how a batch treats diverged bodies.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH.
   */
  lr_batch_get_divergence_policy(world: number, batch: number, policy: number): number;
  lr_emitter_desc_init(desc: number, struct_size: number): number;
  /**
   * Sets the emitter of a batch. Bodies spawn at the end of each step, after rules have ended others, up to the batch's
   * capacity; spawns beyond it are dropped, not postponed. New bodies take the world's next noise seeds, and 0 as `user`.
   * The struct is copied; null removes the emitter. A replacement keeps the pending fraction of a spawn and the time since
   * the last burst. Part of snapshots. Allocates as lr_batch_set_rules does.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT (also null while the rules respawn), LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_set_emitter(world: number, batch: number, desc: number): number;
  /**
   * Reads the emitter of a batch.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
   */
  lr_batch_get_emitter(world: number, batch: number, desc: number, present: number): number;
  /**
   * Spawns `count` bodies now, all or none.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT (no emitter),
   * LR_ERROR_CAPACITY.
   */
  lr_batch_spawn(world: number, batch: number, count: number, out_ids: number): number;
  /**
   * Spawns `count` bodies in a box now, all or none, without an emitter: awake, evenly distributed, each orientation
   * equally likely, at rest, scale 1, age 0, with the world's next noise seeds. Random values depend only on the world's
   * seed and the body's noise seed, as with an LR_EMIT_BOX emitter. Causes LR_EVENT_SPAWNED. Allocates nothing, and so
   * counts in lr_batch_counts only while the batch has rules or an emitter.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY.
   */
  lr_batch_spawn_box(world: number, batch: number, low: number, high: number, count: number, out_ids: number): number;
  lr_batch_counts_init(counts: number, struct_size: number): number;
  /**
   * Reads the counts of a batch. A batch that never had rules or an emitter counts only diverged bodies. Totals
   * are part of snapshots; after a restore the counts of the last step are 0.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
   */
  lr_batch_get_counts(world: number, batch: number, counts: number): number;
  /** Sets the axes to the body's, `length`, `wake_length` and `wake_lag` to 1 and everything else to 0: no loads. */
  lr_aerodynamics_init(aerodynamics: number, struct_size: number): number;
  /**
   * Reads an asset's baked coefficients.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
   */
  lr_asset_get_aerodynamics(asset: number, aerodynamics: number): number;
  /**
   * Replaces the asset's coefficients of AERODYNAMIC loads for a batch from the next step on. The struct is copied; null
   * restores the asset's. With intensity 0, lr_load_gains.turbulence 1 and lr_batch_desc.variation 0 a fall is the same
   * for any seed. Axes other than the body's, or a center other than 0, put an LR_ASSET_DIAGONAL body on the slower path
   * of contact.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_set_aerodynamics(world: number, batch: number, aerodynamics: number): number;
  /**
   * Reads a batch's current coefficients.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
   */
  lr_batch_get_aerodynamics(world: number, batch: number, aerodynamics: number): number;
  lr_rigid_desc_init(desc: number, struct_size: number): number;
  /**
   * Creates an asset from given numbers.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also for
   * matrices that no body can have), LR_ERROR_OUT_OF_MEMORY.
   */
  lr_asset_create_rigid(desc: number, out: number): number;
  lr_turbulence_table_init(table: number, struct_size: number): number;
  /**
   * Replaces the turbulence table of a batch; null restores the asset's. With AERODYNAMIC loads the table replaces the
   * intensity of lr_aerodynamics: it sets the velocity of the fluid around the body.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_set_turbulence_table(world: number, batch: number, table: number): number;
  /**
   * Reads a batch's turbulence table: the one that was set, bit for bit, or the asset's, rounded to float.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world, table), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_BUFFER_TOO_SMALL
   * (table is set, chi and epsilon are not).
   */
  lr_batch_get_turbulence_table(world: number, batch: number, table: number, chi: number, epsilon: number, capacity: number): number;
  lr_body_loads_init(loads: number, struct_size: number): number;
  /**
   * Computes the loads on a body from its present state, wind and water; on a sleeping body as if its wake had ended. At the
   * surface of water those of the fluid that its centre of mass is in; the fluid's own rotation is left out.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE.
   */
  lr_body_get_loads(world: number, body: bigint, loads: number): number;
}
