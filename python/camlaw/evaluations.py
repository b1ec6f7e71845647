# SPDX-License-Identifier: MIT
"""What can be said of a problem without a search: a design evaluated, a problem in words."""

from __future__ import annotations

from typing import Any, NamedTuple

from . import tables
from .answers import Answer
from .arguments import text
from .errors import InputError


class Range(NamedTuple):
    """Extremes of a curve over the cycle, where they are, and whether they are proved."""

    lowest: float
    lowest_at: float
    highest: float
    highest_at: float
    unit: str
    proved: bool


class Evaluation(Answer):
    """Every response of a design, the margins of its limits, and whether it can be built."""

    def __init__(self, facts: dict[str, Any]) -> None:
        self.facts = facts
        self._rows = {row["response"]: row for row in facts["responses"]}
        # Prices are those of an optimum.
        self._limits = [
            {key: value for key, value in limit.items() if key != "multiplier"}
            for limit in facts["limits"]
        ]
        self.buildable: dict[str, Any] | None = facts["buildable"]
        self.warnings: list[str] = facts["warnings"]

    def __getitem__(self, response: str) -> float | Range:
        """The value of a number, or the Range of a curve."""
        row = self._rows.get(text(response, "response"))
        if row is None:
            raise InputError(
                f"the machine has no response '{response}'; it has {', '.join(self._rows)}"
            )
        if not row["curve"]:
            return float(row["value"])
        return Range(
            row["lowest"],
            row["lowest_at"],
            row["highest"],
            row["highest_at"],
            row["unit"],
            row["proved"],
        )

    @property
    def responses(self) -> Any:
        """A table: value, lowest, lowest_at, highest, highest_at, unit, proved, meaning."""
        return tables.of_rows(list(self._rows.values()), index="response")

    @property
    def margins(self) -> Any:
        """A table of the limits: value, bound, side, margin, unit, at, worst_at, met, proved,
        why_no_value, undecided, why_not_proved."""
        return tables.of_rows(self._limits, index="name")

    @property
    def feasible(self) -> bool:
        """Whether every limit is met."""
        return all(limit["met"] for limit in self._limits)

    def __repr__(self) -> str:
        met = sum(limit["met"] for limit in self._limits)
        return f"<camlaw evaluation: {len(self._rows)} responses, {met} of {len(self._limits)} limits met>"

    def _repr_html_(self) -> str:
        return self.responses._repr_html_() + (self.margins._repr_html_() if self._limits else "")


class _Told(Answer):
    """What the program says, as facts, text and HTML."""

    def __init__(self, answer: tuple[dict[str, Any], str, str]) -> None:
        self.facts, self._text, self._html = answer

    def __str__(self) -> str:
        return self._text

    def __repr__(self) -> str:
        return self._text

    def _repr_html_(self) -> str:
        return self._html


class Sensitivity(_Told):
    """How a design's numbers depend on its parameters. `facts` has what 'camlaw evaluate
    --sensitivity --json' adds."""

    @property
    def derivatives(self) -> Any:
        """A table of derivatives: of the objective and of each limited number by each parameter, with
        the elasticity, % for 1 %. If `exact` is false, a derivative comes from finite differences."""
        return tables.of_rows(self.facts["sensitivity"]["derivatives"])

    @property
    def indices(self) -> Any:
        """A table of Sobol indices with their intervals; None if no parameter has a range."""
        found = self.facts["sensitivity"].get("sobol")
        return None if found is None else tables.of_rows(found["indices"])


class Tolerance(_Told):
    """What manufacturing tolerances do to a design: worst cases and yield. `facts` has what 'camlaw tolerance
    --json' prints.
    """

    @property
    def worst(self) -> Any:
        """A table of the worst case of each limit: its value, where it occurs, whether it is proved."""
        return tables.of_rows(self.facts["worst_cases"])

    @property
    def finished(self) -> bool:
        """Whether the work was finished; facts["cut_short"] says why it was not."""
        return not self.facts["cut_short"]

    @property
    def failing(self) -> float:
        """The estimated fraction of parts that break a limit."""
        return self._of_yield("failing")

    @property
    def standard_error(self) -> float:
        """The standard error of `failing`."""
        return self._of_yield("standard_error")

    def _of_yield(self, name: str) -> float:
        found = self.facts.get(name)
        if found is None:
            raise InputError("there is no yield: no part can break a limit, or the work was cut short")
        return float(found)


class Check(NamedTuple):
    """A problem in words: as text, as facts and as HTML."""

    text: str
    facts: dict[str, Any]
    html: str

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return self.html
