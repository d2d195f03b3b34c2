# SPDX-License-Identifier: MIT
"""Instruction sets of this build and processor."""
from __future__ import annotations

import ctypes
from typing import List

from ._library import call, library
from .enums import SimdTarget


def simd_targets() -> List[SimdTarget]:
    """The instruction sets that this processor can run, best first."""
    count, values = ctypes.c_uint32(), (ctypes.c_int32 * len(SimdTarget))()
    call("lr_simd_targets", values, len(values), ctypes.byref(count))
    return [SimdTarget(value) for value in values[:count.value]]


def simd_target_name(target: int) -> str:
    """A readable name."""
    return library().lr_simd_target_name(int(target)).decode()
