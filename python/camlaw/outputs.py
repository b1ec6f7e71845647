# SPDX-License-Identifier: MIT
"""Files that are written, and what an export is told."""

from __future__ import annotations

import os
import threading
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import units
from .arguments import flag
from .arguments import path as checked_path
from .errors import InputError


def written(text: str, path: str | Path | None) -> str:
    """Writes a text, all of it or nothing, where a path is given; returns it."""
    if path is not None:
        place = Path(checked_path(path))
        beside = place.with_name(f".{place.name}.{os.getpid()}.{threading.get_ident()}")
        try:
            try:
                beside.write_text(text, encoding="utf-8")
                os.replace(beside, place)
            except OSError as error:
                raise type(error)(error.errno, error.strerror, str(place)) from None
        finally:
            beside.unlink(missing_ok=True)
    return text


#: What is True or False.
_SWITCHES = {"drawing", "decimal_comma"}

#: What an export may be told; its format and what they mean: docs/exports.md.
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
