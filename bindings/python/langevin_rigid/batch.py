# SPDX-License-Identifier: MIT
"""Batches: all bodies of one asset with the same settings."""
from __future__ import annotations

import ctypes
import weakref
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Tuple

import numpy as np

from . import _native as native
from ._records import Aerodynamics, BatchRules, Emitter
from ._plain import BatchPlain
from ._structs import address, as_fields, elements, init, integer, scalars, takes, vectors
from .enums import ForceFrame, ForceMode, TransformFormat
from .view import View

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Unpack

    from ._options import AerodynamicsOptions, TurbulenceTableOptions
    from .asset import Asset

SHAPES = {
    TransformFormat.POSITION_QUATERNION: (7,), TransformFormat.POSITION_QUATERNION_SCALE: (8,), TransformFormat.MATRIX_3X4_ROW_MAJOR: (3, 4),
    TransformFormat.MATRIX_3X4_COLUMN_MAJOR: (4, 3), TransformFormat.MATRIX_4X4_ROW_MAJOR: (4, 4), TransformFormat.MATRIX_4X4_COLUMN_MAJOR: (4, 4),
}


class Batch(BatchPlain):
    """A batch of bodies, created by `World.create_batch`. It lives until `destroy` or the end of its world."""

    def __init__(self, world: Any, handle: int, asset: "Asset") -> None:
        self.world = world
        self.id = handle
        self.asset = asset
        self._exports: "weakref.WeakSet[Any]" = weakref.WeakSet()

    def destroy(self) -> None:
        """Destroys the batch with all its bodies. Arrays of its views must be deleted first."""
        if len(self._exports) and not self.world.closed:
            raise BufferError(f"{len(self._exports)} arrays still use the memory of this batch: delete them and their view first")
        self._change("lr_batch_destroy")

    def __repr__(self) -> str:
        return f"<Batch {self.id:#x} of {self.asset!r}>"

    # Bodies.

    def create(self, count: Optional[int] = None, *, position: Any = None, orientation: Any = None, linear_velocity: Any = None,
               angular_velocity: Any = None, scale: Any = None, age: Any = None, noise_seed: Any = None,
               user: Any = None) -> NDArray[Any]:
        """Creates bodies, all or none, and returns their ids.

        Each argument is a single value, or an array with a value for each body: (count, 3) for vectors, (count, 4) for
        quaternions x, y, z, w, (count,) for the others. count: 1, unless given or known from an array.

        position: m, of the centre of mass; 0. orientation: body to world; 0 0 0 1. linear_velocity: m/s, angular_velocity:
        rad/s, world frame; 0. scale: 0.001 to 1000; 1. age: s; 0. noise_seed: selects a body's random numbers; 0: the world's
        next. user: a 64-bit number of yours, returned in states, views, events and ray hits; 0.
        """
        wide = {"position": (position, 3), "orientation": (orientation, 4), "linear_velocity": (linear_velocity, 3),
                "angular_velocity": (angular_velocity, 3)}
        narrow = {"scale": scale, "age": age, "noise_seed": noise_seed, "user": user}
        if count is None:
            lengths = {name: len(v) for name, (v, _) in wide.items() if v is not None and np.ndim(v) == 2}
            lengths.update((name, len(v)) for name, v in narrow.items() if v is not None and np.ndim(v) == 1)
            if len(set(lengths.values())) > 1:
                raise ValueError(f"arrays of different lengths: {lengths}")
            count = max(lengths.values(), default=1)
        descs = elements(native.lr_body_desc, count)
        for name, (values, width) in wide.items():
            if values is not None:
                descs[name] = vectors(values, width, count, name)
        for name, value in narrow.items():
            if value is not None:
                kind = {"noise_seed": ctypes.c_uint32, "user": ctypes.c_uint64}.get(name, ctypes.c_float)
                descs[name] = scalars(value, kind, count, name)
        ids = np.zeros(count, np.uint64)
        self.world._create("lr_body_create", self.id, address(descs, native.lr_body_desc), count, address(ids, ctypes.c_uint64))
        return ids

    def view(self) -> View:
        """The state of all bodies, as arrays without a copy."""
        struct = init(native.lr_batch_view)
        self._ask("lr_batch_get_view", ctypes.byref(struct))
        return View(self, struct)

    def __len__(self) -> int:
        return self.view().count

    @property
    def ids(self) -> NDArray[Any]:
        """Ids of all bodies, in the order of the view; a copy."""
        return self.view().ids.copy()

    def transforms(self, format: int = TransformFormat.MATRIX_4X4_ROW_MAJOR, out: Optional[NDArray[Any]] = None,
                   first: Optional[int] = None) -> NDArray[Any]:
        """The transforms of all bodies, or of the `first` bodies, in the order of the view.

        out: a float32 array to write into, as many transforms as fit. Each transform is contiguous; the stride between them
        is free, so a field of a structured array works. Returns the part of it that was written.
        Draw a mesh with its origin at the centre of mass (`asset.info.center_of_mass`).
        """
        format = TransformFormat(format)
        if first is not None:
            first = integer(first, ctypes.c_uint32, "first")
        shape = SHAPES[format]
        if out is None:
            out = np.empty((len(self) if first is None else min(first, len(self)), *shape), np.float32)
        stride = self._stride(out, int(np.prod(shape)))
        written = ctypes.c_uint32()
        count = len(out) if first is None else min(first, len(out))
        self._ask("lr_batch_write_transforms", int(format), out.ctypes.data, stride, count, ctypes.byref(written))
        return out[:written.value]

    def velocities(self) -> Tuple[NDArray[Any], NDArray[Any]]:
        """Linear velocities, m/s, and angular velocities, rad/s, world frame, in the order of the view: two arrays of shape
        (count, 3). Bodies of a waiting batch have those of their last step."""
        out = np.empty((len(self), 6), np.float32)
        self._ask("lr_batch_write_velocities", out.ctypes.data, 0, len(out), None)
        return out[:, :3], out[:, 3:]

    @staticmethod
    def _stride(out: NDArray[Any], floats: int) -> int:
        if not isinstance(out, np.ndarray) or out.dtype != np.float32:
            raise TypeError(f"out: expected a float32 array, not {getattr(out, 'dtype', type(out).__name__)}")
        if not out.flags.writeable:
            raise ValueError("out: the array is read-only")
        inner = 4
        for size, step in zip(out.shape[:0:-1], out.strides[:0:-1]):
            if size != 1 and step != inner and len(out):
                raise ValueError("out: each element must be contiguous, in C order")
            inner *= size
        if out.ndim < 2 or inner != 4 * floats:
            raise ValueError(f"out: shape {out.shape}, but an element has {floats} numbers")
        if len(out) > 1 and out.strides[0] < inner:
            raise ValueError("out: elements overlap or run backwards")
        return out.strides[0] if len(out) > 1 else 0

    def bounds(self) -> Optional[Tuple[NDArray[Any], NDArray[Any]]]:
        """The corners of a box around all bodies, m; None without bodies."""
        low, high = np.empty(3, np.float32), np.empty(3, np.float32)
        self._ask("lr_batch_get_bounds", address(low, ctypes.c_float), address(high, ctypes.c_float))
        return (low, high) if low[0] <= high[0] else None

    # # Forces and loads.

    def add_forces(self, force: Any = None, torque: Any = None, mode: int = ForceMode.FORCE, frame: int = ForceFrame.WORLD,
                   first: int = 0) -> None:
        """Adds forces to bodies [first, first + count) in the order of the view: arrays of shape (count, 3), or three arrays of
        shape (count,). Contiguous float32 is not copied."""
        keep: List[Any] = []
        arrays = init(native.lr_force_arrays)
        arrays.mode, arrays.frame, arrays.first = int(mode), int(frame), integer(first, ctypes.c_uint32, "first")
        given = {"force": components(force, "force"), "torque": components(torque, "torque")}
        strides = {step for value in given.values() if value is not None for step in [value[1]]}
        counts = {len(value[0][0]) for value in given.values() if value is not None}
        if len(counts) > 1:
            raise ValueError(f"force and torque of different lengths: {sorted(counts)}")
        for name, value in given.items():
            if value is None:
                continue
            parts, _ = value
            if len(strides) > 1:
                parts = [np.ascontiguousarray(part) for part in parts]
            keep.extend(parts)
            getattr(arrays, name)[:] = [address(part, ctypes.c_float) for part in parts]
        arrays.count = counts.pop() if counts else 0
        arrays.stride = strides.pop() if len(strides) == 1 else 0
        self._change("lr_batch_add_forces", ctypes.byref(arrays))

    @takes("lr_aerodynamics")
    def set_aerodynamics(self, coefficients: Optional[Aerodynamics] = None, **changes: "Unpack[AerodynamicsOptions]") -> None:
        """Replaces the asset's coefficients, all (a record) or some (keywords). Without arguments, restores the asset's."""
        fields = dict(as_fields(coefficients)) if coefficients is not None else {}
        if changes and not fields:
            fields = self.aerodynamics.as_dict()
        self._set("lr_batch_set_aerodynamics", native.lr_aerodynamics, {**fields, **changes})

    @takes("lr_turbulence_table", "count")
    def set_turbulence_table(self, **table: "Unpack[TurbulenceTableOptions]") -> None:
        """Replaces the asset's k-epsilon samples. Without keywords, restores the asset's."""
        if table:
            for name in ("chi", "epsilon"):
                if table.get(name) is None:
                    raise TypeError(f"a turbulence table needs {name}")
            if np.size(table["chi"]) != np.size(table["epsilon"]):
                raise ValueError("chi and epsilon have different lengths")
            table = {**table, "count": np.size(table["chi"])}  # type: ignore[typeddict-unknown-key,misc]
        self._set("lr_batch_set_turbulence_table", native.lr_turbulence_table, table)

    @property
    def turbulence_table(self) -> Dict[str, Any]:
        """The k-epsilon samples in use, as keywords of `set_turbulence_table`: chi and epsilon are float32 arrays."""
        table = init(native.lr_turbulence_table)
        self._ask("lr_batch_get_turbulence_table", ctypes.byref(table), None, None, 0)
        samples = {name: np.empty(table.count, np.float32) for name in ("chi", "epsilon")}
        self._ask("lr_batch_get_turbulence_table", ctypes.byref(table), *(address(part, ctypes.c_float) for part in samples.values()),
                  table.count)
        return {**samples, **{name: getattr(table, name) for name in ("dt", "u0", "l", "c0", "stationary")}}

    # Contact.

    def set_body_contact(self, other: "Batch", enabled: bool = True) -> None:
        """Switches contact with the bodies of another batch, or among those of this batch."""
        self._change("lr_batch_set_body_contact", self._beside(other), int(enabled))

    def body_contact(self, other: "Batch") -> bool:
        enabled = ctypes.c_int32()
        self._ask("lr_batch_get_body_contact", self._beside(other), ctypes.byref(enabled))
        return bool(enabled.value)

    def _beside(self, other: "Batch") -> int:
        """The other batch's handle. Handles of another world would name a batch of this one."""
        if other.world is not self.world:
            raise ValueError("other: a batch of another world")
        return other.id

    # # Emitter and rules.

    def _get_if_present(self, name: str, struct: Any, record: Any) -> Any:
        value, present = init(struct), ctypes.c_int32()
        self._ask(name, ctypes.byref(value), ctypes.byref(present))
        return record.read(value) if present.value else None

    @property
    def rules(self) -> Optional[BatchRules]:
        """The rules, or None."""
        return self._get_if_present("lr_batch_get_rules", native.lr_batch_rules, BatchRules)

    @property
    def emitter(self) -> Optional[Emitter]:
        """The emitter, or None."""
        return self._get_if_present("lr_batch_get_emitter", native.lr_emitter_desc, Emitter)

    def emit(self, count: int) -> NDArray[Any]:
        """Spawns bodies from the emitter now, all or none, and returns their ids."""
        ids = np.zeros(count, np.uint64)
        self.world._create("lr_batch_spawn", self.id, count, address(ids, ctypes.c_uint64))
        return ids

    def spawn_box(self, low: ArrayLike, high: ArrayLike, count: int) -> NDArray[Any]:
        """Spawns bodies at rest, evenly in a box and turned at random, without an emitter, all or none; returns their ids."""
        corners = np.stack([vectors(low, 3, 1, "low")[0], vectors(high, 3, 1, "high")[0]])
        ids = np.zeros(count, np.uint64)
        self.world._create("lr_batch_spawn_box", self.id, address(corners[0], ctypes.c_float), address(corners[1], ctypes.c_float), count,
                     address(ids, ctypes.c_uint64))
        return ids


def components(values: Any, name: str) -> Optional[Tuple[List[NDArray[Any]], int]]:
    """x, y and z of vectors, and the stride between bodies in bytes."""
    if values is None:
        return None
    if isinstance(values, (tuple, list)) and len(values) == 3 and all(isinstance(v, np.ndarray) and v.ndim == 1 for v in values):
        parts = [np.asarray(v, np.float32) for v in values]
    else:
        array = np.asarray(values, np.float32)
        if array.ndim != 2 or array.shape[1] != 3:
            raise ValueError(f"{name}: shape {array.shape}, but expected (count, 3) or three arrays of (count,)")
        parts = [array[:, i] for i in range(3)]
    if len({len(part) for part in parts}) > 1:
        raise ValueError(f"{name}: components of different lengths")
    steps = {part.strides[0] for part in parts}
    if len(parts[0]) > 1 and (len(steps) > 1 or min(steps) < 4 or min(steps) % 4):
        parts = [np.ascontiguousarray(part) for part in parts]
    return parts, parts[0].strides[0] if len(parts[0]) > 1 else 4
