# SPDX-License-Identifier: MIT
"""Runs `lr_bake`, which makes assets from meshes, and reads its report."""
from __future__ import annotations

import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from typing import TYPE_CHECKING, Any, Dict, List, Sequence, Union

from ._library import PACKAGE, library_path
from .errors import BakeError, Fault, LibraryError

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

Path = Union[str, "os.PathLike[str]"]
FAULT = re.compile(r"^(?:(?P<file>.*?): )?error (?P<number>\d+)(?: at (?P<where>.*?))?: (?P<what>.*?\.)(?: (?P<remedy>.*))?$")


def baker_path() -> str:
    """The path of `lr_bake`: LANGEVIN_RIGID_BAKE, beside this package, bin/ beside the library's folder, or the PATH."""
    name = "lr_bake.exe" if sys.platform == "win32" else "lr_bake"
    chosen = os.environ.get("LANGEVIN_RIGID_BAKE")
    if chosen:
        path = pathlib.Path(chosen).expanduser()
        path = path / name if path.is_dir() else path
        if not path.is_file():
            raise BakeError(f"LANGEVIN_RIGID_BAKE is {chosen}, but there is no such file")
        return str(path)
    folders = [PACKAGE / "bin"]
    try:
        loaded = pathlib.Path(library_path())
        if loaded.is_absolute():
            folders += [loaded.parent, loaded.resolve().parent.parent / "bin"]
    except LibraryError:
        pass
    for folder in folders:
        path = folder / name
        if path.is_file():
            if not os.access(path, os.X_OK):  # Blender and zipfile unpack wheels without this permission
                path.chmod(path.stat().st_mode | 0o111)
            return str(path)
    found = shutil.which(name)
    if found is None:
        raise BakeError(f"{name} was not found in {', '.join(map(str, folders))} nor on the PATH: set LANGEVIN_RIGID_BAKE to it")
    return found


def _numbers(values: Any) -> str:
    return ",".join(repr(float(v)) for v in values)


def _arguments(options: Dict[str, Any]) -> List[str]:
    """Turns keywords into the tool's options: density=350 is --density 350, sheet=True is --sheet."""
    arguments = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        arguments.append("--" + name.replace("_", "-"))
        if value is True:
            continue
        if isinstance(value, (str, os.PathLike)):
            arguments.append(os.fspath(value))
        elif isinstance(value, (int, float)) or hasattr(value, "__float__") and getattr(value, "ndim", 0) == 0:
            arguments.append(repr(value) if isinstance(value, int) else repr(float(value)))
        elif name == "grid":
            arguments.append(",".join(str(int(v)) for v in value))
        else:
            arguments.append(_numbers(value))
    return arguments


def _run(arguments: Sequence[str]) -> "subprocess.CompletedProcess[str]":
    result = subprocess.run([baker_path(), *arguments], stdin=subprocess.DEVNULL, capture_output=True, text=True,
                            encoding="utf-8", errors="replace", check=False)
    if result.returncode:
        faults = []
        for line in result.stderr.splitlines():
            match = FAULT.match(line)
            if match:
                faults.append(Fault(int(match["number"]), match["where"] or "", match["what"], match["remedy"] or ""))
        said = "\n".join(line for line in result.stderr.splitlines() if FAULT.match(line)) or result.stderr.strip() or \
            f"exit code {result.returncode}"
        error = BakeError(f"lr_bake: {said}", faults=faults)
        error.returncode = result.returncode
        raise error
    return result


def _bake(command: str, inputs: Sequence[str], output: Path, options: Dict[str, Any]) -> Dict[str, Any]:
    with tempfile.TemporaryDirectory(prefix="langevin_rigid_") as folder:
        report = options.pop("report", None) or os.path.join(folder, "report.json")
        _run([command, *inputs, "--output", os.fspath(output), "--report", os.fspath(report), "--quiet", *_arguments(options)])
        with open(report, encoding="utf-8") as file:
            return json.load(file)


def bake(mesh: Path, output: Path, **options: Any) -> Dict[str, Any]:
    """Bakes an asset from a mesh file (OBJ, STL, PLY, glTF, FBX, Collada) and returns the report.

    Options are those of `lr_bake mesh`, with _ for -: density=350, unit="cm", up="y", sheet=True, thickness=2e-4,
    areal_density=0.08, fluid="water", grid=(32, 32, 16), center_of_mass=(0, 0, 0.01), name="leaf", if_changed=True.
    Raises `BakeError`; its `faults` have a number, a place and a remedy.
    """
    return _bake("mesh", [os.fspath(mesh)], output, options)


def bake_card(image: Path, output: Path, *, width: float, thickness: float, **options: Any) -> Dict[str, Any]:
    """Bakes an asset from the alpha channel of a leaf's picture (PNG). Options are those of `lr_bake card`."""
    return _bake("card", [os.fspath(image)], output, {"width": width, "thickness": thickness, **options})


def bake_ellipsoid(semi_axes: "Sequence[float]", output: Path, **options: Any) -> Dict[str, Any]:
    """Bakes an asset of a solid ellipsoid. Options are those of `lr_bake ellipsoid`."""
    return _bake("ellipsoid", [repr(float(a)) for a in semi_axes], output, options)


def bake_triangles(vertices: "ArrayLike", triangles: "ArrayLike", output: Path, **options: Any) -> Dict[str, Any]:
    """Bakes an asset from triangles in memory: (n, 3) positions, (m, 3) indices. Options are those of `bake`."""
    from .mesh import Mesh
    with tempfile.TemporaryDirectory(prefix="langevin_rigid_") as folder:
        path = os.path.join(folder, "mesh.obj")
        Mesh.from_triangles(vertices, triangles).write_obj(path)
        options.setdefault("name", pathlib.Path(output).stem)
        return bake(path, output, **options)


def inspect_asset(path: Path) -> Dict[str, Any]:
    """The report of `lr_bake info` for an asset file."""
    return json.loads(_run(["info", os.fspath(path), "--json"]).stdout)
