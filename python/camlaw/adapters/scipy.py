# SPDX-License-Identifier: MIT
"""A problem for scipy.optimize.

objective = ScipyObjective(problem)
found = scipy.optimize.minimize(objective, objective.start, jac=objective.gradient,
                                bounds=objective.bounds, constraints=objective.constraints)
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ..errors import InputError
from ..problems import Problem
from .model import Model


class ScipyObjective:
    """The objective of a problem, with gradient, bounds and constraints as SciPy takes them."""

    def __init__(self, problem: Problem) -> None:
        self.model = Model(problem)
        if len(self.model.objectives) != 1:
            raise InputError(
                f"the problem has {len(self.model.objectives)} objectives; SciPy searches with one"
            )

    def __call__(self, x: Any) -> float:
        """The function to be minimised."""
        return float(self.model.values(x)[0][0])

    def gradient(self, x: Any) -> np.ndarray:
        return self.model.derivatives(x)[0][0]

    @property
    def start(self) -> np.ndarray:
        return self.model.start

    @property
    def bounds(self) -> list[tuple[float, float]]:
        return [(v.lower, v.upper) for v in self.model.variables]

    @property
    def constraints(self) -> list[dict[str, Any]]:
        """The margins, none below zero: for the methods SLSQP and COBYLA."""
        if not self.model.margins:
            return []
        return [
            {
                "type": "ineq",
                "fun": lambda x: self.model.values(x)[1],
                "jac": lambda x: self.model.derivatives(x)[1],
            }
        ]

    @property
    def nonlinear_constraint(self) -> Any:
        """The same for the method trust-constr and for differential_evolution."""
        from scipy.optimize import NonlinearConstraint

        return NonlinearConstraint(
            lambda x: self.model.values(x)[1], 0, np.inf, jac=lambda x: self.model.derivatives(x)[1]
        )
