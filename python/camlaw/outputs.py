# SPDX-License-Identifier: MIT
"""Files that are written, and the options of an export."""

from __future__ import annotations

import errno
import os
import shutil
import threading
import warnings
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, TypeVar

from . import units
from .arguments import flag
from .arguments import path as checked_path
from .errors import InputError


_Content = TypeVar("_Content", str, bytes)


def written(content: _Content, path: str | Path | None) -> _Content:
    """Writes a text or bytes, all of it or nothing, where a path is given; returns it."""
    if path is not None:
        named = checked_path(path)
        try:
            if os.path.exists(named) and not _is_replaced(named):
                with open(named, "ab") as open_one:
                    open_one.write(_bytes_of(content))
            else:
                _replace(Path(named).resolve(), _bytes_of(content))  # of a link the file that it leads to
        except RuntimeError:  # so resolve() says that links go in a circle
            raise OSError(errno.ELOOP, os.strerror(errno.ELOOP), named) from None
        except OSError as error:
            raise type(error)(error.errno, error.strerror, named) from None
    return content


#: Endings of files that people write or that took long to make, and what these are.
_KEPT = {".toml": "problem files", ".db": "studies"}


def rendered(
    content: _Content,
    path: str | Path | None,
    read_from: str = "",
    page: bool = False,
    is_input: Callable[[str], bool] | None = None,
) -> _Content:
    """Writes a picture, a table, a drawing or a page where a path is given; returns it. Raises InputError
    where that is the file that the answer was read from, one that its problem was read from (is_input),
    or has the ending of one that is not replaced; a page must be named as one."""
    if path is not None:
        named = checked_path(path)
        ending = Path(named).suffix.lower()
        is_file = os.path.isfile(named) or not os.path.exists(named)  # no folder, pipe or device
        if page and is_file and ending not in (".html", ".htm"):
            raise InputError(
                f"path: {named}: a report is a page for the browser, whose name ends in .html or .htm"
            )
        if ending in _KEPT:
            raise InputError(
                f"path: {named}: {ending} is the ending of {_KEPT[ending]}; the output needs another name"
            )
        if read_from and os.path.exists(read_from) and os.path.exists(named):
            if os.path.samefile(read_from, named):
                raise InputError(
                    f"path: {named} is the file that was read; the output needs another name"
                )
        keep_input(named, is_input)
    return written(content, path)


def keep_input(named: str, is_input: Callable[[str], bool] | None) -> None:
    """Raises InputError where a file is one that the problem is read from."""
    if is_input is not None and os.path.isfile(named) and is_input(named):
        raise InputError(
            f"path: the problem is read from {named}; the output needs another name"
        )


def _bytes_of(content: str | bytes) -> bytes:
    return content.encode("utf-8") if isinstance(content, str) else content


def _is_replaced(named: str) -> bool:
    """Whether a file takes the place of what is there: not that of a pipe, a terminal or an open file."""
    place = os.path.abspath(named)
    return os.path.isfile(place) and not place.startswith(("/dev/", "/proc/"))


def _replace(place: Path, content: bytes) -> None:
    beside = place.with_name(f".camlaw.{os.getpid()}.{threading.get_ident()}")
    try:
        with open(beside, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        if place.exists():
            shutil.copymode(place, beside)
        os.replace(beside, place)
    finally:
        beside.unlink(missing_ok=True)


def exported(
    found: tuple[str, list[str]],
    path: str | Path | None,
    read_from: str,
    is_input: Callable[[str], bool],
) -> str:
    """The text of an export, written where a path is given; warns of limits that are not met."""
    text, unmet = found
    for limit in unmet:
        warnings.warn(limit, stacklevel=3)
    return rendered(text, path, read_from, is_input=is_input)


#: What is True or False.
_SWITCHES = {"drawing", "decimal_comma"}

#: The options of an export; docs/exports.md explains them and its formats.
_OPTIONS = {
    "format",
    "curve",
    "tolerance",
    "step",
    "form",
    "decimals",
    "tool",
    "feed",
    "clearance",
    "depth",
    "slave",
    "cam",
    "zero",
    "unit",
    "master",
    "cycle",
    "columns",
    "separator",
    "lead",
    "compensation",
    "allowances",
    "bore",
    "keyway",
    "width",
    "groove",
    "blank",
    "form_tolerance",
    "drawing",
    "decimal_comma",
}


def export_options(path: str | Path | None, options: Mapping[str, Any]) -> dict[str, str]:
    """The options of an export as the library reads them. Raises InputError for unknown ones."""
    unknown = set(options) - _OPTIONS
    if unknown:
        raise InputError(
            f"an export has no option '{min(unknown)}'; it accepts {', '.join(sorted(_OPTIONS))}"
        )
    told = {}
    for name, value in options.items():
        if name in _SWITCHES:
            if value is not None and flag(value, name):
                told[name] = "yes"
        elif value is not None:
            told[name] = units.value_text(value, name)
    return told | ({"out": checked_path(path)} if path is not None else {})
