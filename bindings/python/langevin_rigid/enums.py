# SPDX-License-Identifier: MIT
# Generated from include/langevin_rigid.h by bindings/generator/python.py: do not edit.

"""Constants of the library, as enumerations."""
from enum import IntEnum, IntFlag

__all__ = [
    'AssetFlags',
    'Clock',
    'ColliderKind',
    'ContactFlags',
    'EmitShape',
    'EndAction',
    'EventKind',
    'EventKinds',
    'FaultPolicy',
    'ForceFlags',
    'ForceMode',
    'Frame',
    'Integrator',
    'KillSide',
    'Loads',
    'LogLevel',
    'MoveMode',
    'OverlapShape',
    'Pose',
    'RayFlags',
    'RecordingFlags',
    'Rest',
    'SimdTarget',
    'Status',
    'TableEnd',
    'Transform',
    'VolumeShape',
    'WindKind',
    'WindOutside',
    'WindSourceKind',
    'WorldChecks',
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

MAX_SUBSTEP = 1.0  # s: the longest dt / substeps that is taken
MAX_SUBSTEPS = 65536  # the most substeps in one step
MAX_WIND_SOURCES = 64
MAX_WIND_SAMPLES = 67108864  # of a grid, all frames together
MAX_WAVES = 8
MAX_COLLIDERS = 67108864  # in a world, at a time
MAX_HULL_VERTICES = 256  # given for one hull
MAX_COLLIDER_VERTICES = 67108864  # of one mesh; and triangles of one, and heights of one heightfield
MAX_KILL_VOLUMES = 8


class Status(IntEnum):
    """What a call says: exceptions have it as `status`."""
    OK = 0
    NULL_ARGUMENT = -1  # a pointer that must be given is null
    STRUCT_SIZE = -2  # struct_size is smaller than any released size, or an unknown tail is not zero
    INVALID_ARGUMENT = -3  # a value is out of its range
    NOT_FINITE = -4  # a number is NaN or infinite
    OUT_OF_MEMORY = -5  # the allocator returned null
    STALE_BODY = -6  # the body was destroyed, or never was
    STALE_BATCH = -7  # the batch was destroyed, or never was
    CAPACITY = -8  # the batch, or the world's table of batches, is full
    BUFFER_TOO_SMALL = -9  # the caller's buffer cannot hold the result
    FILE_NOT_FOUND = -10  # no file at that path
    FILE_READ = -11  # the file exists but cannot be read
    ASSET_FORMAT = -12  # not an asset file: too short, or another kind of file
    ASSET_VERSION = -13  # made for a newer library
    ASSET_CORRUPT = -14  # an asset file, but damaged
    ASSET_INVALID = -15  # undamaged, but its numbers cannot be those of a body
    SNAPSHOT_FORMAT = -16  # not a snapshot, damaged, or of another version
    SNAPSHOT_MISMATCH = -17  # a snapshot of a world with other batches or assets
    UNSUPPORTED = -18  # not available on this processor or in this build
    THREADS = -19  # the worker threads could not be started
    TIMESTEP_ZERO = -20  # dt is 0
    TIMESTEP_NEGATIVE = -21  # dt is negative
    TIMESTEP_NOT_FINITE = -22  # dt is NaN or infinite
    TIMESTEP_TOO_LARGE = -23  # dt / substeps is over `MAX_SUBSTEP`
    SUBSTEPS = -24  # substeps is 0 or over `MAX_SUBSTEPS`
    INTERNAL = -25  # a defect of the library: please report
    STALE_WIND_SOURCE = -26  # the wind source was removed, or never was
    STALE_COLLIDER = -27  # the collider was destroyed, or never was
    CONCURRENT_USE = -28  # another thread is inside a call on the world: `WorldChecks.THREADS`
    REENTRANT = -29  # this thread is, and the call comes from a callback: `WorldChecks.THREADS`


class LogLevel(IntEnum):
    """How grave a message is."""
    ERROR = 1  # a call failed: the message says which, and why
    WARNING = 2  # a call succeeded, but probably not as meant
    INFO = 3


class SimdTarget(IntEnum):
    """Instruction sets, all of which give the same bits."""
    AUTO = 0
    SSE4 = 1  # with SSE4.2, AES and PCLMUL: the least that an x86-64 processor must have
    AVX2 = 2
    AVX512 = 3
    NEON = 4
    WASM = 5
    PLAIN = 6  # plain C++, in builds for tests alone


class AssetFlags(IntFlag):
    """What is special about an asset."""
    DIAGONAL = 1  # diagonal in body axes, buoyancy at the centre of mass: the fast path applies


class WorldChecks(IntFlag):
    """Misuse that is found at run time."""
    THREADS = 1


class WindKind(IntEnum):
    """The uniform part of the wind."""
    STILL = 0
    UNIFORM = 1  # the same velocity everywhere


class WindSourceKind(IntEnum):
    """Kinds of wind sources."""
    GUSTS = 1  # fluctuations of the uniform wind in time
    RANKINE = 2  # a straight vortex with a core that turns as a solid
    LAMB_OSEEN = 3  # a straight vortex with a smooth core
    POINT_BLOWER = 4  # a round jet
    LINE_BLOWER = 5  # a plane jet from a slot
    TURBULENCE = 6  # random, without divergence, everywhere; carried along by the uniform wind
    GRID = 7  # samples on a lattice, in one or more frames
    GROUND = 8  # a factor of the uniform wind and the gusts: logarithmic over a plane


class WindOutside(IntEnum):
    """What a wind grid is outside its samples."""
    ZERO = 0  # a grid adds nothing outside its samples
    CLAMP = 1  # it goes on as at its border
    REPEAT = 2  # it repeats itself; the first sample follows the last


class RecordingFlags(IntFlag):
    """Of a recording."""
    CALLBACKS = 1


class Loads(IntEnum):
    """What the fluid does to the bodies of a batch."""
    DEFAULT = 0  # `Loads.AERODYNAMIC` in this version
    NONE = 1  # gravity, buoyancy and added mass only: Kirchhoff's equations
    LANGEVIN = 2  # the paper's turbulent loads, dimensionally repaired; docs/maintainers/physics.md, 4
    AERODYNAMIC = 3  # quasi-steady drag and lift in a turbulent fluid; docs/maintainers/physics.md, 5


class Clock(IntEnum):
    """What turbulence goes by."""
    SPEED = 0  # turbulence scales with the body's present speed through the fluid
    AGE = 1  # the paper: turbulence follows the table at the body's age


class TableEnd(IntEnum):
    """What comes after the last sample of a turbulence table."""
    CLAMP = 0  # `Clock.AGE`: hold the last sample after the end of the table
    LOOP = 1  # `Clock.AGE`: begin again


class Integrator(IntEnum):
    """How motion is integrated."""
    DEFAULT = 0  # `Integrator.SPLITTING` in this version
    RK4 = 1  # the paper's: fourth order, unstable at long steps, slow. In water: splitting
    SPLITTING = 2  # second order and stable at any step; docs/maintainers/numerics.md


class Transform(IntEnum):
    """Formats of transforms."""
    POSITION_QUATERNION = 0  # 7 floats: position, quaternion x y z w
    POSITION_QUATERNION_SCALE = 1  # 8 floats: the same and the scale
    MATRIX_3X4_ROW_MAJOR = 2  # 12 floats: three rows of rotation times scale and translation
    MATRIX_3X4_COLUMN_MAJOR = 3  # 12 floats: four columns of three
    MATRIX_4X4_ROW_MAJOR = 4  # 16 floats; column vectors, translation in elements 3, 7, 11
    MATRIX_4X4_COLUMN_MAJOR = 5  # 16 floats; column vectors, translation in elements 12, 13, 14


class Rest(IntEnum):
    """Whether a body is at rest."""
    AWAKE = 0
    RESTING = 1
    HELD = 2  # read only: it has left physics, and lr_batch_set_fault_policy holds it where it was


class ForceMode(IntEnum):
    """What a force's numbers are."""
    FORCE = 0  # N, N m
    ACCELERATION = 1  # m/s^2, rad/s^2
    IMPULSE = 2  # N s, N m s
    VELOCITY = 3  # m/s, rad/s: added to the body's


class Frame(IntEnum):
    """The frame of a force."""
    WORLD = 0
    BODY = 1  # turns with the body


class ForceFlags(IntFlag):
    """Where a force acts."""
    AT_POINT = 1  # `force` acts at `point`, not at the centre of mass; forces and impulses only


class ColliderKind(IntEnum):
    """Shapes of colliders."""
    PLANE = 1
    SPHERE = 2
    CAPSULE = 3
    BOX = 4
    HULL = 5
    HEIGHTFIELD = 6
    MESH = 7


class MoveMode(IntEnum):
    """How a collider moves."""
    TO = 1  # over the next step it goes from where it is to this pose, and stands still afterwards
    PLACE = 2  # it is there at once, and has these velocities from now on
    VELOCITY = 3  # it stays where it is, and has these velocities from now on


class ContactFlags(IntFlag):
    """How bodies of a batch meet colliders."""
    NEVER_REST = 1  # bodies move until they are put to rest by lr_body_set_rest


class EventKind(IntEnum):
    """What happened to a body."""
    CONTACT_BEGIN = 1  # a body touches a collider that it did not touch at the end of the step before
    CONTACT_END = 2  # it no longer does, or the collider has been destroyed, whose id is then stale
    LANDED = 3  # it has come to rest by itself
    WOKE = 4  # it has left rest since the step before, whatever for
    KILLED = 5  # its batch's rules have ended it; with `EndAction.RESPAWN` it goes on with the same id
    FAULTED = 6  # it has left physics: lr_batch_set_fault_policy


class EventKinds(IntFlag):
    """Which events are kept."""
    BEGIN = 1
    END = 2
    LANDED = 4
    WOKE = 8
    KILLED = 16
    FAULTED = 32
    ALL = 63


class RayFlags(IntFlag):
    """What a ray can hit."""
    BODIES = 1
    COLLIDERS = 2


class OverlapShape(IntEnum):
    """Where bodies are looked for."""
    SPHERE = 1  # size[0]: radius
    BOX = 2  # size: half extents along its own axes


class EndAction(IntEnum):
    """What becomes of bodies that end."""
    DESTROY = 0  # the body is destroyed, its id stale
    RESPAWN = 1  # the body begins anew where the batch's emitter says, at age 0, with the same id and key


class VolumeShape(IntEnum):
    """Shapes of kill volumes."""
    PLANE = 0  # inside: behind the plane through `center`, away from its normal `size`
    BOX = 1  # axis-aligned; size: half extents
    SPHERE = 2  # size[0]: radius


class KillSide(IntEnum):
    """On which side of a kill volume bodies end."""
    INSIDE = 0
    OUTSIDE = 1


class FaultPolicy(IntEnum):
    """What becomes of bodies that have left physics."""
    AUTO = 0  # as `FaultPolicy.REMOVE` in a batch with rules, as `FaultPolicy.FREEZE` in others
    FREEZE = 1  # it is held where it last was sane
    REMOVE = 2  # it ends: respawns where the batch's rules do that, else is destroyed


class EmitShape(IntEnum):
    """Where bodies are born."""
    POINT = 0
    BOX = 1  # the first three fill their shape evenly
    SPHERE = 2
    DISC = 3  # in the plane of the shape's own x and y
    BOX_SURFACE = 4  # evenly
    SPHERE_SURFACE = 5  # evenly if its three sizes are equal


class Pose(IntEnum):
    """How bodies lie when they are born."""
    RANDOM = 0  # every orientation alike
    FIXED = 1  # body_orientation
