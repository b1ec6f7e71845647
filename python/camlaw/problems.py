# SPDX-License-Identifier: MIT
"""Problems: a machine, what may vary, what is wanted, what must hold.

How one is stated is in stating, what is searched for in searches, what can be said of it without a search
in evaluations.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from . import plots, tables, units
from .arguments import flag, is_pint, mapping, numbers, texts, whole
from .arguments import path as checked_path
from .arguments import text as _text
from .errors import InputError
from .evaluations import Check, Evaluation, Range
from .motion_laws import Law, name_of
from .native import native
from .outputs import export_options, exported, rendered, written
from .own_machines import Machine
from .searches import Searches
from .stating import Held, problem_table
from .toml_text import toml_text


#: Of curves, as many as the program tabulates.
_MOST_POINTS = 1_000_000


class Problem(Searches):
    """A design problem, as a problem file states one (docs/problem-files.md).

    Problem.load(path) reads a file. Otherwise state the tables of a problem file as dicts; values are
    numbers in the listed unit, texts with units such as "30 mm", or quantities of pint:

        cl.Problem(mechanism="disc-cam-roller",
                   constants={"stroke": "30 mm", "speed": "200 rpm"},
                   program=[{"name": "rise", "angle": "80 deg", "law": "cycloidal"}, ...],
                   variables={"base_radius": ("10 mm", "120 mm")},
                   objective="base_radius",
                   constraints={"pressure_angle": ("-40 deg", "30 deg")})

    mechanism: a mechanism's name, or machine: a Machine of your own, or the table [machine]. law: a
    name, a Law, a list of these to choose from, or the table [law]. program: the segments, or the table
    [program]. variables: (lower, upper), or a table with lower, upper, start, type and values.
    objective: the response to minimize, or {"minimize": ...} or {"maximize": ...}; objectives: a list
    of these, for a front. constraints: a dict of (lower, upper) or tables, or a list of tables.
    responses: formulas of your own, each a Response. cases: load cases, [{"name": "fast", "speed":
    "400 rpm"}, ...]. ranges: parameters that take any value in a range, {"speed": ("100 rpm",
    "400 rpm")}. variation: the deviations of manufacture, plus and minus, {"base_radius": "0.02 mm"},
    or tables. parts: tables [parts.NAME] with a catalogue. cams: several cams on one shaft by name,
    each with the keywords of a problem, {"press": {"mechanism": ..., "constants": ..., "program":
    ...}}. free, buildable, profile (errors of the cut profile) and solver: the tables of these names.
    format: as a problem file states it, so that the tables of one may be given,
    Problem(**tomllib.loads(text)). Raises InputError.
    """

    def __init__(
        self,
        mechanism: str | Machine | None = None,
        *,
        machine: Machine | Mapping[str, Any] | None = None,
        title: str | None = None,
        constants: Mapping[str, Any] | None = None,
        law: Any = None,
        free: Mapping[str, Any] | None = None,
        program: Any = None,
        variables: Mapping[str, Any] | None = None,
        objective: Any = None,
        objectives: Sequence[Any] | None = None,
        constraints: Any = None,
        responses: Mapping[str, Any] | None = None,
        parts: Mapping[str, Any] | None = None,
        cams: Mapping[str, Mapping[str, Any]] | None = None,
        cases: Sequence[Mapping[str, Any]] | None = None,
        ranges: Mapping[str, Any] | None = None,
        variation: Mapping[str, Any] | None = None,
        buildable: Mapping[str, Any] | None = None,
        profile: Mapping[str, Any] | None = None,
        solver: Mapping[str, Any] | None = None,
        source: str = "problem",
        format: str | None = None,
        _native: Any = None,
    ) -> None:
        if _native is not None:
            self._native = _native
            return
        held: Held = {}
        table = problem_table(
            mechanism,
            machine=machine,
            title=title,
            constants=constants,
            law=law,
            free=free,
            program=program,
            variables=variables,
            objective=objective,
            objectives=objectives,
            constraints=constraints,
            responses=responses,
            parts=parts,
            cams=cams,
            cases=cases,
            ranges=ranges,
            variation=variation,
            buildable=buildable,
            profile=profile,
            solver=solver,
            held=held,
        )
        laws = {name: law._native for name, law in held.items()}
        stated = native.problem_format if format is None else _text(format, "format")
        table = {"format": stated, **table}
        self._native = native.problem(toml_text(table), _text(source, "source"), laws)

    @classmethod
    def load(cls, path: str | Path) -> Problem:
        """Reads a problem file. Raises InputError with the line and what is accepted."""
        return cls(_native=native.problem_file(checked_path(path)))

    @classmethod
    def from_text(cls, text: str, source: str = "problem") -> Problem:
        """Reads the text of a problem file; `source` names it in errors."""
        return cls(_native=native.problem(_text(text, "text"), _text(source, "source")))

    @classmethod
    def new(cls, mechanism: str) -> Problem:
        """A problem of a mechanism to begin with, as 'camlaw new' writes it. Comments in its text explain
        each line, and it can be optimized as it is."""
        return cls.from_text(native.first_file(_text(mechanism, "mechanism")), mechanism)

    @classmethod
    def example(cls, name: str) -> Problem:
        """A problem that comes with the package, one of examples(): "cams/roller_least_base"."""
        return cls(_native=native.example(_text(name, "example")))

    def save(self, path: str | Path) -> None:
        """Writes the problem's text, and next to it the laws and tables that it names, unless they are
        there. Raises InputError if the text does not have all of the problem: if set() has changed
        values, or if it is a design that was found."""
        beside = self._native.found_settings()
        if beside:
            raise InputError(
                f"save writes the problem's text, which does not have these values: {', '.join(beside)}"
            )
        place = Path(checked_path(path))
        files = {place.parent / name: text for name, text in self._native.held_files().items()}
        if place.resolve() in {file.resolve() for file in files}:
            raise InputError(
                f"path: the problem is read from {place}; the problem's text needs another name"
            )
        for file, text in files.items():
            if not file.exists() and not file.resolve().is_relative_to(place.parent.resolve()):
                raise InputError(
                    f"{file} is outside the folder of {place}, where a problem's files are saved with it"
                )
        for file, text in files.items():
            if file.exists() and not _is_same_file(file, text):
                raise InputError(
                    f"{file} is there already and is not what the problem names by this name; save the "
                    "problem into another folder"
                )
        for file, text in files.items():
            if not file.exists():
                file.parent.mkdir(parents=True, exist_ok=True)
                written(text, file)
        written(self.text, place)

    @property
    def text(self) -> str:
        """The text of the problem file."""
        return self._native.text

    @property
    def title(self) -> str:
        return self._native.title

    @property
    def mechanism(self) -> str:
        return self._native.mechanism

    @property
    def settings(self) -> list[str]:
        """What set() has changed, as the program's --set takes it."""
        return self._native.settings

    @property
    def law(self) -> Law | None:
        """The law or motion program, the first of several; None if the machine has none."""
        found = self._native.law()
        return None if found is None else Law(found)

    @property
    def variables(self) -> Any:
        """A table: name, unit, lower, upper, start, integer, values."""
        return tables.of_rows(self._native.variables(), index="name")

    @property
    def constants(self) -> dict[str, float]:
        """Every parameter of the mechanism with its value, in its listed unit."""
        return {name: value for name, (value, _) in self._native.constants().items()}

    @property
    def units(self) -> dict[str, str]:
        """The listed unit of every parameter of the mechanism, and of the variables."""
        known = {name: unit for name, (_, unit) in self._native.constants().items()}
        return known | {row["name"]: row["unit"] for row in self._native.variables()}

    @property
    def responses(self) -> Any:
        """A table of the machine's responses: response, kind, unit, meaning."""
        return tables.of_rows(self._native.machine()["responses"], index="response")

    def set(self, values: Mapping[str, Any] | None = None, /, **more: Any) -> Problem:
        """The problem with other values: starts of variables, constants, coefficients of the law, values
        in load cases ("fast.speed"), bounds of limits ("pressure_angle.upper"), or another law, by its
        name or as a Law of the catalogue."""
        given = {**mapping(values, "set", "{'stroke': '32 mm'}"), **more}
        settings = units.settings_of(
            {
                name: name_of(value, name) if isinstance(value, Law) else value
                for name, value in given.items()
            }
        )
        return Problem(_native=self._native.with_settings(settings))

    def _counted(self) -> str:
        count = len(self._native.variables())
        return f"{count} variable{'' if count == 1 else 's'}"

    def check(self) -> Check:
        """The problem in words, with what depends on what and in which shape."""
        facts, text, html = self._native.check()
        return Check(text, facts, html)

    def check_derivatives(self) -> Any:
        """A table that compares every derivative with differences, with a row for each law and objective:
        whether they agree, the worst error and where it is, and shapes that do not hold."""
        return tables.of_rows(self._native.check_derivatives(), index="problem")

    def scaling(self) -> Any:
        """A table of what variables, objective and limits are divided by, and their tolerances."""
        return tables.of_rows(self._native.scaling(), index="of")

    def formula(self, response: str) -> str:
        """The formula of a response, in the grammar of docs/formulas.md."""
        return self._native.formula(_text(response, "response"))

    def evaluate(
        self,
        values: Mapping[str, Any] | None = None,
        /,
        *,
        time_limit: Any = None,
        **more: Any,
    ) -> Evaluation:
        """Every response at the variables' starts or at these values, proved over the whole cycle.

        time_limit: seconds, or a text such as "1 min", after which proofs end; what is still open then is
        not proved, and facts["cut_short"] says why.
        """
        problem = self.set(values, **more) if values is not None or more else self
        return Evaluation(problem._native.evaluate(units.seconds(time_limit)))

    def evaluate_many(
        self, values: Mapping[str, Any], responses: Sequence[str] | None = None
    ) -> Any:
        """Many designs at once: a table with a row for each, of responses and of limits' margins.

        `values` has arrays of one length by the names of variables, constants or coefficients of the
        law, in their listed units or as quantities of pint. `responses` names the responses, in the
        words of problem files; by default all of the machine's. A curve has the columns "lowest NAME"
        and "highest NAME". These values are searched for, not proved.
        """
        given = {
            name: self._numbers(name, each)
            for name, each in mapping(values, "values", "{'base_radius': [40, 50]}").items()
        }
        longest = max((len(array) for array in given.values()), default=0)
        given = {
            name: np.full(longest, array[0]) if len(array) == 1 else array
            for name, array in given.items()
        }
        found = native.evaluate_many(
            self._native,
            list(given),
            list(given.values()),
            None if responses is None else texts(responses, "responses"),
        )
        return tables.of_columns(
            given | {name: column for name, _, column in found},
            {name: unit for name, unit, _ in found},
        )

    def _numbers(self, name: str, values: Any) -> np.ndarray:
        """An array in the listed unit of a variable or a constant."""
        if is_pint(values):
            unit = self._native.unit_of(name)
            one = native.quantity(units.value_text(1 * values.units), unit, unit, name)
            values = np.asarray(values.magnitude, dtype=np.float64) * one
        return numbers(values, name)

    def curves(self, points: int = 720) -> Any:
        """A table of every curve, "NAME [UNIT]", at evenly spaced places of the cycle, which come first.

        points: the number of equal steps of the cycle; the table has one row more.
        """
        return tables.of_columns(self._native.curves(whole(points, "points", 1, _MOST_POINTS)))

    def plot(self) -> Any:
        """Draws every curve over the cycle with matplotlib; returns the axes."""
        return plots.draw(self._native.curves_figure())

    def plot_profile(self) -> Any:
        """Draws the cam's profile, its pitch curve and the cutter-centre path; returns the axes."""
        return plots.draw(self._native.profile_figure(), equal=True)

    def svg(self, path: str | Path | None = None, *, profile: bool = False) -> str:
        """Every curve over the cycle as a picture in SVG; written to `path` if given. profile: the cam's
        profile, its pitch curve and the cutter-centre path instead."""
        native_svg = self._native.profile_svg if flag(profile, "profile") else self._native.curves_svg
        return rendered(native_svg(), path, self._native.source, is_input=self._native.is_input)

    def report(self, path: str | Path | None = None) -> str:
        """A page for the browser about the design at the variables' starts; written to `path` if given."""
        return rendered(
            native.report_of_problem(self._native),
            path,
            self._native.source,
            page=True,
            is_input=self._native.is_input,
        )

    def export(self, path: str | Path | None = None, **options: Any) -> str:
        """The cam's curves, motion or law as the text of a file; see Result.export."""
        found = native.export_problem(self._native, export_options(path, options))
        return exported(found, path, self._native.source, self._native.is_input)

    def __eq__(self, other: object) -> bool:
        """Whether the other states the same: text, files, what was set, and the design at its starts."""
        if not isinstance(other, Problem):
            return NotImplemented
        return self._stated() == other._stated()

    def __hash__(self) -> int:
        return hash(self.text)

    def _stated(self) -> tuple[Any, ...]:
        text, _source, *rest = self._native.__getstate__()
        return text, *rest

    def __repr__(self) -> str:
        return f"<camlaw problem {self.title or self.mechanism}: {self._counted()}>"

    def _repr_html_(self) -> str:
        return f"<p><b>{escape(self.title or self.mechanism)}</b></p>{self.check().html}"


def _is_same_file(file: Path, text: str) -> bool:
    """Whether a file says what a text does: a table the same text, a law the same pieces."""
    try:
        there = file.read_text(encoding="utf-8")
        return there == text or json.loads(there)["pieces"] == json.loads(text)["pieces"]
    except (OSError, ValueError, LookupError, TypeError):
        return False


def examples() -> Any:
    """A table of the problems that come with the package, by name, and what each is about."""
    rows = [{"name": name, "about": about} for name, about in native.examples()]
    return tables.of_rows(rows, index="name")


__all__ = ["Check", "Evaluation", "Problem", "Range", "examples"]
