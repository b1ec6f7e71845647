# SPDX-License-Identifier: MIT
"""Arguments of calls, checked where they come in: whatever is wrong is an InputError that names the
argument and says what is accepted."""

from __future__ import annotations

import errno
import os
from collections.abc import Mapping, Sequence
from operator import index
from typing import Any
from unicodedata import category

import numpy as np

from .errors import InputError

_SHOWN = 60  #: characters of a value that an error shows


def shown(value: Any) -> str:
    """A value as an error shows it: on one line, and not all of a long one."""
    try:
        said = " ".join(repr(value).split())
    except Exception:  # a value whose own repr fails is refused all the same
        said = ""
    said = said or f"a {type(value).__name__}"
    return said if len(said) <= _SHOWN else f"{said[:_SHOWN]}..."


def is_pint(value: Any) -> bool:
    """Whether a value is a quantity of pint, which need not be there."""
    return hasattr(value, "magnitude") and hasattr(value, "units")


def text(value: Any, what: str) -> str:
    if not isinstance(value, str):
        raise InputError(f"{what}: {shown(value)} is not a text")
    try:
        value.encode()
    except UnicodeEncodeError:
        raise InputError(f"{what}: {shown(value)} has a character that is not text") from None
    return str(value)


def word(value: Any, what: str) -> str:
    """A text on one line, as names are."""
    said = text(value, what)
    if any(category(character) == "Cc" for character in said):
        raise InputError(f"{what}: {shown(said)} has control characters")
    return said


def optional_text(value: Any, what: str) -> str | None:
    return None if value is None else text(value, what)


def path(value: Any, what: str = "path") -> str:
    """The path of a file or a folder."""
    try:
        place = os.fspath(value)
    except TypeError:
        place = None
    if not isinstance(place, str):
        raise InputError(f"{what}: {shown(value)} is not a path; a text or a pathlib.Path is accepted")
    if place in ("", ".") or "\0" in place:
        raise InputError(f"{what}: {shown(place)} is not the name of a file")
    return text(place, what)


def optional_path(value: Any, what: str = "path") -> str | None:
    return None if value is None else path(value, what)


def record_path(value: Any) -> str:
    """The file of a study's record, whose folder must be there; "" where none is named."""
    if value is None:
        return ""
    place = path(value, "record")
    if not os.path.isdir(os.path.dirname(place) or "."):
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), place)
    return place


def flag(value: Any, what: str) -> bool:
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    raise InputError(f"{what}: {shown(value)} is neither True nor False")


def whole(value: Any, what: str, least: int = 0, most: int | None = None) -> int:
    """A whole number from `least`, to `most` where there is such."""
    try:
        number = least - 1 if isinstance(value, (bool, np.bool_)) else index(value)
    except TypeError:
        number = least - 1
    if number < least or (most is not None and number > most):
        accepted = f"from {least}" if most is None else f"from {least} to {most}"
        raise InputError(f"{what}: {shown(value)} is not a whole number {accepted}")
    return number


def optional_whole(value: Any, what: str, least: int, most: int) -> int | None:
    return None if value is None else whole(value, what, least, most)


def place(value: Any, what: str, size: int) -> int:
    """The index of one of `size` things, counted from 0, or from the end as in a list. Raises IndexError
    where there is none, as lists do."""
    try:
        number = index(value)
    except TypeError:
        raise InputError(f"{what}: {shown(value)} is not a whole number") from None
    if not -size <= number < size:
        raise IndexError(f"{what} {number}: there are {size}, counted from 0")
    return number % size


def mapping(value: Any, what: str, example: str = "") -> dict[str, Any]:
    """A dict whose keys are names; an empty one where none is given."""
    if value is None:
        return {}
    if not isinstance(value, Mapping):
        like = f" such as {example}" if example else ""
        raise InputError(f"{what}: {shown(value)} is not a dict{like}")
    for name in value:
        if not isinstance(name, str):
            raise InputError(f"{what}: the name {shown(name)} is not a text")
    return dict(value)


def sequence(value: Any, what: str, example: str = "") -> list[Any]:
    """A list of anything; an empty one if none is given. A text is not a list."""
    if value is None:
        return []
    if isinstance(value, np.ndarray) and value.ndim == 1:
        return value.tolist()
    if isinstance(value, Sequence) and not isinstance(value, (str, bytes, bytearray)):
        return list(value)
    like = f" such as {example}" if example else ""
    raise InputError(f"{what}: {shown(value)} is not a list{like}")


def texts(value: Any, what: str) -> list[str]:
    """A list of texts."""
    return [text(item, what) for item in sequence(value, what)]


def _real(value: Any) -> float:
    """One of an array of objects: whole numbers of any size, fractions and so on."""
    if value is None or isinstance(value, (str, bytes, bool, np.bool_)):
        raise TypeError
    try:
        return float(value)
    except Exception:  # whatever a type of somebody's own raises
        raise TypeError from None


def _has_flags(values: Any) -> bool:
    """Whether a list has True or False among its numbers, which NumPy takes for 1 and 0."""
    if not isinstance(values, (list, tuple)):
        return False
    kinds = set(map(type, values))
    if kinds & {bool, np.bool_}:
        return True
    return bool(kinds & {list, tuple}) and any(map(_has_flags, values))


def numbers(values: Any, what: str, most_dimensions: int = 1) -> np.ndarray:
    """An array of float64 of one dimension, or of so many at most, which is not copied if it is one; a
    number is an array of one. What a masked array masks is not a number."""
    if is_pint(values):
        if not getattr(values, "dimensionless", False):
            raise InputError(f"{what}: plain numbers are accepted here, not '{values.units}'")
        values = values.to("").magnitude
    try:
        if isinstance(values, np.ma.MaskedArray):
            values = np.ma.filled(values.astype(np.float64), np.nan)
        array = np.asarray(values)
        if array.dtype.kind == "O":
            array = np.array([_real(value) for value in array.flat]).reshape(array.shape)
        if array.dtype.kind not in "iuf" or _has_flags(values):
            raise TypeError
        array = np.ascontiguousarray(np.atleast_1d(array), dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise InputError(f"{what}: {shown(values)} is not an array of real numbers") from None
    if array.ndim > most_dimensions:
        accepted = "one" if most_dimensions == 1 else "one or two"
        raise InputError(f"{what} has {array.ndim} dimensions; an array of {accepted} is accepted")
    return array
