# SPDX-License-Identifier: MIT
"""Files that are written, and what an export is told."""

from __future__ import annotations

import os
import threading
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import units
from .errors import InputError


def written(text: str, path: str | Path | None) -> str:
    """Writes a text, all of it or nothing, where a path is given; returns it."""
    if path is not None:
        place = Path(path)
        beside = place.with_name(f".{place.name}.{os.getpid()}.{threading.get_ident()}")
        try:
            try:
                beside.write_text(text, encoding="utf-8")
                os.replace(beside, place)
            except OSError as error:
                error.filename, error.filename2 = str(place), None
                raise
        finally:
            beside.unlink(missing_ok=True)
    return text


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
            f"no option is called '{min(unknown)}'; there are {', '.join(sorted(_OPTIONS))}"
        )
    told = {
        name: units.value_text(value)
        for name, value in options.items()
        if value is not None and value is not False and value is not True
    }
    told |= {name: "yes" for name, value in options.items() if value is True}
    return told | ({"out": str(path)} if path is not None else {})
