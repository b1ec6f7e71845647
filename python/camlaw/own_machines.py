# SPDX-License-Identifier: MIT
"""Responses and machines of your own, written as Python functions; their formulas are recorded by
camlaw.formulas.

    machine = cl.Machine("toggle press", moved_by="law", parameters={
        "crank_radius": {"unit": "mm", "default": 40, "lower": 1, "upper": 500}, ...})

    @machine.response(unit="N")
    def inertia_force(m):
        return 2 * m.crank_radius * m.moved_mass / m.cycle_time**2 * m.a
"""

from __future__ import annotations

import inspect
from collections.abc import Callable
from typing import Any

from .arguments import mapping, optional_text, text
from .errors import InputError
from .formulas import Expression, Names, expression


class Response:
    """A response as a formula: a function of the machine's names, or the text of the formula.

    unit: the unit it is listed in; "1" for a plain number. meaning: a line for tables and reports; by
    default the first line of the function's documentation.
    """

    def __init__(
        self, formula: Callable[[Any], Any] | Expression | str, unit: str = "1", meaning: str = ""
    ) -> None:
        if callable(formula):
            written = formula(Names())
            meaning = meaning or (inspect.getdoc(formula) or "").partition("\n")[0]
            formula = expression(written)
        self.formula = formula.text if isinstance(formula, Expression) else text(formula, "formula")
        self.unit = text(unit, "unit")
        self.meaning = text(meaning, "meaning")

    def table(self) -> dict[str, str]:
        """[responses.NAME] of a problem file."""
        table = {"formula": self.formula, "unit": self.unit}
        return table | {"meaning": self.meaning} if self.meaning else table

    def __eq__(self, other: object) -> bool:
        return self.table() == other.table() if isinstance(other, Response) else NotImplemented

    def __hash__(self) -> int:
        return hash((self.formula, self.unit, self.meaning))

    def __repr__(self) -> str:
        return f"camlaw.Response({self.formula!r}, unit={self.unit!r})"


class Machine:
    """A machine of your own: its parameters, and its responses as formulas.

    moved_by: with "law" curves run over x, from 0 to 1; with "program" they run over the cam's angle;
    with "nothing" formulas can use the angle of a shaft that turns evenly. A parameter is a dict with
    default and, optionally, unit, lower, upper, type, symbol and meaning.
    """

    def __init__(
        self,
        name: str,
        moved_by: str = "nothing",
        parameters: dict[str, Any] | None = None,
        title: str | None = None,
        source: str | None = None,
    ) -> None:
        self.name = text(name, "name")
        self.moved_by = text(moved_by, "moved_by")
        self.title = optional_text(title, "title")
        self.source = optional_text(source, "source")
        self.parameters: dict[str, Any] = mapping(parameters, "parameters")
        self.responses: dict[str, Response] = {}

    def response(self, unit: str = "1", meaning: str = "", name: str | None = None) -> Any:
        """A decorator that makes a function a response of the machine, under the function's name."""

        text(unit, "unit")

        def add(function: Callable[[Any], Any]) -> Callable[[Any], Any]:
            called = name or function.__name__
            if called in self.responses:
                raise InputError(f"{self.name} has a response '{called}' already")
            self.responses[called] = Response(function, unit, meaning)
            return function

        return add

    def table(self) -> dict[str, Any]:
        """[machine] of a problem file."""
        return {
            "name": self.name,
            "title": self.title,
            "source": self.source,
            "moved_by": self.moved_by,
            "parameters": self.parameters,
        }

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Machine):
            return NotImplemented
        return self.table() == other.table() and self.responses == other.responses

    def __hash__(self) -> int:
        return hash((self.name, self.moved_by))

    def __repr__(self) -> str:
        return f"<camlaw machine {self.name}: {', '.join(self.responses)}>"
