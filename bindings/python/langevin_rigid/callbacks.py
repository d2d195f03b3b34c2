# SPDX-License-Identifier: MIT
"""Calls from the library into Python. A call on the world raises the first exception of its callbacks after it returns. If it created
something, the next call that creates nothing does, so that no handle is lost."""
from __future__ import annotations

import ctypes
import logging
import signal
import sys
import threading
from concurrent.futures import Executor, Future
from typing import TYPE_CHECKING, Any, Callable, Dict, List, Optional, Tuple

import numpy as np

from . import _native as native
from .enums import LogLevel

if TYPE_CHECKING:
    from numpy.typing import NDArray

LOGGER = logging.getLogger("langevin_rigid")
LEVELS = {LogLevel.ERROR: logging.ERROR, LogLevel.WARNING: logging.WARNING, LogLevel.INFO: logging.INFO}


class Guard:
    """State shared by the callbacks of a world: the first exception of a call, that of a call that created something, and the last error
    message."""

    def __init__(self) -> None:
        self.pending: Optional[BaseException] = None
        self.late: Optional[BaseException] = None
        self.message = ""

    def caught(self, exception: BaseException) -> None:
        if self.pending is None:
            self.pending = exception

    def raise_late(self) -> None:
        late, self.late = self.late, None
        if late is not None:
            raise late


def _copy_in(pointers: Any, count: int) -> NDArray[Any]:
    array = np.empty((len(pointers), count), np.float32)
    row, step = array.ctypes.data, 4 * count
    for pointer in pointers:
        ctypes.memmove(row, pointer, step)
        row += step
    return array


def _copy_out(array: NDArray[Any], pointers: Any, count: int) -> None:
    row, step = array.ctypes.data, 4 * count
    for pointer in pointers:
        ctypes.memmove(pointer, row, step)
        row += step


class Query:
    """A query for some bodies, in arrays that outlive the callback. Vectors have shape (3, count)."""

    __slots__ = ("time", "count", "batch", "position", "_native", "_arrays")

    def __init__(self, value: Any) -> None:
        self.time: float = value.time
        self.count: int = value.count
        self.batch: int = value.batch
        self.position = _copy_in(value.position, self.count)
        self._native: Optional[Any] = value
        self._arrays: Dict[str, NDArray[Any]] = {}

    def _array(self, name: str) -> NDArray[Any]:
        if name not in self._arrays:
            if self._native is None:
                raise ValueError(f"{name} was not read during the callback, which has ended")
            pointers = getattr(self._native, name)
            self._arrays[name] = _copy_in(pointers if isinstance(pointers, ctypes.Array) else [pointers], self.count)
        return self._arrays[name]

    def _set(self, name: str, value: Any, shape: Tuple[int, ...] = (3,)) -> None:
        """Sets a value for each body, or a single value for all."""
        given = np.asarray(value, np.float32)
        if given.shape == shape:
            given = given[..., np.newaxis]
        try:
            self._array(name).reshape(*shape, self.count)[...] = given
        except ValueError:
            raise ValueError(f"{name}: shape {np.shape(value)} is neither {shape} nor {(*shape, self.count)}") from None

    def _finish(self) -> None:
        for name, array in self._arrays.items():
            pointers = getattr(self._native, name)
            _copy_out(array, pointers if isinstance(pointers, ctypes.Array) else [pointers], self.count)
        self._native = None


class WindQuery(Query):
    """time, count, batch (0 from `World.sample_wind`), position (3, count). The callback sets, or adds to:

    velocity: (3, count), m/s, 0 at first
    rate: (3, count), m/s^2, partial derivative of the velocity in time, 0 at first; optional
    gradient: (3, 3, count), 1/s, d velocity[i] / d position[j], 0 at first; optional
    """

    __slots__ = ()
    velocity = property(lambda self: self._array("velocity"), lambda self, value: self._set("velocity", value))
    rate = property(lambda self: self._array("rate"), lambda self, value: self._set("rate", value))
    gradient = property(lambda self: self._array("gradient").reshape(3, 3, self.count),
                        lambda self, value: self._set("gradient", value, (3, 3)))


class WaterQuery(Query):
    """time, count, batch, position (3, count). The callback sets these values, which begin as those of the plane and waves:

    height: (count,), m above the plane along its normal
    normal: (3, count), unit
    velocity, rate: (3, count), m/s and m/s^2, of the water
    """

    __slots__ = ()
    height = property(lambda self: self._array("height")[0], lambda self, value: self._set("height", value, ()))
    normal = property(lambda self: self._array("normal"), lambda self, value: self._set("normal", value))
    velocity = property(lambda self: self._array("velocity"), lambda self, value: self._set("velocity", value))
    rate = property(lambda self: self._array("rate"), lambda self, value: self._set("rate", value))


def uninterrupted(function: Callable[..., Any], *arguments: Any) -> Any:
    """Calls a function of the library that calls back into Python. Ctrl-C during the call is handled after it: Python would raise it
    on entering a callback, outside of all its `try`, where ctypes drops it, and the job system would not wait for its tasks."""
    before = signal.getsignal(signal.SIGINT)
    if threading.current_thread() is not threading.main_thread() or not callable(before):
        return function(*arguments)
    interrupts: List[int] = []  # without their frames: those refer to this list, and so would keep the world until a garbage collection
    try:
        signal.signal(signal.SIGINT, lambda number, _: interrupts.append(number))
        return function(*arguments)
    finally:
        signal.signal(signal.SIGINT, before)
        if interrupts:
            before(interrupts[0], sys._getframe())


def field_callback(kind: Any, query: Any, function: Callable[[Any], Any], guard: Guard) -> Any:
    """A wind or water callback for C. An exception ends its use for the rest of the call."""
    def asked(_: Any, pointer: Any) -> None:
        if guard.pending is not None:
            return
        try:
            asked_for = query(pointer[0])
            function(asked_for)
            asked_for._finish()
        except BaseException as exception:  # pylint: disable=broad-except
            guard.caught(exception)

    return kind(asked)


def record_callback(write: Callable[[bytes], Any], guard: Guard) -> Any:
    """Passes a recording's bytes to `write`; an exception ends the recording."""
    def wrote(_: Any, memory: int, size: int) -> int:
        try:
            write(ctypes.string_at(memory, size))
            return 0
        except BaseException as exception:  # pylint: disable=broad-except
            guard.caught(exception)
            return 1

    return native.lr_record_fn(wrote)


def log_callback(function: Optional[Callable[[LogLevel, str], Any]], guard: Guard) -> Any:
    """Passes messages to `function`. Without it, errors go into the exception, others to the logger "langevin_rigid"."""
    def logged(_: Any, level: int, message: bytes) -> None:
        try:
            text = message.decode("utf-8", "replace")
            if level == LogLevel.ERROR:
                guard.message = text
            if function is not None:
                function(LogLevel(level), text)
            elif level != LogLevel.ERROR:
                LOGGER.log(LEVELS[LogLevel(level)], "%s", text)
        except BaseException as exception:  # pylint: disable=broad-except
            guard.caught(exception)

    return native.lr_log_fn(logged)


def job_callbacks(executor: Executor, guard: Guard) -> Any:
    """Uses an executor as the library's job system. The stepping thread runs tasks that no thread has started."""
    enqueued: Dict[int, List[Tuple[Future, int]]] = {}
    tasks: Dict[int, Tuple[Any, Any]] = {}
    types: Dict[str, Any] = dict(native.lr_job_system._fields_)

    def enqueue(_: Any, run: Any, task: Any, count: int) -> int:
        token = max(enqueued, default=0) + 1
        enqueued[token], tasks[token] = [], (run, task)
        for index in range(count):
            future: Future = Future()
            try:
                future = executor.submit(run, task, index, index + 1)
            except BaseException as exception:  # pylint: disable=broad-except
                guard.caught(exception)
            enqueued[token].append((future, index))
        return token

    def finish(_: Any, token: int) -> None:
        run, task = tasks.pop(token)
        for future, index in enqueued.pop(token):
            if future.cancel():
                run(task, index, index + 1)
            else:
                exception = future.exception()
                if exception is not None:
                    guard.caught(exception)

    return native.lr_job_system(None, types["enqueue"](enqueue), types["finish"](finish))
