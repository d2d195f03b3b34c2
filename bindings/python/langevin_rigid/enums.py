# SPDX-License-Identifier: MIT
# Generated from include/langevin_rigid.h by bindings/generator/python.py: do not edit.

"""Constants of the library, as enumerations."""
from enum import IntEnum, IntFlag

__all__ = [
    'AssetFlags',
    'CheckFlags',
    'ColliderKind',
    'ContactFlags',
    'DivergencePolicy',
    'EmitterPose',
    'EmitterShape',
    'EndAction',
    'EventKind',
    'EventKinds',
    'ForceFlags',
    'ForceFrame',
    'ForceMode',
    'Integrator',
    'KillSide',
    'LoadModel',
    'LogLevel',
    'MoveMode',
    'OverlapShape',
    'RayFlags',
    'RecordFlags',
    'SimdTarget',
    'SleepState',
    'Status',
    'TableEnd',
    'TransformFormat',
    'TurbulenceClock',
    'VolumeShape',
    'VortexCore',
    'WindOutside',
    'MAX_SUBSTEP',
    'MAX_SUBSTEPS',
    'MAX_WIND_SOURCES',
    'MAX_WIND_SAMPLES',
    'MAX_WAVES',
    'MAX_COLLIDERS',
    'MAX_HULL_VERTICES',
    'MAX_COLLIDER_VERTICES',
    'MAX_KILL_VOLUMES',
]

MAX_SUBSTEP = 1.0  # s: the largest dt / substeps
MAX_SUBSTEPS = 65536  # the most substeps in one step
MAX_WIND_SOURCES = 64
MAX_WIND_SAMPLES = 67108864  # of one grid, all frames together
MAX_WAVES = 8
MAX_COLLIDERS = 67108864  # in a world, at a time
MAX_HULL_VERTICES = 256  # of one hull
MAX_COLLIDER_VERTICES = 67108864  # vertices or triangles of one mesh, or heights of one heightfield
MAX_KILL_VOLUMES = 8


class Status(IntEnum):
    """LR_OK, or a negative error. Values never change."""
    OK = 0  # success
    NULL_ARGUMENT = -1  # a required pointer is null
    STRUCT_SIZE = -2  # struct_size is of no release, or an unknown tail is not 0: see LR_..._INIT
    INVALID_ARGUMENT = -3  # a value is out of range
    NOT_FINITE = -4  # a number is NaN or infinite
    OUT_OF_MEMORY = -5  # out of memory: the allocator returned null
    STALE_BODY = -6  # the body was destroyed, or never existed
    STALE_BATCH = -7  # the batch was destroyed, or never existed
    CAPACITY = -8  # the batch, or the world's table of batches, is full
    BUFFER_TOO_SMALL = -9  # the caller's buffer cannot hold the result
    FILE_NOT_FOUND = -10  # no file at that path
    FILE_READ = -11  # the file exists but cannot be read
    ASSET_FORMAT = -12  # not an asset file: too short, or another kind of file
    ASSET_VERSION = -13  # made for a newer library
    ASSET_CORRUPT = -14  # an asset file, but damaged
    ASSET_INVALID = -15  # an undamaged asset file with numbers that no body can have
    SNAPSHOT_FORMAT = -16  # not a snapshot, damaged, or of another version
    SNAPSHOT_MISMATCH = -17  # the snapshot's world has other batches, capacities or assets
    UNSUPPORTED = -18  # not available on this processor or in this build
    THREADS = -19  # the worker threads could not be started
    TIMESTEP_ZERO = -20  # dt is 0: while paused, do not step
    TIMESTEP_NEGATIVE = -21  # dt is negative
    TIMESTEP_NOT_FINITE = -22  # dt is NaN or infinite
    TIMESTEP_TOO_LARGE = -23  # dt / substeps exceeds `MAX_SUBSTEP`
    SUBSTEPS = -24  # substeps is 0 or exceeds `MAX_SUBSTEPS`
    INTERNAL = -25  # a bug in the library: please report it
    STALE_WIND_SOURCE = -26  # the wind source was removed, or never existed
    STALE_COLLIDER = -27  # the collider was destroyed, or never existed
    CONCURRENT_USE = -28  # another thread is inside a call on this world: see `CheckFlags.THREADS`
    REENTRANT = -29  # called from one of this world's callbacks: see `CheckFlags.THREADS`


class LogLevel(IntEnum):
    """Severity of a log message."""
    ERROR = 1  # a call failed: the message names it and gives the reason
    WARNING = 2  # a call succeeded, but probably does not do what was meant
    INFO = 3


class SimdTarget(IntEnum):
    """Instruction sets. All give the same bits, so force one only for tests and measurements. LR_SIMD_AUTO picks the best
that the processor supports."""
    AUTO = 0
    SSE4 = 1  # with SSE4.2, AES and PCLMUL: the minimum on x86-64
    AVX2 = 2
    AVX512 = 3
    NEON = 4
    WASM = 5
    PLAIN = 6  # plain C++, only in test builds


class AssetFlags(IntFlag):
    """Bits that describe an asset."""
    DIAGONAL = 1  # diagonal in body axes, buoyancy at the centre of mass: the fastest path for all loads
    SYMMETRIC = 2  # its own mirror image across its widest face: the fastest path for AERODYNAMIC loads


class CheckFlags(IntFlag):
    """Refuses a call on a world while another thread is inside one, and a call from one of the world's own callbacks (wind,
water surface, allocator, log, job system, recording). The refused call changes nothing, a message names both
functions, and the call in progress continues unharmed. A refused lr_world_destroy leaks the world; a refused
lr_world_snapshot_size returns 0. Calls after lr_world_destroy has returned are not detected. Without this bit all
such calls are undefined behaviour. docs/reference/stepping.md"""
    THREADS = 1


class VortexCore(IntEnum):
    """The core of a vortex."""
    LAMB_OSEEN = 0  # a smooth core, as viscosity spreads it
    RANKINE = 1  # a core that rotates as a solid


class WindOutside(IntEnum):
    """The value of a wind grid outside its samples."""
    ZERO = 0  # a grid adds nothing outside its samples
    CLAMP = 1  # the values at its border continue outside
    REPEAT = 2  # the grid repeats: its first sample follows its last


class RecordFlags(IntFlag):
    """Records the results of wind and water callbacks, up to 72 bytes per body and substep for each callback. Without them
a replay stops at the first callback."""
    CALLBACKS = 1


class LoadModel(IntEnum):
    """How the fluid's forces on bodies are computed."""
    DEFAULT = 0  # `LoadModel.AERODYNAMIC` in this version
    NONE = 1  # gravity, buoyancy and added mass only: Kirchhoff's equations
    LANGEVIN = 2  # the paper's turbulent loads, dimensionally repaired; docs/maintainers/physics.md, 4
    AERODYNAMIC = 3  # quasi-steady drag and lift in a turbulent fluid; docs/maintainers/physics.md, 5


class TurbulenceClock(IntEnum):
    """The clock of a body's turbulence."""
    SPEED = 0  # turbulence scales with the body's current speed through the fluid
    AGE = 1  # the paper's: turbulence follows the table by the body's age


class TableEnd(IntEnum):
    """Continuation of a turbulence table after its last sample."""
    CLAMP = 0  # `TurbulenceClock.AGE`: hold the last sample after the end of the table
    LOOP = 1  # `TurbulenceClock.AGE`: start over


class Integrator(IntEnum):
    """How motion is integrated."""
    DEFAULT = 0  # `Integrator.SPLITTING` in this version
    RK4 = 1  # the paper's: fourth order, slow, unstable at long steps. In water: splitting
    SPLITTING = 2  # second order, stable at any step; docs/maintainers/numerics.md


class TransformFormat(IntEnum):
    """Formats of transforms, in floats."""
    POSITION_QUATERNION = 0  # 7 floats: position, quaternion x y z w
    POSITION_QUATERNION_SCALE = 1  # 8 floats: position, quaternion x y z w, scale
    MATRIX_3X4_ROW_MAJOR = 2  # 12 floats: three rows, rotation times scale and translation
    MATRIX_3X4_COLUMN_MAJOR = 3  # 12 floats: four columns of three
    MATRIX_4X4_ROW_MAJOR = 4  # 16 floats; column vectors, translation in elements 3, 7, 11
    MATRIX_4X4_COLUMN_MAJOR = 5  # 16 floats; column vectors, translation in elements 12, 13, 14


class SleepState(IntEnum):
    """A body's sleep state."""
    AWAKE = 0
    ASLEEP = 1
    HELD = 2  # read only: diverged, and held where it was by lr_batch_set_divergence_policy


class ForceMode(IntEnum):
    """The unit and timing of a force. Forces and accelerations act over the whole next step, at the body's orientation in
each substep, and are then gone; those of several calls add up. Impulses and velocities act at once. A force or
impulse also moves the added mass of fluid, (M + added)^-1 F; an acceleration or velocity takes full effect whatever
the mass."""
    FORCE = 0  # N, N m
    ACCELERATION = 1  # m/s^2, rad/s^2
    IMPULSE = 2  # N s, N m s
    VELOCITY = 3  # m/s, rad/s: added to the body's


class ForceFrame(IntEnum):
    """The frame of a force."""
    WORLD = 0
    BODY = 1  # rotates with the body


class ForceFlags(IntFlag):
    """Options of a force on one body."""
    AT_POINT = 1  # `force` acts at `point`, not at the centre of mass; forces and impulses only


class ColliderKind(IntEnum):
    """Shapes of colliders, in a frame of their own that `position` and `orientation` place in the world. size[] holds
  PLANE        nothing: everything below y = 0 is solid, without bounds
  SPHERE       the radius
  CAPSULE      the radius, and half the length of its axis from (0, -size[1], 0) to (0, size[1], 0)
  BOX          half extents along x, y, z
  HULL         nothing: the convex hull of `vertices`
  HEIGHTFIELD  nothing: solid below its surface, along -y. Sample (i, k) lies at
               (i spacing[0], heights[i + counts[0] k], k spacing[1]); the diagonal from (i, k) to (i + 1, k + 1)
               splits each cell into two triangles
  MESH         nothing: triangles without an inside. Both sides collide, and winding does not matter. A body pays for
               each triangle near it: 2 us a substep on triangles of its own size, 20 us on those of an eighth, 70 us on
               those of a sixteenth, far more on smaller ones. Give scanned scenery a coarser collision mesh"""
    PLANE = 1
    SPHERE = 2
    CAPSULE = 3
    BOX = 4
    HULL = 5
    HEIGHTFIELD = 6
    MESH = 7


class MoveMode(IntEnum):
    """Ways to move a collider."""
    TO = 1  # sweeps to this pose during the next step, then stands still
    PLACE = 2  # teleports to this pose, and moves with these velocities from now on
    VELOCITY = 3  # keeps its pose, and moves with these velocities from now on


class ContactFlags(IntFlag):
    """Options of a batch's contact."""
    NEVER_SLEEP = 1  # bodies never fall asleep by themselves, only by lr_body_set_sleep


class EventKind(IntEnum):
    """Kinds of events."""
    SPAWNED = 1  # an emitter, lr_batch_spawn or lr_batch_spawn_box added it since the previous step
    HIT = 2  # the body touches a collider that it did not touch at the end of the step before
    LIFTED = 3  # it no longer touches the collider, or the collider was destroyed: its id is stale
    LANDED = 4  # it fell asleep by itself
    WOKE = 5  # it woke since the previous step, for any reason
    KILLED = 6  # its batch's rules or its divergence destroyed it: its id is stale
    RESPAWNED = 7  # its batch's rules or its divergence ended it, and it restarted with its id
    DIVERGED = 8  # it diverged: lr_batch_set_divergence_policy


class EventKinds(IntFlag):
    """Bits for lr_world_set_events."""
    SPAWNED = 1
    HIT = 2
    LIFTED = 4
    LANDED = 8
    WOKE = 16
    KILLED = 32
    RESPAWNED = 64
    DIVERGED = 128
    ALL = 255


class RayFlags(IntFlag):
    """Targets of a ray."""
    BODIES = 1
    COLLIDERS = 2


class OverlapShape(IntEnum):
    """Shapes of overlap queries."""
    SPHERE = 1  # size[0]: radius
    BOX = 2  # size: half extents along its own axes


class EndAction(IntEnum):
    """The fate of a body that its batch's rules end."""
    DESTROY = 0  # the body is destroyed and its id becomes stale
    RESPAWN = 1  # the body restarts where the batch's emitter puts it, at age 0, with its id and noise seed


class VolumeShape(IntEnum):
    """Shapes of kill volumes."""
    PLANE = 0  # `size` is its normal, `center` a point of it; inside: behind it, away from the normal
    BOX = 1  # axis-aligned; size: half extents
    SPHERE = 2  # size[0]: radius


class KillSide(IntEnum):
    """The side of a kill volume on which bodies end."""
    INSIDE = 0
    OUTSIDE = 1


class DivergencePolicy(IntEnum):
    """The fate of a diverged body."""
    AUTO = 0  # `DivergencePolicy.REMOVE` in a batch with rules, else `DivergencePolicy.FREEZE`
    FREEZE = 1  # the body is held where it was last valid
    REMOVE = 2  # the body respawns if the batch's rules respawn, else it is destroyed


class EmitterShape(IntEnum):
    """Shapes in which an emitter spawns bodies."""
    POINT = 0
    BOX = 1  # filled evenly
    SPHERE = 2  # filled evenly
    DISC = 3  # filled evenly, in the plane of the shape's x and y axes
    BOX_SURFACE = 4  # covered evenly
    SPHERE_SURFACE = 5  # covered evenly if its three sizes are equal


class EmitterPose(IntEnum):
    """Orientations of spawned bodies."""
    RANDOM = 0  # every orientation is equally likely
    FIXED = 1  # body_orientation
