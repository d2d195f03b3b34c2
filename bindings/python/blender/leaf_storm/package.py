# SPDX-License-Identifier: MIT
"""Finds the Python package langevin_rigid, which contains the native library and lr_bake."""
import importlib.util
import os
import pathlib
import sys
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent


def unpacked(wheel):
    """The folder of an unpacked wheel beside it. Its name contains the version: an update never mixes with older files."""
    folder = wheel.with_suffix("")
    if not folder.is_dir():
        with tempfile.TemporaryDirectory(dir=wheel.parent) as work:
            with zipfile.ZipFile(wheel) as archive:
                archive.extractall(os.path.join(work, "files"))
            try:
                os.rename(os.path.join(work, "files"), folder)
            except OSError:
                if not folder.is_dir():  # else another Blender was faster
                    raise
    return folder


def places():
    """Folders that may hold the package: one that the user names, the source tree's, the wheel of the add-on's zip."""
    chosen = os.environ.get("LANGEVIN_RIGID_PYTHON")
    if chosen:
        yield pathlib.Path(chosen).expanduser()
    if len(HERE.parents) > 1:
        yield HERE.parents[1]
    for wheel in sorted((HERE / "wheels").glob("langevin_rigid-*.whl")):
        yield unpacked(wheel)


def find():
    """Makes langevin_rigid importable. Blender 4.2 and later have installed the wheel already."""
    if importlib.util.find_spec("langevin_rigid") is None:
        for folder in places():
            if (folder / "langevin_rigid").is_dir():
                sys.path.append(str(folder))
                break
    try:
        import langevin_rigid  # noqa: F401
    except ModuleNotFoundError as error:
        raise ImportError(f"Leaf Storm needs {error.name} in Blender's Python: install the add-on's zip, which contains it, or set "
                          "LANGEVIN_RIGID_PYTHON to the folder that has it") from error
