# SPDX-License-Identifier: MIT
# Generated from include/langevin_rigid.h by bindings/generator/python.py: do not edit.

"""Types of what calls take as keywords, and of what they read back."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypedDict

import numpy as np

from ._record import Record
from .enums import Rest, SimdTarget

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class AerodynamicsOptions(TypedDict, total=False):
    """Keywords for lr_aerodynamics."""
    axes: ArrayLike
    drag: ArrayLike
    drag_blunt: ArrayLike
    drag_layer: ArrayLike
    drag_stokes: ArrayLike
    lift: ArrayLike
    spin_lift: ArrayLike
    lift_moment: ArrayLike
    spin_drag: ArrayLike
    spin_drag_stream: ArrayLike
    spin_drag_stokes: ArrayLike
    intensity: float
    length: float
    wake_reynolds: float
    broadside: ArrayLike
    lift_stall: float
    lift_moment_stalled: ArrayLike
    roll_damping: ArrayLike
    center: ArrayLike


class ContactOptions(TypedDict, total=False):
    """Keywords for lr_batch_contact."""
    layers: int
    friction: float
    restitution: float
    rolling_resistance: float
    flags: int
    ground_effect: float


class BatchOptions(TypedDict, total=False):
    """Keywords for lr_batch_desc."""
    load_model: int
    clock: int
    table_end: int
    integrator: int
    damping_gain: float
    noise_gain: float


class BatchForceOptions(TypedDict, total=False):
    """Keywords for lr_batch_force."""
    force: ArrayLike
    torque: ArrayLike
    acceleration: ArrayLike
    angular_acceleration: ArrayLike
    body_force: ArrayLike
    body_torque: ArrayLike
    body_acceleration: ArrayLike
    body_angular_acceleration: ArrayLike


class RulesOptions(TypedDict, total=False):
    """Keywords for lr_batch_rules."""
    action: int
    max_age: float
    volume_count: int
    volumes: ArrayLike


class StateOptions(TypedDict, total=False):
    """Keywords for lr_body_state."""
    position: ArrayLike
    orientation: ArrayLike
    linear_velocity: ArrayLike
    angular_velocity: ArrayLike
    scale: float
    age: float


class ColliderOptions(TypedDict, total=False):
    """Keywords for lr_collider_desc."""
    position: ArrayLike
    orientation: ArrayLike
    linear_velocity: ArrayLike
    angular_velocity: ArrayLike
    size: ArrayLike
    friction: float
    restitution: float
    layers: int
    flags: int
    spacing: ArrayLike
    vertices: Any
    indices: Any
    heights: Any


class MotionOptions(TypedDict, total=False):
    """Keywords for lr_collider_motion."""
    mode: int
    collider: int
    position: ArrayLike
    orientation: ArrayLike
    linear_velocity: ArrayLike
    angular_velocity: ArrayLike


class ColliderSurfaceOptions(TypedDict, total=False):
    """Keywords for lr_collider_surface."""
    layers: int
    friction: float
    restitution: float


class EllipsoidOptions(TypedDict, total=False):
    """Keywords for lr_ellipsoid_desc."""
    semi_axes: ArrayLike
    density: float
    fluid_density: float
    fluid_viscosity: float
    intensity: float
    center_of_mass: ArrayLike


class EmitterOptions(TypedDict, total=False):
    """Keywords for lr_emitter_desc."""
    shape: int
    position: ArrayLike
    orientation: ArrayLike
    size: ArrayLike
    pose: int
    body_orientation: ArrayLike
    direction: ArrayLike
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


class KillVolumeOptions(TypedDict, total=False):
    """Keywords for lr_kill_volume."""
    shape: int
    side: int
    center: ArrayLike
    size: ArrayLike


class LoadGainsOptions(TypedDict, total=False):
    """Keywords for lr_load_gains."""
    drag: float
    lift: float
    spin_drag: float
    turbulence: float


class RecordingOptions(TypedDict, total=False):
    """Keywords for lr_recording_desc."""
    flags: int
    hash_interval: int


class RigidOptions(TypedDict, total=False):
    """Keywords for lr_rigid_desc."""
    mass: float
    volume: float
    inertia: ArrayLike
    added_mass: ArrayLike
    center_of_buoyancy: ArrayLike
    fluid_density: float
    fluid_viscosity: float
    extents: ArrayLike
    intensity: float
    aerodynamics: Any


class SurfaceOptions(TypedDict, total=False):
    """Keywords for lr_surface_desc."""
    position: ArrayLike
    normal: ArrayLike
    density: float
    viscosity: float
    current: ArrayLike
    reach: float
    waves: ArrayLike


class TurbulenceTableOptions(TypedDict, total=False):
    """Keywords for lr_turbulence_table."""
    chi: Any
    epsilon: Any
    dt: float
    u0: float
    l: float
    c0: float
    stationary: int


class WaveOptions(TypedDict, total=False):
    """Keywords for lr_wave."""
    direction: ArrayLike
    length: float
    amplitude: float
    phase: float


class WindSourceOptions(TypedDict, total=False):
    """Keywords for lr_wind_source_desc."""
    position: ArrayLike
    direction: ArrayLike
    side: ArrayLike
    velocity: ArrayLike
    speed: float
    circulation: float
    size: float
    radius: float
    half_length: float
    range: float
    spread: float
    period: float
    reference_height: float
    octaves: int
    seed: int
    outside: int
    counts: ArrayLike
    frames: int
    spacing: ArrayLike
    samples: Any


class WorldOptions(TypedDict, total=False):
    """Keywords for lr_world_desc."""
    worker_count: int
    seed: int
    gravity: ArrayLike
    fluid_density: float
    simd_target: int
    fluid_viscosity: float
    checks: int


class Aerodynamics(Record):
    """Coefficients of the quasi-steady loads at scale 1; equations in docs/maintainers/physics.md, AERODYNAMIC. Everything acts at
    `center` along `axes`, which turn with the body. Arrays have a value for each axis. v: velocity through the fluid and w:
    spin, both along the axes; s = |v|; (i, j, k) cyclic; d: lr_asset_info.length_d; rho, nu: density and kinematic viscosity of
    the fluid.

    axes: rows: unit vectors in the body frame, right-handed
    drag: Drag -1/2 rho sum_i (v_i/s)^2 [drag_i + drag_blunt_i Re/(Re + 8710)] s v, Re = s d/nu, and along each axis -rho [drag_layer_i sqrt(nu s) + drag_stokes_i nu] v_i. All >= 0. m^2, drag coefficient times area
    drag_blunt: m^2, the part that grows with the Reynolds number: of rounded bodies
    drag_layer: m^(3/2), of the boundary layer
    drag_stokes: m, of creeping flow
    lift: Lift rho G x v, G_k = spin_lift_k w_k - lift_k v_i v_j/s. m^2, positive where the body is thinner along j than along i
    spin_lift: m^3
    lift_moment: m^3, moment rho lift_moment_k v_i v_j of that lift about k
    spin_drag: Couple -rho (spin_drag_k |w| + spin_drag_stream_k s + spin_drag_stokes_k nu) w_k. All >= 0. m^5
    spin_drag_stream: m^4
    spin_drag_stokes: m^3
    intensity: of the velocity of the fluid in the body's own wake: per axis `intensity` times s. More than 0.4, gains included, acts as 0.4: such a wake would feed itself
    length: m, correlated over length/s
    wake_reynolds: that velocity is less by Re/(Re + wake_reynolds): slow wakes are laminar
    broadside: Stall: sigma = sum_i broadside_i (v_i/s)^2 multiplies lift by 1 - lift_stall sigma and adds lift_moment_stalled_k sigma to lift_moment_k. 0 to 1
    lift_stall
    lift_moment_stalled: m^3
    roll_damping: Couple -rho g_k (g . w)/s, g_k = sqrt(roll_damping_k) v_k, on the part of the spin about the stream: a wing's roll. All >= 0. In a plane that spin is nought. m^4
    center: m, where all of it acts, from the centre of buoyancy, body frame; initially 0; within 2 d
    """
    __slots__ = ('axes', 'drag', 'drag_blunt', 'drag_layer', 'drag_stokes', 'lift', 'spin_lift', 'lift_moment', 'spin_drag', 'spin_drag_stream', 'spin_drag_stokes', 'intensity', 'length', 'wake_reynolds', 'broadside', 'lift_stall', 'lift_moment_stalled', 'roll_damping', 'center')
    axes: np.ndarray
    drag: np.ndarray
    drag_blunt: np.ndarray
    drag_layer: np.ndarray
    drag_stokes: np.ndarray
    lift: np.ndarray
    spin_lift: np.ndarray
    lift_moment: np.ndarray
    spin_drag: np.ndarray
    spin_drag_stream: np.ndarray
    spin_drag_stokes: np.ndarray
    intensity: float
    length: float
    wake_reynolds: float
    broadside: np.ndarray
    lift_stall: float
    lift_moment_stalled: np.ndarray
    roll_damping: np.ndarray
    center: np.ndarray


class AssetInfo(Record):
    """What an asset is. Matrices are row-major and symmetric.

    flags: `AssetFlags`
    name: UTF-8, ends with 0
    mass: kg
    volume: m^3
    density: kg/m^3
    center_of_mass: m, in the frame of the mesh: where the body origin lies in it
    center_of_buoyancy: m, from the centre of mass, body axes
    inertia: kg m^2, about the centre of mass, body axes
    added_mass: about the centre of mass, order vx vy vz wx wy wz, fluid density included: kg for the 3x3 block of v, kg m for the coupling, kg m^2 for the block of w
    fluid_density: kg/m^3, of the fluid it was baked in
    fluid_viscosity: m^2/s, kinematic
    length_d: m, characteristic length: the largest extent
    length_b: m, thickness
    length_l: m, turbulence length; see docs/maintainers/physics.md
    u0: m/s, fall velocity scale sqrt(|density ratio - 1| g b), paper Eq. 1
    reynolds: u0 d / viscosity
    c0: Kolmogorov constant of the Langevin model, paper Eq. 10
    turbulence_dt: s between table samples
    turbulence_count: number of table samples
    hull_vertex_count: 0 for an asset without a hull
    hull_triangle_count
    format_version: of the file; 0 for an asset without a file
    content_hash: of everything that matters for motion; equal for equal assets
    """
    __slots__ = ('flags', 'name', 'mass', 'volume', 'density', 'center_of_mass', 'center_of_buoyancy', 'inertia', 'added_mass', 'fluid_density', 'fluid_viscosity', 'length_d', 'length_b', 'length_l', 'u0', 'reynolds', 'c0', 'turbulence_dt', 'turbulence_count', 'hull_vertex_count', 'hull_triangle_count', 'format_version', 'content_hash')
    flags: int
    name: str
    mass: float
    volume: float
    density: float
    center_of_mass: np.ndarray
    center_of_buoyancy: np.ndarray
    inertia: np.ndarray
    added_mass: np.ndarray
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


class WorldInfo(Record):
    """What lr_world_info says.

    simd_target: what `SimdTarget.AUTO` became
    worker_count: as in the desc; with jobs what 0 became
    batch_count
    body_count
    substep_count: substeps since creation; the time index of the noise
    time: s since creation: the sum of all dt, in double
    memory_bytes: taken from the allocator at present
    collider_count
    awake_count: bodies that are not at rest: lr_body_set_rest
    """
    __slots__ = ('simd_target', 'worker_count', 'batch_count', 'body_count', 'substep_count', 'time', 'memory_bytes', 'collider_count', 'awake_count')
    simd_target: SimdTarget
    worker_count: int
    batch_count: int
    body_count: int
    substep_count: int
    time: float
    memory_bytes: int
    collider_count: int
    awake_count: int


class StepReport(Record):
    """What the last step did, and what it left out. Batches without bodies do not count.

    batches_stepped
    batches_waiting: not due, by their own divisors
    batches_passed_over: due, but the budget did not reach them
    body_substeps: done
    body_substeps_wanted: of the batches that were due, without a budget
    behind: s: how far the bodies that have waited longest are behind the world's time
    lost: s: the most that a batch lost in this step: bodies go in slow motion rather than in too long substeps
    """
    __slots__ = ('batches_stepped', 'batches_waiting', 'batches_passed_over', 'body_substeps', 'body_substeps_wanted', 'behind', 'lost')
    batches_stepped: int
    batches_waiting: int
    batches_passed_over: int
    body_substeps: int
    body_substeps_wanted: int
    behind: float
    lost: float


class BatchPace(Record):
    """How a batch keeps up with its world.

    divisor: as set
    substeps: in the last step of the world; 0: it waited
    waited: steps since it was last stepped
    behind: s: the same as time
    lost: s, in all: what its bodies' clocks are slow by
    body_substeps: in all
    """
    __slots__ = ('divisor', 'substeps', 'waited', 'behind', 'lost', 'body_substeps')
    divisor: int
    substeps: int
    waited: int
    behind: float
    lost: float
    body_substeps: int


class BodyState(Record):
    """What lr_body_state says.

    key: read only: ignored by lr_body_set_state
    position: m, of the centre of mass, world frame
    orientation: unit quaternion x y z w, body to world
    linear_velocity: m/s, of the centre of mass, world frame
    angular_velocity: rad/s, world frame
    scale: 0.001 to 1000
    age: s, 0 to 1e9
    resting: `Rest`; read only
    """
    __slots__ = ('key', 'position', 'orientation', 'linear_velocity', 'angular_velocity', 'scale', 'age', 'resting')
    key: int
    position: np.ndarray
    orientation: np.ndarray
    linear_velocity: np.ndarray
    angular_velocity: np.ndarray
    scale: float
    age: float
    resting: Rest


class ColliderState(Record):
    """What lr_collider_state says.

    kind: `ColliderKind`
    position: m, world frame
    orientation: unit quaternion x y z w, collider to world
    linear_velocity: m/s, that it has until told otherwise; 0 while `MoveMode.TO` is pending
    angular_velocity: rad/s, world frame; alike
    friction
    restitution
    layers
    flags: 0
    """
    __slots__ = ('kind', 'position', 'orientation', 'linear_velocity', 'angular_velocity', 'friction', 'restitution', 'layers', 'flags')
    kind: int
    position: np.ndarray
    orientation: np.ndarray
    linear_velocity: np.ndarray
    angular_velocity: np.ndarray
    friction: float
    restitution: float
    layers: int
    flags: int


class BatchContact(Record):
    """How the bodies of a batch meet colliders. Of a pair, friction is the geometric mean of both and restitution the larger.
    Bodies touch with their hull, reduced to 32 points at most, or as the ellipsoid that they are.

    layers: bit mask: colliders that are in one of these are met; initially all; 0: none
    friction: coefficient of Coulomb friction, 0 to 10; initially 0.5
    restitution: speed after over speed before an impact, 0 to 1; initially 0.1
    rolling_resistance: moment against rolling and spinning over normal force and a lever, 0 to 10; initially 0.05. The lever is the geometric mean of reach and half of the least width: a sphere's radius
    flags: `EventKind`; initially 0
    ground_effect: the air that a sheet must press away before it lies, 0 to 1 of what the flow over planes and heightfields gives in theory; initially 0. docs/maintainers/contact.md
    """
    __slots__ = ('layers', 'friction', 'restitution', 'rolling_resistance', 'flags', 'ground_effect')
    layers: int
    friction: float
    restitution: float
    rolling_resistance: float
    flags: int
    ground_effect: float


class BatchEvents(Record):
    """What rules and emitter did in the last step, and since the batch began.

    born: by rate and bursts
    destroyed: by the rules
    respawned
    missed: births for which there was no room
    by_not_finite: Why bodies ended: the first cause that held, in this order. bodies that have left physics: lr_batch_set_fault_policy
    by_age
    by_volume
    total_born: with those of lr_batch_emit
    total_destroyed
    total_respawned
    total_missed
    ended_ids: destroyed or respawned in the last step: destroyed + respawned of them, in no order
    born_ids: `born` of them
    faulted: bodies that have left physics in the last step, held or ended
    total_faulted: since the batch began
    """
    __slots__ = ('born', 'destroyed', 'respawned', 'missed', 'by_not_finite', 'by_age', 'by_volume', 'total_born', 'total_destroyed', 'total_respawned', 'total_missed', 'ended_ids', 'born_ids', 'faulted', 'total_faulted')
    born: int
    destroyed: int
    respawned: int
    missed: int
    by_not_finite: int
    by_age: int
    by_volume: np.ndarray
    total_born: int
    total_destroyed: int
    total_respawned: int
    total_missed: int
    ended_ids: np.ndarray
    born_ids: np.ndarray
    faulted: int
    total_faulted: int
