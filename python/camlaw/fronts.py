# SPDX-License-Identifier: MIT
"""Fronts: the designs than which none is better in one objective without being worse in another."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from . import plots, tables, units
from .errors import InputError
from .evaluations import Check
from .native import native
from .outputs import written
from .problems import Problem
from .results import Result


class Front:
    """The front of a problem. len(front) designs; front[k] is one as a Result, front.table all."""

    def __init__(self, native_front: Any) -> None:
        self._native = native_front

    @classmethod
    def load(cls, path: str | Path) -> Front:
        """The front that a study's record holds, without a search. What is damaged or wrong in it
        does not count; notes says so."""
        return cls(native.front_file(str(path)))

    @property
    def table(self) -> Any:
        """A table of the designs: objectives, law, variables, verdict."""
        return tables.of_rows(self._native.rows(), self._native.units())

    @property
    def units(self) -> dict[str, str]:
        return self._native.units()

    @property
    def hypervolume(self) -> float:
        return self._native.hypervolume

    @property
    def complete(self) -> bool:
        """Whether it was not stopped and has no large gap."""
        return self._native.complete

    @property
    def stopped(self) -> bool:
        return self._native.stopped

    @property
    def notes(self) -> list[str]:
        """What is to be said of its record, and of how it was worked out."""
        return [*self._native.notes, *filter(None, [self._native.remark])]

    @property
    def facts(self) -> dict[str, Any]:
        """All that 'camlaw pareto --json' prints."""
        return self._native.facts()

    def __len__(self) -> int:
        return self._native.size

    def __getitem__(self, k: int) -> Result:
        size = len(self)
        if not -size <= k < size:
            raise IndexError(f"point {k}: the front has {size}")
        return Result(self._native.result(k % size))

    def __iter__(self) -> Iterator[Result]:
        return (self[k] for k in range(len(self)))

    def knee(self) -> Result:
        """The design that lies deepest below the line through the ends. Raises InputError where the
        front has none."""
        k = self._native.knee()
        if k is None:
            raise InputError(
                "this front has no knee; no point lies below the line through its ends"
            )
        return self[k]

    @property
    def knee_index(self) -> int | None:
        return self._native.knee()

    def compromise(self, weights: Sequence[float]) -> Result:
        """The design with the least of the greatest weighed objective; a weight for each."""
        return self[self._native.compromise([float(w) for w in weights])]

    def sensitivity(self, k: int, tolerances: Mapping[str, Any] | None = None) -> Check:
        """What becomes of a design that is not made as it was meant: `tolerances` by variable; by
        default hundredths."""
        facts, text, html = self._native.sensitivity(
            k % len(self), units.settings_of(dict(tolerances or {}))
        )
        return Check(text, facts, html)

    def csv(self, path: str | Path | None = None) -> str:
        """The front as CSV, every digit."""
        return written(self._native.csv(), path)

    def plot(self) -> Any:
        """The front of two or three objectives, drawn by matplotlib; returns the axes."""
        figure = self._native.figure()
        if not figure["panels"]:
            raise InputError("fronts of two or three objectives are drawn")
        return plots.draw(figure)

    def report(self, path: str | Path | None = None) -> str:
        """A page for any browser: the front, and the curves of its designs."""
        return written(self._native.report(self._native.file or "front"), path)

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        return f"<camlaw front: {len(self)} designs of {', '.join(self.units)}>"

    def _repr_html_(self) -> str:
        return self._native.html()


__all__ = ["Front", "Problem"]
