# SPDX-License-Identifier: MIT
"""Assets: the baked properties of a body's shape."""
from __future__ import annotations

import ctypes
import os
from typing import TYPE_CHECKING, Any, List, Optional, Union

from . import _native as native
from ._records import Aerodynamics, AssetInfo
from ._library import call, error, library
from ._structs import init, make, takes
from .errors import ClosedError, Fault

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._options import EllipsoidOptions, RigidOptions


class Asset:
    """An immutable asset. Any number of worlds and threads can share it; it is freed with its last user.

    Create it with `Asset.load`, `Asset.from_bytes`, `Asset.ellipsoid` or `Asset.rigid`.
    """

    def __init__(self, pointer: Any) -> None:
        self._pointer = pointer
        self._release = library().lr_asset_release
        self._info: Optional[AssetInfo] = None

    @classmethod
    def load(cls, path: Union[str, "os.PathLike[str]"]) -> "Asset":
        """Loads a file made by `lr_bake`. A damaged file raises an `AssetError` with numbered faults."""
        name = os.fspath(path)
        pointer = ctypes.POINTER(native.lr_asset)()
        status = library().lr_asset_load_file(name.encode("utf-8"), ctypes.byref(pointer))
        if status:
            faults = []
            if status <= native.LR_ERROR_ASSET_FORMAT and status >= native.LR_ERROR_ASSET_INVALID:
                try:
                    with open(name, "rb") as file:
                        faults = check_asset(file.read())
                except OSError:
                    pass
            raise error(status, "lr_asset_load_file", f"{name}: {library().lr_status_string(status).decode()}", faults)
        return cls(pointer)

    @classmethod
    def from_bytes(cls, data: Any) -> "Asset":
        """Loads an asset from bytes in memory."""
        view = memoryview(data).cast("B")
        buffer = (ctypes.c_char * view.nbytes).from_buffer_copy(view)
        pointer = ctypes.POINTER(native.lr_asset)()
        status = library().lr_asset_load_memory(buffer, view.nbytes, ctypes.byref(pointer))
        if status:
            raise error(status, "lr_asset_load_memory", faults=check_asset(data))
        return cls(pointer)

    @classmethod
    @takes("lr_ellipsoid_desc")
    def ellipsoid(cls, **options: "Unpack[EllipsoidOptions]") -> "Asset":
        """Creates a solid ellipsoid from closed forms, without a file."""
        pointer = ctypes.POINTER(native.lr_asset)()
        desc = make(native.lr_ellipsoid_desc, options, [])
        call("lr_asset_create_ellipsoid", ctypes.byref(desc), ctypes.byref(pointer))
        return cls(pointer)

    @classmethod
    @takes("lr_rigid_desc")
    def rigid(cls, **options: "Unpack[RigidOptions]") -> "Asset":
        """Creates a body with the given coefficients. aerodynamics: an `Aerodynamics`, or a dict of its fields."""
        keep: List[Any] = []
        pointer = ctypes.POINTER(native.lr_asset)()
        desc = make(native.lr_rigid_desc, options, keep)
        call("lr_asset_create_rigid", ctypes.byref(desc), ctypes.byref(pointer))
        return cls(pointer)

    @property
    def _as_parameter_(self) -> Any:
        if self._pointer is None:
            raise ClosedError("the asset was closed")
        return self._pointer

    @property
    def info(self) -> AssetInfo:
        """Mass, inertia, added mass and other properties."""
        if self._info is None:
            info = init(native.lr_asset_info)
            call("lr_asset_get_info", self._as_parameter_, ctypes.byref(info))
            self._info = AssetInfo.read(info)
        return self._info

    @property
    def aerodynamics(self) -> Aerodynamics:
        """The baked coefficients of the quasi-steady loads. Pass a changed copy (`replace`) to `Batch.set_aerodynamics`."""
        value = init(native.lr_aerodynamics)
        call("lr_asset_get_aerodynamics", self._as_parameter_, ctypes.byref(value))
        return Aerodynamics.read(value)

    def close(self) -> None:
        """Releases this reference; batches keep their own."""
        pointer, self._pointer = self._pointer, None
        if pointer is not None:
            self._release(pointer)

    def __copy__(self) -> "Asset":
        call("lr_asset_retain", self._as_parameter_)
        return type(self)(self._pointer)

    def __enter__(self) -> "Asset":
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    def __del__(self) -> None:
        if getattr(self, "_pointer", None) is not None:
            self.close()

    def __repr__(self) -> str:
        if self._pointer is None:
            return "<Asset, closed>"
        return f"<Asset {self.info.name!r}, {self.info.mass:.3g} kg, {self.info.length_d:.3g} m>"


def check_asset(data: Any) -> List[Fault]:
    """Lists all faults of an asset in memory."""
    view = memoryview(data).cast("B")
    buffer = (ctypes.c_char * view.nbytes).from_buffer_copy(view)
    faults: List[Fault] = []

    def report(_: Any, number: int, where: bytes, what: bytes, remedy: bytes) -> None:
        faults.append(Fault(number, *((text or b"").decode("utf-8", "replace") for text in (where, what, remedy))))

    library().lr_asset_check_memory(buffer, view.nbytes, native.lr_fault_fn(report), None)
    return faults
