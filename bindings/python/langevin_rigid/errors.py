# SPDX-License-Identifier: MIT
"""Exceptions: a subclass of `Error` for each status, most of them also subclasses of a built-in exception."""
from __future__ import annotations

from typing import Any, Dict, List, NamedTuple, Optional, Type


from .enums import Status


class Fault(NamedTuple):
    """A numbered fault of an asset or of a mesh; docs/reference/asset_format.md explains each number."""

    number: int
    where: str
    what: str
    remedy: str

    def __str__(self) -> str:
        place = f" at {self.where}" if self.where else ""
        return f"fault {self.number}{place}: {self.what} {self.remedy}".rstrip()


class Error(Exception):
    """A refused call. It changed nothing.

    status: a `Status`; None if this package refused, not the library.
    function: the function of the C API that refused, if any.
    faults: of an asset, if any.
    """

    default_status: Optional[Status] = None

    def __init__(self, message: str = "", *, status: Optional[int] = None, function: str = "", faults: Any = ()) -> None:
        super().__init__(message)
        self.message = message
        self.status = Status(status) if status is not None else self.default_status
        self.function = function
        self.faults: List[Fault] = list(faults)

    def __str__(self) -> str:
        return self.message

    def __reduce__(self) -> Any:
        return _rebuild, (type(self), self.message, self.status, self.function, self.faults)


def _rebuild(kind: Type[Error], message: str, status: Any, function: str, faults: Any) -> Error:
    return kind(message, status=status, function=function, faults=faults)


class NullArgumentError(Error, TypeError):
    default_status = Status.NULL_ARGUMENT


class StructSizeError(Error, TypeError):
    default_status = Status.STRUCT_SIZE


class InvalidArgumentError(Error, ValueError):
    default_status = Status.INVALID_ARGUMENT


class NotFiniteError(Error, ValueError):
    default_status = Status.NOT_FINITE


class OutOfMemoryError(Error, MemoryError):
    default_status = Status.OUT_OF_MEMORY


class StaleError(Error, LookupError):
    """The object behind a handle or an id no longer exists."""


class StaleBodyError(StaleError):
    default_status = Status.STALE_BODY


class StaleBatchError(StaleError):
    default_status = Status.STALE_BATCH


class StaleWindSourceError(StaleError):
    default_status = Status.STALE_WIND_SOURCE


class StaleColliderError(StaleError):
    default_status = Status.STALE_COLLIDER


class StaleViewError(StaleError):
    """The world changed after the view was taken: call `Batch.view` again."""


class CapacityError(Error):
    default_status = Status.CAPACITY


class BufferTooSmallError(Error, ValueError):
    default_status = Status.BUFFER_TOO_SMALL


class AssetFileNotFoundError(Error, FileNotFoundError):
    default_status = Status.FILE_NOT_FOUND


class AssetReadError(Error, OSError):
    default_status = Status.FILE_READ


class AssetError(Error, ValueError):
    """Bytes that are not a valid asset; `faults` lists the reasons."""


class AssetFormatError(AssetError):
    default_status = Status.ASSET_FORMAT


class AssetVersionError(AssetError):
    default_status = Status.ASSET_VERSION


class AssetCorruptError(AssetError):
    default_status = Status.ASSET_CORRUPT


class AssetInvalidError(AssetError):
    default_status = Status.ASSET_INVALID


class SnapshotFormatError(Error, ValueError):
    default_status = Status.SNAPSHOT_FORMAT


class SnapshotMismatchError(Error, ValueError):
    default_status = Status.SNAPSHOT_MISMATCH


class UnsupportedError(Error, NotImplementedError):
    default_status = Status.UNSUPPORTED


class ThreadsError(Error, RuntimeError):
    default_status = Status.THREADS


class ConcurrentUseError(Error, RuntimeError):
    """Another thread is inside a call (only with `checks`). `World` detects this itself: `BusyError`."""

    default_status = Status.CONCURRENT_USE


class ReentrantError(Error, RuntimeError):
    """A callback called its own world (only with `checks`). `World` detects this itself: `BusyError`."""

    default_status = Status.REENTRANT


class TimestepError(Error, ValueError):
    """`dt` or `substeps` is out of range; `status` says which."""


class InternalError(Error, RuntimeError):
    default_status = Status.INTERNAL


class ClosedError(Error, ValueError):
    """The world or the asset was closed."""


class BusyError(Error, RuntimeError):
    """The world is inside a call, of another thread or of the one that runs this callback."""


class LibraryError(Error, ImportError):
    """The native library was not found, did not load, or has another version than this package."""


class BakeError(Error, RuntimeError):
    """`lr_bake` refused. `faults` lists its numbered faults; `returncode` is 1 for these, 2 for wrong usage."""

    returncode: int = 1


BY_STATUS: Dict[int, Type[Error]] = {
    kind.default_status: kind
    for kind in list(globals().values())
    if isinstance(kind, type) and issubclass(kind, Error) and kind.default_status is not None
}
for _status in (Status.TIMESTEP_ZERO, Status.TIMESTEP_NEGATIVE, Status.TIMESTEP_NOT_FINITE, Status.TIMESTEP_TOO_LARGE,
                Status.SUBSTEPS):
    BY_STATUS[_status] = TimestepError

__all__ = [
    "AssetCorruptError", "AssetError", "AssetFileNotFoundError", "AssetFormatError", "AssetInvalidError", "AssetReadError",
    "AssetVersionError", "BakeError", "BufferTooSmallError", "BusyError", "CapacityError", "ClosedError", "ConcurrentUseError", "Error",
    "Fault", "InternalError", "InvalidArgumentError", "LibraryError", "NotFiniteError", "NullArgumentError", "OutOfMemoryError",
    "ReentrantError", "SnapshotFormatError", "SnapshotMismatchError", "StaleBatchError", "StaleBodyError", "StaleColliderError",
    "StaleError", "StaleViewError", "StaleWindSourceError", "StructSizeError", "ThreadsError", "TimestepError", "UnsupportedError",
]
