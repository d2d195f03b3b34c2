# SPDX-License-Identifier: MIT
# Generated from include/langevin_rigid.h by bindings/generator/python.py: do not edit.

"""Types of keywords for calls: only type checkers read them."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Sequence, TypedDict

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


class EllipsoidOptions(TypedDict, total=False):
    """Keywords for lr_ellipsoid_desc."""
    semi_axes: ArrayLike
    density: float
    fluid_density: float
    fluid_viscosity: float
    intensity: float
    center_of_mass: ArrayLike


class WorldOptions(TypedDict, total=False):
    """Keywords for lr_world_desc."""
    worker_count: int
    seed: int
    gravity: ArrayLike
    fluid_density: float
    simd_target: int
    fluid_viscosity: float
    checks: int


class GustsOptions(TypedDict, total=False):
    """Keywords for lr_gusts_desc."""
    seed: int
    direction: ArrayLike
    rms: float
    angle_rms: float
    integral_time: float


class VortexOptions(TypedDict, total=False):
    """Keywords for lr_vortex_desc."""
    core: int
    position: ArrayLike
    axis: ArrayLike
    velocity: ArrayLike
    circulation: float
    core_radius: float
    outer_radius: float
    half_length: float


class BlowerOptions(TypedDict, total=False):
    """Keywords for lr_blower_desc."""
    position: ArrayLike
    direction: ArrayLike
    side: ArrayLike
    velocity: ArrayLike
    speed: float
    nozzle_radius: float
    half_length: float
    range: float
    spread: float


class TurbulenceOptions(TypedDict, total=False):
    """Keywords for lr_turbulence_desc."""
    seed: int
    octaves: int
    velocity: ArrayLike
    rms: float
    integral_length: float
    eddy_life: float


class WindGridOptions(TypedDict, total=False):
    """Keywords for lr_wind_grid_desc."""
    outside: int
    position: ArrayLike
    velocity: ArrayLike
    spacing: ArrayLike
    counts: ArrayLike
    frames: int
    frame_time: float
    samples: Any


class GroundWindOptions(TypedDict, total=False):
    """Keywords for lr_ground_wind_desc."""
    position: ArrayLike
    normal: ArrayLike
    velocity: ArrayLike
    roughness_length: float
    reference_height: float


class WaveOptions(TypedDict, total=False):
    """Keywords for lr_wave."""
    direction: ArrayLike
    length: float
    amplitude: float
    phase: float


class WaterOptions(TypedDict, total=False):
    """Keywords for lr_water_desc."""
    position: ArrayLike
    normal: ArrayLike
    density: float
    viscosity: float
    current: ArrayLike
    reach: float
    waves: Sequence[WaveOptions]


class RecordingOptions(TypedDict, total=False):
    """Keywords for lr_recording_desc."""
    flags: int
    hash_interval: int


class BatchOptions(TypedDict, total=False):
    """Keywords for lr_batch_desc."""
    load_model: int
    clock: int
    table_end: int
    integrator: int
    damping_gain: float
    noise_gain: float
    variation: float


class LoadGainsOptions(TypedDict, total=False):
    """Keywords for lr_load_gains."""
    drag: float
    lift: float
    spin_drag: float
    turbulence: float


class BodyStateOptions(TypedDict, total=False):
    """Keywords for lr_body_state."""
    position: ArrayLike
    orientation: ArrayLike
    linear_velocity: ArrayLike
    angular_velocity: ArrayLike
    scale: float
    age: float
    user: int


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


class ColliderMotionOptions(TypedDict, total=False):
    """Keywords for lr_collider_motion."""
    mode: int
    collider: int
    position: ArrayLike
    orientation: ArrayLike
    linear_velocity: ArrayLike
    angular_velocity: ArrayLike


class MaterialOptions(TypedDict, total=False):
    """Keywords for lr_material."""
    layers: int
    friction: float
    restitution: float


class BatchContactOptions(TypedDict, total=False):
    """Keywords for lr_batch_contact."""
    layers: int
    friction: float
    restitution: float
    rolling_resistance: float
    flags: int
    ground_effect: float
    min_thickness: float


class KillVolumeOptions(TypedDict, total=False):
    """Keywords for lr_kill_volume."""
    shape: int
    side: int
    center: ArrayLike
    size: ArrayLike


class BatchRulesOptions(TypedDict, total=False):
    """Keywords for lr_batch_rules."""
    action: int
    max_age: float
    volumes: Sequence[KillVolumeOptions]


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
    plate_lift: ArrayLike
    plate_vortex: ArrayLike
    plate_stall: ArrayLike
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
    spin_drag_layer: ArrayLike


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


class TurbulenceTableOptions(TypedDict, total=False):
    """Keywords for lr_turbulence_table."""
    chi: Any
    epsilon: Any
    dt: float
    u0: float
    l: float
    c0: float
    stationary: int
