# SPDX-License-Identifier: MIT
"""Batches: all bodies of one asset in a world."""
from __future__ import annotations

import ctypes
import weakref
from typing import TYPE_CHECKING, Any, List, Mapping, Optional, Sequence, Tuple

import numpy as np

from . import _native as native
from ._fields import Aerodynamics, BatchContact, BatchEvents, BatchPace
from ._structs import address, as_fields, contiguous, elements, init, make, takes, vectors
from .enums import FaultPolicy, ForceMode, Frame, Transform
from .view import View

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._fields import (AerodynamicsOptions, BatchForceOptions, ContactOptions, EmitterOptions, KillVolumeOptions,
                          LoadGainsOptions, TurbulenceTableOptions)
    from .asset import Asset
    from .world import World

SHAPES = {
    Transform.POSITION_QUATERNION: (7,), Transform.POSITION_QUATERNION_SCALE: (8,), Transform.MATRIX_3X4_ROW_MAJOR: (3, 4),
    Transform.MATRIX_3X4_COLUMN_MAJOR: (4, 3), Transform.MATRIX_4X4_ROW_MAJOR: (4, 4), Transform.MATRIX_4X4_COLUMN_MAJOR: (4, 4),
}


class Batch:
    """Made by `World.create_batch`; it ends with its world, or by `destroy`."""

    def __init__(self, world: "World", handle: int, asset: "Asset") -> None:
        self.world = world
        self.id = handle
        self.asset = asset
        self._exports: "weakref.WeakSet[Any]" = weakref.WeakSet()

    def destroy(self) -> None:
        """Ends the batch with all its bodies. No array of its views may be left."""
        if len(self._exports) and not self.world.closed:
            raise BufferError(f"{len(self._exports)} arrays still look at this batch: delete them and their view first")
        self.world._change("lr_batch_destroy", self.id)

    def __repr__(self) -> str:
        return f"<Batch {self.id:#x} of {self.asset!r}>"

    # Bodies.

    def create(self, count: Optional[int] = None, *, position: Any = None, orientation: Any = None, linear_velocity: Any = None,
               angular_velocity: Any = None, scale: Any = None, age: Any = None, key: Any = None) -> np.ndarray:
        """Creates bodies, all or none, and returns their ids.

        Each value is one for all, or an array with one for each body: (count, 3) for vectors, (count, 4) for quaternions
        x, y, z, w, (count,) for the others. count: not needed where one of them is an array.

        position: m, of the centre of mass; 0. orientation: body to world; 0 0 0 1. linear_velocity: m/s, angular_velocity:
        rad/s, world frame; 0. scale: 0.001 to 1000; 1. age: s; 0. key: tells the noise of bodies apart; 0: the world's next.
        """
        wide = {"position": (position, 3), "orientation": (orientation, 4), "linear_velocity": (linear_velocity, 3),
                "angular_velocity": (angular_velocity, 3)}
        narrow = {"scale": scale, "age": age, "key": key}
        if count is None:
            lengths = {len(v) for v, _ in wide.values() if v is not None and np.ndim(v) == 2}
            lengths |= {len(v) for v in narrow.values() if v is not None and np.ndim(v) == 1}
            if len(lengths) > 1:
                raise ValueError(f"arrays of different lengths: {sorted(lengths)}")
            count = lengths.pop() if lengths else 1
        descs = elements(native.lr_body_desc, count)
        for name, (values, width) in wide.items():
            if values is not None:
                descs[name] = vectors(values, width, count, name)
        for name, value in narrow.items():
            if value is not None:
                kind = ctypes.c_uint32 if name == "key" else ctypes.c_float
                descs[name] = contiguous(value, kind, name)
        ids = np.zeros(count, np.uint64)
        self.world._change("lr_body_create", self.id, address(descs, native.lr_body_desc), count, address(ids, ctypes.c_uint64))
        return ids

    def view(self) -> View:
        """The state of all bodies, as arrays without a copy."""
        struct = init(native.lr_batch_view)
        self.world._ask("lr_batch_get_view", self.id, ctypes.byref(struct))
        return View(self, struct)

    def __len__(self) -> int:
        return self.view().count

    @property
    def ids(self) -> np.ndarray:
        """Of all bodies, in the order of the view; a copy."""
        return self.view().ids.copy()

    def transforms(self, format: int = Transform.MATRIX_4X4_ROW_MAJOR, out: Optional[np.ndarray] = None,
                   first: Optional[int] = None) -> np.ndarray:
        """The transforms of all bodies, in the order of the view; of `first` bodies where it is given.

        out: an array of float32 to write into, as many as fit; each without gaps, but with any distance from one
        to the next: a field of a structured array will do. Returns the part of it that was written.
        The mesh to be drawn must have its origin at the centre of mass (`asset.info.center_of_mass`).
        """
        format = Transform(format)
        shape = SHAPES[format]
        if out is None:
            out = np.empty((len(self) if first is None else min(first, len(self)), *shape), np.float32)
        stride = self._stride(out, int(np.prod(shape)))
        written = ctypes.c_uint32()
        count = len(out) if first is None else min(first, len(out))
        self.world._ask("lr_batch_write_transforms", self.id, int(format), out.ctypes.data, stride, count, ctypes.byref(written))
        return out[:written.value]

    @staticmethod
    def _stride(out: np.ndarray, floats: int) -> int:
        if out.dtype != np.float32 or not out.flags.writeable:
            raise TypeError(f"out: a writable array of float32 is wanted, not one of {out.dtype}")
        inner = 4
        for size, step in zip(out.shape[:0:-1], out.strides[:0:-1]):
            if size != 1 and step != inner and len(out):
                raise ValueError("out: each element must be without gaps, in C's order")
            inner *= size
        if out.ndim < 2 or inner != 4 * floats:
            raise ValueError(f"out: shape {out.shape}, but an element has {floats} numbers")
        if len(out) > 1 and out.strides[0] < inner:
            raise ValueError("out: elements overlap, or go backwards")
        return out.strides[0] if len(out) > 1 else 0

    # What acts on the bodies.

    def add_forces(self, force: Any = None, torque: Any = None, mode: int = ForceMode.FORCE, frame: int = Frame.WORLD,
                   first: int = 0) -> None:
        """Forces on bodies [first, first + count) in the order of the view: arrays of shape (count, 3), or three of (count,).
        float32 without gaps is not copied."""
        keep: List[Any] = []
        arrays = init(native.lr_force_arrays)
        arrays.mode, arrays.frame, arrays.first = int(mode), int(frame), first
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
        self.world._change("lr_batch_add_forces", self.id, ctypes.byref(arrays))

    def _set(self, name: str, struct: Any, fields: Mapping[str, Any]) -> None:
        """Without fields, what the library has of itself."""
        keep: List[Any] = []
        value = ctypes.byref(make(struct, fields, keep)) if fields else None
        self.world._change(name, self.id, value)

    def _get(self, name: str, struct: Any, record: Any) -> Any:
        value = init(struct)
        self.world._ask(name, self.id, ctypes.byref(value))
        return record.read(value)

    @takes("lr_batch_force")
    def set_force(self, **force: "Unpack[BatchForceOptions]") -> None:
        """What acts on every body, until changed; without keywords nothing does."""
        self._set("lr_batch_set_force", native.lr_batch_force, force)

    @takes("lr_aerodynamics")
    def set_aerodynamics(self, coefficients: Optional[Aerodynamics] = None, **changes: "Unpack[AerodynamicsOptions]") -> None:
        """Coefficients in place of the asset's: a whole record, some numbers of the present ones, or none for the asset's own."""
        fields = dict(as_fields(coefficients)) if coefficients is not None else {}
        if changes and not fields:
            fields = self.aerodynamics.as_dict()
        self._set("lr_batch_set_aerodynamics", native.lr_aerodynamics, {**fields, **changes})

    @property
    def aerodynamics(self) -> Aerodynamics:
        return self._get("lr_batch_get_aerodynamics", native.lr_aerodynamics, Aerodynamics)

    @takes("lr_load_gains")
    def set_load_gains(self, **gains: "Unpack[LoadGainsOptions]") -> None:
        """Art control: factors on drag, lift, spin drag and turbulence; without keywords all are 1."""
        self._set("lr_batch_set_load_gains", native.lr_load_gains, gains)

    @takes("lr_turbulence_table", "count")
    def set_turbulence_table(self, **table: "Unpack[TurbulenceTableOptions]") -> None:
        """k-epsilon samples in place of the asset's; without keywords its own."""
        if table:
            for name in ("chi", "epsilon"):
                if table.get(name) is None:
                    raise TypeError(f"a turbulence table needs {name}")
            if np.size(table["chi"]) != np.size(table["epsilon"]):
                raise ValueError("chi and epsilon have different lengths")
            table = {**table, "count": np.size(table["chi"])}  # type: ignore[typeddict-unknown-key,misc]
        self._set("lr_batch_set_turbulence_table", native.lr_turbulence_table, table)

    # Level of detail.

    def set_rate(self, divisor: int) -> None:
        """How often the batch is stepped; 1: as often as the world."""
        self.world._change("lr_batch_set_rate", self.id, int(divisor))

    @property
    def pace(self) -> BatchPace:
        return self._get("lr_batch_get_pace", native.lr_batch_pace, BatchPace)

    # Contact.

    @takes("lr_batch_contact")
    def set_contact(self, **contact: "Unpack[ContactOptions]") -> None:
        """How the bodies meet colliders; without keywords as initially."""
        self._set("lr_batch_set_contact", native.lr_batch_contact, contact)

    @property
    def contact(self) -> BatchContact:
        return self._get("lr_batch_get_contact", native.lr_batch_contact, BatchContact)

    def set_pair_contact(self, other: "Batch", enabled: bool = True) -> None:
        """Whether bodies of this batch meet those of another one; with itself, each other."""
        self.world._change("lr_batch_set_pair_contact", self.id, other.id, int(enabled))

    def pair_contact(self, other: "Batch") -> bool:
        enabled = ctypes.c_int32()
        self.world._ask("lr_batch_get_pair_contact", self.id, other.id, ctypes.byref(enabled))
        return bool(enabled.value)

    # Births and ends.

    @property
    def fault_policy(self) -> FaultPolicy:
        """What becomes of bodies that have left physics."""
        policy = ctypes.c_int32()
        self.world._ask("lr_batch_get_fault_policy", self.id, ctypes.byref(policy))
        return FaultPolicy(policy.value)

    @fault_policy.setter
    def fault_policy(self, policy: int) -> None:
        self.world._change("lr_batch_set_fault_policy", self.id, int(policy))

    def set_rules(self, *, max_age: Optional[float] = None, volumes: "Sequence[KillVolumeOptions]" = (),
                  action: Optional[int] = None) -> None:
        """When bodies end, and what becomes of them (`EndAction`). volumes: dicts with shape, side, center and size. Without
        anything the rules end."""
        fields = {"max_age": max_age, "volumes": list(volumes), "action": action}
        none = max_age is None and not volumes and action is None
        self._set("lr_batch_set_rules", native.lr_batch_rules, {} if none else fields)

    @takes("lr_emitter_desc")
    def set_emitter(self, **emitter: "Unpack[EmitterOptions]") -> None:
        """How bodies are born; without keywords none are any more."""
        self._set("lr_batch_set_emitter", native.lr_emitter_desc, emitter)

    def emit(self, count: int) -> np.ndarray:
        """Bears bodies now as the emitter says, all or none; their ids."""
        ids = np.zeros(count, np.uint64)
        self.world._change("lr_batch_emit", self.id, count, address(ids, ctypes.c_uint64))
        return ids

    @property
    def events(self) -> BatchEvents:
        """What rules and emitter did in the last step, and since the batch began; lists of ids are copies."""
        value = init(native.lr_batch_events)
        self.world._ask("lr_batch_get_events", self.id, ctypes.byref(value))

        def ids(pointer: Any, count: int) -> np.ndarray:
            return np.fromiter(pointer[:count], np.uint64, count) if count else np.empty(0, np.uint64)

        return BatchEvents.read(value, ended_ids=ids(value.ended_ids, value.destroyed + value.respawned),
                                born_ids=ids(value.born_ids, value.born))


def components(values: Any, name: str) -> Optional[Tuple[List[np.ndarray], int]]:
    """x, y and z of vectors, and the bytes from one body's value to the next's."""
    if values is None:
        return None
    if isinstance(values, (tuple, list)) and len(values) == 3 and all(isinstance(v, np.ndarray) and v.ndim == 1 for v in values):
        parts = [np.asarray(v, np.float32) for v in values]
    else:
        array = np.asarray(values, np.float32)
        if array.ndim != 2 or array.shape[1] != 3:
            raise ValueError(f"{name}: shape {array.shape}, but (count, 3) is wanted, or three arrays of (count,)")
        parts = [array[:, i] for i in range(3)]
    if len({len(part) for part in parts}) > 1:
        raise ValueError(f"{name}: components of different lengths")
    steps = {part.strides[0] for part in parts}
    if len(parts[0]) > 1 and (len(steps) > 1 or min(steps) < 4 or min(steps) % 4):
        parts = [np.ascontiguousarray(part) for part in parts]
    return parts, parts[0].strides[0] if len(parts[0]) > 1 else 4
