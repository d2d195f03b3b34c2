// Made by bindings/generator/javascript.py from include/langevin_rigid.h: changes here are lost.
// SPDX-License-Identifier: MIT

import type { Asset } from '../../langevin_rigid.mjs';

/** Constants of the C header, without LR_. */
export declare const LR: {
  readonly OK: 0;
  /** a pointer that must be given is null */
  readonly ERROR_NULL_ARGUMENT: -1;
  /** struct_size is smaller than any released size, or an unknown tail is not zero */
  readonly ERROR_STRUCT_SIZE: -2;
  /** a value is out of its range */
  readonly ERROR_INVALID_ARGUMENT: -3;
  /** a number is NaN or infinite */
  readonly ERROR_NOT_FINITE: -4;
  /** the allocator returned null */
  readonly ERROR_OUT_OF_MEMORY: -5;
  /** the body was destroyed, or never was */
  readonly ERROR_STALE_BODY: -6;
  /** the batch was destroyed, or never was */
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
  /** undamaged, but its numbers cannot be those of a body */
  readonly ERROR_ASSET_INVALID: -15;
  /** not a snapshot, damaged, or of another version */
  readonly ERROR_SNAPSHOT_FORMAT: -16;
  /** a snapshot of a world with other batches or assets */
  readonly ERROR_SNAPSHOT_MISMATCH: -17;
  /** not available on this processor or in this build */
  readonly ERROR_UNSUPPORTED: -18;
  /** the worker threads could not be started */
  readonly ERROR_THREADS: -19;
  /** dt is 0 */
  readonly ERROR_TIMESTEP_ZERO: -20;
  /** dt is negative */
  readonly ERROR_TIMESTEP_NEGATIVE: -21;
  /** dt is NaN or infinite */
  readonly ERROR_TIMESTEP_NOT_FINITE: -22;
  /** dt / substeps is over LR_MAX_SUBSTEP */
  readonly ERROR_TIMESTEP_TOO_LARGE: -23;
  /** substeps is 0 or over LR_MAX_SUBSTEPS */
  readonly ERROR_SUBSTEPS: -24;
  /** a defect of the library: please report */
  readonly ERROR_INTERNAL: -25;
  /** the wind source was removed, or never was */
  readonly ERROR_STALE_WIND_SOURCE: -26;
  /** the collider was destroyed, or never was */
  readonly ERROR_STALE_COLLIDER: -27;
  /** another thread is inside a call on the world: LR_CHECK_THREADS */
  readonly ERROR_CONCURRENT_USE: -28;
  /** this thread is, and the call comes from a callback: LR_CHECK_THREADS */
  readonly ERROR_REENTRANT: -29;
  /** s: the longest dt / substeps that is taken */
  readonly MAX_SUBSTEP: 1;
  /** the most substeps in one step */
  readonly MAX_SUBSTEPS: 65536;
  /** a call failed: the message says which, and why */
  readonly LOG_ERROR: 1;
  /** a call succeeded, but probably not as meant */
  readonly LOG_WARNING: 2;
  readonly LOG_INFO: 3;
  readonly SIMD_AUTO: 0;
  /** with SSE4.2, AES and PCLMUL: the least that an x86-64 processor must have */
  readonly SIMD_SSE4: 1;
  readonly SIMD_AVX2: 2;
  readonly SIMD_AVX512: 3;
  readonly SIMD_NEON: 4;
  readonly SIMD_WASM: 5;
  /** plain C++, in builds for tests alone */
  readonly SIMD_PLAIN: 6;
  /** diagonal in body axes, buoyancy at the centre of mass: the fast path applies */
  readonly ASSET_DIAGONAL: 1;
  readonly CHECK_THREADS: 1;
  readonly WIND_NONE: 0;
  /** the same velocity everywhere */
  readonly WIND_UNIFORM: 1;
  /** fluctuations of the uniform wind in time */
  readonly WIND_SOURCE_GUSTS: 1;
  /** a straight vortex with a core that turns as a solid */
  readonly WIND_SOURCE_RANKINE: 2;
  /** a straight vortex with a smooth core */
  readonly WIND_SOURCE_LAMB_OSEEN: 3;
  /** a round jet */
  readonly WIND_SOURCE_POINT_BLOWER: 4;
  /** a plane jet from a slot */
  readonly WIND_SOURCE_LINE_BLOWER: 5;
  /** random, without divergence, everywhere; carried along by the uniform wind */
  readonly WIND_SOURCE_TURBULENCE: 6;
  /** samples on a lattice, in one or more frames */
  readonly WIND_SOURCE_GRID: 7;
  /** a factor of the uniform wind and the gusts: logarithmic over a plane */
  readonly WIND_SOURCE_GROUND: 8;
  /** a grid adds nothing outside its samples */
  readonly WIND_OUTSIDE_ZERO: 0;
  /** it goes on as at its border */
  readonly WIND_OUTSIDE_CLAMP: 1;
  /** it repeats itself; the first sample follows the last */
  readonly WIND_OUTSIDE_REPEAT: 2;
  readonly MAX_WIND_SOURCES: 64;
  /** of a grid, all frames together */
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
  /** turbulence scales with the body's present speed through the fluid */
  readonly CLOCK_SPEED: 0;
  /** the paper: turbulence follows the table at the body's age */
  readonly CLOCK_AGE: 1;
  /** LR_CLOCK_AGE: hold the last sample after the end of the table */
  readonly TABLE_CLAMP: 0;
  /** LR_CLOCK_AGE: begin again */
  readonly TABLE_LOOP: 1;
  /** LR_INTEGRATOR_SPLITTING in this version */
  readonly INTEGRATOR_DEFAULT: 0;
  /** the paper's: fourth order, unstable at long steps, slow. In water: splitting */
  readonly INTEGRATOR_RK4: 1;
  /** second order and stable at any step; docs/maintainers/numerics.md */
  readonly INTEGRATOR_SPLITTING: 2;
  /** 7 floats: position, quaternion x y z w */
  readonly TRANSFORM_POSITION_QUATERNION: 0;
  /** 8 floats: the same and the scale */
  readonly TRANSFORM_POSITION_QUATERNION_SCALE: 1;
  /** 12 floats: three rows of rotation times scale and translation */
  readonly TRANSFORM_3X4_ROW_MAJOR: 2;
  /** 12 floats: four columns of three */
  readonly TRANSFORM_3X4_COLUMN_MAJOR: 3;
  /** 16 floats; column vectors, translation in elements 3, 7, 11 */
  readonly TRANSFORM_4X4_ROW_MAJOR: 4;
  /** 16 floats; column vectors, translation in elements 12, 13, 14 */
  readonly TRANSFORM_4X4_COLUMN_MAJOR: 5;
  readonly REST_AWAKE: 0;
  readonly REST_RESTING: 1;
  /** read only: it has left physics, and lr_batch_set_fault_policy holds it where it was */
  readonly REST_HELD: 2;
  /** N, N m */
  readonly FORCE_MODE_FORCE: 0;
  /** m/s^2, rad/s^2 */
  readonly FORCE_MODE_ACCELERATION: 1;
  /** N s, N m s */
  readonly FORCE_MODE_IMPULSE: 2;
  /** m/s, rad/s: added to the body's */
  readonly FORCE_MODE_VELOCITY: 3;
  readonly FRAME_WORLD: 0;
  /** turns with the body */
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
  /** given for one hull */
  readonly MAX_HULL_VERTICES: 256;
  /** of one mesh; and triangles of one, and heights of one heightfield */
  readonly MAX_COLLIDER_VERTICES: 67108864;
  /** over the next step it goes from where it is to this pose, and stands still afterwards */
  readonly MOVE_TO: 1;
  /** it is there at once, and has these velocities from now on */
  readonly MOVE_PLACE: 2;
  /** it stays where it is, and has these velocities from now on */
  readonly MOVE_VELOCITY: 3;
  /** bodies move until they are put to rest by lr_body_set_rest */
  readonly CONTACT_NEVER_REST: 1;
  /** a body touches a collider that it did not touch at the end of the step before */
  readonly CONTACT_BEGIN: 1;
  /** it no longer does, or the collider has been destroyed, whose id is then stale */
  readonly CONTACT_END: 2;
  /** it has come to rest by itself */
  readonly BODY_LANDED: 3;
  /** it has left rest since the step before, whatever for */
  readonly BODY_WOKE: 4;
  /** its batch's rules have ended it; with LR_END_RESPAWN it goes on with the same id */
  readonly BODY_KILLED: 5;
  /** it has left physics: lr_batch_set_fault_policy */
  readonly BODY_FAULTED: 6;
  readonly EVENTS_BEGIN: 1;
  readonly EVENTS_END: 2;
  readonly EVENTS_LANDED: 4;
  readonly EVENTS_WOKE: 8;
  readonly EVENTS_KILLED: 16;
  readonly EVENTS_FAULTED: 32;
  readonly EVENTS_ALL: 63;
  readonly RAY_BODIES: 1;
  readonly RAY_COLLIDERS: 2;
  /** size[0]: radius */
  readonly OVERLAP_SPHERE: 1;
  /** size: half extents along its own axes */
  readonly OVERLAP_BOX: 2;
  /** the body is destroyed, its id stale */
  readonly END_DESTROY: 0;
  /** the body begins anew where the batch's emitter says, at age 0, with the same id and key */
  readonly END_RESPAWN: 1;
  /** inside: behind the plane through `center`, away from its normal `size` */
  readonly VOLUME_PLANE: 0;
  /** axis-aligned; size: half extents */
  readonly VOLUME_BOX: 1;
  /** size[0]: radius */
  readonly VOLUME_SPHERE: 2;
  readonly KILL_INSIDE: 0;
  readonly KILL_OUTSIDE: 1;
  readonly MAX_KILL_VOLUMES: 8;
  /** as LR_FAULT_REMOVE in a batch with rules, as LR_FAULT_FREEZE in others */
  readonly FAULT_AUTO: 0;
  /** it is held where it last was sane */
  readonly FAULT_FREEZE: 1;
  /** it ends: respawns where the batch's rules do that, else is destroyed */
  readonly FAULT_REMOVE: 2;
  readonly EMIT_POINT: 0;
  /** the first three fill their shape evenly */
  readonly EMIT_BOX: 1;
  readonly EMIT_SPHERE: 2;
  /** in the plane of the shape's own x and y */
  readonly EMIT_DISC: 3;
  /** evenly */
  readonly EMIT_BOX_SURFACE: 4;
  /** evenly if its three sizes are equal */
  readonly EMIT_SPHERE_SURFACE: 5;
  /** every orientation alike */
  readonly POSE_RANDOM: 0;
  /** body_orientation */
  readonly POSE_FIXED: 1;
};

/**
 * Where a world takes its memory from. Both functions are given or neither; neither means the C library's.
 * `allocate` returns `size` bytes aligned to `alignment` (a power of two, at most 128), or null.
 * `release` gets the very size and alignment that were asked for. Called only from the thread that calls the library,
 * during lr_world_step only where bodies meet each other (lr_batch_set_pair_contact) in greater number than ever before.
 * Must not call the library on the same world.
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
 * A solid ellipsoid, with everything from closed forms: mass, Lamb's added mass, and the decay of k and epsilon in a
 * uniform stream. The quickest way to a first falling body.
 */
export interface EllipsoidDesc {
  /** 3 elements. m, each 1e-6 to 1e3, along body x, y, z */
  semiAxes: number[];
  /** kg/m^3 of the body, > 0 */
  density: number;
  /** kg/m^3, > 0; initially 1.2, air */
  fluidDensity: number;
  /** m^2/s, kinematic, > 0; initially 1.5e-5, air */
  fluidViscosity: number;
  /** turbulence intensity I of k0 = 3/2 (I U0)^2, 0 to 10; initially 1, as in the paper */
  intensity: number;
  /** 3 elements. m, from the centre of the ellipsoid, inside it; initially 0. A ballasted body: its centre of buoyancy stays at the centre, its moments of inertia those of the uniform solid */
  centerOfMass: number[];
}

/**
 * Coefficients of the quasi-steady loads at scale 1; equations in docs/maintainers/physics.md, AERODYNAMIC. Everything acts at
 * `center` along `axes`, which turn with the body. Arrays have a value for each axis. v: velocity through the fluid and w:
 * spin, both along the axes; s = |v|; (i, j, k) cyclic; d: lr_asset_info.length_d; rho, nu: density and kinematic viscosity of
 * the fluid.
 */
export interface Aerodynamics {
  /** 9 elements. rows: unit vectors in the body frame, right-handed */
  axes: number[];
  /** 3 elements. m^2, drag coefficient times area */
  drag: number[];
  /** 3 elements. m^2, the part that grows with the Reynolds number: of rounded bodies */
  dragBlunt: number[];
  /** 3 elements. m^(3/2), of the boundary layer */
  dragLayer: number[];
  /** 3 elements. m, of creeping flow */
  dragStokes: number[];
  /** 3 elements. m^2, positive where the body is thinner along j than along i */
  lift: number[];
  /** 3 elements. m^3 */
  spinLift: number[];
  /** 3 elements. m^3, moment rho lift_moment_k v_i v_j of that lift about k */
  liftMoment: number[];
  /** 3 elements. m^5 */
  spinDrag: number[];
  /** 3 elements. m^4 */
  spinDragStream: number[];
  /** 3 elements. m^3 */
  spinDragStokes: number[];
  /** of the velocity of the fluid in the body's own wake: per axis `intensity` times s. More than 0.4, gains included, acts as 0.4: such a wake would feed itself */
  intensity: number;
  /** m, correlated over length/s */
  length: number;
  /** that velocity is less by Re/(Re + wake_reynolds): slow wakes are laminar */
  wakeReynolds: number;
  /** 3 elements. 0 to 1 */
  broadside: number[];
  liftStall: number;
  /** 3 elements. m^3 */
  liftMomentStalled: number[];
  /** 3 elements. m^4 */
  rollDamping: number[];
  /** 3 elements. m, where all of it acts, from the centre of buoyancy, body frame; initially 0; within 2 d */
  center: number[];
}

/**
 * A body whose numbers are known, without mesh or file: from another solver, from measurements, or a section of a card in
 * two dimensions. Matrices are row-major, symmetric, about the centre of mass, in body axes.
 */
export interface RigidDesc {
  /** kg, > 0 */
  mass: number;
  /** m^3, > 0 */
  volume: number;
  /** 9 elements. kg m^2, positive definite */
  inertia: number[];
  /** 36 elements. order vx vy vz wx wy wz, fluid density included as in lr_asset_info: kg, kg m, kg m^2; positive semi-definite; initially 0 */
  addedMass: number[];
  /** 3 elements. m, from the centre of mass; initially 0 */
  centerOfBuoyancy: number[];
  /** kg/m^3, > 0; initially 1.2, air */
  fluidDensity: number;
  /** m^2/s, kinematic, > 0; initially 1.5e-5, air */
  fluidViscosity: number;
  /** 3 elements. m, full size along the body axes, > 0 */
  extents: number[];
  /** of the turbulence table, as in lr_ellipsoid_desc; initially 1 */
  intensity: number;
  /** copied; null, as initially: those of an ellipsoid with these extents */
  aerodynamics: Aerodynamics;
}

/** What an asset is. Matrices are row-major and symmetric. */
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
  /** 3 elements. m, in the frame of the mesh: where the body origin lies in it */
  centerOfMass: number[];
  /** 3 elements. m, from the centre of mass, body axes */
  centerOfBuoyancy: number[];
  /** 9 elements. kg m^2, about the centre of mass, body axes */
  inertia: number[];
  /** 36 elements. about the centre of mass, order vx vy vz wx wy wz, fluid density included: kg for the 3x3 block of v, kg m for the coupling, kg m^2 for the block of w */
  addedMass: number[];
  /** kg/m^3, of the fluid it was baked in */
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
  /** 0 for an asset without a hull */
  hullVertexCount: number;
  hullTriangleCount: number;
  /** of the file; 0 for an asset without a file */
  formatVersion: number;
  /** of everything that matters for motion; equal for equal assets */
  contentHash: bigint;
}

export interface WorldDesc {
  /** threads besides the caller's, 0 to 64; initially 0: everything runs in the caller. With `jobs`: the most indices in one enqueue, as many as its threads but the caller's; 0: one less than this machine has threads, from 1 to 64, and a warning that it is a guess */
  workerCount: number;
  /** of all noise; initially 0 */
  seed: bigint;
  /** 3 elements. m/s^2; initially 0, -9.81, 0 */
  gravity: number[];
  /** kg/m^3, >= 0; initially 0: each batch in the fluid its asset was baked in */
  fluidDensity: number;
  /** LR_SIMD_*; initially LR_SIMD_AUTO */
  simdTarget: number;
  /** m^2/s, kinematic, >= 0; initially 0: as each batch's asset was baked */
  fluidViscosity: number;
  /** copied; initially null functions: the C library's */
  allocator: Allocator;
  /** initially null: silence */
  log: number;
  logUser: number;
  /** copied; initially null functions: worker_count threads of the world's own */
  jobs: JobSystem;
  /** bits LR_CHECK_*; initially 0 */
  checks: number;
}

export interface WorldInfo {
  /** what LR_SIMD_AUTO became */
  simdTarget: number;
  /** as in the desc; with jobs what 0 became */
  workerCount: number;
  batchCount: number;
  bodyCount: number;
  /** substeps since creation; the time index of the noise */
  substepCount: number;
  /** s since creation: the sum of all dt, in double */
  time: number;
  /** taken from the allocator at present */
  memoryBytes: number;
  colliderCount: number;
  /** bodies that are not at rest: lr_body_set_rest */
  awakeCount: number;
}

export interface WindDesc {
  /** LR_WIND_*; initially LR_WIND_UNIFORM */
  kind: number;
  /** 3 elements. m/s, each up to 1000 in magnitude; initially 0 */
  velocity: number[];
}

/** Fields that a kind does not have are not used, but must be in range. Lengths up to 1e6 m, speeds up to 1000 m/s. */
export interface WindSourceDesc {
  /** LR_WIND_SOURCE_*; initially 0, which is none of them */
  kind: number;
  /** 3 elements. m: a point of the vortex axis (its middle, if half_length > 0), the nozzle's middle, the grid's first sample, a point of the ground; initially 0 */
  position: number[];
  /** 3 elements. any length but 0: the vortex axis (right-hand rule), where a blower blows, about where gusts blow, the ground's upward normal; initially 1, 0, 0 */
  direction: number[];
  /** 3 elements. along the slot of a line blower, not along its direction; initially 0, 0, 1 */
  side: number[];
  /** 3 elements. m/s, of the source itself; initially 0 */
  velocity: number[];
  /** m/s: of a blower at its nozzle; root mean square of gusts in all, of turbulence for each component; >= 0; initially 1 */
  speed: number;
  /** m^2/s, up to 1e6 in magnitude; initially 1 */
  circulation: number;
  /** m, >= 1e-4: core radius, radius of the nozzle or half width of the slot, integral length of turbulence, roughness length of the ground (0.0001 water, 0.03 grass, 1 town); initially 1 */
  size: number;
  /** m: a vortex fades out from half of it on, to nothing at it; 0: no limit; initially 0 */
  radius: number;
  /** m: of a vortex, which fades likewise, 0 for no limit; of a slot; initially 0 */
  halfLength: number;
  /** m, >= size: a blower fades out from half of it on, to nothing at it; initially 10 */
  range: number;
  /** 0 to 1: widening of a jet per length, 0.11 as measured; gusts: root mean square angle in radians from `direction`; initially 0.1 */
  spread: number;
  /** s: integral time of gusts, 0 for 4, as 2 m over the ground in 3 m/s (IEC 61400-1: 5.67 times the height over the speed); life of the largest eddies, 0 for size/speed; time from one frame to the next, 0 for 1; up to 1e6; initially 0 */
  period: number;
  /** m: where the ground's factor is 1; >= size; initially 10 */
  referenceHeight: number;
  /** of turbulence, each half as large as the one before, 1 to 4; initially 2 */
  octaves: number;
  /** of gusts and turbulence, together with the world's; initially 0 */
  seed: number;
  /** LR_WIND_OUTSIDE_*; initially LR_WIND_OUTSIDE_ZERO */
  outside: number;
  /** 3 elements. samples of a grid along x, y, z, each >= 1 */
  counts: number[];
  /** of a grid, shown one after the other and again from the first; >= 1; initially 1 */
  frames: number;
  /** 3 elements. m between samples, >= 1e-4; initially 1 */
  spacing: number[];
  /** m/s, x y z of each sample; x varies fastest, then y, z, frame; copied */
  samples: Float32Array;
}

/** What a wind callback is asked. Arrays have one value a body. */
export interface WindQuery {
  /** bodies, 1 to 256 */
  count: number;
  /** whose bodies they are; 0 when asked by lr_world_sample_wind */
  batch: number;
  /** s, of the middle of the substep */
  time: number;
  /** 3 elements. m: where the bodies are expected to be at that time; finite */
  position: Float32Array[];
  /** 3 elements. m/s, 0 at first: the velocity that is added to the other sources' */
  velocity: Float32Array[];
  /** 3 elements. m/s^2, 0 at first: its partial derivative in time, if it is known */
  rate: Float32Array[];
  /** 9 elements. 1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate and gradient the callback's part gives drag, but neither the force of the fluid's acceleration nor shear */
  gradient: Float32Array[];
}

/**
 * A long-crested wave of deep water. Heights add; its frequency sqrt(2 pi g/length) is that of the world's gravity when
 * the surface is set.
 */
export interface Wave {
  /** 3 elements. where it goes: any vector not along the normal; its part in the plane counts */
  direction: number[];
  /** m, crest to crest, 1e-3 to 1e6 */
  length: number;
  /** m, half of crest to trough, 0 to length/7: steeper ones break */
  amplitude: number;
  /** rad, up to 1e6 in magnitude: 0 has a crest at `position` at the world's time 0 */
  phase: number;
}

/**
 * The lower fluid fills everything below a plane, or below the waves on it. Above is the fluid of the world or of each
 * batch's asset. Bodies float, sink, and go through; surface tension is ignored.
 */
export interface SurfaceDesc {
  /** used part of `waves`; initially 0 */
  waveCount: number;
  /** 3 elements. m, a point of the plane, each up to 1e9 in magnitude; initially 0 */
  position: number[];
  /** 3 elements. upward, any length but 0; initially 0, 1, 0 */
  normal: number[];
  /** kg/m^3, 1e-3 to 1e6; initially 998. A batch whose own fluid is denser keeps that one's */
  density: number;
  /** m^2/s, kinematic, 1e-12 to 1e3; initially 1e-6 */
  viscosity: number;
  /** 3 elements. m/s, velocity of the lower fluid, each up to 1000 in magnitude; initially 0 */
  current: number[];
  /** m, 0 to 1e6: a callback's surface lies at most so far from the plane; initially 0 */
  reach: number;
  /** 8 elements. */
  waves: Wave[];
}

/** What a surface callback is asked. Arrays have one value a body, and hold what plane and waves give at first. */
export interface SurfaceQuery {
  /** bodies, 1 to 256 */
  count: number;
  /** whose bodies they are */
  batch: number;
  /** s */
  time: number;
  /** 3 elements. m; finite */
  position: Float32Array[];
  /** m above the plane of the surface there, along the plane's normal */
  height: Float32Array;
  /** 3 elements. unit, of the surface, less than 80 degrees from the plane's */
  normal: Float32Array[];
  /** 3 elements. m/s, of the lower fluid at the position */
  velocity: Float32Array[];
  /** 3 elements. m/s^2, its acceleration. Where the surface is steep it is what lets bodies slide down */
  rate: Float32Array[];
}

/** What the last step did, and what it left out. Batches without bodies do not count. */
export interface StepReport {
  batchesStepped: number;
  /** not due, by their own divisors */
  batchesWaiting: number;
  /** due, but the budget did not reach them */
  batchesPassedOver: number;
  /** done */
  bodySubsteps: number;
  /** of the batches that were due, without a budget */
  bodySubstepsWanted: number;
  /** s: how far the bodies that have waited longest are behind the world's time */
  behind: number;
  /** s: the most that a batch lost in this step: bodies go in slow motion rather than in too long substeps */
  lost: number;
}

export interface RecordingDesc {
  /** bits LR_RECORD_*; initially LR_RECORD_CALLBACKS */
  flags: number;
  /** steps from one hash of the world in the recording to the next; 0: none; initially 1 */
  hashInterval: number;
  /** must be given */
  write: number;
  user: number;
}

export interface BatchDesc {
  /** the most bodies at a time, 1 to 2^26; memory for all is taken at once */
  capacity: number;
  /** kept by reference until the batch ends */
  asset: Asset;
  /** LR_LOADS_*; initially LR_LOADS_DEFAULT */
  loadModel: number;
  /** LR_CLOCK_*; initially LR_CLOCK_SPEED */
  clock: number;
  /** LR_TABLE_*; initially LR_TABLE_CLAMP */
  tableEnd: number;
  /** LR_INTEGRATOR_*; initially LR_INTEGRATOR_DEFAULT */
  integrator: number;
  /** multiplies the turbulent damping, 0 to 100; initially 1 */
  dampingGain: number;
  /** multiplies the turbulent noise, 0 to 100; initially 1; 0 for repeatable single falls */
  noiseGain: number;
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
  /** m/s, speed the table was made at, > 0: what LR_CLOCK_SPEED scales by */
  u0: number;
  /** m, length the table was made with, > 0 */
  l: number;
  /** Kolmogorov constant, > 0; initially 6.5, its limit at high Reynolds number */
  c0: number;
  /** sample that LR_CLOCK_SPEED uses, < count; initially 0 */
  stationary: number;
}

/** Art control of the AERODYNAMIC loads: factors on top of the coefficients, so that motion stays that of some body. */
export interface LoadGains {
  /** of translation, 0 to 100; initially 1 */
  drag: number;
  /** and its moment, 0 to 100; initially 1 */
  lift: number;
  /** 0 to 100; initially 1 */
  spinDrag: number;
  /** intensity of the body's own wake, 0 to 100; initially 1 */
  turbulence: number;
}

/** How a batch keeps up with its world. */
export interface BatchPace {
  /** as set */
  divisor: number;
  /** in the last step of the world; 0: it waited */
  substeps: number;
  /** steps since it was last stepped */
  waited: number;
  /** s: the same as time */
  behind: number;
  /** s, in all: what its bodies' clocks are slow by */
  lost: number;
  /** in all */
  bodySubsteps: number;
}

/**
 * The state of a batch where it lies: arrays with one value a body, `count` of them, 64-byte aligned. Bodies are dense:
 * those that move come first, then those at rest, and where one leaves its part of them, the last of that part takes its
 * place. Pointers are valid until the next call that is not a query.
 */
export interface BatchView {
  /** bodies */
  count: number;
  /** 3 elements. m, world frame: x, y, z */
  position: Float32Array[];
  /** 4 elements. unit quaternion x, y, z, w, body to world */
  orientation: Float32Array[];
  /** 3 elements. m/s, of the centre of mass, in the BODY frame: turn by the orientation for the world's */
  velocity: Float32Array[];
  /** 3 elements. rad/s, angular velocity, in the BODY frame */
  spin: Float32Array[];
  /** uniform scale */
  scale: Float32Array;
  /** s; of a body at rest some earlier one: lr_body_get_state has it exactly */
  age: Float32Array;
  /** what tells the noise of bodies apart */
  key: Uint32Array;
  ids: BigUint64Array;
  capacity: number;
  /** differs whenever bodies at rest have woken, ended, or changed their places */
  revision: number;
  /** bodies [0, awake_count) move, [awake_count, count) are at rest: lr_body_set_rest */
  awakeCount: number;
}

export interface BodyDesc {
  /** tells its noise apart; initially 0: the world gives each body its own, in order of birth */
  key: number;
  /** 3 elements. m, of the centre of mass; initially 0 */
  position: number[];
  /** 4 elements. quaternion x y z w, normalised when taken; initially 0 0 0 1 */
  orientation: number[];
  /** 3 elements. m/s, of the centre of mass; initially 0 */
  linearVelocity: number[];
  /** 3 elements. rad/s, world frame; initially 0 */
  angularVelocity: number[];
  /** uniform, 0.001 to 1000; mass goes with its cube; initially 1 */
  scale: number;
  /** s, 0 to 1e9; initially 0. Bodies grow no older than that */
  age: number;
}

export interface BodyState {
  /** read only: ignored by lr_body_set_state */
  key: number;
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
  /** LR_REST_*; read only */
  resting: number;
}

/** A force and a torque on one body, at the body's true size: a body of scale 2 has eight times the mass. */
export interface BodyForce {
  /** LR_FORCE_MODE_*; initially LR_FORCE_MODE_FORCE */
  mode: number;
  body: bigint;
  /** LR_FRAME_*, of force, torque and point; initially LR_FRAME_WORLD */
  frame: number;
  /** LR_FORCE_*; initially 0 */
  flags: number;
  /** 3 elements. initially 0 */
  force: number[];
  /** 3 elements. about the centre of mass; initially 0 */
  torque: number[];
  /** 3 elements. m; in the world frame a position, in the body frame from the centre of mass. Its arm is taken at the time of the call */
  point: number[];
}

/** The same for many bodies of one batch, in the order of its view. */
export interface ForceArrays {
  /** LR_FORCE_MODE_*; initially LR_FORCE_MODE_FORCE */
  mode: number;
  /** LR_FRAME_*; initially LR_FRAME_WORLD */
  frame: number;
  /** index in the view of the first body; initially 0 */
  first: number;
  /** bodies */
  count: number;
  /** bytes from one body's value to the next's, a multiple of 4; initially 0: no gaps, 4 */
  stride: number;
  /** 3 elements. x, y, z: `count` values each, not kept; all three or none */
  force: Float32Array[];
  /** 3 elements. alike; all three or none */
  torque: Float32Array[];
}

/** What acts on every body of a batch. All initially 0, each component up to 1e9 in magnitude. */
export interface BatchForce {
  /** 3 elements. N, world frame */
  force: number[];
  /** 3 elements. N m, world frame */
  torque: number[];
  /** 3 elements. m/s^2, world frame; of the body, whatever its mass */
  acceleration: number[];
  /** 3 elements. rad/s^2, world frame */
  angularAcceleration: number[];
  /** 3 elements. the same four in the body frame */
  bodyForce: number[];
  /** 3 elements. */
  bodyTorque: number[];
  /** 3 elements. */
  bodyAcceleration: number[];
  /** 3 elements. */
  bodyAngularAcceleration: number[];
}

/** Fields that a kind does not have are not used. */
export interface ColliderDesc {
  /** LR_COLLIDER_*; initially 0, which is none of them */
  kind: number;
  /** 3 elements. m, up to 1e9 in magnitude; initially 0 */
  position: number[];
  /** 4 elements. quaternion x y z w, normalised when taken; initially 0 0 0 1 */
  orientation: number[];
  /** 3 elements. m/s, of the frame's origin, up to 1e6; initially 0. It moves so until told otherwise */
  linearVelocity: number[];
  /** 3 elements. rad/s, world frame, up to 1e6; initially 0 */
  angularVelocity: number[];
  /** 3 elements. m, > 0, up to 1e6; initially 0 */
  size: number[];
  /** 0 to 10; initially 0.5 */
  friction: number;
  /** 0 to 1; initially 0.2 */
  restitution: number;
  /** bits: it meets bodies that have one of them; initially 1 */
  layers: number;
  /** 0 */
  flags: number;
  /** hull: 4 to LR_MAX_HULL_VERTICES; mesh: 3 to LR_MAX_COLLIDER_VERTICES */
  vertexCount: number;
  /** mesh: 1 to LR_MAX_COLLIDER_VERTICES */
  triangleCount: number;
  /** 2 elements. heightfield: samples along x and z, each >= 2 */
  counts: number[];
  /** 2 elements. heightfield: m between samples, 1e-6 to 1e6; initially 1 */
  spacing: number[];
  /** m, x y z each, up to 1e6 in magnitude; copied, as are the others */
  vertices: Float32Array;
  /** 3 a triangle, each < vertex_count */
  indices: Uint32Array;
  /** m, up to 1e6 in magnitude; x varies fastest */
  heights: Float32Array;
}

/**
 * How one collider moves. Within a step its position goes evenly from where it begins to where it ends, and its
 * orientation by the normalised linear quaternion, the shorter way round: what turns by more than half a turn in a step
 * seems to turn by less.
 */
export interface ColliderMotion {
  /** LR_MOVE_*; initially LR_MOVE_TO */
  mode: number;
  collider: bigint;
  /** 3 elements. m, as in lr_collider_desc; LR_MOVE_TO, LR_MOVE_PLACE; initially 0 */
  position: number[];
  /** 4 elements. alike; initially 0 0 0 1 */
  orientation: number[];
  /** 3 elements. m/s; LR_MOVE_PLACE, LR_MOVE_VELOCITY; initially 0 */
  linearVelocity: number[];
  /** 3 elements. rad/s; alike */
  angularVelocity: number[];
}

export interface ColliderState {
  /** LR_COLLIDER_* */
  kind: number;
  /** 3 elements. m, world frame */
  position: number[];
  /** 4 elements. unit quaternion x y z w, collider to world */
  orientation: number[];
  /** 3 elements. m/s, that it has until told otherwise; 0 while LR_MOVE_TO is pending */
  linearVelocity: number[];
  /** 3 elements. rad/s, world frame; alike */
  angularVelocity: number[];
  friction: number;
  restitution: number;
  layers: number;
  /** 0 */
  flags: number;
}

/** What can be changed of a collider besides its motion. */
export interface ColliderSurface {
  /** as in lr_collider_desc; initially 1 */
  layers: number;
  /** initially 0.5 */
  friction: number;
  /** initially 0.2 */
  restitution: number;
}

/**
 * How the bodies of a batch meet colliders. Of a pair, friction is the geometric mean of both and restitution the larger.
 * Bodies touch with their hull, reduced to 32 points at most, or as the ellipsoid that they are.
 */
export interface BatchContact {
  /** bit mask: colliders that are in one of these are met; initially all; 0: none */
  layers: number;
  /** coefficient of Coulomb friction, 0 to 10; initially 0.5 */
  friction: number;
  /** speed after over speed before an impact, 0 to 1; initially 0.1 */
  restitution: number;
  /** moment against rolling and spinning over normal force and a lever, 0 to 10; initially 0.05. The lever is the geometric mean of reach and half of the least width: a sphere's radius */
  rollingResistance: number;
  /** LR_CONTACT_*; initially 0 */
  flags: number;
  /** the air that a sheet must press away before it lies, 0 to 1 of what the flow over planes and heightfields gives in theory; initially 0. docs/maintainers/contact.md */
  groundEffect: number;
}

/** Never changes: 64 bytes, an element of arrays without gaps. */
export interface ContactEvent {
  /** LR_CONTACT_*, LR_BODY_* */
  kind: number;
  batch: number;
  /** stale where it has been destroyed */
  body: bigint;
  /** LR_CONTACT_*; else 0 */
  collider: bigint;
  /** 3 elements. m, world frame: of LR_CONTACT_BEGIN where they touch, else of the centre of mass; of one that has left physics where that was last sane */
  position: number[];
  /** 3 elements. LR_CONTACT_BEGIN: unit, world frame, from the collider to the body; else 0 */
  normal: number[];
  /** m/s, LR_CONTACT_BEGIN: at which they approach each other along the normal, >= 0; else 0 */
  speed: number;
  /** N s, LR_CONTACT_BEGIN: along the normal, of the substep in which they meet; else 0 */
  impulse: number;
}

export interface ContactEventList {
  count: number;
  /** of the last step; null before lr_world_set_contact_events */
  events: ContactEvent;
  /** events of the last step for which there was no room: the last ones in their order */
  lost: number;
  /** since lr_world_set_contact_events */
  totalLost: number;
}

export interface Ray {
  /** LR_RAY_*, what it can hit; initially both */
  flags: number;
  /** 3 elements. m, up to 1e9 in magnitude; initially 0 */
  origin: number[];
  /** 3 elements. of any length from 1e-6 to 1e6; initially 0, -1, 0 */
  direction: number[];
  /** m, 0 to 1e9; initially 1e9 */
  maxDistance: number;
  /** whose bodies it can hit; initially 0: all */
  batch: number;
  /** bits: it meets colliders that have one of them; initially all */
  colliderLayers: number;
}

/** Never changes: 48 bytes, an element of arrays without gaps. All 0 where nothing is hit. */
export interface RayHit {
  /** 0 where it is a collider */
  body: bigint;
  /** 0 where it is a body */
  collider: bigint;
  /** m, from the ray's origin */
  distance: number;
  /** 3 elements. m, world frame */
  position: number[];
  /** 3 elements. unit, world frame, out of what is hit; against the ray where that begins inside, at distance 0 */
  normal: number[];
}

export interface OverlapDesc {
  /** LR_OVERLAP_*; initially LR_OVERLAP_SPHERE */
  shape: number;
  /** 3 elements. m, of its middle, up to 1e9 in magnitude; initially 0 */
  position: number[];
  /** 4 elements. of a box, x y z w, normalised when taken; initially 0 0 0 1 */
  orientation: number[];
  /** 3 elements. m, > 0, up to 1e6; initially 1 */
  size: number[];
  /** whose bodies are looked for; initially 0: all */
  batch: number;
}

export interface KillVolume {
  /** LR_VOLUME_* */
  shape: number;
  /** LR_KILL_*: where bodies end */
  side: number;
  /** 3 elements. m, up to 1e9 in magnitude */
  center: number[];
  /** 3 elements. m; of a plane its normal, of any length but 0 */
  size: number[];
}

/**
 * When the bodies of a batch end. A body that has left physics ends under any rules, unless lr_batch_set_fault_policy says
 * that it is held.
 */
export interface BatchRules {
  /** LR_END_*; initially LR_END_DESTROY */
  action: number;
  /** s, up to 1e9; initially 0: no limit */
  maxAge: number;
  /** used part of `volumes`; initially 0 */
  volumeCount: number;
  /** 8 elements. by the centre of mass */
  volumes: KillVolume[];
}

/**
 * How bodies of a batch are born. What is drawn for a body depends on the world's seed, its key, and how often it has
 * respawned, and on nothing else.
 */
export interface EmitterDesc {
  /** LR_EMIT_*; initially LR_EMIT_POINT */
  shape: number;
  /** 3 elements. m, centre of the shape; initially 0 */
  position: number[];
  /** 4 elements. of the shape, x y z w, normalised when taken; initially 0 0 0 1 */
  orientation: number[];
  /** 3 elements. m, half extents or semi-axes along the shape's own axes, 0 to 1e9; initially 0 */
  size: number[];
  /** LR_POSE_*, of the bodies; initially LR_POSE_RANDOM */
  pose: number;
  /** 4 elements. body to world, normalised when taken; initially 0 0 0 1 */
  bodyOrientation: number[];
  /** 3 elements. of the velocity, world frame, of any length but 0; initially 0, -1, 0 */
  direction: number[];
  /** rad, half angle of a cone about `direction`, filled evenly, 0 to pi; initially 0 */
  spread: number;
  /** m/s, evenly between; initially 0 */
  speedMin: number;
  /** m/s, evenly between; initially 0 */
  speedMax: number;
  /** rad/s, evenly between, about any axis alike; initially 0 */
  spinMin: number;
  /** rad/s, evenly between, about any axis alike; initially 0 */
  spinMax: number;
  /** evenly between; initially 1 */
  scaleMin: number;
  /** evenly between; initially 1 */
  scaleMax: number;
  /** births per second, 0 to 1e9; initially 0: bodies respawn, but none are added */
  rate: number;
  /** s between bursts, >= 1e-4 */
  burstInterval: number;
  /** births at once in each burst; initially 0: no bursts */
  burstCount: number;
}

/** What rules and emitter did in the last step, and since the batch began. */
export interface BatchEvents {
  /** by rate and bursts */
  born: number;
  /** by the rules */
  destroyed: number;
  respawned: number;
  /** births for which there was no room */
  missed: number;
  /** bodies that have left physics: lr_batch_set_fault_policy */
  byNotFinite: number;
  byAge: number;
  /** 8 elements. */
  byVolume: number[];
  /** with those of lr_batch_emit */
  totalBorn: number;
  totalDestroyed: number;
  totalRespawned: number;
  totalMissed: number;
  /** destroyed or respawned in the last step: destroyed + respawned of them, in no order */
  endedIds: BigUint64Array;
  /** `born` of them */
  bornIds: BigUint64Array;
  /** bodies that have left physics in the last step, held or ended */
  faulted: number;
  /** since the batch began */
  totalFaulted: number;
}

/** The C functions as the module exports them: addresses are numbers, 64 bits are bigints. */
export interface RawFunctions {
  /**
   * Version of the library that is loaded: major << 22 | minor << 12 | patch. Compare it with the macros above when the
   * library is loaded at run time: a different major, or before 1.0 a different minor, is another ABI.
   */
  lr_version(): number;
  /** A short English phrase for a status, no full stop; never null; static storage. Unknown values give "unknown status". */
  lr_status_string(status: number): number;
  /**
   * Writes the instruction sets that this build has and this processor can run, best first.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL (count is set).
   */
  lr_simd_targets(targets: number, capacity: number, count: number): number;
  /**
   * A name for people: "AVX-512", "AVX2", "SSE4", "NEON", "WebAssembly", "plain", "auto" or "unknown"; never null; static
   * storage.
   */
  lr_simd_target_name(target: number): number;
  /**
   * Reads an asset made by `lr_bake`, a regular file. It is verified whole before anything of it is used.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_FILE_NOT_FOUND, LR_ERROR_FILE_READ, LR_ERROR_ASSET_FORMAT,
   * LR_ERROR_ASSET_VERSION, LR_ERROR_ASSET_CORRUPT, LR_ERROR_ASSET_INVALID, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_asset_load_file(path_utf8: number, out: number): number;
  /**
   * The same from `size` bytes in memory, of any alignment, not kept.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_ASSET_*, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_asset_load_memory(bytes: number, size: bigint, out: number): number;
  /**
   * Says everything that is wrong with asset bytes, by one call of `report` for each fault (may be null).
   * Returns what lr_asset_load_memory would.
   */
  lr_asset_check_memory(bytes: number, size: bigint, report: number, user: number): number;
  /**
   * Fills a desc with its initial values.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. The other _init functions are alike.
   */
  lr_ellipsoid_desc_init(desc: number, struct_size: number): number;
  /**
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
   * LR_ERROR_OUT_OF_MEMORY. Source: Lamb, Hydrodynamics, art. 114-115; docs/maintainers/physics.md.
   */
  lr_asset_create_ellipsoid(desc: number, out: number): number;
  /**
   * Adds a reference, to be given back by lr_asset_release.
   * LR_OK, LR_ERROR_NULL_ARGUMENT.
   */
  lr_asset_retain(asset: number): number;
  /** Gives a reference back; the last one frees the asset. Batches hold their own. Null is fine. */
  lr_asset_release(asset: number): void;
  /** Initially the axes are those of the body, `length` is 1 and all else 0: no loads. */
  lr_aerodynamics_init(aerodynamics: number, struct_size: number): number;
  lr_rigid_desc_init(desc: number, struct_size: number): number;
  /**
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also matrices that no
   * body has), LR_ERROR_OUT_OF_MEMORY.
   */
  lr_asset_create_rigid(desc: number, out: number): number;
  lr_asset_info_init(info: number, struct_size: number): number;
  /** LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. */
  lr_asset_get_info(asset: number, info: number): number;
  /**
   * The coefficients of an asset, as baked.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
   */
  lr_asset_get_aerodynamics(asset: number, aerodynamics: number): number;
  lr_world_desc_init(desc: number, struct_size: number): number;
  /**
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
   * LR_ERROR_UNSUPPORTED (simd_target), LR_ERROR_OUT_OF_MEMORY, LR_ERROR_THREADS.
   */
  lr_world_create(desc: number, out: number): number;
  /** Frees a world with all its batches and bodies, and ends its worker threads. A recording ends. Null is fine. */
  lr_world_destroy(world: number): void;
  lr_world_info_init(info: number, struct_size: number): number;
  /** LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. */
  lr_world_get_info(world: number, info: number): number;
  /**
   * Takes effect with the next step. Another one than before wakes all bodies (lr_body_set_rest).
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_world_set_gravity(world: number, gravity: number): number;
  /**
   * Changes the instruction set from the next step on; results do not change.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_UNSUPPORTED.
   */
  lr_world_set_simd_target(world: number, target: number): number;
  lr_wind_desc_init(desc: number, struct_size: number): number;
  /**
   * The uniform part of the fluid's velocity; copied. Bodies feel the fluid's velocity relative to theirs. A change is
   * spread evenly over the next step, and bodies feel the fluid's acceleration in it (Froude-Krylov force and added mass):
   * one that has the fluid's density is carried along, a heavy one keeps most of its velocity. What is set before the
   * world's first step is there from the beginning and accelerates nothing; setting the same wind again changes nothing.
   * Null is still fluid. docs/reference/wind_and_water.md.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_world_set_wind(world: number, desc: number): number;
  lr_wind_source_desc_init(desc: number, struct_size: number): number;
  /**
   * Adds a source. Bodies keep their velocities: a field that appears is not one that accelerates.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->samples of a grid), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_world_add_wind(world: number, desc: number, out: number): number;
  /**
   * Replaces everything of a source, also its kind. A grid may be given without samples: it then keeps those it has, if
   * counts and frames are as before.
   * LR_OK, LR_ERROR_STALE_WIND_SOURCE, and what lr_world_add_wind returns.
   */
  lr_world_update_wind(world: number, source: number, desc: number): number;
  /** LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_WIND_SOURCE. */
  lr_world_remove_wind(world: number, source: number): number;
  /**
   * An engine's own field, added to all else. Null removes it. Not part of snapshots.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world).
   */
  lr_world_set_wind_callback(world: number, callback: number, user: number): number;
  /**
   * The velocity of the fluid at the world's present time, of all sources: for particles, cloth, arrows on a screen.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_world_sample_wind(world: number, positions: number, count: number, velocities: number): number;
  lr_surface_desc_init(desc: number, struct_size: number): number;
  /**
   * From the next step on; copied. Null removes it. Bodies keep their velocities, also those that are now in another
   * fluid. A batch whose mass matrix is singular in it stays in its own, with a warning. Part of snapshots and hash.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_world_set_surface(world: number, desc: number): number;
  /**
   * An engine's own water, while there is a surface. Null removes it. Not part of snapshots.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world).
   */
  lr_world_set_surface_callback(world: number, callback: number, user: number): number;
  /**
   * Advances all bodies by dt in `substeps` equal parts.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_TIMESTEP_*, LR_ERROR_SUBSTEPS, LR_ERROR_OUT_OF_MEMORY: the step has been taken, not
   * to be repeated, but bodies went through each other in it; the next one asks for the memory again.
   */
  lr_world_step(world: number, dt: number, substeps: number): number;
  /**
   * A budget for the work of each step: a count of substeps of single bodies, whatever each of them costs, at most 2^48; 0, as at
   * first: none. From the next step on; part of snapshots. Where the batches that are due want more, each gets the fewest substeps that
   * keep falls as they are (lr_batch_set_rate), those that have waited longest first; nobody waits for ever. The same calls give the
   * same bits on every machine. A batch on whose single bodies forces act is stepped at once, even over the budget. docs/reference/stepping.md.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_world_set_budget(world: number, body_substeps: bigint): number;
  lr_step_report_init(report: number, struct_size: number): number;
  /** LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. */
  lr_world_get_step_report(world: number, report: number): number;
  /**
   * A hash of the state of all bodies and the time index. Independent of the order of bodies in memory, of the processor
   * and of worker_count; equal hashes mean equal motion from here on, given equal worlds. Wind sources are part of it,
   * grids by the hash of their samples, the surface, and colliders.
   * LR_OK, LR_ERROR_NULL_ARGUMENT.
   */
  lr_world_hash(world: number, out: number): number;
  /** Bytes that lr_world_snapshot_save needs at present; 0 for null. */
  lr_world_snapshot_size(world: number): bigint;
  /**
   * Writes the world's state (bodies with their ids, time, wind, surface, gravity, tables, loads, forces, rules, emitter,
   * rates, budget, colliders with their ids, how batches meet them and each other) into `size` bytes at `memory`, any alignment.
   * Assets, how batches were created, threads and callbacks are not part of it, nor the samples of wind grids and the data of
   * hulls, heightfields and meshes, which are named by their hash.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL.
   */
  lr_world_snapshot_save(world: number, memory: number, size: bigint, written: number): number;
  /**
   * Puts a saved state back, also into another world or process whose batches were created in the same order from equal
   * assets with equal capacities. Bodies, wind sources and colliders have the same ids as when it was saved; grids of
   * wind, hulls, heightfields and meshes must be in the world already, in any place. Checked whole before anything changes.
   * Allocates nothing where the world has held as much before. docs/reference/snapshots.md: which versions restore which snapshots.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_SNAPSHOT_FORMAT, LR_ERROR_SNAPSHOT_MISMATCH, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_world_snapshot_restore(world: number, memory: number, size: bigint): number;
  lr_recording_desc_init(desc: number, struct_size: number): number;
  /**
   * From now on every call that can change the world is handed to desc->write with its arguments before it is carried out, and
   * its status after it. At once: the world as it is, with the assets of its batches. May begin at any time. Takes 64 KiB of memory,
   * some bytes for each asset, and while it begins a copy of the assets and a snapshot. When `write` refuses, the recording
   * ends, a message is logged, and the world goes on.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->write), LR_ERROR_STRUCT_SIZE, LR_ERROR_INVALID_ARGUMENT (unknown flags; the world
   * is being recorded; `write` has refused), LR_ERROR_OUT_OF_MEMORY.
   */
  lr_world_record_start(world: number, desc: number): number;
  /**
   * Ends a recording.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (none is under way: also where `write` has refused).
   */
  lr_world_record_stop(world: number): number;
  lr_batch_desc_init(desc: number, struct_size: number): number;
  /**
   * LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->asset), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_create(world: number, desc: number, out: number): number;
  /**
   * Ends a batch with all its bodies. Those of batches that it met (lr_batch_set_pair_contact) wake.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH.
   */
  lr_batch_destroy(world: number, batch: number): number;
  lr_turbulence_table_init(table: number, struct_size: number): number;
  /**
   * Replaces a batch's table; null puts the asset's own back. With AERODYNAMIC loads the table sets the velocity of the fluid
   * around the body, instead of the intensity in lr_aerodynamics.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_set_turbulence_table(world: number, batch: number, table: number): number;
  /**
   * Coefficients of the AERODYNAMIC loads for a batch, in place of its asset's, from the next step on; copied. Null puts the
   * asset's own back. With intensity 0 and lr_load_gains.turbulence 1 a fall is the same for any seed. With other axes than the
   * body's, or another center than 0, a body of LR_ASSET_DIAGONAL takes the slower path of all others.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_set_aerodynamics(world: number, batch: number, aerodynamics: number): number;
  /**
   * What the batch's coefficients are at present.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
   */
  lr_batch_get_aerodynamics(world: number, batch: number, aerodynamics: number): number;
  lr_load_gains_init(gains: number, struct_size: number): number;
  /**
   * From the next step on; null puts all at 1. LANGEVIN loads have their gains in lr_batch_desc.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_set_load_gains(world: number, batch: number, gains: number): number;
  /**
   * How often a batch is stepped: level of detail for bodies that are far away, small, or out of sight. docs/reference/stepping.md.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_set_rate(world: number, batch: number, divisor: number): number;
  lr_batch_pace_init(pace: number, struct_size: number): number;
  /** LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
  lr_batch_get_pace(world: number, batch: number, pace: number): number;
  lr_batch_view_init(view: number, struct_size: number): number;
  /** LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
  lr_batch_get_view(world: number, batch: number, view: number): number;
  /**
   * Writes the transforms of the first `count` bodies of a batch, or of all where there are fewer, in the order of its view; of one that
   * waits (lr_batch_set_rate), moved on to the world's time. The mesh to be drawn must have its origin at the centre of mass
   * (lr_asset_info.center_of_mass).
   * An instance buffer keeps what was written before: where lr_batch_view.revision is that of the last time, bodies at rest then still
   * lie there, and it is enough to write as many as moved then or move now, the greater awake_count of the two. Else all: docs/reference/bodies.md.
   * Keep both numbers for each buffer that is written in turn.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (dst may be null only when nothing is to be written), LR_ERROR_STALE_BATCH,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_write_transforms(world: number, batch: number, format: number, dst: number, stride: bigint, count: number, written: number): number;
  lr_body_desc_init(desc: number, struct_size: number): number;
  /**
   * Creates `count` bodies, all or none.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY.
   */
  lr_body_create(world: number, batch: number, descs: number, count: number, out_ids: number): number;
  /**
   * Destroys `count` bodies of any batches, all or none: if one of them is stale, or given twice, nothing is destroyed. What lay on
   * them wakes.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY.
   */
  lr_body_destroy(world: number, bodies: number, count: number): number;
  lr_body_state_init(state: number, struct_size: number): number;
  /** LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE. */
  lr_body_get_state(world: number, body: bigint, state: number): number;
  /**
   * Sets everything but the key, and wakes the body. The quaternion is normalised. Positions up to 1e9 m, velocities up to
   * 1e6 m/s and rad/s are taken, here and by lr_body_create. For many bodies a frame, prefer forces and wind: this breaks
   * the physics by design.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_body_set_state(world: number, body: bigint, state: number): number;
  /**
   * Puts bodies of any batches to rest, or wakes them, all or none; some may be so already, or be given twice. A body at
   * rest does not move, whatever acts on it, and costs a step nothing. Its velocities and the forces on it end. It wakes
   *  - by this function, lr_world_wake_box, and lr_body_set_state,
   *  - by a force, impulse or velocity on it that is not zero (lr_body_add_force, lr_batch_add_forces),
   *  - by a change of lr_batch_set_force, lr_world_set_gravity or lr_batch_set_pair_contact, with all others that it is about,
   *  - when it begins anew by its batch's rules,
   *  - by contact: colliders, wind. docs/reference/bodies.md.
   * It grows older, and the rules of its batch are for it too: they look at bodies at rest in every 16th step of the batch.
   * Bodies that wake and come to rest change indices in the view, not ids. Part of snapshots. The first body at rest of a
   * batch takes up to 25 bytes for each of the batch's capacity.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_INVALID_ARGUMENT,
   * LR_ERROR_OUT_OF_MEMORY.
   */
  lr_body_set_rest(world: number, bodies: number, count: number, rest: number): number;
  /**
   * Wakes all bodies at rest that reach into a box, each taken to be a cube that it can turn in: for what the world does not
   * know of, as footsteps and explosions.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
   */
  lr_world_wake_box(world: number, low: number, high: number, woken: number): number;
  lr_body_force_init(force: number, struct_size: number): number;
  /**
   * Puts `count` forces on bodies of any batches, all or none; a body may be there more than once. One of them may
   * give its body up to 1e9 m/s^2, torques as much over its length; an impulse up to 1e6 m/s and rad/s. Pending forces
   * are part of snapshots and of the world's hash. The first force or acceleration on a body of a batch takes 96 bytes
   * for each of the batch's capacity.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_body_add_force(world: number, forces: number, count: number): number;
  lr_force_arrays_init(arrays: number, struct_size: number): number;
  /**
   * LR_OK, LR_ERROR_NULL_ARGUMENT (some of three pointers), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE,
   * LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also first + count over the batch's bodies),
   * LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_add_forces(world: number, batch: number, arrays: number): number;
  lr_batch_force_init(force: number, struct_size: number): number;
  /**
   * From the next step on, until changed; copied. Null ends it. A change wakes the batch's bodies. Part of snapshots.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_set_force(world: number, batch: number, force: number): number;
  lr_collider_desc_init(desc: number, struct_size: number): number;
  /**
   * Creates `count` colliders, all or none. They are there from the next step on. Hulls, heightfields and meshes that are equal
   * share one copy of their data.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT (also arrays that the kind needs), LR_ERROR_STRUCT_SIZE,
   * LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also a hull that is flat: thinner than 1e-4 of its largest extent; a mesh
   * with an index out of range, or no triangle with an area), LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_collider_create(world: number, descs: number, count: number, out_ids: number): number;
  /**
   * Destroys `count` colliders, all or none: if one of them is stale, or given twice, nothing is destroyed.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER.
   */
  lr_collider_destroy(world: number, colliders: number, count: number): number;
  lr_collider_motion_init(motion: number, struct_size: number): number;
  /**
   * Moves `count` colliders, all or none, in this order: of several motions of one collider the last holds. Planes that turn
   * keep all bodies of the world from the fast path while they do.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_STALE_COLLIDER, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_collider_move(world: number, motions: number, count: number): number;
  lr_collider_state_init(state: number, struct_size: number): number;
  /** LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE. */
  lr_collider_get_state(world: number, collider: bigint, state: number): number;
  lr_collider_surface_init(surface: number, struct_size: number): number;
  /**
   * Gives `count` colliders the same surface, all or none, from the next step on.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_collider_set_surface(world: number, colliders: number, count: number, surface: number): number;
  lr_batch_contact_init(contact: number, struct_size: number): number;
  /**
   * From the next step on; copied. Null is what a batch has initially. Wakes the batch's bodies at rest. Part of snapshots.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT.
   */
  lr_batch_set_contact(world: number, batch: number, contact: number): number;
  /** LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
  lr_batch_get_contact(world: number, batch: number, contact: number): number;
  /**
   * Whether bodies of `a` and of `b` meet each other, from the next step on; their order does not matter, and a == b are the
   * bodies of one batch among themselves. Initially none do. Friction, restitution and rolling resistance are those of
   * lr_batch_contact: of a pair, friction is the geometric mean of both and restitution the larger. Layers are for colliders alone.
   * Bodies of batches that are stepped at different rates (lr_batch_set_rate), or wait for a budget, meet only while one of both is
   * at rest. A change wakes the bodies at rest of both batches, and the end of one batch those of the other. Part of snapshots.
   * The first pair of a batch takes 28 bytes for each of its capacity, and up to 75 more unless there have been colliders.
   * docs/maintainers/contact.md
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH (either), LR_ERROR_INVALID_ARGUMENT (enabled),
   * LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_set_pair_contact(world: number, a: number, b: number, enabled: number): number;
  /** LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH (either). */
  lr_batch_get_pair_contact(world: number, a: number, b: number, enabled: number): number;
  /**
   * Has events kept, at most `capacity` of a step, from now on: contacts that there are already do not begin again.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (unknown bits; no bit but a capacity),
   * LR_ERROR_OUT_OF_MEMORY.
   */
  lr_world_set_contact_events(world: number, capacity: number, kinds: number): number;
  lr_contact_event_list_init(list: number, struct_size: number): number;
  /**
   * Valid until the next call that is not a query; empty after lr_world_snapshot_restore. In order of batches (their place in the
   * world's table), then of the bodies' keys, then of kinds, then of colliders' slots: independent of workers, processors and where
   * bodies lie in memory. Bodies that share a key are in order of their slots.
   * Contact is looked at after each substep, and ends only at the end of a step: what bounces within one begins once. What touches
   * and leaves within a step begins and ends in it. A body at rest still touches what it lies on. Of a body that ends there is one
   * LR_BODY_KILLED and nothing else, but LR_BODY_FAULTED where that is why; of those destroyed by lr_body_destroy there is nothing. At
   * most four colliders of a body count, those that press it most; other bodies that it touches count as one of the four, and neither
   * begin nor end. A body that comes to rest on other bodies has landed.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
   */
  lr_world_get_contact_events(world: number, list: number): number;
  lr_ray_init(ray: number, struct_size: number): number;
  /**
   * What each ray hits first. Bodies are what can touch colliders of them: the hull of their asset, or an ellipsoid (docs/maintainers/contact.md);
   * those of batches that wait (lr_batch_set_rate) are where they were stepped last. Planes and heightfields are solid below their surface,
   * meshes are met from both sides. Colliders are where the last step or lr_collider_move has put them. Of equal distances bodies come
   * before colliders, then the order is that of batches and keys, or of colliders' slots.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
   * LR_ERROR_STALE_BATCH: then no hit is written.
   */
  lr_world_ray_cast(world: number, rays: number, count: number, hits: number): number;
  lr_overlap_desc_init(desc: number, struct_size: number): number;
  /**
   * All bodies of which a part is in a sphere or box, in order of batches, then keys, then slots. They are the same as for rays.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_STALE_BATCH,
   * LR_ERROR_BUFFER_TOO_SMALL: *count is set, and `bodies` holds no meaning.
   */
  lr_world_overlap(world: number, desc: number, bodies: number, capacity: number, count: number): number;
  lr_batch_rules_init(rules: number, struct_size: number): number;
  /**
   * Bodies are judged at the end of each step, those at rest (lr_body_set_rest) in one of 16 of their batch. Copied; null
   * ends the rules. Part of snapshots. The first rules or emitter of a batch take 24 bytes for each of its capacity; later
   * calls, say to move a volume along with a camera, none.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT (also LR_END_RESPAWN without an emitter), LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_set_rules(world: number, batch: number, rules: number): number;
  /**
   * What becomes of a body that has left physics: forces beyond all measure, a scheme that blows up, a collider that shoots it out of
   * the world. Every body is judged in each step, and after impulses: a number that is not finite, a coordinate over 1e10 m, a velocity
   * over 2e6 m/s or 1e9 rad/s, or an orientation that is none must not be seen. At the end of the step it is told by LR_BODY_FAULTED, counted
   * in lr_batch_events, and logged once for all; others are not touched by it. docs/reference/bodies.md
   * A body that is held has the position and orientation of the beginning of that step or substep, and no velocity. Nothing moves or
   * touches it, it moves and touches nothing, forces on it are taken and have no effect; it grows older, and rules may end it.
   * lr_body_set_state sets it free, and lr_body_set_rest puts it to rest like any other. lr_body_state.resting tells.
   * Initially LR_FAULT_AUTO. From the next step on, also for the others; those that are held stay so. Part of snapshots and hash.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_set_fault_policy(world: number, batch: number, policy: number): number;
  /** LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH. */
  lr_batch_get_fault_policy(world: number, batch: number, policy: number): number;
  lr_emitter_desc_init(desc: number, struct_size: number): number;
  /**
   * Bodies are born at the end of each step, after others have ended, up to the batch's capacity; those that find no room
   * are not born later. Their keys are the world's next. Copied; another emitter carries on with the fraction of a body
   * that is due and with the time since the last burst; null ends it. Part of snapshots. Memory: as lr_batch_set_rules.
   * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
   * LR_ERROR_INVALID_ARGUMENT (also null while the rules respawn), LR_ERROR_OUT_OF_MEMORY.
   */
  lr_batch_set_emitter(world: number, batch: number, desc: number): number;
  /**
   * Bears `count` bodies now, all or none.
   * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT (no emitter),
   * LR_ERROR_CAPACITY.
   */
  lr_batch_emit(world: number, batch: number, count: number, out_ids: number): number;
  lr_batch_events_init(events: number, struct_size: number): number;
  /**
   * Lists are valid until the next call that is not a query. All but faults is 0 and null for a batch that never had rules or an
   * emitter. Totals are part of snapshots; after a restore there are no events of the last step.
   * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
   */
  lr_batch_get_events(world: number, batch: number, events: number): number;
}
