# SPDX-License-Identifier: MIT
"""Tables: DataFrames where pandas is installed, else dicts of arrays."""

from collections.abc import Mapping, Sequence
from html import escape
from typing import Any

import numpy as np


_SHOWN = 20  #: rows from the beginning, and from the end, of a table as text


def _cell(value: Any) -> str:
    return f"{value:.8g}" if isinstance(value, float) else str(value)


class Columns(dict[str, Any]):
    """A table without pandas: arrays and lists by the names of their columns; a list of names gives
    the table of these."""

    def __getitem__(self, name: Any) -> Any:
        if isinstance(name, list):
            return Columns({each: self[each] for each in name})
        return super().__getitem__(name)

    def __repr__(self) -> str:
        rows = list(zip(*self.values()))
        shown = rows if len(rows) <= 2 * _SHOWN else [*rows[:_SHOWN], *rows[-_SHOWN:]]
        lines = [list(self), *([_cell(cell) for cell in row] for row in shown)]
        widths = [max(map(len, column)) for column in zip(*lines)]
        text = ["  ".join(cell.rjust(w) for cell, w in zip(line, widths)) for line in lines]
        if len(shown) < len(rows):
            text[1 + _SHOWN : 1 + _SHOWN] = ["..."]
            text.append(f"({len(rows)} rows)")
        return "\n".join(text)

    def _repr_html_(self) -> str:
        names = list(self)
        rows = zip(*self.values()) if names else []
        head = "".join(f"<th>{escape(name)}</th>" for name in names)
        body = "".join(
            "<tr>" + "".join(f"<td>{escape(str(cell))}</td>" for cell in row) + "</tr>"
            for row in rows
        )
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def number_of(value: Any) -> Any:
    """A value as rows have it; a number without end is a word there."""
    return float(value) if value in ("inf", "-inf") else value


def _column(values: Sequence[Any]) -> Any:
    values = [number_of(value) for value in values]
    numbers = [float("nan") if value is None else value for value in values]
    if any(
        isinstance(value, (int, float)) and not isinstance(value, bool) for value in numbers
    ) and all(isinstance(value, (int, float)) and not isinstance(value, bool) for value in numbers):
        return np.array(numbers)
    if values and all(isinstance(value, bool) for value in values):
        return np.array(values)
    return values


def of_columns(
    columns: Mapping[str, Any], units: Mapping[str, str] | None = None, index: str | None = None
) -> Any:
    """A table of arrays, which are not copied."""
    try:
        import pandas
    except ImportError:
        return Columns(columns)
    frame = pandas.DataFrame(dict(columns), copy=False)
    if index is not None and index in frame.columns:
        frame = frame.set_index(index)
    if units:
        frame.attrs["units"] = dict(units)
    return frame


def of_rows(
    rows: Sequence[Mapping[str, Any]],
    units: Mapping[str, str] | None = None,
    index: str | None = None,
) -> Any:
    """A table of rows that have the same names, or some of them."""
    names: dict[str, None] = {}
    for row in rows:
        names.update(dict.fromkeys(row))
    return of_columns(
        {name: _column([row.get(name) for row in rows]) for name in names}, units, index
    )
