# SPDX-License-Identifier: MIT
"""Motion over frames, in memory and in NumPy archives: the input of the exporters."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, NamedTuple, Tuple, Union

import numpy as np

from .enums import TransformFormat

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .batch import Batch

FORMAT = 1
FIELDS: Dict[str, Tuple[int, Any]] = {
    "ids": (1, np.int64), "bodies": (1, np.uint64), "position": (3, np.float32), "orientation": (4, np.float32),
    "scale": (1, np.float32), "velocity": (3, np.float32), "spin": (3, np.float32), "age": (1, np.float32),
}


class RecordedFrame(NamedTuple):
    """Bodies of a frame, sorted by id, in the world frame and SI units. orientation: x, y, z, w.

    ids: a number for each life, counted from 0: a respawned body has a new one.
    bodies: the library's ids.
    """

    ids: NDArray[Any]
    bodies: NDArray[Any]
    position: NDArray[Any]
    orientation: NDArray[Any]
    scale: NDArray[Any]
    velocity: NDArray[Any]
    spin: NDArray[Any]
    age: NDArray[Any]


class Recording:
    """Frames of a batch at a fixed rate. Bodies can come and go between frames.

        recording = lr.Recording(fps=24)
        for frame in range(240):
            recording.capture(batch)
            world.step(1 / 24, substeps=5)
        recording.save("storm.npz")
    """

    def __init__(self, fps: float = 24.0, first_frame: int = 1) -> None:
        if not fps > 0:
            raise ValueError("fps must be greater than 0")
        self.fps = float(fps)
        self.first_frame = int(first_frame)
        self.frames: List[RecordedFrame] = []
        self._lives = 0

    def capture(self, batch: "Batch") -> RecordedFrame:
        """Adds the present state of a batch as the next frame."""
        placed = batch.transforms(TransformFormat.POSITION_QUATERNION_SCALE)
        view = batch.view()
        lives = self._lives_of(view.ids, view.age)
        order = np.argsort(lives, kind="stable")
        placed = placed[order]
        velocity, spin = batch.velocities()
        frame = RecordedFrame(lives[order], view.ids[order], placed[:, :3].copy(), placed[:, 3:7].copy(), placed[:, 7].copy(),
                              velocity[order], spin[order], view.age[order])
        self.frames.append(frame)
        return frame

    def _lives_of(self, bodies: NDArray[Any], age: NDArray[Any]) -> NDArray[Any]:
        """A number for each body's present life: that of the previous frame, unless the body is now younger."""
        lives = np.full(len(bodies), -1, np.int64)
        if self.frames and len(self.frames[-1].bodies):
            last = self.frames[-1]
            order = np.argsort(last.bodies)
            at = order[np.minimum(np.searchsorted(last.bodies, bodies, sorter=order), len(order) - 1)]
            same = (last.bodies[at] == bodies) & (last.age[at] <= age)
            lives[same] = last.ids[at[same]]
        new = lives < 0
        lives[new] = self._lives + np.arange(np.count_nonzero(new))
        self._lives += int(np.count_nonzero(new))
        return lives

    def __len__(self) -> int:
        return len(self.frames)

    def __iter__(self) -> Iterator[RecordedFrame]:
        return iter(self.frames)

    def __getitem__(self, index: int) -> RecordedFrame:
        return self.frames[index]

    @property
    def frame_numbers(self) -> range:
        return range(self.first_frame, self.first_frame + len(self.frames))

    def save(self, path: Union[str, "os.PathLike[str]"], compressed: bool = True) -> None:
        """Writes a NumPy archive of arrays over all frames; frame f is at offsets[f]:offsets[f + 1]."""
        counts = [len(frame.ids) for frame in self.frames]
        arrays: Dict[str, Any] = {
            "format": np.int32(FORMAT), "fps": np.float64(self.fps), "first_frame": np.int32(self.first_frame),
            "offsets": np.concatenate([[0], np.cumsum(counts)]).astype(np.int64),
        }
        for name, (width, kind) in FIELDS.items():
            empty = np.empty((0, width) if width > 1 else (0,), kind)
            arrays[name] = np.concatenate([getattr(frame, name) for frame in self.frames] or [empty])
        (np.savez_compressed if compressed else np.savez)(path, **arrays)

    @classmethod
    def load(cls, path: Union[str, "os.PathLike[str]"]) -> "Recording":
        with np.load(path, allow_pickle=False) as archive:
            if "format" not in archive.files or int(archive["format"]) != FORMAT:
                raise ValueError(f"{os.fspath(path)}: not a recording of this version")
            recording = cls(float(archive["fps"]), int(archive["first_frame"]))
            offsets = archive["offsets"]
            arrays = {name: archive[name] for name in FIELDS}
        recording._lives = int(arrays["ids"].max()) + 1 if len(arrays["ids"]) else 0
        for begin, end in zip(offsets[:-1], offsets[1:]):
            recording.frames.append(RecordedFrame(**{name: arrays[name][begin:end] for name in FIELDS}))
        return recording

    def slots(self) -> Tuple[List[NDArray[Any]], int]:
        """The slot of each body for each frame, and the number of slots. A life keeps its slot. After its end the slot stays
        empty for at least two frames, so that interpolation does not move a body from that end to the next start."""
        lives = max((int(frame.ids.max()) + 1 for frame in self.frames if len(frame.ids)), default=0)
        slot_of = np.full(lives, -1, np.int64)
        free: List[int] = []
        empty: List[int] = []
        just_left: List[int] = []
        before = np.empty(0, np.int64)
        count = 0
        result = []
        for frame in self.frames:
            free += empty
            empty = just_left
            just_left = slot_of[np.setdiff1d(before, frame.ids, assume_unique=True)].tolist()
            spawned = frame.ids[slot_of[frame.ids] < 0]
            reused = min(len(free), len(spawned))
            slot_of[spawned[:reused]] = [free.pop() for _ in range(reused)]
            slot_of[spawned[reused:]] = np.arange(count, count + len(spawned) - reused)
            count += len(spawned) - reused
            result.append(slot_of[frame.ids])
            before = frame.ids
        return result, count
