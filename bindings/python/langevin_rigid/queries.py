# SPDX-License-Identifier: MIT
"""Rays and overlap queries."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Optional

import numpy as np

from . import _native as native
from ._structs import address, elements, make, rows, vectors
from .enums import OverlapShape, RayFlags
from .errors import BufferTooSmallError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray

    from .batch import Batch


class QueryMixin:
    """Adds queries to `World`."""

    if TYPE_CHECKING:
        def _ask(self, name: str, *arguments: Any) -> None: ...

    def ray_cast(self, origins: "ArrayLike", directions: "ArrayLike", *, max_distance: Any = None,
                 flags: int = RayFlags.BODIES | RayFlags.COLLIDERS, batch: "Optional[Batch]" = None,
                 collider_layers: Any = None) -> NDArray[Any]:
        """The first hit of each ray. origins, directions: (3,) or (count, 3).

        Returns a structured array: body, user, collider, distance, position, normal. Without a hit, body and collider are 0.
        """
        starts, along = rows(origins, 3, "origins"), rows(directions, 3, "directions")
        count = max(len(starts), len(along)) if min(len(starts), len(along)) else 0
        rays = elements(native.lr_ray, count)
        rays["origin"], rays["direction"] = vectors(starts, 3, count, "origins"), vectors(along, 3, count, "directions")
        rays["flags"] = int(flags)
        if max_distance is not None:
            rays["max_distance"] = max_distance
        if batch is not None:
            rays["batch"] = batch.id
        if collider_layers is not None:
            rays["collider_layers"] = collider_layers
        hits = np.zeros(count, np.dtype(native.lr_ray_hit))
        self._ask("lr_world_ray_cast", address(rays, native.lr_ray), count, address(hits, native.lr_ray_hit))
        return hits

    def overlap_sphere(self, center: "ArrayLike", radius: float, batch: "Optional[Batch]" = None) -> NDArray[Any]:
        """The ids of all bodies that overlap a sphere."""
        return self._overlap(OverlapShape.SPHERE, batch, position=center, size=[radius] * 3)

    def overlap_box(self, center: "ArrayLike", half_extents: "ArrayLike", orientation: "ArrayLike" = (0, 0, 0, 1),
                    batch: "Optional[Batch]" = None) -> NDArray[Any]:
        """The ids of all bodies that overlap a box."""
        return self._overlap(OverlapShape.BOX, batch, position=center, size=half_extents, orientation=orientation)

    def _overlap(self, shape: int, batch: "Optional[Batch]", **fields: Any) -> NDArray[Any]:
        desc = make(native.lr_overlap_desc, {**fields, "shape": int(shape), "batch": None if batch is None else batch.id}, [])
        bodies, count = np.empty(256, np.uint64), ctypes.c_uint32()
        while True:
            try:
                self._ask("lr_world_overlap", ctypes.byref(desc), address(bodies, ctypes.c_uint64), bodies.size,
                          ctypes.byref(count))
                return bodies[:count.value].copy()
            except BufferTooSmallError:
                bodies = np.empty(count.value, np.uint64)
