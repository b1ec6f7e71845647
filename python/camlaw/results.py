# SPDX-License-Identifier: MIT
"""Results: a design that was found, with its verdict."""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import Any, NamedTuple

from . import plots, tables
from .answers import Answer
from .arguments import text
from .arguments import path as checked_path
from .errors import InputError
from .motion_laws import Law
from .native import native
from .outputs import export_options, exported, keep_input, rendered, written
from .problems import Problem


#: What a search says of its answer, which a design alone does not tell.
_CLAIMS = {
    "active",
    "best_possible",
    "kkt_residual",
    "objective_case",
    "objective_cases",
    "objective_proved",
    "objective_undecided",
    "objective_why_not_proved",
    "objective_worst_angle_deg",
    "objective_worst_at",
    "second_order",
}


class Verification(NamedTuple):
    """A result's claim judged again by its own problem, without a search.

    holds: whether the whole claim is confirmed. disagreements: what is not confirmed, in words.
    not_judged: what cannot be judged without a search. record: remarks on the file.
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


class Result(Answer):
    """The answer to a problem: a design with its verdict.

    result["base_radius"] is the value of a variable, in the unit that result.units has. facts has all
    that the program's --json prints.
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
        """Reads a result's file. camlaw computes everything in it again: review says where the file and its design
        disagree. If they do, verdict, objective and margins are not the file's, but those of its
        design."""
        result = cls(native.result_file(checked_path(path)))
        if result.review:
            result._judge_again()
        return result

    def _judge_again(self) -> None:
        """Replaces what a file claims about the design by what the design is."""
        found = self.verify()
        limits = [
            {
                **limit,
                "worst_angle_deg": limit["at"],
                "multiplier": None,
                "at_rest": None,
                "eased_by": None,
                "eased_gain": None,
            }
            for limit in self.design.evaluate()._limits
        ]
        for limit in limits:
            del limit["at"]
        starts = {row["name"]: row["start"] for row in self._native.design().variables()}
        claims = set(self.facts) & _CLAIMS
        remarks = "; ".join(self.review)
        self.facts = self.facts | dict.fromkeys(claims) | {
            "status": None,
            "verdict": found.verdict,
            "reason": f"{found.reason}; {remarks}" if found.reason else remarks,
            "global": False,
            "objective": found.objective,
            "constraints": limits,
            "variables": {
                name: starts.get(name, value) for name, value in self.variables.items()
            },
        }

    def save(self, path: str | Path) -> None:
        """Writes the result as 'camlaw optimize --out' does. The file needs no other file."""
        named = checked_path(path)
        keep_input(named, self._native.is_input)
        written(self._native.json_text(), named)

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
        """Whether it is proved that no better design exists anywhere."""
        return bool(self.facts.get("global"))

    @property
    def objective(self) -> float:
        """The objective's value, in its listed unit; of a design of a front, facts["objectives"] has
        all."""
        value = self.facts.get("objective")
        return float("nan") if value is None else float(value)

    @property
    def variables(self) -> dict[str, Any]:
        """The values of variables that were found, and the choices, by name."""
        return self.facts.get("variables", {})

    @property
    def units(self) -> dict[str, str]:
        return self.facts.get("units", {})

    def __getitem__(self, name: str) -> Any:
        """The value of a variable or a choice of the design, or of a parameter of its machine."""
        if text(name, "result") in self.variables:
            return self.variables[name]
        known = self.design.constants
        if name in known:
            return known[name]
        raise InputError(
            f"the design has no '{name}'; it has {', '.join({**self.variables, **known})}"
        )

    @property
    def margins(self) -> Any:
        """A table of the limits: value, bound, margin, unit, place, whether met and proved, multiplier."""
        return tables.of_rows(self.facts.get("constraints") or [], index="name")

    @property
    def table(self) -> Any:
        """A table of what the search found with each combination of laws, parts and other choices, the
        best first. It is empty if there was nothing to choose, or if the result was read from a file.
        With optimize(table=True), from_free_law says how far each is from a free law, in %, and
        facts["free_law"] what that reaches."""
        return tables.of_rows(self._native.combinations())

    @property
    def warnings(self) -> list[str]:
        return self.facts.get("warnings", [])

    @property
    def buildable(self) -> Any:
        """Whether the design can be built: what the program's checks say, as facts."""
        return self.facts.get("buildable")

    @property
    def problem(self) -> Problem:
        """The problem that it answers."""
        return Problem(_native=self._native.problem())

    @property
    def design(self) -> Problem:
        """The problem at the design that was found, for evaluate(), curves() and so on."""
        found = self._native.design()
        if found is None:
            raise InputError("the result has no design, as its search found none")
        return Problem(_native=found)

    @property
    def law(self) -> Law | None:
        """The law of the design with all its coefficients."""
        return self.design.law

    @property
    def curves(self) -> Any:
        """A table of every curve of the design at 721 evenly spaced places of the cycle."""
        return self.design.curves()

    @property
    def review(self) -> list[str]:
        """Remarks on a result that was read: that it was changed, or that a number does not fit the
        design. Empty if the file is as it was written."""
        return self._native.review()

    def verify(self) -> Verification:
        """Judges the design and the claim again."""
        facts = self._native.verify()
        return Verification(
            **{name: facts[name] for name in Verification._fields if name != "facts"}, facts=facts
        )

    def plot(self) -> Any:
        """Draws the curves that are limited or optimized, with their limits; of a result that was read,
        every curve. Returns the axes."""
        figure = self._cycle_figure()
        return plots.draw(figure) if figure["panels"] else self.design.plot()

    def plot_profile(self) -> Any:
        """Draws the cam's profile, its pitch curve and the cutter-centre path; returns the axes."""
        return self.design.plot_profile()

    def report(self, path: str | Path | None = None) -> str:
        """A page for any browser, without a network: verdict, limits, curves, the machine in motion. It
        is returned, and written to `path` if given."""
        return rendered(
            self._native.report(),
            path,
            self._native.file,
            page=True,
            is_input=self._native.is_input,
        )

    def export(self, path: str | Path | None = None, **options: Any) -> str:
        """The cam for drawing, cutting or control, as the text of a file; written to `path` if given, whose
        ending decides the format: .csv, .dxf, .step, .svg, .json, .nc.

        format: csv, dxf, step, svg, json, gcode, inspection, table, or a drive's: beckhoff-points,
        beckhoff-motion, codesys, lenze, rockwell, siemens. curve: profile, second-profile, pitch,
        cutter, all. cam: of several cams on one shaft, the one to export; none for a slave that is a
        curve of the shaft itself. zero: shaft or cam, where that cam's tables and keyways begin. tolerance: how far the exact curve may be from what is written. step:
        even steps of the angle instead of a tolerance. form: lines, arcs, spline. docs/exports.md explains
        decimals, tool, feed, clearance, depth, width, slave and others; drawing and decimal_comma are True or
        False. Warns of each limit that the design does not meet.
        """
        found = native.export_result(self._native, export_options(path, options))
        return exported(found, path, self._native.file, self._native.is_input)

    def __str__(self) -> str:
        text = self._native.text
        return repr(self) if text is None else str(text)

    def __repr__(self) -> str:
        return f"<camlaw result: {self.verdict}{self._objectives()}>"

    def _objectives(self) -> str:
        """", base_radius = 52.6": every objective, of a design of a front several."""
        several = self.facts.get("objectives") or {}
        if not several and "objective_name" in self.facts:
            several = {self.facts["objective_name"]: self.objective}
        return "".join(f", {name} = {value:.10g}" for name, value in several.items())

    def _repr_html_(self) -> str:
        html = self._native.html
        if html is not None:
            return str(html)
        return f"<p><b>{escape(self.verdict)}</b>: {escape(self.reason)}</p>{self.margins._repr_html_()}"
