# SPDX-License-Identifier: MIT
"""Structs of the library, copied into immutable Python objects."""
from __future__ import annotations

import ctypes
from typing import Any, Dict, Type, TypeVar

import numpy as np

MATRICES = {9: (3, 3), 36: (6, 6)}
R = TypeVar("R", bound="Record")


class Record:
    """Fields as in C. Arrays are NumPy arrays, matrices have two dimensions."""

    __slots__: Any = ()
    _enums: Dict[str, Any] = {}

    def __init__(self, **fields: Any) -> None:
        for name in self.__slots__:
            object.__setattr__(self, name, fields.pop(name))
        if fields:
            raise TypeError(f"{type(self).__name__} has no {', '.join(fields)}")

    @classmethod
    def read(cls: Type[R], struct: Any, **others: Any) -> R:
        return cls(**{name: others[name] if name in others else _python(name, getattr(struct, name), cls._enums.get(name))
                      for name in cls.__slots__})

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{type(self).__name__} is read-only: make a changed copy by replace({name}=...)")

    def as_dict(self) -> Dict[str, Any]:
        return {name: getattr(self, name) for name in self.__slots__}

    def replace(self: R, **fields: Any) -> R:
        """A copy with other values for some fields."""
        return type(self)(**{**self.as_dict(), **fields})

    def __repr__(self) -> str:
        return f"{type(self).__name__}({', '.join(f'{k}={v!r}' for k, v in self.as_dict().items())})"

    def __reduce__(self) -> Any:
        return _again, (type(self), self.as_dict())


def _again(cls: Type[R], fields: Dict[str, Any]) -> R:
    return cls(**fields)


def _python(name: str, value: Any, enum: Any) -> Any:
    if isinstance(value, bytes):
        return value.decode("utf-8", "replace")
    if isinstance(value, ctypes.Array):
        array = np.array(value)
        shape = MATRICES.get(array.size)
        return array.reshape(shape) if shape and name != "gradient" else array
    return enum(value) if enum else value
