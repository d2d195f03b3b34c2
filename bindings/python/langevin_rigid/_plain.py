# SPDX-License-Identifier: MIT
# Generated from include/langevin_rigid.h by bindings/generator/python.py: do not edit.

"""Getters and setters of a single call: bases of the hand-written classes."""
from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, List, Mapping

from . import _native as native
from ._records import Aerodynamics, BatchContact, BatchCounts, BatchForce, BatchPace, BodyLoads, BodyState, ColliderState, LoadGains, StepReport, Timings, WorldInfo
from ._structs import init, integer, make, takes
from .enums import DivergencePolicy

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._options import BatchContactOptions, BatchForceOptions, BatchRulesOptions, EmitterOptions, LoadGainsOptions


class Plain:
    """Makes calls by `_ask` and `_change`, which put the called object before the arguments."""

    if TYPE_CHECKING:
        def _ask(self, name: str, *arguments: Any) -> None: ...
        def _change(self, name: str, *arguments: Any) -> None: ...

    def _set(self, name: str, struct: Any, fields: Mapping[str, Any]) -> None:
        """Passes null if there are no fields."""
        keep: List[Any] = []
        given = any(value is not None for value in fields.values())
        self._change(name, ctypes.byref(make(struct, fields, keep)) if given else None)


class OfWorld(Plain):
    """Makes calls on an object with a handle in a world."""

    if TYPE_CHECKING:
        world: Any
        id: int

    def _ask(self, name: str, *arguments: Any) -> None:
        self.world._ask(name, self.id, *arguments)

    def _change(self, name: str, *arguments: Any) -> None:
        self.world._change(name, self.id, *arguments)


class BatchPlain(OfWorld):
    """Plain getters and setters of `Batch`."""

    @takes("lr_load_gains")
    def set_load_gains(self, **gains: "Unpack[LoadGainsOptions]") -> None:
        """Sets the gains of a batch from the next step on. Without keywords, restores the initial setting."""
        self._set("lr_batch_set_load_gains", native.lr_load_gains, gains)

    @property
    def load_gains(self) -> LoadGains:
        """Reads the gains of a batch."""
        value = init(native.lr_load_gains)
        self._ask("lr_batch_get_load_gains", ctypes.byref(value))
        return LoadGains.read(value)

    def set_rate(self, divisor: int) -> None:
        """Sets how often a batch is stepped.

        divisor: 1 to 1024; default 1.
        """
        self._change("lr_batch_set_rate", integer(divisor, ctypes.c_uint32, 'divisor'))

    @property
    def pace(self) -> BatchPace:
        """Reads a batch's rate and backlog."""
        value = init(native.lr_batch_pace)
        self._ask("lr_batch_get_pace", ctypes.byref(value))
        return BatchPace.read(value)

    @takes("lr_batch_force")
    def set_force(self, **force: "Unpack[BatchForceOptions]") -> None:
        """Sets the forces on a batch from the next step on. Without keywords, removes the setting."""
        self._set("lr_batch_set_force", native.lr_batch_force, force)

    @property
    def force(self) -> BatchForce:
        """Reads the forces on every body of a batch."""
        value = init(native.lr_batch_force)
        self._ask("lr_batch_get_force", ctypes.byref(value))
        return BatchForce.read(value)

    @takes("lr_batch_contact")
    def set_contact(self, **contact: "Unpack[BatchContactOptions]") -> None:
        """Sets how a batch collides from the next step on. Without keywords, restores the initial setting."""
        self._set("lr_batch_set_contact", native.lr_batch_contact, contact)

    @property
    def contact(self) -> BatchContact:
        """Reads how a batch collides."""
        value = init(native.lr_batch_contact)
        self._ask("lr_batch_get_contact", ctypes.byref(value))
        return BatchContact.read(value)

    @takes("lr_batch_rules", "volume_count")
    def set_rules(self, **rules: "Unpack[BatchRulesOptions]") -> None:
        """Sets the rules of a batch. Without keywords, removes the setting."""
        self._set("lr_batch_set_rules", native.lr_batch_rules, rules)

    @property
    def divergence_policy(self) -> DivergencePolicy:
        """Reads how a batch treats diverged bodies."""
        value = ctypes.c_int32()
        self._ask("lr_batch_get_divergence_policy", ctypes.byref(value))
        return DivergencePolicy(value.value)

    @divergence_policy.setter
    def divergence_policy(self, value: int) -> None:
        self._change("lr_batch_set_divergence_policy", integer(value, ctypes.c_int32, 'policy'))

    @takes("lr_emitter_desc")
    def set_emitter(self, **desc: "Unpack[EmitterOptions]") -> None:
        """Sets the emitter of a batch. Without keywords, removes the setting."""
        self._set("lr_batch_set_emitter", native.lr_emitter_desc, desc)

    @property
    def counts(self) -> BatchCounts:
        """Reads the counts of a batch."""
        value = init(native.lr_batch_counts)
        self._ask("lr_batch_get_counts", ctypes.byref(value))
        return BatchCounts.read(value)

    @property
    def aerodynamics(self) -> Aerodynamics:
        """Reads a batch's current coefficients."""
        value = init(native.lr_aerodynamics)
        self._ask("lr_batch_get_aerodynamics", ctypes.byref(value))
        return Aerodynamics.read(value)


class ColliderPlain(OfWorld):
    """Plain getters and setters of `Collider`."""

    @property
    def state(self) -> ColliderState:
        """Reads the state of a collider."""
        value = init(native.lr_collider_state)
        self._ask("lr_collider_get_state", ctypes.byref(value))
        return ColliderState.read(value)


class WorldPlain(Plain):
    """Plain getters and setters of `World`."""

    @property
    def info(self) -> WorldInfo:
        """Reads counts, time and settings of the world."""
        value = init(native.lr_world_info)
        self._ask("lr_world_get_info", ctypes.byref(value))
        return WorldInfo.read(value)

    def set_simd_target(self, target: int) -> None:
        """Sets the instruction set from the next step on.

        target: `SimdTarget`.
        """
        self._change("lr_world_set_simd_target", integer(target, ctypes.c_int32, 'target'))

    def set_budget(self, body_substeps: int) -> None:
        """Limits the work of each step to a number of substeps of single bodies.

        body_substeps: at most 2^48; 0, the default, for no limit.
        """
        self._change("lr_world_set_budget", integer(body_substeps, ctypes.c_uint64, 'body_substeps'))

    @property
    def step_report(self) -> StepReport:
        """Reads the report of the last step."""
        value = init(native.lr_step_report)
        self._ask("lr_world_get_step_report", ctypes.byref(value))
        return StepReport.read(value)

    @property
    def timings(self) -> Timings:
        """Reads the timings of the last step."""
        value = init(native.lr_timings)
        self._ask("lr_world_get_timings", ctypes.byref(value))
        return Timings.read(value)

    def state(self, body: int) -> BodyState:
        """Reads the state of a body."""
        value = init(native.lr_body_state)
        self._ask("lr_body_get_state", int(body), ctypes.byref(value))
        return BodyState.read(value)

    def loads(self, body: int) -> BodyLoads:
        """Computes the loads on a body from its present state, wind and water; on a sleeping body as if its wake had ended."""
        value = init(native.lr_body_loads)
        self._ask("lr_body_get_loads", int(body), ctypes.byref(value))
        return BodyLoads.read(value)
