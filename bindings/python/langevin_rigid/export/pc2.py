# SPDX-License-Identifier: MIT
"""Point caches (PC2) of a carrier: a mesh with three loose vertices for each body, moved by any program with a PC2 modifier.

Vertex 3 i is the centre of mass of the body in slot i. Vertices 3 i + 1 and 3 i + 2 lie along the body's x and y axes, at the
distance of its scale in metres. Together they give position, orientation and scale, and interpolate between frames. In an
empty slot all three are at one point.
"""
from __future__ import annotations

import os
import struct
from typing import TYPE_CHECKING, Any, NamedTuple, Tuple, Union

import numpy as np

from ..recording import Recording
from ..view import turned

if TYPE_CHECKING:
    from numpy.typing import NDArray

HEADER = struct.Struct("<12siiffi")  # mark, version, points, first frame, frames per sample, samples
MARK = b"POINTCACHE2\0"


class CarrierCache(NamedTuple):
    """vertices: their number in the carrier. first: their positions in the first frame, (vertices, 3)."""

    vertices: int
    first: NDArray[Any]


def carrier_frames(recording: Recording) -> NDArray[Any]:
    """(frames, slots, 3, 3): centre and ends of the two arms of each slot in each frame."""
    slots, count = recording.slots()
    out = np.empty((len(recording), count, 3, 3), np.float32)
    alive = np.zeros((len(recording), count), bool)
    unit_x, unit_y = np.array([1, 0, 0], np.float32), np.array([0, 1, 0], np.float32)
    for at, (frame, slot) in enumerate(zip(recording, slots)):
        reach = frame.scale[:, None]
        out[at, slot, 0] = frame.position
        out[at, slot, 1] = frame.position + reach * turned(frame.orientation, np.broadcast_to(unit_x, frame.position.shape))
        out[at, slot, 2] = frame.position + reach * turned(frame.orientation, np.broadcast_to(unit_y, frame.position.shape))
        alive[at, slot] = True
    # # An empty slot stays where its last body ended for a frame, then where its next body begins; after the last body, at its end.
    ended = alive.copy()
    for at in range(1, len(out)):
        fill = ~alive[at] & alive[at - 1]
        out[at, fill] = out[at - 1, fill, :1]
        ended[at] |= fill
    for order, beside in ((range(len(out) - 2, -1, -1), 1), (range(1, len(out)), -1)):
        for at in order:
            fill = ~ended[at] & ended[at + beside]
            out[at, fill] = out[at + beside, fill, :1]
            ended[at] |= fill
    return out


def write_carrier_pc2(path: Union[str, "os.PathLike[str]"], recording: Recording) -> CarrierCache:
    """Writes the cache of a recording. Sample f is frame first_frame + f."""
    frames = carrier_frames(recording)
    vertices = 3 * frames.shape[1]
    if not frames.size:
        raise ValueError("the recording has no bodies")
    with open(path, "wb") as file:
        file.write(HEADER.pack(MARK, 1, vertices, float(recording.first_frame), 1.0, len(frames)))
        file.write(frames.astype("<f4", copy=False).tobytes())
    return CarrierCache(vertices, frames[0].reshape(-1, 3))


def read_pc2(path: Union[str, "os.PathLike[str]"]) -> Tuple[float, float, NDArray[Any]]:
    """First frame, frames per sample, and an array (samples, points, 3)."""
    with open(path, "rb") as file:
        mark, version, points, start, rate, samples = HEADER.unpack(file.read(HEADER.size))
        if mark != MARK or version != 1:
            raise ValueError(f"{os.fspath(path)}: not a PC2 file")
        data = np.frombuffer(file.read(), "<f4")
    return start, rate, data.reshape(samples, points, 3)
