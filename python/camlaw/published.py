# SPDX-License-Identifier: MIT
"""Published tables computed again, and studies of published machines."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from . import plots, tables, units
from .answers import Answer
from .arguments import flag, mapping, optional_whole, text, whole
from .arguments import path as checked_path
from .kept import Kept
from .native import native
from .outputs import rendered
from .progress import Progress, shown


class Reproduction(Answer):
    """A published table computed again: which values are reproduced, and why others are not."""

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
        """Values that used to be reproduced and no longer are; there are none in a released version."""
        return self._native.worsened

    @property
    def values(self) -> Any:
        """A table of the printed values next to those computed."""
        return tables.of_rows(self.facts.get("values") or [])

    def report(self, path: str | Path | None = None) -> str:
        return rendered(native.report_of_reproductions([self._native]), path, page=True)

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        return f"<camlaw reproduction of {self.system}: {self.counts}>"

    def _repr_html_(self) -> str:
        return self._native.html()


class Study(Answer):
    """Laws compared on a published machine."""

    def __init__(self, native_study: Any) -> None:
        self._native = native_study
        self.facts: dict[str, Any] = native_study.facts()

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"_native": Kept(self._native, ("text", "html", "figure"))}

    def plot(self) -> Any:
        """Draws the trade-off with matplotlib; returns the axes."""
        return plots.draw(self._native.figure())

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        compared = self.facts.get("rows") or self.facts.get("points") or []
        return f"<camlaw study of {self.facts['study']}: {len(compared)} compared>"

    def _repr_html_(self) -> str:
        return self._native.html()


def reproducible() -> list[str]:
    """The names of the systems that reproduce() knows."""
    return native.system_names()


def reproduce(system: str | Path, *, progress: Progress = None) -> Reproduction:
    """Computes a published table again and explains each difference. system: one of reproducible(), or
    the file of a table, whose name ends in .toml."""
    name = checked_path(system, "system")
    with shown(progress, f"reproduce {name}") as tell:
        return Reproduction(native.reproduce(name, tell))


def cam_shape(n: int) -> dict[str, Any]:
    """Solves the COPS cam with n radii: objective, true optimum, verdict, iterations, time."""
    return native.solve_cam_shape(whole(n, "n", 1, 1_000_000))


def study(
    system: str,
    *,
    set: Mapping[str, Any] | None = None,
    table: bool = False,
    workers: int | None = None,
    progress: Progress = None,
) -> Study:
    """Compares laws on "spine-cutter" or "sheet-delivery". table: gives the table of laws of the spine
    cutter alone, without the proved fronts."""
    name = text(system, "system")
    settings = units.settings_of(mapping(set, "set"))
    with shown(progress, f"study {name}") as tell:
        found = native.study(
            name, settings, flag(table, "table"), optional_whole(workers, "workers", 1, 256), tell
        )
    return Study(found)
