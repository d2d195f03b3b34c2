/*
 * Langevin Rigid: leaves, paper, petals, confetti and sinking things that flutter, glide and tumble, thousands to a
 * million at a time, with the same bits on every machine.
 *
 * SPDX-License-Identifier: MIT
 *
 * How it is used
 *   1. Load an asset that `lr_bake` made from a mesh (or make an ellipsoid without a file).
 *   2. Create a world, and in it a batch for each asset: a batch holds all bodies of one asset.
 *   3. Create bodies, step the world once a frame, write the transforms straight into an instance buffer.
 *
 * Units        SI everywhere: metre, kilogram, second, radian. No axis is special; gravity is a vector.
 * Frames       World frame unless a field says "body frame". The body frame has its origin at the centre of mass and
 *              its axes as authored in the mesh. Right-handed. Orientations are unit quaternions x, y, z, w that turn
 *              body vectors into world vectors.
 * Ownership    Whoever creates, destroys. No function keeps a pointer given to it unless its text says so.
 * Structs      Each begins with `struct_size` and is filled by its `_init` function, called with sizeof. Structs only
 *              ever grow at the end. A larger struct from a newer header is taken if its unknown tail is all zero.
 * Errors       Functions return LR_OK or a negative lr_status and then have changed nothing, unless their text says
 *              otherwise. Nothing aborts, throws or prints.
 * Threads      One world may be used by one thread at a time; different worlds at the same time. Assets are immutable
 *              and may be shared by any number of worlds and threads. lr_world_desc.checks has misuse found: every function
 *              that takes a world then returns LR_ERROR_CONCURRENT_USE or LR_ERROR_REENTRANT besides what its text says.
 * Determinism  Same calls, same library version: same bits, whatever the processor, the number of workers, or the order
 *              in which bodies lie in memory. See docs/maintainers/determinism.md.
 */
#ifndef LANGEVIN_RIGID_H
#define LANGEVIN_RIGID_H

#include <stdint.h>

#if defined(_WIN32)
#if defined(LR_BUILD_SHARED)
#define LR_API __declspec(dllexport)
#else
#define LR_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define LR_API __attribute__((visibility("default")))
#else
#define LR_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ------------------------------------------------------------------------------------------------------------------ */
/* Version and status                                                                                                 */

#define LR_VERSION_MAJOR 0
#define LR_VERSION_MINOR 1
#define LR_VERSION_PATCH 0

/* Version of the library that is loaded: major << 22 | minor << 12 | patch. Compare it with the macros above when the
 * library is loaded at run time: a different major, or before 1.0 a different minor, is another ABI. Any thread. */
LR_API uint32_t lr_version(void);

/* LR_OK, or a negative error. Values are stable. */
typedef int32_t lr_status;

#define LR_OK 0
#define LR_ERROR_NULL_ARGUMENT (-1) /* a pointer that must be given is null */
#define LR_ERROR_STRUCT_SIZE (-2)   /* struct_size is smaller than any released size, or an unknown tail is not zero */
#define LR_ERROR_INVALID_ARGUMENT (-3)     /* a value is out of its range */
#define LR_ERROR_NOT_FINITE (-4)           /* a number is NaN or infinite */
#define LR_ERROR_OUT_OF_MEMORY (-5)        /* the allocator returned null */
#define LR_ERROR_STALE_BODY (-6)           /* the body was destroyed, or never was */
#define LR_ERROR_STALE_BATCH (-7)          /* the batch was destroyed, or never was */
#define LR_ERROR_CAPACITY (-8)             /* the batch, or the world's table of batches, is full */
#define LR_ERROR_BUFFER_TOO_SMALL (-9)     /* the caller's buffer cannot hold the result */
#define LR_ERROR_FILE_NOT_FOUND (-10)      /* no file at that path */
#define LR_ERROR_FILE_READ (-11)           /* the file exists but cannot be read */
#define LR_ERROR_ASSET_FORMAT (-12)        /* not an asset file: too short, or another kind of file */
#define LR_ERROR_ASSET_VERSION (-13)       /* made for a newer library */
#define LR_ERROR_ASSET_CORRUPT (-14)       /* an asset file, but damaged */
#define LR_ERROR_ASSET_INVALID (-15)       /* undamaged, but its numbers cannot be those of a body */
#define LR_ERROR_SNAPSHOT_FORMAT (-16)     /* not a snapshot, damaged, or of another version */
#define LR_ERROR_SNAPSHOT_MISMATCH (-17)   /* a snapshot of a world with other batches or assets */
#define LR_ERROR_UNSUPPORTED (-18)         /* not available on this processor or in this build */
#define LR_ERROR_THREADS (-19)             /* the worker threads could not be started */
#define LR_ERROR_TIMESTEP_ZERO (-20)       /* dt is 0 */
#define LR_ERROR_TIMESTEP_NEGATIVE (-21)   /* dt is negative */
#define LR_ERROR_TIMESTEP_NOT_FINITE (-22) /* dt is NaN or infinite */
#define LR_ERROR_TIMESTEP_TOO_LARGE (-23)  /* dt / substeps is over LR_MAX_SUBSTEP */
#define LR_ERROR_SUBSTEPS (-24)            /* substeps is 0 or over LR_MAX_SUBSTEPS */
#define LR_ERROR_INTERNAL (-25)            /* a defect of the library: please report */
#define LR_ERROR_STALE_WIND_SOURCE (-26)   /* the wind source was removed, or never was */
#define LR_ERROR_STALE_COLLIDER (-27)      /* the collider was destroyed, or never was */
#define LR_ERROR_CONCURRENT_USE (-28)      /* another thread is inside a call on the world: LR_CHECK_THREADS */
#define LR_ERROR_REENTRANT (-29)           /* this thread is, and the call comes from a callback: LR_CHECK_THREADS */

#define LR_MAX_SUBSTEP 1.0f    /* s: the longest dt / substeps that is taken */
#define LR_MAX_SUBSTEPS 65536u /* the most substeps in one step */

/* A short English phrase for a status, no full stop; never null; static storage. Unknown values give "unknown status".
 * Any thread. */
LR_API const char* lr_status_string(lr_status status);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Types                                                                                                              */

typedef struct lr_world lr_world;
typedef struct lr_asset lr_asset;

/* Handles are values. 0 is never a valid handle. A handle to something destroyed is recognised, not followed. */
typedef uint32_t lr_batch;
typedef uint64_t lr_body; /* batch, generation and slot in one; compare for equality only */

/* Where a world takes its memory from. Both functions are given or neither; neither means the C library's.
 * `allocate` returns `size` bytes aligned to `alignment` (a power of two, at most 128), or null.
 * `release` gets the very size and alignment that were asked for. Called only from the thread that calls the library,
 * during lr_world_step only where bodies meet each other (lr_batch_set_pair_contact) in greater number than ever before.
 * Must not call the library on the same world. */
typedef struct lr_allocator {
    void* user;
    void* (*allocate)(void* user, uint64_t size, uint64_t alignment);
    void (*release)(void* user, void* memory, uint64_t size, uint64_t alignment);
} lr_allocator;

/* Tasks of an engine's job system, in place of the world's own threads: docs/reference/stepping.md. Both functions are given or neither.
 *
 * `enqueue` has run(task, begin, end) called for ranges that together hold each of the indices 0 to count - 1 once, in
 * any order, on any threads, at any time from now on until `finish` returns: one call for all, one for each, or what a
 * parallel-for makes of it, also right away inside `enqueue`. It returns a token for `finish`, of any value.
 * `finish` returns when all of these calls have returned. It is called exactly once for each `enqueue`, by the same thread.
 * Its thread had best run what has not begun itself: the world's caller does its share first, so that late tasks find
 * nothing left to do, and return at once.
 *
 * Indices stand for threads, not for pieces of work, which the tasks share out among themselves: how they are spread changes
 * speed, never results. Both are called within lr_world_step alone, by its thread, in the floating-point mode that it came
 * with; tasks set and restore their own. Neither may throw, longjmp, or call the library on the same world; nor may run()
 * be called after `finish`. */
typedef void (*lr_task_fn)(void* task, uint32_t begin, uint32_t end);

typedef struct lr_job_system {
    void* user;
    void* (*enqueue)(void* user, lr_task_fn run, void* task, uint32_t count);
    void (*finish)(void* user, void* token);
} lr_job_system;

#define LR_LOG_ERROR 1   /* a call failed: the message says which, and why */
#define LR_LOG_WARNING 2 /* a call succeeded, but probably not as meant */
#define LR_LOG_INFO 3

/* Receives a message, valid during the call only. Called from the thread that calls the library: with LR_CHECK_THREADS also
 * while another thread's call on the world goes on. Must not call the library on the same world. May be null. */
typedef void (*lr_log_fn)(void* user, int32_t level, const char* message);

/* Instruction sets, best first within a family. LR_SIMD_AUTO picks the best that the processor has. All of them give
 * the same bits: forcing one is for tests and measurements. */
#define LR_SIMD_AUTO 0
#define LR_SIMD_SSE4 1 /* with SSE4.2, AES and PCLMUL: the least that an x86-64 processor must have */
#define LR_SIMD_AVX2 2
#define LR_SIMD_AVX512 3
#define LR_SIMD_NEON 4
#define LR_SIMD_WASM 5
#define LR_SIMD_PLAIN 6 /* plain C++, in builds for tests alone */

/* Writes the instruction sets that this build has and this processor can run, best first.
 * targets: `capacity` values, may be null when capacity is 0. count: how many there are, even if more than capacity.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL (count is set). Any thread. */
LR_API lr_status lr_simd_targets(int32_t* targets, uint32_t capacity, uint32_t* count);

/* A name for people: "AVX-512", "AVX2", "SSE4", "NEON", "WebAssembly", "plain", "auto" or "unknown"; never null; static
 * storage. Any thread. */
LR_API const char* lr_simd_target_name(int32_t target);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Assets                                                                                                             */

/* One numbered fault of an asset file; see docs/reference/asset_format.md. Strings are valid during the call only. */
typedef void (*lr_fault_fn)(void* user, uint32_t number, const char* where, const char* what, const char* remedy);

/* Reads an asset made by `lr_bake`, a regular file. It is verified whole before anything of it is used.
 * path_utf8: UTF-8 on every platform. out: receives an asset with one reference, release it with lr_asset_release; null
 * after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_FILE_NOT_FOUND, LR_ERROR_FILE_READ, LR_ERROR_ASSET_FORMAT,
 * LR_ERROR_ASSET_VERSION, LR_ERROR_ASSET_CORRUPT, LR_ERROR_ASSET_INVALID, LR_ERROR_OUT_OF_MEMORY. Any thread. */
LR_API lr_status lr_asset_load_file(const char* path_utf8, lr_asset** out);

/* The same from `size` bytes in memory, of any alignment, not kept.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_ASSET_*, LR_ERROR_OUT_OF_MEMORY. Any thread. */
LR_API lr_status lr_asset_load_memory(const void* bytes, uint64_t size, lr_asset** out);

/* Says everything that is wrong with asset bytes, by one call of `report` for each fault (may be null).
 * Returns what lr_asset_load_memory would. Any thread. */
LR_API lr_status lr_asset_check_memory(const void* bytes, uint64_t size, lr_fault_fn report, void* user);

/* A solid ellipsoid, with everything from closed forms: mass, Lamb's added mass, and the decay of k and epsilon in a
 * uniform stream. The quickest way to a first falling body. */
typedef struct lr_ellipsoid_desc {
    uint32_t struct_size;
    uint32_t reserved;
    double semi_axes[3];    /* m, each 1e-6 to 1e3, along body x, y, z */
    double density;         /* kg/m^3 of the body, > 0 */
    double fluid_density;   /* kg/m^3, > 0; initially 1.2, air */
    double fluid_viscosity; /* m^2/s, kinematic, > 0; initially 1.5e-5, air */
    double intensity;       /* turbulence intensity I of k0 = 3/2 (I U0)^2, 0 to 10; initially 1, as in the paper */
    double
        center_of_mass[3]; /* m, from the centre of the ellipsoid, inside it; initially 0. A ballasted body: its centre
                              of buoyancy stays at the centre, its moments of inertia those of the uniform solid */
} lr_ellipsoid_desc;

/* Fills a desc with its initial values. struct_size: sizeof(lr_ellipsoid_desc) as the caller sees it.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. Any thread. The other _init functions are alike. */
LR_API lr_status lr_ellipsoid_desc_init(lr_ellipsoid_desc* desc, uint32_t struct_size);

/* out: as for lr_asset_load_file.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
 * LR_ERROR_OUT_OF_MEMORY. Any thread. Source: Lamb, Hydrodynamics, art. 114-115; docs/maintainers/physics.md. */
LR_API lr_status lr_asset_create_ellipsoid(const lr_ellipsoid_desc* desc, lr_asset** out);

/* Adds a reference, to be given back by lr_asset_release. LR_OK, LR_ERROR_NULL_ARGUMENT. Any thread. */
LR_API lr_status lr_asset_retain(lr_asset* asset);

/* Gives a reference back; the last one frees the asset. Batches hold their own. Null is fine. Any thread. */
LR_API void lr_asset_release(lr_asset* asset);

/* Coefficients of the quasi-steady loads at scale 1; equations in docs/maintainers/physics.md, AERODYNAMIC. Everything acts at
 * `center` along `axes`, which turn with the body. Arrays have a value for each axis. v: velocity through the fluid and w:
 * spin, both along the axes; s = |v|; (i, j, k) cyclic; d: lr_asset_info.length_d; rho, nu: density and kinematic viscosity of
 * the fluid. */
typedef struct lr_aerodynamics {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    double axes[9];    /* rows: unit vectors in the body frame, right-handed */
    /* Drag -1/2 rho sum_i (v_i/s)^2 [drag_i + drag_blunt_i Re/(Re + 8710)] s v, Re = s d/nu, and along each axis
     * -rho [drag_layer_i sqrt(nu s) + drag_stokes_i nu] v_i. All >= 0. */
    double drag[3];        /* m^2, drag coefficient times area */
    double drag_blunt[3];  /* m^2, the part that grows with the Reynolds number: of rounded bodies */
    double drag_layer[3];  /* m^(3/2), of the boundary layer */
    double drag_stokes[3]; /* m, of creeping flow */
    /* Lift rho G x v, G_k = spin_lift_k w_k - lift_k v_i v_j/s. */
    double lift[3];        /* m^2, positive where the body is thinner along j than along i */
    double spin_lift[3];   /* m^3 */
    double lift_moment[3]; /* m^3, moment rho lift_moment_k v_i v_j of that lift about k */
    /* Couple -rho (spin_drag_k |w| + spin_drag_stream_k s + spin_drag_stokes_k nu) w_k. All >= 0. */
    double spin_drag[3];        /* m^5 */
    double spin_drag_stream[3]; /* m^4 */
    double spin_drag_stokes[3]; /* m^3 */
    double intensity;     /* of the velocity of the fluid in the body's own wake: per axis `intensity` times s. More
                                   than 0.4, gains included, acts as 0.4: such a wake would feed itself */
    double length;        /* m, correlated over length/s */
    double wake_reynolds; /* that velocity is less by Re/(Re + wake_reynolds): slow wakes are laminar */
    /* Stall: sigma = sum_i broadside_i (v_i/s)^2 multiplies lift by 1 - lift_stall sigma and adds lift_moment_stalled_k
     * sigma to lift_moment_k. */
    double broadside[3]; /* 0 to 1 */
    double lift_stall;
    double lift_moment_stalled[3]; /* m^3 */
    /* Couple -rho g_k (g . w)/s, g_k = sqrt(roll_damping_k) v_k, on the part of the spin about the stream: a wing's roll. All
     * >= 0. In a plane that spin is nought. */
    double roll_damping[3]; /* m^4 */
    double center[3]; /* m, where all of it acts, from the centre of buoyancy, body frame; initially 0; within 2 d */
} lr_aerodynamics;

/* Initially the axes are those of the body, `length` is 1 and all else 0: no loads. */
LR_API lr_status lr_aerodynamics_init(lr_aerodynamics* aerodynamics, uint32_t struct_size);

/* A body whose numbers are known, without mesh or file: from another solver, from measurements, or a section of a card in
 * two dimensions. Matrices are row-major, symmetric, about the centre of mass, in body axes. */
typedef struct lr_rigid_desc {
    uint32_t struct_size;
    uint32_t reserved;
    double mass;                  /* kg, > 0 */
    double volume;                /* m^3, > 0 */
    double inertia[9];            /* kg m^2, positive definite */
    double added_mass[36];        /* order vx vy vz wx wy wz, fluid density included as in lr_asset_info: kg, kg m,
                                         kg m^2; positive semi-definite; initially 0 */
    double center_of_buoyancy[3]; /* m, from the centre of mass; initially 0 */
    double fluid_density;         /* kg/m^3, > 0; initially 1.2, air */
    double fluid_viscosity;       /* m^2/s, kinematic, > 0; initially 1.5e-5, air */
    double extents[3];            /* m, full size along the body axes, > 0 */
    double intensity;             /* of the turbulence table, as in lr_ellipsoid_desc; initially 1 */
    const lr_aerodynamics* aerodynamics; /* copied; null, as initially: those of an ellipsoid with these extents */
} lr_rigid_desc;

LR_API lr_status lr_rigid_desc_init(lr_rigid_desc* desc, uint32_t struct_size);

/* out: as for lr_asset_load_file.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also matrices that no
 * body has), LR_ERROR_OUT_OF_MEMORY. Any thread. */
LR_API lr_status lr_asset_create_rigid(const lr_rigid_desc* desc, lr_asset** out);

/* What an asset is. Matrices are row-major and symmetric. */
typedef struct lr_asset_info {
    uint32_t struct_size;
    uint32_t flags;               /* LR_ASSET_* */
    char name[64];                /* UTF-8, ends with 0 */
    double mass;                  /* kg */
    double volume;                /* m^3 */
    double density;               /* kg/m^3 */
    double center_of_mass[3];     /* m, in the frame of the mesh: where the body origin lies in it */
    double center_of_buoyancy[3]; /* m, from the centre of mass, body axes */
    double inertia[9];            /* kg m^2, about the centre of mass, body axes */
    double added_mass[36];        /* about the centre of mass, order vx vy vz wx wy wz, fluid density included:
                                     kg for the 3x3 block of v, kg m for the coupling, kg m^2 for the block of w */
    double fluid_density;         /* kg/m^3, of the fluid it was baked in */
    double fluid_viscosity;       /* m^2/s, kinematic */
    double length_d;              /* m, characteristic length: the largest extent */
    double length_b;              /* m, thickness */
    double length_l;              /* m, turbulence length; see docs/maintainers/physics.md */
    double u0;                    /* m/s, fall velocity scale sqrt(|density ratio - 1| g b), paper Eq. 1 */
    double reynolds;              /* u0 d / viscosity */
    double c0;                    /* Kolmogorov constant of the Langevin model, paper Eq. 10 */
    double turbulence_dt;         /* s between table samples */
    uint32_t turbulence_count;    /* number of table samples */
    uint32_t hull_vertex_count;   /* 0 for an asset without a hull */
    uint32_t hull_triangle_count;
    uint32_t format_version; /* of the file; 0 for an asset without a file */
    uint64_t content_hash;   /* of everything that matters for motion; equal for equal assets */
} lr_asset_info;

#define LR_ASSET_DIAGONAL 1u /* diagonal in body axes, buoyancy at the centre of mass: the fast path applies */

LR_API lr_status lr_asset_info_init(lr_asset_info* info, uint32_t struct_size);

/* info: initialised by lr_asset_info_init, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. Any thread. */
LR_API lr_status lr_asset_get_info(const lr_asset* asset, lr_asset_info* info);

/* The coefficients of an asset, as baked.
 * aerodynamics: initialised by lr_aerodynamics_init, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. Any thread. */
LR_API lr_status lr_asset_get_aerodynamics(const lr_asset* asset, lr_aerodynamics* aerodynamics);

/* ------------------------------------------------------------------------------------------------------------------ */
/* World                                                                                                              */

/* Bits of lr_world_desc.checks: misuse that is found at run time, for development. Without them it is undefined. */

/* A call on a world while another thread is inside one, or from inside one of the world's own callbacks (wind, surface,
 * allocator, log, job system, recording), is refused: it changes nothing, a message names both functions, and the call
 * that is under way goes on unharmed. A world that is destroyed so stays alive, and its memory is lost;
 * lr_world_snapshot_size returns 0. A call after lr_world_destroy has returned is not found. docs/reference/stepping.md */
#define LR_CHECK_THREADS 1u

typedef struct lr_world_desc {
    uint32_t struct_size;
    uint32_t worker_count;  /* threads besides the caller's, 0 to 64; initially 0: everything runs in the caller. With
                               `jobs`: the most indices in one enqueue, as many as its threads but the caller's; 0:
                               one less than this machine has threads, from 1 to 64, and a warning that it is a guess */
    uint64_t seed;          /* of all noise; initially 0 */
    float gravity[3];       /* m/s^2; initially 0, -9.81, 0 */
    float fluid_density;    /* kg/m^3, >= 0; initially 0: each batch in the fluid its asset was baked in */
    int32_t simd_target;    /* LR_SIMD_*; initially LR_SIMD_AUTO */
    float fluid_viscosity;  /* m^2/s, kinematic, >= 0; initially 0: as each batch's asset was baked */
    lr_allocator allocator; /* copied; initially null functions: the C library's */
    lr_log_fn log;          /* initially null: silence */
    void* log_user;
    lr_job_system jobs; /* copied; initially null functions: worker_count threads of the world's own */
    uint32_t checks;    /* bits LR_CHECK_*; initially 0 */
    uint32_t reserved;  /* 0 */
} lr_world_desc;

LR_API lr_status lr_world_desc_init(lr_world_desc* desc, uint32_t struct_size);

/* out: receives the world, null after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
 * LR_ERROR_UNSUPPORTED (simd_target), LR_ERROR_OUT_OF_MEMORY, LR_ERROR_THREADS. Any thread. */
LR_API lr_status lr_world_create(const lr_world_desc* desc, lr_world** out);

/* Frees a world with all its batches and bodies, and ends its worker threads. A recording ends. Null is fine. */
LR_API void lr_world_destroy(lr_world* world);

typedef struct lr_world_info {
    uint32_t struct_size;
    int32_t simd_target;   /* what LR_SIMD_AUTO became */
    uint32_t worker_count; /* as in the desc; with jobs what 0 became */
    uint32_t batch_count;
    uint64_t body_count;
    uint64_t substep_count; /* substeps since creation; the time index of the noise */
    double time;            /* s since creation: the sum of all dt, in double */
    uint64_t memory_bytes;  /* taken from the allocator at present */
    uint64_t collider_count;
    uint64_t awake_count; /* bodies that are not at rest: lr_body_set_rest */
} lr_world_info;

LR_API lr_status lr_world_info_init(lr_world_info* info, uint32_t struct_size);

/* LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_world_get_info(const lr_world* world, lr_world_info* info);

/* Takes effect with the next step. Another one than before wakes all bodies (lr_body_set_rest). gravity: m/s^2, 3 values,
 * each up to 1e4 in magnitude.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_world_set_gravity(lr_world* world, const float* gravity);

/* Changes the instruction set from the next step on; results do not change.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_UNSUPPORTED. */
LR_API lr_status lr_world_set_simd_target(lr_world* world, int32_t target);

#define LR_WIND_NONE 0
#define LR_WIND_UNIFORM 1 /* the same velocity everywhere */

typedef struct lr_wind_desc {
    uint32_t struct_size;
    int32_t kind;      /* LR_WIND_*; initially LR_WIND_UNIFORM */
    float velocity[3]; /* m/s, each up to 1000 in magnitude; initially 0 */
    uint32_t reserved; /* 0 */
} lr_wind_desc;

LR_API lr_status lr_wind_desc_init(lr_wind_desc* desc, uint32_t struct_size);

/* The uniform part of the fluid's velocity; copied. Bodies feel the fluid's velocity relative to theirs. A change is
 * spread evenly over the next step, and bodies feel the fluid's acceleration in it (Froude-Krylov force and added mass):
 * one that has the fluid's density is carried along, a heavy one keeps most of its velocity. What is set before the
 * world's first step is there from the beginning and accelerates nothing; setting the same wind again changes nothing.
 * Null is still fluid. docs/reference/wind_and_water.md.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_world_set_wind(lr_world* world, const lr_wind_desc* desc);

/* Wind sources: up to LR_MAX_WIND_SOURCES at a time, whose velocities add to the uniform wind. Formulas: docs/reference/wind_and_water.md.
 * Time is that of the world (lr_world_info.time). A source's position is where it is when it is added or updated; from
 * then on it moves with its own `velocity`. Gusts have a mean of 0. They begin at 0 when they are added, the quick ones
 * first, and have their full speed after 4 periods; an update goes on with them. Fields that each kind has:
 *   GUSTS         speed direction spread period seed
 *   RANKINE       position direction velocity circulation size radius half_length
 *   LAMB_OSEEN    the same
 *   POINT_BLOWER  position direction velocity speed size spread range
 *   LINE_BLOWER   the same, and side half_length
 *   TURBULENCE    speed size period octaves seed velocity
 *   GRID          position velocity spacing counts frames period outside samples
 *   GROUND        position direction velocity size reference_height */
#define LR_WIND_SOURCE_GUSTS 1        /* fluctuations of the uniform wind in time */
#define LR_WIND_SOURCE_RANKINE 2      /* a straight vortex with a core that turns as a solid */
#define LR_WIND_SOURCE_LAMB_OSEEN 3   /* a straight vortex with a smooth core */
#define LR_WIND_SOURCE_POINT_BLOWER 4 /* a round jet */
#define LR_WIND_SOURCE_LINE_BLOWER 5  /* a plane jet from a slot */
#define LR_WIND_SOURCE_TURBULENCE 6   /* random, without divergence, everywhere; carried along by the uniform wind */
#define LR_WIND_SOURCE_GRID 7         /* samples on a lattice, in one or more frames */
#define LR_WIND_SOURCE_GROUND 8       /* a factor of the uniform wind and the gusts: logarithmic over a plane */

#define LR_WIND_OUTSIDE_ZERO 0   /* a grid adds nothing outside its samples */
#define LR_WIND_OUTSIDE_CLAMP 1  /* it goes on as at its border */
#define LR_WIND_OUTSIDE_REPEAT 2 /* it repeats itself; the first sample follows the last */

#define LR_MAX_WIND_SOURCES 64u
#define LR_MAX_WIND_SAMPLES 67108864u /* of a grid, all frames together */

typedef uint32_t lr_wind_source; /* handle; 0 is never one */

/* Fields that a kind does not have are not used, but must be in range. Lengths up to 1e6 m, speeds up to 1000 m/s. */
typedef struct lr_wind_source_desc {
    uint32_t struct_size;
    int32_t kind;       /* LR_WIND_SOURCE_*; initially 0, which is none of them */
    float position[3];  /* m: a point of the vortex axis (its middle, if half_length > 0), the nozzle's middle, the
                           grid's first sample, a point of the ground; initially 0 */
    float direction[3]; /* any length but 0: the vortex axis (right-hand rule), where a blower blows, about where gusts
                           blow, the ground's upward normal; initially 1, 0, 0 */
    float side[3];      /* along the slot of a line blower, not along its direction; initially 0, 0, 1 */
    float velocity[3];  /* m/s, of the source itself; initially 0 */
    float speed;        /* m/s: of a blower at its nozzle; root mean square of gusts in all, of turbulence for each
                           component; >= 0; initially 1 */
    float circulation;  /* m^2/s, up to 1e6 in magnitude; initially 1 */
    float size;         /* m, >= 1e-4: core radius, radius of the nozzle or half width of the slot, integral length of
                           turbulence, roughness length of the ground (0.0001 water, 0.03 grass, 1 town); initially 1 */
    float radius;       /* m: a vortex fades out from half of it on, to nothing at it; 0: no limit; initially 0 */
    float half_length;  /* m: of a vortex, which fades likewise, 0 for no limit; of a slot; initially 0 */
    float range;        /* m, >= size: a blower fades out from half of it on, to nothing at it; initially 10 */
    float spread;       /* 0 to 1: widening of a jet per length, 0.11 as measured; gusts: root mean square angle in
                           radians from `direction`; initially 0.1 */
    float period;       /* s: integral time of gusts, 0 for 4, as 2 m over the ground in 3 m/s (IEC 61400-1: 5.67 times
                           the height over the speed); life of the largest eddies, 0 for size/speed; time from one frame
                           to the next, 0 for 1; up to 1e6; initially 0 */
    float reference_height; /* m: where the ground's factor is 1; >= size; initially 10 */
    uint32_t octaves;       /* of turbulence, each half as large as the one before, 1 to 4; initially 2 */
    uint32_t seed;          /* of gusts and turbulence, together with the world's; initially 0 */
    int32_t outside;        /* LR_WIND_OUTSIDE_*; initially LR_WIND_OUTSIDE_ZERO */
    uint32_t counts[3];     /* samples of a grid along x, y, z, each >= 1 */
    uint32_t frames;        /* of a grid, shown one after the other and again from the first; >= 1; initially 1 */
    float spacing[3];       /* m between samples, >= 1e-4; initially 1 */
    uint32_t reserved;      /* 0 */
    const float* samples;   /* m/s, x y z of each sample; x varies fastest, then y, z, frame; copied */
} lr_wind_source_desc;

LR_API lr_status lr_wind_source_desc_init(lr_wind_source_desc* desc, uint32_t struct_size);

/* Adds a source. Bodies keep their velocities: a field that appears is not one that accelerates. out: receives the
 * handle, 0 after an error; may be null.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->samples of a grid), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_world_add_wind(lr_world* world, const lr_wind_source_desc* desc, lr_wind_source* out);

/* Replaces everything of a source, also its kind. A grid may be given without samples: it then keeps those it has, if
 * counts and frames are as before.
 * LR_OK, LR_ERROR_STALE_WIND_SOURCE, and what lr_world_add_wind returns. */
LR_API lr_status lr_world_update_wind(lr_world* world, lr_wind_source source, const lr_wind_source_desc* desc);

/* LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_WIND_SOURCE. */
LR_API lr_status lr_world_remove_wind(lr_world* world, lr_wind_source source);

/* What a wind callback is asked. Arrays have one value a body. */
typedef struct lr_wind_query {
    uint32_t struct_size;
    uint32_t count;           /* bodies, 1 to 256 */
    lr_batch batch;           /* whose bodies they are; 0 when asked by lr_world_sample_wind */
    uint32_t reserved;        /* 0 */
    double time;              /* s, of the middle of the substep */
    const float* position[3]; /* m: where the bodies are expected to be at that time; finite */
    float* velocity[3];       /* m/s, 0 at first: the velocity that is added to the other sources' */
    float* rate[3];           /* m/s^2, 0 at first: its partial derivative in time, if it is known */
    float* gradient[9];       /* 1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate
                                 and gradient the callback's part gives drag, but neither the force of the fluid's
                                 acceleration nor shear */
} lr_wind_query;

/* Called once for each body and substep, in no certain order, from the thread that steps and from the world's workers, or the
 * job system's, at the same time (with worker_count 0 from the stepping thread alone). Results must depend on nothing but position, time
 * and batch for the world to be deterministic. Must not call the library on the same world, throw, or keep pointers. A
 * body whose values are not finite, or over 1000 m/s, gets 0 for all of them, and a warning is logged once after the
 * step. */
typedef void (*lr_wind_fn)(void* user, const lr_wind_query* query);

/* An engine's own field, added to all else. Null removes it. Not part of snapshots.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world). */
LR_API lr_status lr_world_set_wind_callback(lr_world* world, lr_wind_fn callback, void* user);

/* The velocity of the fluid at the world's present time, of all sources: for particles, cloth, arrows on a screen.
 * positions: 3 * count values, m, x y z x y z ..., each up to 1e9 in magnitude. velocities: receives 3 * count, m/s.
 * Both may be null when count is 0; they may be the same array.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_world_sample_wind(const lr_world* world, const float* positions, uint32_t count, float* velocities);

/* A second fluid under a surface: water, with air above. docs/reference/wind_and_water.md */

#define LR_MAX_WAVES 8u

/* A long-crested wave of deep water. Heights add; its frequency sqrt(2 pi g/length) is that of the world's gravity when
 * the surface is set. */
typedef struct lr_wave {
    float direction[3]; /* where it goes: any vector not along the normal; its part in the plane counts */
    float length;       /* m, crest to crest, 1e-3 to 1e6 */
    float amplitude;    /* m, half of crest to trough, 0 to length/7: steeper ones break */
    float phase;        /* rad, up to 1e6 in magnitude: 0 has a crest at `position` at the world's time 0 */
} lr_wave;

/* The lower fluid fills everything below a plane, or below the waves on it. Above is the fluid of the world or of each
 * batch's asset. Bodies float, sink, and go through; surface tension is ignored. */
typedef struct lr_surface_desc {
    uint32_t struct_size;
    uint32_t wave_count; /* used part of `waves`; initially 0 */
    float position[3];   /* m, a point of the plane, each up to 1e9 in magnitude; initially 0 */
    float normal[3];     /* upward, any length but 0; initially 0, 1, 0 */
    float density;       /* kg/m^3, 1e-3 to 1e6; initially 998. A batch whose own fluid is denser keeps that one's */
    float viscosity;     /* m^2/s, kinematic, 1e-12 to 1e3; initially 1e-6 */
    float current[3];    /* m/s, velocity of the lower fluid, each up to 1000 in magnitude; initially 0 */
    float reach;         /* m, 0 to 1e6: a callback's surface lies at most so far from the plane; initially 0 */
    lr_wave waves[LR_MAX_WAVES];
} lr_surface_desc;

LR_API lr_status lr_surface_desc_init(lr_surface_desc* desc, uint32_t struct_size);

/* From the next step on; copied. Null removes it. Bodies keep their velocities, also those that are now in another
 * fluid. A batch whose mass matrix is singular in it stays in its own, with a warning. Part of snapshots and hash.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_world_set_surface(lr_world* world, const lr_surface_desc* desc);

/* What a surface callback is asked. Arrays have one value a body, and hold what plane and waves give at first. */
typedef struct lr_surface_query {
    uint32_t struct_size;
    uint32_t count;           /* bodies, 1 to 256 */
    lr_batch batch;           /* whose bodies they are */
    uint32_t reserved;        /* 0 */
    double time;              /* s */
    const float* position[3]; /* m; finite */
    float* height;            /* m above the plane of the surface there, along the plane's normal */
    float* normal[3];         /* unit, of the surface, less than 80 degrees from the plane's */
    float* velocity[3];       /* m/s, of the lower fluid at the position */
    float* rate[3]; /* m/s^2, its acceleration. Where the surface is steep it is what lets bodies slide down */
} lr_surface_query;

/* Called for bodies near the surface: once, and twice more for each substep; on what terms: as lr_wind_fn.
 * A body whose values are not finite, too large (heights over `reach`, velocities over 1000 m/s, accelerations over
 * 1e6 m/s^2), or whose normal is none gets those of the plane, and a warning is logged once
 * after the step. */
typedef void (*lr_surface_fn)(void* user, const lr_surface_query* query);

/* An engine's own water, while there is a surface. Null removes it. Not part of snapshots.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world). */
LR_API lr_status lr_world_set_surface_callback(lr_world* world, lr_surface_fn callback, void* user);

/* Advances all bodies by dt in `substeps` equal parts. dt: s, > 0. substeps: 1 to LR_MAX_SUBSTEPS; at 60 Hz, 2 suit
 * leaves and paper of some centimetres, 4 petals and confetti (docs/maintainers/numerics.md). At its end bodies end and are born as
 * the batches' rules and emitters say. Allocates nothing but what lr_allocator says. The floating-point mode of the calling
 * thread is saved, set and restored.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_TIMESTEP_*, LR_ERROR_SUBSTEPS, LR_ERROR_OUT_OF_MEMORY: the step has been taken, not
 * to be repeated, but bodies went through each other in it; the next one asks for the memory again. */
LR_API lr_status lr_world_step(lr_world* world, float dt, uint32_t substeps);

/* A budget for the work of each step: a count of substeps of single bodies, whatever each of them costs, at most 2^48; 0, as at
 * first: none. From the next step on; part of snapshots. Where the batches that are due want more, each gets the fewest substeps that
 * keep falls as they are (lr_batch_set_rate), those that have waited longest first; nobody waits for ever. The same calls give the
 * same bits on every machine. A batch on whose single bodies forces act is stepped at once, even over the budget. docs/reference/stepping.md.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_world_set_budget(lr_world* world, uint64_t body_substeps);

/* What the last step did, and what it left out. Batches without bodies do not count. */
typedef struct lr_step_report {
    uint32_t struct_size;
    uint32_t batches_stepped;
    uint32_t batches_waiting;      /* not due, by their own divisors */
    uint32_t batches_passed_over;  /* due, but the budget did not reach them */
    uint64_t body_substeps;        /* done */
    uint64_t body_substeps_wanted; /* of the batches that were due, without a budget */
    double behind;                 /* s: how far the bodies that have waited longest are behind the world's time */
    double
        lost; /* s: the most that a batch lost in this step: bodies go in slow motion rather than in too long substeps */
} lr_step_report;

LR_API lr_status lr_step_report_init(lr_step_report* report, uint32_t struct_size);

/* report: initialised, or with struct_size set. Zeros before the first step, and after a snapshot was restored.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_world_get_step_report(const lr_world* world, lr_step_report* report);

/* A hash of the state of all bodies and the time index. Independent of the order of bodies in memory, of the processor
 * and of worker_count; equal hashes mean equal motion from here on, given equal worlds. Wind sources are part of it,
 * grids by the hash of their samples, the surface, and colliders.
 * LR_OK, LR_ERROR_NULL_ARGUMENT. */
LR_API lr_status lr_world_hash(const lr_world* world, uint64_t* out);

/* Bytes that lr_world_snapshot_save needs at present; 0 for null. */
LR_API uint64_t lr_world_snapshot_size(const lr_world* world);

/* Writes the world's state (bodies with their ids, time, wind, surface, gravity, tables, loads, forces, rules, emitter,
 * rates, budget, colliders with their ids, how batches meet them and each other) into `size` bytes at `memory`, any alignment.
 * Assets, how batches were created, threads and callbacks are not part of it, nor the samples of wind grids and the data of
 * hulls, heightfields and meshes, which are named by their hash. written: bytes used; may be null.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL. */
LR_API lr_status lr_world_snapshot_save(const lr_world* world, void* memory, uint64_t size, uint64_t* written);

/* Puts a saved state back, also into another world or process whose batches were created in the same order from equal
 * assets with equal capacities. Bodies, wind sources and colliders have the same ids as when it was saved; grids of
 * wind, hulls, heightfields and meshes must be in the world already, in any place. Checked whole before anything changes.
 * Allocates nothing where the world has held as much before. docs/reference/snapshots.md: which versions restore which snapshots.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_SNAPSHOT_FORMAT, LR_ERROR_SNAPSHOT_MISMATCH, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_world_snapshot_restore(lr_world* world, const void* memory, uint64_t size);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Recording: what was done to a world, to be done again elsewhere by lr_replay. docs/reference/snapshots.md          */

/* Takes the next `size` bytes of a recording, valid during the call only: append them to a file, or to a ring in memory.
 * Returns 0; anything else ends the recording. Called within functions that take the world, by their thread; with
 * LR_RECORD_CALLBACKS also by those that run wind and surface callbacks, never by two at a time. Must not call the library on
 * the same world, throw or longjmp. */
typedef int32_t (*lr_record_fn)(void* user, const void* bytes, uint64_t size);

/* What the wind and surface callbacks answer is recorded too, up to 72 bytes a body and substep each: without it the replay
 * of a world with callbacks stops where one is asked. */
#define LR_RECORD_CALLBACKS 1u

typedef struct lr_recording_desc {
    uint32_t struct_size;
    uint32_t flags;         /* bits LR_RECORD_*; initially LR_RECORD_CALLBACKS */
    uint32_t hash_interval; /* steps from one hash of the world in the recording to the next; 0: none; initially 1 */
    uint32_t reserved;      /* 0 */
    lr_record_fn write;     /* must be given */
    void* user;
} lr_recording_desc;

LR_API lr_status lr_recording_desc_init(lr_recording_desc* desc, uint32_t struct_size);

/* From now on every call that can change the world is handed to desc->write with its arguments before it is carried out, and
 * its status after it. At once: the world as it is, with the assets of its batches. May begin at any time. Takes 64 KiB of memory,
 * some bytes for each asset, and while it begins a copy of the assets and a snapshot. When `write` refuses, the recording
 * ends, a message is logged, and the world goes on.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->write), LR_ERROR_STRUCT_SIZE, LR_ERROR_INVALID_ARGUMENT (unknown flags; the world
 * is being recorded; `write` has refused), LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_world_record_start(lr_world* world, const lr_recording_desc* desc);

/* Ends a recording.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (none is under way: also where `write` has refused). */
LR_API lr_status lr_world_record_stop(lr_world* world);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Batches                                                                                                            */

#define LR_LOADS_DEFAULT 0     /* LR_LOADS_AERODYNAMIC in this version */
#define LR_LOADS_NONE 1        /* gravity, buoyancy and added mass only: Kirchhoff's equations */
#define LR_LOADS_LANGEVIN 2    /* the paper's turbulent loads, dimensionally repaired; docs/maintainers/physics.md, 4 */
#define LR_LOADS_AERODYNAMIC 3 /* quasi-steady drag and lift in a turbulent fluid; docs/maintainers/physics.md, 5 */

#define LR_CLOCK_SPEED 0 /* turbulence scales with the body's present speed through the fluid */
#define LR_CLOCK_AGE 1   /* the paper: turbulence follows the table at the body's age */

#define LR_TABLE_CLAMP 0 /* LR_CLOCK_AGE: hold the last sample after the end of the table */
#define LR_TABLE_LOOP 1  /* LR_CLOCK_AGE: begin again */

#define LR_INTEGRATOR_DEFAULT 0   /* LR_INTEGRATOR_SPLITTING in this version */
#define LR_INTEGRATOR_RK4 1       /* the paper's: fourth order, unstable at long steps, slow. In water: splitting */
#define LR_INTEGRATOR_SPLITTING 2 /* second order and stable at any step; docs/maintainers/numerics.md */

typedef struct lr_batch_desc {
    uint32_t struct_size;
    uint32_t capacity;     /* the most bodies at a time, 1 to 2^26; memory for all is taken at once */
    const lr_asset* asset; /* kept by reference until the batch ends */
    int32_t load_model;    /* LR_LOADS_*; initially LR_LOADS_DEFAULT */
    int32_t clock;         /* LR_CLOCK_*; initially LR_CLOCK_SPEED */
    int32_t table_end;     /* LR_TABLE_*; initially LR_TABLE_CLAMP */
    int32_t integrator;    /* LR_INTEGRATOR_*; initially LR_INTEGRATOR_DEFAULT */
    float damping_gain;    /* multiplies the turbulent damping, 0 to 100; initially 1 */
    float noise_gain;      /* multiplies the turbulent noise, 0 to 100; initially 1; 0 for repeatable single falls */
} lr_batch_desc;

LR_API lr_status lr_batch_desc_init(lr_batch_desc* desc, uint32_t struct_size);

/* out: receives the batch, 0 after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->asset), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_create(lr_world* world, const lr_batch_desc* desc, lr_batch* out);

/* Ends a batch with all its bodies. Those of batches that it met (lr_batch_set_pair_contact) wake. LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH. */
LR_API lr_status lr_batch_destroy(lr_world* world, lr_batch batch);

/* k-epsilon samples in the units of the bake. Arrays are copied. */
typedef struct lr_turbulence_table {
    uint32_t struct_size;
    uint32_t count;       /* samples, 1 to 65536 */
    const float* chi;     /* 1/s, turbulent frequency epsilon / k, `count` values >= 0 */
    const float* epsilon; /* m^2/s^3, dissipation rate, `count` values >= 0 */
    float dt;             /* s between samples, > 0 */
    float u0;             /* m/s, speed the table was made at, > 0: what LR_CLOCK_SPEED scales by */
    float l;              /* m, length the table was made with, > 0 */
    float c0;             /* Kolmogorov constant, > 0; initially 6.5, its limit at high Reynolds number */
    uint32_t stationary;  /* sample that LR_CLOCK_SPEED uses, < count; initially 0 */
    uint32_t reserved;    /* 0 */
} lr_turbulence_table;

LR_API lr_status lr_turbulence_table_init(lr_turbulence_table* table, uint32_t struct_size);

/* Replaces a batch's table; null puts the asset's own back. With AERODYNAMIC loads the table sets the velocity of the fluid
 * around the body, instead of the intensity in lr_aerodynamics.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_set_turbulence_table(lr_world* world, lr_batch batch, const lr_turbulence_table* table);

/* Coefficients of the AERODYNAMIC loads for a batch, in place of its asset's, from the next step on; copied. Null puts the
 * asset's own back. With intensity 0 and lr_load_gains.turbulence 1 a fall is the same for any seed. With other axes than the
 * body's, or another center than 0, a body of LR_ASSET_DIAGONAL takes the slower path of all others.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_set_aerodynamics(lr_world* world, lr_batch batch, const lr_aerodynamics* aerodynamics);

/* What the batch's coefficients are at present. aerodynamics: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_aerodynamics(const lr_world* world, lr_batch batch, lr_aerodynamics* aerodynamics);

/* Art control of the AERODYNAMIC loads: factors on top of the coefficients, so that motion stays that of some body. */
typedef struct lr_load_gains {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    float drag;        /* of translation, 0 to 100; initially 1 */
    float lift;        /* and its moment, 0 to 100; initially 1 */
    float spin_drag;   /* 0 to 100; initially 1 */
    float turbulence;  /* intensity of the body's own wake, 0 to 100; initially 1 */
} lr_load_gains;

LR_API lr_status lr_load_gains_init(lr_load_gains* gains, uint32_t struct_size);

/* From the next step on; null puts all at 1. LANGEVIN loads have their gains in lr_batch_desc.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_set_load_gains(lr_world* world, lr_batch batch, const lr_load_gains* gains);

/* How often a batch is stepped: level of detail for bodies that are far away, small, or out of sight. docs/reference/stepping.md.
 * divisor: 1 to 1024, at first 1. A batch of divisor n takes one substep where others take n: fewer in each step, or, where n is
 * more than the world's substeps, one in every so many steps, which makes up for all of them. No substep gets longer by that than
 * falls keep their statistics: 1/60 s, for bodies under 2.5 cm length_d / 1.5 m/s. A divisor beyond has no more effect.
 * From the next step on, at any time: a batch that waits makes up for all of it when next stepped. While it waits
 *  - views and lr_body_get_state have the bodies as they were last stepped, lr_batch_pace.behind ago, and bodies that are made
 *    or set are taken to be from then; transforms are moved on by that time with the bodies' velocities;
 *  - a force on one of its bodies ends the waiting, and acts with the impulse that it would have had in one step;
 *  - its rules, emitter and events wait too.
 * Part of snapshots.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_set_rate(lr_world* world, lr_batch batch, uint32_t divisor);

/* How a batch keeps up with its world. */
typedef struct lr_batch_pace {
    uint32_t struct_size;
    uint32_t divisor;       /* as set */
    uint32_t substeps;      /* in the last step of the world; 0: it waited */
    uint32_t waited;        /* steps since it was last stepped */
    double behind;          /* s: the same as time */
    double lost;            /* s, in all: what its bodies' clocks are slow by */
    uint64_t body_substeps; /* in all */
} lr_batch_pace;

LR_API lr_status lr_batch_pace_init(lr_batch_pace* pace, uint32_t struct_size);

/* pace: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_pace(const lr_world* world, lr_batch batch, lr_batch_pace* pace);

/* The state of a batch where it lies: arrays with one value a body, `count` of them, 64-byte aligned. Bodies are dense:
 * those that move come first, then those at rest, and where one leaves its part of them, the last of that part takes its
 * place. Pointers are valid until the next call that is not a query. */
typedef struct lr_batch_view {
    uint32_t struct_size;
    uint32_t count;              /* bodies */
    const float* position[3];    /* m, world frame: x, y, z */
    const float* orientation[4]; /* unit quaternion x, y, z, w, body to world */
    const float*
        velocity[3];      /* m/s, of the centre of mass, in the BODY frame: turn by the orientation for the world's */
    const float* spin[3]; /* rad/s, angular velocity, in the BODY frame */
    const float* scale;   /* uniform scale */
    const float* age;     /* s; of a body at rest some earlier one: lr_body_get_state has it exactly */
    const uint32_t* key;  /* what tells the noise of bodies apart */
    const lr_body* ids;
    uint32_t capacity;
    uint32_t reserved;
    uint64_t revision;    /* differs whenever bodies at rest have woken, ended, or changed their places */
    uint32_t awake_count; /* bodies [0, awake_count) move, [awake_count, count) are at rest: lr_body_set_rest */
    uint32_t reserved_1;
} lr_batch_view;

LR_API lr_status lr_batch_view_init(lr_batch_view* view, uint32_t struct_size);

/* view: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_view(const lr_world* world, lr_batch batch, lr_batch_view* view);

#define LR_TRANSFORM_POSITION_QUATERNION 0       /* 7 floats: position, quaternion x y z w */
#define LR_TRANSFORM_POSITION_QUATERNION_SCALE 1 /* 8 floats: the same and the scale */
#define LR_TRANSFORM_3X4_ROW_MAJOR 2             /* 12 floats: three rows of rotation times scale and translation */
#define LR_TRANSFORM_3X4_COLUMN_MAJOR 3          /* 12 floats: four columns of three */
#define LR_TRANSFORM_4X4_ROW_MAJOR 4             /* 16 floats; column vectors, translation in elements 3, 7, 11 */
#define LR_TRANSFORM_4X4_COLUMN_MAJOR 5          /* 16 floats; column vectors, translation in elements 12, 13, 14 */

/* Writes the transforms of the first `count` bodies of a batch, or of all where there are fewer, in the order of its view; of one that
 * waits (lr_batch_set_rate), moved on to the world's time. The mesh to be drawn must have its origin at the centre of mass
 * (lr_asset_info.center_of_mass).
 * An instance buffer keeps what was written before: where lr_batch_view.revision is that of the last time, bodies at rest then still
 * lie there, and it is enough to write as many as moved then or move now, the greater awake_count of the two. Else all: docs/reference/bodies.md.
 * Keep both numbers for each buffer that is written in turn.
 * dst: 4-byte aligned, room for `count` elements `stride` bytes apart.
 * stride: 0 for elements without gaps, else a multiple of 4, at least an element. written: elements written; may be
 * null.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (dst may be null only when nothing is to be written), LR_ERROR_STALE_BATCH,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_write_transforms(const lr_world* world, lr_batch batch, int32_t format, void* dst,
                                           uint64_t stride, uint32_t count, uint32_t* written);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Bodies                                                                                                             */

typedef struct lr_body_desc {
    uint32_t struct_size; /* the same in all elements of an array: it is the array's stride */
    uint32_t key;         /* tells its noise apart; initially 0: the world gives each body its own, in order of birth */
    float position[3];    /* m, of the centre of mass; initially 0 */
    float orientation[4]; /* quaternion x y z w, normalised when taken; initially 0 0 0 1 */
    float linear_velocity[3];  /* m/s, of the centre of mass; initially 0 */
    float angular_velocity[3]; /* rad/s, world frame; initially 0 */
    float scale;               /* uniform, 0.001 to 1000; mass goes with its cube; initially 1 */
    float age;                 /* s, 0 to 1e9; initially 0. Bodies grow no older than that */
    uint32_t reserved;         /* 0 */
} lr_body_desc;

LR_API lr_status lr_body_desc_init(lr_body_desc* desc, uint32_t struct_size);

/* Creates `count` bodies, all or none. descs: `count` elements. out_ids: receives `count` ids; may be null.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY. */
LR_API lr_status lr_body_create(lr_world* world, lr_batch batch, const lr_body_desc* descs, uint32_t count,
                                lr_body* out_ids);

/* Destroys `count` bodies of any batches, all or none: if one of them is stale, or given twice, nothing is destroyed. What lay on
 * them wakes. LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY. */
LR_API lr_status lr_body_destroy(lr_world* world, const lr_body* bodies, uint32_t count);

typedef struct lr_body_state {
    uint32_t struct_size;
    uint32_t key;              /* read only: ignored by lr_body_set_state */
    float position[3];         /* m, of the centre of mass, world frame */
    float orientation[4];      /* unit quaternion x y z w, body to world */
    float linear_velocity[3];  /* m/s, of the centre of mass, world frame */
    float angular_velocity[3]; /* rad/s, world frame */
    float scale;               /* 0.001 to 1000 */
    float age;                 /* s, 0 to 1e9 */
    uint32_t reserved;         /* 0 */
    int32_t resting;           /* LR_REST_*; read only */
} lr_body_state;

LR_API lr_status lr_body_state_init(lr_body_state* state, uint32_t struct_size);

/* LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_body_get_state(const lr_world* world, lr_body body, lr_body_state* state);

/* Sets everything but the key, and wakes the body. The quaternion is normalised. Positions up to 1e9 m, velocities up to
 * 1e6 m/s and rad/s are taken, here and by lr_body_create. For many bodies a frame, prefer forces and wind: this breaks
 * the physics by design.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_body_set_state(lr_world* world, lr_body body, const lr_body_state* state);

#define LR_REST_AWAKE 0
#define LR_REST_RESTING 1
#define LR_REST_HELD 2 /* read only: it has left physics, and lr_batch_set_fault_policy holds it where it was */

/* Puts bodies of any batches to rest, or wakes them, all or none; some may be so already, or be given twice. A body at
 * rest does not move, whatever acts on it, and costs a step nothing. Its velocities and the forces on it end. It wakes
 *  - by this function, lr_world_wake_box, and lr_body_set_state,
 *  - by a force, impulse or velocity on it that is not zero (lr_body_add_force, lr_batch_add_forces),
 *  - by a change of lr_batch_set_force, lr_world_set_gravity or lr_batch_set_pair_contact, with all others that it is about,
 *  - when it begins anew by its batch's rules,
 *  - by contact: colliders, wind. docs/reference/bodies.md.
 * It grows older, and the rules of its batch are for it too: they look at bodies at rest in every 16th step of the batch.
 * Bodies that wake and come to rest change indices in the view, not ids. Part of snapshots. The first body at rest of a
 * batch takes up to 25 bytes for each of the batch's capacity.
 * rest: LR_REST_*.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_INVALID_ARGUMENT,
 * LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_body_set_rest(lr_world* world, const lr_body* bodies, uint32_t count, int32_t rest);

/* Wakes all bodies at rest that reach into a box, each taken to be a cube that it can turn in: for what the world does not
 * know of, as footsteps and explosions. low, high: x, y, z of its corners, m, low <= high. woken: how many; may be null. It
 * takes time by what lies there, not by what rests elsewhere.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_world_wake_box(lr_world* world, const float* low, const float* high, uint32_t* woken);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Forces                                                                                                             */

/* What a force's numbers are. A body answers with the inertia of the fluid that moves along with it, (M + added)^-1 F;
 * accelerations and velocities come out as given, whatever the mass. The first two act over the whole next step, in
 * each substep at its own orientation, and are then gone; forces of several calls before a step add up. The last two
 * change the velocity at once. */
#define LR_FORCE_MODE_FORCE 0        /* N, N m */
#define LR_FORCE_MODE_ACCELERATION 1 /* m/s^2, rad/s^2 */
#define LR_FORCE_MODE_IMPULSE 2      /* N s, N m s */
#define LR_FORCE_MODE_VELOCITY 3     /* m/s, rad/s: added to the body's */

#define LR_FRAME_WORLD 0
#define LR_FRAME_BODY 1 /* turns with the body */

#define LR_FORCE_AT_POINT 1u /* `force` acts at `point`, not at the centre of mass; forces and impulses only */

/* A force and a torque on one body, at the body's true size: a body of scale 2 has eight times the mass. */
typedef struct lr_body_force {
    uint32_t struct_size; /* the same in all elements of an array: it is the array's stride */
    int32_t mode;         /* LR_FORCE_MODE_*; initially LR_FORCE_MODE_FORCE */
    lr_body body;
    int32_t frame;   /* LR_FRAME_*, of force, torque and point; initially LR_FRAME_WORLD */
    uint32_t flags;  /* LR_FORCE_*; initially 0 */
    float force[3];  /* initially 0 */
    float torque[3]; /* about the centre of mass; initially 0 */
    float point[3];  /* m; in the world frame a position, in the body frame from the centre of mass. Its arm is taken at
                          the time of the call */
    uint32_t reserved; /* 0 */
} lr_body_force;

LR_API lr_status lr_body_force_init(lr_body_force* force, uint32_t struct_size);

/* Puts `count` forces on bodies of any batches, all or none; a body may be there more than once. One of them may
 * give its body up to 1e9 m/s^2, torques as much over its length; an impulse up to 1e6 m/s and rad/s. Pending forces
 * are part of snapshots and of the world's hash. The first force or acceleration on a body of a batch takes 96 bytes
 * for each of the batch's capacity.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_body_add_force(lr_world* world, const lr_body_force* forces, uint32_t count);

/* The same for many bodies of one batch, in the order of its view. */
typedef struct lr_force_arrays {
    uint32_t struct_size;
    int32_t mode;           /* LR_FORCE_MODE_*; initially LR_FORCE_MODE_FORCE */
    int32_t frame;          /* LR_FRAME_*; initially LR_FRAME_WORLD */
    uint32_t first;         /* index in the view of the first body; initially 0 */
    uint32_t count;         /* bodies */
    uint32_t stride;        /* bytes from one body's value to the next's, a multiple of 4; initially 0: no gaps, 4 */
    const float* force[3];  /* x, y, z: `count` values each, not kept; all three or none */
    const float* torque[3]; /* alike; all three or none */
} lr_force_arrays;

LR_API lr_status lr_force_arrays_init(lr_force_arrays* arrays, uint32_t struct_size);

/* LR_OK, LR_ERROR_NULL_ARGUMENT (some of three pointers), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE,
 * LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also first + count over the batch's bodies),
 * LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_add_forces(lr_world* world, lr_batch batch, const lr_force_arrays* arrays);

/* What acts on every body of a batch. All initially 0, each component up to 1e9 in magnitude. */
typedef struct lr_batch_force {
    uint32_t struct_size;
    uint32_t reserved;             /* 0 */
    float force[3];                /* N, world frame */
    float torque[3];               /* N m, world frame */
    float acceleration[3];         /* m/s^2, world frame; of the body, whatever its mass */
    float angular_acceleration[3]; /* rad/s^2, world frame */
    float body_force[3];           /* the same four in the body frame */
    float body_torque[3];
    float body_acceleration[3];
    float body_angular_acceleration[3];
} lr_batch_force;

LR_API lr_status lr_batch_force_init(lr_batch_force* force, uint32_t struct_size);

/* From the next step on, until changed; copied. Null ends it. A change wakes the batch's bodies. Part of snapshots.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_set_force(lr_world* world, lr_batch batch, const lr_batch_force* force);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Contact: what bodies land on. docs/maintainers/contact.md                                                          */

/* Handles are values, 0 is never one, and those of destroyed colliders are recognised. */
typedef uint64_t lr_collider;

/* Each in its own frame, which `position` and `orientation` put into the world. size[] is
 *   PLANE        nothing: all below its y = 0 is solid, without bounds
 *   SPHERE       radius
 *   CAPSULE      radius, half length of its axis: from (0, -size[1], 0) to (0, size[1], 0)
 *   BOX          half extents along x, y, z
 *   HULL         nothing: the convex hull of vertices
 *   HEIGHTFIELD  nothing: solid below its surface, along -y. Sample (i, k) lies at (i spacing[0], heights[i + counts[0] k],
 *                k spacing[1]); each cell is two triangles, parted from (i, k) to (i + 1, k + 1)
 *   MESH         nothing: triangles without an inside, met from both sides; which way round they are does not matter
 */
#define LR_COLLIDER_PLANE 1
#define LR_COLLIDER_SPHERE 2
#define LR_COLLIDER_CAPSULE 3
#define LR_COLLIDER_BOX 4
#define LR_COLLIDER_HULL 5
#define LR_COLLIDER_HEIGHTFIELD 6
#define LR_COLLIDER_MESH 7

#define LR_MAX_COLLIDERS 67108864u         /* in a world, at a time */
#define LR_MAX_HULL_VERTICES 256u          /* given for one hull */
#define LR_MAX_COLLIDER_VERTICES 67108864u /* of one mesh; and triangles of one, and heights of one heightfield */

/* Fields that a kind does not have are not used. */
typedef struct lr_collider_desc {
    uint32_t struct_size;     /* the same in all elements of an array: it is the array's stride */
    int32_t kind;             /* LR_COLLIDER_*; initially 0, which is none of them */
    float position[3];        /* m, up to 1e9 in magnitude; initially 0 */
    float orientation[4];     /* quaternion x y z w, normalised when taken; initially 0 0 0 1 */
    float linear_velocity[3]; /* m/s, of the frame's origin, up to 1e6; initially 0. It moves so until told otherwise */
    float angular_velocity[3]; /* rad/s, world frame, up to 1e6; initially 0 */
    float size[3];             /* m, > 0, up to 1e6; initially 0 */
    float friction;            /* 0 to 10; initially 0.5 */
    float restitution;         /* 0 to 1; initially 0.2 */
    uint32_t layers;           /* bits: it meets bodies that have one of them; initially 1 */
    uint32_t flags;            /* 0 */
    uint32_t vertex_count;     /* hull: 4 to LR_MAX_HULL_VERTICES; mesh: 3 to LR_MAX_COLLIDER_VERTICES */
    uint32_t triangle_count;   /* mesh: 1 to LR_MAX_COLLIDER_VERTICES */
    uint32_t counts[2];        /* heightfield: samples along x and z, each >= 2 */
    float spacing[2];          /* heightfield: m between samples, 1e-6 to 1e6; initially 1 */
    const float* vertices;     /* m, x y z each, up to 1e6 in magnitude; copied, as are the others */
    const uint32_t* indices;   /* 3 a triangle, each < vertex_count */
    const float* heights;      /* m, up to 1e6 in magnitude; x varies fastest */
} lr_collider_desc;

LR_API lr_status lr_collider_desc_init(lr_collider_desc* desc, uint32_t struct_size);

/* Creates `count` colliders, all or none. They are there from the next step on. Hulls, heightfields and meshes that are equal
 * share one copy of their data. descs: `count` elements. out_ids: receives `count` ids; may be null.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT (also arrays that the kind needs), LR_ERROR_STRUCT_SIZE,
 * LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also a hull that is flat: thinner than 1e-4 of its largest extent; a mesh
 * with an index out of range, or no triangle with an area), LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_collider_create(lr_world* world, const lr_collider_desc* descs, uint32_t count,
                                    lr_collider* out_ids);

/* Destroys `count` colliders, all or none: if one of them is stale, or given twice, nothing is destroyed.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER. */
LR_API lr_status lr_collider_destroy(lr_world* world, const lr_collider* colliders, uint32_t count);

#define LR_MOVE_TO 1       /* over the next step it goes from where it is to this pose, and stands still afterwards */
#define LR_MOVE_PLACE 2    /* it is there at once, and has these velocities from now on */
#define LR_MOVE_VELOCITY 3 /* it stays where it is, and has these velocities from now on */

/* How one collider moves. Within a step its position goes evenly from where it begins to where it ends, and its
 * orientation by the normalised linear quaternion, the shorter way round: what turns by more than half a turn in a step
 * seems to turn by less. */
typedef struct lr_collider_motion {
    uint32_t struct_size; /* the same in all elements of an array: it is the array's stride */
    int32_t mode;         /* LR_MOVE_*; initially LR_MOVE_TO */
    lr_collider collider;
    float position[3];         /* m, as in lr_collider_desc; LR_MOVE_TO, LR_MOVE_PLACE; initially 0 */
    float orientation[4];      /* alike; initially 0 0 0 1 */
    float linear_velocity[3];  /* m/s; LR_MOVE_PLACE, LR_MOVE_VELOCITY; initially 0 */
    float angular_velocity[3]; /* rad/s; alike */
    uint32_t reserved;         /* 0 */
} lr_collider_motion;

LR_API lr_status lr_collider_motion_init(lr_collider_motion* motion, uint32_t struct_size);

/* Moves `count` colliders, all or none, in this order: of several motions of one collider the last holds. Planes that turn
 * keep all bodies of the world from the fast path while they do.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_STALE_COLLIDER, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_collider_move(lr_world* world, const lr_collider_motion* motions, uint32_t count);

typedef struct lr_collider_state {
    uint32_t struct_size;
    int32_t kind;              /* LR_COLLIDER_* */
    float position[3];         /* m, world frame */
    float orientation[4];      /* unit quaternion x y z w, collider to world */
    float linear_velocity[3];  /* m/s, that it has until told otherwise; 0 while LR_MOVE_TO is pending */
    float angular_velocity[3]; /* rad/s, world frame; alike */
    float friction;
    float restitution;
    uint32_t layers;
    uint32_t flags; /* 0 */
} lr_collider_state;

LR_API lr_status lr_collider_state_init(lr_collider_state* state, uint32_t struct_size);

/* state: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_collider_get_state(const lr_world* world, lr_collider collider, lr_collider_state* state);

/* What can be changed of a collider besides its motion. */
typedef struct lr_collider_surface {
    uint32_t struct_size;
    uint32_t layers;   /* as in lr_collider_desc; initially 1 */
    float friction;    /* initially 0.5 */
    float restitution; /* initially 0.2 */
} lr_collider_surface;

LR_API lr_status lr_collider_surface_init(lr_collider_surface* surface, uint32_t struct_size);

/* Gives `count` colliders the same surface, all or none, from the next step on.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_collider_set_surface(lr_world* world, const lr_collider* colliders, uint32_t count,
                                         const lr_collider_surface* surface);

#define LR_CONTACT_NEVER_REST 1u /* bodies move until they are put to rest by lr_body_set_rest */

/* How the bodies of a batch meet colliders. Of a pair, friction is the geometric mean of both and restitution the larger.
 * Bodies touch with their hull, reduced to 32 points at most, or as the ellipsoid that they are. */
typedef struct lr_batch_contact {
    uint32_t struct_size;
    uint32_t layers;   /* bit mask: colliders that are in one of these are met; initially all; 0: none */
    float friction;    /* coefficient of Coulomb friction, 0 to 10; initially 0.5 */
    float restitution; /* speed after over speed before an impact, 0 to 1; initially 0.1 */
    float
        rolling_resistance; /* moment against rolling and spinning over normal force and a lever, 0 to 10; initially 0.05.
                               The lever is the geometric mean of reach and half of the least width: a sphere's radius */
    uint32_t flags;         /* LR_CONTACT_*; initially 0 */
    float ground_effect; /* the air that a sheet must press away before it lies, 0 to 1 of what the flow over planes and
                                 heightfields gives in theory; initially 0. docs/maintainers/contact.md */
    uint32_t reserved;   /* 0 */
} lr_batch_contact;

LR_API lr_status lr_batch_contact_init(lr_batch_contact* contact, uint32_t struct_size);

/* From the next step on; copied. Null is what a batch has initially. Wakes the batch's bodies at rest. Part of snapshots.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_set_contact(lr_world* world, lr_batch batch, const lr_batch_contact* contact);

/* contact: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_contact(const lr_world* world, lr_batch batch, lr_batch_contact* contact);

/* Whether bodies of `a` and of `b` meet each other, from the next step on; their order does not matter, and a == b are the
 * bodies of one batch among themselves. Initially none do. Friction, restitution and rolling resistance are those of
 * lr_batch_contact: of a pair, friction is the geometric mean of both and restitution the larger. Layers are for colliders alone.
 * Bodies of batches that are stepped at different rates (lr_batch_set_rate), or wait for a budget, meet only while one of both is
 * at rest. A change wakes the bodies at rest of both batches, and the end of one batch those of the other. Part of snapshots.
 * The first pair of a batch takes 28 bytes for each of its capacity, and up to 75 more unless there have been colliders.
 * docs/maintainers/contact.md
 * enabled: 0 or 1.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH (either), LR_ERROR_INVALID_ARGUMENT (enabled),
 * LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_set_pair_contact(lr_world* world, lr_batch a, lr_batch b, int32_t enabled);

/* enabled: receives 0 or 1; unchanged after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH (either). */
LR_API lr_status lr_batch_get_pair_contact(const lr_world* world, lr_batch a, lr_batch b, int32_t* enabled);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Contact events: what touched, left, landed, woke and ended in a step. docs/reference/bodies.md                     */

#define LR_CONTACT_BEGIN 1 /* a body touches a collider that it did not touch at the end of the step before */
#define LR_CONTACT_END 2   /* it no longer does, or the collider has been destroyed, whose id is then stale */
#define LR_BODY_LANDED 3   /* it has come to rest by itself */
#define LR_BODY_WOKE 4     /* it has left rest since the step before, whatever for */
#define LR_BODY_KILLED 5   /* its batch's rules have ended it; with LR_END_RESPAWN it goes on with the same id */
#define LR_BODY_FAULTED 6  /* it has left physics: lr_batch_set_fault_policy */

/* Bits for lr_world_set_contact_events. */
#define LR_EVENTS_BEGIN 1u
#define LR_EVENTS_END 2u
#define LR_EVENTS_LANDED 4u
#define LR_EVENTS_WOKE 8u
#define LR_EVENTS_KILLED 16u
#define LR_EVENTS_FAULTED 32u
#define LR_EVENTS_ALL 63u

/* Never changes: 64 bytes, an element of arrays without gaps. */
typedef struct lr_contact_event {
    int32_t kind; /* LR_CONTACT_*, LR_BODY_* */
    lr_batch batch;
    lr_body body;         /* stale where it has been destroyed */
    lr_collider collider; /* LR_CONTACT_*; else 0 */
    float position
        [3]; /* m, world frame: of LR_CONTACT_BEGIN where they touch, else of the centre of mass; of one that has left
                             physics where that was last sane */
    float normal[3];      /* LR_CONTACT_BEGIN: unit, world frame, from the collider to the body; else 0 */
    float speed;          /* m/s, LR_CONTACT_BEGIN: at which they approach each other along the normal, >= 0; else 0 */
    float impulse;        /* N s, LR_CONTACT_BEGIN: along the normal, of the substep in which they meet; else 0 */
    uint32_t reserved[2]; /* 0 */
} lr_contact_event;

/* Has events kept, at most `capacity` of a step, from now on: contacts that there are already do not begin again. kinds: bits
 * LR_EVENTS_*. capacity 0 ends it. All memory is taken here and by lr_batch_create, 225 bytes for each of a batch's capacity and 64
 * for each event, and a step takes none. Neither part of snapshots nor of the world's hash.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (unknown bits; no bit but a capacity),
 * LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_world_set_contact_events(lr_world* world, uint32_t capacity, uint32_t kinds);

typedef struct lr_contact_event_list {
    uint32_t struct_size;
    uint32_t count;
    const lr_contact_event* events; /* of the last step; null before lr_world_set_contact_events */
    uint64_t lost;       /* events of the last step for which there was no room: the last ones in their order */
    uint64_t total_lost; /* since lr_world_set_contact_events */
} lr_contact_event_list;

LR_API lr_status lr_contact_event_list_init(lr_contact_event_list* list, uint32_t struct_size);

/* Valid until the next call that is not a query; empty after lr_world_snapshot_restore. In order of batches (their place in the
 * world's table), then of the bodies' keys, then of kinds, then of colliders' slots: independent of workers, processors and where
 * bodies lie in memory. Bodies that share a key are in order of their slots.
 * Contact is looked at after each substep, and ends only at the end of a step: what bounces within one begins once. What touches
 * and leaves within a step begins and ends in it. A body at rest still touches what it lies on. Of a body that ends there is one
 * LR_BODY_KILLED and nothing else, but LR_BODY_FAULTED where that is why; of those destroyed by lr_body_destroy there is nothing. At
 * most four colliders of a body count, those that press it most; other bodies that it touches count as one of the four, and neither
 * begin nor end. A body that comes to rest on other bodies has landed.
 * list: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_world_get_contact_events(const lr_world* world, lr_contact_event_list* list);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Queries: rays, and what is in a sphere or box. docs/reference/bodies.md                                            */

#define LR_RAY_BODIES 1u
#define LR_RAY_COLLIDERS 2u

typedef struct lr_ray {
    uint32_t struct_size;     /* the same in all elements of an array: it is the array's stride */
    uint32_t flags;           /* LR_RAY_*, what it can hit; initially both */
    float origin[3];          /* m, up to 1e9 in magnitude; initially 0 */
    float direction[3];       /* of any length from 1e-6 to 1e6; initially 0, -1, 0 */
    float max_distance;       /* m, 0 to 1e9; initially 1e9 */
    lr_batch batch;           /* whose bodies it can hit; initially 0: all */
    uint32_t collider_layers; /* bits: it meets colliders that have one of them; initially all */
    uint32_t reserved;        /* 0 */
} lr_ray;

LR_API lr_status lr_ray_init(lr_ray* ray, uint32_t struct_size);

/* Never changes: 48 bytes, an element of arrays without gaps. All 0 where nothing is hit. */
typedef struct lr_ray_hit {
    lr_body body;         /* 0 where it is a collider */
    lr_collider collider; /* 0 where it is a body */
    float distance;       /* m, from the ray's origin */
    float position[3];    /* m, world frame */
    float
        normal[3]; /* unit, world frame, out of what is hit; against the ray where that begins inside, at distance 0 */
    uint32_t reserved; /* 0 */
} lr_ray_hit;

/* What each ray hits first. Bodies are what can touch colliders of them: the hull of their asset, or an ellipsoid (docs/maintainers/contact.md);
 * those of batches that wait (lr_batch_set_rate) are where they were stepped last. Planes and heightfields are solid below their surface,
 * meshes are met from both sides. Colliders are where the last step or lr_collider_move has put them. Of equal distances bodies come
 * before colliders, then the order is that of batches and keys, or of colliders' slots.
 * rays: `count` elements. hits: receives `count` elements.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
 * LR_ERROR_STALE_BATCH: then no hit is written. */
LR_API lr_status lr_world_ray_cast(const lr_world* world, const lr_ray* rays, uint32_t count, lr_ray_hit* hits);

#define LR_OVERLAP_SPHERE 1 /* size[0]: radius */
#define LR_OVERLAP_BOX 2    /* size: half extents along its own axes */

typedef struct lr_overlap_desc {
    uint32_t struct_size;
    int32_t shape;        /* LR_OVERLAP_*; initially LR_OVERLAP_SPHERE */
    float position[3];    /* m, of its middle, up to 1e9 in magnitude; initially 0 */
    float orientation[4]; /* of a box, x y z w, normalised when taken; initially 0 0 0 1 */
    float size[3];        /* m, > 0, up to 1e6; initially 1 */
    lr_batch batch;       /* whose bodies are looked for; initially 0: all */
    uint32_t reserved;    /* 0 */
} lr_overlap_desc;

LR_API lr_status lr_overlap_desc_init(lr_overlap_desc* desc, uint32_t struct_size);

/* All bodies of which a part is in a sphere or box, in order of batches, then keys, then slots. They are the same as for rays.
 * bodies: room for `capacity` ids; may be null when that is 0. count: receives how many there are.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_STALE_BATCH,
 * LR_ERROR_BUFFER_TOO_SMALL: *count is set, and `bodies` holds no meaning. */
LR_API lr_status lr_world_overlap(const lr_world* world, const lr_overlap_desc* desc, lr_body* bodies,
                                  uint32_t capacity, uint32_t* count);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Births and ends: storms that run by themselves. docs/reference/bodies.md                                           */

#define LR_END_DESTROY 0 /* the body is destroyed, its id stale */
#define LR_END_RESPAWN 1 /* the body begins anew where the batch's emitter says, at age 0, with the same id and key */

#define LR_VOLUME_PLANE 0  /* inside: behind the plane through `center`, away from its normal `size` */
#define LR_VOLUME_BOX 1    /* axis-aligned; size: half extents */
#define LR_VOLUME_SPHERE 2 /* size[0]: radius */

#define LR_KILL_INSIDE 0
#define LR_KILL_OUTSIDE 1

typedef struct lr_kill_volume {
    int32_t shape;   /* LR_VOLUME_* */
    int32_t side;    /* LR_KILL_*: where bodies end */
    float center[3]; /* m, up to 1e9 in magnitude */
    float size[3];   /* m; of a plane its normal, of any length but 0 */
} lr_kill_volume;

#define LR_MAX_KILL_VOLUMES 8u

/* When the bodies of a batch end. A body that has left physics ends under any rules, unless lr_batch_set_fault_policy says
 * that it is held. */
typedef struct lr_batch_rules {
    uint32_t struct_size;
    int32_t action;                              /* LR_END_*; initially LR_END_DESTROY */
    float max_age;                               /* s, up to 1e9; initially 0: no limit */
    uint32_t volume_count;                       /* used part of `volumes`; initially 0 */
    lr_kill_volume volumes[LR_MAX_KILL_VOLUMES]; /* by the centre of mass */
} lr_batch_rules;

LR_API lr_status lr_batch_rules_init(lr_batch_rules* rules, uint32_t struct_size);

/* Bodies are judged at the end of each step, those at rest (lr_body_set_rest) in one of 16 of their batch. Copied; null
 * ends the rules. Part of snapshots. The first rules or emitter of a batch take 24 bytes for each of its capacity; later
 * calls, say to move a volume along with a camera, none.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT (also LR_END_RESPAWN without an emitter), LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_set_rules(lr_world* world, lr_batch batch, const lr_batch_rules* rules);

#define LR_FAULT_AUTO 0   /* as LR_FAULT_REMOVE in a batch with rules, as LR_FAULT_FREEZE in others */
#define LR_FAULT_FREEZE 1 /* it is held where it last was sane */
#define LR_FAULT_REMOVE 2 /* it ends: respawns where the batch's rules do that, else is destroyed */

/* What becomes of a body that has left physics: forces beyond all measure, a scheme that blows up, a collider that shoots it out of
 * the world. Every body is judged in each step, and after impulses: a number that is not finite, a coordinate over 1e10 m, a velocity
 * over 2e6 m/s or 1e9 rad/s, or an orientation that is none must not be seen. At the end of the step it is told by LR_BODY_FAULTED, counted
 * in lr_batch_events, and logged once for all; others are not touched by it. docs/reference/bodies.md
 * A body that is held has the position and orientation of the beginning of that step or substep, and no velocity. Nothing moves or
 * touches it, it moves and touches nothing, forces on it are taken and have no effect; it grows older, and rules may end it.
 * lr_body_set_state sets it free, and lr_body_set_rest puts it to rest like any other. lr_body_state.resting tells.
 * Initially LR_FAULT_AUTO. From the next step on, also for the others; those that are held stay so. Part of snapshots and hash.
 * policy: LR_FAULT_*. LR_FAULT_REMOVE takes memory as lr_batch_set_rules.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_set_fault_policy(lr_world* world, lr_batch batch, int32_t policy);

/* policy: receives LR_FAULT_*; unchanged after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH. */
LR_API lr_status lr_batch_get_fault_policy(const lr_world* world, lr_batch batch, int32_t* policy);

#define LR_EMIT_POINT 0
#define LR_EMIT_BOX 1 /* the first three fill their shape evenly */
#define LR_EMIT_SPHERE 2
#define LR_EMIT_DISC 3           /* in the plane of the shape's own x and y */
#define LR_EMIT_BOX_SURFACE 4    /* evenly */
#define LR_EMIT_SPHERE_SURFACE 5 /* evenly if its three sizes are equal */

#define LR_POSE_RANDOM 0 /* every orientation alike */
#define LR_POSE_FIXED 1  /* body_orientation */

/* How bodies of a batch are born. What is drawn for a body depends on the world's seed, its key, and how often it has
 * respawned, and on nothing else. */
typedef struct lr_emitter_desc {
    uint32_t struct_size;
    int32_t shape;              /* LR_EMIT_*; initially LR_EMIT_POINT */
    float position[3];          /* m, centre of the shape; initially 0 */
    float orientation[4];       /* of the shape, x y z w, normalised when taken; initially 0 0 0 1 */
    float size[3];              /* m, half extents or semi-axes along the shape's own axes, 0 to 1e9; initially 0 */
    int32_t pose;               /* LR_POSE_*, of the bodies; initially LR_POSE_RANDOM */
    float body_orientation[4];  /* body to world, normalised when taken; initially 0 0 0 1 */
    float direction[3];         /* of the velocity, world frame, of any length but 0; initially 0, -1, 0 */
    float spread;               /* rad, half angle of a cone about `direction`, filled evenly, 0 to pi; initially 0 */
    float speed_min, speed_max; /* m/s, evenly between; initially 0 */
    float spin_min, spin_max;   /* rad/s, evenly between, about any axis alike; initially 0 */
    float scale_min, scale_max; /* evenly between; initially 1 */
    float rate;                 /* births per second, 0 to 1e9; initially 0: bodies respawn, but none are added */
    float burst_interval;       /* s between bursts, >= 1e-4 */
    uint32_t burst_count;       /* births at once in each burst; initially 0: no bursts */
    uint32_t reserved;          /* 0 */
} lr_emitter_desc;

LR_API lr_status lr_emitter_desc_init(lr_emitter_desc* desc, uint32_t struct_size);

/* Bodies are born at the end of each step, after others have ended, up to the batch's capacity; those that find no room
 * are not born later. Their keys are the world's next. Copied; another emitter carries on with the fraction of a body
 * that is due and with the time since the last burst; null ends it. Part of snapshots. Memory: as lr_batch_set_rules.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT (also null while the rules respawn), LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_set_emitter(lr_world* world, lr_batch batch, const lr_emitter_desc* desc);

/* Bears `count` bodies now, all or none. out_ids: receives `count` ids; may be null.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT (no emitter),
 * LR_ERROR_CAPACITY. */
LR_API lr_status lr_batch_emit(lr_world* world, lr_batch batch, uint32_t count, lr_body* out_ids);

/* What rules and emitter did in the last step, and since the batch began. */
typedef struct lr_batch_events {
    uint32_t struct_size;
    uint32_t born;      /* by rate and bursts */
    uint32_t destroyed; /* by the rules */
    uint32_t respawned;
    uint32_t missed; /* births for which there was no room */
    /* Why bodies ended: the first cause that held, in this order. */
    uint32_t by_not_finite; /* bodies that have left physics: lr_batch_set_fault_policy */
    uint32_t by_age;
    uint32_t by_volume[LR_MAX_KILL_VOLUMES];
    uint32_t reserved;
    uint64_t total_born; /* with those of lr_batch_emit */
    uint64_t total_destroyed;
    uint64_t total_respawned;
    uint64_t total_missed;
    const lr_body* ended_ids; /* destroyed or respawned in the last step: destroyed + respawned of them, in no order */
    const lr_body* born_ids;  /* `born` of them */
    uint32_t faulted;         /* bodies that have left physics in the last step, held or ended */
    uint32_t reserved_1;
    uint64_t total_faulted; /* since the batch began */
} lr_batch_events;

LR_API lr_status lr_batch_events_init(lr_batch_events* events, uint32_t struct_size);

/* Lists are valid until the next call that is not a query. All but faults is 0 and null for a batch that never had rules or an
 * emitter. Totals are part of snapshots; after a restore there are no events of the last step.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_events(const lr_world* world, lr_batch batch, lr_batch_events* events);

#ifdef __cplusplus
}
#endif

#endif /* LANGEVIN_RIGID_H */
