# SPDX-License-Identifier: MIT
"""Worlds: clock, gravity, snapshots and batches."""
from __future__ import annotations

import ctypes
from concurrent.futures import Executor
from typing import TYPE_CHECKING, Any, Callable, List, Optional, SupportsFloat, Tuple, Union

import numpy as np

from . import _native as native
from ._library import error, library
from ._plain import WorldPlain
from ._structs import address, contiguous, elements, integer, make, takes, vectors
from .air import AirMixin, WindSource
from .batch import Batch
from .callbacks import Guard, job_callbacks, log_callback, record_callback, uninterrupted
from .contact import Collider, ContactMixin
from .enums import ForceFlags, ForceFrame, ForceMode, LogLevel, SleepState
from .errors import BusyError, ClosedError
from .queries import QueryMixin

if TYPE_CHECKING:
    from numpy.typing import ArrayLike, NDArray
    from typing_extensions import Unpack

    from ._options import BatchOptions, BodyStateOptions, RecordingOptions, WorldOptions
    from .asset import Asset


class Handle:
    """A world of the library with its callbacks, freed with the last object that refers to it."""

    def __init__(self, pointer: Any, destroy: Any, guard: Guard, keep: Any) -> None:
        self.pointer = pointer
        self.destroy = destroy
        self.guard = guard
        self.keep = keep
        self.idle = [True]  # empty during a call. No lock: Ctrl-C could be raised between its acquire() and `try`, but not after `del`

    def calls_python(self) -> bool:
        """Whether a call can call back into Python, but for its log."""
        return any(any(callbacks) for name, callbacks in self.keep.items() if name != "log")

    def __del__(self) -> None:
        self.destroy(self.pointer)


class World(WorldPlain, AirMixin, ContactMixin, QueryMixin):
    """A world with its batches and bodies.

        with World(seed=1) as world:
            batch = world.create_batch(asset, capacity=1000)
            batch.create(count=1000, position=positions)
            world.step(1 / 60, substeps=2)

    log: called with a `LogLevel` and a text. Without it, warnings go to the logger "langevin_rigid", and the text of an error
        into its exception.
    executor: a ThreadPoolExecutor whose threads help the caller's thread to step: worker_count threads, or all if that is 0.
        Without it the library starts worker_count threads.

    Only one thread at a time can use a world. A second thread, or a callback that calls its own world, gets a `BusyError`. The
    library runs without Python's interpreter lock.
    """

    @takes("lr_world_desc", "allocator", "log_user", "jobs", "log")
    def __init__(self, *, log: Optional[Callable[[LogLevel, str], Any]] = None, executor: Optional[Executor] = None,
                 **options: "Unpack[WorldOptions]") -> None:
        self._handle: Optional[Handle] = None
        self._changes = 0
        guard = Guard()
        desc = make(native.lr_world_desc, options, [])
        desc.log = log_callback(log, guard)
        keep = {"log": (desc.log,)}
        if executor is not None:
            desc.jobs = job_callbacks(executor, guard)
            if desc.worker_count == 0:  # only Python's own executors say how many; for others the library guesses, and warns
                desc.worker_count = min(getattr(executor, "_max_workers", 0), 64)
            keep["jobs"] = (desc.jobs,)
        pointer = ctypes.POINTER(native.lr_world)()
        status = library().lr_world_create(ctypes.byref(desc), ctypes.byref(pointer))
        if status:
            raise error(status, "lr_world_create", guard.message)
        self._handle = Handle(pointer, library().lr_world_destroy, guard, keep)

    # # Calls.

    def _open(self) -> Handle:
        if self._handle is None:
            raise ClosedError("the world was closed")
        return self._handle

    def _call(self, name: str, *arguments: Any, creates: bool = False) -> Tuple[int, str]:
        """A function's result, and its error message."""
        handle = self._open()
        try:
            del handle.idle[0]
        except IndexError:
            raise BusyError("the world is already in a call: use one thread at a time, and do not call it from its callbacks") from None
        try:
            handle.guard.message = ""
            function = getattr(library(), name)
            result = uninterrupted(function, handle.pointer, *arguments) if handle.calls_python() else function(handle.pointer, *arguments)
        finally:
            handle.guard.late, handle.guard.pending = handle.guard.late or handle.guard.pending, None
            handle.idle.append(True)
        if result or not creates:
            handle.guard.raise_late()
        return result, handle.guard.message

    def _ask(self, name: str, *arguments: Any, creates: bool = False) -> None:
        """Makes a call that does not change the world."""
        status, message = self._call(name, *arguments, creates=creates)
        if status:
            raise error(status, name, message)

    def _change(self, name: str, *arguments: Any) -> None:
        """Makes a call that changes the world, so that views become stale."""
        self._changes += 1
        self._ask(name, *arguments)

    def _create(self, name: str, *arguments: Any) -> None:
        """Makes a call that creates something. An exception of a callback would lose the handle, so the next other call raises it."""
        self._changes += 1
        self._ask(name, *arguments, creates=True)

    def _give(self, place: str, callback: Any, name: str, *arguments: Any) -> None:
        """Makes a call that gives the library a callback. One that raises, by Ctrl-C or in a recording's `write`, can have given it:
        the callback before is then kept as well."""
        keep = self._open().keep
        before = keep.get(place, ())
        keep[place] = (*before, callback)
        status, message = self._call(name, *arguments)
        keep[place] = before if status else (callback,)
        if status:
            raise error(status, name, message)

    # # Lifetime.

    def close(self) -> None:
        """Destroys the world. Its memory is freed once no array uses it."""
        if self._handle is not None and not self._handle.idle:
            raise BusyError("the world is in a call")
        guard = self._handle and self._handle.guard
        uninterrupted(setattr, self, "_handle", None)  # Python drops an exception in __del__
        if guard:
            guard.raise_late()

    @property
    def closed(self) -> bool:
        return self._handle is None

    def __enter__(self) -> "World":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __repr__(self) -> str:
        if self.closed:
            return "<World, closed>"
        info = self.info
        return f"<World at {info.time:.3f} s, {info.body_count} bodies in {info.batch_count} batches, {info.simd_target.name}>"

    # Time.

    def step(self, dt: SupportsFloat, substeps: int = 1) -> None:
        """Advances all bodies by dt seconds in equal substeps. At 60 Hz take 2 for leaves and paper, 4 for petals and confetti.

        If a callback raises, the step is completed with the values set so far, and then raises that exception. A step that
        raises OutOfMemoryError is also complete, but without some contacts.
        """
        self._change("lr_world_step", float(dt), integer(substeps, ctypes.c_uint32, "substeps"))

    @property
    def time(self) -> float:
        """Time since creation, s."""
        return self.info.time

    def set_gravity(self, gravity: "ArrayLike") -> None:
        """Sets gravity: a vector, m/s^2."""
        self._change("lr_world_set_gravity", address(vectors(gravity, 3, 1, "gravity").copy(), ctypes.c_float))

    def hash(self) -> int:
        """A hash of the world's state. Worlds with equal hashes move the same from here on, on any machine."""
        value = ctypes.c_uint64()
        self._ask("lr_world_hash", ctypes.byref(value))
        return value.value

    def save(self) -> bytes:
        """A snapshot as bytes."""
        size, _ = self._call("lr_world_snapshot_size")
        memory, written = ctypes.create_string_buffer(size), ctypes.c_uint64()
        self._ask("lr_world_snapshot_save", memory, size, ctypes.byref(written))
        return memory.raw[:written.value]

    def restore(self, snapshot: Any) -> None:
        """Restores a snapshot of this world, or of a world with the same batches, in any process."""
        data = np.frombuffer(snapshot, np.uint8)
        self._change("lr_world_snapshot_restore", data.ctypes.data, data.nbytes)

    @takes("lr_recording_desc", "write", "user")
    def record_start(self, write: Callable[[bytes], Any], **options: "Unpack[RecordingOptions]") -> None:
        """Starts a recording for `lr_replay`: `write` (`open("bug.lrr", "wb").write`) receives every call that can change the world.

        Calls on this world call `write`. An exception in it ends the recording, and that call raises it."""
        desc = make(native.lr_recording_desc, options, [])
        desc.write = record_callback(write, self._open().guard)
        self._give("record", desc.write, "lr_world_record_start", ctypes.byref(desc))

    def record_stop(self) -> None:
        """Ends the recording after writing its last bytes."""
        self._ask("lr_world_record_stop")
        self._open().keep["record"] = ()

    # Batches and bodies.

    @takes("lr_batch_desc", "asset", "capacity")
    def create_batch(self, asset: "Asset", capacity: int, **options: "Unpack[BatchOptions]") -> Batch:
        """Creates a batch with room for `capacity` bodies of an asset."""
        if not hasattr(asset, "_as_parameter_"):
            raise TypeError(f"asset: expected an Asset, not {type(asset).__name__}; Asset.load reads a file")
        keep: List[Any] = []
        desc = make(native.lr_batch_desc, {**options, "asset": asset, "capacity": capacity}, keep)
        out = ctypes.c_uint32()
        self._create("lr_batch_create", ctypes.byref(desc), ctypes.byref(out))
        return Batch(self, out.value, asset)

    def destroy_bodies(self, bodies: "ArrayLike") -> None:
        """Destroys bodies, all or none: a stale or repeated id destroys nothing."""
        ids, pointer, count = body_ids(bodies)
        self._change("lr_body_destroy", pointer, count)

    def is_valid(self, thing: "Union[int, Batch, Collider, WindSource]") -> bool:
        """Whether a body (its id), batch, collider or wind source of this world still exists."""
        if isinstance(thing, (Batch, Collider, WindSource)):
            name = {Batch: "lr_batch_is_valid", Collider: "lr_collider_is_valid", WindSource: "lr_wind_source_is_valid"}[type(thing)]
            return thing.world is self and self._call(name, thing.id)[0] == 1
        return self._call("lr_body_is_valid", int(thing))[0] == 1

    @takes("lr_body_state", "noise_seed", "sleep_state")
    def set_state(self, body: int, **fields: "Unpack[BodyStateOptions]") -> None:
        """Sets the given fields of a body, keeps the rest, and wakes it."""
        keep: List[Any] = []
        state = make(native.lr_body_state, {**self.state(body).as_dict(), **fields}, keep)
        self._change("lr_body_set_state", int(body), ctypes.byref(state))

    def set_sleep(self, bodies: "ArrayLike", sleep: int = SleepState.ASLEEP) -> None:
        """Puts bodies to sleep, or wakes them with SleepState.AWAKE."""
        ids, pointer, count = body_ids(bodies)
        self._change("lr_body_set_sleep", pointer, count, int(sleep))

    def wake_box(self, low: "ArrayLike", high: "ArrayLike") -> int:
        """Wakes all sleeping bodies that overlap a box, and returns their number."""
        corners = np.stack([vectors(low, 3, 1, "low")[0], vectors(high, 3, 1, "high")[0]])
        woken = ctypes.c_uint32()
        self._change("lr_world_wake_box", address(corners[0], ctypes.c_float), address(corners[1], ctypes.c_float),
                     ctypes.byref(woken))
        return woken.value

    def add_forces(self, bodies: "ArrayLike", force: Any = (0, 0, 0), torque: Any = (0, 0, 0), point: Any = None,
                   mode: int = ForceMode.FORCE, frame: int = ForceFrame.WORLD) -> None:
        """Forces on bodies of any batches, vectors of shape (3,) or (count, 3). point: where `force` acts, else at the centre of
        mass. `Batch.add_forces` is faster for bodies of one batch."""
        ids, _, count = body_ids(bodies)
        forces = elements(native.lr_body_force, count)
        forces["body"], forces["mode"], forces["frame"] = ids, int(mode), int(frame)
        forces["force"] = vectors(force, 3, count, "force")
        forces["torque"] = vectors(torque, 3, count, "torque")
        if point is not None:
            forces["point"] = vectors(point, 3, count, "point")
            forces["flags"] = int(ForceFlags.AT_POINT)
        self._change("lr_body_add_force", address(forces, native.lr_body_force), count)


def body_ids(bodies: Any) -> Tuple[NDArray[Any], Any, int]:
    """Ids as an array, with its address and length."""
    if np.asarray(bodies).dtype == bool:
        raise TypeError("bodies: ids are expected, not a mask")
    ids = contiguous(bodies, ctypes.c_uint64, "bodies").ravel()
    return ids, address(ids, ctypes.c_uint64), ids.size
