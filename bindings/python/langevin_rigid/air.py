# SPDX-License-Identifier: MIT
"""Wind, its sources, and water under a surface."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Mapping, Optional

import numpy as np

from . import _native as native
from ._structs import address, make, rows, takes
from .callbacks import SurfaceQuery, WindQuery, field_callback
from .enums import WindSourceKind

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
    from typing_extensions import Unpack

    from ._fields import SurfaceOptions, WindSourceOptions
    from .world import World


class WindSource:
    """A source of wind in a world, made by `World.add_wind`."""

    def __init__(self, world: "World", handle: int, fields: Mapping[str, Any]) -> None:
        self.world = world
        self.id = handle
        self._fields: Dict[str, Any] = dict(fields)

    @takes("lr_wind_source_desc", "kind")
    def update(self, **changes: "Unpack[WindSourceOptions]") -> None:
        """Changes what is given. A grid keeps its samples unless there are new ones."""
        fields = {**self._fields, **changes}
        keep: List[Any] = []
        desc = _source(fields, keep)
        self.world._change("lr_world_update_wind", self.id, ctypes.byref(desc))
        self._fields = _without_samples(fields)

    def remove(self) -> None:
        self.world._change("lr_world_remove_wind", self.id)

    def __repr__(self) -> str:
        return f"<WindSource {WindSourceKind(self._fields['kind']).name} {self.id:#x}>"


def _source(fields: Mapping[str, Any], keep: List[Any]) -> Any:
    fields = dict(fields)
    samples = fields.get("samples")
    if samples is not None:
        array = np.ascontiguousarray(samples, np.float32)
        if array.ndim == 4:
            array = array[np.newaxis]
        if array.ndim != 5 or array.shape[-1] != 3:
            raise ValueError(f"samples: shape {array.shape}, but (z, y, x, 3) or (frames, z, y, x, 3) is wanted")
        frames, z, y, x, _ = array.shape
        fields.update(samples=array, counts=(x, y, z), frames=frames)
    return make(native.lr_wind_source_desc, fields, keep)


def _without_samples(fields: Mapping[str, Any]) -> Dict[str, Any]:
    """What a source remembers: of a grid its counts, so that an update without samples is taken."""
    kept = {name: value for name, value in fields.items() if name != "samples"}
    samples = fields.get("samples")
    if samples is not None:
        shape = np.shape(samples)
        kept.update(counts=shape[-2:-5:-1], frames=shape[0] if len(shape) == 5 else 1)
    return kept


class AirMixin:
    """The part of `World` that is about fluids."""

    if TYPE_CHECKING:
        def _ask(self, name: str, *arguments: Any) -> None: ...
        def _change(self, name: str, *arguments: Any) -> None: ...
        def _keep(self, name: str, function: Any) -> None: ...
        _handle: Any

    def set_wind(self, velocity: "Optional[ArrayLike]" = None) -> None:
        """The uniform part of the wind, m/s; none is still air. A change is spread over the next step."""
        if velocity is None:
            self._change("lr_world_set_wind", None)
            return
        desc = make(native.lr_wind_desc, {"velocity": velocity}, [])
        self._change("lr_world_set_wind", ctypes.byref(desc))

    @takes("lr_wind_source_desc", "kind")
    def add_wind(self, kind: int, **options: "Unpack[WindSourceOptions]") -> WindSource:
        """Adds gusts, a vortex, a blower, turbulence, a velocity grid or a ground profile: `WindSourceKind`.

        samples: of a grid, shape (z, y, x, 3) or (frames, z, y, x, 3), m/s; counts and frames follow from it.
        """
        fields: Dict[str, Any] = {**options, "kind": int(kind)}
        keep: List[Any] = []
        desc = _source(fields, keep)
        out = ctypes.c_uint32()
        self._change("lr_world_add_wind", ctypes.byref(desc), ctypes.byref(out))
        return WindSource(self, out.value, _without_samples(fields))  # type: ignore[arg-type]

    def set_wind_callback(self, function: Optional[Callable[[WindQuery], Any]]) -> None:
        """A field of one's own, added to all else: called with a `WindQuery` of up to 256 bodies, whose velocity it sets. None
        removes it.

            def swirl(query):
                x, y, z = query.position
                query.velocity = (-z, 0 * y, x)

        With worker_count over 0 it is called by several threads, which take turns under Python's interpreter lock.
        """
        self._set_callback("lr_world_set_wind_callback", native.lr_wind_fn, WindQuery, function)

    def _set_callback(self, name: str, kind: Any, query: Any, function: Optional[Callable[[Any], Any]]) -> None:
        if function is not None and not callable(function):
            raise TypeError(f"{function!r} cannot be called")
        guard = self._handle.guard if self._handle is not None else None
        callback = field_callback(kind, query, function, guard) if function is not None and guard is not None else kind()
        self._change(name, callback, None)
        self._keep(name, callback)

    def sample_wind(self, positions: "ArrayLike") -> np.ndarray:
        """The velocity of the fluid at positions (..., 3), m/s, at the world's time."""
        given = np.asarray(positions, np.float32)
        points = rows(given, 3, "positions")
        velocities = np.empty_like(points)
        self._ask("lr_world_sample_wind", address(points, ctypes.c_float), len(points), address(velocities, ctypes.c_float))
        return velocities.reshape(given.shape)

    @takes("lr_surface_desc", "wave_count")
    def set_surface(self, **surface: "Unpack[SurfaceOptions]") -> None:
        """Water under a surface; without keywords as the library has it: y = 0, without waves. waves: dicts with direction,
        length, amplitude and phase."""
        self._change("lr_world_set_surface", ctypes.byref(make(native.lr_surface_desc, surface, [])))

    def remove_surface(self) -> None:
        self._change("lr_world_set_surface", None)

    def set_surface_callback(self, function: Optional[Callable[[SurfaceQuery], Any]]) -> None:
        """Water of one's own, while there is a surface: called with a `SurfaceQuery`. None removes it."""
        self._set_callback("lr_world_set_surface_callback", native.lr_surface_fn, SurfaceQuery, function)
