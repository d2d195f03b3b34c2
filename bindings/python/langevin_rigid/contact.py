# SPDX-License-Identifier: MIT
"""Colliders and contact events."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Dict, List, Mapping, NamedTuple, Optional

import numpy as np

from . import _native as native
from ._plain import ColliderPlain
from ._structs import address, contiguous, elements, init, integer, make, rows, takes, vectors
from .enums import ColliderKind, EventKinds, MoveMode

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Unpack

    from ._options import ColliderOptions, MaterialOptions


class Events(NamedTuple):
    """Events of the last step.

    events: a copy, as a structured array: kind (`EventKind`), batch, body, user, collider, position, normal, speed, impulse.
    lost: events of the last step beyond the capacity; total_lost: the same since `World.keep_events`.
    """

    events: NDArray[Any]
    lost: int
    total_lost: int

    def of(self, kind: int) -> NDArray[Any]:
        """The events of one kind."""
        return self.events[self.events["kind"] == int(kind)]


class Collider(ColliderPlain):
    """A collider of a world, created by `World.add_collider` and similar methods."""

    def __init__(self, world: Any, handle: int) -> None:
        self.world = world
        self.id = handle

    def _move(self, mode: int, **fields: Any) -> None:
        motion = make(native.lr_collider_motion, {**fields, "mode": int(mode), "collider": self.id}, [])
        self.world._change("lr_collider_move", ctypes.byref(motion), 1)

    def move_to(self, position: "Optional[ArrayLike]" = None, orientation: "Optional[ArrayLike]" = None) -> None:
        """Moves to this pose during the next step, then stops. Omitted values stay."""
        state = self.state
        self._move(MoveMode.TO, position=state.position if position is None else position,
                   orientation=state.orientation if orientation is None else orientation)

    def place(self, position: "Optional[ArrayLike]" = None, orientation: "Optional[ArrayLike]" = None,
              linear_velocity: "ArrayLike" = (0, 0, 0), angular_velocity: "ArrayLike" = (0, 0, 0)) -> None:
        """Teleports to this pose, then moves with these velocities."""
        state = self.state
        self._move(MoveMode.PLACE, position=state.position if position is None else position,
                   orientation=state.orientation if orientation is None else orientation,
                   linear_velocity=linear_velocity, angular_velocity=angular_velocity)

    def set_velocity(self, linear: "ArrayLike" = (0, 0, 0), angular: "ArrayLike" = (0, 0, 0)) -> None:
        """Moves with these velocities from the present pose."""
        self._move(MoveMode.VELOCITY, linear_velocity=linear, angular_velocity=angular)

    @takes("lr_material")
    def set_material(self, **surface: "Unpack[MaterialOptions]") -> None:
        """Sets layers, friction and restitution. Omitted values stay."""
        state = self.state
        fields: Dict[str, Any] = {"layers": state.layers, "friction": state.friction, "restitution": state.restitution, **surface}
        value = make(native.lr_material, fields, [])
        ids = np.array([self.id], np.uint64)
        self.world._change("lr_collider_set_material", address(ids, ctypes.c_uint64), 1, ctypes.byref(value))

    def destroy(self) -> None:
        ids = np.array([self.id], np.uint64)
        self.world._change("lr_collider_destroy", address(ids, ctypes.c_uint64), 1)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Collider) and other.id == self.id and other.world is self.world

    def __hash__(self) -> int:
        return hash(self.id)

    def __repr__(self) -> str:
        return f"<Collider {self.id:#x}>"


def _shaped(fields: Mapping[str, Any]) -> Mapping[str, Any]:
    """Derives counts from arrays."""
    fields = dict(fields)
    if fields.get("vertices") is not None:
        fields["vertices"] = rows(fields["vertices"], 3, "vertices")
        fields["vertex_count"] = len(fields["vertices"])
    if fields.get("indices") is not None:
        indices = contiguous(fields["indices"], ctypes.c_uint32, "indices")
        if indices.size % 3:
            raise ValueError(f"indices: {indices.size} is not a multiple of 3")
        fields.update(indices=indices, triangle_count=indices.size // 3)
    if fields.get("heights") is not None:
        heights = np.ascontiguousarray(fields["heights"], np.float32)
        if heights.ndim != 2:
            raise ValueError(f"heights: shape {heights.shape}, but expected (z, x)")
        fields.update(heights=heights, counts=heights.shape[::-1])
    size = fields.get("size")
    if size is not None:
        fields["size"] = np.resize(np.append(np.ravel(size), [0.0, 0.0]), 3) if np.size(size) < 3 else size
    return fields


class ContactMixin:
    """Adds colliders to `World`."""

    if TYPE_CHECKING:
        def _ask(self, name: str, *arguments: Any) -> None: ...
        def _change(self, name: str, *arguments: Any) -> None: ...
        def _create(self, name: str, *arguments: Any) -> None: ...

    def add_colliders(self, options: List[Mapping[str, Any]]) -> List[Collider]:
        """Creates colliders, all or none. Each dict has the keywords of `add_collider`, kind included."""
        keep: List[Any] = []
        descs = (native.lr_collider_desc * len(options))(*(make(native.lr_collider_desc, _shaped(o), keep) for o in options))
        ids = np.zeros(len(options), np.uint64)
        self._create("lr_collider_create", descs, len(options), address(ids, ctypes.c_uint64))
        return [Collider(self, int(handle)) for handle in ids]  # type: ignore[arg-type]

    @takes("lr_collider_desc", "kind", "vertex_count", "triangle_count", "counts")
    def add_collider(self, kind: int, **options: "Unpack[ColliderOptions]") -> Collider:
        """Creates a collider. vertices: (n, 3). indices: (triangles, 3). heights: (z, x), solid below them, along -y."""
        return self.add_colliders([{**options, "kind": int(kind)}])[0]

    def add_plane(self, point: "ArrayLike" = (0, 0, 0), normal: "ArrayLike" = (0, 1, 0), **options: Any) -> Collider:
        """Creates a plane; the space below it is solid."""
        return self.add_collider(ColliderKind.PLANE, position=point, orientation=turn_from_y(normal), **options)

    def add_sphere(self, center: "ArrayLike", radius: float, **options: Any) -> Collider:
        return self.add_collider(ColliderKind.SPHERE, position=center, size=[radius], **options)

    def add_box(self, center: "ArrayLike", half_extents: "ArrayLike", **options: Any) -> Collider:
        return self.add_collider(ColliderKind.BOX, position=center, size=half_extents, **options)

    def add_capsule(self, center: "ArrayLike", radius: float, half_length: float, **options: Any) -> Collider:
        """Creates a capsule along its own y axis."""
        return self.add_collider(ColliderKind.CAPSULE, position=center, size=[radius, half_length], **options)

    def add_mesh(self, vertices: "ArrayLike", indices: "ArrayLike", **options: Any) -> Collider:
        return self.add_collider(ColliderKind.MESH, vertices=vertices, indices=indices, **options)

    def add_hull(self, vertices: "ArrayLike", **options: Any) -> Collider:
        return self.add_collider(ColliderKind.HULL, vertices=vertices, **options)

    def add_heightfield(self, heights: "ArrayLike", spacing: "ArrayLike" = (1, 1), **options: Any) -> Collider:
        return self.add_collider(ColliderKind.HEIGHTFIELD, heights=heights, spacing=spacing, **options)

    def move_colliders(self, colliders: "List[Collider]", position: Any, orientation: Any = (0, 0, 0, 1), *,
                       mode: int = MoveMode.TO, linear_velocity: Any = (0, 0, 0), angular_velocity: Any = (0, 0, 0)) -> None:
        """Moves many colliders: each argument is a single value, or an array with a value for each collider."""
        count = len(colliders)
        if any(collider.world is not self for collider in colliders):
            raise ValueError("colliders: one is of another world")
        motions = elements(native.lr_collider_motion, count)
        motions["mode"] = int(mode)
        motions["collider"] = [collider.id for collider in colliders]
        for name, values, width in (("position", position, 3), ("orientation", orientation, 4),
                                    ("linear_velocity", linear_velocity, 3), ("angular_velocity", angular_velocity, 3)):
            motions[name] = vectors(values, width, count, name)
        self._change("lr_collider_move", address(motions, native.lr_collider_motion), count)

    def keep_events(self, capacity: int = 4096, kinds: int = EventKinds.ALL) -> None:
        """Keeps at most `capacity` events of each step; 0 disables events."""
        self._change("lr_world_set_events", integer(capacity, ctypes.c_uint32, "capacity"),
                     integer(kinds, ctypes.c_uint32, "kinds"))

    @property
    def events(self) -> Events:
        """The events of the last step."""
        listed = init(native.lr_event_list)
        self._ask("lr_world_get_events", ctypes.byref(listed))
        events = np.zeros(listed.count, np.dtype(native.lr_event))
        if listed.count:
            ctypes.memmove(events.ctypes.data, listed.events, events.nbytes)
        return Events(events, listed.lost, listed.total_lost)


def turn_from_y(direction: Any) -> NDArray[Any]:
    """The shortest rotation from +y to a direction, as a quaternion x, y, z, w."""
    x, y, z = np.asarray(direction, np.float64) / np.linalg.norm(direction)
    if y < -0.999999:
        return np.array([1.0, 0.0, 0.0, 0.0])
    quaternion = np.array([z, 0.0, -x, 1.0 + y])
    return quaternion / np.linalg.norm(quaternion)
