# SPDX-License-Identifier: MIT
"""The state of a batch as NumPy arrays without a copy."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Dict, Optional

import numpy as np

from .errors import StaleViewError

if TYPE_CHECKING:
    from numpy.typing import NDArray

SCALARS = {"scale": np.float32, "age": np.float32, "noise_seed": np.uint32, "ids": np.uint64, "user": np.uint64}


class Memory:
    """Memory of the library behind an array; it keeps the world alive."""

    __slots__ = ("__array_interface__", "handle", "__weakref__")

    def __init__(self, address: int, count: int, dtype: Any, handle: Any) -> None:
        self.__array_interface__ = {"data": (address, True), "shape": (count,), "typestr": np.dtype(dtype).str, "version": 3}
        self.handle = handle


class Vectors(tuple):
    """Arrays of components, with a value for each body: `x, y, z = view.position`, or `view.position.x`."""

    __slots__ = ()

    x = property(lambda self: self[0])
    y = property(lambda self: self[1])
    z = property(lambda self: self[2])
    w = property(lambda self: self[3])

    def stack(self, out: Optional[NDArray[Any]] = None) -> NDArray[Any]:
        """A copy of shape (count, components)."""
        return np.stack(self, axis=-1, out=out)

    def __array__(self, dtype: Any = None, copy: Any = None) -> NDArray[Any]:
        if copy is False:
            raise ValueError("each component has its own array: an array of vectors needs a copy")
        stacked = self.stack()
        return stacked if dtype is None else stacked.astype(dtype, copy=False)


class View:
    """Read-only arrays of all bodies of a batch, in the library's memory.

    Awake bodies come first, [0, awake_count), then sleeping ones. A view is valid until the next call that changes its world
    (a step, spawns, destroyed bodies, forces); then it raises `StaleViewError`: take another view. Arrays already taken from it
    can still be read safely, but their contents are undefined. Velocities: `Batch.velocities`.
    """

    def __init__(self, batch: Any, struct: Any) -> None:
        self._batch = batch
        self._changes = batch.world._changes
        self._struct = struct
        self._arrays: Dict[str, Any] = {}
        self.count: int = struct.count
        self.capacity: int = struct.capacity
        self.awake_count: int = struct.awake_count
        self.revision: int = struct.revision

    @property
    def is_stale(self) -> bool:
        return self._batch.world._handle is None or self._changes != self._batch.world._changes

    def _check(self) -> None:
        if self.is_stale:
            raise StaleViewError("the world has changed since this view was taken: take another one by Batch.view()")

    def _memory(self, pointer: Any, dtype: Any) -> NDArray[Any]:
        if self.count == 0:
            return np.empty(0, dtype)
        memory = Memory(ctypes.cast(pointer, ctypes.c_void_p).value or 0, self.count, dtype, self._batch.world._handle)
        self._batch._exports.add(memory)
        return np.asarray(memory)

    def _vectors(self, name: str) -> Vectors:
        self._check()
        if name not in self._arrays:
            self._arrays[name] = Vectors(self._memory(pointer, np.float32) for pointer in getattr(self._struct, name))
        return self._arrays[name]

    def _scalars(self, name: str) -> NDArray[Any]:
        self._check()
        if name not in self._arrays:
            self._arrays[name] = self._memory(getattr(self._struct, name), SCALARS[name])
        return self._arrays[name]

    @property
    def position(self) -> Vectors:
        """m, world frame."""
        return self._vectors("position")

    @property
    def orientation(self) -> Vectors:
        """Unit quaternions x, y, z, w, body to world."""
        return self._vectors("orientation")

    @property
    def scale(self) -> NDArray[Any]:
        return self._scalars("scale")

    @property
    def age(self) -> NDArray[Any]:
        """s. The age of a sleeping body is out of date here: `World.state` has it."""
        return self._scalars("age")

    @property
    def noise_seed(self) -> NDArray[Any]:
        """Noise seeds."""
        return self._scalars("noise_seed")

    @property
    def ids(self) -> NDArray[Any]:
        return self._scalars("ids")

    @property
    def user(self) -> NDArray[Any]:
        """The caller's own number of each body."""
        if not self._struct.user:  # no body of the batch has been given one
            self._check()
            return np.zeros(self.count, np.uint64)
        return self._scalars("user")

    def __len__(self) -> int:
        return self.count

    def __repr__(self) -> str:
        return f"<View of {self.count} bodies, {self.awake_count} awake{', stale' if self.is_stale else ''}>"


def turned(quaternions: NDArray[Any], vectors: NDArray[Any]) -> NDArray[Any]:
    """Vectors rotated by unit quaternions x, y, z, w."""
    axis, real = quaternions[..., :3], quaternions[..., 3:]
    twice = 2.0 * np.cross(axis, vectors)
    return vectors + real * twice + np.cross(axis, twice)
