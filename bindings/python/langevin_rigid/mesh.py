# SPDX-License-Identifier: MIT
"""Meshes to draw: polygons with texture coordinates, read from and written to OBJ."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, List, Optional, Union

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray


def rows_of(values: Any, width: int, kind: Any, name: str) -> "NDArray[Any]":
    """An array of shape (n, width), from that or from a flat one."""
    array = np.ascontiguousarray(values, kind)
    if array.size % width or array.ndim > 1 and array.shape[-1] != width:
        raise ValueError(f"{name}: shape {array.shape}, but expected (n, {width})")
    return array.reshape(-1, width)


class Mesh:
    """points: (n, 3). counts: corners of each face. indices: the corners' points, face after face. uvs: (corners, 2) or None."""

    def __init__(self, points: Any, counts: Any, indices: Any, uvs: Any = None) -> None:
        self.points = rows_of(points, 3, np.float64, "points")
        self.counts = np.ascontiguousarray(counts, np.int32)
        self.indices = np.ascontiguousarray(indices, np.int32)
        self.uvs: Optional[NDArray[Any]] = None if uvs is None else np.ascontiguousarray(uvs, np.float64).reshape(-1, 2)
        if self.indices.size != self.counts.sum():
            raise ValueError(f"{self.indices.size} corners, but the faces have {self.counts.sum()}")
        if self.indices.size and not 0 <= self.indices.min() <= self.indices.max() < len(self.points):
            raise ValueError(f"indices are from {self.indices.min()} to {self.indices.max()}, but there are {len(self.points)} points")

    @classmethod
    def from_triangles(cls, vertices: Any, triangles: Any) -> "Mesh":
        triangles = rows_of(triangles, 3, np.int64, "triangles")
        return cls(vertices, np.full(len(triangles), 3), triangles.ravel())

    @classmethod
    def read_obj(cls, path: Union[str, "os.PathLike[str]"]) -> "Mesh":
        """Reads positions, texture coordinates and faces; joins all objects of the file."""
        points: List[List[float]] = []
        texture: List[List[float]] = []
        counts: List[int] = []
        indices: List[int] = []
        corners: List[int] = []
        with open(path, encoding="utf-8", errors="replace") as file:
            for line in file:
                words = line.split()
                if not words:
                    continue
                if words[0] == "v":
                    points.append([float(word) for word in words[1:4]])
                elif words[0] == "vt":
                    texture.append([float(word) for word in words[1:3]])
                elif words[0] == "f":
                    counts.append(len(words) - 1)
                    for word in words[1:]:
                        parts = word.split("/")
                        index = int(parts[0])
                        indices.append(index - 1 if index > 0 else len(points) + index)
                        if len(parts) > 1 and parts[1]:
                            index = int(parts[1])
                            corners.append(index - 1 if index > 0 else len(texture) + index)
        if not counts:
            raise ValueError(f"{os.fspath(path)}: no faces")
        uvs = np.array(texture)[corners] if len(corners) == len(indices) else None
        return cls(points, counts, indices, uvs)

    def write_obj(self, path: Union[str, "os.PathLike[str]"]) -> None:
        lines = [f"v {x!r} {y!r} {z!r}" for x, y, z in self.points.tolist()]
        at = 0
        for count in self.counts.tolist():
            lines.append("f " + " ".join(str(i + 1) for i in self.indices[at:at + count].tolist()))
            at += count
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")

    def moved(self, offset: Any) -> "Mesh":
        """A translated copy. Move by minus `asset.info.center_of_mass`: transforms place the centre of mass."""
        return Mesh(self.points + np.asarray(offset, np.float64), self.counts, self.indices, self.uvs)
