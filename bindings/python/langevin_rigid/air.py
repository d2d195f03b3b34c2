# SPDX-License-Identifier: MIT
"""Wind, wind sources and water."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, Optional

import numpy as np

from . import _native as native
from ._records import Water
from ._structs import address, assign, init, make, rows, takes, vectors
from .callbacks import WaterQuery, WindQuery, field_callback

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Unpack

    from ._options import (BlowerOptions, GroundWindOptions, GustsOptions, TurbulenceOptions, VortexOptions, WaterOptions,
                           WindGridOptions)


class WindSource:
    """A wind source of a world, created by `World.add_gusts`, `World.add_vortex` and so on."""

    def __init__(self, world: Any, kind: str, handle: int) -> None:
        self.world = world
        self.kind = kind
        self.id = handle

    def _desc(self) -> Any:
        desc = _struct(self.kind)()
        desc.struct_size = ctypes.sizeof(desc)
        self.world._ask(f"lr_world_get_{self.kind}", self.id, ctypes.byref(desc))
        return desc

    def get(self) -> Dict[str, Any]:
        """The values last set, by keyword. A grid's samples are None."""
        desc = self._desc()
        values = {name: getattr(desc, name) for name in native.FIELD_DOCS[type(desc).__name__]}
        return {name: tuple(v) if isinstance(v, ctypes.Array) else None if name == "samples" else v for name, v in values.items()}

    def update(self, **changes: Any) -> None:
        """Changes the given fields. A grid keeps its samples unless new ones are given."""
        keep: List[Any] = []
        desc = assign(self._desc(), _with_counts(changes), keep)
        self.world._change(f"lr_world_update_{self.kind}", self.id, ctypes.byref(desc))

    def remove(self) -> None:
        self.world._change("lr_world_remove_wind", self.id)

    def __repr__(self) -> str:
        return f"<WindSource {self.kind} {self.id:#x}>"


def _struct(kind: str) -> Any:
    return getattr(native, f"lr_{kind}_desc")


def _with_counts(fields: Mapping[str, Any]) -> Dict[str, Any]:
    """Derives a grid's counts and frames from the shape of its samples."""
    fields = dict(fields)
    samples = fields.get("samples")
    if samples is not None:
        array = np.ascontiguousarray(samples, np.float32)
        if array.ndim == 4:
            array = array[np.newaxis]
        if array.ndim != 5 or array.shape[-1] != 3:
            raise ValueError(f"samples: shape {array.shape}, but expected (z, y, x, 3) or (frames, z, y, x, 3)")
        frames, z, y, x, _ = array.shape
        fields.update(samples=array, counts=(x, y, z), frames=frames)
    return fields


class AirMixin:
    """Adds wind and water to `World`."""

    if TYPE_CHECKING:
        def _ask(self, name: str, *arguments: Any) -> None: ...
        def _change(self, name: str, *arguments: Any) -> None: ...
        def _create(self, name: str, *arguments: Any) -> None: ...
        def _give(self, place: str, callback: Any, name: str, *arguments: Any) -> None: ...
        _handle: Any
        _changes: int

    def set_uniform_wind(self, velocity: "ArrayLike") -> None:
        """Sets the uniform wind, m/s. The wind changes linearly over the next step."""
        x, y, z = vectors(velocity, 3, 1, "velocity")[0].tolist()
        self._change("lr_world_set_uniform_wind", x, y, z)

    @property
    def uniform_wind(self) -> NDArray[Any]:
        """The uniform wind last set, m/s."""
        velocity = np.empty(3, np.float32)
        self._ask("lr_world_get_uniform_wind", address(velocity, ctypes.c_float))
        return velocity

    def _add_source(self, kind: str, options: Mapping[str, Any]) -> WindSource:
        keep: List[Any] = []
        desc = make(_struct(kind), _with_counts(options), keep)
        out = ctypes.c_uint32()
        self._create(f"lr_world_add_{kind}", ctypes.byref(desc), ctypes.byref(out))
        return WindSource(self, kind, out.value)  # type: ignore[arg-type]

    @takes("lr_gusts_desc")
    def add_gusts(self, **options: "Unpack[GustsOptions]") -> WindSource:
        """Adds gusts: fluctuations of the uniform wind in time."""
        return self._add_source("gusts", options)

    @takes("lr_vortex_desc")
    def add_vortex(self, **options: "Unpack[VortexOptions]") -> WindSource:
        """Adds a straight vortex."""
        return self._add_source("vortex", options)

    @takes("lr_blower_desc")
    def add_blower(self, **options: "Unpack[BlowerOptions]") -> WindSource:
        """Adds a blower: a turbulent jet, round or from a slot."""
        return self._add_source("blower", options)

    @takes("lr_turbulence_desc")
    def add_turbulence(self, **options: "Unpack[TurbulenceOptions]") -> WindSource:
        """Adds turbulence: random eddies everywhere."""
        return self._add_source("turbulence", options)

    @takes("lr_wind_grid_desc")
    def add_wind_grid(self, **options: "Unpack[WindGridOptions]") -> WindSource:
        """Adds a grid of wind samples, m/s, of shape (z, y, x, 3) or (frames, z, y, x, 3); the shape gives counts and frames."""
        return self._add_source("wind_grid", options)

    @takes("lr_ground_wind_desc")
    def add_ground_wind(self, **options: "Unpack[GroundWindOptions]") -> WindSource:
        """Adds a wind profile over a ground."""
        return self._add_source("ground_wind", options)

    def set_wind_callback(self, function: Optional[Callable[[WindQuery], Any]]) -> None:
        """Sets a function that adds wind. It receives a `WindQuery` of up to 256 bodies and sets its velocity. None removes the
        function.

            def swirl(query):
                x, y, z = query.position
                query.velocity = (-z, 0 * y, x)

        If worker_count is over 0, several threads call the function, one at a time because of Python's interpreter lock.
        """
        self._set_callback("lr_world_set_wind_callback", native.lr_wind_fn, WindQuery, function)

    def _set_callback(self, name: str, kind: Any, query: Any, function: Optional[Callable[[Any], Any]]) -> None:
        if function is not None and not callable(function):
            raise TypeError(f"{function!r} cannot be called")
        guard = self._handle.guard if self._handle is not None else None
        callback = field_callback(kind, query, function, guard) if function is not None and guard is not None else kind()
        self._changes += 1
        self._give(name, callback, name, callback, None)

    def sample_wind(self, positions: "ArrayLike") -> NDArray[Any]:
        """The velocity of the fluid at positions (..., 3), m/s, at the world's time."""
        given = np.asarray(positions, np.float32)
        points = rows(given, 3, "positions")
        velocities = np.empty_like(points)
        self._ask("lr_world_sample_wind", address(points, ctypes.c_float), len(points), address(velocities, ctypes.c_float))
        return velocities.reshape(given.shape)

    @takes("lr_water_desc", "wave_count")
    def set_water(self, **surface: "Unpack[WaterOptions]") -> None:
        """Sets the water. The defaults are a surface at y = 0 without waves. waves: dicts with direction, length, amplitude
        and phase."""
        self._change("lr_world_set_water", ctypes.byref(make(native.lr_water_desc, surface, [])))

    @property
    def water(self) -> Optional[Water]:
        """The water's settings, or None without water."""
        value, present = init(native.lr_water_desc), ctypes.c_int32()
        self._ask("lr_world_get_water", ctypes.byref(value), ctypes.byref(present))
        return Water.read(value) if present.value else None

    def remove_surface(self) -> None:
        self._change("lr_world_set_water", None)

    def set_water_callback(self, function: Optional[Callable[[WaterQuery], Any]]) -> None:
        """Sets a function that shapes the water surface. It receives a `WaterQuery`, while water is set. None removes it."""
        self._set_callback("lr_world_set_water_callback", native.lr_water_fn, WaterQuery, function)
