# SPDX-License-Identifier: MIT
# Generated from include/langevin_rigid.h by bindings/generator/python.py: do not edit.

"""Records that calls return."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ._record import Record
from .enums import AssetFlags, ColliderKind, ContactFlags, EmitterPose, EmitterShape, EndAction, SimdTarget, SleepState

if TYPE_CHECKING:
    from numpy.typing import NDArray


class AssetInfo(Record):
    """Properties of an asset. Matrices are row-major and symmetric.

    flags: `AssetFlags`
    name: UTF-8, ends with 0
    mass: kg
    volume: m^3
    density: kg/m^3
    center_of_mass: m, in the frame of the mesh: the position of the body's origin in it
    center_of_buoyancy: m, from the centre of mass, body axes
    inertia: kg m^2, about the centre of mass, body axes
    added_mass: about the centre of mass, order vx vy vz wx wy wz, fluid density included: kg for the 3x3 block of v, kg m for the coupling, kg m^2 for the block of w
    fluid_density: kg/m^3, of the fluid that the asset was baked in
    fluid_viscosity: m^2/s, kinematic
    length_d: m, characteristic length: the largest extent
    length_b: m, thickness
    length_l: m, turbulence length; see docs/maintainers/physics.md
    u0: m/s, fall velocity scale sqrt(|density ratio - 1| g b), paper Eq. 1
    reynolds: u0 d / viscosity
    c0: Kolmogorov constant of the Langevin model, paper Eq. 10
    turbulence_dt: s between table samples
    turbulence_count: number of table samples
    hull_vertex_count: 0: no hull
    hull_triangle_count
    format_version: of the file; 0: created without a file
    content_hash: of everything that affects motion; equal for equal assets
    """
    __slots__ = ('flags', 'name', 'mass', 'volume', 'density', 'center_of_mass', 'center_of_buoyancy', 'inertia', 'added_mass', 'fluid_density', 'fluid_viscosity', 'length_d', 'length_b', 'length_l', 'u0', 'reynolds', 'c0', 'turbulence_dt', 'turbulence_count', 'hull_vertex_count', 'hull_triangle_count', 'format_version', 'content_hash')
    flags: AssetFlags
    name: str
    mass: float
    volume: float
    density: float
    center_of_mass: NDArray[Any]
    center_of_buoyancy: NDArray[Any]
    inertia: NDArray[Any]
    added_mass: NDArray[Any]
    fluid_density: float
    fluid_viscosity: float
    length_d: float
    length_b: float
    length_l: float
    u0: float
    reynolds: float
    c0: float
    turbulence_dt: float
    turbulence_count: int
    hull_vertex_count: int
    hull_triangle_count: int
    format_version: int
    content_hash: int
    _enums = {'flags': AssetFlags}


class WorldInfo(Record):
    """Values of lr_world_info.

    simd_target: `SimdTarget`: in use, never `SimdTarget.AUTO`
    worker_count: as in the desc; with `jobs` and 0: the guess
    batch_count
    body_count
    substep_count: substeps since creation; the time index of the noise
    time: s since creation: the sum of all dt, in double
    memory_bytes: currently allocated
    collider_count
    awake_count: bodies that are not asleep: lr_body_set_sleep
    budget: as set by lr_world_set_budget
    gravity: m/s^2, as set by lr_world_set_gravity
    """
    __slots__ = ('simd_target', 'worker_count', 'batch_count', 'body_count', 'substep_count', 'time', 'memory_bytes', 'collider_count', 'awake_count', 'budget', 'gravity')
    simd_target: SimdTarget
    worker_count: int
    batch_count: int
    body_count: int
    substep_count: int
    time: float
    memory_bytes: int
    collider_count: int
    awake_count: int
    budget: int
    gravity: NDArray[Any]
    _enums = {'simd_target': SimdTarget}


class Water(Record):
    """The water surface. Water fills everything below it; above it is the fluid of the world or of each batch's asset.

    wave_count: elements of `waves` in use; the others are not kept; default 0
    position: m, a point of the plane, each up to 1e9 in magnitude; default 0
    normal: upward, any length but 0; default 0, 1, 0
    density: kg/m^3, 1e-3 to 1e6; default 998. A batch whose own fluid is denser keeps its own density
    viscosity: m^2/s, kinematic, 1e-12 to 1e3; default 1e-6
    current: m/s, of the water, and of a plane that you move; each up to 1000 in magnitude; default 0
    reach: m, 0 to 1e6: the farthest that a callback's surface lies from the plane; default 0
    waves
    """
    __slots__ = ('wave_count', 'position', 'normal', 'density', 'viscosity', 'current', 'reach', 'waves')
    wave_count: int
    position: NDArray[Any]
    normal: NDArray[Any]
    density: float
    viscosity: float
    current: NDArray[Any]
    reach: float
    waves: NDArray[Any]


class StepReport(Record):
    """Work done and postponed by the last step. Batches without bodies are not counted.

    batches_stepped
    batches_waiting: not due, because of their divisors
    batches_passed_over: due, but out of budget
    body_substeps: done in this step
    body_substeps_wanted: that the batches which were due would need without a budget
    behind: s: the longest time by which a batch is behind the world
    lost: s: the most simulated time that a batch lost in this step: rather than take substeps that are too long, bodies move in slow motion
    """
    __slots__ = ('batches_stepped', 'batches_waiting', 'batches_passed_over', 'body_substeps', 'body_substeps_wanted', 'behind', 'lost')
    batches_stepped: int
    batches_waiting: int
    batches_passed_over: int
    body_substeps: int
    body_substeps_wanted: int
    behind: float
    lost: float


class Timings(Record):
    """Seconds that the phases of the last step took on the stepping thread, by a monotonic clock. `total` also includes
    the work between phases. Phases that did not occur are 0. Neither part of snapshots nor of the world's hash.

    total
    colliders: waking bodies about to be hit, moving colliders, sorting them for the search
    wind: preparing the wind's fields; bodies evaluate them as part of their motion
    motion: of batches without body contact: loads, wind, water, contact with colliders
    body_contact: of batches with body contact: their motion, and the contact between their bodies
    wake: finding sleeping bodies that wind or water moves
    emit_and_rules: ends, spawns, divergence, and falling asleep
    events: listing and sorting them
    """
    __slots__ = ('total', 'colliders', 'wind', 'motion', 'body_contact', 'wake', 'emit_and_rules', 'events')
    total: float
    colliders: float
    wind: float
    motion: float
    body_contact: float
    wake: float
    emit_and_rules: float
    events: float


class LoadGains(Record):
    """Artistic control of AERODYNAMIC loads. The factors multiply the coefficients, so bodies still move physically.

    drag: on translation, 0 to 100; default 1
    lift: and its moment, 0 to 100; default 1
    spin_drag: 0 to 100; default 1
    turbulence: intensity of the body's own wake, 0 to 100; default 1
    """
    __slots__ = ('drag', 'lift', 'spin_drag', 'turbulence')
    drag: float
    lift: float
    spin_drag: float
    turbulence: float


class BatchPace(Record):
    """How a batch keeps pace with its world.

    divisor: as set
    substeps: in the world's last step; 0: it waited
    waited: steps since it was last stepped
    behind: s since it was last stepped
    lost: s, simulated time lost in total
    body_substeps: in total
    """
    __slots__ = ('divisor', 'substeps', 'waited', 'behind', 'lost', 'body_substeps')
    divisor: int
    substeps: int
    waited: int
    behind: float
    lost: float
    body_substeps: int


class BodyState(Record):
    """Values of lr_body_state.

    noise_seed: read only: ignored by lr_body_set_state
    position: m, of the centre of mass, world frame
    orientation: unit quaternion x y z w, body to world
    linear_velocity: m/s, of the centre of mass, world frame
    angular_velocity: rad/s, world frame
    scale: 0.001 to 1000
    age: s, 0 to 1e9
    sleep_state: `SleepState`; read only
    user: as in lr_body_desc
    """
    __slots__ = ('noise_seed', 'position', 'orientation', 'linear_velocity', 'angular_velocity', 'scale', 'age', 'sleep_state', 'user')
    noise_seed: int
    position: NDArray[Any]
    orientation: NDArray[Any]
    linear_velocity: NDArray[Any]
    angular_velocity: NDArray[Any]
    scale: float
    age: float
    sleep_state: SleepState
    user: int
    _enums = {'sleep_state': SleepState}


class BatchForce(Record):
    """Forces on every body of a batch, until changed. All default to 0; each component up to 1e9 in magnitude.

    force: N, world frame
    torque: N m, world frame
    acceleration: m/s^2, world frame; of the body, whatever its mass
    angular_acceleration: rad/s^2, world frame
    body_force: N, body frame
    body_torque: N m, body frame
    body_acceleration: m/s^2, body frame
    body_angular_acceleration: rad/s^2, body frame
    """
    __slots__ = ('force', 'torque', 'acceleration', 'angular_acceleration', 'body_force', 'body_torque', 'body_acceleration', 'body_angular_acceleration')
    force: NDArray[Any]
    torque: NDArray[Any]
    acceleration: NDArray[Any]
    angular_acceleration: NDArray[Any]
    body_force: NDArray[Any]
    body_torque: NDArray[Any]
    body_acceleration: NDArray[Any]
    body_angular_acceleration: NDArray[Any]


class ColliderState(Record):
    """Values of lr_collider_state.

    kind: `ColliderKind`
    position: m, world frame
    orientation: unit quaternion x y z w, collider to world
    linear_velocity: m/s, that lasts until changed; 0 while `MoveMode.TO` is pending
    angular_velocity: rad/s, world frame, that lasts until changed; 0 while `MoveMode.TO` is pending
    friction
    restitution
    layers
    flags: 0
    """
    __slots__ = ('kind', 'position', 'orientation', 'linear_velocity', 'angular_velocity', 'friction', 'restitution', 'layers', 'flags')
    kind: ColliderKind
    position: NDArray[Any]
    orientation: NDArray[Any]
    linear_velocity: NDArray[Any]
    angular_velocity: NDArray[Any]
    friction: float
    restitution: float
    layers: int
    flags: int
    _enums = {'kind': ColliderKind}


class BatchContact(Record):
    """How bodies of a batch collide. A contact uses the geometric mean of both frictions and the larger restitution. A body
    collides as its hull, reduced to at most 32 points, or as an ellipsoid if its asset is one.

    layers: bits: collides with colliders that share at least one; default all; 0: none
    friction: coefficient of Coulomb friction, 0 to 10; default 0.5
    restitution: speed after an impact over speed before it, 0 to 1; default 0.1
    rolling_resistance: moment against rolling and spinning over normal force times lever, 0 to 10; default 0.05. The lever is the geometric mean of reach and half the thickness: of a sphere, its radius
    flags: bits: `ContactFlags.NEVER_SLEEP`; default 0
    ground_effect: air cushion under a sheet that settles on a plane or heightfield, as a share of theory, 0 to 1; default 0. docs/maintainers/contact.md
    min_thickness: m, at scale 1, -1 to 10: sheets thinner than this meet other bodies as if they were so thick, at most a tenth of their reach; 0: 1/32 of it, at most 1.25 mm; below 0: as thick as they are, for decks of cards; default 0
    """
    __slots__ = ('layers', 'friction', 'restitution', 'rolling_resistance', 'flags', 'ground_effect', 'min_thickness')
    layers: int
    friction: float
    restitution: float
    rolling_resistance: float
    flags: ContactFlags
    ground_effect: float
    min_thickness: float
    _enums = {'flags': ContactFlags}


class BatchRules(Record):
    """When the bodies of a batch end. Diverged bodies end under any rules, unless lr_batch_set_divergence_policy holds
    them.

    action: `EndAction`; default `EndAction.DESTROY`
    max_age: s, up to 1e9; default 0: no limit
    volume_count: elements of `volumes` in use; default 0
    volumes: tested with the centre of mass
    """
    __slots__ = ('action', 'max_age', 'volume_count', 'volumes')
    action: EndAction
    max_age: float
    volume_count: int
    volumes: NDArray[Any]
    _enums = {'action': EndAction}


class Emitter(Record):
    """How bodies of a batch spawn. Random values depend only on the world's seed, the body's noise seed, and the number of
    times it has respawned.

    shape: `EmitterShape`; default `EmitterShape.POINT`
    position: m, centre of the shape; default 0
    orientation: of the shape, x y z w, normalised by the call; default 0 0 0 1
    size: m, half extents or semi-axes along the shape's own axes, 0 to 1e9; default 0
    pose: `EmitterPose`, of the bodies; default `EmitterPose.RANDOM`
    body_orientation: body to world, normalised by the call; default 0 0 0 1
    direction: of the velocity, world frame, any length but 0; default 0, -1, 0
    spread: rad, half angle of a cone about `direction`, filled evenly, 0 to pi; default 0
    speed_min: m/s, uniform in this range; default 0
    speed_max: m/s, uniform in this range; default 0
    spin_min: rad/s, uniform in this range, about a random axis; default 0
    spin_max: rad/s, uniform in this range, about a random axis; default 0
    scale_min: uniform in this range; default 1
    scale_max: uniform in this range; default 1
    rate: spawns per second, 0 to 1e9; default 0: bodies respawn, but none are added
    burst_interval: s between bursts, >= 1e-4
    burst_count: spawns in each burst; default 0: no bursts
    """
    __slots__ = ('shape', 'position', 'orientation', 'size', 'pose', 'body_orientation', 'direction', 'spread', 'speed_min', 'speed_max', 'spin_min', 'spin_max', 'scale_min', 'scale_max', 'rate', 'burst_interval', 'burst_count')
    shape: EmitterShape
    position: NDArray[Any]
    orientation: NDArray[Any]
    size: NDArray[Any]
    pose: EmitterPose
    body_orientation: NDArray[Any]
    direction: NDArray[Any]
    spread: float
    speed_min: float
    speed_max: float
    spin_min: float
    spin_max: float
    scale_min: float
    scale_max: float
    rate: float
    burst_interval: float
    burst_count: int
    _enums = {'shape': EmitterShape, 'pose': EmitterPose}


class BatchCounts(Record):
    """Numbers of bodies that rules ended and the emitter spawned in the last step, and totals since the batch was created.
    lr_world_get_events names the bodies.

    spawned: by rate and bursts
    destroyed: by the rules
    respawned
    missed: spawns dropped for lack of room
    by_divergence: Why bodies ended: the first cause that applied, in this order. diverged: lr_batch_set_divergence_policy
    by_age
    by_volume
    diverged: bodies that diverged in the last step, held or ended
    total_spawned: including lr_batch_spawn, lr_batch_spawn_box
    total_destroyed
    total_respawned
    total_missed
    total_diverged
    """
    __slots__ = ('spawned', 'destroyed', 'respawned', 'missed', 'by_divergence', 'by_age', 'by_volume', 'diverged', 'total_spawned', 'total_destroyed', 'total_respawned', 'total_missed', 'total_diverged')
    spawned: int
    destroyed: int
    respawned: int
    missed: int
    by_divergence: int
    by_age: int
    by_volume: NDArray[Any]
    diverged: int
    total_spawned: int
    total_destroyed: int
    total_respawned: int
    total_missed: int
    total_diverged: int


class Aerodynamics(Record):
    """Coefficients of the quasi-steady loads (`LoadModel.AERODYNAMIC`) at scale 1; equations: docs/maintainers/physics.md,
    AERODYNAMIC. All loads act at `center`, along `axes`, which rotate with the body. Arrays hold one value per axis.
    Symbols: v is the velocity through the fluid and w the spin, both along the axes; s = |v|; (i, j, k) are cyclic; d is
    lr_asset_info.length_d; rho and nu are the fluid's density and kinematic viscosity.

    axes: rows: unit vectors in the body frame, right-handed
    drag: Drag -1/2 rho sum_i (v_i/s)^2 [drag_i + drag_blunt_i Re/(Re + 8710)] s v with Re = s d/nu, and along each axis -rho [drag_layer_i sqrt(nu s) + drag_stokes_i nu] v_i. All >= 0. m^2, drag coefficient times area
    drag_blunt: m^2, the part of rounded bodies, which grows with the Reynolds number
    drag_layer: m^(3/2), boundary layer
    drag_stokes: m, creeping flow
    lift: Lift rho G x v with G_k = spin_lift_k w_k - lift_k v_i v_j/s. m^2, positive where the body is thinner along j than along i
    spin_lift: m^3
    lift_moment: ignored since 0.3
    spin_drag: Couple -rho (spin_drag_k |w| + spin_drag_stream_k s + spin_drag_layer_k (nu (s + |w| d/2))^(1/2) + spin_drag_stokes_k nu) w_k. All >= 0. In |w| each axis counts by its spin_drag. m^5
    spin_drag_stream: m^4
    spin_drag_stokes: m^3
    intensity: velocity fluctuations in the body's own wake, per axis, over s. Above 0.4, gains included, it acts as 0.4: a stronger wake would feed itself
    length: m: the fluctuations are correlated over length/s
    wake_reynolds: scales the fluctuations by Re/(Re + wake_reynolds): slow wakes are laminar
    broadside: 0 to 1: the fluctuations grow with sum_i broadside_i (v_i/s)^2
    lift_stall: ignored since 0.3
    lift_moment_stalled: ignored since 0.3
    roll_damping: ignored since 0.3
    center: m, where the loads act, from the centre of buoyancy, body frame; within 2 d; default 0
    plate_lift: A plate whose normal n is the axis with the largest broadside, with the part v_n of the stream along it and v_t in the plate. The normal force is -1/2 rho N; attached, N = plate_lift |v_t| v_n + plate_vortex |v_n| v_n; separated, N = plate_drag s v_n (1 + 0.8 v_t^2/s^2); half of each where v_n^2/s^2 is plate_stall. A stream along axis i of the plate has the values with index i. m^2, >= 0
    plate_vortex: m^2, >= 0
    plate_stall: 0 to 1
    plate_separated_shedding: This share of the added momentum along n, 0 to 1, does not move with the body while the stream is separated and sheds vortices: it reduces the Munk moment.
    plate_drag: m^2, >= 0: drag coefficient broadside times area
    start_drag: >= 0: adds to N start_drag plate_drag |u - v| ((v - u) . v/s^2) v_n
    wake_length: Memory: u follows v at the rate max(s, |u|)/(wake_lag wake_length). Attached, N takes wake_share of its stream from u. m, > 0
    wake_lag: > 0
    wake_share: 0 to 1
    strouhal: Vortex shedding above the Reynolds number shedding_reynolds of wake_length: an oscillator q in the plate with the frequency strouhal s/wake_length and the moment rho v_n^2 n x (shedding_moment q + shedding_rate_moment r), r the rate of q over 2 pi times the frequency. It starts from the fluctuations. At shedding_reynolds and below, the wake remembers for 2.5 times as long, and the stream stalls later: 1/plate_stall - 1 counts 0.4 times.
    shedding_growth: >= 0
    shedding_reynolds: >= 0
    shedding_noise: >= 0: of r by the fluctuations
    shedding_moment: m^3
    shedding_rate_moment: m^3
    spin_drag_layer: m^(7/2), boundary layer: see spin_drag
    """
    __slots__ = ('axes', 'drag', 'drag_blunt', 'drag_layer', 'drag_stokes', 'lift', 'spin_lift', 'lift_moment', 'spin_drag', 'spin_drag_stream', 'spin_drag_stokes', 'intensity', 'length', 'wake_reynolds', 'broadside', 'lift_stall', 'lift_moment_stalled', 'roll_damping', 'center', 'plate_lift', 'plate_vortex', 'plate_stall', 'plate_separated_shedding', 'plate_drag', 'start_drag', 'wake_length', 'wake_lag', 'wake_share', 'strouhal', 'shedding_growth', 'shedding_reynolds', 'shedding_noise', 'shedding_moment', 'shedding_rate_moment', 'spin_drag_layer')
    axes: NDArray[Any]
    drag: NDArray[Any]
    drag_blunt: NDArray[Any]
    drag_layer: NDArray[Any]
    drag_stokes: NDArray[Any]
    lift: NDArray[Any]
    spin_lift: NDArray[Any]
    lift_moment: NDArray[Any]
    spin_drag: NDArray[Any]
    spin_drag_stream: NDArray[Any]
    spin_drag_stokes: NDArray[Any]
    intensity: float
    length: float
    wake_reynolds: float
    broadside: NDArray[Any]
    lift_stall: float
    lift_moment_stalled: NDArray[Any]
    roll_damping: NDArray[Any]
    center: NDArray[Any]
    plate_lift: NDArray[Any]
    plate_vortex: NDArray[Any]
    plate_stall: NDArray[Any]
    plate_separated_shedding: float
    plate_drag: float
    start_drag: float
    wake_length: float
    wake_lag: float
    wake_share: float
    strouhal: float
    shedding_growth: float
    shedding_reynolds: float
    shedding_noise: float
    shedding_moment: float
    shedding_rate_moment: float
    spin_drag_layer: NDArray[Any]


class BodyLoads(Record):
    """The loads of the flow on a body and the state of its wake, for inspectors and debug arrows: what AERODYNAMIC loads do
    to it now. Weight, buoyancy and added mass are not among them, but what turning costs where added momentum is left in
    the wake is. World frame.

    station_count: 1 to 8: 1 where one stream describes the shape; 0: no AERODYNAMIC loads
    stream: m/s, velocity of the fluid relative to the body, its own fluctuations included
    wake: m/s, the stream that the wake remembers: it follows `stream`
    shedding: q of the vortex shedding (lr_aerodynamics), up to 1.4; 0: a steady wake
    force: N, sum of all stations
    torque: N m, about the centre of mass, with the couples of spin and shed vortices
    station_position: m, x y z of each station
    station_force: N, x y z of each station's force
    """
    __slots__ = ('station_count', 'stream', 'wake', 'shedding', 'force', 'torque', 'station_position', 'station_force')
    station_count: int
    stream: NDArray[Any]
    wake: NDArray[Any]
    shedding: NDArray[Any]
    force: NDArray[Any]
    torque: NDArray[Any]
    station_position: NDArray[Any]
    station_force: NDArray[Any]
