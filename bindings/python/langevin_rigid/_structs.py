# SPDX-License-Identifier: MIT
"""Fills the library's structs from keywords, on top of the library's defaults."""
from __future__ import annotations

import ctypes
import difflib
import inspect
import operator
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterable, List, Mapping, Tuple, Type, TypeVar

import numpy as np

from . import _native as native
from ._library import call
from ._record import Record

if TYPE_CHECKING:
    from numpy.typing import NDArray

F = TypeVar("F", bound=Callable[..., Any])
_DTYPES: Dict[Any, Any] = {}
_INTEGERS = {ctypes.c_int8, ctypes.c_uint8, ctypes.c_int16, ctypes.c_uint16, ctypes.c_int32, ctypes.c_uint32, ctypes.c_int64,
             ctypes.c_uint64}
_FLOATS = {ctypes.c_float, ctypes.c_double}


def dtype(struct: Any) -> Any:
    """The NumPy type of an array of a struct, or of a scalar."""
    if struct not in _DTYPES:
        _DTYPES[struct] = np.dtype(struct)
    return _DTYPES[struct]


def init(struct: Type[Any]) -> Any:
    """A struct with its defaults."""
    value = struct()
    name = native.INITS.get(struct.__name__)
    if name:
        call(name, ctypes.byref(value), ctypes.sizeof(struct))
    return value


def integer(value: Any, kind: Any, name: str) -> int:
    """The value, if it is within the type's range: ctypes would truncate it silently."""
    number = operator.index(value)
    bits = 8 * ctypes.sizeof(kind)
    signed = kind(-1).value < 0
    low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if signed else (0, (1 << bits) - 1)
    if not low <= number <= high:
        raise OverflowError(f"{name}: {number} is not from {low} to {high}")
    return number


def address(array: NDArray[Any], of: Any) -> Any:
    """A pointer to an array's first element; the caller keeps the array alive."""
    return ctypes.cast(array.ctypes.data, ctypes.POINTER(of))


def contiguous(values: Any, of: Any, name: str) -> NDArray[Any]:
    """Values as a contiguous array of C's type; copied only if necessary."""
    if of in _INTEGERS:
        array = np.asarray(values)
        whole = array.dtype.kind in "iub"
        if not whole and not isinstance(values, np.ndarray):  # NumPy makes floats of integers on both sides of 2^63
            objects = np.asarray(values, object)
            whole = all(isinstance(value, (int, np.integer)) for value in objects.flat)
            array = objects if whole else array
        if array.size and not whole:
            raise TypeError(f"{name}: expected integers, not {array.dtype}")
        if array.dtype != dtype(of) and array.size:
            info = np.iinfo(dtype(of))
            if int(array.min()) < info.min or int(array.max()) > info.max:
                raise OverflowError(f"{name}: values are not from {info.min} to {info.max}")
        return np.ascontiguousarray(array, dtype(of))
    return np.ascontiguousarray(values, dtype(of))


def vectors(values: Any, width: int, count: int, name: str) -> NDArray[Any]:
    """`count` vectors, from as many or from a single one."""
    array = np.asarray(values, np.float32)
    if array.shape not in ((width,), (1, width), (count, width)):
        raise ValueError(f"{name}: shape {array.shape} is neither ({width},) nor ({count}, {width})")
    return np.broadcast_to(array, (count, width))


def scalars(values: Any, of: Any, count: int, name: str) -> NDArray[Any]:
    """`count` numbers, from as many or from a single one."""
    array = contiguous(values, of, name)
    if array.shape not in ((1,), (count,)):
        raise ValueError(f"{name}: shape {array.shape} is neither () nor ({count},)")
    return array


def rows(values: Any, width: int, name: str) -> NDArray[Any]:
    """Vectors as an array of shape (count, width), from one vector or an array that ends with the width."""
    array = np.ascontiguousarray(values, np.float32)
    if array.ndim == 0 or array.shape[-1] != width:
        raise ValueError(f"{name}: shape {array.shape} does not end with {width}")
    return array.reshape(-1, width)


def check_names(struct: Type[Any], fields: Iterable[str], hidden: Tuple[str, ...] = ()) -> None:
    known = [name for name in native.FIELD_DOCS[struct.__name__] if name not in hidden]
    for name in fields:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1)
            raise TypeError(f"{struct.__name__} has no {name!r}" + (f": is {near[0]!r} meant?" if near else
                                                                  f"; it has {', '.join(known)}"))


def assign(value: Any, fields: Mapping[str, Any], keep: List[Any]) -> Any:
    """Fills fields of a struct. None leaves the default. Objects that the struct points to are added to `keep`."""
    struct = type(value)
    check_names(struct, fields)
    kinds = dict(struct._fields_)
    for name, given in fields.items():
        if given is None:
            continue
        kind = kinds[name]
        if kind in _INTEGERS or kind in _FLOATS:
            try:
                number = integer(given, kind, name) if kind in _INTEGERS else float(given)
            except TypeError as error:
                shape = np.shape(given)
                raise TypeError(f"{name}: shape {shape}, but it is one number" if shape else f"{name}: {error}") from None
            setattr(value, name, number)
        elif issubclass(kind, ctypes.Array):
            _assign_array(value, name, kind, given, keep)
        elif issubclass(kind, ctypes._Pointer):
            setattr(value, name, _pointer(name, kind._type_, given, keep))
        else:
            setattr(value, name, given)
    return value


def _assign_array(value: Any, name: str, kind: Any, given: Any, keep: List[Any]) -> None:
    of, length = kind._type_, kind._length_
    if issubclass(of, ctypes.Structure):
        items = list(given)
        if len(items) > length:
            raise ValueError(f"{name}: {len(items)}, but at most {length} are taken")
        for at, item in enumerate(items):
            getattr(value, name)[at] = item if isinstance(item, of) else assign(init(of), item, keep)
        setattr(value, name[:-1] + "_count", len(items))
        return
    array = np.asarray(given, dtype(of)).ravel()
    if array.size != length:
        raise ValueError(f"{name}: {array.size} numbers, but it has {length}")
    getattr(value, name)[:] = array.tolist()


def _pointer(name: str, of: Any, given: Any, keep: List[Any]) -> Any:
    if hasattr(given, "_as_parameter_"):  # an asset
        keep.append(given)
        return given._as_parameter_
    if issubclass(of, ctypes.Structure):
        struct = given if isinstance(given, of) else assign(init(of), as_fields(given), keep)
        keep.append(struct)
        return ctypes.pointer(struct)
    array = contiguous(given, of, name)
    keep.append(array)
    return address(array, of)


def as_fields(given: Any) -> Mapping[str, Any]:
    return given.as_dict() if isinstance(given, Record) else given


def make(struct: Type[Any], fields: Mapping[str, Any], keep: List[Any]) -> Any:
    return assign(init(struct), fields, keep)


def elements(struct: Type[Any], count: int) -> NDArray[Any]:
    """An array of structs with their defaults."""
    one = np.frombuffer(init(struct), np.uint8)
    array = np.empty((count, one.size), np.uint8)
    array[:] = one
    return array.view(dtype(struct))[:, 0]


class _Initial:
    """A placeholder for the library's default in help()."""

    def __repr__(self) -> str:
        return "<initial>"


def takes(struct: str, *hidden: str) -> Callable[[F], F]:
    """Shows help() and editors the keywords that a function passes to a struct."""
    def decorate(function: F) -> F:
        docs = {name: text for name, text in native.FIELD_DOCS[struct].items() if name not in hidden}
        lines = [f"    {name}: {text}" if text else f"    {name}" for name, text in docs.items()]
        function.__doc__ = inspect.cleandoc(function.__doc__ or "") + "\n\nKeywords:\n" + "\n".join(lines)
        signature = inspect.signature(function)
        own = [p for p in signature.parameters.values() if p.kind is not inspect.Parameter.VAR_KEYWORD]
        names = {p.name for p in own}
        more = [inspect.Parameter(name, inspect.Parameter.KEYWORD_ONLY, default=_Initial()) for name in docs if name not in names]
        function.__signature__ = signature.replace(parameters=own + more)  # type: ignore[attr-defined]
        return function
    return decorate
