# SPDX-License-Identifier: MIT
"""Simulates falling leaves, paper, petals and confetti, up to a million at a time, with the same bits on every machine.

    import langevin_rigid as lr

    asset = lr.Asset.load("leaf.lrb")
    with lr.World(seed=1) as world:
        batch = world.create_batch(asset, capacity=1000)
        batch.create(position=positions)
        for frame in range(60):
            world.step(1 / 60, substeps=2)
            matrices = batch.transforms()

SI units everywhere, right-handed frames, quaternions x, y, z, w. The whole C API is in `langevin_rigid._native`.
"""
from . import enums, errors
from ._library import library, library_path, version
from ._records import (Aerodynamics, AssetInfo, BatchContact, BatchCounts, BatchForce, BatchPace, BatchRules, BodyState, ColliderState,
                       Emitter, LoadGains, StepReport, Timings, Water, WorldInfo)
from ._version import __version__
from .air import WindSource
from .asset import Asset, check_asset
from .baker import bake, bake_card, bake_ellipsoid, bake_triangles, baker_path, inspect_asset
from .batch import Batch
from .callbacks import WaterQuery, WindQuery
from .contact import Collider, Events
from .enums import *  # noqa: F401,F403
from .errors import *  # noqa: F401,F403
from .recording import Recording
from .simd import simd_target_name, simd_targets
from .view import Vectors, View
from .world import World

__all__ = [
    "Aerodynamics", "Asset", "AssetInfo", "Batch", "BatchContact", "BatchCounts", "BatchForce", "BatchPace", "BatchRules", "BodyState",
    "Collider", "ColliderState", "Emitter", "Events", "LoadGains", "Recording", "StepReport", "Timings", "Vectors", "View", "Water",
    "WaterQuery", "WindQuery", "WindSource", "World", "WorldInfo", "__version__", "bake", "bake_card", "bake_ellipsoid",
    "bake_triangles", "baker_path", "check_asset", "inspect_asset", "library", "library_path", "simd_target_name", "simd_targets",
    "version",
]
__all__ += enums.__all__
__all__ += errors.__all__
