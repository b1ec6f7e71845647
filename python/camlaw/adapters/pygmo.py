# SPDX-License-Identifier: MIT
"""A problem for pygmo: pygmo.problem(PygmoProblem(problem))."""

from __future__ import annotations

from typing import Any

import numpy as np

from ..problems import Problem
from .model import Model


class PygmoProblem:
    """A user-defined problem: objectives, then margins as inequalities <= 0, with gradients.
    Integer variables come last in pygmo; order[i] is the number of the problem's variable that
    is number i in pygmo."""

    def __init__(self, problem: Problem) -> None:
        self.model = Model(problem)
        variables = self.model.variables
        self.order = sorted(range(len(variables)), key=lambda i: variables[i].integer)

    def _design(self, x: Any) -> np.ndarray:
        design = np.empty(len(self.order))
        design[self.order] = x
        return design

    def fitness(self, x: Any) -> np.ndarray:
        objectives, margins = self.model.values(self._design(x))
        return np.concatenate([objectives, -margins])

    def gradient(self, x: Any) -> np.ndarray:
        objectives, margins = self.model.derivatives(self._design(x))
        return np.vstack([objectives, -margins])[:, self.order].ravel()

    def has_gradient(self) -> bool:
        return not self.get_nix()

    def get_bounds(self) -> tuple[list[float], list[float]]:
        return list(self.model.lower[self.order]), list(self.model.upper[self.order])

    def get_nobj(self) -> int:
        return len(self.model.objectives)

    def get_nic(self) -> int:
        return len(self.model.margins)

    def get_nix(self) -> int:
        return sum(v.integer for v in self.model.variables)

    def get_name(self) -> str:
        return self.model.problem.title or self.model.problem.mechanism

    def __reduce__(self) -> Any:
        return PygmoProblem, (self.model.problem,)

    def __deepcopy__(self, memo: Any) -> PygmoProblem:
        return PygmoProblem(self.model.problem)
