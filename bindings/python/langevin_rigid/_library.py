# SPDX-License-Identifier: MIT
"""Finds, loads and checks the native library when it is first used."""
from __future__ import annotations

import ctypes
import ctypes.util
import os
import pathlib
import sys
import threading
from typing import Any, Iterator, List, Optional, Tuple

from . import _native as native
from .errors import BY_STATUS, Error, LibraryError

PACKAGE = pathlib.Path(__file__).resolve().parent
_lock = threading.Lock()
_library: Optional[Any] = None
_path = ""


def file_names() -> List[str]:
    if sys.platform == "win32":
        return ["langevin_rigid.dll", "liblangevin_rigid.dll"]
    major = native.VERSION[0]
    if sys.platform == "darwin":
        return [f"liblangevin_rigid.{major}.dylib", "liblangevin_rigid.dylib"]
    return [f"liblangevin_rigid.so.{major}", "liblangevin_rigid.so"]


def candidates() -> Iterator[Tuple[str, bool]]:
    """Yields places of the library, and whether a file there that does not load ends the search."""
    chosen = os.environ.get("LANGEVIN_RIGID_LIBRARY")
    if chosen:
        path = pathlib.Path(chosen).expanduser()
        if path.is_dir():
            for name in file_names():
                if (path / name).exists():
                    yield str(path / name), True
                    return
        yield str(path), True
        return
    for folder in (PACKAGE / "lib", PACKAGE):
        for name in file_names():
            if (folder / name).exists():
                yield str(folder / name), True
    found = ctypes.util.find_library("langevin_rigid")
    if found:
        yield found, False
    for name in file_names():
        yield name, False


def version_text(packed: int) -> str:
    return f"{packed >> 22}.{packed >> 12 & 0x3FF}.{packed & 0xFFF}"


def check_version(packed: int, path: str) -> None:
    """Requires the same ABI: the same major version, before 1.0 also the same minor version, and no older patch."""
    major, minor, patch = packed >> 22, packed >> 12 & 0x3FF, packed & 0xFFF
    wanted = native.VERSION
    fits = major == wanted[0] and (minor == wanted[1] if major == 0 else minor >= wanted[1])
    if not fits or (minor == wanted[1] and patch < wanted[2]):
        raise LibraryError(
            f"{path} is version {version_text(packed)}, but this Python package is for {'.'.join(map(str, wanted))}: install "
            "both from the same release, or set LANGEVIN_RIGID_LIBRARY to the library that belongs to the package")


def _load() -> Tuple[Any, str]:
    tried = []
    for path, final in candidates():
        try:
            library = ctypes.CDLL(path)
        except OSError as error:
            tried.append(f"  {path}: {error}")
            if final:
                break
            continue
        try:
            library.lr_version.restype = ctypes.c_uint32
            packed = library.lr_version()
        except AttributeError:
            raise LibraryError(f"{path} is another library: it has no lr_version") from None
        check_version(packed, path)
        try:
            return native.bind(library), path
        except AttributeError as error:
            raise LibraryError(f"{path} is version {version_text(packed)}, but lacks a function of it: {error}") from None
    raise LibraryError(
        "the native library of Langevin Rigid could not be loaded. Set LANGEVIN_RIGID_LIBRARY to the file or its folder, put it "
        f"beside this package in {PACKAGE / 'lib'}, or install it where the system finds libraries. Tried:\n" + "\n".join(tried))


def library() -> Any:
    """The loaded library, with all prototypes."""
    global _library, _path
    if _library is None:
        with _lock:
            if _library is None:
                _library, _path = _load()
    return _library


def library_path() -> str:
    """The path of the loaded native library."""
    library()
    return _path


def version() -> Tuple[int, int, int]:
    """The version of the native library: major, minor, patch."""
    packed = library().lr_version()
    return packed >> 22, packed >> 12 & 0x3FF, packed & 0xFFF


def status_string(status: int) -> str:
    return library().lr_status_string(status).decode()


def error(status: int, function: str, detail: str = "", faults: Any = ()) -> Error:
    """The exception for a status."""
    kind = BY_STATUS.get(status, Error)
    detail = detail or status_string(status)
    message = detail if detail.startswith(function) else f"{function}: {detail}"
    faults = list(faults)
    if faults:
        message += "".join(f"\n  {fault}" for fault in faults)
    known = status in BY_STATUS
    return kind(message, status=status if known else None, function=function, faults=faults)


def call(name: str, *arguments: Any) -> None:
    """Calls a function that returns a status and takes no world; raises the error of that status."""
    status = getattr(library(), name)(*arguments)
    if status:
        raise error(status, name, library().lr_last_error().decode(errors="replace"))
