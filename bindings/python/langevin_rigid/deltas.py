# SPDX-License-Identifier: MIT
"""Differences between snapshots of a world, for sending and for long rings of states: docs/reference/snapshots.md."""
from __future__ import annotations

import ctypes
from typing import Any

import numpy as np

from ._library import error, library
from .enums import Status


def delta_encode(base: Any, snapshot: Any) -> bytes:
    """What of a snapshot is not in an earlier one of the same world, the base."""
    old, new = np.frombuffer(base, np.uint8), np.frombuffer(snapshot, np.uint8)
    room = library().lr_snapshot_delta_bound(new.nbytes)
    memory, written = ctypes.create_string_buffer(room), ctypes.c_uint64()
    status = library().lr_snapshot_delta_encode(old.ctypes.data, old.nbytes, new.ctypes.data, new.nbytes, memory, room,
                                                ctypes.byref(written))
    if status:
        raise error(status, "lr_snapshot_delta_encode")
    return memory.raw[:written.value]


def delta_apply(base: Any, delta: Any) -> bytes:
    """The snapshot that a delta was made of, from the base that it was made with."""
    old, packed = np.frombuffer(base, np.uint8), np.frombuffer(delta, np.uint8)
    given = (old.ctypes.data, old.nbytes, packed.ctypes.data, packed.nbytes)
    size = ctypes.c_uint64()
    status = library().lr_snapshot_delta_apply(*given, None, 0, ctypes.byref(size))
    if status not in (Status.OK, Status.BUFFER_TOO_SMALL):
        raise error(status, "lr_snapshot_delta_apply")
    memory = ctypes.create_string_buffer(size.value)
    status = library().lr_snapshot_delta_apply(*given, memory, size.value, ctypes.byref(size))
    if status:
        raise error(status, "lr_snapshot_delta_apply")
    return memory.raw[:size.value]
