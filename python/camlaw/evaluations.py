# SPDX-License-Identifier: MIT
"""What is said of a problem without a search: a design evaluated, a problem said back."""

from __future__ import annotations

from typing import Any, NamedTuple

from . import tables
from .errors import InputError


class Range(NamedTuple):
    """What a curve does over the cycle: its extremes, where they are, and whether they are proved."""

    lowest: float
    lowest_at: float
    highest: float
    highest_at: float
    unit: str
    proved: bool


class Evaluation:
    """Every response of a design, how its limits stand, and whether it can be built."""

    def __init__(self, facts: dict[str, Any]) -> None:
        self._rows = {row["response"]: row for row in facts["responses"]}
        self._limits = facts["limits"]
        self.buildable: dict[str, Any] | None = facts["buildable"]
        self.warnings: list[str] = facts["warnings"]

    def __getitem__(self, response: str) -> float | Range:
        """A number's value; of a curve its Range."""
        row = self._rows.get(response)
        if row is None:
            raise InputError(
                f"no response is called '{response}'; there are {', '.join(self._rows)}"
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
        """A table of the limits: value, bound, side, margin, unit, at, met, proved."""
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


class Check(NamedTuple):
    """A problem said back: in words, as facts, as HTML."""

    text: str
    facts: dict[str, Any]
    html: str

    def __str__(self) -> str:
        return self.text

    def __repr__(self) -> str:
        return self.text

    def _repr_html_(self) -> str:
        return self.html
