# SPDX-License-Identifier: MIT
"""Laws and machines behind measurements: samples, worn cams, recorded curves, printed constants."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from . import plots, tables, units
from .answers import Answer
from .arguments import is_pint, mapping, numbers, optional_text, optional_whole, text, texts
from .arguments import path as checked_path
from .arguments import shown as shown_value
from .errors import InputError, Interrupted
from .kept import Kept
from .motion_laws import Law, name_of
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
        return native.sample_file(checked_path(data, "data"))
    if not hasattr(data, "items"):
        raise InputError(
            f"data: {shown_value(data)} is not a table; a DataFrame, a dict of arrays or the path of a "
            "file is accepted, with columns such as 'angle [deg]' and 'lift [mm]'"
        )
    names, columns = [], []
    for title, values in data.items():
        name, unit = _name_and_unit(title)
        if is_pint(values):
            unit, values = units.pint_unit(values.units), values.magnitude
        elif is_pint(getattr(values, "array", None)):
            unit, values = units.pint_unit(values.array.units), values.array.quantity.magnitude
        columns.append(numbers(values, str(title)))
        names.append((name, unit))
    return native.sample_table("samples", names, columns)


def _machine(mechanism: Any, settings: Mapping[str, Any] | None) -> Any:
    values = mapping(settings, "set", "{'roller_radius': '8 mm'}")
    if mechanism is None:
        if values:
            raise InputError("set: it sets values of a mechanism; give mechanism too")
        return None
    problem = (
        mechanism
        if isinstance(mechanism, Problem)
        else Problem(_native=native.machine(checked_path(mechanism, "mechanism")))
    )
    return (problem.set(values) if values else problem)._native


class Fit(Answer):
    """The law or the machine behind a table, and whether the fit may be trusted."""

    def __init__(self, native_fit: Any, machine: Any = None) -> None:
        self._native = native_fit
        self.facts: dict[str, Any] = native_fit.facts()

    def __getstate__(self) -> dict[str, Any]:
        names = ("json_text", "text", "html", "law", "law_text", "machine", "program", "figure")
        return self.__dict__ | {"_native": Kept(self._native, names)}

    @property
    def law(self) -> Law | None:
        """The law of the largest motion with its fitted coefficients: a spline if no named law follows
        the samples; the machine's own law if the table is a recorded curve; the law that explains printed
        constants best."""
        found = self._native.law()
        return None if found is None else Law(found)

    @property
    def trusted(self) -> bool:
        return bool(self.facts.get("trusted", True))

    @property
    def reason(self) -> str:
        """Why the fit may not be trusted; empty if it may."""
        return str(self.facts.get("reason", ""))

    @property
    def intervals(self) -> Any:
        """A table of the fitted numbers: value, low, high (95 %), standard_deviation, unit."""
        return tables.of_rows(self.facts.get("parameters") or [], index="name")

    @property
    def motions(self) -> list[dict[str, Any]]:
        """What was found for each rise and return, as facts."""
        return self.facts.get("motions", [])

    @property
    def machine(self) -> Problem | None:
        """The machine with the values that were found, if the table is a recorded curve."""
        found = self._native.machine()
        return None if found is None else Problem(_native=found)

    @property
    def program(self) -> str | None:
        """The motion program of a measured cam, as the text of a problem file."""
        found = self._native.program()
        return None if found is None else str(found[0])

    def save(self, folder: str | Path) -> None:
        """Writes fit.json into a folder, and law.json and program.toml if the fit has them."""
        place = Path(checked_path(folder, "folder"))
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
        """Draws samples, law and residuals with matplotlib; returns the axes."""
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
    """Finds the law behind measured samples or a worn cam, or the machine behind a recorded curve.

    data: a DataFrame, a dict of arrays, or a file's path. Columns have names with their units,
    "angle [deg]" and "lift [mm]"; "x [mm]" and "y [mm]" for a cam's profile; a recorded curve has its
    own name. law: the law whose coefficients are fitted; by default every law is tried. mechanism: a
    mechanism's name, a problem file or a Problem: what runs on a measured cam, or the machine whose
    curve was recorded and whose variables are unknown; `set` sets its values. response: the recorded
    curve, if several columns could be one. shift: the unknown offsets of the record: "centre", or for a
    recorded curve "abscissa" and "value". loss: "none", "huber" or "cauchy". time_limit: seconds, or a
    text such as "1 min"; the answer is then the best fit so far. workers: processes that fit
    laws side by side if that takes longer than a few seconds; the fit does not depend on them. Raises
    InputError.
    """
    table = _sample_table(data)
    shifts = [shift] if isinstance(shift, str) else texts(shift, "shift")
    name = name_of(law, "law") if isinstance(law, Law) else optional_text(law, "law")
    machine = _machine(mechanism, set)
    with shown(progress, "fit") as tell:
        found, interrupted = native.fit(
            table,
            name,
            machine,
            optional_text(response, "response"),
            shifts,
            text(loss, "loss"),
            units.seconds(time_limit),
            optional_whole(workers, "workers", 1, 256),
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
    """Finds the law, or the sizes of a machine, behind printed constants: "C_v=1.6125, C_a=4.66".

    The digits count: if a last digit is a zero, give a text, {"C_v": "1.6120"}.
    """
    if not isinstance(constants, str):
        printed = mapping(constants, "constants", "{'C_v': '1.6125'}")
        constants = ", ".join(
            f"{name}={units.value_text(value, name)}" for name, value in printed.items()
        )
    name = name_of(law, "law") if isinstance(law, Law) else optional_text(law, "law")
    return Fit(native.fit_constants(constants, _machine(mechanism, set), name))
