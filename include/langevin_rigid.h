/*
 * Langevin Rigid simulates light bodies in air and water: leaves, paper, petals, confetti and sinking things that
 * flutter, glide and tumble. Thousands to a million of them at a time, with the same bits on every machine.
 *
 * SPDX-License-Identifier: MIT
 *
 * The functions that research needs and a game does not are in langevin_rigid_research.h: bodies from given matrices,
 * coefficients of the loads, turbulence tables.
 *
 * How to use it
 *   1. Load an asset that `lr_bake` made from a mesh, or create an ellipsoid without a file.
 *   2. Create a world, and in it one batch for each asset. A batch holds all bodies of one asset.
 *   3. Create bodies. Each frame, step the world and write the transforms straight into an instance buffer.
 *
 * Units        SI: metre, kilogram, second, radian. Gravity is a vector; no axis is special.
 * Frames       World frame, unless a field says "body frame". The body frame has its origin at the centre of mass and
 *              the axes of the authored mesh. Right-handed. Orientations are unit quaternions x, y, z, w that rotate
 *              vectors from the body frame to the world frame.
 * Ownership    The caller destroys what it creates. Functions keep no pointers passed to them, unless they say so.
 * Structs      Each struct begins with `struct_size`. Its `_INIT` macro sets the defaults (lr_body_desc desc =
 *              LR_BODY_DESC_INIT), and so does its `_init` function, called with sizeof. New fields are only appended.
 *              A larger struct from a newer header is accepted if its unknown tail is 0.
 * Errors       Functions return LR_OK or a negative lr_status. A failed call changes nothing, unless its comment says
 *              otherwise. Nothing aborts, throws or prints.
 * Threads      One thread at a time may use a world; different worlds may be used at the same time. Assets are
 *              immutable: any number of worlds and threads may share them. lr_world_desc.checks detects misuse during
 *              development: calls on a world may then also return LR_ERROR_CONCURRENT_USE or LR_ERROR_REENTRANT.
 * Determinism  The same calls on the same library version give the same bits on every processor, with any number of
 *              workers, in any order of bodies in memory. See docs/maintainers/numerics.md.
 */
#ifndef LANGEVIN_RIGID_H
#define LANGEVIN_RIGID_H

#include <stdint.h>

#if defined(LR_STATIC) /* the static library, or the sources compiled into a program */
#define LR_API
#elif defined(_WIN32)
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
#define LR_VERSION_MINOR 2
#define LR_VERSION_PATCH 0

/* Version of the loaded library: major << 22 | minor << 12 | patch. Compare it with the macros above when you load the
 * library at run time. A different major version has a different ABI; before 1.0, so has a different minor version.
 * Any thread. */
LR_API uint32_t lr_version(void);

/* LR_OK, or a negative error. Values never change. */
typedef int32_t lr_status;
enum {
    LR_OK = 0,                          /* success */
    LR_ERROR_NULL_ARGUMENT = -1,        /* a required pointer is null */
    LR_ERROR_STRUCT_SIZE = -2,          /* struct_size is of no release, or an unknown tail is not 0: see LR_..._INIT */
    LR_ERROR_INVALID_ARGUMENT = -3,     /* a value is out of range */
    LR_ERROR_NOT_FINITE = -4,           /* a number is NaN or infinite */
    LR_ERROR_OUT_OF_MEMORY = -5,        /* out of memory: the allocator returned null */
    LR_ERROR_STALE_BODY = -6,           /* the body was destroyed, or never existed */
    LR_ERROR_STALE_BATCH = -7,          /* the batch was destroyed, or never existed */
    LR_ERROR_CAPACITY = -8,             /* the batch, or the world's table of batches, is full */
    LR_ERROR_BUFFER_TOO_SMALL = -9,     /* the caller's buffer cannot hold the result */
    LR_ERROR_FILE_NOT_FOUND = -10,      /* no file at that path */
    LR_ERROR_FILE_READ = -11,           /* the file exists but cannot be read */
    LR_ERROR_ASSET_FORMAT = -12,        /* not an asset file: too short, or another kind of file */
    LR_ERROR_ASSET_VERSION = -13,       /* made for a newer library */
    LR_ERROR_ASSET_CORRUPT = -14,       /* an asset file, but damaged */
    LR_ERROR_ASSET_INVALID = -15,       /* an undamaged asset file with numbers that no body can have */
    LR_ERROR_SNAPSHOT_FORMAT = -16,     /* not a snapshot, damaged, or of another version */
    LR_ERROR_SNAPSHOT_MISMATCH = -17,   /* the snapshot's world has other batches, capacities or assets */
    LR_ERROR_UNSUPPORTED = -18,         /* not available on this processor or in this build */
    LR_ERROR_THREADS = -19,             /* the worker threads could not be started */
    LR_ERROR_TIMESTEP_ZERO = -20,       /* dt is 0: while paused, do not step */
    LR_ERROR_TIMESTEP_NEGATIVE = -21,   /* dt is negative */
    LR_ERROR_TIMESTEP_NOT_FINITE = -22, /* dt is NaN or infinite */
    LR_ERROR_TIMESTEP_TOO_LARGE = -23,  /* dt / substeps exceeds LR_MAX_SUBSTEP */
    LR_ERROR_SUBSTEPS = -24,            /* substeps is 0 or exceeds LR_MAX_SUBSTEPS */
    LR_ERROR_INTERNAL = -25,            /* a bug in the library: please report it */
    LR_ERROR_STALE_WIND_SOURCE = -26,   /* the wind source was removed, or never existed */
    LR_ERROR_STALE_COLLIDER = -27,      /* the collider was destroyed, or never existed */
    LR_ERROR_CONCURRENT_USE = -28,      /* another thread is inside a call on this world: see LR_CHECK_THREADS */
    LR_ERROR_REENTRANT = -29,           /* called from one of this world's callbacks: see LR_CHECK_THREADS */
};

#define LR_MAX_SUBSTEP 1.0f    /* s: the largest dt / substeps */
#define LR_MAX_SUBSTEPS 65536u /* the most substeps in one step */

/* A short English phrase for a status, without a full stop. Unknown values give "unknown status". Never null; static
 * storage. Any thread. */
LR_API const char* lr_status_string(lr_status status);

/* The text of the calling thread's last failed call: the function and the reason, as the log has it. Calls that succeed
 * leave it alone. Never null, empty before the first failure, cut after 255 bytes. Valid until the thread's next failed
 * call. Any thread. */
LR_API const char* lr_last_error(void);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Types                                                                                                              */

typedef struct lr_world lr_world;
typedef struct lr_asset lr_asset;

/* Handles: each is a number in a struct of its own, so that mixing them up does not compile. Pass them by value. Store
 * and compare `id`; its bits mean nothing to a caller. id 0 is never valid and stands for "none". A handle of something
 * destroyed is stale: that is detected, and it is never followed. The limit: a stale handle is valid again, for another
 * thing, once its place has been taken anew 262,143 times by a batch, 16.7 million times by a body, 33 million times by
 * a wind source or 4 billion times by a collider. */

/* Handle of a batch. */
typedef struct lr_batch {
    uint32_t id;
} lr_batch;

/* Handle of a body. */
typedef struct lr_body {
    uint64_t id;
} lr_body;

/* Handle of a collider. */
typedef struct lr_collider {
    uint64_t id;
} lr_collider;

/* Handle of a wind source. */
typedef struct lr_wind_source {
    uint32_t id;
} lr_wind_source;

#ifdef __cplusplus
extern "C++" {
/* clang-format off */
inline bool operator==(lr_batch a, lr_batch b) { return a.id == b.id; }
inline bool operator!=(lr_batch a, lr_batch b) { return a.id != b.id; }
inline bool operator==(lr_body a, lr_body b) { return a.id == b.id; }
inline bool operator!=(lr_body a, lr_body b) { return a.id != b.id; }
inline bool operator==(lr_collider a, lr_collider b) { return a.id == b.id; }
inline bool operator!=(lr_collider a, lr_collider b) { return a.id != b.id; }
inline bool operator==(lr_wind_source a, lr_wind_source b) { return a.id == b.id; }
inline bool operator!=(lr_wind_source a, lr_wind_source b) { return a.id != b.id; }
/* clang-format on */
}
#endif

/* The allocator of a world. Set both functions, or neither to use the C library's.
 * `allocate` returns `size` bytes aligned to `alignment` (a power of two, at most 128), or null.
 * `release` receives the same size and alignment as the matching `allocate`. Both are called only on the thread that
 * calls the library. lr_world_step calls them only when more bodies touch each other than ever before
 * (lr_batch_set_body_contact). Neither may call the library on the same world. */
typedef struct lr_allocator {
    void* user;
    void* (*allocate)(void* user, uint64_t size, uint64_t alignment);
    void (*release)(void* user, void* memory, uint64_t size, uint64_t alignment);
} lr_allocator;

/* Runs the world's tasks on an engine's job system instead of on threads of its own: docs/reference/stepping.md. Set
 * both functions or neither.
 *
 * `enqueue` starts a task: call run(task, begin, end) for ranges that together cover each index from 0 to count - 1
 * exactly once. Any split, order and threads will do, from one call for all indices to a parallel-for, and calls may be
 * made inside `enqueue`. All must have returned when `finish` returns. The returned token is passed to `finish`; any
 * value is allowed.
 * `finish` waits for the task. It is called exactly once for each `enqueue`, on the same thread. While it waits, it
 * should run calls that have not started: the stepping thread does its share of the work first, so these find nothing
 * left to do and return at once.
 *
 * An index stands for a thread, not for a piece of work: tasks share out the work among themselves, so the split
 * affects speed, never results. Both functions are called only during lr_world_step, on the thread that called it and
 * in that thread's floating-point mode; tasks set and restore their own. Neither may throw, longjmp, or call the
 * library on the same world. Do not call run() after `finish`. A task needs 192 KB of stack. */
typedef void (*lr_task_fn)(void* task, uint32_t begin, uint32_t end);

typedef struct lr_job_system {
    void* user;
    void* (*enqueue)(void* user, lr_task_fn run, void* task, uint32_t count);
    void (*finish)(void* user, void* token);
} lr_job_system;

/* Severity of a log message. */
typedef int32_t lr_log_level;
enum {
    LR_LOG_ERROR = 1,   /* a call failed: the message names it and gives the reason */
    LR_LOG_WARNING = 2, /* a call succeeded, but probably does not do what was meant */
    LR_LOG_INFO = 3,
};

/* Receives a log message, valid during the call only. Called on the thread that calls the library; with
 * LR_CHECK_THREADS possibly while another thread is inside a call on the world. Must not call the library on the same
 * world. May be null. */
typedef void (*lr_log_fn)(void* user, lr_log_level level, const char* message);

/* Instruction sets. All give the same bits, so force one only for tests and measurements. LR_SIMD_AUTO picks the best
 * that the processor supports. */
typedef int32_t lr_simd_target;
enum {
    LR_SIMD_AUTO = 0,
    LR_SIMD_SSE4 = 1, /* with SSE4.2, AES and PCLMUL: the minimum on x86-64 */
    LR_SIMD_AVX2 = 2,
    LR_SIMD_AVX512 = 3,
    LR_SIMD_NEON = 4,
    LR_SIMD_WASM = 5,
    LR_SIMD_PLAIN = 6, /* plain C++, only in test builds */
};

/* Lists the instruction sets that this build contains and this processor supports, best first.
 * targets: receives up to `capacity` values; may be null when capacity is 0. count: receives the full number, even if
 * it exceeds capacity.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL (count is set). Any thread. */
LR_API lr_status lr_simd_targets(lr_simd_target* targets, uint32_t capacity, uint32_t* count);

/* A display name: "AVX-512", "AVX2", "SSE4", "NEON", "WebAssembly", "plain", "auto" or "unknown". Never null; static
 * storage. Any thread. */
LR_API const char* lr_simd_target_name(lr_simd_target target);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Assets                                                                                                             */

/* An asset holds everything that depends on a body's shape alone: mass, inertia, added mass, aerodynamic coefficients,
 * collision hull. Load it from a file made by `lr_bake`, or create one from numbers below. */

/* Receives one numbered fault of an asset file; docs/reference/asset_format.md lists them. Strings are valid during the
 * call only. */
typedef void (*lr_fault_fn)(void* user, uint32_t number, const char* where, const char* what, const char* remedy);

/* Loads an asset made by `lr_bake` from a regular file. The whole file is verified before any of it is used.
 * path_utf8: UTF-8 on every platform. out: receives the asset with one reference, which lr_asset_release gives back;
 * null after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_FILE_NOT_FOUND, LR_ERROR_FILE_READ, LR_ERROR_ASSET_FORMAT,
 * LR_ERROR_ASSET_VERSION, LR_ERROR_ASSET_CORRUPT, LR_ERROR_ASSET_INVALID, LR_ERROR_OUT_OF_MEMORY. Any thread. */
LR_API lr_status lr_asset_load_file(const char* path_utf8, lr_asset** out);

/* Loads an asset from memory. bytes: of any alignment, not kept. out: as for lr_asset_load_file.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_ASSET_*, LR_ERROR_OUT_OF_MEMORY. Any thread. */
LR_API lr_status lr_asset_load_memory(const void* bytes, uint64_t size, lr_asset** out);

/* Checks the bytes of an asset and calls `report`, which may be null, once for each fault found.
 * Returns what lr_asset_load_memory would. Any thread. */
LR_API lr_status lr_asset_check_memory(const void* bytes, uint64_t size, lr_fault_fn report, void* user);

/* A solid ellipsoid: the quickest way to a first falling body. Mass, added mass (Lamb) and the decay of k and epsilon
 * in a uniform stream come from closed forms. */
typedef struct lr_ellipsoid_desc {
    uint32_t struct_size;
    uint32_t reserved;
    double semi_axes[3];      /* m, each 1e-6 to 1e3, along body x, y, z */
    double density;           /* kg/m^3 of the body, > 0 */
    double fluid_density;     /* kg/m^3, > 0; default 1.2, air */
    double fluid_viscosity;   /* m^2/s, kinematic, > 0; default 1.5e-5, air */
    double intensity;         /* turbulence intensity I of k0 = 3/2 (I U0)^2, 0 to 10; default 1, as in the paper */
    double center_of_mass[3]; /* m, from the ellipsoid's centre, inside it; default 0. For ballast: the centre of
                                 buoyancy and the moments of inertia stay those of the uniform solid */
} lr_ellipsoid_desc;

/* Sets the defaults, those of LR_ELLIPSOID_DESC_INIT. All other _init functions work alike. struct_size:
 * sizeof(lr_ellipsoid_desc) in the caller's header.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. Any thread. */
LR_API lr_status lr_ellipsoid_desc_init(lr_ellipsoid_desc* desc, uint32_t struct_size);

/* Creates an asset from an ellipsoid. Formulas: Lamb, Hydrodynamics, art. 114-115; docs/maintainers/physics.md.
 * out: as for lr_asset_load_file.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
 * LR_ERROR_OUT_OF_MEMORY. Any thread. */
LR_API lr_status lr_asset_create_ellipsoid(const lr_ellipsoid_desc* desc, lr_asset** out);

/* Adds a reference, which lr_asset_release gives back. LR_OK, LR_ERROR_NULL_ARGUMENT. Any thread. */
LR_API lr_status lr_asset_retain(lr_asset* asset);

/* Gives back a reference. The last one frees the asset. Each batch holds its own. Null is allowed. Any thread. */
LR_API void lr_asset_release(lr_asset* asset);

/* Bits that describe an asset. */
typedef uint32_t lr_asset_flags;
enum {
    LR_ASSET_DIAGONAL = 1,  /* diagonal in body axes, buoyancy at the centre of mass: the fastest path for all loads */
    LR_ASSET_SYMMETRIC = 2, /* its own mirror image across its widest face: the fastest path for AERODYNAMIC loads */
};

/* Properties of an asset. Matrices are row-major and symmetric. */
typedef struct lr_asset_info {
    uint32_t struct_size;
    lr_asset_flags flags;         /* LR_ASSET_* */
    char name[64];                /* UTF-8, ends with 0 */
    double mass;                  /* kg */
    double volume;                /* m^3 */
    double density;               /* kg/m^3 */
    double center_of_mass[3];     /* m, in the frame of the mesh: the position of the body's origin in it */
    double center_of_buoyancy[3]; /* m, from the centre of mass, body axes */
    double inertia[9];            /* kg m^2, about the centre of mass, body axes */
    double added_mass[36];        /* about the centre of mass, order vx vy vz wx wy wz, fluid density included:
                                     kg for the 3x3 block of v, kg m for the coupling, kg m^2 for the block of w */
    double fluid_density;         /* kg/m^3, of the fluid that the asset was baked in */
    double fluid_viscosity;       /* m^2/s, kinematic */
    double length_d;              /* m, characteristic length: the largest extent */
    double length_b;              /* m, thickness */
    double length_l;              /* m, turbulence length; see docs/maintainers/physics.md */
    double u0;                    /* m/s, fall velocity scale sqrt(|density ratio - 1| g b), paper Eq. 1 */
    double reynolds;              /* u0 d / viscosity */
    double c0;                    /* Kolmogorov constant of the Langevin model, paper Eq. 10 */
    double turbulence_dt;         /* s between table samples */
    uint32_t turbulence_count;    /* number of table samples */
    uint32_t hull_vertex_count;   /* 0: no hull */
    uint32_t hull_triangle_count;
    uint32_t format_version; /* of the file; 0: created without a file */
    uint64_t content_hash;   /* of everything that affects motion; equal for equal assets */
} lr_asset_info;

LR_API lr_status lr_asset_info_init(lr_asset_info* info, uint32_t struct_size);

/* Reads an asset's properties. info: initialised by lr_asset_info_init, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. Any thread. */
LR_API lr_status lr_asset_get_info(const lr_asset* asset, lr_asset_info* info);

/* ------------------------------------------------------------------------------------------------------------------ */
/* World                                                                                                              */

/* A world holds gravity, a fluid, wind, water, colliders and batches, and has a clock of its own. Create it first, then
 * batches and bodies; call lr_world_step once a frame. */

/* Refuses a call on a world while another thread is inside one, and a call from one of the world's own callbacks (wind,
 * water surface, allocator, log, job system, recording). The refused call changes nothing, a message names both
 * functions, and the call in progress continues unharmed. A refused lr_world_destroy leaks the world; a refused
 * lr_world_snapshot_size returns 0. Calls after lr_world_destroy has returned are not detected. Without this bit all
 * such calls are undefined behaviour. docs/reference/stepping.md */
typedef uint32_t lr_check_flags;
enum {
    LR_CHECK_THREADS = 1,
};

typedef struct lr_world_desc {
    uint32_t struct_size;
    uint32_t worker_count; /* threads besides the caller's, 0 to 64; default 0: everything runs on the caller's thread.
                               With `jobs`: threads of the job system besides the caller's, and the most indices in one
                               enqueue; 0 guesses the machine's threads less one, from 1 to 64, and logs a warning */
    uint64_t seed;         /* of all noise; default 0 */
    float gravity[3];      /* m/s^2; default 0, -9.81, 0 */
    float fluid_density; /* kg/m^3, >= 0; default 0: each batch uses the fluid that its asset was baked in. For a vacuum
                              set 1e-6 */
    lr_simd_target simd_target; /* LR_SIMD_*; default LR_SIMD_AUTO */
    float fluid_viscosity;  /* m^2/s, kinematic, >= 0; default 0: each batch uses the value its asset was baked with */
    lr_allocator allocator; /* copied; default null functions: the C library's */
    lr_log_fn log;          /* default null: no messages */
    void* log_user;
    lr_job_system jobs;    /* copied; default null functions: the world starts worker_count threads of its own */
    lr_check_flags checks; /* bits LR_CHECK_*: misuse to detect, for development; default 0 */
    uint32_t reserved;     /* 0 */
} lr_world_desc;

LR_API lr_status lr_world_desc_init(lr_world_desc* desc, uint32_t struct_size);

/* Creates a world. out: receives the world, null after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
 * LR_ERROR_UNSUPPORTED (simd_target), LR_ERROR_OUT_OF_MEMORY, LR_ERROR_THREADS. Any thread. */
LR_API lr_status lr_world_create(const lr_world_desc* desc, lr_world** out);

/* Destroys a world with its batches and bodies, stops its worker threads and ends its recording. Null is allowed. */
LR_API void lr_world_destroy(lr_world* world);

typedef struct lr_world_info {
    uint32_t struct_size;
    lr_simd_target simd_target; /* LR_SIMD_*: in use, never LR_SIMD_AUTO */
    uint32_t worker_count;      /* as in the desc; with `jobs` and 0: the guess */
    uint32_t batch_count;
    uint64_t body_count;
    uint64_t substep_count; /* substeps since creation; the time index of the noise */
    double time;            /* s since creation: the sum of all dt, in double */
    uint64_t memory_bytes;  /* currently allocated */
    uint64_t collider_count;
    uint64_t awake_count; /* bodies that are not asleep: lr_body_set_sleep */
    uint64_t budget;      /* as set by lr_world_set_budget */
    float gravity[3];     /* m/s^2, as set by lr_world_set_gravity */
    uint32_t reserved;    /* 0 */
} lr_world_info;

LR_API lr_status lr_world_info_init(lr_world_info* info, uint32_t struct_size);

/* Reads counts, time and settings of the world. info: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_world_get_info(const lr_world* world, lr_world_info* info);

/* Sets gravity from the next step on. A change wakes all bodies (lr_body_set_sleep). gravity: m/s^2, 3 values, each up
 * to 1e4 in magnitude.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_world_set_gravity(lr_world* world, const float* gravity);

/* Sets the instruction set from the next step on. Results do not change. target: LR_SIMD_*.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_UNSUPPORTED. */
LR_API lr_status lr_world_set_simd_target(lr_world* world, lr_simd_target target);

/* Wind: the fluid's velocity is the uniform wind, plus up to LR_MAX_WIND_SOURCES sources, plus a callback. Bodies feel
 * the fluid's velocity relative to their own, without its component into walls beside them. Formulas:
 * docs/reference/wind_and_water.md. */

/* Sets the uniform wind, the same velocity everywhere; 0 before the first call. A change is spread evenly over the next
 * step, in which bodies feel the fluid accelerate (Froude-Krylov force and added mass): a body as dense as the fluid is
 * carried along, a heavy one keeps most of its velocity. A wind set before the world's first step is there from the
 * beginning and accelerates nothing. Setting the same wind again changes nothing. x, y, z: m/s, each up to 1000 in
 * magnitude.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_world_set_uniform_wind(lr_world* world, float x, float y, float z);

/* Reads the uniform wind that was set last. velocity: receives 3 values, m/s; unchanged after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT. */
LR_API lr_status lr_world_get_uniform_wind(const lr_world* world, float* velocity);

/* Wind sources. Each kind has a struct, and functions to add, update and read it. A source is at `position` at the
 * world time (lr_world_info.time) at which it is added or updated; from then on it moves with `velocity`. When a source
 * is added, updated or removed, bodies keep their velocities: this does not count as accelerating fluid. Limits:
 * positions up to 1e9 m and velocities up to 1000 m/s, each component in magnitude; other lengths up to 1e6 m. */

#define LR_MAX_WIND_SOURCES 64u

/* Gusts: fluctuations of the uniform wind in time, with mean 0. They start from 0 when added, the fast ones first, and
 * reach full strength after 4 integral times; an update continues them. */
typedef struct lr_gusts_desc {
    uint32_t struct_size;
    uint32_t seed;       /* combined with the world's; default 0 */
    float direction[3];  /* mean direction, any length but 0; default 1, 0, 0 */
    float rms;           /* m/s, root mean square speed, 0 to 1000; default 1 */
    float angle_rms;     /* rad, root mean square angle from `direction`, 0 to 1; default 0.1 */
    float integral_time; /* s, up to 1e6; default 0: 4 s. IEC 61400-1: 5.67 times height over wind speed */
} lr_gusts_desc;

LR_API lr_status lr_gusts_desc_init(lr_gusts_desc* desc, uint32_t struct_size);

/* Adds gusts. The struct is copied. out: receives the handle, id 0 after an error; may be null.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
 * LR_ERROR_CAPACITY (of sources), LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_world_add_gusts(lr_world* world, const lr_gusts_desc* desc, lr_wind_source* out);

/* Replaces all values of a source of this kind.
 * LR_OK, LR_ERROR_STALE_WIND_SOURCE, LR_ERROR_INVALID_ARGUMENT (also a source of another kind), and every status of
 * lr_world_add_gusts but LR_ERROR_CAPACITY. */
LR_API lr_status lr_world_update_gusts(lr_world* world, lr_wind_source source, const lr_gusts_desc* desc);

/* Reads a source of this kind as it was added or last updated, but with the position where it is now. desc:
 * initialised, or with struct_size set; unchanged after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_STALE_WIND_SOURCE, LR_ERROR_INVALID_ARGUMENT (a source
 * of another kind). */
LR_API lr_status lr_world_get_gusts(const lr_world* world, lr_wind_source source, lr_gusts_desc* desc);

/* The core of a vortex. */
typedef int32_t lr_vortex_core;
enum {
    LR_VORTEX_LAMB_OSEEN = 0, /* a smooth core, as viscosity spreads it */
    LR_VORTEX_RANKINE = 1,    /* a core that rotates as a solid */
};

/* A straight vortex. */
typedef struct lr_vortex_desc {
    uint32_t struct_size;
    lr_vortex_core core; /* LR_VORTEX_*; default LR_VORTEX_LAMB_OSEEN */
    float position[3];   /* m, a point on the axis, its middle if half_length > 0; default 0 */
    float axis[3];       /* right-hand rule, any length but 0; default 0, 1, 0 */
    float velocity[3];   /* m/s, of the vortex itself; default 0 */
    float circulation;   /* m^2/s, up to 1e6 and up to 6000 * core_radius in magnitude; default 1 */
    float core_radius;   /* m, >= 1e-4; default 1 */
    float outer_radius;  /* m: fades from half this distance to nothing at it; default 0: no limit */
    float half_length;   /* m: likewise along the axis; default 0: no limit */
} lr_vortex_desc;

LR_API lr_status lr_vortex_desc_init(lr_vortex_desc* desc, uint32_t struct_size);

/* Adds a vortex. Returns what lr_world_add_gusts would. out: the handle; may be null. */
LR_API lr_status lr_world_add_vortex(lr_world* world, const lr_vortex_desc* desc, lr_wind_source* out);

/* Updates a vortex. Returns what lr_world_update_gusts would. */
LR_API lr_status lr_world_update_vortex(lr_world* world, lr_wind_source source, const lr_vortex_desc* desc);

/* Reads a vortex as last set. Returns what lr_world_get_gusts would. */
LR_API lr_status lr_world_get_vortex(const lr_world* world, lr_wind_source source, lr_vortex_desc* desc);

/* A blower: a turbulent jet, round or from a slot. */
typedef struct lr_blower_desc {
    uint32_t struct_size;
    float position[3];   /* m, the middle of the nozzle; default 0 */
    float direction[3];  /* of the jet, any length but 0; default 1, 0, 0 */
    float side[3];       /* along the slot; not parallel to `direction`; default 0, 0, 1. Unused by a round jet */
    float velocity[3];   /* m/s, of the blower itself; default 0 */
    float speed;         /* m/s at the nozzle, 0 to 1000; default 1 */
    float nozzle_radius; /* m, >= 1e-4: of a round nozzle, half the width of a slot; default 1 */
    float half_length;   /* m: half the length of the slot; default 0: a round jet */
    float range;         /* m, >= nozzle_radius: fades from half this distance to nothing at it; default 10 */
    float spread;        /* widening of the jet per length, 0 to 1; default 0.1, measured as 0.11 */
} lr_blower_desc;

LR_API lr_status lr_blower_desc_init(lr_blower_desc* desc, uint32_t struct_size);

/* Adds a blower. Returns what lr_world_add_gusts would. out: the handle; may be null. */
LR_API lr_status lr_world_add_blower(lr_world* world, const lr_blower_desc* desc, lr_wind_source* out);

/* Updates a blower. Returns what lr_world_update_gusts would. */
LR_API lr_status lr_world_update_blower(lr_world* world, lr_wind_source source, const lr_blower_desc* desc);

/* Reads a blower as last set. Returns what lr_world_get_gusts would. */
LR_API lr_status lr_world_get_blower(const lr_world* world, lr_wind_source source, lr_blower_desc* desc);

/* Turbulence: random eddies everywhere, divergence-free, carried along by the uniform wind. An update continues them,
 * also with another velocity; only another size moves them. */
typedef struct lr_turbulence_desc {
    uint32_t struct_size;
    uint32_t seed;         /* combined with the world's; default 0 */
    uint32_t octaves;      /* each half the size of the one before, 1 to 4; default 2 */
    float velocity[3];     /* m/s, of the pattern, besides the uniform wind; default 0 */
    float rms;             /* m/s, root mean square of each component, 0 to 1000; default 1 */
    float integral_length; /* m, >= 1e-4; default 1 */
    float eddy_life;       /* s, of the largest eddies, up to 1e6; default 0: integral_length/rms */
} lr_turbulence_desc;

LR_API lr_status lr_turbulence_desc_init(lr_turbulence_desc* desc, uint32_t struct_size);

/* Adds turbulence. Returns what lr_world_add_gusts would. out: the handle; may be null. */
LR_API lr_status lr_world_add_turbulence(lr_world* world, const lr_turbulence_desc* desc, lr_wind_source* out);

/* Updates turbulence. Returns what lr_world_update_gusts would. */
LR_API lr_status lr_world_update_turbulence(lr_world* world, lr_wind_source source, const lr_turbulence_desc* desc);

/* Reads turbulence as last set. Returns what lr_world_get_gusts would. */
LR_API lr_status lr_world_get_turbulence(const lr_world* world, lr_wind_source source, lr_turbulence_desc* desc);

/* The value of a wind grid outside its samples. */
typedef int32_t lr_wind_outside;
enum {
    LR_WIND_OUTSIDE_ZERO = 0,   /* a grid adds nothing outside its samples */
    LR_WIND_OUTSIDE_CLAMP = 1,  /* the values at its border continue outside */
    LR_WIND_OUTSIDE_REPEAT = 2, /* the grid repeats: its first sample follows its last */
};

#define LR_MAX_WIND_SAMPLES 67108864u /* of one grid, all frames together */

/* Samples of wind on a lattice, in one or more frames that are played in a loop, from the first at world time 0. An
 * update with another frame_time, but as many frames, goes on from the present one. */
typedef struct lr_wind_grid_desc {
    uint32_t struct_size;
    lr_wind_outside outside; /* LR_WIND_OUTSIDE_*; default LR_WIND_OUTSIDE_ZERO */
    float position[3];       /* m, of the first sample; default 0 */
    float velocity[3];       /* m/s, of the grid itself; default 0 */
    float spacing[3];        /* m between samples, >= 1e-4; default 1 */
    uint32_t counts[3];      /* samples along x, y, z, each >= 1 */
    uint32_t frames;         /* >= 1; default 1 */
    float frame_time;        /* s between frames, up to 1e6; default 0: 1 s */
    const float* samples;    /* m/s, each up to 1000 in magnitude: x y z of each sample; x varies fastest, then y, z,
                             frame; copied. Null in an update: keeps the samples, if counts and frames are unchanged.
                             lr_world_get_wind_grid gives null */
} lr_wind_grid_desc;

LR_API lr_status lr_wind_grid_desc_init(lr_wind_grid_desc* desc, uint32_t struct_size);

/* Adds a grid. Returns what lr_world_add_gusts would. out: the handle; may be null. */
LR_API lr_status lr_world_add_wind_grid(lr_world* world, const lr_wind_grid_desc* desc, lr_wind_source* out);

/* Updates a grid. Returns what lr_world_update_gusts would. */
LR_API lr_status lr_world_update_wind_grid(lr_world* world, lr_wind_source source, const lr_wind_grid_desc* desc);

/* Reads a grid as last set. Returns what lr_world_get_gusts would. */
LR_API lr_status lr_world_get_wind_grid(const lr_world* world, lr_wind_source source, lr_wind_grid_desc* desc);

/* A logarithmic profile over the ground, a plane: scales the uniform wind and the gusts. */
typedef struct lr_ground_wind_desc {
    uint32_t struct_size;
    float position[3];      /* m, a point on the ground; default 0 */
    float normal[3];        /* upward, any length but 0; default 0, 1, 0 */
    float velocity[3];      /* m/s, of the plane itself; default 0 */
    float roughness_length; /* m, >= 1e-4; default 0.03, grass (0.0001 water, 1 town) */
    float reference_height; /* m, >= roughness_length: the height at which the factor is 1; default 10 */
} lr_ground_wind_desc;

LR_API lr_status lr_ground_wind_desc_init(lr_ground_wind_desc* desc, uint32_t struct_size);

/* Adds the wind over a ground. Returns what lr_world_add_gusts would. out: the handle; may be null. */
LR_API lr_status lr_world_add_ground_wind(lr_world* world, const lr_ground_wind_desc* desc, lr_wind_source* out);

/* Updates the wind over a ground. Returns what lr_world_update_gusts would. */
LR_API lr_status lr_world_update_ground_wind(lr_world* world, lr_wind_source source, const lr_ground_wind_desc* desc);

/* Reads the wind over a ground as last set. Returns what lr_world_get_gusts would. */
LR_API lr_status lr_world_get_ground_wind(const lr_world* world, lr_wind_source source, lr_ground_wind_desc* desc);

/* Removes a source of any kind. LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_WIND_SOURCE. */
LR_API lr_status lr_world_remove_wind(lr_world* world, lr_wind_source source);

/* Returns 1 if the wind source exists in this world, else 0. Never an error: see lr_body_is_valid. */
LR_API int32_t lr_wind_source_is_valid(const lr_world* world, lr_wind_source source);

/* Input and output of a wind callback. Arrays hold one value per body. */
typedef struct lr_wind_query {
    uint32_t struct_size;
    uint32_t count;           /* bodies, 1 to 256 */
    lr_batch batch;           /* of these bodies; id 0 in lr_world_sample_wind */
    uint32_t reserved;        /* 0 */
    double time;              /* s, of the middle of the substep */
    const float* position[3]; /* m: expected positions of the bodies at that time; finite */
    float* velocity[3];       /* m/s, preset to 0: write the velocity to add to the other sources' */
    float* rate[3];           /* m/s^2, preset to 0: write its partial derivative in time, if known */
    float* gradient[9];       /* 1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without
                                 rate and gradient the callback's wind causes drag, but neither shear nor the force of
                                 accelerating fluid */
} lr_wind_query;

/* Called with each body once per substep, in no particular order. Calls come at the same time from the stepping thread
 * and from the world's workers or the job system's threads; with worker_count 0 from the stepping thread alone. For a
 * deterministic world the results must depend only on position, time and batch. Must not call the library on the same
 * world, throw, or keep pointers. If a body's results are not finite, or exceed 1000 m/s, all of them are taken as 0,
 * and one warning is logged after the step. */
typedef void (*lr_wind_fn)(void* user, const lr_wind_query* query);

/* Sets a callback that adds an engine's own wind field to all other wind. Null removes it. Not part of snapshots.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world). */
LR_API lr_status lr_world_set_wind_callback(lr_world* world, lr_wind_fn callback, void* user);

/* Evaluates the fluid's velocity from all sources at the world's current time, for particles, cloth or debug arrows.
 * positions: 3 * count values, m, x y z x y z ..., each up to 1e9 in magnitude. velocities: receives 3 * count, m/s.
 * Both may be null when count is 0, and both may be the same array.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_world_sample_wind(const lr_world* world, const float* positions, uint32_t count, float* velocities);

/* Water: a second, denser fluid below a plane or below waves. Bodies float, sink and pass through its surface; surface
 * tension is ignored. docs/reference/wind_and_water.md */

#define LR_MAX_WAVES 8u

/* A long-crested deep-water wave. Heights of waves add up. The frequency in the water, sqrt(2 pi g/length), uses the
 * world's gravity at the time of lr_world_set_water. The current carries the waves along; a change of it leaves them
 * where they are. */
typedef struct lr_wave {
    float direction[3]; /* of travel: any vector not along the normal; only its part in the plane counts */
    float length;       /* m, crest to crest, 1e-3 to 1e6 */
    float amplitude;    /* m, half of crest to trough, 0 to length/7: steeper waves break */
    float phase;        /* rad, up to 1e6 in magnitude; 0 puts a crest at `position` at world time 0 */
} lr_wave;

/* The water surface. Water fills everything below it; above it is the fluid of the world or of each batch's asset. */
typedef struct lr_water_desc {
    uint32_t struct_size;
    uint32_t wave_count; /* elements of `waves` in use; the others are not kept; default 0 */
    float position[3];   /* m, a point of the plane, each up to 1e9 in magnitude; default 0 */
    float normal[3];     /* upward, any length but 0; default 0, 1, 0 */
    float density;       /* kg/m^3, 1e-3 to 1e6; default 998. A batch whose own fluid is denser keeps its own density */
    float viscosity;     /* m^2/s, kinematic, 1e-12 to 1e3; default 1e-6 */
    float current[3];    /* m/s, of the water, and of a plane that you move; each up to 1000 in magnitude; default 0 */
    float reach;         /* m, 0 to 1e6: the farthest that a callback's surface lies from the plane; default 0 */
    lr_wave waves[LR_MAX_WAVES];
} lr_water_desc;

LR_API lr_status lr_water_desc_init(lr_water_desc* desc, uint32_t struct_size);

/* Sets the water from the next step on. The struct is copied; null removes the water. Bodies keep their velocities,
 * even if they are now in another fluid. A batch whose mass matrix would be singular in water stays in its own fluid,
 * and a warning is logged. Part of snapshots and of the world's hash. A change wakes sleeping bodies that feel it.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
 * LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_world_set_water(lr_world* world, const lr_water_desc* desc);

/* Reads the water. desc: initialised, or with struct_size set; receives initial values if there is no water.
 * present: receives 1 or 0.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_world_get_water(const lr_world* world, lr_water_desc* desc, int32_t* present);

/* Input and output of a water surface callback. Arrays hold one value per body; outputs are preset to the values of the
 * plane and its waves, each wave as its mean over the body. */
typedef struct lr_water_query {
    uint32_t struct_size;
    uint32_t count;           /* bodies, 1 to 256 */
    lr_batch batch;           /* of these bodies */
    uint32_t reserved;        /* 0 */
    double time;              /* s */
    const float* position[3]; /* m; finite */
    float* height;            /* m, of the surface above the plane, along the plane's normal */
    float* normal[3];         /* unit, of the surface, less than 80 degrees from the plane's */
    float* velocity[3];       /* m/s, of the water at the position */
    float* rate[3];           /* m/s^2, du/dt + u . grad u of the water: lets bodies slide down slopes, follow eddies */
} lr_water_query;

/* Called for bodies near the water surface: once, and twice more in each substep. Threads and restrictions: as for
 * lr_wind_fn. A body's results are replaced by the plane's if one is not finite, if a height exceeds `reach`, a
 * velocity 1000 m/s or an acceleration 1e6 m/s^2, or if the normal is invalid; one warning is then logged after the
 * step. */
typedef void (*lr_water_fn)(void* user, const lr_water_query* query);

/* Sets a callback for an engine's own water, used while lr_world_set_water has set a surface. Null removes it. Not
 * part of snapshots.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world). */
LR_API lr_status lr_world_set_water_callback(lr_world* world, lr_water_fn callback, void* user);

/* Advances all bodies by dt, in `substeps` equal parts. At 60 Hz use 1 substep for flat leaves and paper of a
 * few centimetres, 2 for bent leaves, 4 for petals and confetti (docs/maintainers/numerics.md). Rules end bodies and
 * emitters spawn them at the end of the step. Allocates only in the case that lr_allocator describes. Saves, sets and
 * restores the calling thread's floating-point mode. Needs 192 KB of stack. dt: s, > 0. substeps: 1 to LR_MAX_SUBSTEPS.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_TIMESTEP_*, LR_ERROR_SUBSTEPS, LR_ERROR_OUT_OF_MEMORY: the step was taken, so
 * do not repeat it, but bodies may have passed through each other. The next step asks for the memory again. */
LR_API lr_status lr_world_step(lr_world* world, float dt, uint32_t substeps);

/* Limits the work of each step to a number of substeps of single bodies: the same work, so the same bits, on every
 * machine. Takes effect at the next step. Part of snapshots. If the batches that are due need more, each first gets the
 * fewest substeps that preserve its fall statistics (lr_batch_set_rate); batches that have waited longest come first,
 * and none waits forever. A batch with forces on single bodies is stepped at once, even beyond the budget.
 * docs/reference/stepping.md.
 * body_substeps: at most 2^48; 0, the default, for no limit.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_world_set_budget(lr_world* world, uint64_t body_substeps);

/* Work done and postponed by the last step. Batches without bodies are not counted. */
typedef struct lr_step_report {
    uint32_t struct_size;
    uint32_t batches_stepped;
    uint32_t batches_waiting;      /* not due, because of their divisors */
    uint32_t batches_passed_over;  /* due, but out of budget */
    uint64_t body_substeps;        /* done in this step */
    uint64_t body_substeps_wanted; /* that the batches which were due would need without a budget */
    double behind;                 /* s: the longest time by which a batch is behind the world */
    double lost;                   /* s: the most simulated time that a batch lost in this step: rather than take
                                      substeps that are too long, bodies move in slow motion */
} lr_step_report;

LR_API lr_status lr_step_report_init(lr_step_report* report, uint32_t struct_size);

/* Reads the report of the last step: zeros before the first step and after a snapshot is restored. report: initialised,
 * or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_world_get_step_report(const lr_world* world, lr_step_report* report);

/* Seconds that the phases of the last step took on the stepping thread, by a monotonic clock. `total` also includes
 * the work between phases. Phases that did not occur are 0. Neither part of snapshots nor of the world's hash. */
typedef struct lr_timings {
    uint32_t struct_size;
    uint32_t reserved;
    double total;
    double colliders;      /* waking bodies about to be hit, moving colliders, sorting them for the search */
    double wind;           /* preparing the wind's fields; bodies evaluate them as part of their motion */
    double motion;         /* of batches without body contact: loads, wind, water, contact with colliders */
    double body_contact;   /* of batches with body contact: their motion, and the contact between their bodies */
    double wake;           /* finding sleeping bodies that wind or water moves */
    double emit_and_rules; /* ends, spawns, divergence, and falling asleep */
    double events;         /* listing and sorting them */
} lr_timings;

LR_API lr_status lr_timings_init(lr_timings* timings, uint32_t struct_size);

/* Reads the timings of the last step: zeros before the first one. timings: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_world_get_timings(const lr_world* world, lr_timings* timings);

/* Snapshots save a world's state and restore it, for rollback; the hash tells whether two worlds agree.
 * docs/reference/snapshots.md */

/* Computes a hash of the world's time index, bodies, colliders, pairs of touching bodies, water and wind sources (grids
 * by the hash of their samples). It does not depend on the order of bodies in memory, the processor or worker_count.
 * Worlds with equal settings and equal hashes move alike from here on.
 * LR_OK, LR_ERROR_NULL_ARGUMENT. */
LR_API lr_status lr_world_hash(const lr_world* world, uint64_t* out);

/* Bytes that lr_world_snapshot_save needs at present; 0 for null. With body contact 120 of them for each pair of awake
 * bodies that touch or nearly do. */
LR_API uint64_t lr_world_snapshot_size(const lr_world* world);

/* Writes the world's state into `size` bytes at `memory`, of any alignment: time, gravity, wind, water, budget; bodies
 * and colliders with their handles; pairs of touching bodies; each batch's turbulence table, loads, forces, rules,
 * emitter, rate and contact settings. Not included: assets, the descs of batches, threads, callbacks, the samples of
 * wind grids, and the data of hulls, heightfields and meshes; samples and data are identified by their hash.
 * written: bytes used; may be null.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL. */
LR_API lr_status lr_world_snapshot_save(const lr_world* world, void* memory, uint64_t size, uint64_t* written);

/* Restores a saved state. The world may be another one, also in another process, if its batches were created in the
 * same order from equal assets with equal capacities. Bodies, wind sources and colliders get their handles back. Wind
 * grids, hulls, heightfields and meshes must already be in the world, anywhere. The snapshot is checked as a whole
 * before anything changes. Allocates nothing in a world that has held as much before. docs/reference/snapshots.md says
 * which versions restore which snapshots.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_SNAPSHOT_FORMAT, LR_ERROR_SNAPSHOT_MISMATCH, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_world_snapshot_restore(lr_world* world, const void* memory, uint64_t size);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Recording: captures all calls to a world, so that lr_replay can repeat them elsewhere. docs/reference/snapshots.md */

/* Receives the next `size` bytes of a recording, valid during the call only: append them to a file or a ring buffer.
 * Return 0, or anything else to end the recording. Called inside functions that take the world, on their thread. With
 * LR_RECORD_CALLBACKS it is also called on the threads that run wind and water callbacks, but never by two at a time.
 * Must not call the library on the same world, throw or longjmp. */
typedef int32_t (*lr_record_fn)(void* user, const void* bytes, uint64_t size);

/* Records the results of wind and water callbacks, up to 72 bytes per body and substep for each callback. Without them
 * a replay stops at the first callback. */
typedef uint32_t lr_record_flags;
enum {
    LR_RECORD_CALLBACKS = 1,
};

typedef struct lr_recording_desc {
    uint32_t struct_size;
    lr_record_flags flags;  /* bits LR_RECORD_*; default LR_RECORD_CALLBACKS */
    uint32_t hash_interval; /* steps between recorded hashes of the world; 0: none; default 1 */
    uint32_t reserved;      /* 0 */
    lr_record_fn write;     /* required */
    void* user;
} lr_recording_desc;

LR_API lr_status lr_recording_desc_init(lr_recording_desc* desc, uint32_t struct_size);

/* Starts a recording, at any time. First writes the world's present state and the assets of its batches, then each call
 * that can change the world: its arguments, as a rule before it is carried out, and its status after it. Allocates 64
 * KiB and a few bytes per asset; while starting, also a copy of the assets and a snapshot. If `write` refuses, the
 * recording ends, a message is logged, and the world goes on.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->write), LR_ERROR_STRUCT_SIZE, LR_ERROR_INVALID_ARGUMENT (unknown flags;
 * already recording; `write` has refused), LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_world_record_start(lr_world* world, const lr_recording_desc* desc);

/* Ends a recording.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (not recording, also after `write` has refused). */
LR_API lr_status lr_world_record_stop(lr_world* world);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Batches                                                                                                            */

/* A batch holds up to `capacity` bodies of one asset, and the settings that they share. Make one for each asset, and
 * one for each tree or tile that needs its own level of detail. */

/* How the fluid's forces on bodies are computed. */
typedef int32_t lr_load_model;
enum {
    LR_LOADS_DEFAULT = 0,     /* LR_LOADS_AERODYNAMIC in this version */
    LR_LOADS_NONE = 1,        /* gravity, buoyancy and added mass only: Kirchhoff's equations */
    LR_LOADS_LANGEVIN = 2,    /* the paper's turbulent loads, dimensionally repaired; docs/maintainers/physics.md, 4 */
    LR_LOADS_AERODYNAMIC = 3, /* quasi-steady drag and lift in a turbulent fluid; docs/maintainers/physics.md, 5 */
};

/* The clock of a body's turbulence. */
typedef int32_t lr_turbulence_clock;
enum {
    LR_CLOCK_SPEED = 0, /* turbulence scales with the body's current speed through the fluid */
    LR_CLOCK_AGE = 1,   /* the paper's: turbulence follows the table by the body's age */
};

/* Continuation of a turbulence table after its last sample. */
typedef int32_t lr_table_end;
enum {
    LR_TABLE_CLAMP = 0, /* LR_CLOCK_AGE: hold the last sample after the end of the table */
    LR_TABLE_LOOP = 1,  /* LR_CLOCK_AGE: start over */
};

/* How motion is integrated. */
typedef int32_t lr_integrator;
enum {
    LR_INTEGRATOR_DEFAULT = 0,   /* LR_INTEGRATOR_SPLITTING in this version */
    LR_INTEGRATOR_RK4 = 1,       /* the paper's: fourth order, slow, unstable at long steps. In water: splitting */
    LR_INTEGRATOR_SPLITTING = 2, /* second order, stable at any step; docs/maintainers/numerics.md */
};

typedef struct lr_batch_desc {
    uint32_t struct_size;
    uint32_t capacity;         /* the most bodies at a time, 1 to 2^26; memory for all is allocated at creation */
    const lr_asset* asset;     /* required; the batch keeps a reference until it is destroyed */
    lr_load_model load_model;  /* LR_LOADS_*; default LR_LOADS_DEFAULT */
    lr_turbulence_clock clock; /* LR_CLOCK_*; default LR_CLOCK_SPEED */
    lr_table_end table_end;    /* LR_TABLE_*; default LR_TABLE_CLAMP */
    lr_integrator integrator;  /* LR_INTEGRATOR_*; default LR_INTEGRATOR_DEFAULT */
    float damping_gain;        /* multiplies the turbulent damping, 0 to 100; default 1 */
    float noise_gain;  /* multiplies the turbulent noise, 0 to 100; default 1; 0 makes single falls repeatable */
    float variation;   /* natural spread of AERODYNAMIC loads from body to body, as by thickness and curl: relative
                          standard deviation, 0 to 0.5; default 0.15; 0: all bodies are alike. A body's loads follow
                          from its noise seed and the world's seed, and never change */
    uint32_t reserved; /* 0 */
} lr_batch_desc;

LR_API lr_status lr_batch_desc_init(lr_batch_desc* desc, uint32_t struct_size);

/* Creates a batch. out: receives the batch, id 0 after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->asset), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_create(lr_world* world, const lr_batch_desc* desc, lr_batch* out);

/* Destroys a batch with all its bodies. Wakes the bodies of batches that had body contact with it
 * (lr_batch_set_body_contact).
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH. */
LR_API lr_status lr_batch_destroy(lr_world* world, lr_batch batch);

/* Returns 1 if the batch exists in this world, else 0. Never an error: see lr_body_is_valid. */
LR_API int32_t lr_batch_is_valid(const lr_world* world, lr_batch batch);

/* Artistic control of AERODYNAMIC loads. The factors multiply the coefficients, so bodies still move physically. */
typedef struct lr_load_gains {
    uint32_t struct_size;
    uint32_t reserved; /* 0 */
    float drag;        /* on translation, 0 to 100; default 1 */
    float lift;        /* and its moment, 0 to 100; default 1 */
    float spin_drag;   /* 0 to 100; default 1 */
    float turbulence;  /* intensity of the body's own wake, 0 to 100; default 1 */
} lr_load_gains;

LR_API lr_status lr_load_gains_init(lr_load_gains* gains, uint32_t struct_size);

/* Sets the gains of a batch from the next step on; null sets all to 1. The gains of LANGEVIN loads are in
 * lr_batch_desc.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_set_load_gains(lr_world* world, lr_batch batch, const lr_load_gains* gains);

/* Reads the gains of a batch. gains: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_load_gains(const lr_world* world, lr_batch batch, lr_load_gains* gains);

/* Sets how often a batch is stepped: level of detail for bodies that are far away, small or out of sight. A batch of
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
 * divisor: 1 to 1024; default 1.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_set_rate(lr_world* world, lr_batch batch, uint32_t divisor);

/* How a batch keeps pace with its world. */
typedef struct lr_batch_pace {
    uint32_t struct_size;
    uint32_t divisor;       /* as set */
    uint32_t substeps;      /* in the world's last step; 0: it waited */
    uint32_t waited;        /* steps since it was last stepped */
    double behind;          /* s since it was last stepped */
    double lost;            /* s, simulated time lost in total */
    uint64_t body_substeps; /* in total */
} lr_batch_pace;

LR_API lr_status lr_batch_pace_init(lr_batch_pace* pace, uint32_t struct_size);

/* Reads a batch's rate and backlog. pace: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_pace(const lr_world* world, lr_batch batch, lr_batch_pace* pace);

/* Read access to a batch's state without a copy: arrays of `count` values, one per body, 64-byte aligned. Awake bodies
 * come first, then sleeping ones, without gaps. A body that leaves either part is replaced by the last one of that
 * part. Pointers are valid until the next call that is not a query. Velocities: lr_batch_write_velocities. */
typedef struct lr_batch_view {
    uint32_t struct_size;
    uint32_t count;              /* bodies */
    const float* position[3];    /* m, world frame: x, y, z */
    const float* orientation[4]; /* unit quaternion x, y, z, w, body to world */
    const float* scale;          /* uniform scale */
    const float* age;            /* s; outdated for sleeping bodies: lr_body_get_state gives their exact age */
    const uint32_t* noise_seed;  /* bodies with different seeds have independent noise */
    const lr_body* ids;
    const uint64_t* user; /* lr_body_desc.user; null until a body of the batch is given one */
    uint32_t capacity;
    uint32_t reserved;
    uint64_t revision;    /* changes whenever sleeping bodies wake, end or change places */
    uint32_t awake_count; /* bodies [0, awake_count) are awake, [awake_count, count) asleep: lr_body_set_sleep */
    uint32_t reserved_1;
} lr_batch_view;

LR_API lr_status lr_batch_view_init(lr_batch_view* view, uint32_t struct_size);

/* Gets the view of a batch. view: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_view(const lr_world* world, lr_batch batch, lr_batch_view* view);

/* Computes a box around all bodies of a batch, awake or asleep, for culling. Each body counts as the sphere that
 * contains it in any orientation; the box of a waiting batch (lr_batch_set_rate) also contains the places that
 * lr_batch_write_transforms extrapolates to. The cost is proportional to the number of bodies.
 * low, high: receive x, y, z of the corners, m, world frame. A batch without bodies gives the largest float in `low` and
 * its negative in `high`: the union with any other box is that box.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH. */
LR_API lr_status lr_batch_get_bounds(const lr_world* world, lr_batch batch, float* low, float* high);

/* Formats of transforms, in floats. */
typedef int32_t lr_transform_format;
enum {
    LR_TRANSFORM_POSITION_QUATERNION = 0,       /* 7 floats: position, quaternion x y z w */
    LR_TRANSFORM_POSITION_QUATERNION_SCALE = 1, /* 8 floats: position, quaternion x y z w, scale */
    LR_TRANSFORM_3X4_ROW_MAJOR = 2,             /* 12 floats: three rows, rotation times scale and translation */
    LR_TRANSFORM_3X4_COLUMN_MAJOR = 3,          /* 12 floats: four columns of three */
    LR_TRANSFORM_4X4_ROW_MAJOR = 4,             /* 16 floats; column vectors, translation in elements 3, 7, 11 */
    LR_TRANSFORM_4X4_COLUMN_MAJOR = 5,          /* 16 floats; column vectors, translation in elements 12, 13, 14 */
};

/* Writes the transforms of a batch's first `count` bodies, or of all if there are fewer, in the order of its view. Draw
 * a mesh whose origin is the centre of mass (lr_asset_info.center_of_mass). Bodies of a waiting batch
 * (lr_batch_set_rate) are extrapolated to the world's time.
 * An instance buffer that still holds the last write needs no rewrite of sleeping bodies. While lr_batch_view.revision
 * is unchanged, `count` may be the greater of the old and the new awake_count; otherwise write all bodies. Remember
 * both numbers per buffer. docs/reference/bodies.md.
 * dst: 4-byte aligned, room for `count` elements `stride` bytes apart.
 * stride: 0 for elements without gaps, else a multiple of 4 no smaller than an element. written: elements written; may
 * be null.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (dst may be null only when nothing is to be written), LR_ERROR_STALE_BATCH,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_write_transforms(const lr_world* world, lr_batch batch, lr_transform_format format, void* dst,
                                           uint64_t stride, uint32_t count, uint32_t* written);

/* Writes the velocities of a batch's first `count` bodies, or of all if there are fewer, in the order of its view. An
 * element is 6 floats, world frame: the linear velocity of the centre of mass, m/s, and the angular velocity, rad/s; bit
 * for bit those of lr_body_get_state. Sleeping bodies have 0, bodies of a waiting batch (lr_batch_set_rate) the
 * velocities of their last step.
 * dst: 4-byte aligned, room for `count` elements `stride` bytes apart.
 * stride: 0 for elements without gaps, else a multiple of 4 no smaller than an element. written: elements written; may
 * be null.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (dst may be null only when nothing is to be written), LR_ERROR_STALE_BATCH,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_write_velocities(const lr_world* world, lr_batch batch, void* dst, uint64_t stride,
                                           uint32_t count, uint32_t* written);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Bodies                                                                                                             */

/* Create bodies in a batch. Read them all at once through the batch's view, or one by one here. */

typedef struct lr_body_desc {
    uint32_t struct_size;      /* equal in all elements of an array: also the array's stride */
    uint32_t noise_seed;       /* default 0: the world assigns each body the next one */
    float position[3];         /* m, of the centre of mass; default 0 */
    float orientation[4];      /* quaternion x y z w, normalised by the call; default 0 0 0 1 */
    float linear_velocity[3];  /* m/s, of the centre of mass; default 0 */
    float angular_velocity[3]; /* rad/s, world frame; default 0 */
    float scale;               /* uniform, 0.001 to 1000; mass scales with its cube; default 1 */
    float age;                 /* s, 0 to 1e9, where it stops growing; default 0 */
    uint32_t reserved;         /* 0 */
    uint64_t user; /* the caller's own number, also in views, events and ray hits; default 0. A respawn keeps it. It
                      does not affect motion: part of snapshots, not of the world's hash */
} lr_body_desc;

LR_API lr_status lr_body_desc_init(lr_body_desc* desc, uint32_t struct_size);

/* Creates `count` bodies, all or none. descs: `count` elements. out_ids: receives `count` ids; may be null.
 * The first `user` other than 0 allocates 8 bytes for each body of the batch's capacity.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_body_create(lr_world* world, lr_batch batch, const lr_body_desc* descs, uint32_t count,
                                lr_body* out_ids);

/* Destroys `count` bodies of any batches, all or none: a stale or repeated id fails the call. Wakes the bodies that lay
 * on them. LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY. */
LR_API lr_status lr_body_destroy(lr_world* world, const lr_body* bodies, uint32_t count);

/* Returns 1 if the body exists in this world, else 0. Never an error: a null world gives 0, and so does a call
 * that lr_world_desc.checks refuses. Not recorded. */
LR_API int32_t lr_body_is_valid(const lr_world* world, lr_body body);

/* A body's sleep state. */
typedef int32_t lr_sleep_state;
enum {
    LR_SLEEP_AWAKE = 0,
    LR_SLEEP_ASLEEP = 1,
    LR_SLEEP_HELD = 2, /* read only: diverged, and held where it was by lr_batch_set_divergence_policy */
};

typedef struct lr_body_state {
    uint32_t struct_size;
    uint32_t noise_seed;        /* read only: ignored by lr_body_set_state */
    float position[3];          /* m, of the centre of mass, world frame */
    float orientation[4];       /* unit quaternion x y z w, body to world */
    float linear_velocity[3];   /* m/s, of the centre of mass, world frame */
    float angular_velocity[3];  /* rad/s, world frame */
    float scale;                /* 0.001 to 1000 */
    float age;                  /* s, 0 to 1e9 */
    lr_sleep_state sleep_state; /* LR_SLEEP_*; read only */
    uint64_t user;              /* as in lr_body_desc */
} lr_body_state;

LR_API lr_status lr_body_state_init(lr_body_state* state, uint32_t struct_size);

/* Reads the state of a body. state: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_body_get_state(const lr_world* world, lr_body body, lr_body_state* state);

/* Sets everything but the noise seed, and wakes the body. The quaternion is normalised. Limits, also of lr_body_create:
 * positions up to 1e9 m, velocities up to 1e6 m/s and rad/s. To steer bodies every frame, prefer forces and wind:
 * setting the state bypasses physics.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY (of `user`, as for lr_body_create). */
LR_API lr_status lr_body_set_state(lr_world* world, lr_body body, const lr_body_state* state);

/* Puts bodies of any batches to sleep or wakes them, all or none. Bodies may already be in that state, and ids may
 * repeat. A sleeping body does not move, whatever acts on it, and adds no cost to a step. Its velocities and pending
 * forces are cleared. It still ages, and its batch's rules still apply: they check sleeping bodies in every 16th step
 * of the batch. Falling asleep and waking change a body's index in the view, not its id. Part of snapshots. A batch's
 * first sleeping body allocates up to 25 bytes for each body of the batch's capacity. A body is woken by
 *  - this function, lr_world_wake_box and lr_body_set_state;
 *  - a force, impulse or velocity other than zero (lr_body_add_force, lr_batch_add_forces);
 *  - a change by lr_batch_set_force, lr_world_set_gravity or lr_batch_set_body_contact that concerns it;
 *  - a respawn by its batch's rules;
 *  - contact with colliders or other bodies, and wind: docs/reference/bodies.md.
 * sleep_state: LR_SLEEP_*.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_INVALID_ARGUMENT,
 * LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_body_set_sleep(lr_world* world, const lr_body* bodies, uint32_t count, lr_sleep_state sleep_state);

/* Wakes all sleeping bodies that touch a box, for events that the world does not know about, such as footsteps and
 * explosions. Each body counts as the cube that contains it in any orientation. The cost depends on the bodies near the
 * box alone. low, high: x, y, z of its corners, m, low <= high. woken: receives how many; may be null.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_world_wake_box(lr_world* world, const float* low, const float* high, uint32_t* woken);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Forces                                                                                                             */

/* The unit and timing of a force. Forces and accelerations act over the whole next step, at the body's orientation in
 * each substep, and are then gone; those of several calls add up. Impulses and velocities act at once. A force or
 * impulse also moves the added mass of fluid, (M + added)^-1 F; an acceleration or velocity takes full effect whatever
 * the mass. */
typedef int32_t lr_force_mode;
enum {
    LR_FORCE_MODE_FORCE = 0,        /* N, N m */
    LR_FORCE_MODE_ACCELERATION = 1, /* m/s^2, rad/s^2 */
    LR_FORCE_MODE_IMPULSE = 2,      /* N s, N m s */
    LR_FORCE_MODE_VELOCITY = 3,     /* m/s, rad/s: added to the body's */
};

/* The frame of a force. */
typedef int32_t lr_force_frame;
enum {
    LR_FRAME_WORLD = 0,
    LR_FRAME_BODY = 1, /* rotates with the body */
};

/* Options of a force on one body. */
typedef uint32_t lr_force_flags;
enum {
    LR_FORCE_AT_POINT = 1, /* `force` acts at `point`, not at the centre of mass; forces and impulses only */
};

/* A force and a torque on one body. Scale matters: a body of scale 2 has eight times the mass. */
typedef struct lr_body_force {
    uint32_t struct_size; /* equal in all elements of an array: also the array's stride */
    lr_force_mode mode;   /* LR_FORCE_MODE_*; default LR_FORCE_MODE_FORCE */
    lr_body body;
    lr_force_frame frame; /* LR_FRAME_*, of force, torque and point; default LR_FRAME_WORLD */
    lr_force_flags flags; /* LR_FORCE_*; default 0 */
    float force[3];       /* default 0 */
    float torque[3];      /* about the centre of mass; default 0 */
    float point[3];    /* m; world frame: a position, body frame: from the centre of mass. The lever arm is fixed by the
                          call */
    uint32_t reserved; /* 0 */
} lr_body_force;

LR_API lr_status lr_body_force_init(lr_body_force* force, uint32_t struct_size);

/* Applies `count` forces to bodies of any batches, all or none. A body may occur more than once. Each element may give
 * its body at most 1e9 m/s^2 (torques: 1e9 m/s^2 over its length), an impulse at most 1e6 m/s and rad/s. Pending forces
 * are part of snapshots and of the world's hash. The first force or acceleration on a body of a batch allocates 96
 * bytes for each body of the batch's capacity.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_body_add_force(lr_world* world, const lr_body_force* forces, uint32_t count);

/* Forces on consecutive bodies of one batch, in the order of its view. */
typedef struct lr_force_arrays {
    uint32_t struct_size;
    lr_force_mode mode;     /* LR_FORCE_MODE_*; default LR_FORCE_MODE_FORCE */
    lr_force_frame frame;   /* LR_FRAME_*; default LR_FRAME_WORLD */
    uint32_t first;         /* index in the view of the first body; default 0 */
    uint32_t count;         /* bodies */
    uint32_t stride;        /* bytes from one body's value to the next, a multiple of 4; default 0: 4, no gaps */
    const float* force[3];  /* x, y, z: `count` values each, not kept; all three or none */
    const float* torque[3]; /* x, y, z: `count` values each, not kept; all three or none */
} lr_force_arrays;

LR_API lr_status lr_force_arrays_init(lr_force_arrays* arrays, uint32_t struct_size);

/* Applies forces to many bodies of a batch; limits, snapshots and memory as for lr_body_add_force.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (some of three pointers), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE,
 * LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also if first + count exceeds the batch's bodies),
 * LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_add_forces(lr_world* world, lr_batch batch, const lr_force_arrays* arrays);

/* Forces on every body of a batch, until changed. All default to 0; each component up to 1e9 in magnitude. */
typedef struct lr_batch_force {
    uint32_t struct_size;
    uint32_t reserved;                  /* 0 */
    float force[3];                     /* N, world frame */
    float torque[3];                    /* N m, world frame */
    float acceleration[3];              /* m/s^2, world frame; of the body, whatever its mass */
    float angular_acceleration[3];      /* rad/s^2, world frame */
    float body_force[3];                /* N, body frame */
    float body_torque[3];               /* N m, body frame */
    float body_acceleration[3];         /* m/s^2, body frame */
    float body_angular_acceleration[3]; /* rad/s^2, body frame */
} lr_batch_force;

LR_API lr_status lr_batch_force_init(lr_batch_force* force, uint32_t struct_size);

/* Sets the forces on a batch from the next step on. The struct is copied; null clears them. A change wakes the batch's
 * sleeping bodies. Part of snapshots.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_set_force(lr_world* world, lr_batch batch, const lr_batch_force* force);

/* Reads the forces on every body of a batch. force: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_force(const lr_world* world, lr_batch batch, lr_batch_force* force);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Contact: colliders to land on, and contact between bodies. docs/maintainers/contact.md                             */

/* Colliders are shapes that bodies land on; bodies never push them. Create them, then move them with lr_collider_move.
 * Bodies touch each other only in batches that lr_batch_set_body_contact has paired. */

/* Shapes of colliders, in a frame of their own that `position` and `orientation` place in the world. size[] holds
 *   PLANE        nothing: everything below y = 0 is solid, without bounds
 *   SPHERE       the radius
 *   CAPSULE      the radius, and half the length of its axis from (0, -size[1], 0) to (0, size[1], 0)
 *   BOX          half extents along x, y, z
 *   HULL         nothing: the convex hull of `vertices`
 *   HEIGHTFIELD  nothing: solid below its surface, along -y. Sample (i, k) lies at
 *                (i spacing[0], heights[i + counts[0] k], k spacing[1]); the diagonal from (i, k) to (i + 1, k + 1)
 *                splits each cell into two triangles
 *   MESH         nothing: triangles without an inside. Both sides collide, and winding does not matter. A body pays for
 *                each triangle near it: 2 us a substep on triangles of its own size, 20 us on those of an eighth, 70 us on
 *                those of a sixteenth, far more on smaller ones. Give scanned scenery a coarser collision mesh
 */
typedef int32_t lr_collider_kind;
enum {
    LR_COLLIDER_PLANE = 1,
    LR_COLLIDER_SPHERE = 2,
    LR_COLLIDER_CAPSULE = 3,
    LR_COLLIDER_BOX = 4,
    LR_COLLIDER_HULL = 5,
    LR_COLLIDER_HEIGHTFIELD = 6,
    LR_COLLIDER_MESH = 7,
};

#define LR_MAX_COLLIDERS 67108864u         /* in a world, at a time */
#define LR_MAX_HULL_VERTICES 256u          /* of one hull */
#define LR_MAX_COLLIDER_VERTICES 67108864u /* vertices or triangles of one mesh, or heights of one heightfield */

/* A collider. Fields that its kind does not use are ignored. Arrays are copied. */
typedef struct lr_collider_desc {
    uint32_t struct_size;      /* equal in all elements of an array: also the array's stride */
    lr_collider_kind kind;     /* LR_COLLIDER_*; must be set: the default 0 is no kind */
    float position[3];         /* m, up to 1e9 in magnitude; default 0 */
    float orientation[4];      /* quaternion x y z w, normalised by the call; default 0 0 0 1 */
    float linear_velocity[3];  /* m/s, of the frame's origin, up to 1e6; default 0. Lasts until changed */
    float angular_velocity[3]; /* rad/s, world frame, up to 1e6; default 0. Lasts until changed */
    float size[3];             /* m, > 0, up to 1e6; default 0 */
    float friction;            /* 0 to 10; default 0.5 */
    float restitution;         /* 0 to 1; default 0.2 */
    uint32_t layers;           /* bits: collides with bodies that share at least one; default 1 */
    uint32_t flags;            /* 0 */
    uint32_t vertex_count;     /* hull: 4 to LR_MAX_HULL_VERTICES; mesh: 3 to LR_MAX_COLLIDER_VERTICES */
    uint32_t triangle_count;   /* mesh: 1 to LR_MAX_COLLIDER_VERTICES */
    uint32_t counts[2];        /* heightfield: samples along x and z, each >= 2 */
    float spacing[2];          /* heightfield: m between samples, 1e-6 to 1e6; default 1 */
    const float* vertices;     /* m, x y z each, up to 1e6 in magnitude */
    const uint32_t* indices;   /* 3 per triangle, each < vertex_count */
    const float* heights;      /* m, up to 1e6 in magnitude; x varies fastest */
} lr_collider_desc;

LR_API lr_status lr_collider_desc_init(lr_collider_desc* desc, uint32_t struct_size);

/* Creates `count` colliders, all or none, which collide from the next step on. Equal hulls, heightfields and meshes
 * share one copy of their data. descs: `count` elements. out_ids: receives `count` handles; may be null.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT (also for arrays that the kind needs), LR_ERROR_STRUCT_SIZE,
 * LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also for a flat hull, thinner than 1e-4 of its largest extent, and
 * for a mesh with an index out of range or no triangle with an area), LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_collider_create(lr_world* world, const lr_collider_desc* descs, uint32_t count,
                                    lr_collider* out_ids);

/* Destroys `count` colliders, all or none: a stale or repeated handle fails the call.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER. */
LR_API lr_status lr_collider_destroy(lr_world* world, const lr_collider* colliders, uint32_t count);

/* Returns 1 if the collider exists in this world, else 0. Never an error: see lr_body_is_valid. */
LR_API int32_t lr_collider_is_valid(const lr_world* world, lr_collider collider);

/* Ways to move a collider. */
typedef int32_t lr_move_mode;
enum {
    LR_MOVE_TO = 1,       /* sweeps to this pose during the next step, then stands still */
    LR_MOVE_PLACE = 2,    /* teleports to this pose, and moves with these velocities from now on */
    LR_MOVE_VELOCITY = 3, /* keeps its pose, and moves with these velocities from now on */
};

/* A motion of one collider. Within a step its position moves linearly and its orientation follows the normalised linear
 * quaternion, the shorter way round: rotations of more than half a turn per step appear shorter. */
typedef struct lr_collider_motion {
    uint32_t struct_size; /* equal in all elements of an array: also the array's stride */
    lr_move_mode mode;    /* LR_MOVE_*; default LR_MOVE_TO */
    lr_collider collider;
    float position[3];         /* m, as in lr_collider_desc; LR_MOVE_TO and LR_MOVE_PLACE; default 0 */
    float orientation[4];      /* quaternion x y z w; LR_MOVE_TO and LR_MOVE_PLACE; default 0 0 0 1 */
    float linear_velocity[3];  /* m/s; LR_MOVE_PLACE and LR_MOVE_VELOCITY; default 0 */
    float angular_velocity[3]; /* rad/s; LR_MOVE_PLACE and LR_MOVE_VELOCITY; default 0 */
    uint32_t reserved;         /* 0 */
} lr_collider_motion;

LR_API lr_status lr_collider_motion_init(lr_collider_motion* motion, uint32_t struct_size);

/* Moves `count` colliders, all or none, in order: the last motion of a collider wins. While a plane rotates, no body of
 * the world can use the fast path.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_STALE_COLLIDER, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_collider_move(lr_world* world, const lr_collider_motion* motions, uint32_t count);

typedef struct lr_collider_state {
    uint32_t struct_size;
    lr_collider_kind kind;     /* LR_COLLIDER_* */
    float position[3];         /* m, world frame */
    float orientation[4];      /* unit quaternion x y z w, collider to world */
    float linear_velocity[3];  /* m/s, that lasts until changed; 0 while LR_MOVE_TO is pending */
    float angular_velocity[3]; /* rad/s, world frame, that lasts until changed; 0 while LR_MOVE_TO is pending */
    float friction;
    float restitution;
    uint32_t layers;
    uint32_t flags; /* 0 */
} lr_collider_state;

LR_API lr_status lr_collider_state_init(lr_collider_state* state, uint32_t struct_size);

/* Reads the state of a collider. state: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_collider_get_state(const lr_world* world, lr_collider collider, lr_collider_state* state);

/* The material of a collider. */
typedef struct lr_material {
    uint32_t struct_size;
    uint32_t layers;   /* as in lr_collider_desc; default 1 */
    float friction;    /* as in lr_collider_desc; default 0.5 */
    float restitution; /* as in lr_collider_desc; default 0.2 */
} lr_material;

LR_API lr_status lr_material_init(lr_material* material, uint32_t struct_size);

/* Sets one material for `count` colliders, all or none, from the next step on. A change wakes bodies asleep on them.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_collider_set_material(lr_world* world, const lr_collider* colliders, uint32_t count,
                                          const lr_material* material);

/* Options of a batch's contact. */
typedef uint32_t lr_contact_flags;
enum {
    LR_CONTACT_NEVER_SLEEP = 1, /* bodies never fall asleep by themselves, only by lr_body_set_sleep */
};

/* How bodies of a batch collide. A contact uses the geometric mean of both frictions and the larger restitution. A body
 * collides as its hull, reduced to at most 32 points, or as an ellipsoid if its asset is one. */
typedef struct lr_batch_contact {
    uint32_t struct_size;
    uint32_t layers;          /* bits: collides with colliders that share at least one; default all; 0: none */
    float friction;           /* coefficient of Coulomb friction, 0 to 10; default 0.5 */
    float restitution;        /* speed after an impact over speed before it, 0 to 1; default 0.1 */
    float rolling_resistance; /* moment against rolling and spinning over normal force times lever, 0 to 10; default
                                 0.05. The lever is the geometric mean of reach and half the thickness: of a sphere, its
                                 radius */
    lr_contact_flags flags;   /* bits: LR_CONTACT_NEVER_SLEEP; default 0 */
    float ground_effect;      /* air cushion under a sheet that settles on a plane or heightfield, as a share of theory,
                                 0 to 1; default 0. docs/maintainers/contact.md */
    uint32_t reserved;        /* 0 */
    float min_thickness;      /* m, at scale 1, -1 to 10: sheets thinner than this meet other bodies as if they were so
                                 thick, at most a tenth of their reach; 0: 1/32 of it, at most 1.25 mm; below 0: as
                                 thick as they are, for decks of cards; default 0 */
} lr_batch_contact;

LR_API lr_status lr_batch_contact_init(lr_batch_contact* contact, uint32_t struct_size);

/* Sets how a batch collides from the next step on. The struct is copied; null restores the defaults. Wakes the batch's
 * sleeping bodies. Part of snapshots.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT. */
LR_API lr_status lr_batch_set_contact(lr_world* world, lr_batch batch, const lr_batch_contact* contact);

/* Reads how a batch collides. contact: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_contact(const lr_world* world, lr_batch batch, lr_batch_contact* contact);

/* Turns body contact on or off from the next step on: collisions between bodies of `a` and bodies of `b`, in either
 * order. Pass the same batch twice for collisions within it. Off by default. Contacts use friction, restitution and
 * rolling resistance of lr_batch_contact, combined as there; layers apply to colliders only. Bodies of batches stepped
 * at different rates (lr_batch_set_rate), or waiting for the budget, collide only while one of the two is asleep. A
 * change wakes the sleeping bodies of both batches. Part of snapshots. A batch's first pair allocates 28 bytes for each
 * body of its capacity, and up to 75 more if the world has never had colliders. docs/maintainers/contact.md.
 * enabled: 0 or 1.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH (either), LR_ERROR_INVALID_ARGUMENT (enabled),
 * LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_set_body_contact(lr_world* world, lr_batch a, lr_batch b, int32_t enabled);

/* Reads whether bodies of two batches collide. enabled: receives 0 or 1; unchanged after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH (either). */
LR_API lr_status lr_batch_get_body_contact(const lr_world* world, lr_batch a, lr_batch b, int32_t* enabled);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Events: spawns, hits, landings, wake-ups, ends and divergence. docs/reference/bodies.md                            */

/* Enable events once with lr_world_set_events; after each step read them with lr_world_get_events. */

/* Kinds of events. */
typedef int32_t lr_event_kind;
enum {
    LR_EVENT_SPAWNED = 1,   /* an emitter, lr_batch_spawn or lr_batch_spawn_box added it since the previous step */
    LR_EVENT_HIT = 2,       /* the body touches a collider that it did not touch at the end of the step before */
    LR_EVENT_LIFTED = 3,    /* it no longer touches the collider, or the collider was destroyed: its id is stale */
    LR_EVENT_LANDED = 4,    /* it fell asleep by itself */
    LR_EVENT_WOKE = 5,      /* it woke since the previous step, for any reason */
    LR_EVENT_KILLED = 6,    /* its batch's rules or its divergence destroyed it: its id is stale */
    LR_EVENT_RESPAWNED = 7, /* its batch's rules or its divergence ended it, and it restarted with its id */
    LR_EVENT_DIVERGED = 8,  /* it diverged: lr_batch_set_divergence_policy */
};

/* Bits for lr_world_set_events. */
typedef uint32_t lr_event_kinds;
enum {
    LR_EVENTS_SPAWNED = 1,
    LR_EVENTS_HIT = 2,
    LR_EVENTS_LIFTED = 4,
    LR_EVENTS_LANDED = 8,
    LR_EVENTS_WOKE = 16,
    LR_EVENTS_KILLED = 32,
    LR_EVENTS_RESPAWNED = 64,
    LR_EVENTS_DIVERGED = 128,
    LR_EVENTS_ALL = 255,
};

/* One event: 64 bytes in arrays without gaps. This struct never changes after 0.2. */
typedef struct lr_event {
    lr_event_kind kind; /* LR_EVENT_* */
    lr_batch batch;
    lr_body body;         /* stale if it was destroyed */
    uint64_t user;        /* the body's: lr_body_desc.user */
    lr_collider collider; /* LR_EVENT_HIT, LR_EVENT_LIFTED; else id 0 */
    float position[3];    /* m, world frame: the point of contact in LR_EVENT_HIT; where it ended in LR_EVENT_KILLED and
                             LR_EVENT_RESPAWNED; the last valid centre of mass in LR_EVENT_DIVERGED; else the centre of
                             mass */
    float normal[3];      /* LR_EVENT_HIT: unit, world frame, from the collider to the body; else 0 */
    float speed;          /* m/s, LR_EVENT_HIT: approach speed along the normal, >= 0; else 0 */
    float impulse;        /* N s, LR_EVENT_HIT: along the normal, in the substep of first contact; else 0 */
} lr_event;

/* Enables events; at most `capacity` are stored per step. Contacts that already exist do not begin again. capacity 0
 * disables events. All memory is allocated here and by lr_batch_create, none in steps: 64 bytes per event, and 233 for
 * each body of a batch's capacity. Not part of the world's hash. Snapshots contain only events that calls since the
 * last step have left for the next one, 33 bytes for each body of a batch's capacity. kinds: bits LR_EVENTS_*.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (unknown bits, or no bits with a capacity),
 * LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_world_set_events(lr_world* world, uint32_t capacity, lr_event_kinds kinds);

typedef struct lr_event_list {
    uint32_t struct_size;
    uint32_t count;
    const lr_event* events; /* of the last step; null before lr_world_set_events */
    uint64_t lost;          /* events of the last step beyond capacity: those last in order are dropped */
    uint64_t total_lost;    /* since lr_world_set_events */
    uint32_t capacity;      /* as set by lr_world_set_events */
    lr_event_kinds kinds;   /* bits LR_EVENTS_*, likewise */
} lr_event_list;

LR_API lr_status lr_event_list_init(lr_event_list* list, uint32_t struct_size);

/* Gets the events of the last step. Valid until the next call that is not a query; empty after
 * lr_world_snapshot_restore. Sorted by batch (its place in the world's table), noise seed, kind and collider slot, so
 * the order does not depend on workers, processor or memory. Bodies with the same noise seed are sorted by slot.
 * Contacts are checked after each substep but end only at the end of a step: a body that bounces within a step begins
 * one contact, and one that touches and leaves begins and ends it. A sleeping body still touches its support. A body
 * that ends has one LR_EVENT_KILLED or LR_EVENT_RESPAWNED, and before it at most LR_EVENT_SPAWNED, after it at most
 * LR_EVENT_DIVERGED. lr_body_destroy and lr_batch_destroy cause no event. A body has at most four contacts, those that
 * press it most. Contact with other bodies takes one of the four and causes no events, but a body that falls asleep on
 * other bodies has landed.
 * list: initialised, or with struct_size set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_world_get_events(const lr_world* world, lr_event_list* list);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Queries: ray casts and overlap tests. docs/reference/bodies.md                                                     */

/* Targets of a ray. */
typedef uint32_t lr_ray_flags;
enum {
    LR_RAY_BODIES = 1,
    LR_RAY_COLLIDERS = 2,
};

typedef struct lr_ray {
    uint32_t struct_size;     /* equal in all elements of an array: also the array's stride */
    lr_ray_flags flags;       /* bits LR_RAY_*: what it can hit; default both */
    float origin[3];          /* m, up to 1e9 in magnitude; default 0 */
    float direction[3];       /* any length from 1e-6 to 1e6; default 0, -1, 0 */
    float max_distance;       /* m, 0 to 1e9; default 1e9 */
    lr_batch batch;           /* hits bodies of this batch only; default id 0: of all batches */
    uint32_t collider_layers; /* bits: hits colliders that share at least one; default all */
    uint32_t reserved;        /* 0 */
} lr_ray;

LR_API lr_status lr_ray_init(lr_ray* ray, uint32_t struct_size);

/* The first hit of a ray, all 0 if there is none: 56 bytes in arrays without gaps. This struct never changes after
 * 0.2. */
typedef struct lr_ray_hit {
    lr_body body;         /* id 0: it hit a collider */
    uint64_t user;        /* the body's: lr_body_desc.user */
    lr_collider collider; /* id 0: it hit a body */
    float distance;       /* m, from the ray's origin */
    float position[3];    /* m, world frame */
    float normal[3];      /* unit, world frame, outward. If the ray starts inside: against the ray, at distance 0 */
    uint32_t reserved;    /* 0 */
} lr_ray_hit;

/* Finds the first hit of each ray. Bodies have their contact shape, the hull of their asset or an ellipsoid
 * (docs/maintainers/contact.md); bodies of waiting batches (lr_batch_set_rate) are where they were last stepped. Planes
 * and heightfields are solid below their surface; meshes are hit from both sides. Colliders are where the last step or
 * lr_collider_move put them. Hits at equal distances are sorted: bodies before colliders, then by batch and noise seed
 * or by collider slot.
 * rays: `count` elements. hits: receives `count` elements; none are written after an error.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_STALE_BATCH. */
LR_API lr_status lr_world_ray_cast(const lr_world* world, const lr_ray* rays, uint32_t count, lr_ray_hit* hits);

/* Shapes of overlap queries. */
typedef int32_t lr_overlap_shape;
enum {
    LR_OVERLAP_SPHERE = 1, /* size[0]: radius */
    LR_OVERLAP_BOX = 2,    /* size: half extents along its own axes */
};

typedef struct lr_overlap_desc {
    uint32_t struct_size;
    lr_overlap_shape shape; /* LR_OVERLAP_*; default LR_OVERLAP_SPHERE */
    float position[3];      /* m, of its centre, up to 1e9 in magnitude; default 0 */
    float orientation[4];   /* of a box, x y z w, normalised by the call; default 0 0 0 1 */
    float size[3];          /* m, > 0, up to 1e6; default 1 */
    lr_batch batch;         /* finds bodies of this batch only; default id 0: of all batches */
    uint32_t reserved;      /* 0 */
} lr_overlap_desc;

LR_API lr_status lr_overlap_desc_init(lr_overlap_desc* desc, uint32_t struct_size);

/* Finds all bodies that overlap a sphere or box, sorted by batch, noise seed and slot. Shapes and places of bodies are
 * as for rays. bodies: room for `capacity` ids; may be null when capacity is 0. count: receives how many there are.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT,
 * LR_ERROR_STALE_BATCH, LR_ERROR_BUFFER_TOO_SMALL: *count is set, and the contents of `bodies` are undefined. */
LR_API lr_status lr_world_overlap(const lr_world* world, const lr_overlap_desc* desc, lr_body* bodies,
                                  uint32_t capacity, uint32_t* count);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Emitters and rules: spawning and ending bodies automatically. docs/reference/bodies.md                             */

/* An emitter spawns bodies, rules end or respawn them: together they keep a storm running. Both act at the end of each
 * step, rules first. */

/* The fate of a body that its batch's rules end. */
typedef int32_t lr_end_action;
enum {
    LR_END_DESTROY = 0, /* the body is destroyed and its id becomes stale */
    LR_END_RESPAWN = 1, /* the body restarts where the batch's emitter puts it, at age 0, with its id and noise seed */
};

/* Shapes of kill volumes. */
typedef int32_t lr_volume_shape;
enum {
    LR_VOLUME_PLANE = 0,  /* `size` is its normal, `center` a point of it; inside: behind it, away from the normal */
    LR_VOLUME_BOX = 1,    /* axis-aligned; size: half extents */
    LR_VOLUME_SPHERE = 2, /* size[0]: radius */
};

/* The side of a kill volume on which bodies end. */
typedef int32_t lr_kill_side;
enum {
    LR_KILL_INSIDE = 0,
    LR_KILL_OUTSIDE = 1,
};

typedef struct lr_kill_volume {
    lr_volume_shape shape; /* LR_VOLUME_* */
    lr_kill_side side;     /* LR_KILL_*: the side on which bodies end */
    float center[3];       /* m, up to 1e9 in magnitude */
    float size[3];         /* m; of a plane its normal, any length but 0 */
} lr_kill_volume;

#define LR_MAX_KILL_VOLUMES 8u

/* When the bodies of a batch end. Diverged bodies end under any rules, unless lr_batch_set_divergence_policy holds
 * them. */
typedef struct lr_batch_rules {
    uint32_t struct_size;
    lr_end_action action;                        /* LR_END_*; default LR_END_DESTROY */
    float max_age;                               /* s, up to 1e9; default 0: no limit */
    uint32_t volume_count;                       /* elements of `volumes` in use; default 0 */
    lr_kill_volume volumes[LR_MAX_KILL_VOLUMES]; /* tested with the centre of mass */
} lr_batch_rules;

LR_API lr_status lr_batch_rules_init(lr_batch_rules* rules, uint32_t struct_size);

/* Sets the rules of a batch. Awake bodies are checked at the end of each step, sleeping ones in every 16th step of
 * their batch. The struct is copied; null removes the rules. Part of snapshots. A batch's first rules or emitter
 * allocate 8 bytes for each body of its capacity; later calls, such as moving a volume along with a camera, allocate
 * nothing.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT (also LR_END_RESPAWN without an emitter), LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_set_rules(lr_world* world, lr_batch batch, const lr_batch_rules* rules);

/* Reads the rules of a batch. rules: initialised, or with struct_size set; receives initial values if there are none.
 * present: receives 1 or 0.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_rules(const lr_world* world, lr_batch batch, lr_batch_rules* rules, int32_t* present);

/* The fate of a diverged body. */
typedef int32_t lr_divergence_policy;
enum {
    LR_DIVERGENCE_AUTO = 0,   /* LR_DIVERGENCE_REMOVE in a batch with rules, else LR_DIVERGENCE_FREEZE */
    LR_DIVERGENCE_FREEZE = 1, /* the body is held where it was last valid */
    LR_DIVERGENCE_REMOVE = 2, /* the body respawns if the batch's rules respawn, else it is destroyed */
};

/* Sets how a batch treats diverged bodies: those with a number that is not finite, a coordinate over 1e10 m, a velocity
 * over 2e6 m/s or 1e9 rad/s, or an invalid orientation. Bodies diverge through extreme forces, an unstable integrator,
 * or a collider that shoots them out of the world. Every body is checked in each step and after impulses, so such
 * values are never visible and never affect other bodies. At the end of the step the body causes LR_EVENT_DIVERGED and
 * counts in lr_batch_counts; one message is logged for all. docs/reference/bodies.md
 * A held body stays at its position and orientation from the beginning of that step or substep, without velocity. It
 * collides with nothing, and forces on it are accepted without effect. It ages, and rules can end it. lr_body_set_state
 * frees it, lr_body_set_sleep can put it to sleep, and lr_body_state.sleep_state shows that it is held.
 * Takes effect at the next step; bodies already held stay held. Part of snapshots and of the world's hash.
 * LR_DIVERGENCE_REMOVE allocates as lr_batch_set_rules does.
 * policy: LR_DIVERGENCE_*; default LR_DIVERGENCE_AUTO.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_set_divergence_policy(lr_world* world, lr_batch batch, lr_divergence_policy policy);

/* Reads how a batch treats diverged bodies. policy: receives LR_DIVERGENCE_*; unchanged after an error.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH. */
LR_API lr_status lr_batch_get_divergence_policy(const lr_world* world, lr_batch batch, lr_divergence_policy* policy);

/* Shapes in which an emitter spawns bodies. */
typedef int32_t lr_emitter_shape;
enum {
    LR_EMIT_POINT = 0,
    LR_EMIT_BOX = 1,            /* filled evenly */
    LR_EMIT_SPHERE = 2,         /* filled evenly */
    LR_EMIT_DISC = 3,           /* filled evenly, in the plane of the shape's x and y axes */
    LR_EMIT_BOX_SURFACE = 4,    /* covered evenly */
    LR_EMIT_SPHERE_SURFACE = 5, /* covered evenly if its three sizes are equal */
};

/* Orientations of spawned bodies. */
typedef int32_t lr_emitter_pose;
enum {
    LR_POSE_RANDOM = 0, /* every orientation is equally likely */
    LR_POSE_FIXED = 1,  /* body_orientation */
};

/* How bodies of a batch spawn. Random values depend only on the world's seed, the body's noise seed, and the number of
 * times it has respawned. */
typedef struct lr_emitter_desc {
    uint32_t struct_size;
    lr_emitter_shape shape;     /* LR_EMIT_*; default LR_EMIT_POINT */
    float position[3];          /* m, centre of the shape; default 0 */
    float orientation[4];       /* of the shape, x y z w, normalised by the call; default 0 0 0 1 */
    float size[3];              /* m, half extents or semi-axes along the shape's own axes, 0 to 1e9; default 0 */
    lr_emitter_pose pose;       /* LR_POSE_*, of the bodies; default LR_POSE_RANDOM */
    float body_orientation[4];  /* body to world, normalised by the call; default 0 0 0 1 */
    float direction[3];         /* of the velocity, world frame, any length but 0; default 0, -1, 0 */
    float spread;               /* rad, half angle of a cone about `direction`, filled evenly, 0 to pi; default 0 */
    float speed_min, speed_max; /* m/s, uniform in this range; default 0 */
    float spin_min, spin_max;   /* rad/s, uniform in this range, about a random axis; default 0 */
    float scale_min, scale_max; /* uniform in this range; default 1 */
    float rate;                 /* spawns per second, 0 to 1e9; default 0: bodies respawn, but none are added */
    float burst_interval;       /* s between bursts, >= 1e-4 */
    uint32_t burst_count;       /* spawns in each burst; default 0: no bursts */
    uint32_t reserved;          /* 0 */
} lr_emitter_desc;

LR_API lr_status lr_emitter_desc_init(lr_emitter_desc* desc, uint32_t struct_size);

/* Sets the emitter of a batch. Bodies spawn at the end of each step, after rules have ended others, up to the batch's
 * capacity; spawns beyond it are dropped, not postponed. New bodies take the world's next noise seeds, and 0 as `user`.
 * The struct is copied; null removes the emitter. A replacement keeps the pending fraction of a spawn and the time since
 * the last burst. Part of snapshots. Allocates as lr_batch_set_rules does.
 * LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT (also null while the rules respawn), LR_ERROR_OUT_OF_MEMORY. */
LR_API lr_status lr_batch_set_emitter(lr_world* world, lr_batch batch, const lr_emitter_desc* desc);

/* Reads the emitter of a batch. desc: initialised, or with struct_size set; receives initial values if there is none.
 * present: receives 1 or 0.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_emitter(const lr_world* world, lr_batch batch, lr_emitter_desc* desc, int32_t* present);

/* Spawns `count` bodies now, all or none. out_ids: receives `count` ids; may be null.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT (no emitter),
 * LR_ERROR_CAPACITY. */
LR_API lr_status lr_batch_spawn(lr_world* world, lr_batch batch, uint32_t count, lr_body* out_ids);

/* Spawns `count` bodies in a box now, all or none, without an emitter: awake, evenly distributed, each orientation
 * equally likely, at rest, scale 1, age 0, with the world's next noise seeds. Random values depend only on the world's
 * seed and the body's noise seed, as with an LR_EMIT_BOX emitter. Causes LR_EVENT_SPAWNED. Allocates nothing, and so
 * counts in lr_batch_counts only while the batch has rules or an emitter. low, high: x, y, z of the corners, m, each up
 * to 1e9 in magnitude, low <= high. out_ids: receives `count` ids; may be null.
 * LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_NOT_FINITE,
 * LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY. */
LR_API lr_status lr_batch_spawn_box(lr_world* world, lr_batch batch, const float* low, const float* high,
                                    uint32_t count, lr_body* out_ids);

/* Numbers of bodies that rules ended and the emitter spawned in the last step, and totals since the batch was created.
 * lr_world_get_events names the bodies. */
typedef struct lr_batch_counts {
    uint32_t struct_size;
    uint32_t spawned;   /* by rate and bursts */
    uint32_t destroyed; /* by the rules */
    uint32_t respawned;
    uint32_t missed; /* spawns dropped for lack of room */
    /* Why bodies ended: the first cause that applied, in this order. */
    uint32_t by_divergence; /* diverged: lr_batch_set_divergence_policy */
    uint32_t by_age;
    uint32_t by_volume[LR_MAX_KILL_VOLUMES];
    uint32_t diverged;      /* bodies that diverged in the last step, held or ended */
    uint64_t total_spawned; /* including lr_batch_spawn, lr_batch_spawn_box */
    uint64_t total_destroyed;
    uint64_t total_respawned;
    uint64_t total_missed;
    uint64_t total_diverged;
} lr_batch_counts;

LR_API lr_status lr_batch_counts_init(lr_batch_counts* counts, uint32_t struct_size);

/* Reads the counts of a batch. A batch that never had rules or an emitter counts only diverged bodies. Totals
 * are part of snapshots; after a restore the counts of the last step are 0. counts: initialised, or with struct_size
 * set.
 * LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE. */
LR_API lr_status lr_batch_get_counts(const lr_world* world, lr_batch batch, lr_batch_counts* counts);

/* ------------------------------------------------------------------------------------------------------------------ */
/* Initial values                                                                                                     */

/* The values that the _init functions set, as initialisers: lr_body_desc desc = LR_BODY_DESC_INIT; */
/* clang-format off */
#define LR_ELLIPSOID_DESC_INIT {sizeof(lr_ellipsoid_desc), 0, {0}, 0, 1.2, 1.5e-5, 1, {0}}
#define LR_ASSET_INFO_INIT {sizeof(lr_asset_info), 0, {0}, 0, 0, 0, {0}, {0}, {0}, {0}, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, \
    0, 0, 0, 0}
#define LR_WORLD_DESC_INIT {sizeof(lr_world_desc), 0, 0, {0, -9.81f, 0}, 0, LR_SIMD_AUTO, 0, {0, 0, 0}, 0, 0, \
    {0, 0, 0}, 0, 0}
#define LR_WORLD_INFO_INIT {sizeof(lr_world_info), LR_SIMD_AUTO, 0, 0, 0, 0, 0, 0, 0, 0, 0, {0}, 0}
#define LR_GUSTS_DESC_INIT {sizeof(lr_gusts_desc), 0, {1, 0, 0}, 1, 0.1f, 0}
#define LR_VORTEX_DESC_INIT {sizeof(lr_vortex_desc), LR_VORTEX_LAMB_OSEEN, {0}, {0, 1, 0}, {0}, 1, 1, 0, 0}
#define LR_BLOWER_DESC_INIT {sizeof(lr_blower_desc), {0}, {1, 0, 0}, {0, 0, 1}, {0}, 1, 1, 0, 10, 0.1f}
#define LR_TURBULENCE_DESC_INIT {sizeof(lr_turbulence_desc), 0, 2, {0}, 1, 1, 0}
#define LR_WIND_GRID_DESC_INIT {sizeof(lr_wind_grid_desc), LR_WIND_OUTSIDE_ZERO, {0}, {0}, {1, 1, 1}, {0}, 1, 0, 0}
#define LR_GROUND_WIND_DESC_INIT {sizeof(lr_ground_wind_desc), {0}, {0, 1, 0}, {0}, 0.03f, 10}
#define LR_WATER_DESC_INIT {sizeof(lr_water_desc), 0, {0}, {0, 1, 0}, 998, 1e-6f, {0}, 0, {{{0}, 0, 0, 0}}}
#define LR_STEP_REPORT_INIT {sizeof(lr_step_report), 0, 0, 0, 0, 0, 0, 0}
#define LR_TIMINGS_INIT {sizeof(lr_timings), 0, 0, 0, 0, 0, 0, 0, 0, 0}
#define LR_RECORDING_DESC_INIT {sizeof(lr_recording_desc), LR_RECORD_CALLBACKS, 1, 0, 0, 0}
#define LR_BATCH_DESC_INIT {sizeof(lr_batch_desc), 0, 0, LR_LOADS_DEFAULT, LR_CLOCK_SPEED, LR_TABLE_CLAMP, \
    LR_INTEGRATOR_DEFAULT, 1, 1, 0.15f, 0}
#define LR_LOAD_GAINS_INIT {sizeof(lr_load_gains), 0, 1, 1, 1, 1}
#define LR_BATCH_PACE_INIT {sizeof(lr_batch_pace), 0, 0, 0, 0, 0, 0}
#define LR_BATCH_VIEW_INIT {sizeof(lr_batch_view), 0, {0}, {0}, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}
#define LR_BODY_DESC_INIT {sizeof(lr_body_desc), 0, {0}, {0, 0, 0, 1}, {0}, {0}, 1, 0, 0, 0}
#define LR_BODY_STATE_INIT {sizeof(lr_body_state), 0, {0}, {0, 0, 0, 1}, {0}, {0}, 1, 0, LR_SLEEP_AWAKE, 0}
#define LR_BODY_FORCE_INIT {sizeof(lr_body_force), LR_FORCE_MODE_FORCE, {0}, LR_FRAME_WORLD, 0, {0}, {0}, {0}, 0}
#define LR_FORCE_ARRAYS_INIT {sizeof(lr_force_arrays), LR_FORCE_MODE_FORCE, LR_FRAME_WORLD, 0, 0, 0, {0}, {0}}
#define LR_BATCH_FORCE_INIT {sizeof(lr_batch_force), 0, {0}, {0}, {0}, {0}, {0}, {0}, {0}, {0}}
#define LR_COLLIDER_DESC_INIT {sizeof(lr_collider_desc), 0, {0}, {0, 0, 0, 1}, {0}, {0}, {0}, 0.5f, 0.2f, 1, 0, 0, 0, \
    {0}, {1, 1}, 0, 0, 0}
#define LR_COLLIDER_MOTION_INIT {sizeof(lr_collider_motion), LR_MOVE_TO, {0}, {0}, {0, 0, 0, 1}, {0}, {0}, 0}
#define LR_COLLIDER_STATE_INIT {sizeof(lr_collider_state), 0, {0}, {0, 0, 0, 1}, {0}, {0}, 0, 0, 0, 0}
#define LR_MATERIAL_INIT {sizeof(lr_material), 1, 0.5f, 0.2f}
#define LR_BATCH_CONTACT_INIT {sizeof(lr_batch_contact), 0xffffffffu, 0.5f, 0.1f, 0.05f, 0, 0, 0, 0}
#define LR_EVENT_LIST_INIT {sizeof(lr_event_list), 0, 0, 0, 0, 0, 0}
#define LR_RAY_INIT {sizeof(lr_ray), LR_RAY_BODIES | LR_RAY_COLLIDERS, {0}, {0, -1, 0}, 1e9f, {0}, 0xffffffffu, \
    0}
#define LR_OVERLAP_DESC_INIT {sizeof(lr_overlap_desc), LR_OVERLAP_SPHERE, {0}, {0, 0, 0, 1}, {1, 1, 1}, {0}, 0}
#define LR_BATCH_RULES_INIT {sizeof(lr_batch_rules), LR_END_DESTROY, 0, 0, \
    {{LR_VOLUME_PLANE, LR_KILL_INSIDE, {0}, {0}}}}
#define LR_EMITTER_DESC_INIT {sizeof(lr_emitter_desc), LR_EMIT_POINT, {0}, {0, 0, 0, 1}, {0}, LR_POSE_RANDOM, \
    {0, 0, 0, 1}, {0, -1, 0}, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0}
#define LR_BATCH_COUNTS_INIT {sizeof(lr_batch_counts), 0, 0, 0, 0, 0, 0, {0}, 0, 0, 0, 0, 0, 0}
/* clang-format on */

#ifdef __cplusplus
}
#endif

#endif /* LANGEVIN_RIGID_H */
