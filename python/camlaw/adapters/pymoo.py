# SPDX-License-Identifier: MIT
"""A problem for pymoo: minimize(PymooProblem(problem), NSGA2(pop_size=40))."""

from __future__ import annotations

from typing import Any

import numpy as np
from pymoo.core.problem import Problem as _Base

from ..problems import Problem
from .model import Model


class PymooProblem(_Base):
    """Objectives, and margins as constraints G <= 0, of many designs at once. Integer variables are
    rounded."""

    def __init__(self, problem: Problem) -> None:
        self.model = Model(problem)
        self._whole = np.array([v.integer for v in self.model.variables])
        super().__init__(
            n_var=len(self.model.variables),
            n_obj=len(self.model.objectives),
            n_ieq_constr=len(self.model.margins),
            xl=self.model.lower,
            xu=self.model.upper,
        )

    def _evaluate(self, x: Any, out: dict[str, Any], *args: Any, **kwargs: Any) -> None:
        designs = np.where(self._whole, np.round(x), x)
        objectives, margins = self.model.values(designs)
        out["F"] = np.where(np.isnan(objectives), np.inf, objectives)
        if margins.shape[1]:
            out["G"] = np.where(np.isnan(margins), np.inf, -margins)
