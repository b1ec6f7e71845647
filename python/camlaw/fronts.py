# SPDX-License-Identifier: MIT
"""Fronts: designs that no other design beats in one objective without losing in another."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from . import plots, tables, units
from .answers import Answer
from .arguments import mapping, numbers, place
from .arguments import path as checked_path
from .errors import InputError
from .evaluations import Check
from .native import native
from .outputs import rendered
from .problems import Problem
from .results import Result


class Front(Answer):
    """The front of a problem: len(front) designs. front[k] is one of them as a Result, and front.table
    has all."""

    def __init__(self, native_front: Any) -> None:
        self._native = native_front

    @classmethod
    def load(cls, path: str | Path) -> Front:
        """Reads the front that a study's record holds, without a search. Damaged or wrong entries
        of the record are left out; notes names them."""
        return cls(native.front_file(checked_path(path)))

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
        """Whether the search was not stopped and the front has no large gap."""
        return self._native.complete

    @property
    def stopped(self) -> bool:
        return self._native.stopped

    @property
    def notes(self) -> list[str]:
        """Remarks on its record, and on how it was computed."""
        return [*self._native.notes, *filter(None, [self._native.remark])]

    @property
    def facts(self) -> dict[str, Any]:  # type: ignore[override]  # nobody assigns it
        """All that 'camlaw pareto --json' prints."""
        return self._native.facts()

    def __len__(self) -> int:
        return self._native.size

    def __getitem__(self, k: int) -> Result:
        return Result(self._native.result(place(k, "point", len(self))))

    def __iter__(self) -> Iterator[Result]:
        return (self[k] for k in range(len(self)))

    def knee(self) -> Result:
        """The design that lies deepest below the line through the ends. Raises InputError if no design
        lies below it."""
        k = self._native.knee()
        if k is None:
            raise InputError(
                "the front has no knee: no point lies below the line through its ends"
            )
        return self[k]

    @property
    def knee_index(self) -> int | None:
        return self._native.knee()

    def compromise(self, weights: Sequence[float]) -> Result:
        """The design whose greatest weighted objective is least. There is a weight for each objective."""
        return self[self._native.compromise(list(numbers(weights, "weights")))]

    def sensitivity(self, k: int, tolerances: Mapping[str, Any] | None = None) -> Check:
        """What happens to a design that is not made exactly: `tolerances` by variable; by default
        0.02 mm of a length, 0.1 deg of an angle and a hundredth of anything else."""
        facts, text, html = self._native.sensitivity(
            place(k, "point", len(self)), units.settings_of(mapping(tolerances, "tolerances"))
        )
        return Check(text, facts, html)

    def csv(self, path: str | Path | None = None) -> str:
        """The front as CSV with every digit; written to `path` if that is given."""
        return rendered(self._native.csv(), path, self._native.file, is_input=self._native.is_input)

    def plot(self) -> Any:
        """Draws a front of two or three objectives with matplotlib; returns the axes."""
        figure = self._native.figure()
        if not figure["panels"]:
            raise InputError("plot draws fronts of two or three objectives")
        return plots.draw(figure)

    def svg(self, path: str | Path | None = None) -> str:
        """The same as a picture in SVG, as 'camlaw front --svg' draws it; written to `path` if given."""
        if not self._native.figure()["panels"]:
            raise InputError("svg draws fronts of two or three objectives")
        return rendered(self._native.svg(), path, self._native.file, is_input=self._native.is_input)

    def report(self, path: str | Path | None = None) -> str:
        """A page for any browser with the front and the curves of its designs; written to `path` if given."""
        page = self._native.report(self._native.file or "front")
        return rendered(
            page, path, self._native.file, page=True, is_input=self._native.is_input
        )

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        return f"<camlaw front: {len(self)} designs of {', '.join(self.units)}>"

    def _repr_html_(self) -> str:
        return self._native.html()


__all__ = ["Front", "Problem"]
