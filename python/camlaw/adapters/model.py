# SPDX-License-Identifier: MIT
"""A problem as plain functions of an array, with exact derivatives."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from ..arguments import numbers, shown
from ..errors import InputError
from ..native import native
from ..problems import Problem


class Variable(NamedTuple):
    """One number of a design. `integer`: only whole numbers, or some of them, are possible."""

    name: str
    unit: str
    lower: float
    upper: float
    start: float
    integer: bool


class Output(NamedTuple):
    """One function of a design. sign: -1 for an objective that the problem maximises."""

    name: str
    unit: str
    sign: float


class Model:
    """Objectives to be minimised and margins to be kept at zero or above.

    The variables are the problem's, all of them as continuous numbers; where the problem chooses
    between laws, the first is taken. An upper and a lower limit are a margin each; that of a curve is
    taken at its peak over the cycle.
    """

    def __init__(self, problem: Problem) -> None:
        if not isinstance(problem, Problem):
            raise InputError(f"problem: {shown(problem)} is not a camlaw.Problem")
        self.problem = problem
        self._native = native.Model(problem._native)
        self.variables = [Variable(*row) for row in self._native.variables()]
        outputs = [Output(*row) for row in self._native.outputs()]
        count = self._native.objectives
        self.objectives = outputs[:count]
        self.margins = [Output(name, unit, 1.0) for name, unit, _ in outputs[count:]]
        if not self.variables:
            raise InputError("the problem has no variables, so there is nothing to search for")

    def __reduce__(self) -> Any:
        return Model, (self.problem,)

    @property
    def lower(self) -> np.ndarray:
        return np.array([v.lower for v in self.variables])

    @property
    def upper(self) -> np.ndarray:
        return np.array([v.upper for v in self.variables])

    @property
    def start(self) -> np.ndarray:
        return np.array([v.start for v in self.variables])

    def values(self, x: Any) -> tuple[np.ndarray, np.ndarray]:
        """Objectives and margins; of an array of designs, a row for each."""
        designs = numbers(x, "x", 2)
        found = self._native.values(np.atleast_2d(designs))
        count = len(self.objectives)
        if designs.ndim == 1:
            return found[0, :count], found[0, count:]
        return found[:, :count], found[:, count:]

    def derivatives(self, x: Any) -> tuple[np.ndarray, np.ndarray]:
        """The derivatives of objectives and margins with respect to the variables, a row for each
        function."""
        found = self._native.jacobian(numbers(x, "x"))
        count = len(self.objectives)
        return found[:count], found[count:]

    def design(self, x: Any) -> Problem:
        """The problem at a design, to be evaluated and proved."""
        values = numbers(x, "x")
        if len(values) != len(self.variables):
            raise InputError(f"x: a design has {len(self.variables)} numbers, not {len(values)}")
        rounded = [
            round(value) if v.integer and np.isfinite(value) else float(value)
            for v, value in zip(self.variables, values)
        ]
        return self.problem.set({v.name: value for v, value in zip(self.variables, rounded)})
