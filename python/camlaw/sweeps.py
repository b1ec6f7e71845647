# SPDX-License-Identifier: MIT
"""Sweeps: a problem solved with each combination of some settings."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import parquet, tables, units
from .answers import Answer
from .arguments import mapping, place, shown
from .arguments import path as checked_path
from .errors import InputError
from .motion_laws import Law, name_of
from .native import native
from .outputs import rendered
from .problems import Problem


def axes_of(values: Mapping[str, Any]) -> list[str]:
    """What the program's --set takes of a sweep: a text as it is, a list one value after the other."""
    texts = []
    for name, value in mapping(values, "sweep").items():
        if isinstance(value, (list, tuple)) or hasattr(value, "tolist"):
            items = list(value)
            if not items:
                raise InputError(f"{name}: the list is empty")
            text = ",".join(_listed(_swept(item, name), name) for item in items)
        else:
            text = _swept(value, name)
        texts.append(f"{name}={text}")
    return texts


def ranges_of(over: Mapping[str, Any] | None) -> list[str]:
    """Ranges such as {"stroke": ("18 mm", "22 mm")} or {"stroke": "18:22 mm"}, as --over has them."""
    texts = []
    for name, value in mapping(over, "over", "{'stroke': ('18 mm', '22 mm')}").items():
        if isinstance(value, str):
            texts.append(f"{name}={value}")
        elif isinstance(value, (list, tuple)) and len(value) == 2:
            low, high = (units.value_text(end, f"over: {name}") for end in value)
            number, _, unit = low.partition(" ")
            same = high.partition(" ")
            if unit != same[2]:
                raise InputError(f"over: {name}: '{low}' and '{high}' have different units")
            texts.append(f"{name}={number}:{same[0]} {unit}".rstrip())
        else:
            raise InputError(
                f"over: {name}: {shown(value)} is neither (lower, upper) nor a text such as '18:22 mm'"
            )
    return texts


def _swept(value: Any, name: str) -> str:
    """A value that is swept; a law may be one."""
    return name_of(value, name) if isinstance(value, Law) else units.value_text(value, name)


def _listed(text: str, name: str) -> str:
    """A value among others; a name that reads as more is in quotes. A law's list has its own."""
    is_law = name == "law" or name.endswith(".law")
    return text if is_law else native.listed_value(text)


class Sweep(Answer):
    """The result of each combination: sweep.table has a row for each, and sweep[k] is a design."""

    def __init__(self, native_sweep: Any) -> None:
        self._native = native_sweep
        self._file = ""  #: of its record, where it was read from one
        #: All that 'camlaw sweep --json' prints.
        self.facts: dict[str, Any] = native_sweep.facts()

    @classmethod
    def load(cls, path: str | Path) -> Sweep:
        """Reads the sweep that a study's record holds, without a search. Damaged or wrong entries
        of the record are left out; notes names them."""
        sweep = cls(native.sweep_file(checked_path(path)))
        sweep._file = checked_path(path)
        return sweep

    def _is_input(self, path: str) -> bool:
        return bool(self._native.is_input(path, self._file))

    def __len__(self) -> int:
        return int(self.facts["count"])

    def __getitem__(self, k: int) -> Problem:
        """The design of a combination as a problem. Raises InputError if it has none, and IndexError if
        there is no such combination."""
        return Problem(_native=self._native.design(place(k, "combination", len(self))))

    @property
    def table(self) -> Any:
        """A table of the combinations: settings, objectives, verdict, active limits, variables,
        margins."""
        return tables.of_rows(self.facts["combinations"])

    @property
    def best(self) -> int | None:
        """The number of the combination with the best first objective; None if none has a design."""
        best = self.facts.get("best")
        return None if best is None else int(best) - 1

    @property
    def stopped(self) -> bool:
        """Whether it was stopped before its end."""
        return not self.facts["finished"]

    @property
    def notes(self) -> list[str]:
        """Remarks on its record and on how it was computed, such as what was left out."""
        return self._native.notes()

    def csv(self, path: str | Path | None = None) -> str:
        """The table as CSV; written to `path` if given."""
        return rendered(self._native.csv(), path, self._file, is_input=self._is_input)

    def parquet(self, path: str | Path | None = None) -> bytes:
        """The table as Parquet; written to `path` if given. Numbers are doubles with their unit in the
        field's metadata, words are strings, and what a combination does not have is null. Raises
        MissingPackage without pyarrow."""
        about = {"title": str(self.facts["title"]), "program": native.version()}
        content = parquet.of_rows(self.facts["combinations"], about)
        return rendered(content, path, self._file, is_input=self._is_input)

    def report(self, path: str | Path | None = None) -> str:
        """A page for the browser with a map of which setting is best where; written to `path` if given."""
        return rendered(
            self._native.report("sweep"), path, self._file, page=True, is_input=self._is_input
        )

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        return f"<camlaw sweep: {len(self)} combinations, {self.facts['designs']} with a design>"

    def _repr_html_(self) -> str:
        return self._native.html()


__all__ = ["Sweep", "axes_of", "ranges_of"]
