# SPDX-License-Identifier: MIT
# Generated from include/langevin_rigid.h by bindings/generator/python.py: do not edit.

"""The C API as ctypes sees it: types, constants, and prototypes of every function. All names are those of C."""
# flake8: noqa
import ctypes

VERSION = (0, 1, 0)  # of the header that this was made from

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
LR_CHECK_THREADS = 1
LR_WIND_NONE = 0
LR_WIND_UNIFORM = 1
LR_WIND_SOURCE_GUSTS = 1
LR_WIND_SOURCE_RANKINE = 2
LR_WIND_SOURCE_LAMB_OSEEN = 3
LR_WIND_SOURCE_POINT_BLOWER = 4
LR_WIND_SOURCE_LINE_BLOWER = 5
LR_WIND_SOURCE_TURBULENCE = 6
LR_WIND_SOURCE_GRID = 7
LR_WIND_SOURCE_GROUND = 8
LR_WIND_OUTSIDE_ZERO = 0
LR_WIND_OUTSIDE_CLAMP = 1
LR_WIND_OUTSIDE_REPEAT = 2
LR_MAX_WIND_SOURCES = 64
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
LR_REST_AWAKE = 0
LR_REST_RESTING = 1
LR_REST_HELD = 2
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
LR_CONTACT_NEVER_REST = 1
LR_CONTACT_BEGIN = 1
LR_CONTACT_END = 2
LR_BODY_LANDED = 3
LR_BODY_WOKE = 4
LR_BODY_KILLED = 5
LR_BODY_FAULTED = 6
LR_EVENTS_BEGIN = 1
LR_EVENTS_END = 2
LR_EVENTS_LANDED = 4
LR_EVENTS_WOKE = 8
LR_EVENTS_KILLED = 16
LR_EVENTS_FAULTED = 32
LR_EVENTS_ALL = 63
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
LR_FAULT_AUTO = 0
LR_FAULT_FREEZE = 1
LR_FAULT_REMOVE = 2
LR_EMIT_POINT = 0
LR_EMIT_BOX = 1
LR_EMIT_SPHERE = 2
LR_EMIT_DISC = 3
LR_EMIT_BOX_SURFACE = 4
LR_EMIT_SPHERE_SURFACE = 5
LR_POSE_RANDOM = 0
LR_POSE_FIXED = 1


class lr_world(ctypes.Structure):
    """Seen through pointers only."""


class lr_asset(ctypes.Structure):
    """Seen through pointers only."""


lr_task_fn = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_uint32, ctypes.c_uint32)
lr_task_fn.__doc__ = """Tasks of an engine's job system, in place of the world's own threads: docs/reference/stepping.md. Both functions are given or neither.

`enqueue` has run(task, begin, end) called for ranges that together hold each of the indices 0 to count - 1 once, in
any order, on any threads, at any time from now on until `finish` returns: one call for all, one for each, or what a
parallel-for makes of it, also right away inside `enqueue`. It returns a token for `finish`, of any value.
`finish` returns when all of these calls have returned. It is called exactly once for each `enqueue`, by the same thread.
Its thread had best run what has not begun itself: the world's caller does its share first, so that late tasks find
nothing left to do, and return at once.

Indices stand for threads, not for pieces of work, which the tasks share out among themselves: how they are spread changes
speed, never results. Both are called within lr_world_step alone, by its thread, in the floating-point mode that it came
with; tasks set and restore their own. Neither may throw, longjmp, or call the library on the same world; nor may run()
be called after `finish`.
"""


lr_log_fn = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int32, ctypes.c_char_p)
lr_log_fn.__doc__ = """Receives a message, valid during the call only. Called from the thread that calls the library: with LR_CHECK_THREADS also
while another thread's call on the world goes on. Must not call the library on the same world. May be null.
"""


lr_fault_fn = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_uint32, ctypes.c_char_p, ctypes.c_char_p, ctypes.c_char_p)
lr_fault_fn.__doc__ = """One numbered fault of an asset file; see docs/reference/asset_format.md. Strings are valid during the call only."""


class lr_wind_query(ctypes.Structure):
    """What a wind callback is asked. Arrays have one value a body."""
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
lr_wind_fn.__doc__ = """Called once for each body and substep, in no certain order, from the thread that steps and from the world's workers, or the
job system's, at the same time (with worker_count 0 from the stepping thread alone). Results must depend on nothing but position, time
and batch for the world to be deterministic. Must not call the library on the same world, throw, or keep pointers. A
body whose values are not finite, or over 1000 m/s, gets 0 for all of them, and a warning is logged once after the
step.
"""


class lr_surface_query(ctypes.Structure):
    """What a surface callback is asked. Arrays have one value a body, and hold what plane and waves give at first."""
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


lr_surface_fn = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.POINTER(lr_surface_query))
lr_surface_fn.__doc__ = """Called for bodies near the surface: once, and twice more for each substep; on what terms: as lr_wind_fn.
A body whose values are not finite, too large (heights over `reach`, velocities over 1000 m/s, accelerations over
1e6 m/s^2), or whose normal is none gets those of the plane, and a warning is logged once
after the step.
"""


lr_record_fn = ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_uint64)
lr_record_fn.__doc__ = """Takes the next `size` bytes of a recording, valid during the call only: append them to a file, or to a ring in memory.
Returns 0; anything else ends the recording. Called within functions that take the world, by their thread; with
LR_RECORD_CALLBACKS also by those that run wind and surface callbacks, never by two at a time. Must not call the library on
the same world, throw or longjmp.
"""


class lr_allocator(ctypes.Structure):
    """Where a world takes its memory from. Both functions are given or neither; neither means the C library's.
    `allocate` returns `size` bytes aligned to `alignment` (a power of two, at most 128), or null.
    `release` gets the very size and alignment that were asked for. Called only from the thread that calls the library,
    during lr_world_step only where bodies meet each other (lr_batch_set_pair_contact) in greater number than ever before.
    Must not call the library on the same world.
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
    """A solid ellipsoid, with everything from closed forms: mass, Lamb's added mass, and the decay of k and epsilon in a
    uniform stream. The quickest way to a first falling body.
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


class lr_aerodynamics(ctypes.Structure):
    """Coefficients of the quasi-steady loads at scale 1; equations in docs/maintainers/physics.md, AERODYNAMIC. Everything acts at
    `center` along `axes`, which turn with the body. Arrays have a value for each axis. v: velocity through the fluid and w:
    spin, both along the axes; s = |v|; (i, j, k) cyclic; d: lr_asset_info.length_d; rho, nu: density and kinematic viscosity of
    the fluid.
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
    ]


class lr_rigid_desc(ctypes.Structure):
    """A body whose numbers are known, without mesh or file: from another solver, from measurements, or a section of a card in
    two dimensions. Matrices are row-major, symmetric, about the centre of mass, in body axes.
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


class lr_asset_info(ctypes.Structure):
    """What an asset is. Matrices are row-major and symmetric."""
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
    """lr_world_info: 64 bytes."""
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
    ]


class lr_wind_desc(ctypes.Structure):
    """lr_wind_desc: 24 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('kind', ctypes.c_int32),
        ('velocity', ctypes.c_float * 3),
        ('reserved', ctypes.c_uint32),
    ]


class lr_wind_source_desc(ctypes.Structure):
    """Fields that a kind does not have are not used, but must be in range. Lengths up to 1e6 m, speeds up to 1000 m/s."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('kind', ctypes.c_int32),
        ('position', ctypes.c_float * 3),
        ('direction', ctypes.c_float * 3),
        ('side', ctypes.c_float * 3),
        ('velocity', ctypes.c_float * 3),
        ('speed', ctypes.c_float),
        ('circulation', ctypes.c_float),
        ('size', ctypes.c_float),
        ('radius', ctypes.c_float),
        ('half_length', ctypes.c_float),
        ('range', ctypes.c_float),
        ('spread', ctypes.c_float),
        ('period', ctypes.c_float),
        ('reference_height', ctypes.c_float),
        ('octaves', ctypes.c_uint32),
        ('seed', ctypes.c_uint32),
        ('outside', ctypes.c_int32),
        ('counts', ctypes.c_uint32 * 3),
        ('frames', ctypes.c_uint32),
        ('spacing', ctypes.c_float * 3),
        ('reserved', ctypes.c_uint32),
        ('samples', ctypes.POINTER(ctypes.c_float)),
    ]


class lr_wave(ctypes.Structure):
    """A long-crested wave of deep water. Heights add; its frequency sqrt(2 pi g/length) is that of the world's gravity when
    the surface is set.
    """
    _fields_ = [
        ('direction', ctypes.c_float * 3),
        ('length', ctypes.c_float),
        ('amplitude', ctypes.c_float),
        ('phase', ctypes.c_float),
    ]


class lr_surface_desc(ctypes.Structure):
    """The lower fluid fills everything below a plane, or below the waves on it. Above is the fluid of the world or of each
    batch's asset. Bodies float, sink, and go through; surface tension is ignored.
    """
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
    """What the last step did, and what it left out. Batches without bodies do not count."""
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
    """lr_batch_desc: 40 bytes."""
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


class lr_load_gains(ctypes.Structure):
    """Art control of the AERODYNAMIC loads: factors on top of the coefficients, so that motion stays that of some body."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('drag', ctypes.c_float),
        ('lift', ctypes.c_float),
        ('spin_drag', ctypes.c_float),
        ('turbulence', ctypes.c_float),
    ]


class lr_batch_pace(ctypes.Structure):
    """How a batch keeps up with its world."""
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
    """The state of a batch where it lies: arrays with one value a body, `count` of them, 64-byte aligned. Bodies are dense:
    those that move come first, then those at rest, and where one leaves its part of them, the last of that part takes its
    place. Pointers are valid until the next call that is not a query.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('count', ctypes.c_uint32),
        ('position', ctypes.POINTER(ctypes.c_float) * 3),
        ('orientation', ctypes.POINTER(ctypes.c_float) * 4),
        ('velocity', ctypes.POINTER(ctypes.c_float) * 3),
        ('spin', ctypes.POINTER(ctypes.c_float) * 3),
        ('scale', ctypes.POINTER(ctypes.c_float)),
        ('age', ctypes.POINTER(ctypes.c_float)),
        ('key', ctypes.POINTER(ctypes.c_uint32)),
        ('ids', ctypes.POINTER(ctypes.c_uint64)),
        ('capacity', ctypes.c_uint32),
        ('reserved', ctypes.c_uint32),
        ('revision', ctypes.c_uint64),
        ('awake_count', ctypes.c_uint32),
        ('reserved_1', ctypes.c_uint32),
    ]


class lr_body_desc(ctypes.Structure):
    """lr_body_desc: 72 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('key', ctypes.c_uint32),
        ('position', ctypes.c_float * 3),
        ('orientation', ctypes.c_float * 4),
        ('linear_velocity', ctypes.c_float * 3),
        ('angular_velocity', ctypes.c_float * 3),
        ('scale', ctypes.c_float),
        ('age', ctypes.c_float),
        ('reserved', ctypes.c_uint32),
    ]


class lr_body_state(ctypes.Structure):
    """lr_body_state: 76 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('key', ctypes.c_uint32),
        ('position', ctypes.c_float * 3),
        ('orientation', ctypes.c_float * 4),
        ('linear_velocity', ctypes.c_float * 3),
        ('angular_velocity', ctypes.c_float * 3),
        ('scale', ctypes.c_float),
        ('age', ctypes.c_float),
        ('reserved', ctypes.c_uint32),
        ('resting', ctypes.c_int32),
    ]


class lr_body_force(ctypes.Structure):
    """A force and a torque on one body, at the body's true size: a body of scale 2 has eight times the mass."""
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
    """The same for many bodies of one batch, in the order of its view."""
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
    """What acts on every body of a batch. All initially 0, each component up to 1e9 in magnitude."""
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
    """Fields that a kind does not have are not used."""
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
    """How one collider moves. Within a step its position goes evenly from where it begins to where it ends, and its
    orientation by the normalised linear quaternion, the shorter way round: what turns by more than half a turn in a step
    seems to turn by less.
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


class lr_collider_surface(ctypes.Structure):
    """What can be changed of a collider besides its motion."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('layers', ctypes.c_uint32),
        ('friction', ctypes.c_float),
        ('restitution', ctypes.c_float),
    ]


class lr_batch_contact(ctypes.Structure):
    """How the bodies of a batch meet colliders. Of a pair, friction is the geometric mean of both and restitution the larger.
    Bodies touch with their hull, reduced to 32 points at most, or as the ellipsoid that they are.
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
    ]


class lr_contact_event(ctypes.Structure):
    """Never changes: 64 bytes, an element of arrays without gaps."""
    _fields_ = [
        ('kind', ctypes.c_int32),
        ('batch', ctypes.c_uint32),
        ('body', ctypes.c_uint64),
        ('collider', ctypes.c_uint64),
        ('position', ctypes.c_float * 3),
        ('normal', ctypes.c_float * 3),
        ('speed', ctypes.c_float),
        ('impulse', ctypes.c_float),
        ('reserved', ctypes.c_uint32 * 2),
    ]


class lr_contact_event_list(ctypes.Structure):
    """lr_contact_event_list: 32 bytes."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('count', ctypes.c_uint32),
        ('events', ctypes.POINTER(lr_contact_event)),
        ('lost', ctypes.c_uint64),
        ('total_lost', ctypes.c_uint64),
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
    """Never changes: 48 bytes, an element of arrays without gaps. All 0 where nothing is hit."""
    _fields_ = [
        ('body', ctypes.c_uint64),
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
    """When the bodies of a batch end. A body that has left physics ends under any rules, unless lr_batch_set_fault_policy says
    that it is held.
    """
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('action', ctypes.c_int32),
        ('max_age', ctypes.c_float),
        ('volume_count', ctypes.c_uint32),
        ('volumes', lr_kill_volume * 8),
    ]


class lr_emitter_desc(ctypes.Structure):
    """How bodies of a batch are born. What is drawn for a body depends on the world's seed, its key, and how often it has
    respawned, and on nothing else.
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


class lr_batch_events(ctypes.Structure):
    """What rules and emitter did in the last step, and since the batch began."""
    _fields_ = [
        ('struct_size', ctypes.c_uint32),
        ('born', ctypes.c_uint32),
        ('destroyed', ctypes.c_uint32),
        ('respawned', ctypes.c_uint32),
        ('missed', ctypes.c_uint32),
        ('by_not_finite', ctypes.c_uint32),
        ('by_age', ctypes.c_uint32),
        ('by_volume', ctypes.c_uint32 * 8),
        ('reserved', ctypes.c_uint32),
        ('total_born', ctypes.c_uint64),
        ('total_destroyed', ctypes.c_uint64),
        ('total_respawned', ctypes.c_uint64),
        ('total_missed', ctypes.c_uint64),
        ('ended_ids', ctypes.POINTER(ctypes.c_uint64)),
        ('born_ids', ctypes.POINTER(ctypes.c_uint64)),
        ('faulted', ctypes.c_uint32),
        ('reserved_1', ctypes.c_uint32),
        ('total_faulted', ctypes.c_uint64),
    ]


# What each field is, by struct.
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
        'fluid_density': 'kg/m^3, > 0; initially 1.2, air',
        'fluid_viscosity': 'm^2/s, kinematic, > 0; initially 1.5e-5, air',
        'intensity': 'turbulence intensity I of k0 = 3/2 (I U0)^2, 0 to 10; initially 1, as in the paper',
        'center_of_mass': 'm, from the centre of the ellipsoid, inside it; initially 0. A ballasted body: its centre of buoyancy stays at the centre, its moments of inertia those of the uniform solid',
    },
    'lr_aerodynamics': {
        'axes': 'rows: unit vectors in the body frame, right-handed',
        'drag': 'Drag -1/2 rho sum_i (v_i/s)^2 [drag_i + drag_blunt_i Re/(Re + 8710)] s v, Re = s d/nu, and along each axis -rho [drag_layer_i sqrt(nu s) + drag_stokes_i nu] v_i. All >= 0. m^2, drag coefficient times area',
        'drag_blunt': 'm^2, the part that grows with the Reynolds number: of rounded bodies',
        'drag_layer': 'm^(3/2), of the boundary layer',
        'drag_stokes': 'm, of creeping flow',
        'lift': 'Lift rho G x v, G_k = spin_lift_k w_k - lift_k v_i v_j/s. m^2, positive where the body is thinner along j than along i',
        'spin_lift': 'm^3',
        'lift_moment': 'm^3, moment rho lift_moment_k v_i v_j of that lift about k',
        'spin_drag': 'Couple -rho (spin_drag_k |w| + spin_drag_stream_k s + spin_drag_stokes_k nu) w_k. All >= 0. m^5',
        'spin_drag_stream': 'm^4',
        'spin_drag_stokes': 'm^3',
        'intensity': "of the velocity of the fluid in the body's own wake: per axis `intensity` times s. More than 0.4, gains included, acts as 0.4: such a wake would feed itself",
        'length': 'm, correlated over length/s',
        'wake_reynolds': 'that velocity is less by Re/(Re + wake_reynolds): slow wakes are laminar',
        'broadside': 'Stall: sigma = sum_i broadside_i (v_i/s)^2 multiplies lift by 1 - lift_stall sigma and adds lift_moment_stalled_k sigma to lift_moment_k. 0 to 1',
        'lift_stall': '',
        'lift_moment_stalled': 'm^3',
        'roll_damping': "Couple -rho g_k (g . w)/s, g_k = sqrt(roll_damping_k) v_k, on the part of the spin about the stream: a wing's roll. All >= 0. In a plane that spin is nought. m^4",
        'center': 'm, where all of it acts, from the centre of buoyancy, body frame; initially 0; within 2 d',
    },
    'lr_rigid_desc': {
        'mass': 'kg, > 0',
        'volume': 'm^3, > 0',
        'inertia': 'kg m^2, positive definite',
        'added_mass': 'order vx vy vz wx wy wz, fluid density included as in lr_asset_info: kg, kg m, kg m^2; positive semi-definite; initially 0',
        'center_of_buoyancy': 'm, from the centre of mass; initially 0',
        'fluid_density': 'kg/m^3, > 0; initially 1.2, air',
        'fluid_viscosity': 'm^2/s, kinematic, > 0; initially 1.5e-5, air',
        'extents': 'm, full size along the body axes, > 0',
        'intensity': 'of the turbulence table, as in lr_ellipsoid_desc; initially 1',
        'aerodynamics': 'copied; null, as initially: those of an ellipsoid with these extents',
    },
    'lr_asset_info': {
        'flags': '`AssetFlags`',
        'name': 'UTF-8, ends with 0',
        'mass': 'kg',
        'volume': 'm^3',
        'density': 'kg/m^3',
        'center_of_mass': 'm, in the frame of the mesh: where the body origin lies in it',
        'center_of_buoyancy': 'm, from the centre of mass, body axes',
        'inertia': 'kg m^2, about the centre of mass, body axes',
        'added_mass': 'about the centre of mass, order vx vy vz wx wy wz, fluid density included: kg for the 3x3 block of v, kg m for the coupling, kg m^2 for the block of w',
        'fluid_density': 'kg/m^3, of the fluid it was baked in',
        'fluid_viscosity': 'm^2/s, kinematic',
        'length_d': 'm, characteristic length: the largest extent',
        'length_b': 'm, thickness',
        'length_l': 'm, turbulence length; see docs/maintainers/physics.md',
        'u0': 'm/s, fall velocity scale sqrt(|density ratio - 1| g b), paper Eq. 1',
        'reynolds': 'u0 d / viscosity',
        'c0': 'Kolmogorov constant of the Langevin model, paper Eq. 10',
        'turbulence_dt': 's between table samples',
        'turbulence_count': 'number of table samples',
        'hull_vertex_count': '0 for an asset without a hull',
        'hull_triangle_count': '',
        'format_version': 'of the file; 0 for an asset without a file',
        'content_hash': 'of everything that matters for motion; equal for equal assets',
    },
    'lr_world_desc': {
        'worker_count': "threads besides the caller's, 0 to 64; initially 0: everything runs in the caller. With `jobs`: the most indices in one enqueue, as many as its threads but the caller's; 0: one less than this machine has threads, from 1 to 64, and a warning that it is a guess",
        'seed': 'of all noise; initially 0',
        'gravity': 'm/s^2; initially 0, -9.81, 0',
        'fluid_density': 'kg/m^3, >= 0; initially 0: each batch in the fluid its asset was baked in',
        'simd_target': '`SimdTarget`; initially `SimdTarget.AUTO`',
        'fluid_viscosity': "m^2/s, kinematic, >= 0; initially 0: as each batch's asset was baked",
        'allocator': "copied; initially null functions: the C library's",
        'log': 'initially null: silence',
        'log_user': '',
        'jobs': "copied; initially null functions: worker_count threads of the world's own",
        'checks': 'bits `WorldChecks`; initially 0',
    },
    'lr_world_info': {
        'simd_target': 'what `SimdTarget.AUTO` became',
        'worker_count': 'as in the desc; with jobs what 0 became',
        'batch_count': '',
        'body_count': '',
        'substep_count': 'substeps since creation; the time index of the noise',
        'time': 's since creation: the sum of all dt, in double',
        'memory_bytes': 'taken from the allocator at present',
        'collider_count': '',
        'awake_count': 'bodies that are not at rest: lr_body_set_rest',
    },
    'lr_wind_desc': {
        'kind': '`WindKind`; initially `WindKind.UNIFORM`',
        'velocity': 'm/s, each up to 1000 in magnitude; initially 0',
    },
    'lr_wind_source_desc': {
        'kind': '`WindSourceKind`; initially 0, which is none of them',
        'position': "m: a point of the vortex axis (its middle, if half_length > 0), the nozzle's middle, the grid's first sample, a point of the ground; initially 0",
        'direction': "any length but 0: the vortex axis (right-hand rule), where a blower blows, about where gusts blow, the ground's upward normal; initially 1, 0, 0",
        'side': 'along the slot of a line blower, not along its direction; initially 0, 0, 1',
        'velocity': 'm/s, of the source itself; initially 0',
        'speed': 'm/s: of a blower at its nozzle; root mean square of gusts in all, of turbulence for each component; >= 0; initially 1',
        'circulation': 'm^2/s, up to 1e6 in magnitude; initially 1',
        'size': 'm, >= 1e-4: core radius, radius of the nozzle or half width of the slot, integral length of turbulence, roughness length of the ground (0.0001 water, 0.03 grass, 1 town); initially 1',
        'radius': 'm: a vortex fades out from half of it on, to nothing at it; 0: no limit; initially 0',
        'half_length': 'm: of a vortex, which fades likewise, 0 for no limit; of a slot; initially 0',
        'range': 'm, >= size: a blower fades out from half of it on, to nothing at it; initially 10',
        'spread': '0 to 1: widening of a jet per length, 0.11 as measured; gusts: root mean square angle in radians from `direction`; initially 0.1',
        'period': 's: integral time of gusts, 0 for 4, as 2 m over the ground in 3 m/s (IEC 61400-1: 5.67 times the height over the speed); life of the largest eddies, 0 for size/speed; time from one frame to the next, 0 for 1; up to 1e6; initially 0',
        'reference_height': "m: where the ground's factor is 1; >= size; initially 10",
        'octaves': 'of turbulence, each half as large as the one before, 1 to 4; initially 2',
        'seed': "of gusts and turbulence, together with the world's; initially 0",
        'outside': '`WindOutside`; initially `WindOutside.ZERO`',
        'counts': 'samples of a grid along x, y, z, each >= 1',
        'frames': 'of a grid, shown one after the other and again from the first; >= 1; initially 1',
        'spacing': 'm between samples, >= 1e-4; initially 1',
        'samples': 'm/s, x y z of each sample; x varies fastest, then y, z, frame; copied',
    },
    'lr_wind_query': {
        'count': 'bodies, 1 to 256',
        'batch': 'whose bodies they are; 0 when asked by lr_world_sample_wind',
        'time': 's, of the middle of the substep',
        'position': 'm: where the bodies are expected to be at that time; finite',
        'velocity': "m/s, 0 at first: the velocity that is added to the other sources'",
        'rate': 'm/s^2, 0 at first: its partial derivative in time, if it is known',
        'gradient': "1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate and gradient the callback's part gives drag, but neither the force of the fluid's acceleration nor shear",
    },
    'lr_wave': {
        'direction': 'where it goes: any vector not along the normal; its part in the plane counts',
        'length': 'm, crest to crest, 1e-3 to 1e6',
        'amplitude': 'm, half of crest to trough, 0 to length/7: steeper ones break',
        'phase': "rad, up to 1e6 in magnitude: 0 has a crest at `position` at the world's time 0",
    },
    'lr_surface_desc': {
        'wave_count': 'used part of `waves`; initially 0',
        'position': 'm, a point of the plane, each up to 1e9 in magnitude; initially 0',
        'normal': 'upward, any length but 0; initially 0, 1, 0',
        'density': "kg/m^3, 1e-3 to 1e6; initially 998. A batch whose own fluid is denser keeps that one's",
        'viscosity': 'm^2/s, kinematic, 1e-12 to 1e3; initially 1e-6',
        'current': 'm/s, velocity of the lower fluid, each up to 1000 in magnitude; initially 0',
        'reach': "m, 0 to 1e6: a callback's surface lies at most so far from the plane; initially 0",
        'waves': '',
    },
    'lr_surface_query': {
        'count': 'bodies, 1 to 256',
        'batch': 'whose bodies they are',
        'time': 's',
        'position': 'm; finite',
        'height': "m above the plane of the surface there, along the plane's normal",
        'normal': "unit, of the surface, less than 80 degrees from the plane's",
        'velocity': 'm/s, of the lower fluid at the position',
        'rate': 'm/s^2, its acceleration. Where the surface is steep it is what lets bodies slide down',
    },
    'lr_step_report': {
        'batches_stepped': '',
        'batches_waiting': 'not due, by their own divisors',
        'batches_passed_over': 'due, but the budget did not reach them',
        'body_substeps': 'done',
        'body_substeps_wanted': 'of the batches that were due, without a budget',
        'behind': "s: how far the bodies that have waited longest are behind the world's time",
        'lost': 's: the most that a batch lost in this step: bodies go in slow motion rather than in too long substeps',
    },
    'lr_recording_desc': {
        'flags': 'bits `RecordingFlags`; initially `RecordingFlags.CALLBACKS`',
        'hash_interval': 'steps from one hash of the world in the recording to the next; 0: none; initially 1',
        'write': 'must be given',
        'user': '',
    },
    'lr_batch_desc': {
        'capacity': 'the most bodies at a time, 1 to 2^26; memory for all is taken at once',
        'asset': 'kept by reference until the batch ends',
        'load_model': '`Loads`; initially `Loads.DEFAULT`',
        'clock': '`Clock`; initially `Clock.SPEED`',
        'table_end': '`TableEnd`; initially `TableEnd.CLAMP`',
        'integrator': '`Integrator`; initially `Integrator.DEFAULT`',
        'damping_gain': 'multiplies the turbulent damping, 0 to 100; initially 1',
        'noise_gain': 'multiplies the turbulent noise, 0 to 100; initially 1; 0 for repeatable single falls',
    },
    'lr_turbulence_table': {
        'count': 'samples, 1 to 65536',
        'chi': '1/s, turbulent frequency epsilon / k, `count` values >= 0',
        'epsilon': 'm^2/s^3, dissipation rate, `count` values >= 0',
        'dt': 's between samples, > 0',
        'u0': 'm/s, speed the table was made at, > 0: what `Clock.SPEED` scales by',
        'l': 'm, length the table was made with, > 0',
        'c0': 'Kolmogorov constant, > 0; initially 6.5, its limit at high Reynolds number',
        'stationary': 'sample that `Clock.SPEED` uses, < count; initially 0',
    },
    'lr_load_gains': {
        'drag': 'of translation, 0 to 100; initially 1',
        'lift': 'and its moment, 0 to 100; initially 1',
        'spin_drag': '0 to 100; initially 1',
        'turbulence': "intensity of the body's own wake, 0 to 100; initially 1",
    },
    'lr_batch_pace': {
        'divisor': 'as set',
        'substeps': 'in the last step of the world; 0: it waited',
        'waited': 'steps since it was last stepped',
        'behind': 's: the same as time',
        'lost': "s, in all: what its bodies' clocks are slow by",
        'body_substeps': 'in all',
    },
    'lr_batch_view': {
        'count': 'bodies',
        'position': 'm, world frame: x, y, z',
        'orientation': 'unit quaternion x, y, z, w, body to world',
        'velocity': "m/s, of the centre of mass, in the BODY frame: turn by the orientation for the world's",
        'spin': 'rad/s, angular velocity, in the BODY frame',
        'scale': 'uniform scale',
        'age': 's; of a body at rest some earlier one: lr_body_get_state has it exactly',
        'key': 'what tells the noise of bodies apart',
        'ids': '',
        'capacity': '',
        'revision': 'differs whenever bodies at rest have woken, ended, or changed their places',
        'awake_count': 'bodies [0, awake_count) move, [awake_count, count) are at rest: lr_body_set_rest',
    },
    'lr_body_desc': {
        'key': 'tells its noise apart; initially 0: the world gives each body its own, in order of birth',
        'position': 'm, of the centre of mass; initially 0',
        'orientation': 'quaternion x y z w, normalised when taken; initially 0 0 0 1',
        'linear_velocity': 'm/s, of the centre of mass; initially 0',
        'angular_velocity': 'rad/s, world frame; initially 0',
        'scale': 'uniform, 0.001 to 1000; mass goes with its cube; initially 1',
        'age': 's, 0 to 1e9; initially 0. Bodies grow no older than that',
    },
    'lr_body_state': {
        'key': 'read only: ignored by lr_body_set_state',
        'position': 'm, of the centre of mass, world frame',
        'orientation': 'unit quaternion x y z w, body to world',
        'linear_velocity': 'm/s, of the centre of mass, world frame',
        'angular_velocity': 'rad/s, world frame',
        'scale': '0.001 to 1000',
        'age': 's, 0 to 1e9',
        'resting': '`Rest`; read only',
    },
    'lr_body_force': {
        'mode': '`ForceMode`; initially `ForceMode.FORCE`',
        'body': '',
        'frame': '`Frame`, of force, torque and point; initially `Frame.WORLD`',
        'flags': '`ForceFlags`; initially 0',
        'force': 'initially 0',
        'torque': 'about the centre of mass; initially 0',
        'point': 'm; in the world frame a position, in the body frame from the centre of mass. Its arm is taken at the time of the call',
    },
    'lr_force_arrays': {
        'mode': '`ForceMode`; initially `ForceMode.FORCE`',
        'frame': '`Frame`; initially `Frame.WORLD`',
        'first': 'index in the view of the first body; initially 0',
        'count': 'bodies',
        'stride': "bytes from one body's value to the next's, a multiple of 4; initially 0: no gaps, 4",
        'force': 'x, y, z: `count` values each, not kept; all three or none',
        'torque': 'alike; all three or none',
    },
    'lr_batch_force': {
        'force': 'N, world frame',
        'torque': 'N m, world frame',
        'acceleration': 'm/s^2, world frame; of the body, whatever its mass',
        'angular_acceleration': 'rad/s^2, world frame',
        'body_force': 'the same four in the body frame',
        'body_torque': '',
        'body_acceleration': '',
        'body_angular_acceleration': '',
    },
    'lr_collider_desc': {
        'kind': '`ColliderKind`; initially 0, which is none of them',
        'position': 'm, up to 1e9 in magnitude; initially 0',
        'orientation': 'quaternion x y z w, normalised when taken; initially 0 0 0 1',
        'linear_velocity': "m/s, of the frame's origin, up to 1e6; initially 0. It moves so until told otherwise",
        'angular_velocity': 'rad/s, world frame, up to 1e6; initially 0',
        'size': 'm, > 0, up to 1e6; initially 0',
        'friction': '0 to 10; initially 0.5',
        'restitution': '0 to 1; initially 0.2',
        'layers': 'bits: it meets bodies that have one of them; initially 1',
        'flags': '0',
        'vertex_count': 'hull: 4 to `MAX_HULL_VERTICES`; mesh: 3 to `MAX_COLLIDER_VERTICES`',
        'triangle_count': 'mesh: 1 to `MAX_COLLIDER_VERTICES`',
        'counts': 'heightfield: samples along x and z, each >= 2',
        'spacing': 'heightfield: m between samples, 1e-6 to 1e6; initially 1',
        'vertices': 'm, x y z each, up to 1e6 in magnitude; copied, as are the others',
        'indices': '3 a triangle, each < vertex_count',
        'heights': 'm, up to 1e6 in magnitude; x varies fastest',
    },
    'lr_collider_motion': {
        'mode': '`MoveMode`; initially `MoveMode.TO`',
        'collider': '',
        'position': 'm, as in lr_collider_desc; `MoveMode.TO`, `MoveMode.PLACE`; initially 0',
        'orientation': 'alike; initially 0 0 0 1',
        'linear_velocity': 'm/s; `MoveMode.PLACE`, `MoveMode.VELOCITY`; initially 0',
        'angular_velocity': 'rad/s; alike',
    },
    'lr_collider_state': {
        'kind': '`ColliderKind`',
        'position': 'm, world frame',
        'orientation': 'unit quaternion x y z w, collider to world',
        'linear_velocity': 'm/s, that it has until told otherwise; 0 while `MoveMode.TO` is pending',
        'angular_velocity': 'rad/s, world frame; alike',
        'friction': '',
        'restitution': '',
        'layers': '',
        'flags': '0',
    },
    'lr_collider_surface': {
        'layers': 'as in lr_collider_desc; initially 1',
        'friction': 'initially 0.5',
        'restitution': 'initially 0.2',
    },
    'lr_batch_contact': {
        'layers': 'bit mask: colliders that are in one of these are met; initially all; 0: none',
        'friction': 'coefficient of Coulomb friction, 0 to 10; initially 0.5',
        'restitution': 'speed after over speed before an impact, 0 to 1; initially 0.1',
        'rolling_resistance': "moment against rolling and spinning over normal force and a lever, 0 to 10; initially 0.05. The lever is the geometric mean of reach and half of the least width: a sphere's radius",
        'flags': '`EventKind`; initially 0',
        'ground_effect': 'the air that a sheet must press away before it lies, 0 to 1 of what the flow over planes and heightfields gives in theory; initially 0. docs/maintainers/contact.md',
    },
    'lr_contact_event': {
        'kind': '`EventKind`, `EventKind`',
        'batch': '',
        'body': 'stale where it has been destroyed',
        'collider': '`EventKind`; else 0',
        'position': 'm, world frame: of `EventKind.CONTACT_BEGIN` where they touch, else of the centre of mass; of one that has left physics where that was last sane',
        'normal': '`EventKind.CONTACT_BEGIN`: unit, world frame, from the collider to the body; else 0',
        'speed': 'm/s, `EventKind.CONTACT_BEGIN`: at which they approach each other along the normal, >= 0; else 0',
        'impulse': 'N s, `EventKind.CONTACT_BEGIN`: along the normal, of the substep in which they meet; else 0',
    },
    'lr_contact_event_list': {
        'count': '',
        'events': 'of the last step; null before lr_world_set_contact_events',
        'lost': 'events of the last step for which there was no room: the last ones in their order',
        'total_lost': 'since lr_world_set_contact_events',
    },
    'lr_ray': {
        'flags': '`RayFlags`, what it can hit; initially both',
        'origin': 'm, up to 1e9 in magnitude; initially 0',
        'direction': 'of any length from 1e-6 to 1e6; initially 0, -1, 0',
        'max_distance': 'm, 0 to 1e9; initially 1e9',
        'batch': 'whose bodies it can hit; initially 0: all',
        'collider_layers': 'bits: it meets colliders that have one of them; initially all',
    },
    'lr_ray_hit': {
        'body': '0 where it is a collider',
        'collider': '0 where it is a body',
        'distance': "m, from the ray's origin",
        'position': 'm, world frame',
        'normal': 'unit, world frame, out of what is hit; against the ray where that begins inside, at distance 0',
    },
    'lr_overlap_desc': {
        'shape': '`OverlapShape`; initially `OverlapShape.SPHERE`',
        'position': 'm, of its middle, up to 1e9 in magnitude; initially 0',
        'orientation': 'of a box, x y z w, normalised when taken; initially 0 0 0 1',
        'size': 'm, > 0, up to 1e6; initially 1',
        'batch': 'whose bodies are looked for; initially 0: all',
    },
    'lr_kill_volume': {
        'shape': '`VolumeShape`',
        'side': '`KillSide`: where bodies end',
        'center': 'm, up to 1e9 in magnitude',
        'size': 'm; of a plane its normal, of any length but 0',
    },
    'lr_batch_rules': {
        'action': '`EndAction`; initially `EndAction.DESTROY`',
        'max_age': 's, up to 1e9; initially 0: no limit',
        'volume_count': 'used part of `volumes`; initially 0',
        'volumes': 'by the centre of mass',
    },
    'lr_emitter_desc': {
        'shape': '`EmitShape`; initially `EmitShape.POINT`',
        'position': 'm, centre of the shape; initially 0',
        'orientation': 'of the shape, x y z w, normalised when taken; initially 0 0 0 1',
        'size': "m, half extents or semi-axes along the shape's own axes, 0 to 1e9; initially 0",
        'pose': '`Pose`, of the bodies; initially `Pose.RANDOM`',
        'body_orientation': 'body to world, normalised when taken; initially 0 0 0 1',
        'direction': 'of the velocity, world frame, of any length but 0; initially 0, -1, 0',
        'spread': 'rad, half angle of a cone about `direction`, filled evenly, 0 to pi; initially 0',
        'speed_min': 'm/s, evenly between; initially 0',
        'speed_max': 'm/s, evenly between; initially 0',
        'spin_min': 'rad/s, evenly between, about any axis alike; initially 0',
        'spin_max': 'rad/s, evenly between, about any axis alike; initially 0',
        'scale_min': 'evenly between; initially 1',
        'scale_max': 'evenly between; initially 1',
        'rate': 'births per second, 0 to 1e9; initially 0: bodies respawn, but none are added',
        'burst_interval': 's between bursts, >= 1e-4',
        'burst_count': 'births at once in each burst; initially 0: no bursts',
    },
    'lr_batch_events': {
        'born': 'by rate and bursts',
        'destroyed': 'by the rules',
        'respawned': '',
        'missed': 'births for which there was no room',
        'by_not_finite': 'Why bodies ended: the first cause that held, in this order. bodies that have left physics: lr_batch_set_fault_policy',
        'by_age': '',
        'by_volume': '',
        'total_born': 'with those of lr_batch_emit',
        'total_destroyed': '',
        'total_respawned': '',
        'total_missed': '',
        'ended_ids': 'destroyed or respawned in the last step: destroyed + respawned of them, in no order',
        'born_ids': '`born` of them',
        'faulted': 'bodies that have left physics in the last step, held or ended',
        'total_faulted': 'since the batch began',
    },
}

# The `_init` function of each struct that has one.
INITS = {
    'lr_ellipsoid_desc': 'lr_ellipsoid_desc_init',
    'lr_aerodynamics': 'lr_aerodynamics_init',
    'lr_rigid_desc': 'lr_rigid_desc_init',
    'lr_asset_info': 'lr_asset_info_init',
    'lr_world_desc': 'lr_world_desc_init',
    'lr_world_info': 'lr_world_info_init',
    'lr_wind_desc': 'lr_wind_desc_init',
    'lr_wind_source_desc': 'lr_wind_source_desc_init',
    'lr_surface_desc': 'lr_surface_desc_init',
    'lr_step_report': 'lr_step_report_init',
    'lr_recording_desc': 'lr_recording_desc_init',
    'lr_batch_desc': 'lr_batch_desc_init',
    'lr_turbulence_table': 'lr_turbulence_table_init',
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
    'lr_collider_surface': 'lr_collider_surface_init',
    'lr_batch_contact': 'lr_batch_contact_init',
    'lr_contact_event_list': 'lr_contact_event_list_init',
    'lr_ray': 'lr_ray_init',
    'lr_overlap_desc': 'lr_overlap_desc_init',
    'lr_batch_rules': 'lr_batch_rules_init',
    'lr_emitter_desc': 'lr_emitter_desc_init',
    'lr_batch_events': 'lr_batch_events_init',
}

# name: (result, parameters, their names, text)
PROTOTYPES = {
    'lr_version': (
        ctypes.c_uint32,
        [],
        (),
        """uint32_t lr_version()

        Version of the library that is loaded: major << 22 | minor << 12 | patch. Compare it with the macros above when the
        library is loaded at run time: a different major, or before 1.0 a different minor, is another ABI.
        Any thread.
        """,
    ),
    'lr_status_string': (
        ctypes.c_char_p,
        [ctypes.c_int32],
        ('status',),
        """const char* lr_status_string(lr_status status)

        A short English phrase for a status, no full stop; never null; static storage. Unknown values give "unknown status".
        Any thread.
        """,
    ),
    'lr_simd_targets': (
        ctypes.c_int32,
        [ctypes.POINTER(ctypes.c_int32), ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint32)],
        ('targets', 'capacity', 'count'),
        """lr_status lr_simd_targets(int32_t* targets, uint32_t capacity, uint32_t* count)

        Writes the instruction sets that this build has and this processor can run, best first.

        targets: `capacity` values, may be null when capacity is 0.
        capacity: elements that there is room for
        count: how many there are, even if more than capacity.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL (count is set).
        Any thread.
        """,
    ),
    'lr_simd_target_name': (
        ctypes.c_char_p,
        [ctypes.c_int32],
        ('target',),
        """const char* lr_simd_target_name(int32_t target)

        A name for people: "AVX-512", "AVX2", "SSE4", "NEON", "WebAssembly", "plain", "auto" or "unknown"; never null; static
        storage.
        Any thread.
        """,
    ),
    'lr_asset_load_file': (
        ctypes.c_int32,
        [ctypes.c_char_p, ctypes.POINTER(ctypes.POINTER(lr_asset))],
        ('path_utf8', 'out'),
        """lr_status lr_asset_load_file(const char* path_utf8, lr_asset** out)

        Reads an asset made by `lr_bake`, a regular file. It is verified whole before anything of it is used.

        path_utf8: UTF-8 on every platform.
        out: receives an asset with one reference, release it with lr_asset_release; null after an error.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_FILE_NOT_FOUND, LR_ERROR_FILE_READ, LR_ERROR_ASSET_FORMAT, LR_ERROR_ASSET_VERSION, LR_ERROR_ASSET_CORRUPT, LR_ERROR_ASSET_INVALID, LR_ERROR_OUT_OF_MEMORY.
        Any thread.
        """,
    ),
    'lr_asset_load_memory': (
        ctypes.c_int32,
        [ctypes.c_void_p, ctypes.c_uint64, ctypes.POINTER(ctypes.POINTER(lr_asset))],
        ('bytes', 'size', 'out'),
        """lr_status lr_asset_load_memory(const void* bytes, uint64_t size, lr_asset** out)

        The same from `size` bytes in memory, of any alignment, not kept.

        size: bytes

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_ASSET_*, LR_ERROR_OUT_OF_MEMORY.
        Any thread.
        """,
    ),
    'lr_asset_check_memory': (
        ctypes.c_int32,
        [ctypes.c_void_p, ctypes.c_uint64, lr_fault_fn, ctypes.c_void_p],
        ('bytes', 'size', 'report', 'user'),
        """lr_status lr_asset_check_memory(const void* bytes, uint64_t size, lr_fault_fn report, void* user)

        Says everything that is wrong with asset bytes, by one call of `report` for each fault (may be null).
        Returns what lr_asset_load_memory would.

        size: bytes
        user: as given along with the function
        Any thread.
        """,
    ),
    'lr_ellipsoid_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_ellipsoid_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_ellipsoid_desc_init(lr_ellipsoid_desc* desc, uint32_t struct_size)

        Fills a desc with its initial values.

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof(lr_ellipsoid_desc) as the caller sees it.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE. The other _init functions are alike.
        Any thread.
        """,
    ),
    'lr_asset_create_ellipsoid': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_ellipsoid_desc), ctypes.POINTER(ctypes.POINTER(lr_asset))],
        ('desc', 'out'),
        """lr_status lr_asset_create_ellipsoid(const lr_ellipsoid_desc* desc, lr_asset** out)

        desc: initialised by its `_init` function, or with struct_size set
        out: as for lr_asset_load_file.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY. Source: Lamb, Hydrodynamics, art. 114-115; docs/maintainers/physics.md.
        Any thread.
        """,
    ),
    'lr_asset_retain': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_asset)],
        ('asset',),
        """lr_status lr_asset_retain(lr_asset* asset)

        Adds a reference, to be given back by lr_asset_release.

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

        Gives a reference back; the last one frees the asset. Batches hold their own. Null is fine.

        asset: the asset
        Any thread.
        """,
    ),
    'lr_aerodynamics_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_aerodynamics), ctypes.c_uint32],
        ('aerodynamics', 'struct_size'),
        """lr_status lr_aerodynamics_init(lr_aerodynamics* aerodynamics, uint32_t struct_size)

        Initially the axes are those of the body, `length` is 1 and all else 0: no loads.

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_rigid_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_rigid_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_rigid_desc_init(lr_rigid_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_asset_create_rigid': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_rigid_desc), ctypes.POINTER(ctypes.POINTER(lr_asset))],
        ('desc', 'out'),
        """lr_status lr_asset_create_rigid(const lr_rigid_desc* desc, lr_asset** out)

        desc: initialised by its `_init` function, or with struct_size set
        out: as for lr_asset_load_file.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also matrices that no body has), LR_ERROR_OUT_OF_MEMORY.
        Any thread.
        """,
    ),
    'lr_asset_info_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_asset_info), ctypes.c_uint32],
        ('info', 'struct_size'),
        """lr_status lr_asset_info_init(lr_asset_info* info, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_asset_get_info': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_asset), ctypes.POINTER(lr_asset_info)],
        ('asset', 'info'),
        """lr_status lr_asset_get_info(const lr_asset* asset, lr_asset_info* info)

        asset: the asset
        info: initialised by lr_asset_info_init, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
        Any thread.
        """,
    ),
    'lr_asset_get_aerodynamics': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_asset), ctypes.POINTER(lr_aerodynamics)],
        ('asset', 'aerodynamics'),
        """lr_status lr_asset_get_aerodynamics(const lr_asset* asset, lr_aerodynamics* aerodynamics)

        The coefficients of an asset, as baked.

        asset: the asset
        aerodynamics: initialised by lr_aerodynamics_init, or with struct_size set.

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
        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_world_create': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world_desc), ctypes.POINTER(ctypes.POINTER(lr_world))],
        ('desc', 'out'),
        """lr_status lr_world_create(const lr_world_desc* desc, lr_world** out)

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

        Frees a world with all its batches and bodies, and ends its worker threads. A recording ends. Null is fine.

        world: the world
        """,
    ),
    'lr_world_info_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world_info), ctypes.c_uint32],
        ('info', 'struct_size'),
        """lr_status lr_world_info_init(lr_world_info* info, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_world_get_info': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_world_info)],
        ('world', 'info'),
        """lr_status lr_world_get_info(const lr_world* world, lr_world_info* info)

        world: the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_world_set_gravity': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_float)],
        ('world', 'gravity'),
        """lr_status lr_world_set_gravity(lr_world* world, const float* gravity)

        Takes effect with the next step. Another one than before wakes all bodies (lr_body_set_rest).

        world: the world
        gravity: m/s^2, 3 values, each up to 1e4 in magnitude.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_world_set_simd_target': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_int32],
        ('world', 'target'),
        """lr_status lr_world_set_simd_target(lr_world* world, int32_t target)

        Changes the instruction set from the next step on; results do not change.

        world: the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_UNSUPPORTED.
        """,
    ),
    'lr_wind_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_wind_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_wind_desc_init(lr_wind_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_world_set_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_wind_desc)],
        ('world', 'desc'),
        """lr_status lr_world_set_wind(lr_world* world, const lr_wind_desc* desc)

        The uniform part of the fluid's velocity; copied. Bodies feel the fluid's velocity relative to theirs. A change is
        spread evenly over the next step, and bodies feel the fluid's acceleration in it (Froude-Krylov force and added mass):
        one that has the fluid's density is carried along, a heavy one keeps most of its velocity. What is set before the
        world's first step is there from the beginning and accelerates nothing; setting the same wind again changes nothing.
        Null is still fluid. docs/reference/wind_and_water.md.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_wind_source_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_wind_source_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_wind_source_desc_init(lr_wind_source_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_world_add_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_wind_source_desc), ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'desc', 'out'),
        """lr_status lr_world_add_wind(lr_world* world, const lr_wind_source_desc* desc, lr_wind_source* out)

        Adds a source. Bodies keep their velocities: a field that appears is not one that accelerates.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set
        out: receives the handle, 0 after an error; may be null.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->samples of a grid), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_world_update_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_wind_source_desc)],
        ('world', 'source', 'desc'),
        """lr_status lr_world_update_wind(lr_world* world, lr_wind_source source, const lr_wind_source_desc* desc)

        Replaces everything of a source, also its kind. A grid may be given without samples: it then keeps those it has, if
        counts and frames are as before.

        world: the world
        source: handle of a wind source of the world
        desc: initialised by its `_init` function, or with struct_size set

        Returns LR_OK, LR_ERROR_STALE_WIND_SOURCE, and what lr_world_add_wind returns.
        """,
    ),
    'lr_world_remove_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32],
        ('world', 'source'),
        """lr_status lr_world_remove_wind(lr_world* world, lr_wind_source source)

        world: the world
        source: handle of a wind source of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_WIND_SOURCE.
        """,
    ),
    'lr_world_set_wind_callback': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), lr_wind_fn, ctypes.c_void_p],
        ('world', 'callback', 'user'),
        """lr_status lr_world_set_wind_callback(lr_world* world, lr_wind_fn callback, void* user)

        An engine's own field, added to all else. Null removes it. Not part of snapshots.

        world: the world
        user: as given along with the function

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world).
        """,
    ),
    'lr_world_sample_wind': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_float), ctypes.c_uint32, ctypes.POINTER(ctypes.c_float)],
        ('world', 'positions', 'count', 'velocities'),
        """lr_status lr_world_sample_wind(const lr_world* world, const float* positions, uint32_t count, float* velocities)

        The velocity of the fluid at the world's present time, of all sources: for particles, cloth, arrows on a screen.

        world: the world
        positions: 3 * count values, m, x y z x y z ..., each up to 1e9 in magnitude.
        count: elements of the arrays
        velocities: receives 3 * count, m/s. Both may be null when count is 0; they may be the same array.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_surface_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_surface_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_surface_desc_init(lr_surface_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_world_set_surface': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_surface_desc)],
        ('world', 'desc'),
        """lr_status lr_world_set_surface(lr_world* world, const lr_surface_desc* desc)

        From the next step on; copied. Null removes it. Bodies keep their velocities, also those that are now in another
        fluid. A batch whose mass matrix is singular in it stays in its own, with a warning. Part of snapshots and hash.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_world_set_surface_callback': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), lr_surface_fn, ctypes.c_void_p],
        ('world', 'callback', 'user'),
        """lr_status lr_world_set_surface_callback(lr_world* world, lr_surface_fn callback, void* user)

        An engine's own water, while there is a surface. Null removes it. Not part of snapshots.

        world: the world
        user: as given along with the function

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world).
        """,
    ),
    'lr_world_step': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_float, ctypes.c_uint32],
        ('world', 'dt', 'substeps'),
        """lr_status lr_world_step(lr_world* world, float dt, uint32_t substeps)

        Advances all bodies by dt in `substeps` equal parts.

        world: the world
        dt: s, > 0.
        substeps: 1 to LR_MAX_SUBSTEPS; at 60 Hz, 2 suit leaves and paper of some centimetres, 4 petals and confetti (docs/maintainers/numerics.md). At its end bodies end and are born as the batches' rules and emitters say. Allocates nothing but what lr_allocator says. The floating-point mode of the calling thread is saved, set and restored.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_TIMESTEP_*, LR_ERROR_SUBSTEPS, LR_ERROR_OUT_OF_MEMORY: the step has been taken, not to be repeated, but bodies went through each other in it; the next one asks for the memory again.
        """,
    ),
    'lr_world_set_budget': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint64],
        ('world', 'body_substeps'),
        """lr_status lr_world_set_budget(lr_world* world, uint64_t body_substeps)

        A budget for the work of each step: a count of substeps of single bodies, whatever each of them costs, at most 2^48; 0, as at
        first: none. From the next step on; part of snapshots. Where the batches that are due want more, each gets the fewest substeps that
        keep falls as they are (lr_batch_set_rate), those that have waited longest first; nobody waits for ever. The same calls give the
        same bits on every machine. A batch on whose single bodies forces act is stepped at once, even over the budget. docs/reference/stepping.md.

        world: the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_step_report_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_step_report), ctypes.c_uint32],
        ('report', 'struct_size'),
        """lr_status lr_step_report_init(lr_step_report* report, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_world_get_step_report': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_step_report)],
        ('world', 'report'),
        """lr_status lr_world_get_step_report(const lr_world* world, lr_step_report* report)

        world: the world
        report: initialised, or with struct_size set. Zeros before the first step, and after a snapshot was restored.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_world_hash': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_uint64)],
        ('world', 'out'),
        """lr_status lr_world_hash(const lr_world* world, uint64_t* out)

        A hash of the state of all bodies and the time index. Independent of the order of bodies in memory, of the processor
        and of worker_count; equal hashes mean equal motion from here on, given equal worlds. Wind sources are part of it,
        grids by the hash of their samples, the surface, and colliders.

        world: the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT.
        """,
    ),
    'lr_world_snapshot_size': (
        ctypes.c_uint64,
        [ctypes.POINTER(lr_world)],
        ('world',),
        """uint64_t lr_world_snapshot_size(const lr_world* world)

        Bytes that lr_world_snapshot_save needs at present; 0 for null.

        world: the world
        """,
    ),
    'lr_world_snapshot_save': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_void_p, ctypes.c_uint64, ctypes.POINTER(ctypes.c_uint64)],
        ('world', 'memory', 'size', 'written'),
        """lr_status lr_world_snapshot_save(const lr_world* world, void* memory, uint64_t size, uint64_t* written)

        Writes the world's state (bodies with their ids, time, wind, surface, gravity, tables, loads, forces, rules, emitter,
        rates, budget, colliders with their ids, how batches meet them and each other) into `size` bytes at `memory`, any alignment.
        Assets, how batches were created, threads and callbacks are not part of it, nor the samples of wind grids and the data of
        hulls, heightfields and meshes, which are named by their hash.

        world: the world
        memory: the bytes
        size: bytes
        written: bytes used; may be null.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_BUFFER_TOO_SMALL.
        """,
    ),
    'lr_world_snapshot_restore': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_void_p, ctypes.c_uint64],
        ('world', 'memory', 'size'),
        """lr_status lr_world_snapshot_restore(lr_world* world, const void* memory, uint64_t size)

        Puts a saved state back, also into another world or process whose batches were created in the same order from equal
        assets with equal capacities. Bodies, wind sources and colliders have the same ids as when it was saved; grids of
        wind, hulls, heightfields and meshes must be in the world already, in any place. Checked whole before anything changes.
        Allocates nothing where the world has held as much before. docs/reference/snapshots.md: which versions restore which snapshots.

        world: the world
        memory: the bytes
        size: bytes

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_SNAPSHOT_FORMAT, LR_ERROR_SNAPSHOT_MISMATCH, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_recording_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_recording_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_recording_desc_init(lr_recording_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_world_record_start': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_recording_desc)],
        ('world', 'desc'),
        """lr_status lr_world_record_start(lr_world* world, const lr_recording_desc* desc)

        From now on every call that can change the world is handed to desc->write with its arguments before it is carried out, and
        its status after it. At once: the world as it is, with the assets of its batches. May begin at any time. Takes 64 KiB of memory,
        some bytes for each asset, and while it begins a copy of the assets and a snapshot. When `write` refuses, the recording
        ends, a message is logged, and the world goes on.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->write), LR_ERROR_STRUCT_SIZE, LR_ERROR_INVALID_ARGUMENT (unknown flags; the world is being recorded; `write` has refused), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_world_record_stop': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world)],
        ('world',),
        """lr_status lr_world_record_stop(lr_world* world)

        Ends a recording.

        world: the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (none is under way: also where `write` has refused).
        """,
    ),
    'lr_batch_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_batch_desc_init(lr_batch_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_batch_create': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_batch_desc), ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'desc', 'out'),
        """lr_status lr_batch_create(lr_world* world, const lr_batch_desc* desc, lr_batch* out)

        world: the world
        desc: initialised by its `_init` function, or with struct_size set
        out: receives the batch, 0 after an error.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (also desc->asset), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_destroy': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32],
        ('world', 'batch'),
        """lr_status lr_batch_destroy(lr_world* world, lr_batch batch)

        Ends a batch with all its bodies. Those of batches that it met (lr_batch_set_pair_contact) wake.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH.
        """,
    ),
    'lr_turbulence_table_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_turbulence_table), ctypes.c_uint32],
        ('table', 'struct_size'),
        """lr_status lr_turbulence_table_init(lr_turbulence_table* table, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_batch_set_turbulence_table': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_turbulence_table)],
        ('world', 'batch', 'table'),
        """lr_status lr_batch_set_turbulence_table(lr_world* world, lr_batch batch, const lr_turbulence_table* table)

        Replaces a batch's table; null puts the asset's own back. With AERODYNAMIC loads the table sets the velocity of the fluid
        around the body, instead of the intensity in lr_aerodynamics.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_set_aerodynamics': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_aerodynamics)],
        ('world', 'batch', 'aerodynamics'),
        """lr_status lr_batch_set_aerodynamics(lr_world* world, lr_batch batch, const lr_aerodynamics* aerodynamics)

        Coefficients of the AERODYNAMIC loads for a batch, in place of its asset's, from the next step on; copied. Null puts the
        asset's own back. With intensity 0 and lr_load_gains.turbulence 1 a fall is the same for any seed. With other axes than the
        body's, or another center than 0, a body of LR_ASSET_DIAGONAL takes the slower path of all others.

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

        What the batch's coefficients are at present.

        world: the world
        batch: handle of a batch of the world
        aerodynamics: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_load_gains_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_load_gains), ctypes.c_uint32],
        ('gains', 'struct_size'),
        """lr_status lr_load_gains_init(lr_load_gains* gains, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_batch_set_load_gains': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_load_gains)],
        ('world', 'batch', 'gains'),
        """lr_status lr_batch_set_load_gains(lr_world* world, lr_batch batch, const lr_load_gains* gains)

        From the next step on; null puts all at 1. LANGEVIN loads have their gains in lr_batch_desc.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_batch_set_rate': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_uint32],
        ('world', 'batch', 'divisor'),
        """lr_status lr_batch_set_rate(lr_world* world, lr_batch batch, uint32_t divisor)

        How often a batch is stepped: level of detail for bodies that are far away, small, or out of sight. docs/reference/stepping.md.

        world: the world
        batch: handle of a batch of the world
        divisor: 1 to 1024, at first 1. A batch of divisor n takes one substep where others take n: fewer in each step, or, where n is more than the world's substeps, one in every so many steps, which makes up for all of them. No substep gets longer by that than falls keep their statistics: 1/60 s, for bodies under 2.5 cm length_d / 1.5 m/s. A divisor beyond has no more effect. From the next step on, at any time: a batch that waits makes up for all of it when next stepped. While it waits - views and lr_body_get_state have the bodies as they were last stepped, lr_batch_pace.behind ago, and bodies that are made or set are taken to be from then; transforms are moved on by that time with the bodies' velocities; - a force on one of its bodies ends the waiting, and acts with the impulse that it would have had in one step; - its rules, emitter and events wait too. Part of snapshots.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_batch_pace_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_pace), ctypes.c_uint32],
        ('pace', 'struct_size'),
        """lr_status lr_batch_pace_init(lr_batch_pace* pace, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_batch_get_pace': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_pace)],
        ('world', 'batch', 'pace'),
        """lr_status lr_batch_get_pace(const lr_world* world, lr_batch batch, lr_batch_pace* pace)

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

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_batch_get_view': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_view)],
        ('world', 'batch', 'view'),
        """lr_status lr_batch_get_view(const lr_world* world, lr_batch batch, lr_batch_view* view)

        world: the world
        batch: handle of a batch of the world
        view: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_batch_write_transforms': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_int32, ctypes.c_void_p, ctypes.c_uint64, ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'batch', 'format', 'dst', 'stride', 'count', 'written'),
        """lr_status lr_batch_write_transforms(const lr_world* world, lr_batch batch, int32_t format, void* dst, uint64_t stride, uint32_t count, uint32_t* written)

        Writes the transforms of the first `count` bodies of a batch, or of all where there are fewer, in the order of its view; of one that
        waits (lr_batch_set_rate), moved on to the world's time. The mesh to be drawn must have its origin at the centre of mass
        (lr_asset_info.center_of_mass).
        An instance buffer keeps what was written before: where lr_batch_view.revision is that of the last time, bodies at rest then still
        lie there, and it is enough to write as many as moved then or move now, the greater awake_count of the two. Else all: docs/reference/bodies.md.
        Keep both numbers for each buffer that is written in turn.

        world: the world
        batch: handle of a batch of the world
        format: one of the constants above
        dst: 4-byte aligned, room for `count` elements `stride` bytes apart.
        stride: 0 for elements without gaps, else a multiple of 4, at least an element.
        count: elements of the arrays
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
        struct_size: sizeof the struct as the caller sees it
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
        count: elements of the arrays
        out_ids: receives `count` ids; may be null.

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_CAPACITY.
        """,
    ),
    'lr_body_destroy': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_uint64), ctypes.c_uint32],
        ('world', 'bodies', 'count'),
        """lr_status lr_body_destroy(lr_world* world, const lr_body* bodies, uint32_t count)

        Destroys `count` bodies of any batches, all or none: if one of them is stale, or given twice, nothing is destroyed. What lay on
        them wakes.

        world: the world
        bodies: `count` ids of bodies
        count: elements of the arrays

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY.
        """,
    ),
    'lr_body_state_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_body_state), ctypes.c_uint32],
        ('state', 'struct_size'),
        """lr_status lr_body_state_init(lr_body_state* state, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_body_get_state': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint64, ctypes.POINTER(lr_body_state)],
        ('world', 'body', 'state'),
        """lr_status lr_body_get_state(const lr_world* world, lr_body body, lr_body_state* state)

        world: the world
        body: a body's id

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_body_set_state': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint64, ctypes.POINTER(lr_body_state)],
        ('world', 'body', 'state'),
        """lr_status lr_body_set_state(lr_world* world, lr_body body, const lr_body_state* state)

        Sets everything but the key, and wakes the body. The quaternion is normalised. Positions up to 1e9 m, velocities up to
        1e6 m/s and rad/s are taken, here and by lr_body_create. For many bodies a frame, prefer forces and wind: this breaks
        the physics by design.

        world: the world
        body: a body's id

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_body_set_rest': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_uint64), ctypes.c_uint32, ctypes.c_int32],
        ('world', 'bodies', 'count', 'rest'),
        """lr_status lr_body_set_rest(lr_world* world, const lr_body* bodies, uint32_t count, int32_t rest)

        Puts bodies of any batches to rest, or wakes them, all or none; some may be so already, or be given twice. A body at
        rest does not move, whatever acts on it, and costs a step nothing. Its velocities and the forces on it end. It wakes
         - by this function, lr_world_wake_box, and lr_body_set_state,
         - by a force, impulse or velocity on it that is not zero (lr_body_add_force, lr_batch_add_forces),
         - by a change of lr_batch_set_force, lr_world_set_gravity or lr_batch_set_pair_contact, with all others that it is about,
         - when it begins anew by its batch's rules,
         - by contact: colliders, wind. docs/reference/bodies.md.
        It grows older, and the rules of its batch are for it too: they look at bodies at rest in every 16th step of the batch.
        Bodies that wake and come to rest change indices in the view, not ids. Part of snapshots. The first body at rest of a
        batch takes up to 25 bytes for each of the batch's capacity.

        world: the world
        bodies: `count` ids of bodies
        count: elements of the arrays
        rest: LR_REST_*.

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_world_wake_box': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_float), ctypes.POINTER(ctypes.c_float), ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'low', 'high', 'woken'),
        """lr_status lr_world_wake_box(lr_world* world, const float* low, const float* high, uint32_t* woken)

        Wakes all bodies at rest that reach into a box, each taken to be a cube that it can turn in: for what the world does not
        know of, as footsteps and explosions.

        world: the world
        low: x, y, z of its corners, m, low <= high.
        high: x, y, z of its corners, m, low <= high.
        woken: how many; may be null. It takes time by what lies there, not by what rests elsewhere.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_body_force_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_body_force), ctypes.c_uint32],
        ('force', 'struct_size'),
        """lr_status lr_body_force_init(lr_body_force* force, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_body_add_force': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_body_force), ctypes.c_uint32],
        ('world', 'forces', 'count'),
        """lr_status lr_body_add_force(lr_world* world, const lr_body_force* forces, uint32_t count)

        Puts `count` forces on bodies of any batches, all or none; a body may be there more than once. One of them may
        give its body up to 1e9 m/s^2, torques as much over its length; an impulse up to 1e6 m/s and rad/s. Pending forces
        are part of snapshots and of the world's hash. The first force or acceleration on a body of a batch takes 96 bytes
        for each of the batch's capacity.

        world: the world
        count: elements of the arrays

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BODY, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_force_arrays_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_force_arrays), ctypes.c_uint32],
        ('arrays', 'struct_size'),
        """lr_status lr_force_arrays_init(lr_force_arrays* arrays, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_batch_add_forces': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_force_arrays)],
        ('world', 'batch', 'arrays'),
        """lr_status lr_batch_add_forces(lr_world* world, lr_batch batch, const lr_force_arrays* arrays)

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (some of three pointers), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also first + count over the batch's bodies), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_force_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_force), ctypes.c_uint32],
        ('force', 'struct_size'),
        """lr_status lr_batch_force_init(lr_batch_force* force, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_batch_set_force': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_force)],
        ('world', 'batch', 'force'),
        """lr_status lr_batch_set_force(lr_world* world, lr_batch batch, const lr_batch_force* force)

        From the next step on, until changed; copied. Null ends it. A change wakes the batch's bodies. Part of snapshots.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_collider_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_collider_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_collider_desc_init(lr_collider_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_collider_create': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_collider_desc), ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint64)],
        ('world', 'descs', 'count', 'out_ids'),
        """lr_status lr_collider_create(lr_world* world, const lr_collider_desc* descs, uint32_t count, lr_collider* out_ids)

        Creates `count` colliders, all or none. They are there from the next step on. Hulls, heightfields and meshes that are equal
        share one copy of their data.

        world: the world
        descs: `count` elements.
        count: elements of the arrays
        out_ids: receives `count` ids; may be null.

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT (also arrays that the kind needs), LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also a hull that is flat: thinner than 1e-4 of its largest extent; a mesh with an index out of range, or no triangle with an area), LR_ERROR_CAPACITY, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_collider_destroy': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_uint64), ctypes.c_uint32],
        ('world', 'colliders', 'count'),
        """lr_status lr_collider_destroy(lr_world* world, const lr_collider* colliders, uint32_t count)

        Destroys `count` colliders, all or none: if one of them is stale, or given twice, nothing is destroyed.

        world: the world
        colliders: `count` handles of colliders
        count: elements of the arrays

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER.
        """,
    ),
    'lr_collider_motion_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_collider_motion), ctypes.c_uint32],
        ('motion', 'struct_size'),
        """lr_status lr_collider_motion_init(lr_collider_motion* motion, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_collider_move': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_collider_motion), ctypes.c_uint32],
        ('world', 'motions', 'count'),
        """lr_status lr_collider_move(lr_world* world, const lr_collider_motion* motions, uint32_t count)

        Moves `count` colliders, all or none, in this order: of several motions of one collider the last holds. Planes that turn
        keep all bodies of the world from the fast path while they do.

        world: the world
        count: elements of the arrays

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_STALE_COLLIDER, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_collider_state_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_collider_state), ctypes.c_uint32],
        ('state', 'struct_size'),
        """lr_status lr_collider_state_init(lr_collider_state* state, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_collider_get_state': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint64, ctypes.POINTER(lr_collider_state)],
        ('world', 'collider', 'state'),
        """lr_status lr_collider_get_state(const lr_world* world, lr_collider collider, lr_collider_state* state)

        world: the world
        collider: a collider's handle
        state: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_collider_surface_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_collider_surface), ctypes.c_uint32],
        ('surface', 'struct_size'),
        """lr_status lr_collider_surface_init(lr_collider_surface* surface, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_collider_set_surface': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(ctypes.c_uint64), ctypes.c_uint32, ctypes.POINTER(lr_collider_surface)],
        ('world', 'colliders', 'count', 'surface'),
        """lr_status lr_collider_set_surface(lr_world* world, const lr_collider* colliders, uint32_t count, const lr_collider_surface* surface)

        Gives `count` colliders the same surface, all or none, from the next step on.

        world: the world
        colliders: `count` handles of colliders
        count: elements of the arrays

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_COLLIDER, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT.
        """,
    ),
    'lr_batch_contact_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_contact), ctypes.c_uint32],
        ('contact', 'struct_size'),
        """lr_status lr_batch_contact_init(lr_batch_contact* contact, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_batch_set_contact': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_contact)],
        ('world', 'batch', 'contact'),
        """lr_status lr_batch_set_contact(lr_world* world, lr_batch batch, const lr_batch_contact* contact)

        From the next step on; copied. Null is what a batch has initially. Wakes the batch's bodies at rest. Part of snapshots.

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

        world: the world
        batch: handle of a batch of the world
        contact: initialised, or with struct_size set.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
    'lr_batch_set_pair_contact': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_uint32, ctypes.c_int32],
        ('world', 'a', 'b', 'enabled'),
        """lr_status lr_batch_set_pair_contact(lr_world* world, lr_batch a, lr_batch b, int32_t enabled)

        Whether bodies of `a` and of `b` meet each other, from the next step on; their order does not matter, and a == b are the
        bodies of one batch among themselves. Initially none do. Friction, restitution and rolling resistance are those of
        lr_batch_contact: of a pair, friction is the geometric mean of both and restitution the larger. Layers are for colliders alone.
        Bodies of batches that are stepped at different rates (lr_batch_set_rate), or wait for a budget, meet only while one of both is
        at rest. A change wakes the bodies at rest of both batches, and the end of one batch those of the other. Part of snapshots.
        The first pair of a batch takes 28 bytes for each of its capacity, and up to 75 more unless there have been colliders.
        docs/maintainers/contact.md

        world: the world
        a: handle of a batch of the world
        b: handle of a batch of the world
        enabled: 0 or 1.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH (either), LR_ERROR_INVALID_ARGUMENT (enabled), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_get_pair_contact': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_uint32, ctypes.POINTER(ctypes.c_int32)],
        ('world', 'a', 'b', 'enabled'),
        """lr_status lr_batch_get_pair_contact(const lr_world* world, lr_batch a, lr_batch b, int32_t* enabled)

        world: the world
        a: handle of a batch of the world
        b: handle of a batch of the world
        enabled: receives 0 or 1; unchanged after an error.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH (either).
        """,
    ),
    'lr_world_set_contact_events': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_uint32],
        ('world', 'capacity', 'kinds'),
        """lr_status lr_world_set_contact_events(lr_world* world, uint32_t capacity, uint32_t kinds)

        Has events kept, at most `capacity` of a step, from now on: contacts that there are already do not begin again.

        world: the world
        capacity: elements that there is room for
        kinds: bits LR_EVENTS_*. capacity 0 ends it. All memory is taken here and by lr_batch_create, 225 bytes for each of a batch's capacity and 64 for each event, and a step takes none. Neither part of snapshots nor of the world's hash.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_INVALID_ARGUMENT (unknown bits; no bit but a capacity), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_contact_event_list_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_contact_event_list), ctypes.c_uint32],
        ('list', 'struct_size'),
        """lr_status lr_contact_event_list_init(lr_contact_event_list* list, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_world_get_contact_events': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_contact_event_list)],
        ('world', 'list'),
        """lr_status lr_world_get_contact_events(const lr_world* world, lr_contact_event_list* list)

        Valid until the next call that is not a query; empty after lr_world_snapshot_restore. In order of batches (their place in the
        world's table), then of the bodies' keys, then of kinds, then of colliders' slots: independent of workers, processors and where
        bodies lie in memory. Bodies that share a key are in order of their slots.
        Contact is looked at after each substep, and ends only at the end of a step: what bounces within one begins once. What touches
        and leaves within a step begins and ends in it. A body at rest still touches what it lies on. Of a body that ends there is one
        LR_BODY_KILLED and nothing else, but LR_BODY_FAULTED where that is why; of those destroyed by lr_body_destroy there is nothing. At
        most four colliders of a body count, those that press it most; other bodies that it touches count as one of the four, and neither
        begin nor end. A body that comes to rest on other bodies has landed.

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

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_world_ray_cast': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_ray), ctypes.c_uint32, ctypes.POINTER(lr_ray_hit)],
        ('world', 'rays', 'count', 'hits'),
        """lr_status lr_world_ray_cast(const lr_world* world, const lr_ray* rays, uint32_t count, lr_ray_hit* hits)

        What each ray hits first. Bodies are what can touch colliders of them: the hull of their asset, or an ellipsoid (docs/maintainers/contact.md);
        those of batches that wait (lr_batch_set_rate) are where they were stepped last. Planes and heightfields are solid below their surface,
        meshes are met from both sides. Colliders are where the last step or lr_collider_move has put them. Of equal distances bodies come
        before colliders, then the order is that of batches and keys, or of colliders' slots.

        world: the world
        rays: `count` elements.
        count: elements of the arrays
        hits: receives `count` elements.

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_STALE_BATCH: then no hit is written.
        """,
    ),
    'lr_overlap_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_overlap_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_overlap_desc_init(lr_overlap_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_world_overlap': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.POINTER(lr_overlap_desc), ctypes.POINTER(ctypes.c_uint64), ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint32)],
        ('world', 'desc', 'bodies', 'capacity', 'count'),
        """lr_status lr_world_overlap(const lr_world* world, const lr_overlap_desc* desc, lr_body* bodies, uint32_t capacity, uint32_t* count)

        All bodies of which a part is in a sphere or box, in order of batches, then keys, then slots. They are the same as for rays.

        world: the world
        desc: initialised by its `_init` function, or with struct_size set
        bodies: room for `capacity` ids; may be null when that is 0.
        capacity: elements that there is room for
        count: receives how many there are.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_BUFFER_TOO_SMALL: *count is set, and `bodies` holds no meaning.
        """,
    ),
    'lr_batch_rules_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_rules), ctypes.c_uint32],
        ('rules', 'struct_size'),
        """lr_status lr_batch_rules_init(lr_batch_rules* rules, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_batch_set_rules': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_rules)],
        ('world', 'batch', 'rules'),
        """lr_status lr_batch_set_rules(lr_world* world, lr_batch batch, const lr_batch_rules* rules)

        Bodies are judged at the end of each step, those at rest (lr_body_set_rest) in one of 16 of their batch. Copied; null
        ends the rules. Part of snapshots. The first rules or emitter of a batch take 24 bytes for each of its capacity; later
        calls, say to move a volume along with a camera, none.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also LR_END_RESPAWN without an emitter), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_set_fault_policy': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_int32],
        ('world', 'batch', 'policy'),
        """lr_status lr_batch_set_fault_policy(lr_world* world, lr_batch batch, int32_t policy)

        What becomes of a body that has left physics: forces beyond all measure, a scheme that blows up, a collider that shoots it out of
        the world. Every body is judged in each step, and after impulses: a number that is not finite, a coordinate over 1e10 m, a velocity
        over 2e6 m/s or 1e9 rad/s, or an orientation that is none must not be seen. At the end of the step it is told by LR_BODY_FAULTED, counted
        in lr_batch_events, and logged once for all; others are not touched by it. docs/reference/bodies.md
        A body that is held has the position and orientation of the beginning of that step or substep, and no velocity. Nothing moves or
        touches it, it moves and touches nothing, forces on it are taken and have no effect; it grows older, and rules may end it.
        lr_body_set_state sets it free, and lr_body_set_rest puts it to rest like any other. lr_body_state.resting tells.
        Initially LR_FAULT_AUTO. From the next step on, also for the others; those that are held stay so. Part of snapshots and hash.

        world: the world
        batch: handle of a batch of the world
        policy: LR_FAULT_*. LR_FAULT_REMOVE takes memory as lr_batch_set_rules.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT, LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_get_fault_policy': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(ctypes.c_int32)],
        ('world', 'batch', 'policy'),
        """lr_status lr_batch_get_fault_policy(const lr_world* world, lr_batch batch, int32_t* policy)

        world: the world
        batch: handle of a batch of the world
        policy: receives LR_FAULT_*; unchanged after an error.

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH.
        """,
    ),
    'lr_emitter_desc_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_emitter_desc), ctypes.c_uint32],
        ('desc', 'struct_size'),
        """lr_status lr_emitter_desc_init(lr_emitter_desc* desc, uint32_t struct_size)

        desc: initialised by its `_init` function, or with struct_size set
        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_batch_set_emitter': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_emitter_desc)],
        ('world', 'batch', 'desc'),
        """lr_status lr_batch_set_emitter(lr_world* world, lr_batch batch, const lr_emitter_desc* desc)

        Bodies are born at the end of each step, after others have ended, up to the batch's capacity; those that find no room
        are not born later. Their keys are the world's next. Copied; another emitter carries on with the fraction of a body
        that is due and with the time since the last burst; null ends it. Part of snapshots. Memory: as lr_batch_set_rules.

        world: the world
        batch: handle of a batch of the world
        desc: initialised by its `_init` function, or with struct_size set

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT (world), LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE, LR_ERROR_NOT_FINITE, LR_ERROR_INVALID_ARGUMENT (also null while the rules respawn), LR_ERROR_OUT_OF_MEMORY.
        """,
    ),
    'lr_batch_emit': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.c_uint32, ctypes.POINTER(ctypes.c_uint64)],
        ('world', 'batch', 'count', 'out_ids'),
        """lr_status lr_batch_emit(lr_world* world, lr_batch batch, uint32_t count, lr_body* out_ids)

        Bears `count` bodies now, all or none.

        world: the world
        batch: handle of a batch of the world
        count: elements of the arrays
        out_ids: receives `count` ids; may be null.

        Returns LR_OK (also for count 0), LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_INVALID_ARGUMENT (no emitter), LR_ERROR_CAPACITY.
        """,
    ),
    'lr_batch_events_init': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_batch_events), ctypes.c_uint32],
        ('events', 'struct_size'),
        """lr_status lr_batch_events_init(lr_batch_events* events, uint32_t struct_size)

        struct_size: sizeof the struct as the caller sees it
        """,
    ),
    'lr_batch_get_events': (
        ctypes.c_int32,
        [ctypes.POINTER(lr_world), ctypes.c_uint32, ctypes.POINTER(lr_batch_events)],
        ('world', 'batch', 'events'),
        """lr_status lr_batch_get_events(const lr_world* world, lr_batch batch, lr_batch_events* events)

        Lists are valid until the next call that is not a query. All but faults is 0 and null for a batch that never had rules or an
        emitter. Totals are part of snapshots; after a restore there are no events of the last step.

        world: the world
        batch: handle of a batch of the world

        Returns LR_OK, LR_ERROR_NULL_ARGUMENT, LR_ERROR_STALE_BATCH, LR_ERROR_STRUCT_SIZE.
        """,
    ),
}


def bind(library):
    """Gives every function of a loaded library its types and its text."""
    for name, (result, parameters, _, text) in PROTOTYPES.items():
        function = getattr(library, name)
        function.restype = result
        function.argtypes = parameters
        function.__doc__ = text
    return library
