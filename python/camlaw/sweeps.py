# SPDX-License-Identifier: MIT
"""Sweeps: a problem with each combination of some settings."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import tables, units
from .errors import InputError
from .native import native
from .outputs import written
from .problems import Problem


def axes_of(values: Mapping[str, Any]) -> list[str]:
    """What the program's --set takes of a sweep: a text as it is, a list one value after the other."""
    texts = []
    for name, value in values.items():
        if isinstance(value, (list, tuple)) or hasattr(value, "tolist"):
            items = list(value)
            if not items:
                raise InputError(f"{name}: there is no value in the list")
            text = ",".join(units.value_text(item) for item in items)
        else:
            text = units.value_text(value)
        texts.append(f"{name}={text}")
    return texts


def ranges_of(over: Mapping[str, Any] | None) -> list[str]:
    """Ranges such as {"stroke": ("18 mm", "22 mm")} or {"stroke": "18:22 mm"}, as --over has them."""
    texts = []
    for name, value in (over or {}).items():
        if isinstance(value, str):
            texts.append(f"{name}={value}")
        elif isinstance(value, (list, tuple)) and len(value) == 2:
            low, high = (units.value_text(end) for end in value)
            number, _, unit = low.partition(" ")
            same = high.partition(" ")
            if unit != same[2]:
                raise InputError(f"over: {name}: '{low}' and '{high}' have different units")
            texts.append(f"{name}={number}:{same[0]} {unit}".rstrip())
        else:
            raise InputError(
                f"over: {name}: {value!r} is neither two ends nor a text such as '18:22 mm'"
            )
    return texts


class Sweep:
    """What came of each combination. sweep.table has a row for each, sweep[k] is a design."""

    def __init__(self, native_sweep: Any) -> None:
        self._native = native_sweep
        #: All that 'camlaw sweep --json' prints.
        self.facts: dict[str, Any] = native_sweep.facts()

    def __len__(self) -> int:
        return int(self.facts["count"])

    def __getitem__(self, k: int) -> Problem:
        """The design of a combination as a problem. Raises InputError if it has none."""
        number = units.whole(k, "combination")
        return Problem(_native=self._native.design(number))

    @property
    def table(self) -> Any:
        """A table of the combinations: settings, objectives, verdict, what holds the design, variables,
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

    def csv(self, path: str | Path | None = None) -> str:
        """The table as CSV; written to `path`."""
        return written(self._native.csv(), path)

    def report(self, path: str | Path | None = None) -> str:
        """A page for the browser with a map: which setting is best where; written to `path`."""
        return written(self._native.report("sweep"), path)

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        return f"<camlaw sweep: {len(self)} combinations, {self.facts['designs']} with a design>"

    def _repr_html_(self) -> str:
        return self._native.html()


__all__ = ["Sweep", "axes_of", "ranges_of"]
