# SPDX-License-Identifier: MIT
"""Laws and machines behind measurements: samples, worn cams, recorded curves, printed constants."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from . import plots, tables, units
from .errors import InputError, Interrupted
from .kept import Kept
from .motion_laws import Law
from .native import native
from .outputs import written
from .problems import Problem
from .progress import Progress, shown

_TITLE = re.compile(r"\s*(.*?)\s*[\[(]([^\])]*)[\])]\s*$")


def _name_and_unit(title: Any) -> tuple[str, str]:
    found = _TITLE.match(str(title))
    return (found[1], found[2]) if found else (str(title), "")


def _sample_table(data: Any) -> Any:
    if isinstance(data, (str, Path)):
        return native.sample_file(str(data))
    if not hasattr(data, "items"):
        raise InputError(
            "a table is wanted: a DataFrame, a dict of arrays or a file's path, with columns "
            "such as 'angle [deg]' and 'lift [mm]'"
        )
    names, columns = [], []
    for title, values in data.items():
        name, unit = _name_and_unit(title)
        if units.is_pint(values):
            unit, values = units.pint_unit(values.units), values.magnitude
        elif units.is_pint(getattr(values, "array", None)):
            unit, values = units.pint_unit(values.array.units), values.array.quantity.magnitude
        try:
            columns.append(np.ascontiguousarray(values, dtype=np.float64))
        except (TypeError, ValueError) as error:
            raise InputError(f"{title}: {error}") from None
        names.append((name, unit))
    return native.sample_table("samples", names, columns)


def _machine(mechanism: Any, settings: Mapping[str, Any] | None) -> Any:
    if mechanism is None:
        return None
    problem = (
        mechanism
        if isinstance(mechanism, Problem)
        else Problem(_native=native.machine(str(mechanism)))
    )
    return (problem.set(settings) if settings else problem)._native


class Fit:
    """What is behind a table, and whether it may be trusted."""

    def __init__(self, native_fit: Any, machine: Any = None) -> None:
        self._native = native_fit
        self.facts: dict[str, Any] = native_fit.facts()

    def __getstate__(self) -> dict[str, Any]:
        names = ("json_text", "text", "html", "law", "law_text", "machine", "program", "figure")
        return self.__dict__ | {"_native": Kept(self._native, names)}

    @property
    def law(self) -> Law | None:
        """The law of the largest motion with its fitted coefficients: a spline where no law that has
        a name follows the samples; of a recorded curve the machine's own."""
        found = self._native.law()
        return None if found is None else Law(found)

    @property
    def trusted(self) -> bool:
        return bool(self.facts.get("trusted", True))

    @property
    def reason(self) -> str:
        """Why it is not to be trusted; else empty."""
        return str(self.facts.get("reason", ""))

    @property
    def intervals(self) -> Any:
        """A table of the fitted numbers: value, low, high (95 %), standard_deviation, unit."""
        return tables.of_rows(self.facts.get("parameters") or [], index="name")

    @property
    def motions(self) -> list[dict[str, Any]]:
        """What was found of each rise and return, as facts."""
        return self.facts.get("motions", [])

    @property
    def machine(self) -> Problem | None:
        """Of a recorded curve the machine with the values that were found."""
        found = self._native.machine()
        return None if found is None else Problem(_native=found)

    @property
    def program(self) -> str | None:
        """Of a measured cam its motion program, as the text of a problem file."""
        found = self._native.program()
        return None if found is None else str(found[0])

    def save(self, folder: str | Path) -> None:
        """Writes fit.json, and law.json and program.toml where there are such."""
        place = Path(folder)
        place.mkdir(parents=True, exist_ok=True)
        written(self._native.json_text(), place / "fit.json")
        law = self._native.law_text()
        if law is not None:
            written(law, place / "law.json")
        program = self._native.program()
        if program is not None:
            written(program[0], place / "program.toml")
            for name, text in program[1].items():
                written(text, place / name)

    def plot(self) -> Any:
        """Samples, law and what is left, drawn by matplotlib; returns the axes."""
        return plots.draw(self._native.figure())

    def __str__(self) -> str:
        return self._native.text()

    def __repr__(self) -> str:
        what = self.facts.get("law") or "constants"
        return f"<camlaw fit: {what}{'' if self.trusted else ', not to be trusted'}>"

    def _repr_html_(self) -> str:
        return self._native.html()


def fit(
    data: Any,
    *,
    law: str | Law | None = None,
    mechanism: Any = None,
    set: Mapping[str, Any] | None = None,
    response: str | None = None,
    shift: str | Sequence[str] = (),
    loss: str = "none",
    time_limit: Any = None,
    workers: int | None = None,
    progress: Progress = None,
) -> Fit:
    """The law behind measured samples, a worn cam, or a machine behind a recorded curve.

    data: a DataFrame, a dict of arrays, or a file's path. Columns have names with their units,
    "angle [deg]", "lift [mm]"; "x [mm]", "y [mm]" of a cam's profile; a machine's curve by its name.
    law: whose coefficients are wanted; by default every law is tried. mechanism: the name of one, a
    problem file or a Problem: what runs on a measured cam, or whose curve was recorded and whose
    variables are unknown; `set` sets its values. response: the recorded curve where several columns
    could be one. shift: what of the record is unknown: "centre"; of a recorded curve "abscissa",
    "value". loss: "none", "huber" or "cauchy". time_limit: seconds, or such as "1 min": the laws that
    were tried by then, or the best values seen, are the answer. workers: processes that fit laws side
    by side where that takes longer than some seconds; the fit does not depend on them. Raises
    InputError.
    """
    table = _sample_table(data)
    shifts = [shift] if isinstance(shift, str) else list(shift)
    name = law.name if isinstance(law, Law) else law
    machine = _machine(mechanism, set)
    with shown(progress, "fit") as tell:
        found, interrupted = native.fit(
            table,
            name,
            machine,
            response,
            shifts,
            loss,
            units.seconds(time_limit),
            units.whole(workers, "workers", 1),
            tell,
        )
    answer = None if found is None else Fit(found)
    if interrupted or answer is None:
        raise Interrupted(answer)
    return answer


def fit_constants(
    constants: str | Mapping[str, Any],
    *,
    law: str | Law | None = None,
    mechanism: Any = None,
    set: Mapping[str, Any] | None = None,
) -> Fit:
    """The law, or the sizes of a machine, behind printed constants: "C_v=1.6125, C_a=4.66".

    The digits count: give texts, {"C_v": "1.6125"}, where a last digit is a zero.
    """
    if not isinstance(constants, str):
        constants = ", ".join(f"{name}={value}" for name, value in constants.items())
    name = law.name if isinstance(law, Law) else law
    return Fit(native.fit_constants(constants, _machine(mechanism, set), name))
