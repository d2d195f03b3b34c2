# SPDX-License-Identifier: MIT
"""USD as text: a PointInstancer for each recording, with the mesh that it draws."""
from __future__ import annotations

import os
import re
from typing import IO, TYPE_CHECKING, Any, Dict, Optional, Sequence, Tuple, Union

import numpy as np

from ..mesh import Mesh
from ..recording import Recording

if TYPE_CHECKING:
    from numpy.typing import NDArray

Pair = Tuple[Recording, Mesh]


def _array(values: NDArray[Any], digits: int) -> str:
    """Numbers, or tuples of numbers, in brackets."""
    if not len(values):
        return "[]"
    if values.ndim == 1:
        if values.dtype.kind in "iu":
            return "[" + ", ".join(map(str, values.tolist())) + "]"
        return "[" + ", ".join(f"{v:.{digits}g}" for v in values.tolist()) + "]"
    item = "(" + ", ".join([f"%.{digits}g"] * values.shape[1]) + ")"
    return "[" + ", ".join([item] * len(values)) % tuple(values.ravel().tolist()) + "]"


def _samples(file: IO[str], indent: str, declaration: str, recording: Recording, values: Any, digits: int) -> None:
    file.write(f"{indent}{declaration}.timeSamples = {{\n")
    for number, frame in zip(recording.frame_numbers, recording):
        file.write(f"{indent}    {number}: {_array(values(frame), digits)},\n")
    file.write(f"{indent}}}\n")


def _name(text: str, taken: Dict[str, int]) -> str:
    """A USD identifier that is not taken yet."""
    name = re.sub(r"[^A-Za-z0-9_]", "_", text) or "Bodies"
    name = name if not name[0].isdigit() else "_" + name
    taken[name] = taken.get(name, 0) + 1
    return name if taken[name] == 1 else f"{name}_{taken[name]}"


def _mesh(file: IO[str], indent: str, mesh: Mesh, color: Sequence[float]) -> None:
    low, high = mesh.points.min(axis=0), mesh.points.max(axis=0)
    lines = [
        f'{indent}def Mesh "Prototype"', f"{indent}{{",
        f"{indent}    float3[] extent = {_array(np.stack([low, high]), 9)}",
        f"{indent}    int[] faceVertexCounts = {_array(mesh.counts, 9)}",
        f"{indent}    int[] faceVertexIndices = {_array(mesh.indices, 9)}",
        f"{indent}    point3f[] points = {_array(mesh.points, 9)}",
        f"{indent}    color3f[] primvars:displayColor = [({', '.join(f'{c:.6g}' for c in color)})]",
        f"{indent}    uniform bool doubleSided = 1",
        f'{indent}    uniform token subdivisionScheme = "none"',
    ]
    if mesh.uvs is not None:
        lines += [f"{indent}    texCoord2f[] primvars:st = {_array(mesh.uvs, 7)} (",
                  f'{indent}        interpolation = "faceVarying"', f"{indent}    )"]
    file.write("\n".join(lines) + f"\n{indent}}}\n")


def _extent(mesh: Mesh, frame: Any) -> NDArray[Any]:
    """A box that contains every body in any orientation."""
    if not len(frame.ids):
        return np.zeros((2, 3))
    reach = frame.scale[:, None] * np.linalg.norm(mesh.points, axis=1).max()
    return np.stack([(frame.position - reach).min(axis=0), (frame.position + reach).max(axis=0)])


def write_usda(path: Union[str, "os.PathLike[str]"], recordings: Union[Recording, Sequence[Pair]], mesh: Optional[Mesh] = None,
               *, up_axis: str = "Y", names: Optional[Sequence[str]] = None,
               color: Sequence[float] = (0.55, 0.35, 0.12)) -> None:
    """Writes recordings as point instancers with time samples, each with the mesh to draw.

    recordings: a recording, with `mesh`, or pairs of a recording and its mesh. Meshes have their origin at the centre of mass:
        Mesh.moved(-asset.info.center_of_mass). up_axis: that of the stepped world, "Y" or "Z"; nothing is rotated.

    Bodies have ids, and velocities (m/s) and angularVelocities (degrees/s) for motion blur. Bodies can come and go. Orientations
    are half precision, as USD requires: within about 0.05 degrees.
    """
    if isinstance(recordings, Recording):
        if mesh is None:
            raise TypeError("a recording needs a mesh to draw its bodies")
        recordings = [(recordings, mesh)]
    pairs = list(recordings)
    if up_axis not in ("Y", "Z"):
        raise ValueError(f'up_axis is "Y" or "Z", not {up_axis!r}')
    rates = {recording.fps for recording, _ in pairs}
    if len(rates) != 1:
        raise ValueError(f"all recordings of a file need the same rate, not {sorted(rates)}")
    if any(not len(recording) for recording, _ in pairs):
        raise ValueError("a recording has no frames")
    first = min(recording.first_frame for recording, _ in pairs)
    last = max(recording.frame_numbers[-1] for recording, _ in pairs)
    fps = rates.pop()
    taken: Dict[str, int] = {}
    with open(path, "w", encoding="utf-8", newline="\n") as file:
        file.write(f'#usda 1.0\n(\n    defaultPrim = "Storm"\n    doc = "Langevin Rigid"\n    endTimeCode = {last}\n'
                   f"    framesPerSecond = {fps:.9g}\n    metersPerUnit = 1\n    startTimeCode = {first}\n"
                   f'    timeCodesPerSecond = {fps:.9g}\n    upAxis = "{up_axis}"\n)\n\ndef Xform "Storm"\n{{\n')
        for at, (recording, drawn) in enumerate(pairs):
            name = _name(names[at] if names else "Bodies", taken)
            indent = " " * 8
            file.write(f'    def PointInstancer "{name}"\n    {{\n{indent}rel prototypes = </Storm/{name}/Prototype>\n')

            def write(declaration: str, values: Any, digits: int = 7) -> None:
                _samples(file, indent, declaration, recording, values, digits)

            write("float3[] extent", lambda frame: _extent(drawn, frame))
            write("int[] protoIndices", lambda frame: np.zeros(len(frame.ids), np.int32))
            write("int64[] ids", lambda frame: frame.ids)
            write("point3f[] positions", lambda frame: frame.position, 9)
            write("quath[] orientations", lambda frame: frame.orientation[:, [3, 0, 1, 2]], 5)
            write("float3[] scales", lambda frame: np.repeat(frame.scale[:, None], 3, axis=1))
            write("vector3f[] velocities", lambda frame: frame.velocity)
            write("vector3f[] angularVelocities", lambda frame: np.degrees(frame.spin))
            file.write("\n")
            _mesh(file, indent, drawn, color)
            file.write("    }\n")
        file.write("}\n")
