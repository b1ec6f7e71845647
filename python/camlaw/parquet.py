# SPDX-License-Identifier: MIT
"""Tables as Parquet, by pyarrow."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from .errors import MissingPackage
from .tables import number_of

#: Columns of a sweep that hold words, and those that hold yes or no, even where no row has a value.
_WORDS = {"law", "verdict", "active", "reason", "start"}
_SWITCHES = {"global"}

_NAMED_WITH_UNIT = re.compile(r".* \[(?P<unit>[^\[\]]+)\]")


def _arrow() -> Any:
    try:
        import pyarrow
        import pyarrow.parquet
    except ImportError as error:
        raise MissingPackage(
            "Parquet needs pyarrow, which is not installed: pip install pyarrow"
        ) from error
    return pyarrow


def _is_number(value: Any) -> bool:
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def _type_of(name: str, values: Sequence[Any], arrow: Any) -> Any:
    """Doubles, yes or no, or words."""
    known = [value for value in values if value is not None]
    if name in _WORDS:
        return arrow.string()
    if name in _SWITCHES or (known and all(isinstance(value, bool) for value in known)):
        return arrow.bool_()
    return arrow.float64() if all(map(_is_number, known)) else arrow.string()


def _words(value: Any) -> str | None:
    return value if value is None or isinstance(value, str) else str(value)


def of_rows(rows: Sequence[Mapping[str, Any]], about: Mapping[str, str]) -> bytes:
    """A file of rows that have the same names, or some of them: what a row has not is null. A column
    of numbers has its unit in its metadata, 1 where it has no dimension. Raises MissingPackage."""
    arrow = _arrow()
    names: dict[str, None] = {}
    for row in rows:
        names.update(dict.fromkeys(row))
    fields, columns = [], []
    for name in names:
        values = [row.get(name) for row in rows]
        numbers = [number_of(value) for value in values]
        kind = _type_of(name, numbers, arrow)
        unit = {}
        if kind == arrow.float64():
            named = _NAMED_WITH_UNIT.fullmatch(name)
            unit = {"unit": named["unit"] if named else "1"}
            values = [None if value is None else float(value) for value in numbers]
        elif kind == arrow.string():
            values = [_words(value) for value in values]
        fields.append(arrow.field(name, kind, metadata=unit or None))
        columns.append(arrow.array(values, type=kind))
    table = arrow.Table.from_arrays(columns, schema=arrow.schema(fields, metadata=dict(about)))
    sink = arrow.BufferOutputStream()
    arrow.parquet.write_table(table, sink)
    return bytes(sink.getvalue())
