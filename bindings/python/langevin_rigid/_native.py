# SPDX-License-Identifier: MIT
# Generated from include/langevin_rigid.h by bindings/generator/python.py: do not edit.

"""The C API for ctypes: types, constants and prototypes of every function, under their C names."""
# flake8: noqa
import ctypes

VERSION = (0, 2, 0)  # of the header behind this file

LR_OK = 0
LR_ERROR_NULL_ARGUMENT = -1
LR_ERROR_STRUCT_SIZE = -2
LR_ERROR_INVALID_ARGUMENT = -3
LR_ERROR_NOT_FINITE = -4
LR_ERROR_OUT_OF_MEMORY = -5
LR_ERROR_STALE_BODY = -6
LR_ERROR_STALE_BATCH = -7
LR_ERROR_CAPACITY = -8
LR_ERROR_BUFFER_TOO_SMALL = -9
LR_ERROR_FILE_NOT_FOUND = -10
LR_ERROR_FILE_READ = -11
LR_ERROR_ASSET_FORMAT = -12
LR_ERROR_ASSET_VERSION = -13
LR_ERROR_ASSET_CORRUPT = -14
LR_ERROR_ASSET_INVALID = -15
LR_ERROR_SNAPSHOT_FORMAT = -16
LR_ERROR_SNAPSHOT_MISMATCH = -17
LR_ERROR_UNSUPPORTED = -18
LR_ERROR_THREADS = -19
LR_ERROR_TIMESTEP_ZERO = -20
LR_ERROR_TIMESTEP_NEGATIVE = -21
LR_ERROR_TIMESTEP_NOT_FINITE = -22
LR_ERROR_TIMESTEP_TOO_LARGE = -23
LR_ERROR_SUBSTEPS = -24
LR_ERROR_INTERNAL = -25
LR_ERROR_STALE_WIND_SOURCE = -26
LR_ERROR_STALE_COLLIDER = -27
LR_ERROR_CONCURRENT_USE = -28
LR_ERROR_REENTRANT = -29
LR_MAX_SUBSTEP = 1.0
LR_MAX_SUBSTEPS = 65536
LR_LOG_ERROR = 1
LR_LOG_WARNING = 2
LR_LOG_INFO = 3
LR_SIMD_AUTO = 0
LR_SIMD_SSE4 = 1
LR_SIMD_AVX2 = 2
LR_SIMD_AVX512 = 3
LR_SIMD_NEON = 4
LR_SIMD_WASM = 5
LR_SIMD_PLAIN = 6
LR_ASSET_DIAGONAL = 1
LR_ASSET_SYMMETRIC = 2
LR_CHECK_THREADS = 1
LR_MAX_WIND_SOURCES = 64
LR_VORTEX_LAMB_OSEEN = 0
LR_VORTEX_RANKINE = 1
LR_WIND_OUTSIDE_ZERO = 0
LR_WIND_OUTSIDE_CLAMP = 1
LR_WIND_OUTSIDE_REPEAT = 2
LR_MAX_WIND_SAMPLES = 67108864
LR_MAX_WAVES = 8
LR_RECORD_CALLBACKS = 1
LR_LOADS_DEFAULT = 0
LR_LOADS_NONE = 1
LR_LOADS_LANGEVIN = 2
LR_LOADS_AERODYNAMIC = 3
LR_CLOCK_SPEED = 0
LR_CLOCK_AGE = 1
LR_TABLE_CLAMP = 0
LR_TABLE_LOOP = 1
LR_INTEGRATOR_DEFAULT = 0
LR_INTEGRATOR_RK4 = 1
LR_INTEGRATOR_SPLITTING = 2
LR_TRANSFORM_POSITION_QUATERNION = 0
LR_TRANSFORM_POSITION_QUATERNION_SCALE = 1
LR_TRANSFORM_3X4_ROW_MAJOR = 2
LR_TRANSFORM_3X4_COLUMN_MAJOR = 3
LR_TRANSFORM_4X4_ROW_MAJOR = 4
LR_TRANSFORM_4X4_COLUMN_MAJOR = 5
LR_SLEEP_AWAKE = 0
LR_SLEEP_ASLEEP = 1
LR_SLEEP_HELD = 2
LR_FORCE_MODE_FORCE = 0
LR_FORCE_MODE_ACCELERATION = 1
LR_FORCE_MODE_IMPULSE = 2
LR_FORCE_MODE_VELOCITY = 3
LR_FRAME_WORLD = 0
LR_FRAME_BODY = 1
LR_FORCE_AT_POINT = 1
LR_COLLIDER_PLANE = 1
LR_COLLIDER_SPHERE = 2
LR_COLLIDER_CAPSULE = 3
LR_COLLIDER_BOX = 4
LR_COLLIDER_HULL = 5
LR_COLLIDER_HEIGHTFIELD = 6
LR_COLLIDER_MESH = 7
LR_MAX_COLLIDERS = 67108864
LR_MAX_HULL_VERTICES = 256
LR_MAX_COLLIDER_VERTICES = 67108864
LR_MOVE_TO = 1
LR_MOVE_PLACE = 2
LR_MOVE_VELOCITY = 3
LR_CONTACT_NEVER_SLEEP = 1
LR_EVENT_SPAWNED = 1
LR_EVENT_HIT = 2
LR_EVENT_LIFTED = 3
LR_EVENT_LANDED = 4
LR_EVENT_WOKE = 5
LR_EVENT_KILLED = 6
LR_EVENT_RESPAWNED = 7
LR_EVENT_DIVERGED = 8
LR_EVENTS_SPAWNED = 1
LR_EVENTS_HIT = 2
LR_EVENTS_LIFTED = 4
LR_EVENTS_LANDED = 8
LR_EVENTS_WOKE = 16
LR_EVENTS_KILLED = 32
LR_EVENTS_RESPAWNED = 64
LR_EVENTS_DIVERGED = 128
LR_EVENTS_ALL = 255
LR_RAY_BODIES = 1
LR_RAY_COLLIDERS = 2
LR_OVERLAP_SPHERE = 1
LR_OVERLAP_BOX = 2
LR_END_DESTROY = 0
LR_END_RESPAWN = 1
LR_VOLUME_PLANE = 0
LR_VOLUME_BOX = 1
LR_VOLUME_SPHERE = 2
LR_KILL_INSIDE = 0
LR_KILL_OUTSIDE = 1
LR_MAX_KILL_VOLUMES = 8
LR_DIVERGENCE_AUTO = 0
LR_DIVERGENCE_FREEZE = 1
LR_DIVERGENCE_REMOVE = 2
LR_EMIT_POINT = 0
LR_EMIT_BOX = 1
LR_EMIT_SPHERE = 2
LR_EMIT_DISC = 3
LR_EMIT_BOX_SURFACE = 4
LR_EMIT_SPHERE_SURFACE = 5
LR_POSE_RANDOM = 0
LR_POSE_FIXED = 1


class lr_world(ctypes.Structure):
    """Used only through pointers."""


class lr_asset(ctypes.Structure):
    """Used only through pointers."""


lr_task_fn = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_uint32, ctypes.c_uint32)
lr_task_fn.__doc__ = """Runs the world's tasks on an engine's job system instead of on threads of its own: docs/reference/stepping.md. Set
both functions or neither.

`enqueue` starts a task: call run(task, begin, end) for ranges that together cover each index from 0 to count - 1
exactly once. Any split, order and threads will do, from one call for all indices to a parallel-for, and calls may be
made inside `enqueue`. All must have returned when `finish` returns. The returned token is passed to `finish`; any
value is allowed.
`finish` waits for the task. It is called exactly once for each `enqueue`, on the same thread. While it waits, it
should run calls that have not started: the stepping thread does its share of the work first, so these find nothing
left to do and return at once.

An index stands for a thread, not for a piece of work: tasks share out the work among themselves, so the split
affects speed, never results. Both functions are called only during lr_world_step, on the thread that called it and
in that thread's floating-point mode; tasks set and restore their own. Neither may throw, longjmp, or call the
library on the same world. Do not call run() after `finish`. A task needs 192 KB of stack.
"""


lr_log_fn = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int32, ctypes.c_char_p)
lr_log_fn.__doc__ = """Receives a log message, valid during the call only. Called on the thread that calls the library; with
LR_CHECK_THREADS possibly while another thread is inside a call on the world. Must not call the library on the same
world. May be null.
"""


lr_fault_fn = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_uint32, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_char_p)
lr_fault_fn.__doc__ = """Receives one numbered fault of an asset file; docs/reference/asset_format.md lists them. Strings are valid during the
call only.
"""


class lr_wind_query(ctypes.Structure):
    """Input and output of a wind callback. Arrays hold one value per body."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('count', ctypes.c_uint32),
        ('batch', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('time', ctypes.c_double),
        ('position', ctypes.POINTER(ctypes.c_float) * 3),
        ('velocity', ctypes.POINTER(ctypes.c_float) * 3),
        ('rate', ctypes.POINTER(ctypes.c_float) * 3),
        ('gradient', ctypes.POINTER(ctypes.c_float) * 9),
    ]


lr_wind_fn = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.POINTER(lr_wind_query))
lr_wind_fn.__doc__ = """Called with each body once per substep, in no particular order. Calls come at the same time from the stepping thread
and from the world's workers or the job system's threads; with worker_count 0 from the stepping thread alone. For a
deterministic world the results must depend only on position, time and batch. Must not call the library on the same
world, throw, or keep pointers. If a body's results are not finite, or exceed 1000 m/s, all of them are taken as 0,
and one warning is logged after the step.
"""


class lr_water_query(ctypes.Structure):
    """Input and output of a water surface callback. Arrays hold one value per body; outputs are preset to the values of the
    plane and its waves, each wave as its mean over the body.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('count', ctypes.c_uint32),
        ('batch', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('time', ctypes.c_double),
        ('position', ctypes.POINTER(ctypes.c_float) * 3),
        ('height', ctypes.POINTER(ctypes.c_float)),
        ('normal', ctypes.POINTER(ctypes.c_float) * 3),
        ('velocity', ctypes.POINTER(ctypes.c_float) * 3),
        ('rate', ctypes.POINTER(ctypes.c_float) * 3),
    ]


lr_water_fn = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.POINTER(lr_water_query))
lr_water_fn.__doc__ = """Called for bodies near the water surface: once, and twice more in each substep. Threads and restrictions: as for
lr_wind_fn. A body's results are replaced by the plane's if one is not finite, if a height exceeds `reach`, a
velocity 1000 m/s or an acceleration 1e6 m/s^2, or if the normal is invalid; one warning is then logged after the
step.
"""


lr_record_fn = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64)
lr_record_fn.__doc__ = """Receives the next `size` bytes of a recording, valid during the call only: append them to a file or a ring buffer.
Return 0, or anything else to end the recording. Called inside functions that take the world, on their thread. With
LR_RECORD_CALLBACKS it is also called on the threads that run wind and water callbacks, but never by two at a time.
Must not call the library on the same world, throw or longjmp.
"""


class lr_allocator(ctypes.Structure):
    """The allocator of a world. Set both functions, or neither to use the C library's.
    `allocate` returns `size` bytes aligned to `alignment` (a power of two, at most 128), or null.
    `release` receives the same size and alignment as the matching `allocate`. Both are called only on the thread that
    calls the library. lr_world_step calls them only when more bodies touch each other than ever before
    (lr_batch_set_body_contact). Neither may call the library on the same world.
    """
    _fields_ = [
        ('user', ctypes.c_void_p),
        ('allocate', ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint64)),
        ('release', ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint64)),
    ]


class lr_job_system(ctypes.Structure):
    """lr_job_system: 24 bytes."""
    _fields_ = [
        ('user', ctypes.c_void_p),
        ('enqueue', ctypes.CFUNCTYPE(ctypes.c_void_p, ctypes.c_void_p, lr_task_fn, ctypes.c_void_p, ctypes.c_uint32)),
        ('finish', ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p)),
    ]


class lr_ellipsoid_desc(ctypes.Structure):
    """A solid ellipsoid: the quickest way to a first falling body. Mass, added mass (Lamb) and the decay of k and epsilon
    in a uniform stream come from closed forms.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('semi_axes', ctypes.c_double * 3),
        ('density', ctypes.c_double),
        ('fluid_density', ctypes.c_double),
        ('fluid_viscosity', ctypes.c_double),
        ('intensity', ctypes.c_double),
        ('center_of_mass', ctypes.c_double * 3),
    ]


class lr_asset_info(ctypes.Structure):
    """Properties of an asset. Matrices are row-major and symmetric."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('flags', ctypes.c_uint32),
        ('name', ctypes.c_char * 64),
        ('mass', ctypes.c_double),
        ('volume', ctypes.c_double),
        ('density', ctypes.c_double),
        ('center_of_mass', ctypes.c_double * 3),
        ('center_of_buoyancy', ctypes.c_double * 3),
        ('inertia', ctypes.c_double * 9),
        ('added_mass', ctypes.c_double * 36),
        ('fluid_density', ctypes.c_double),
        ('fluid_viscosity', ctypes.c_double),
        ('length_d', ctypes.c_double),
        ('length_b', ctypes.c_double),
        ('length_l', ctypes.c_double),
        ('u0', ctypes.c_double),
        ('reynolds', ctypes.c_double),
        ('c0', ctypes.c_double),
        ('turbulence_dt', ctypes.c_double),
        ('turbulence_count', ctypes.c_uint32),
        ('hull_vertex_count', ctypes.c_uint32),
        ('hull_triangle_count', ctypes.c_uint32),
        ('format_version', ctypes.c_uint32),
        ('content_hash', ctypes.c_uint64),
    ]


class lr_world_desc(ctypes.Structure):
    """lr_world_desc: 112 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('worker_count', ctypes.c_uint32),
        ('seed', ctypes.c_uint64),
        ('gravity', ctypes.c_float * 3),
        ('fluid_density', ctypes.c_float),
        ('simd_target', ctypes.c_int32),
        ('fluid_viscosity', ctypes.c_float),
        ('allocator', lr_allocator),
        ('log', lr_log_fn),
        ('log_user', ctypes.c_void_p),
        ('jobs', lr_job_system),
        ('checks', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
    ]


class lr_world_info(ctypes.Structure):
    """lr_world_info: 88 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('simd_target', ctypes.c_int32),
        ('worker_count', ctypes.c_uint32),
        ('batch_count', ctypes.c_uint32),
        ('body_count', ctypes.c_uint64),
        ('substep_count', ctypes.c_uint64),
        ('time', ctypes.c_double),
        ('memory_bytes', ctypes.c_uint64),
        ('collider_count', ctypes.c_uint64),
        ('awake_count', ctypes.c_uint64),
        ('budget', ctypes.c_uint64),
        ('gravity', ctypes.c_float * 3),
        ('reserved', ctypes.c_uint32),
    ]


class lr_gusts_desc(ctypes.Structure):
    """Gusts: fluctuations of the uniform wind in time, with mean 0. They start from 0 when added, the fast ones first, and
    reach full strength after 4 integral times; an update continues them.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('seed', ctypes.c_uint32),
        ('direction', ctypes.c_float * 3),
        ('rms', ctypes.c_float),
        ('angle_rms', ctypes.c_float),
        ('integral_time', ctypes.c_float),
    ]


class lr_vortex_desc(ctypes.Structure):
    """A straight vortex."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('core', ctypes.c_int32),
        ('position', ctypes.c_float * 3),
        ('axis', ctypes.c_float * 3),
        ('velocity', ctypes.c_float * 3),
        ('circulation', ctypes.c_float),
        ('core_radius', ctypes.c_float),
        ('outer_radius', ctypes.c_float),
        ('half_length', ctypes.c_float),
    ]


class lr_blower_desc(ctypes.Structure):
    """A blower: a turbulent jet, round or from a slot."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('position', ctypes.c_float * 3),
        ('direction', ctypes.c_float * 3),
        ('side', ctypes.c_float * 3),
        ('velocity', ctypes.c_float * 3),
        ('speed', ctypes.c_float),
        ('nozzle_radius', ctypes.c_float),
        ('half_length', ctypes.c_float),
        ('range', ctypes.c_float),
        ('spread', ctypes.c_float),
    ]


class lr_turbulence_desc(ctypes.Structure):
    """Turbulence: random eddies everywhere, divergence-free, carried along by the uniform wind. An update continues them,
    also with another velocity; only another size moves them.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('seed', ctypes.c_uint32),
        ('octaves', ctypes.c_uint32),
        ('velocity', ctypes.c_float * 3),
        ('rms', ctypes.c_float),
        ('integral_length', ctypes.c_float),
        ('eddy_life', ctypes.c_float),
    ]


class lr_wind_grid_desc(ctypes.Structure):
    """Samples of wind on a lattice, in one or more frames that are played in a loop, from the first at world time 0. An
    update with another frame_time, but as many frames, goes on from the present one.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('outside', ctypes.c_int32),
        ('position', ctypes.c_float * 3),
        ('velocity', ctypes.c_float * 3),
        ('spacing', ctypes.c_float * 3),
        ('counts', ctypes.c_uint32 * 3),
        ('frames', ctypes.c_uint32),
        ('frame_time', ctypes.c_float),
        ('samples', ctypes.POINTER(ctypes.c_float)),
    ]


class lr_ground_wind_desc(ctypes.Structure):
    """A logarithmic profile over the ground, a plane: scales the uniform wind and the gusts."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('position', ctypes.c_float * 3),
        ('normal', ctypes.c_float * 3),
        ('velocity', ctypes.c_float * 3),
        ('roughness_length', ctypes.c_float),
        ('reference_height', ctypes.c_float),
    ]


class lr_wave(ctypes.Structure):
    """A long-crested deep-water wave. Heights of waves add up. The frequency in the water, sqrt(2 pi g/length), uses the
    world's gravity at the time of lr_world_set_water. The current carries the waves along; a change of it leaves them
    where they are.
    """
    _fields_ = [
        ('direction', ctypes.c_float * 3),
        ('length', ctypes.c_float),
        ('amplitude', ctypes.c_float),
        ('phase', ctypes.c_float),
    ]


class lr_water_desc(ctypes.Structure):
    """The water surface. Water fills everything below it; above it is the fluid of the world or of each batch's asset."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('wave_count', ctypes.c_uint32),
        ('position', ctypes.c_float * 3),
        ('normal', ctypes.c_float * 3),
        ('density', ctypes.c_float),
        ('viscosity', ctypes.c_float),
        ('current', ctypes.c_float * 3),
        ('reach', ctypes.c_float),
        ('waves', lr_wave * 8),
    ]


class lr_step_report(ctypes.Structure):
    """Work done and postponed by the last step. Batches without bodies are not counted."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('batches_stepped', ctypes.c_uint32),
        ('batches_waiting', ctypes.c_uint32),
        ('batches_passed_over', ctypes.c_uint32),
        ('body_substeps', ctypes.c_uint64),
        ('body_substeps_wanted', ctypes.c_uint64),
        ('behind', ctypes.c_double),
        ('lost', ctypes.c_double),
    ]


class lr_timings(ctypes.Structure):
    """Seconds that the phases of the last step took on the stepping thread, by a monotonic clock. `total` also includes
    the work between phases. Phases that did not occur are 0. Neither part of snapshots nor of the world's hash.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('total', ctypes.c_double),
        ('colliders', ctypes.c_double),
        ('wind', ctypes.c_double),
        ('motion', ctypes.c_double),
        ('body_contact', ctypes.c_double),
        ('wake', ctypes.c_double),
        ('emit_and_rules', ctypes.c_double),
        ('events', ctypes.c_double),
    ]


class lr_recording_desc(ctypes.Structure):
    """lr_recording_desc: 32 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('flags', ctypes.c_uint32),
        ('hash_interval', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('write', lr_record_fn),
        ('user', ctypes.c_void_p),
    ]


class lr_batch_desc(ctypes.Structure):
    """lr_batch_desc: 48 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('capacity', ctypes.c_uint32),
        ('asset', ctypes.POINTER(lr_asset)),
        ('load_model', ctypes.c_int32),
        ('clock', ctypes.c_int32),
        ('table_end', ctypes.c_int32),
        ('integrator', ctypes.c_int32),
        ('damping_gain', ctypes.c_float),
        ('noise_gain', ctypes.c_float),
        ('variation', ctypes.c_float),
        ('reserved', ctypes.c_uint32),
    ]


class lr_load_gains(ctypes.Structure):
    """Artistic control of AERODYNAMIC loads. The factors multiply the coefficients, so bodies still move physically."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('drag', ctypes.c_float),
        ('lift', ctypes.c_float),
        ('spin_drag', ctypes.c_float),
        ('turbulence', ctypes.c_float),
    ]


class lr_batch_pace(ctypes.Structure):
    """How a batch keeps pace with its world."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('divisor', ctypes.c_uint32),
        ('substeps', ctypes.c_uint32),
        ('waited', ctypes.c_uint32),
        ('behind', ctypes.c_double),
        ('lost', ctypes.c_double),
        ('body_substeps', ctypes.c_uint64),
    ]


class lr_batch_view(ctypes.Structure):
    """Read access to a batch's state without a copy: arrays of `count` values, one per body, 64-byte aligned. Awake bodies
    come first, then sleeping ones, without gaps. A body that leaves either part is replaced by the last one of that
    part. Pointers are valid until the next call that is not a query. Velocities: lr_batch_write_velocities.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('count', ctypes.c_uint32),
        ('position', ctypes.POINTER(ctypes.c_float) * 3),
        ('orientation', ctypes.POINTER(ctypes.c_float) * 4),
        ('scale', ctypes.POINTER(ctypes.c_float)),
        ('age', ctypes.POINTER(ctypes.c_float)),
        ('noise_seed', ctypes.POINTER(ctypes.c_uint32)),
        ('ids', ctypes.POINTER(ctypes.c_uint64)),
        ('user', ctypes.POINTER(ctypes.c_uint64)),
        ('capacity', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('revision', ctypes.c_uint64),
        ('awake_count', ctypes.c_uint32),
        ('reserved_1', ctypes.c_uint32),
    ]


class lr_body_desc(ctypes.Structure):
    """lr_body_desc: 80 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('noise_seed', ctypes.c_uint32),
        ('position', ctypes.c_float * 3),
        ('orientation', ctypes.c_float * 4),
        ('linear_velocity', ctypes.c_float * 3),
        ('angular_velocity', ctypes.c_float * 3),
        ('scale', ctypes.c_float),
        ('age', ctypes.c_float),
        ('reserved', ctypes.c_uint32),
        ('user', ctypes.c_uint64),
    ]


class lr_body_state(ctypes.Structure):
    """lr_body_state: 80 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('noise_seed', ctypes.c_uint32),
        ('position', ctypes.c_float * 3),
        ('orientation', ctypes.c_float * 4),
        ('linear_velocity', ctypes.c_float * 3),
        ('angular_velocity', ctypes.c_float * 3),
        ('scale', ctypes.c_float),
        ('age', ctypes.c_float),
        ('sleep_state', ctypes.c_int32),
        ('user', ctypes.c_uint64),
    ]


class lr_body_force(ctypes.Structure):
    """A force and a torque on one body. Scale matters: a body of scale 2 has eight times the mass."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('mode', ctypes.c_int32),
        ('body', ctypes.c_uint64),
        ('frame', ctypes.c_int32),
        ('flags', ctypes.c_uint32),
        ('force', ctypes.c_float * 3),
        ('torque', ctypes.c_float * 3),
        ('point', ctypes.c_float * 3),
        ('reserved', ctypes.c_uint32),
    ]


class lr_force_arrays(ctypes.Structure):
    """Forces on consecutive bodies of one batch, in the order of its view."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('mode', ctypes.c_int32),
        ('frame', ctypes.c_int32),
        ('first', ctypes.c_uint32),
        ('count', ctypes.c_uint32),
        ('stride', ctypes.c_uint32),
        ('force', ctypes.POINTER(ctypes.c_float) * 3),
        ('torque', ctypes.POINTER(ctypes.c_float) * 3),
    ]


class lr_batch_force(ctypes.Structure):
    """Forces on every body of a batch, until changed. All default to 0; each component up to 1e9 in magnitude."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('force', ctypes.c_float * 3),
        ('torque', ctypes.c_float * 3),
        ('acceleration', ctypes.c_float * 3),
        ('angular_acceleration', ctypes.c_float * 3),
        ('body_force', ctypes.c_float * 3),
        ('body_torque', ctypes.c_float * 3),
        ('body_acceleration', ctypes.c_float * 3),
        ('body_angular_acceleration', ctypes.c_float * 3),
    ]


class lr_collider_desc(ctypes.Structure):
    """A collider. Fields that its kind does not use are ignored. Arrays are copied."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('kind', ctypes.c_int32),
        ('position', ctypes.c_float * 3),
        ('orientation', ctypes.c_float * 4),
        ('linear_velocity', ctypes.c_float * 3),
        ('angular_velocity', ctypes.c_float * 3),
        ('size', ctypes.c_float * 3),
        ('friction', ctypes.c_float),
        ('restitution', ctypes.c_float),
        ('layers', ctypes.c_uint32),
        ('flags', ctypes.c_uint32),
        ('vertex_count', ctypes.c_uint32),
        ('triangle_count', ctypes.c_uint32),
        ('counts', ctypes.c_uint32 * 2),
        ('spacing', ctypes.c_float * 2),
        ('vertices', ctypes.POINTER(ctypes.c_float)),
        ('indices', ctypes.POINTER(ctypes.c_uint32)),
        ('heights', ctypes.POINTER(ctypes.c_float)),
    ]


class lr_collider_motion(ctypes.Structure):
    """A motion of one collider. Within a step its position moves linearly and its orientation follows the normalised linear
    quaternion, the shorter way round: rotations of more than half a turn per step appear shorter.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('mode', ctypes.c_int32),
        ('collider', ctypes.c_uint64),
        ('position', ctypes.c_float * 3),
        ('orientation', ctypes.c_float * 4),
        ('linear_velocity', ctypes.c_float * 3),
        ('angular_velocity', ctypes.c_float * 3),
        ('reserved', ctypes.c_uint32),
    ]


class lr_collider_state(ctypes.Structure):
    """lr_collider_state: 76 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('kind', ctypes.c_int32),
        ('position', ctypes.c_float * 3),
        ('orientation', ctypes.c_float * 4),
        ('linear_velocity', ctypes.c_float * 3),
        ('angular_velocity', ctypes.c_float * 3),
        ('friction', ctypes.c_float),
        ('restitution', ctypes.c_float),
        ('layers', ctypes.c_uint32),
        ('flags', ctypes.c_uint32),
    ]


class lr_material(ctypes.Structure):
    """The material of a collider."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('layers', ctypes.c_uint32),
        ('friction', ctypes.c_float),
        ('restitution', ctypes.c_float),
    ]


class lr_batch_contact(ctypes.Structure):
    """How bodies of a batch collide. A contact uses the geometric mean of both frictions and the larger restitution. A body
    collides as its hull, reduced to at most 32 points, or as an ellipsoid if its asset is one.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('layers', ctypes.c_uint32),
        ('friction', ctypes.c_float),
        ('restitution', ctypes.c_float),
        ('rolling_resistance', ctypes.c_float),
        ('flags', ctypes.c_uint32),
        ('ground_effect', ctypes.c_float),
        ('reserved', ctypes.c_uint32),
        ('min_thickness', ctypes.c_float),
    ]


class lr_event(ctypes.Structure):
    """One event: 64 bytes in arrays without gaps. This struct never changes after 0.2."""
    _fields_ = [
        ('kind', ctypes.c_int32),
        ('batch', ctypes.c_uint32),
        ('body', ctypes.c_uint64),
        ('user', ctypes.c_uint64),
        ('collider', ctypes.c_uint64),
        ('position', ctypes.c_float * 3),
        ('normal', ctypes.c_float * 3),
        ('speed', ctypes.c_float),
        ('impulse', ctypes.c_float),
    ]


class lr_event_list(ctypes.Structure):
    """lr_event_list: 40 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('count', ctypes.c_uint32),
        ('events', ctypes.POINTER(lr_event)),
        ('lost', ctypes.c_uint64),
        ('total_lost', ctypes.c_uint64),
        ('capacity', ctypes.c_uint32),
        ('kinds', ctypes.c_uint32),
    ]


class lr_ray(ctypes.Structure):
    """lr_ray: 48 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('flags', ctypes.c_uint32),
        ('origin', ctypes.c_float * 3),
        ('direction', ctypes.c_float * 3),
        ('max_distance', ctypes.c_float),
        ('batch', ctypes.c_uint32),
        ('collider_layers', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
    ]


class lr_ray_hit(ctypes.Structure):
    """The first hit of a ray, all 0 if there is none: 56 bytes in arrays without gaps. This struct never changes after
    0.2.
    """
    _fields_ = [
        ('body', ctypes.c_uint64),
        ('user', ctypes.c_uint64),
        ('collider', ctypes.c_uint64),
        ('distance', ctypes.c_float),
        ('position', ctypes.c_float * 3),
        ('normal', ctypes.c_float * 3),
        ('reserved', ctypes.c_uint32),
    ]


class lr_overlap_desc(ctypes.Structure):
    """lr_overlap_desc: 56 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('shape', ctypes.c_int32),
        ('position', ctypes.c_float * 3),
        ('orientation', ctypes.c_float * 4),
        ('size', ctypes.c_float * 3),
        ('batch', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
    ]


class lr_kill_volume(ctypes.Structure):
    """lr_kill_volume: 32 bytes."""
    _fields_ = [
        ('shape', ctypes.c_int32),
        ('side', ctypes.c_int32),
        ('center', ctypes.c_float * 3),
        ('size', ctypes.c_float * 3),
    ]


class lr_batch_rules(ctypes.Structure):
    """When the bodies of a batch end. Diverged bodies end under any rules, unless lr_batch_set_divergence_policy holds
    them.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('action', ctypes.c_int32),
        ('max_age', ctypes.c_float),
        ('volume_count', ctypes.c_uint32),
        ('volumes', lr_kill_volume * 8),
    ]


class lr_emitter_desc(ctypes.Structure):
    """How bodies of a batch spawn. Random values depend only on the world's seed, the body's noise seed, and the number of
    times it has respawned.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('shape', ctypes.c_int32),
        ('position', ctypes.c_float * 3),
        ('orientation', ctypes.c_float * 4),
        ('size', ctypes.c_float * 3),
        ('pose', ctypes.c_int32),
        ('body_orientation', ctypes.c_float * 4),
        ('direction', ctypes.c_float * 3),
        ('spread', ctypes.c_float),
        ('speed_min', ctypes.c_float),
        ('speed_max', ctypes.c_float),
        ('spin_min', ctypes.c_float),
        ('spin_max', ctypes.c_float),
        ('scale_min', ctypes.c_float),
        ('scale_max', ctypes.c_float),
        ('rate', ctypes.c_float),
        ('burst_interval', ctypes.c_float),
        ('burst_count', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
    ]


class lr_batch_counts(ctypes.Structure):
    """Numbers of bodies that rules ended and the emitter spawned in the last step, and totals since the batch was created.
    lr_world_get_events names the bodies.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('spawned', ctypes.c_uint32),
        ('destroyed', ctypes.c_uint32),
        ('respawned', ctypes.c_uint32),
        ('missed', ctypes.c_uint32),
        ('by_divergence', ctypes.c_uint32),
        ('by_age', ctypes.c_uint32),
        ('by_volume', ctypes.c_uint32 * 8),
        ('diverged', ctypes.c_uint32),
        ('total_spawned', ctypes.c_uint64),
        ('total_destroyed', ctypes.c_uint64),
        ('total_respawned', ctypes.c_uint64),
        ('total_missed', ctypes.c_uint64),
        ('total_diverged', ctypes.c_uint64),
    ]


class lr_aerodynamics(ctypes.Structure):
    """Coefficients of the quasi-steady loads (LR_LOADS_AERODYNAMIC) at scale 1; equations: docs/maintainers/physics.md,
    AERODYNAMIC. All loads act at `center`, along `axes`, which rotate with the body. Arrays hold one value per axis.
    Symbols: v is the velocity through the fluid and w the spin, both along the axes; s = |v|; (i, j, k) are cyclic; d is
    lr_asset_info.length_d; rho and nu are the fluid's density and kinematic viscosity.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('axes', ctypes.c_double * 9),
        ('drag', ctypes.c_double * 3),
        ('drag_blunt', ctypes.c_double * 3),
        ('drag_layer', ctypes.c_double * 3),
        ('drag_stokes', ctypes.c_double * 3),
        ('lift', ctypes.c_double * 3),
        ('spin_lift', ctypes.c_double * 3),
        ('lift_moment', ctypes.c_double * 3),
        ('spin_drag', ctypes.c_double * 3),
        ('spin_drag_stream', ctypes.c_double * 3),
        ('spin_drag_stokes', ctypes.c_double * 3),
        ('intensity', ctypes.c_double),
        ('length', ctypes.c_double),
        ('wake_reynolds', ctypes.c_double),
        ('broadside', ctypes.c_double * 3),
        ('lift_stall', ctypes.c_double),
        ('lift_moment_stalled', ctypes.c_double * 3),
        ('roll_damping', ctypes.c_double * 3),
        ('center', ctypes.c_double * 3),
        ('plate_lift', ctypes.c_double * 3),
        ('plate_vortex', ctypes.c_double * 3),
        ('plate_stall', ctypes.c_double * 3),
        ('plate_separated_shedding', ctypes.c_double),
        ('plate_drag', ctypes.c_double),
        ('start_drag', ctypes.c_double),
        ('wake_length', ctypes.c_double),
        ('wake_lag', ctypes.c_double),
        ('wake_share', ctypes.c_double),
        ('strouhal', ctypes.c_double),
        ('shedding_growth', ctypes.c_double),
        ('shedding_reynolds', ctypes.c_double),
        ('shedding_noise', ctypes.c_double),
        ('shedding_moment', ctypes.c_double),
        ('shedding_rate_moment', ctypes.c_double),
        ('spin_drag_layer', ctypes.c_double * 3),
    ]


class lr_rigid_desc(ctypes.Structure):
    """A body of known numbers without a mesh or file: from another solver, from measurements, or the cross-section of a
    card in two dimensions. Matrices are row-major, symmetric, about the centre of mass, in body axes.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('mass', ctypes.c_double),
        ('volume', ctypes.c_double),
        ('inertia', ctypes.c_double * 9),
        ('added_mass', ctypes.c_double * 36),
        ('center_of_buoyancy', ctypes.c_double * 3),
        ('fluid_density', ctypes.c_double),
        ('fluid_viscosity', ctypes.c_double),
        ('extents', ctypes.c_double * 3),
        ('intensity', ctypes.c_double),
        ('aerodynamics', ctypes.POINTER(lr_aerodynamics)),
    ]


class lr_turbulence_table(ctypes.Structure):
    """k-epsilon samples in the units of the bake. Arrays are copied."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('count', ctypes.c_uint32),
        ('chi', ctypes.POINTER(ctypes.c_float)),
        ('epsilon', ctypes.POINTER(ctypes.c_float)),
        ('dt', ctypes.c_float),
        ('u0', ctypes.c_float),
        ('l', ctypes.c_float),
        ('c0', ctypes.c_float),
        ('stationary', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
    ]


class lr_body_loads(ctypes.Structure):
    """The loads of the flow on a body and the state of its wake, for inspectors and debug arrows: what AERODYNAMIC loads do
    to it now. Weight, buoyancy and added mass are not among them, but what turning costs where added momentum is left in
    the wake is. World frame.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('station_count', ctypes.c_uint32),
        ('stream', ctypes.c_float * 3),
        ('wake', ctypes.c_float * 3),
        ('shedding', ctypes.c_float * 3),
        ('force', ctypes.c_float * 3),
        ('torque', ctypes.c_float * 3),
        ('station_position', ctypes.c_float * 24),
        ('station_force', ctypes.c_float * 24),
    ]


# Texts of fields, by struct.
FIELD_DOCS = {
    'lr_allocator': {
        'user': '',
        'allocate': '',
        'release': '',
    },
    'lr_job_system': {
        'user': '',
        'enqueue': '',
        'finish': '',
    },
    'lr_ellipsoid_desc': {
        'semi_axes': 'm, each 1e-6 to 1e3, along body x, y, z',
        'density': 'kg/m^3 of the body, > 0',
        'fluid_density': 'kg/m^3, > 0; default 1.2, air',
        'fluid_viscosity': 'm^2/s, kinematic, > 0; default 1.5e-5, air',
        'intensity': 'turbulence intensity I of k0 = 3/2 (I U0)^2, 0 to 10; default 1, as in the paper',
        'center_of_mass': "m, from the ellipsoid's centre, inside it; default 0. For ballast: the centre of buoyancy and the moments of inertia stay those of the uniform solid",
    },
    'lr_asset_info': {
        'flags': '`AssetFlags`',
        'name': 'UTF-8, ends with 0',
        'mass': 'kg',
        'volume': 'm^3',
        'density': 'kg/m^3',
        'center_of_mass': "m, in the frame of the mesh: the position of the body's origin in it",
        'center_of_buoyancy': 'm, from the centre of mass, body axes',
        'inertia': 'kg m^2, about the centre of mass, body axes',
        'added_mass': 'about the centre of mass, order vx vy vz wx wy wz, fluid density included: kg for the 3x3 block of v, kg m for the coupling, kg m^2 for the block of w',
        'fluid_density': 'kg/m^3, of the fluid that the asset was baked in',
        'fluid_viscosity': 'm^2/s, kinematic',
        'length_d': 'm, characteristic length: the largest extent',
        'length_b': 'm, thickness',
        'length_l': 'm, turbulence length; see docs/maintainers/physics.md',
        'u0': 'm/s, fall velocity scale sqrt(|density ratio - 1| g b), paper Eq. 1',
        'reynolds': 'u0 d / viscosity',
        'c0': 'Kolmogorov constant of the Langevin model, paper Eq. 10',
        'turbulence_dt': 's between table samples',
        'turbulence_count': 'number of table samples',
        'hull_vertex_count': '0: no hull',
        'hull_triangle_count': '',
        'format_version': 'of the file; 0: created without a file',
        'content_hash': 'of everything that affects motion; equal for equal assets',
    },
    'lr_world_desc': {
        'worker_count': "threads besides the caller's, 0 to 64; default 0: everything runs on the caller's thread. With `jobs`: threads of the job system besides the caller's, and the most indices in one enqueue; 0 guesses the machine's threads less one, from 1 to 64, and logs a warning",
        'seed': 'of all noise; default 0',
        'gravity': 'm/s^2; default 0, -9.81, 0',
        'fluid_density': 'kg/m^3, >= 0; default 0: each batch uses the fluid that its asset was baked in. For a vacuum set 1e-6',
        'simd_target': '`SimdTarget`; default `SimdTarget.AUTO`',
        'fluid_viscosity': 'm^2/s, kinematic, >= 0; default 0: each batch uses the value its asset was baked with',
        'allocator': "copied; default null functions: the C library's",
        'log': 'default null: no messages',
        'log_user': '',
        'jobs': 'copied; default null functions: the world starts worker_count threads of its own',
        'checks': 'bits `CheckFlags`: misuse to detect, for development; default 0',
    },
    'lr_world_info': {
        'simd_target': '`SimdTarget`: in use, never `SimdTarget.AUTO`',
        'worker_count': 'as in the desc; with `jobs` and 0: the guess',
        'batch_count': '',
        'body_count': '',
        'substep_count': 'substeps since creation; the time index of the noise',
        'time': 's since creation: the sum of all dt, in double',
        'memory_bytes': 'currently allocated',
        'collider_count': '',
        'awake_count': 'bodies that are not asleep: lr_body_set_sleep',
        'budget': 'as set by lr_world_set_budget',
        'gravity': 'm/s^2, as set by lr_world_set_gravity',
    },
    'lr_gusts_desc': {
        'seed': "combined with the world's; default 0",
        'direction': 'mean direction, any length but 0; default 1, 0, 0',
        'rms': 'm/s, root mean square speed, 0 to 1000; default 1',
        'angle_rms': 'rad, root mean square angle from `direction`, 0 to 1; default 0.1',
        'integral_time': 's, up to 1e6; default 0: 4 s. IEC 61400-1: 5.67 times height over wind speed',
    },
    'lr_vortex_desc': {
        'core': '`VortexCore`; default `VortexCore.LAMB_OSEEN`',
        'position': 'm, a point on the axis, its middle if half_length > 0; default 0',
        'axis': 'right-hand rule, any length but 0; default 0, 1, 0',
        'velocity': 'm/s, of the vortex itself; default 0',
        'circulation': 'm^2/s, up to 1e6 and up to 6000 * core_radius in magnitude; default 1',
        'core_radius': 'm, >= 1e-4; default 1',
        'outer_radius': 'm: fades from half this distance to nothing at it; default 0: no limit',
        'half_length': 'm: likewise along the axis; default 0: no limit',
    },
    'lr_blower_desc': {
        'position': 'm, the middle of the nozzle; default 0',
        'direction': 'of the jet, any length but 0; default 1, 0, 0',
        'side': 'along the slot; not parallel to `direction`; default 0, 0, 1. Unused by a round jet',
        'velocity': 'm/s, of the blower itself; default 0',
        'speed': 'm/s at the nozzle, 0 to 1000; default 1',
        'nozzle_radius': 'm, >= 1e-4: of a round nozzle, half the width of a slot; default 1',
        'half_length': 'm: half the length of the slot; default 0: a round jet',
        'range': 'm, >= nozzle_radius: fades from half this distance to nothing at it; default 10',
        'spread': 'widening of the jet per length, 0 to 1; default 0.1, measured as 0.11',
    },
    'lr_turbulence_desc': {
        'seed': "combined with the world's; default 0",
        'octaves': 'each half the size of the one before, 1 to 4; default 2',
        'velocity': 'm/s, of the pattern, besides the uniform wind; default 0',
        'rms': 'm/s, root mean square of each component, 0 to 1000; default 1',
        'integral_length': 'm, >= 1e-4; default 1',
        'eddy_life': 's, of the largest eddies, up to 1e6; default 0: integral_length/rms',
    },
    'lr_wind_grid_desc': {
        'outside': '`WindOutside`; default `WindOutside.ZERO`',
        'position': 'm, of the first sample; default 0',
        'velocity': 'm/s, of the grid itself; default 0',
        'spacing': 'm between samples, >= 1e-4; default 1',
        'counts': 'samples along x, y, z, each >= 1',
        'frames': '>= 1; default 1',
        'frame_time': 's between frames, up to 1e6; default 0: 1 s',
        'samples': 'm/s, each up to 1000 in magnitude: x y z of each sample; x varies fastest, then y, z, frame; copied. Null in an update: keeps the samples, if counts and frames are unchanged. lr_world_get_wind_grid gives null',
    },
    'lr_ground_wind_desc': {
        'position': 'm, a point on the ground; default 0',
        'normal': 'upward, any length but 0; default 0, 1, 0',
        'velocity': 'm/s, of the plane itself; default 0',
        'roughness_length': 'm, >= 1e-4; default 0.03, grass (0.0001 water, 1 town)',
        'reference_height': 'm, >= roughness_length: the height at which the factor is 1; default 10',
    },
    'lr_wind_query': {
        'count': 'bodies, 1 to 256',
        'batch': 'of these bodies; id 0 in lr_world_sample_wind',
        'time': 's, of the middle of the substep',
        'position': 'm: expected positions of the bodies at that time; finite',
        'velocity': "m/s, preset to 0: write the velocity to add to the other sources'",
        'rate': 'm/s^2, preset to 0: write its partial derivative in time, if known',
        'gradient': "1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without rate and gradient the callback's wind causes drag, but neither shear nor the force of accelerating fluid",
    },
    'lr_wave': {
        'direction': 'of travel: any vector not along the normal; only its part in the plane counts',
        'length': 'm, crest to crest, 1e-3 to 1e6',
        'amplitude': 'm, half of crest to trough, 0 to length/7: steeper waves break',
        'phase': 'rad, up to 1e6 in magnitude; 0 puts a crest at `position` at world time 0',
    },
    'lr_water_desc': {
        'wave_count': 'elements of `waves` in use; the others are not kept; default 0',
        'position': 'm, a point of the plane, each up to 1e9 in magnitude; default 0',
        'normal': 'upward, any length but 0; default 0, 1, 0',
        'density': 'kg/m^3, 1e-3 to 1e6; default 998. A batch whose own fluid is denser keeps its own density',
        'viscosity': 'm^2/s, kinematic, 1e-12 to 1e3; default 1e-6',
        'current': 'm/s, of the water, and of a plane that you move; each up to 1000 in magnitude; default 0',
        'reach': "m, 0 to 1e6: the farthest that a callback's surface lies from the plane; default 0",
        'waves': '',
    },
    'lr_water_query': {
        'count': 'bodies, 1 to 256',
        'batch': 'of these bodies',
        'time': 's',
        'position': 'm; finite',
        'height': "m, of the surface above the plane, along the plane's normal",
        'normal': "unit, of the surface, less than 80 degrees from the plane's",
        'velocity': 'm/s, of the water at the position',
        'rate': 'm/s^2, du/dt + u . grad u of the water: lets bodies slide down slopes, follow eddies',
    },
    'lr_step_report': {
        'batches_stepped': '',
        'batches_waiting': 'not due, because of their divisors',
        'batches_passed_over': 'due, but out of budget',
        'body_substeps': 'done in this step',
        'body_substeps_wanted': 'that the batches which were due would need without a budget',
        'behind': 's: the longest time by which a batch is behind the world',
        'lost': 's: the most simulated time that a batch lost in this step: rather than take substeps that are too long, bodies move in slow motion',
    },
    'lr_timings': {
        'total': '',
        'colliders': 'waking bodies about to be hit, moving colliders, sorting them for the search',
        'wind': "preparing the wind's fields; bodies evaluate them as part of their motion",
        'motion': 'of batches without body contact: loads, wind, water, contact with colliders',
        'body_contact': 'of batches with body contact: their motion, and the contact between their bodies',
        'wake': 'finding sleeping bodies that wind or water moves',
        'emit_and_rules': 'ends, spawns, divergence, and falling asleep',
        'events': 'listing and sorting them',
    },
    'lr_recording_desc': {
        'flags': 'bits `RecordFlags`; default `RecordFlags.CALLBACKS`',
        'hash_interval': 'steps between recorded hashes of the world; 0: none; default 1',
        'write': 'required',
        'user': '',
    },
    'lr_batch_desc': {
        'capacity': 'the most bodies at a time, 1 to 2^26; memory for all is allocated at creation',
        'asset': 'required; the batch keeps a reference until it is destroyed',
        'load_model': '`LoadModel`; default `LoadModel.DEFAULT`',
        'clock': '`TurbulenceClock`; default `TurbulenceClock.SPEED`',
        'table_end': '`TableEnd`; default `TableEnd.CLAMP`',
        'integrator': '`Integrator`; default `Integrator.DEFAULT`',
        'damping_gain': 'multiplies the turbulent damping, 0 to 100; default 1',
        'noise_gain': 'multiplies the turbulent noise, 0 to 100; default 1; 0 makes single falls repeatable',
        'variation': "natural spread of AERODYNAMIC loads from body to body, as by thickness and curl: relative standard deviation, 0 to 0.5; default 0.15; 0: all bodies are alike. A body's loads follow from its noise seed and the world's seed, and never change",
    },
    'lr_load_gains': {
        'drag': 'on translation, 0 to 100; default 1',
        'lift': 'and its moment, 0 to 100; default 1',
        'spin_drag': '0 to 100; default 1',
        'turbulence': "intensity of the body's own wake, 0 to 100; default 1",
    },
    'lr_batch_pace': {
        'divisor': 'as set',
        'substeps': "in the world's last step; 0: it waited",
        'waited': 'steps since it was last stepped',
        'behind': 's since it was last stepped',
        'lost': 's, simulated time lost in total',
        'body_substeps': 'in total',
    },
    'lr_batch_view': {
        'count': 'bodies',
        'position': 'm, world frame: x, y, z',
        'orientation': 'unit quaternion x, y, z, w, body to world',
        'scale': 'uniform scale',
        'age': 's; outdated for sleeping bodies: lr_body_get_state gives their exact age',
        'noise_seed': 'bodies with different seeds have independent noise',
        'ids': '',
        'user': 'lr_body_desc.user; null until a body of the batch is given one',
        'capacity': '',
        'revision': 'changes whenever sleeping bodies wake, end or change places',
        'awake_count': 'bodies [0, awake_count) are awake, [awake_count, count) asleep: lr_body_set_sleep',
    },
    'lr_body_desc': {
        'noise_seed': 'default 0: the world assigns each body the next one',
        'position': 'm, of the centre of mass; default 0',
        'orientation': 'quaternion x y z w, normalised by the call; default 0 0 0 1',
        'linear_velocity': 'm/s, of the centre of mass; default 0',
        'angular_velocity': 'rad/s, world frame; default 0',
        'scale': 'uniform, 0.001 to 1000; mass scales with its cube; default 1',
        'age': 's, 0 to 1e9, where it stops growing; default 0',
        'user': "the caller's own number, also in views, events and ray hits; default 0. A respawn keeps it. It does not affect motion: part of snapshots, not of the world's hash",
    },
    'lr_body_state': {
        'noise_seed': 'read only: ignored by lr_body_set_state',
        'position': 'm, of the centre of mass, world frame',
        'orientation': 'unit quaternion x y z w, body to world',
        'linear_velocity': 'm/s, of the centre of mass, world frame',
        'angular_velocity': 'rad/s, world frame',
        'scale': '0.001 to 1000',
        'age': 's, 0 to 1e9',
        'sleep_state': '`SleepState`; read only',
        'user': 'as in lr_body_desc',
    },
    'lr_body_force': {
        'mode': '`ForceMode`; default `ForceMode.FORCE`',
        'body': '',
        'frame': '`ForceFrame`, of force, torque and point; default `ForceFrame.WORLD`',
        'flags': '`ForceFlags`; default 0',
        'force': 'default 0',
        'torque': 'about the centre of mass; default 0',
        'point': 'm; world frame: a position, body frame: from the centre of mass. The lever arm is fixed by the call',
    },
    'lr_force_arrays': {
        'mode': '`ForceMode`; default `ForceMode.FORCE`',
        'frame': '`ForceFrame`; default `ForceFrame.WORLD`',
        'first': 'index in the view of the first body; default 0',
        'count': 'bodies',
        'stride': "bytes from one body's value to the next, a multiple of 4; default 0: 4, no gaps",
        'force': 'x, y, z: `count` values each, not kept; all three or none',
        'torque': 'x, y, z: `count` values each, not kept; all three or none',
    },
    'lr_batch_force': {
        'force': 'N, world frame',
        'torque': 'N m, world frame',
        'acceleration': 'm/s^2, world frame; of the body, whatever its mass',
        'angular_acceleration': 'rad/s^2, world frame',
        'body_force': 'N, body frame',
        'body_torque': 'N m, body frame',
        'body_acceleration': 'm/s^2, body frame',
        'body_angular_acceleration': 'rad/s^2, body frame',
    },
    'lr_collider_desc': {
        'kind': '`ColliderKind`; must be set: the default 0 is no kind',
        'position': 'm, up to 1e9 in magnitude; default 0',
        'orientation': 'quaternion x y z w, normalised by the call; default 0 0 0 1',
        'linear_velocity': "m/s, of the frame's origin, up to 1e6; default 0. Lasts until changed",
        'angular_velocity': 'rad/s, world frame, up to 1e6; default 0. Lasts until changed',
        'size': 'm, > 0, up to 1e6; default 0',
        'friction': '0 to 10; default 0.5',
        'restitution': '0 to 1; default 0.2',
        'layers': 'bits: collides with bodies that share at least one; default 1',
        'flags': '0',
        'vertex_count': 'hull: 4 to `MAX_HULL_VERTICES`; mesh: 3 to `MAX_COLLIDER_VERTICES`',
        'triangle_count': 'mesh: 1 to `MAX_COLLIDER_VERTICES`',
        'counts': 'heightfield: samples along x and z, each >= 2',
        'spacing': 'heightfield: m between samples, 1e-6 to 1e6; default 1',
        'vertices': 'm, x y z each, up to 1e6 in magnitude',
        'indices': '3 per triangle, each < vertex_count',
        'heights': 'm, up to 1e6 in magnitude; x varies fastest',
    },
    'lr_collider_motion': {
        'mode': '`MoveMode`; default `MoveMode.TO`',
        'collider': '',
        'position': 'm, as in lr_collider_desc; `MoveMode.TO` and `MoveMode.PLACE`; default 0',
        'orientation': 'quaternion x y z w; `MoveMode.TO` and `MoveMode.PLACE`; default 0 0 0 1',
        'linear_velocity': 'm/s; `MoveMode.PLACE` and `MoveMode.VELOCITY`; default 0',
        'angular_velocity': 'rad/s; `MoveMode.PLACE` and `MoveMode.VELOCITY`; default 0',
    },
    'lr_collider_state': {
        'kind': '`ColliderKind`',
        'position': 'm, world frame',
        'orientation': 'unit quaternion x y z w, collider to world',
        'linear_velocity': 'm/s, that lasts until changed; 0 while `MoveMode.TO` is pending',
        'angular_velocity': 'rad/s, world frame, that lasts until changed; 0 while `MoveMode.TO` is pending',
        'friction': '',
        'restitution': '',
        'layers': '',
        'flags': '0',
    },
    'lr_material': {
        'layers': 'as in lr_collider_desc; default 1',
        'friction': 'as in lr_collider_desc; default 0.5',
        'restitution': 'as in lr_collider_desc; default 0.2',
    },
    'lr_batch_contact': {
        'layers': 'bits: collides with colliders that share at least one; default all; 0: none',
        'friction': 'coefficient of Coulomb friction, 0 to 10; default 0.5',
        'restitution': 'speed after an impact over speed before it, 0 to 1; default 0.1',
        'rolling_resistance': 'moment against rolling and spinning over normal force times lever, 0 to 10; default 0.05. The lever is the geometric mean of reach and half the thickness: of a sphere, its radius',
        'flags': 'bits: `ContactFlags.NEVER_SLEEP`; default 0',
        'ground_effect': 'air cushion under a sheet that settles on a plane or heightfield, as a share of theory, 0 to 1; default 0. docs/maintainers/contact.md',
        'min_thickness': 'm, at scale 1, -1 to 10: sheets thinner than this meet other bodies as if they were so thick, at most a tenth of their reach; 0: 1/32 of it, at most 1.25 mm; below 0: as thick as they are, for decks of cards; default 0',
    },
    'lr_event': {
        'kind': '`EventKind`',
        'batch': '',
        'body': 'stale if it was destroyed',
        'user': "the body's: lr_body_desc.user",
        'collider': '`EventKind.HIT`, `EventKind.LIFTED`; else id 0',
        'position': 'm, world frame: the point of contact in `EventKind.HIT`; where it ended in `EventKind.KILLED` and `EventKind.RESPAWNED`; the last valid centre of mass in `EventKind.DIVERGED`; else the centre of mass',
        'normal': '`EventKind.HIT`: unit, world frame, from the collider to the body; else 0',
        'speed': 'm/s, `EventKind.HIT`: approach speed along the normal, >= 0; else 0',
        'impulse': 'N s, `EventKind.HIT`: along the normal, in the substep of first contact; else 0',
    },
    'lr_event_list': {
        'count': '',
        'events': 'of the last step; null before lr_world_set_events',
        'lost': 'events of the last step beyond capacity: those last in order are dropped',
        'total_lost': 'since lr_world_set_events',
        'capacity': 'as set by lr_world_set_events',
        'kinds': 'bits `EventKinds`, likewise',
    },
    'lr_ray': {
        'flags': 'bits `RayFlags`: what it can hit; default both',
        'origin': 'm, up to 1e9 in magnitude; default 0',
        'direction': 'any length from 1e-6 to 1e6; default 0, -1, 0',
        'max_distance': 'm, 0 to 1e9; default 1e9',
        'batch': 'hits bodies of this batch only; default id 0: of all batches',
        'collider_layers': 'bits: hits colliders that share at least one; default all',
    },
    'lr_ray_hit': {
        'body': 'id 0: it hit a collider',
        'user': "the body's: lr_body_desc.user",
        'collider': 'id 0: it hit a body',
        'distance': "m, from the ray's origin",
        'position': 'm, world frame',
        'normal': 'unit, world frame, outward. If the ray starts inside: against the ray, at distance 0',
    },
    'lr_overlap_desc': {
        'shape': '`OverlapShape`; default `OverlapShape.SPHERE`',
        'position': 'm, of its centre, up to 1e9 in magnitude; default 0',
        'orientation': 'of a box, x y z w, normalised by the call; default 0 0 0 1',
        'size': 'm, > 0, up to 1e6; default 1',
        'batch': 'finds bodies of this batch only; default id 0: of all batches',
    },
    'lr_kill_volume': {
        'shape': '`VolumeShape`',
        'side': '`KillSide`: the side on which bodies end',
        'center': 'm, up to 1e9 in magnitude',
        'size': 'm; of a plane its normal, any length but 0',
    },
    'lr_batch_rules': {
        'action': '`EndAction`; default `EndAction.DESTROY`',
        'max_age': 's, up to 1e9; default 0: no limit',
        'volume_count': 'elements of `volumes` in use; default 0',
        'volumes': 'tested with the centre of mass',
    },
    'lr_emitter_desc': {
        'shape': '`EmitterShape`; default `EmitterShape.POINT`',
        'position': 'm, centre of the shape; default 0',
        'orientation': 'of the shape, x y z w, normalised by the call; default 0 0 0 1',
        'size': "m, half extents or semi-axes along the shape's own axes, 0 to 1e9; default 0",
        'pose': '`EmitterPose`, of the bodies; default `EmitterPose.RANDOM`',
        'body_orientation': 'body to world, normalised by the call; default 0 0 0 1',
        'direction': 'of the velocity, world frame, any length but 0; default 0, -1, 0',
        'spread': 'rad, half angle of a cone about `direction`, filled evenly, 0 to pi; default 0',
        'speed_min': 'm/s, uniform in this range; default 0',
        'speed_max': 'm/s, uniform in this range; default 0',
        'spin_min': 'rad/s, uniform in this range, about a random axis; default 0',
        'spin_max': 'rad/s, uniform in this range, about a random axis; default 0',
        'scale_min': 'uniform in this range; default 1',
        'scale_max': 'uniform in this range; default 1',
        'rate': 'spawns per second, 0 to 1e9; default 0: bodies respawn, but none are added',
        'burst_interval': 's between bursts, >= 1e-4',
        'burst_count': 'spawns in each burst; default 0: no bursts',
    },
    'lr_batch_counts': {
        'spawned': 'by rate and bursts',
        'destroyed': 'by the rules',
        'respawned': '',
        'missed': 'spawns dropped for lack of room',
        'by_divergence': 'Why bodies ended: the first cause that applied, in this order. diverged: lr_batch_set_divergence_policy',
        'by_age': '',
        'by_volume': '',
        'diverged': 'bodies that diverged in the last step, held or ended',
        'total_spawned': 'including lr_batch_spawn, lr_batch_spawn_box',
        'total_destroyed': '',
        'total_respawned': '',
        'total_missed': '',
        'total_diverged': '',
    },
    'lr_aerodynamics': {
        'axes': 'rows: unit vectors in the body frame, right-handed',
        'drag': 'Drag -1/2 rho sum_i (v_i/s)^2 [drag_i + drag_blunt_i Re/(Re + 8710)] s v with Re = s d/nu, and along each axis -rho [drag_layer_i sqrt(nu s) + drag_stokes_i nu] v_i. All >= 0. m^2, drag coefficient times area',
        'drag_blunt': 'm^2, the part of rounded bodies, which grows with the Reynolds number',
        'drag_layer': 'm^(3/2), boundary layer',
        'drag_stokes': 'm, creeping flow',
        'lift': 'Lift rho G x v with G_k = spin_lift_k w_k - lift_k v_i v_j/s. m^2, positive where the body is thinner along j than along i',
        'spin_lift': 'm^3',
        'lift_moment': 'ignored since 0.3',
        'spin_drag': 'Couple -rho (spin_drag_k |w| + spin_drag_stream_k s + spin_drag_layer_k (nu (s + |w| d/2))^(1/2) + spin_drag_stokes_k nu) w_k. All >= 0. In |w| each axis counts by its spin_drag. m^5',
        'spin_drag_stream': 'm^4',
        'spin_drag_stokes': 'm^3',
        'intensity': "velocity fluctuations in the body's own wake, per axis, over s. Above 0.4, gains included, it acts as 0.4: a stronger wake would feed itself",
        'length': 'm: the fluctuations are correlated over length/s',
        'wake_reynolds': 'scales the fluctuations by Re/(Re + wake_reynolds): slow wakes are laminar',
        'broadside': '0 to 1: the fluctuations grow with sum_i broadside_i (v_i/s)^2',
        'lift_stall': 'ignored since 0.3',
        'lift_moment_stalled': 'ignored since 0.3',
        'roll_damping': 'ignored since 0.3',
        'center': 'm, where the loads act, from the centre of buoyancy, body frame; within 2 d; default 0',
        'plate_lift': 'A plate whose normal n is the axis with the largest broadside, with the part v_n of the stream along it and v_t in the plate. The normal force is -1/2 rho N; attached, N = plate_lift |v_t| v_n + plate_vortex |v_n| v_n; separated, N = plate_drag s v_n (1 + 0.8 v_t^2/s^2); half of each where v_n^2/s^2 is plate_stall. A stream along axis i of the plate has the values with index i. m^2, >= 0',
        'plate_vortex': 'm^2, >= 0',
        'plate_stall': '0 to 1',
        'plate_separated_shedding': 'This share of the added momentum along n, 0 to 1, does not move with the body while the stream is separated and sheds vortices: it reduces the Munk moment.',
        'plate_drag': 'm^2, >= 0: drag coefficient broadside times area',
        'start_drag': '>= 0: adds to N start_drag plate_drag |u - v| ((v - u) . v/s^2) v_n',
        'wake_length': 'Memory: u follows v at the rate max(s, |u|)/(wake_lag wake_length). Attached, N takes wake_share of its stream from u. m, > 0',
        'wake_lag': '> 0',
        'wake_share': '0 to 1',
        'strouhal': 'Vortex shedding above the Reynolds number shedding_reynolds of wake_length: an oscillator q in the plate with the frequency strouhal s/wake_length and the moment rho v_n^2 n x (shedding_moment q + shedding_rate_moment r), r the rate of q over 2 pi times the frequency. It starts from the fluctuations. At shedding_reynolds and below, the wake remembers for 2.5 times as long, and the stream stalls later: 1/plate_stall - 1 counts 0.4 times.',
        'shedding_growth': '>= 0',
        'shedding_reynolds': '>= 0',
        'shedding_noise': '>= 0: of r by the fluctuations',
        'shedding_moment': 'm^3',
        'shedding_rate_moment': 'm^3',
        'spin_drag_layer': 'm^(7/2), boundary layer: see spin_drag',
    },
    'lr_rigid_desc': {
        'mass': 'kg, > 0',
        'volume': 'm^3, > 0',
        'inertia': 'kg m^2, positive definite',
        'added_mass': 'kg, kg m, kg m^2: order vx vy vz wx wy wz, fluid density included, as in lr_asset_info; positive semi-definite; default 0',
        'center_of_buoyancy': 'm, from the centre of mass; default 0',
        'fluid_density': 'kg/m^3, > 0; default 1.2, air',
        'fluid_viscosity': 'm^2/s, kinematic, > 0; default 1.5e-5, air',
        'extents': 'm, full size along the body axes, > 0',
        'intensity': 'of the turbulence table, as in lr_ellipsoid_desc; default 1',
        'aerodynamics': "copied; default null: an ellipsoid's with these extents",
    },
    'lr_turbulence_table': {
        'count': 'samples, 1 to 65536',
        'chi': '1/s, turbulent frequency epsilon / k, `count` values >= 0',
        'epsilon': 'm^2/s^3, dissipation rate, `count` values >= 0',
        'dt': 's between samples, > 0',
        'u0': 'm/s, the speed that the table was made at, > 0; `TurbulenceClock.SPEED` scales by it',
        'l': 'm, the length that the table was made with, > 0',
        'c0': 'Kolmogorov constant, > 0; default 6.5, its limit at high Reynolds number',
        'stationary': 'the sample that `TurbulenceClock.SPEED` uses, < count; default 0',
    },
    'lr_body_loads': {
        'station_count': '1 to 8: 1 where one stream describes the shape; 0: no AERODYNAMIC loads',
        'stream': 'm/s, velocity of the fluid relative to the body, its own fluctuations included',
        'wake': 'm/s, the stream that the wake remembers: it follows `stream`',
        'shedding': 'q of the vortex shedding (lr_aerodynamics), up to 1.4; 0: a steady wake',
        'force': 'N, sum of all stations',
        'torque': 'N m, about the centre of mass, with the couples of spin and shed vortices',
        'station_position': 'm, x y z of each station',
        'station_force': "N, x y z of each station's force",
    },
}

# The `_init` function of each struct that has one.
INITS = {
    'lr_ellipsoid_desc': 'lr_ellipsoid_desc_init',
    'lr_asset_info': 'lr_asset_info_init',
    'lr_world_desc': 'lr_world_desc_init',
    'lr_world_info': 'lr_world_info_init',
    'lr_gusts_desc': 'lr_gusts_desc_init',
    'lr_vortex_desc': 'lr_vortex_desc_init',
    'lr_blower_desc': 'lr_blower_desc_init',
    'lr_turbulence_desc': 'lr_turbulence_desc_init',
    'lr_wind_grid_desc': 'lr_wind_grid_desc_init',
    'lr_ground_wind_desc': 'lr_ground_wind_desc_init',
    'lr_water_desc': 'lr_water_desc_init',
    'lr_step_report': 'lr_step_report_init',
    'lr_timings': 'lr_timings_init',
    'lr_recording_desc': 'lr_recording_desc_init',
    'lr_batch_desc': 'lr_batch_desc_init',
    'lr_load_gains': 'lr_load_gains_init',
    'lr_batch_pace': 'lr_batch_pace_init',
    'lr_batch_view': 'lr_batch_view_init',
    'lr_body_desc': 'lr_body_desc_init',
    'lr_body_state': 'lr_body_state_init',
    'lr_body_force': 'lr_body_force_init',
    'lr_force_arrays': 'lr_force_arrays_init',
    'lr_batch_force': 'lr_batch_force_init',
    'lr_collider_desc': 'lr_collider_desc_init',
    'lr_collider_motion': 'lr_collider_motion_init',
    'lr_collider_state': 'lr_collider_state_init',
    'lr_material': 'lr_material_init',
    'lr_batch_contact': 'lr_batch_contact_init',
    'lr_event_list': 'lr_event_list_init',
    'lr_ray': 'lr_ray_init',
    'lr_overlap_desc': 'lr_overlap_desc_init',
    'lr_batch_rules': 'lr_batch_rules_init',
    'lr_emitter_desc': 'lr_emitter_desc_init',
    'lr_batch_counts': 'lr_batch_counts_init',
    'lr_aerodynamics': 'lr_aerodynamics_init',
    'lr_rigid_desc': 'lr_rigid_desc_init',
    'lr_turbulence_table': 'lr_turbulence_table_init',
    'lr_body_loads': 'lr_body_loads_init',
}

# name: (result, parameters, their names, text)
PROTOTYPES = {
    'lr_version': (
        ctypes.c_uint32,
        [],
        (),
        """uint32_t lr_version()

        Version of the loaded library: major << 22 | minor << 12 | patch. Compare it with the macros above when you load the
        library at run time. A different major version has a different ABI; before 1.0, so has a different minor version.
        Any thread.
        """,
    ),
    'lr_status_string': (
        ctypes.c_char_p,
        [ctypes.c_int32],
        ('status',),
        """const char* lr_status_string(lr_status status)

        A short English phrase for a status, without a full stop. Unknown values give "unknown status". Never null; static
        storage.
        Any thread.
        """,
    ),
    'lr_last_error': (
        ctypes.c_char_p,
        [],
        (),
        """const char* lr_last_error()

        The text of the calling thread's last failed call: the function and the reason, as the log has it. Calls that succeed
        leave it alone. Never null, empty before the first failure, cut after 255 bytes. Valid until the thread's next failed
        call.
        Any thread.
        """,
    ),
    'lr_simd_targets': (
        ctypes.c_int32,
        [ctypes.POINTER(ctypes.c_int32), ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint32)],
        ('targets', 'capacity', 'count'),
        """lr_status lr_simd_targets(lr_simd_target* targets, uint32_t capacity, uint32_t* count)

        Lists the instruction sets that this build contains and this processor supports, best first.

        targets: receives up to `capacity` values; may be null when capacity is 0.
        capacity: number of elements that fit
        count: receives the full number, even if it exceeds capacity.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL (count is set).
        Any thread.
        """,
    ),
    'lr_simd_target_name': (
        ctypes.c_char_p,
        [ctypes.c_int32],
        ('target',),
        """const char* lr_simd_target_name(lr_simd_target target)

        A display name: "AVX-512", "AVX2", "SSE4", "NEON", "WebAssembly", "plain", "auto" or "unknown". Never null; static
        storage.
        Any thread.
        """,
    ),
    'lr_asset_load_file': (
        ctypes.c_int32,
        [ctypes.c_char_p, ctypes.POINTER(ctypes.POINTER(lr_asset))],
        ('path_utf8', 'out'),
        """lr_status lr_asset_load_file(const char* path_utf8, lr_asset** out)

        Loads an asset made by `lr_bake` from a regular file. The whole file is verified before any of it is used.

        path_utf8: UTF-8 on every platform.
        out: receives the asset with one reference, which lr_asset_release gives back; null after an error.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_FILE_NOT_FOUND, LR_ERROR_FILE_READ, LR_ERROR_ASSET_FORMAT, LR_ERROR_ASSET_VERSION, LR_ERROR_ASSET_CORRUPT, LR_ERROR_ASSET_INVALID, LR_ERROR_OUT_OF_MEMORY.
        Any thread.
        """,
    ),
    'lr_asset_load_memory': (
        ctypes.c_int32,
        [ctypes.c_void_p, ctypes.c_uint64, ctypes.POINTER(ctypes.POINTER(lr_asset))],
        ('bytes', 'size', 'out'),
        """lr_status lr_asset_load_memory(const void* bytes, uint64_t size, lr_asset** out)

        Loads an asset from memory.

        bytes: of any alignment, not kept.
        size: number of bytes
        out: as for lr_asset_load_file.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_ASSET_*, LR_ERROR_OUT_OF_MEMORY.
        Any thread.
        """,
    ),
    'lr_asset_check_memory': (
        ctypes.c_int32,
        [ctypes.c_void_p, ctypes.c_uint64, lr_fault_fn, ctypes.c_void_p],
        ('bytes', 'size', 'report', 'user'),
        """lr_status lr_asset_check_memory(const void* bytes, uint64_t size, lr_fault_fn report, void* user)

        Checks the bytes of an asset and calls `report`, which may be null, once for each fault found.
        Returns what lr_asset_load_memory would.

        size: number of bytes
        user: passed to each call of the function
        Any thread.
        """,
    ),
    'lr_ellipsoid_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_ellipsoid_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_ellipsoid_desc_init(lr_ellipsoid_desc* desc, uint32_t struct_size)

        Sets the defaults, those of LR_ELLIPSOID_DESC_INIT. All other _init functions work alike. struct_size:
        sizeof(lr_ellipsoid_desc) in the caller's header.

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
        Any thread.
        """,
    ),
    'lr_asset_create_ellipsoid': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_ellipsoid_desc), ctypes.POINTER(ctypes.POINTER(lr_asset))],
        ('desc', 'out'),
        """lr_status lr_asset_create_ellipsoid(const lr_ellipsoid_desc* desc, lr_asset** out)

        Creates an asset from an ellipsoid. Formulas: Lamb, Hydrodynamics, art. 114-115; docs/maintainers/physics.md.

        desc: initialised by its `_init` function, or with struct_size set
        out: as for lr_asset_load_file.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        Any thread.
        """,
    ),
    'lr_asset_retain': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_asset)],
        ('asset',),
        """lr_status lr_asset_retain(lr_asset* asset)

        Adds a reference, which lr_asset_release gives back.

        asset: the asset

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT.
        Any thread.
        """,
    ),
    'lr_asset_release': (
        None,
        [ctypes.POINTER(lr_asset)],
        ('asset',),
        """void lr_asset_release(lr_asset* asset)

        Gives back a reference. The last one frees the asset. Each batch holds its own. Null is allowed.

        asset: the asset
        Any thread.
        """,
    ),
    'lr_asset_info_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_asset_info), ctypes.c_uint32],
        ('info', 'struct_size'),
        """lr_status lr_asset_info_init(lr_asset_info* info, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_asset_get_info': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_asset), ctypes.POINTER(lr_asset_info)],
        ('asset', 'info'),
        """lr_status lr_asset_get_info(const lr_asset* asset, lr_asset_info* info)

        Reads an asset's properties.

        asset: the asset
        info: initialised by lr_asset_info_init, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
        Any thread.
        """,
    ),
    'lr_world_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_world_desc_init(lr_world_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_create': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world_desc), ctypes.POINTER(ctypes.POINTER(lr_world))],
        ('desc', 'out'),
        """lr_status lr_world_create(const lr_world_desc* desc, lr_world** out)

        Creates a world.

        desc: initialised by its `_init` function, or with struct_size set
        out: receives the world, null after an error.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_UNSUPPORTED (simd_target), LR_ERROR_OUT_OF_MEMORY, LR_ERROR_THREADS.
        Any thread.
        """,
    ),
    'lr_world_destroy': (
        None,
        [ctypes.POINTER(lr_world)],
        ('world',),
        """void lr_world_destroy(lr_world* world)

        Destroys a world with its batches and bodies, stops its worker threads and ends its recording. Null is allowed.

        world: the world
        """,
    ),
    'lr_world_info_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world_info), ctypes.c_uint32],
        ('info', 'struct_size'),
        """lr_status lr_world_info_init(lr_world_info* info, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_get_info': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_world_info)],
        ('world', 'info'),
        """lr_status lr_world_get_info(const lr_world* world, lr_world_info* info)

        Reads counts, time and settings of the world.

        world: the world
        info: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_world_set_gravity': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_float)],
        ('world', 'gravity'),
        """lr_status lr_world_set_gravity(lr_world* world, const float* gravity)

        Sets gravity from the next step on. A change wakes all bodies (lr_body_set_sleep).

        world: the world
        gravity: m/s^2, 3 values, each up to 1e4 in magnitude.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_world_set_simd_target': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_int32],
        ('world', 'target'),
        """lr_status lr_world_set_simd_target(lr_world* world, lr_simd_target target)

        Sets the instruction set from the next step on. Results do not change.

        world: the world
        target: LR_SIMD_*.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_UNSUPPORTED.
        """,
    ),
    'lr_world_set_uniform_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_float, ctypes.c_float, ctypes.c_float],
        ('world', 'x', 'y', 'z'),
        """lr_status lr_world_set_uniform_wind(lr_world* world, float x, float y, float z)

        Sets the uniform wind, the same velocity everywhere; 0 before the first call. A change is spread evenly over the next
        step, in which bodies feel the fluid accelerate (Froude-Krylov force and added mass): a body as dense as the fluid is
        carried along, a heavy one keeps most of its velocity. A wind set before the world's first step is there from the
        beginning and accelerates nothing. Setting the same wind again changes nothing.

        world: the world
        x: m/s, each up to 1000 in magnitude.
        y: m/s, each up to 1000 in magnitude.
        z: m/s, each up to 1000 in magnitude.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_world_get_uniform_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_float)],
        ('world', 'velocity'),
        """lr_status lr_world_get_uniform_wind(const lr_world* world, float* velocity)

        Reads the uniform wind that was set last.

        world: the world
        velocity: receives 3 values, m/s; unchanged after an error.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT.
        """,
    ),
    'lr_gusts_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_gusts_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_gusts_desc_init(lr_gusts_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_add_gusts': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_gusts_desc), ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'desc', 'out'),
        """lr_status lr_world_add_gusts(lr_world* world, const lr_gusts_desc* desc, lr_wind_source* out)

        Adds gusts. The struct is copied.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set
        out: receives the handle, id 0 after an error; may be null.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY (of sources), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_world_update_gusts': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_gusts_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_update_gusts(lr_world* world, lr_wind_source source, const lr_gusts_desc* desc)

        Replaces all values of a source of this kind.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set

        Returns LR_OK, LR_ERROR_STALE_WIND_SOURCE, LR_ERROR_INVALID_ARGUMENT (also a source of another kind), and every status of lr_world_add_gusts but LR_ERROR_CAPACITY.
        """,
    ),
    'lr_world_get_gusts': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_gusts_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_get_gusts(const lr_world* world, lr_wind_source source, lr_gusts_desc* desc)

        Reads a source of this kind as it was added or last updated, but with the position where it is now. desc:
        initialised, or with struct_size set; unchanged after an error.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_STALE_WIND_SOURCE, LR_ERROR_INVALID_ARGUMENT (a source of another kind).
        """,
    ),
    'lr_vortex_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_vortex_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_vortex_desc_init(lr_vortex_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_add_vortex': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_vortex_desc), ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'desc', 'out'),
        """lr_status lr_world_add_vortex(lr_world* world, const lr_vortex_desc* desc, lr_wind_source* out)

        Adds a vortex. Returns what lr_world_add_gusts would.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set
        out: the handle; may be null.
        """,
    ),
    'lr_world_update_vortex': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_vortex_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_update_vortex(lr_world* world, lr_wind_source source, const lr_vortex_desc* desc)

        Updates a vortex. Returns what lr_world_update_gusts would.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set
        """,
    ),
    'lr_world_get_vortex': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_vortex_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_get_vortex(const lr_world* world, lr_wind_source source, lr_vortex_desc* desc)

        Reads a vortex as last set. Returns what lr_world_get_gusts would.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set
        """,
    ),
    'lr_blower_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_blower_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_blower_desc_init(lr_blower_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_add_blower': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_blower_desc), ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'desc', 'out'),
        """lr_status lr_world_add_blower(lr_world* world, const lr_blower_desc* desc, lr_wind_source* out)

        Adds a blower. Returns what lr_world_add_gusts would.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set
        out: the handle; may be null.
        """,
    ),
    'lr_world_update_blower': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_blower_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_update_blower(lr_world* world, lr_wind_source source, const lr_blower_desc* desc)

        Updates a blower. Returns what lr_world_update_gusts would.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set
        """,
    ),
    'lr_world_get_blower': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_blower_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_get_blower(const lr_world* world, lr_wind_source source, lr_blower_desc* desc)

        Reads a blower as last set. Returns what lr_world_get_gusts would.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set
        """,
    ),
    'lr_turbulence_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_turbulence_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_turbulence_desc_init(lr_turbulence_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_add_turbulence': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_turbulence_desc), ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'desc', 'out'),
        """lr_status lr_world_add_turbulence(lr_world* world, const lr_turbulence_desc* desc, lr_wind_source* out)

        Adds turbulence. Returns what lr_world_add_gusts would.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set
        out: the handle; may be null.
        """,
    ),
    'lr_world_update_turbulence': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_turbulence_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_update_turbulence(lr_world* world, lr_wind_source source, const lr_turbulence_desc* desc)

        Updates turbulence. Returns what lr_world_update_gusts would.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set
        """,
    ),
    'lr_world_get_turbulence': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_turbulence_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_get_turbulence(const lr_world* world, lr_wind_source source, lr_turbulence_desc* desc)

        Reads turbulence as last set. Returns what lr_world_get_gusts would.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set
        """,
    ),
    'lr_wind_grid_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_wind_grid_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_wind_grid_desc_init(lr_wind_grid_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_add_wind_grid': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_wind_grid_desc), ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'desc', 'out'),
        """lr_status lr_world_add_wind_grid(lr_world* world, const lr_wind_grid_desc* desc, lr_wind_source* out)

        Adds a grid. Returns what lr_world_add_gusts would.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set
        out: the handle; may be null.
        """,
    ),
    'lr_world_update_wind_grid': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_wind_grid_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_update_wind_grid(lr_world* world, lr_wind_source source, const lr_wind_grid_desc* desc)

        Updates a grid. Returns what lr_world_update_gusts would.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set
        """,
    ),
    'lr_world_get_wind_grid': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_wind_grid_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_get_wind_grid(const lr_world* world, lr_wind_source source, lr_wind_grid_desc* desc)

        Reads a grid as last set. Returns what lr_world_get_gusts would.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set
        """,
    ),
    'lr_ground_wind_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_ground_wind_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_ground_wind_desc_init(lr_ground_wind_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_add_ground_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_ground_wind_desc), ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'desc', 'out'),
        """lr_status lr_world_add_ground_wind(lr_world* world, const lr_ground_wind_desc* desc, lr_wind_source* out)

        Adds the wind over a ground. Returns what lr_world_add_gusts would.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set
        out: the handle; may be null.
        """,
    ),
    'lr_world_update_ground_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_ground_wind_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_update_ground_wind(lr_world* world, lr_wind_source source, const lr_ground_wind_desc* desc)

        Updates the wind over a ground. Returns what lr_world_update_gusts would.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set
        """,
    ),
    'lr_world_get_ground_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_ground_wind_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_get_ground_wind(const lr_world* world, lr_wind_source source, lr_ground_wind_desc* desc)

        Reads the wind over a ground as last set. Returns what lr_world_get_gusts would.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set
        """,
    ),
    'lr_world_remove_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32],
        ('world', 'source'),
        """lr_status lr_world_remove_wind(lr_world* world, lr_wind_source source)

        Removes a source of any kind.

        world: the world
        source: handle of a wind source of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_WIND_SOURCE.
        """,
    ),
    'lr_wind_source_is_valid': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32],
        ('world', 'source'),
        """int32_t lr_wind_source_is_valid(const lr_world* world, lr_wind_source source)

        Returns 1 if the wind source exists in this world, else 0. Never an error: see lr_body_is_valid.

        world: the world
        source: handle of a wind source of the world
        """,
    ),
    'lr_world_set_wind_callback': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), lr_wind_fn, ctypes.c_void_p],
        ('world', 'callback', 'user'),
        """lr_status lr_world_set_wind_callback(lr_world* world, lr_wind_fn callback, void* user)

        Sets a callback that adds an engine's own wind field to all other wind. Null removes it. Not part of snapshots.

        world: the world
        user: passed to each call of the function

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world).
        """,
    ),
    'lr_world_sample_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_float), ctypes.c_uint32, ctypes.POINTER(ctypes.c_float)],
        ('world', 'positions', 'count', 'velocities'),
        """lr_status lr_world_sample_wind(const lr_world* world, const float* positions, uint32_t count, float* velocities)

        Evaluates the fluid's velocity from all sources at the world's current time, for particles, cloth or debug arrows.

        world: the world
        positions: 3 * count values, m, x y z x y z ..., each up to 1e9 in magnitude.
        count: number of elements
        velocities: receives 3 * count, m/s. Both may be null when count is 0, and both may be the same array.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_water_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_water_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_water_desc_init(lr_water_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_set_water': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_water_desc)],
        ('world', 'desc'),
        """lr_status lr_world_set_water(lr_world* world, const lr_water_desc* desc)

        Sets the water from the next step on. The struct is copied; null removes the water. Bodies keep their velocities,
        even if they are now in another fluid. A batch whose mass matrix would be singular in water stays in its own fluid,
        and a warning is logged. Part of snapshots and of the world's hash. A change wakes sleeping bodies that feel it.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_world_get_water': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_water_desc), ctypes.POINTER(ctypes.c_int32)],
        ('world', 'desc', 'present'),
        """lr_status lr_world_get_water(const lr_world* world, lr_water_desc* desc, int32_t* present)

        Reads the water.

        world: the world
        desc: initialised, or with struct_size set; receives initial values if there is no water.
        present: receives 1 or 0.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_world_set_water_callback': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), lr_water_fn, ctypes.c_void_p],
        ('world', 'callback', 'user'),
        """lr_status lr_world_set_water_callback(lr_world* world, lr_water_fn callback, void* user)

        Sets a callback for an engine's own water, used while lr_world_set_water has set a surface. Null removes it. Not
        part of snapshots.

        world: the world
        user: passed to each call of the function

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world).
        """,
    ),
    'lr_world_step': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_float, ctypes.c_uint32],
        ('world', 'dt', 'substeps'),
        """lr_status lr_world_step(lr_world* world, float dt, uint32_t substeps)

        Advances all bodies by dt, in `substeps` equal parts. At 60 Hz use 1 substep for flat leaves and paper of a
        few centimetres, 2 for bent leaves, 4 for petals and confetti (docs/maintainers/numerics.md). Rules end bodies and
        emitters spawn them at the end of the step. Allocates only in the case that lr_allocator describes. Saves, sets and
        restores the calling thread's floating-point mode. Needs 192 KB of stack.

        world: the world
        dt: s, > 0.
        substeps: 1 to LR_MAX_SUBSTEPS.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_TIMESTEP_*, LR_ERROR_SUBSTEPS, LR_ERROR_OUT_OF_MEMORY: the step was taken, so do not repeat it, but bodies may have passed through each other. The next step asks for the memory again.
        """,
    ),
    'lr_world_set_budget': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint64],
        ('world', 'body_substeps'),
        """lr_status lr_world_set_budget(lr_world* world, uint64_t body_substeps)

        Limits the work of each step to a number of substeps of single bodies: the same work, so the same bits, on every
        machine. Takes effect at the next step. Part of snapshots. If the batches that are due need more, each first gets the
        fewest substeps that preserve its fall statistics (lr_batch_set_rate); batches that have waited longest come first,
        and none waits forever. A batch with forces on single bodies is stepped at once, even beyond the budget.
        docs/reference/stepping.md.

        world: the world
        body_substeps: at most 2^48; 0, the default, for no limit.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_step_report_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_step_report), ctypes.c_uint32],
        ('report', 'struct_size'),
        """lr_status lr_step_report_init(lr_step_report* report, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_get_step_report': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_step_report)],
        ('world', 'report'),
        """lr_status lr_world_get_step_report(const lr_world* world, lr_step_report* report)

        Reads the report of the last step: zeros before the first step and after a snapshot is restored.

        world: the world
        report: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_timings_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_timings), ctypes.c_uint32],
        ('timings', 'struct_size'),
        """lr_status lr_timings_init(lr_timings* timings, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_get_timings': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_timings)],
        ('world', 'timings'),
        """lr_status lr_world_get_timings(const lr_world* world, lr_timings* timings)

        Reads the timings of the last step: zeros before the first one.

        world: the world
        timings: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_world_hash': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_uint64)],
        ('world', 'out'),
        """lr_status lr_world_hash(const lr_world* world, uint64_t* out)

        Computes a hash of the world's time index, bodies, colliders, pairs of touching bodies, water and wind sources (grids
        by the hash of their samples). It does not depend on the order of bodies in memory, the processor or worker_count.
        Worlds with equal settings and equal hashes move alike from here on.

        world: the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT.
        """,
    ),
    'lr_world_snapshot_size': (
        ctypes.c_uint64,
        [ctypes.POINTER(lr_world)],
        ('world',),
        """uint64_t lr_world_snapshot_size(const lr_world* world)

        Bytes that lr_world_snapshot_save needs at present; 0 for null. With body contact 120 of them for each pair of awake
        bodies that touch or nearly do.

        world: the world
        """,
    ),
    'lr_world_snapshot_save': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_void_p, ctypes.c_uint64, ctypes.POINTER(ctypes.c_uint64)],
        ('world', 'memory', 'size', 'written'),
        """lr_status lr_world_snapshot_save(const lr_world* world, void* memory, uint64_t size, uint64_t* written)

        Writes the world's state into `size` bytes at `memory`, of any alignment: time, gravity, wind, water, budget; bodies
        and colliders with their handles; pairs of touching bodies; each batch's turbulence table, loads, forces, rules,
        emitter, rate and contact settings. Not included: assets, the descs of batches, threads, callbacks, the samples of
        wind grids, and the data of hulls, heightfields and meshes; samples and data are identified by their hash.

        world: the world
        memory: the bytes
        size: number of bytes
        written: bytes used; may be null.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL.
        """,
    ),
    'lr_world_snapshot_restore': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_void_p, ctypes.c_uint64],
        ('world', 'memory', 'size'),
        """lr_status lr_world_snapshot_restore(lr_world* world, const void* memory, uint64_t size)

        Restores a saved state. The world may be another one, also in another process, if its batches were created in the
        same order from equal assets with equal capacities. Bodies, wind sources and colliders get their handles back. Wind
        grids, hulls, heightfields and meshes must already be in the world, anywhere. The snapshot is checked as a whole
        before anything changes. Allocates nothing in a world that has held as much before. docs/reference/snapshots.md says
        which versions restore which snapshots.

        world: the world
        memory: the bytes
        size: number of bytes

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_SNAPSHOT_FORMAT, LR_ERROR_SNAPSHOT_MISMATCH, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_recording_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_recording_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_recording_desc_init(lr_recording_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_record_start': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_recording_desc)],
        ('world', 'desc'),
        """lr_status lr_world_record_start(lr_world* world, const lr_recording_desc* desc)

        Starts a recording, at any time. First writes the world's present state and the assets of its batches, then each call
        that can change the world: its arguments, as a rule before it is carried out, and its status after it. Allocates 64
        KiB and a few bytes per asset; while starting, also a copy of the assets and a snapshot. If `write` refuses, the
        recording ends, a message is logged, and the world goes on.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->write), LR_ERROR_STRUCT_SIZE, LR_ERROR_INVALID_ARGUMENT (unknown flags; already recording; `write` has refused), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_world_record_stop': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world)],
        ('world',),
        """lr_status lr_world_record_stop(lr_world* world)

        Ends a recording.

        world: the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (not recording, also after `write` has refused).
        """,
    ),
    'lr_batch_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_batch_desc_init(lr_batch_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_batch_create': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_batch_desc), ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'desc', 'out'),
        """lr_status lr_batch_create(lr_world* world, const lr_batch_desc* desc, lr_batch* out)

        Creates a batch.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set
        out: receives the batch, id 0 after an error.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->asset), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_destroy': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32],
        ('world', 'batch'),
        """lr_status lr_batch_destroy(lr_world* world, lr_batch batch)

        Destroys a batch with all its bodies. Wakes the bodies of batches that had body contact with it
        (lr_batch_set_body_contact).

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH.
        """,
    ),
    'lr_batch_is_valid': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32],
        ('world', 'batch'),
        """int32_t lr_batch_is_valid(const lr_world* world, lr_batch batch)

        Returns 1 if the batch exists in this world, else 0. Never an error: see lr_body_is_valid.

        world: the world
        batch: handle of a batch of the world
        """,
    ),
    'lr_load_gains_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_load_gains), ctypes.c_uint32],
        ('gains', 'struct_size'),
        """lr_status lr_load_gains_init(lr_load_gains* gains, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_batch_set_load_gains': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_load_gains)],
        ('world', 'batch', 'gains'),
        """lr_status lr_batch_set_load_gains(lr_world* world, lr_batch batch, const lr_load_gains* gains)

        Sets the gains of a batch from the next step on; null sets all to 1. The gains of LANGEVIN loads are in
        lr_batch_desc.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_batch_get_load_gains': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_load_gains)],
        ('world', 'batch', 'gains'),
        """lr_status lr_batch_get_load_gains(const lr_world* world, lr_batch batch, lr_load_gains* gains)

        Reads the gains of a batch.

        world: the world
        batch: handle of a batch of the world
        gains: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_batch_set_rate': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_uint32],
        ('world', 'batch', 'divisor'),
        """lr_status lr_batch_set_rate(lr_world* world, lr_batch batch, uint32_t divisor)

        Sets how often a batch is stepped: level of detail for bodies that are far away, small or out of sight. A batch of
        divisor n takes one substep where other batches take n: fewer in each step or, if n exceeds the world's substeps, one
        every few steps that covers them all. Substeps are never so long that fall statistics change: at most 1/60 s, and
        length_d / 2 m/s for bodies under 3.3 cm. Larger divisors have no further effect. docs/reference/stepping.md.
        Takes effect at the next step and may change at any time: a waiting batch catches up when it is next stepped. Part of
        snapshots. While a batch waits
         - views and lr_body_get_state show bodies as of their last step, lr_batch_pace.behind ago;
         - bodies that are created or set count as of that time too;
         - lr_batch_write_transforms extrapolates to the present by the bodies' velocities;
         - a force on one of its bodies ends the wait, and acts with the impulse that it would have had in one step;
         - a collider that moves within the bounds of its bodies ends the wait, since it would pass through them;
         - its rules, emitter and events wait too.

        world: the world
        batch: handle of a batch of the world
        divisor: 1 to 1024; default 1.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_batch_pace_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_pace), ctypes.c_uint32],
        ('pace', 'struct_size'),
        """lr_status lr_batch_pace_init(lr_batch_pace* pace, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_batch_get_pace': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_pace)],
        ('world', 'batch', 'pace'),
        """lr_status lr_batch_get_pace(const lr_world* world, lr_batch batch, lr_batch_pace* pace)

        Reads a batch's rate and backlog.

        world: the world
        batch: handle of a batch of the world
        pace: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_batch_view_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_view), ctypes.c_uint32],
        ('view', 'struct_size'),
        """lr_status lr_batch_view_init(lr_batch_view* view, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_batch_get_view': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_view)],
        ('world', 'batch', 'view'),
        """lr_status lr_batch_get_view(const lr_world* world, lr_batch batch, lr_batch_view* view)

        Gets the view of a batch.

        world: the world
        batch: handle of a batch of the world
        view: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_batch_get_bounds': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(ctypes.c_float), ctypes.POINTER(ctypes.c_float)],
        ('world', 'batch', 'low', 'high'),
        """lr_status lr_batch_get_bounds(const lr_world* world, lr_batch batch, float* low, float* high)

        Computes a box around all bodies of a batch, awake or asleep, for culling. Each body counts as the sphere that
        contains it in any orientation; the box of a waiting batch (lr_batch_set_rate) also contains the places that
        lr_batch_write_transforms extrapolates to. The cost is proportional to the number of bodies.

        world: the world
        batch: handle of a batch of the world
        low: receive x, y, z of the corners, m, world frame. A batch without bodies gives the largest float in `low` and its negative in `high`: the union with any other box is that box.
        high: receive x, y, z of the corners, m, world frame. A batch without bodies gives the largest float in `low` and its negative in `high`: the union with any other box is that box.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH.
        """,
    ),
    'lr_batch_write_transforms': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'batch', 'format', 'dst', 'stride', 'count', 'written'),
        """lr_status lr_batch_write_transforms(const lr_world* world, lr_batch batch, lr_transform_format format, void* dst, uint64_t stride, uint32_t count, uint32_t* written)

        Writes the transforms of a batch's first `count` bodies, or of all if there are fewer, in the order of its view. Draw
        a mesh whose origin is the centre of mass (lr_asset_info.center_of_mass). Bodies of a waiting batch
        (lr_batch_set_rate) are extrapolated to the world's time.
        An instance buffer that still holds the last write needs no rewrite of sleeping bodies. While lr_batch_view.revision
        is unchanged, `count` may be the greater of the old and the new awake_count; otherwise write all bodies. Remember
        both numbers per buffer. docs/reference/bodies.md.

        world: the world
        batch: handle of a batch of the world
        format: one of the constants above
        dst: 4-byte aligned, room for `count` elements `stride` bytes apart.
        stride: 0 for elements without gaps, else a multiple of 4 no smaller than an element.
        count: number of elements
        written: elements written; may be null.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (dst may be null only when nothing is to be written), LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_batch_write_velocities': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'batch', 'dst', 'stride', 'count', 'written'),
        """lr_status lr_batch_write_velocities(const lr_world* world, lr_batch batch, void* dst, uint64_t stride, uint32_t count, uint32_t* written)

        Writes the velocities of a batch's first `count` bodies, or of all if there are fewer, in the order of its view. An
        element is 6 floats, world frame: the linear velocity of the centre of mass, m/s, and the angular velocity, rad/s; bit
        for bit those of lr_body_get_state. Sleeping bodies have 0, bodies of a waiting batch (lr_batch_set_rate) the
        velocities of their last step.

        world: the world
        batch: handle of a batch of the world
        dst: 4-byte aligned, room for `count` elements `stride` bytes apart.
        stride: 0 for elements without gaps, else a multiple of 4 no smaller than an element.
        count: number of elements
        written: elements written; may be null.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (dst may be null only when nothing is to be written), LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_body_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_body_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_body_desc_init(lr_body_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_body_create': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_body_desc), ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint64)],
        ('world', 'batch', 'descs', 'count', 'out_ids'),
        """lr_status lr_body_create(lr_world* world, lr_batch batch, const lr_body_desc* descs, uint32_t count, lr_body* out_ids)

        Creates `count` bodies, all or none.

        world: the world
        batch: handle of a batch of the world
        descs: `count` elements.
        count: number of elements
        out_ids: receives `count` ids; may be null. The first `user` other than 0 allocates 8 bytes for each body of the batch's capacity.

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_body_destroy': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_uint64), ctypes.c_uint32],
        ('world', 'bodies', 'count'),
        """lr_status lr_body_destroy(lr_world* world, const lr_body* bodies, uint32_t count)

        Destroys `count` bodies of any batches, all or none: a stale or repeated id fails the call. Wakes the bodies that lay
        on them.

        world: the world
        bodies: `count` ids of bodies
        count: number of elements

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY.
        """,
    ),
    'lr_body_is_valid': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint64],
        ('world', 'body'),
        """int32_t lr_body_is_valid(const lr_world* world, lr_body body)

        Returns 1 if the body exists in this world, else 0. Never an error: a null world gives 0, and so does a call
        that lr_world_desc.checks refuses. Not recorded.

        world: the world
        body: id of a body
        """,
    ),
    'lr_body_state_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_body_state), ctypes.c_uint32],
        ('state', 'struct_size'),
        """lr_status lr_body_state_init(lr_body_state* state, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_body_get_state': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint64, ctypes.POINTER(lr_body_state)],
        ('world', 'body', 'state'),
        """lr_status lr_body_get_state(const lr_world* world, lr_body body, lr_body_state* state)

        Reads the state of a body.

        world: the world
        body: id of a body
        state: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_body_set_state': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint64, ctypes.POINTER(lr_body_state)],
        ('world', 'body', 'state'),
        """lr_status lr_body_set_state(lr_world* world, lr_body body, const lr_body_state* state)

        Sets everything but the noise seed, and wakes the body. The quaternion is normalised. Limits, also of lr_body_create:
        positions up to 1e9 m, velocities up to 1e6 m/s and rad/s. To steer bodies every frame, prefer forces and wind:
        setting the state bypasses physics.

        world: the world
        body: id of a body

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY (of `user`, as for lr_body_create).
        """,
    ),
    'lr_body_set_sleep': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_uint64), ctypes.c_uint32, ctypes.c_int32],
        ('world', 'bodies', 'count', 'sleep_state'),
        """lr_status lr_body_set_sleep(lr_world* world, const lr_body* bodies, uint32_t count, lr_sleep_state sleep_state)

        Puts bodies of any batches to sleep or wakes them, all or none. Bodies may already be in that state, and ids may
        repeat. A sleeping body does not move, whatever acts on it, and adds no cost to a step. Its velocities and pending
        forces are cleared. It still ages, and its batch's rules still apply: they check sleeping bodies in every 16th step
        of the batch. Falling asleep and waking change a body's index in the view, not its id. Part of snapshots. A batch's
        first sleeping body allocates up to 25 bytes for each body of the batch's capacity. A body is woken by
         - this function, lr_world_wake_box and lr_body_set_state;
         - a force, impulse or velocity other than zero (lr_body_add_force, lr_batch_add_forces);
         - a change by lr_batch_set_force, lr_world_set_gravity or lr_batch_set_body_contact that concerns it;
         - a respawn by its batch's rules;
         - contact with colliders or other bodies, and wind: docs/reference/bodies.md.

        world: the world
        bodies: `count` ids of bodies
        count: number of elements
        sleep_state: LR_SLEEP_*.

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_world_wake_box': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_float), ctypes.POINTER(ctypes.c_float), ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'low', 'high', 'woken'),
        """lr_status lr_world_wake_box(lr_world* world, const float* low, const float* high, uint32_t* woken)

        Wakes all sleeping bodies that touch a box, for events that the world does not know about, such as footsteps and
        explosions. Each body counts as the cube that contains it in any orientation. The cost depends on the bodies near the
        box alone.

        world: the world
        low: x, y, z of its corners, m, low <= high.
        high: x, y, z of its corners, m, low <= high.
        woken: receives how many; may be null.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_body_force_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_body_force), ctypes.c_uint32],
        ('force', 'struct_size'),
        """lr_status lr_body_force_init(lr_body_force* force, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_body_add_force': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_body_force), ctypes.c_uint32],
        ('world', 'forces', 'count'),
        """lr_status lr_body_add_force(lr_world* world, const lr_body_force* forces, uint32_t count)

        Applies `count` forces to bodies of any batches, all or none. A body may occur more than once. Each element may give
        its body at most 1e9 m/s^2 (torques: 1e9 m/s^2 over its length), an impulse at most 1e6 m/s and rad/s. Pending forces
        are part of snapshots and of the world's hash. The first force or acceleration on a body of a batch allocates 96
        bytes for each body of the batch's capacity.

        world: the world
        count: number of elements

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_force_arrays_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_force_arrays), ctypes.c_uint32],
        ('arrays', 'struct_size'),
        """lr_status lr_force_arrays_init(lr_force_arrays* arrays, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_batch_add_forces': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_force_arrays)],
        ('world', 'batch', 'arrays'),
        """lr_status lr_batch_add_forces(lr_world* world, lr_batch batch, const lr_force_arrays* arrays)

        Applies forces to many bodies of a batch; limits, snapshots and memory as for lr_body_add_force.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (some of three pointers), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also if first + count exceeds the batch's bodies), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_force_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_force), ctypes.c_uint32],
        ('force', 'struct_size'),
        """lr_status lr_batch_force_init(lr_batch_force* force, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_batch_set_force': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_force)],
        ('world', 'batch', 'force'),
        """lr_status lr_batch_set_force(lr_world* world, lr_batch batch, const lr_batch_force* force)

        Sets the forces on a batch from the next step on. The struct is copied; null clears them. A change wakes the batch's
        sleeping bodies. Part of snapshots.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_batch_get_force': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_force)],
        ('world', 'batch', 'force'),
        """lr_status lr_batch_get_force(const lr_world* world, lr_batch batch, lr_batch_force* force)

        Reads the forces on every body of a batch.

        world: the world
        batch: handle of a batch of the world
        force: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_collider_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_collider_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_collider_desc_init(lr_collider_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_collider_create': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_collider_desc), ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint64)],
        ('world', 'descs', 'count', 'out_ids'),
        """lr_status lr_collider_create(lr_world* world, const lr_collider_desc* descs, uint32_t count, lr_collider* out_ids)

        Creates `count` colliders, all or none, which collide from the next step on. Equal hulls, heightfields and meshes
        share one copy of their data.

        world: the world
        descs: `count` elements.
        count: number of elements
        out_ids: receives `count` handles; may be null.

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT (also for arrays that the kind needs), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also for a flat hull, thinner than 1e-4 of its largest extent, and for a mesh with an index out of range or no triangle with an area), LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_collider_destroy': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_uint64), ctypes.c_uint32],
        ('world', 'colliders', 'count'),
        """lr_status lr_collider_destroy(lr_world* world, const lr_collider* colliders, uint32_t count)

        Destroys `count` colliders, all or none: a stale or repeated handle fails the call.

        world: the world
        colliders: `count` handles of colliders
        count: number of elements

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER.
        """,
    ),
    'lr_collider_is_valid': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint64],
        ('world', 'collider'),
        """int32_t lr_collider_is_valid(const lr_world* world, lr_collider collider)

        Returns 1 if the collider exists in this world, else 0. Never an error: see lr_body_is_valid.

        world: the world
        collider: handle of a collider
        """,
    ),
    'lr_collider_motion_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_collider_motion), ctypes.c_uint32],
        ('motion', 'struct_size'),
        """lr_status lr_collider_motion_init(lr_collider_motion* motion, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_collider_move': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_collider_motion), ctypes.c_uint32],
        ('world', 'motions', 'count'),
        """lr_status lr_collider_move(lr_world* world, const lr_collider_motion* motions, uint32_t count)

        Moves `count` colliders, all or none, in order: the last motion of a collider wins. While a plane rotates, no body of
        the world can use the fast path.

        world: the world
        count: number of elements

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_STALE_COLLIDER, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_collider_state_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_collider_state), ctypes.c_uint32],
        ('state', 'struct_size'),
        """lr_status lr_collider_state_init(lr_collider_state* state, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_collider_get_state': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint64, ctypes.POINTER(lr_collider_state)],
        ('world', 'collider', 'state'),
        """lr_status lr_collider_get_state(const lr_world* world, lr_collider collider, lr_collider_state* state)

        Reads the state of a collider.

        world: the world
        collider: handle of a collider
        state: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_material_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_material), ctypes.c_uint32],
        ('material', 'struct_size'),
        """lr_status lr_material_init(lr_material* material, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_collider_set_material': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_uint64), ctypes.c_uint32, ctypes.POINTER(lr_material)],
        ('world', 'colliders', 'count', 'material'),
        """lr_status lr_collider_set_material(lr_world* world, const lr_collider* colliders, uint32_t count, const lr_material* material)

        Sets one material for `count` colliders, all or none, from the next step on. A change wakes bodies asleep on them.

        world: the world
        colliders: `count` handles of colliders
        count: number of elements

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_batch_contact_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_contact), ctypes.c_uint32],
        ('contact', 'struct_size'),
        """lr_status lr_batch_contact_init(lr_batch_contact* contact, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_batch_set_contact': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_contact)],
        ('world', 'batch', 'contact'),
        """lr_status lr_batch_set_contact(lr_world* world, lr_batch batch, const lr_batch_contact* contact)

        Sets how a batch collides from the next step on. The struct is copied; null restores the defaults. Wakes the batch's
        sleeping bodies. Part of snapshots.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_batch_get_contact': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_contact)],
        ('world', 'batch', 'contact'),
        """lr_status lr_batch_get_contact(const lr_world* world, lr_batch batch, lr_batch_contact* contact)

        Reads how a batch collides.

        world: the world
        batch: handle of a batch of the world
        contact: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_batch_set_body_contact': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_uint32, ctypes.c_int32],
        ('world', 'a', 'b', 'enabled'),
        """lr_status lr_batch_set_body_contact(lr_world* world, lr_batch a, lr_batch b, int32_t enabled)

        Turns body contact on or off from the next step on: collisions between bodies of `a` and bodies of `b`, in either
        order. Pass the same batch twice for collisions within it. Off by default. Contacts use friction, restitution and
        rolling resistance of lr_batch_contact, combined as there; layers apply to colliders only. Bodies of batches stepped
        at different rates (lr_batch_set_rate), or waiting for the budget, collide only while one of the two is asleep. A
        change wakes the sleeping bodies of both batches. Part of snapshots. A batch's first pair allocates 28 bytes for each
        body of its capacity, and up to 75 more if the world has never had colliders. docs/maintainers/contact.md.

        world: the world
        a: handle of a batch of the world
        b: handle of a batch of the world
        enabled: 0 or 1.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH (either), LR_ERROR_INVALID_ARGUMENT (enabled), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_get_body_contact': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_uint32, ctypes.POINTER(ctypes.c_int32)],
        ('world', 'a', 'b', 'enabled'),
        """lr_status lr_batch_get_body_contact(const lr_world* world, lr_batch a, lr_batch b, int32_t* enabled)

        Reads whether bodies of two batches collide.

        world: the world
        a: handle of a batch of the world
        b: handle of a batch of the world
        enabled: receives 0 or 1; unchanged after an error.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH (either).
        """,
    ),
    'lr_world_set_events': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_uint32],
        ('world', 'capacity', 'kinds'),
        """lr_status lr_world_set_events(lr_world* world, uint32_t capacity, lr_event_kinds kinds)

        Enables events; at most `capacity` are stored per step. Contacts that already exist do not begin again. capacity 0
        disables events. All memory is allocated here and by lr_batch_create, none in steps: 64 bytes per event, and 233 for
        each body of a batch's capacity. Not part of the world's hash. Snapshots contain only events that calls since the
        last step have left for the next one, 33 bytes for each body of a batch's capacity.

        world: the world
        capacity: number of elements that fit
        kinds: bits LR_EVENTS_*.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (unknown bits, or no bits with a capacity), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_event_list_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_event_list), ctypes.c_uint32],
        ('list', 'struct_size'),
        """lr_status lr_event_list_init(lr_event_list* list, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_get_events': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_event_list)],
        ('world', 'list'),
        """lr_status lr_world_get_events(const lr_world* world, lr_event_list* list)

        Gets the events of the last step. Valid until the next call that is not a query; empty after
        lr_world_snapshot_restore. Sorted by batch (its place in the world's table), noise seed, kind and collider slot, so
        the order does not depend on workers, processor or memory. Bodies with the same noise seed are sorted by slot.
        Contacts are checked after each substep but end only at the end of a step: a body that bounces within a step begins
        one contact, and one that touches and leaves begins and ends it. A sleeping body still touches its support. A body
        that ends has one LR_EVENT_KILLED or LR_EVENT_RESPAWNED, and before it at most LR_EVENT_SPAWNED, after it at most
        LR_EVENT_DIVERGED. lr_body_destroy and lr_batch_destroy cause no event. A body has at most four contacts, those that
        press it most. Contact with other bodies takes one of the four and causes no events, but a body that falls asleep on
        other bodies has landed.

        world: the world
        list: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_ray_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_ray), ctypes.c_uint32],
        ('ray', 'struct_size'),
        """lr_status lr_ray_init(lr_ray* ray, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_ray_cast': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_ray), ctypes.c_uint32, ctypes.POINTER(lr_ray_hit)],
        ('world', 'rays', 'count', 'hits'),
        """lr_status lr_world_ray_cast(const lr_world* world, const lr_ray* rays, uint32_t count, lr_ray_hit* hits)

        Finds the first hit of each ray. Bodies have their contact shape, the hull of their asset or an ellipsoid
        (docs/maintainers/contact.md); bodies of waiting batches (lr_batch_set_rate) are where they were last stepped. Planes
        and heightfields are solid below their surface; meshes are hit from both sides. Colliders are where the last step or
        lr_collider_move put them. Hits at equal distances are sorted: bodies before colliders, then by batch and noise seed
        or by collider slot.

        world: the world
        rays: `count` elements.
        count: number of elements
        hits: receives `count` elements; none are written after an error.

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_STALE_BATCH.
        """,
    ),
    'lr_overlap_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_overlap_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_overlap_desc_init(lr_overlap_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_world_overlap': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_overlap_desc), ctypes.POINTER(ctypes.c_uint64), ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'desc', 'bodies', 'capacity', 'count'),
        """lr_status lr_world_overlap(const lr_world* world, const lr_overlap_desc* desc, lr_body* bodies, uint32_t capacity, uint32_t* count)

        Finds all bodies that overlap a sphere or box, sorted by batch, noise seed and slot. Shapes and places of bodies are
        as for rays.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set
        bodies: room for `capacity` ids; may be null when capacity is 0.
        capacity: number of elements that fit
        count: receives how many there are.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_BUFFER_TOO_SMALL: *count is set, and the contents of `bodies` are undefined.
        """,
    ),
    'lr_batch_rules_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_rules), ctypes.c_uint32],
        ('rules', 'struct_size'),
        """lr_status lr_batch_rules_init(lr_batch_rules* rules, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_batch_set_rules': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_rules)],
        ('world', 'batch', 'rules'),
        """lr_status lr_batch_set_rules(lr_world* world, lr_batch batch, const lr_batch_rules* rules)

        Sets the rules of a batch. Awake bodies are checked at the end of each step, sleeping ones in every 16th step of
        their batch. The struct is copied; null removes the rules. Part of snapshots. A batch's first rules or emitter
        allocate 8 bytes for each body of its capacity; later calls, such as moving a volume along with a camera, allocate
        nothing.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also LR_END_RESPAWN without an emitter), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_get_rules': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_rules), ctypes.POINTER(ctypes.c_int32)],
        ('world', 'batch', 'rules', 'present'),
        """lr_status lr_batch_get_rules(const lr_world* world, lr_batch batch, lr_batch_rules* rules, int32_t* present)

        Reads the rules of a batch.

        world: the world
        batch: handle of a batch of the world
        rules: initialised, or with struct_size set; receives initial values if there are none.
        present: receives 1 or 0.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_batch_set_divergence_policy': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_int32],
        ('world', 'batch', 'policy'),
        """lr_status lr_batch_set_divergence_policy(lr_world* world, lr_batch batch, lr_divergence_policy policy)

        Sets how a batch treats diverged bodies: those with a number that is not finite, a coordinate over 1e10 m, a velocity
        over 2e6 m/s or 1e9 rad/s, or an invalid orientation. Bodies diverge through extreme forces, an unstable integrator,
        or a collider that shoots them out of the world. Every body is checked in each step and after impulses, so such
        values are never visible and never affect other bodies. At the end of the step the body causes LR_EVENT_DIVERGED and
        counts in lr_batch_counts; one message is logged for all. docs/reference/bodies.md
        A held body stays at its position and orientation from the beginning of that step or substep, without velocity. It
        collides with nothing, and forces on it are accepted without effect. It ages, and rules can end it. lr_body_set_state
        frees it, lr_body_set_sleep can put it to sleep, and lr_body_state.sleep_state shows that it is held.
        Takes effect at the next step; bodies already held stay held. Part of snapshots and of the world's hash.
        LR_DIVERGENCE_REMOVE allocates as lr_batch_set_rules does.

        world: the world
        batch: handle of a batch of the world
        policy: LR_DIVERGENCE_*; default LR_DIVERGENCE_AUTO.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_get_divergence_policy': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(ctypes.c_int32)],
        ('world', 'batch', 'policy'),
        """lr_status lr_batch_get_divergence_policy(const lr_world* world, lr_batch batch, lr_divergence_policy* policy)

        Reads how a batch treats diverged bodies.

        world: the world
        batch: handle of a batch of the world
        policy: receives LR_DIVERGENCE_*; unchanged after an error.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH.
        """,
    ),
    'lr_emitter_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_emitter_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_emitter_desc_init(lr_emitter_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_batch_set_emitter': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_emitter_desc)],
        ('world', 'batch', 'desc'),
        """lr_status lr_batch_set_emitter(lr_world* world, lr_batch batch, const lr_emitter_desc* desc)

        Sets the emitter of a batch. Bodies spawn at the end of each step, after rules have ended others, up to the batch's
        capacity; spawns beyond it are dropped, not postponed. New bodies take the world's next noise seeds, and 0 as `user`.
        The struct is copied; null removes the emitter. A replacement keeps the pending fraction of a spawn and the time since
        the last burst. Part of snapshots. Allocates as lr_batch_set_rules does.

        world: the world
        batch: handle of a batch of the world
        desc: initialised by its `_init` function, or with struct_size set

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also null while the rules respawn), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_get_emitter': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_emitter_desc), ctypes.POINTER(ctypes.c_int32)],
        ('world', 'batch', 'desc', 'present'),
        """lr_status lr_batch_get_emitter(const lr_world* world, lr_batch batch, lr_emitter_desc* desc, int32_t* present)

        Reads the emitter of a batch.

        world: the world
        batch: handle of a batch of the world
        desc: initialised, or with struct_size set; receives initial values if there is none.
        present: receives 1 or 0.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_batch_spawn': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint64)],
        ('world', 'batch', 'count', 'out_ids'),
        """lr_status lr_batch_spawn(lr_world* world, lr_batch batch, uint32_t count, lr_body* out_ids)

        Spawns `count` bodies now, all or none.

        world: the world
        batch: handle of a batch of the world
        count: number of elements
        out_ids: receives `count` ids; may be null.

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT (no emitter), LR_ERROR_CAPACITY.
        """,
    ),
    'lr_batch_spawn_box': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(ctypes.c_float), ctypes.POINTER(ctypes.c_float), ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint64)],
        ('world', 'batch', 'low', 'high', 'count', 'out_ids'),
        """lr_status lr_batch_spawn_box(lr_world* world, lr_batch batch, const float* low, const float* high, uint32_t count, lr_body* out_ids)

        Spawns `count` bodies in a box now, all or none, without an emitter: awake, evenly distributed, each orientation
        equally likely, at rest, scale 1, age 0, with the world's next noise seeds. Random values depend only on the world's
        seed and the body's noise seed, as with an LR_EMIT_BOX emitter. Causes LR_EVENT_SPAWNED. Allocates nothing, and so
        counts in lr_batch_counts only while the batch has rules or an emitter.

        world: the world
        batch: handle of a batch of the world
        low: x, y, z of the corners, m, each up to 1e9 in magnitude, low <= high.
        high: x, y, z of the corners, m, each up to 1e9 in magnitude, low <= high.
        count: number of elements
        out_ids: receives `count` ids; may be null.

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY.
        """,
    ),
    'lr_batch_counts_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_counts), ctypes.c_uint32],
        ('counts', 'struct_size'),
        """lr_status lr_batch_counts_init(lr_batch_counts* counts, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_batch_get_counts': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_counts)],
        ('world', 'batch', 'counts'),
        """lr_status lr_batch_get_counts(const lr_world* world, lr_batch batch, lr_batch_counts* counts)

        Reads the counts of a batch. A batch that never had rules or an emitter counts only diverged bodies. Totals
        are part of snapshots; after a restore the counts of the last step are 0.

        world: the world
        batch: handle of a batch of the world
        counts: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_aerodynamics_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_aerodynamics), ctypes.c_uint32],
        ('aerodynamics', 'struct_size'),
        """lr_status lr_aerodynamics_init(lr_aerodynamics* aerodynamics, uint32_t struct_size)

        Sets the axes to the body's, `length`, `wake_length` and `wake_lag` to 1 and everything else to 0: no loads.

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_asset_get_aerodynamics': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_asset), ctypes.POINTER(lr_aerodynamics)],
        ('asset', 'aerodynamics'),
        """lr_status lr_asset_get_aerodynamics(const lr_asset* asset, lr_aerodynamics* aerodynamics)

        Reads an asset's baked coefficients.

        asset: the asset
        aerodynamics: initialised by lr_aerodynamics_init, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
        Any thread.
        """,
    ),
    'lr_batch_set_aerodynamics': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_aerodynamics)],
        ('world', 'batch', 'aerodynamics'),
        """lr_status lr_batch_set_aerodynamics(lr_world* world, lr_batch batch, const lr_aerodynamics* aerodynamics)

        Replaces the asset's coefficients of AERODYNAMIC loads for a batch from the next step on. The struct is copied; null
        restores the asset's. With intensity 0, lr_load_gains.turbulence 1 and lr_batch_desc.variation 0 a fall is the same
        for any seed. Axes other than the body's, or a center other than 0, put an LR_ASSET_DIAGONAL body on the slower path
        of contact.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_batch_get_aerodynamics': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_aerodynamics)],
        ('world', 'batch', 'aerodynamics'),
        """lr_status lr_batch_get_aerodynamics(const lr_world* world, lr_batch batch, lr_aerodynamics* aerodynamics)

        Reads a batch's current coefficients.

        world: the world
        batch: handle of a batch of the world
        aerodynamics: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_rigid_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_rigid_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_rigid_desc_init(lr_rigid_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_asset_create_rigid': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_rigid_desc), ctypes.POINTER(ctypes.POINTER(lr_asset))],
        ('desc', 'out'),
        """lr_status lr_asset_create_rigid(const lr_rigid_desc* desc, lr_asset** out)

        Creates an asset from given numbers.

        desc: initialised by its `_init` function, or with struct_size set
        out: as for lr_asset_load_file.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also for matrices that no body can have), LR_ERROR_OUT_OF_MEMORY.
        Any thread.
        """,
    ),
    'lr_turbulence_table_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_turbulence_table), ctypes.c_uint32],
        ('table', 'struct_size'),
        """lr_status lr_turbulence_table_init(lr_turbulence_table* table, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_batch_set_turbulence_table': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_turbulence_table)],
        ('world', 'batch', 'table'),
        """lr_status lr_batch_set_turbulence_table(lr_world* world, lr_batch batch, const lr_turbulence_table* table)

        Replaces the turbulence table of a batch; null restores the asset's. With AERODYNAMIC loads the table replaces the
        intensity of lr_aerodynamics: it sets the velocity of the fluid around the body.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_get_turbulence_table': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_turbulence_table), ctypes.POINTER(ctypes.c_float), ctypes.POINTER(ctypes.c_float), ctypes.c_uint32],
        ('world', 'batch', 'table', 'chi', 'epsilon', 'capacity'),
        """lr_status lr_batch_get_turbulence_table(const lr_world* world, lr_batch batch, lr_turbulence_table* table, float* chi, float* epsilon, uint32_t capacity)

        Reads a batch's turbulence table: the one that was set, bit for bit, or the asset's, rounded to float.

        world: the world
        batch: handle of a batch of the world
        table: initialised, or with struct_size set; its own chi and epsilon receive null.
        chi: receive `table->count` values each, up to `capacity`; either may be null, and capacity is then not read for it.
        epsilon: receive `table->count` values each, up to `capacity`; either may be null, and capacity is then not read for it.
        capacity: number of elements that fit

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world, table), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_BUFFER_TOO_SMALL (table is set, chi and epsilon are not).
        """,
    ),
    'lr_body_loads_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_body_loads), ctypes.c_uint32],
        ('loads', 'struct_size'),
        """lr_status lr_body_loads_init(lr_body_loads* loads, uint32_t struct_size)

        struct_size: sizeof the struct in the caller's header
        """,
    ),
    'lr_body_get_loads': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint64, ctypes.POINTER(lr_body_loads)],
        ('world', 'body', 'loads'),
        """lr_status lr_body_get_loads(const lr_world* world, lr_body body, lr_body_loads* loads)

        Computes the loads on a body from its present state, wind and water; on a sleeping body as if its wake had ended. At the
        surface of water those of the fluid that its centre of mass is in; the fluid's own rotation is left out.

        world: the world
        body: id of a body
        loads: initialised, or with struct_size set. A microsecond; calls the wind and water callbacks.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE.
        """,
    ),
}


def bind(library):
    """Sets types and docstring of every function of a loaded library."""
    for name, (result, parameters, _, text) in PROTOTYPES.items():
        function = getattr(library, name)
        function.restype = result
        function.argtypes = parameters
        function.__doc__ = text
    return library
