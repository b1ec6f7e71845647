# SPDX-License-Identifier: MIT
"""Results: a design that was found, and what it is worth."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Any, NamedTuple

from . import plots, tables
from .errors import InputError
from .motion_laws import Law
from .native import native
from .outputs import export_options, written
from .problems import Problem


class Verification(NamedTuple):
    """A result's claim judged again by its own problem, without a search.

    holds: whether all of it is confirmed. disagreements: what is not, in words. not_judged: what
    cannot be judged without a search. record: what is to be said of the file.
    """

    holds: bool
    claimed: str
    verdict: str
    reason: str
    objective: float
    disagreements: list[str]
    not_judged: list[str]
    record: list[str]
    facts: dict[str, Any]

    def __repr__(self) -> str:
        said = "holds" if self.holds else "; ".join(self.disagreements) or "does not hold"
        return f"<camlaw verification: {said}; {self.verdict}>"


class Result:
    """The answer to a problem: a design with its verdict.

    result["base_radius"] is a variable's value, in the unit result.units has. facts has all that
    the program's --json prints.
    """

    def __init__(self, native_result: Any) -> None:
        self._native = native_result
        self.facts: dict[str, Any] = native_result.facts()
        self._figure: dict[str, Any] | None = None

    def __getstate__(self) -> dict[str, Any]:
        # What is drawn is worked out of the search, which does not go along.
        return self.__dict__ | {"_figure": self._cycle_figure()}

    def _cycle_figure(self) -> dict[str, Any]:
        return self._native.cycle_figure() if self._figure is None else self._figure

    @classmethod
    def load(cls, path: str | Path) -> Result:
        """Reads a result's file. Nothing in it is believed: review says where it is not what its
        design is."""
        return cls(native.result_file(str(path)))

    def save(self, path: str | Path) -> None:
        """Writes the result as 'camlaw optimize --out' does: it stands alone."""
        written(self._native.json_text(), path)

    @property
    def verdict(self) -> str:
        """ "certified optimum", "feasible", "infeasible" or "failed"."""
        return self.facts["verdict"]

    @property
    def reason(self) -> str:
        """Why the verdict is what it is."""
        return self.facts["reason"]

    @property
    def certified(self) -> bool:
        return bool(self.verdict == "certified optimum")

    @property
    def is_global(self) -> bool:
        """Whether no better design exists anywhere."""
        return bool(self.facts.get("global"))

    @property
    def objective(self) -> float:
        """The objective's value, in its listed unit."""
        value = self.facts.get("objective")
        return float("nan") if value is None else float(value)

    @property
    def variables(self) -> dict[str, Any]:
        """What was found: values of variables, and choices, by name."""
        return self.facts.get("variables", {})

    @property
    def units(self) -> dict[str, str]:
        return self.facts.get("units", {})

    def __getitem__(self, name: str) -> Any:
        """A variable or a choice of the design; else a parameter of its machine."""
        if name in self.variables:
            return self.variables[name]
        known = self.design.constants
        if name in known:
            return known[name]
        raise InputError(
            f"the design has no '{name}'; it has {', '.join({**self.variables, **known})}"
        )

    @property
    def margins(self) -> Any:
        """A table of the limits: value, bound, margin, unit, where, whether met and proved, price."""
        return tables.of_rows(self.facts.get("constraints") or [], index="name")

    @property
    def warnings(self) -> list[str]:
        return self.facts.get("warnings", [])

    @property
    def buildable(self) -> Any:
        """Whether it can be made: what the program's checks say, as facts."""
        return self.facts.get("buildable")

    @property
    def problem(self) -> Problem:
        """The problem that it answers."""
        return Problem(_native=self._native.problem())

    @property
    def design(self) -> Problem:
        """The problem at the design: its evaluate(), curves() and so on are the design's."""
        found = self._native.design()
        if found is None:
            raise InputError("the result has no design: its search found none")
        return Problem(_native=found)

    @property
    def law(self) -> Law | None:
        """The law of the design with all its coefficients."""
        return self.design.law

    @property
    def curves(self) -> Any:
        """A table of every curve of the design over the cycle, at 721 even places."""
        return self.design.curves()

    @property
    def review(self) -> list[str]:
        """Of a result that was read, what is to be said of it: that it was changed, that a number is
        not the design's. Empty where it is as it was written."""
        return self._native.review()

    def verify(self) -> Verification:
        """Judges the design and the claim again."""
        facts = self._native.verify()
        return Verification(
            **{name: facts[name] for name in Verification._fields if name != "facts"}, facts=facts
        )

    def plot(self) -> Any:
        """The curves that are limited or sought, with their limits; of a result that was read, every
        curve. Returns the axes."""
        figure = self._cycle_figure()
        return plots.draw(figure) if figure["panels"] else self.design.plot()

    def plot_profile(self) -> Any:
        """The cam: profile, pitch curve and path of the tool."""
        return self.design.plot_profile()

    def report(self, path: str | Path | None = None) -> str:
        """A page for any browser, offline: verdict, limits, curves, the machine in motion. Returned,
        and written where `path` is given."""
        return written(self._native.report(), path)

    def export(self, path: str | Path | None = None, **options: Any) -> str:
        """The cam for drawing, cutting or control, as the text of a file; written to `path`, whose
        ending tells the format: .csv, .dxf, .svg, .json, .nc.

        format: csv, dxf, svg, json, gcode, inspection, table, or a drive's: beckhoff-points, beckhoff-motion,
        codesys, lenze, rockwell, siemens. curve: profile, second-profile, pitch, cutter,
        all. tolerance: how far the exact curve may be from what is written. step: even steps of
        the angle in place of a tolerance. form: lines, arcs, spline. decimals, tool, feed,
        clearance, depth, slave and others: as docs/exports.md has them; drawing and decimal_comma are True or
        False.
        """
        text = native.export_result(self._native, export_options(path, options))
        return written(text, path)

    def __str__(self) -> str:
        text = self._native.text
        return repr(self) if text is None else str(text)

    def __repr__(self) -> str:
        return f"<camlaw result: {self.verdict}, {self.facts.get('objective_name', 'objective')} = {self.objective:.10g}>"

    def _repr_html_(self) -> str:
        html = self._native.html
        if html is not None:
            return str(html)
        return f"<p><b>{escape(self.verdict)}</b>: {escape(self.reason)}</p>{self.margins._repr_html_()}"
