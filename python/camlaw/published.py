# SPDX-License-Identifier: MIT
"""Published tables computed again, and studies of published machines."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import plots, tables, units
from .kept import Kept
from .native import native
from .outputs import written
from .progress import Progress, shown


class Reproduction:
    """A published table computed again: how many values come out, and why others do not."""

    def __init__(self, native_reproduction: Any) -> None:
        self._native = native_reproduction
        self.facts: dict[str, Any] = native_reproduction.facts()

    @property
    def system(self) -> str:
        return self._native.system

    @property
    def counts(self) -> dict[str, int]:
        """How many values are reproduced, explained and unexplained."""
        return {
            name: getattr(self._native, name) for name in ("reproduced", "explained", "unexplained")
        }

    @property
    def worsened(self) -> list[str]:
        """What used to come out and no longer does; empty."""
        return self._native.worsened

    @property
    def values(self) -> Any:
        """A table of the printed values beside those computed."""
        return tables.of_rows(self.facts.get("values") or [])

    def report(self, path: str | Path | None = None) -> str:
        return written(native.report_of_reproductions([self._native]), path)

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        return f"<camlaw reproduction of {self.system}: {self.counts}>"

    def _repr_html_(self) -> str:
        return self._native.html()


class Study:
    """Laws compared on a published machine."""

    def __init__(self, native_study: Any) -> None:
        self._native = native_study
        self.facts: dict[str, Any] = native_study.facts()

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"_native": Kept(self._native, ("text", "html", "figure"))}

    def plot(self) -> Any:
        """What is gained for what, drawn by matplotlib; returns the axes."""
        return plots.draw(self._native.figure())

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        compared = self.facts.get("rows") or self.facts.get("points") or []
        return f"<camlaw study of {self.facts['study']}: {len(compared)} compared>"

    def _repr_html_(self) -> str:
        return self._native.html()


def reproducible() -> list[str]:
    """The systems that reproduce() knows."""
    return native.system_names()


def reproduce(system: str | Path, *, progress: Progress = None) -> Reproduction:
    """A published table computed again, each difference with its cause. system: one of
    reproducible(), or the file of a table, whose name ends in .toml."""
    with shown(progress, f"reproduce {system}") as tell:
        return Reproduction(native.reproduce(str(system), tell))


def cam_shape(n: int) -> dict[str, Any]:
    """The COPS cam of n radii solved: objective, true optimum, verdict, iterations, time."""
    return native.solve_cam_shape(n)


def study(
    system: str,
    *,
    set: Mapping[str, Any] | None = None,
    table: bool = False,
    workers: int | None = None,
    progress: Progress = None,
) -> Study:
    """Laws compared on "spine-cutter" or "sheet-delivery". table: of the spine cutter the table of
    laws alone, without the proved fronts."""
    with shown(progress, f"study {system}") as tell:
        return Study(
            native.study(system, units.settings_of(dict(set or {})), table, workers, tell)
        )
