# SPDX-License-Identifier: MIT
"""A problem as a component of OpenMDAO, with exact partial derivatives."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import openmdao.api as om

from ..problems import Problem
from .model import Model


def component_name(name: str) -> str:
    """A name that OpenMDAO accepts: "peak force" as "peak_force", "c[2]" as "c_2"."""
    return re.sub(r"\W+", "_", name).strip("_")


class CamlawComponent(om.ExplicitComponent):
    """Inputs are the variables, outputs the objectives and the margins of limits, each of which
    must not be below zero. Units are declared where OpenMDAO knows them; numbers are in the
    problem's units.

    An objective that the problem maximises keeps its sign: add_objective(name, scaler=-1).
    """

    def initialize(self) -> None:
        self.options.declare("problem", types=Problem, desc="a camlaw.Problem", recordable=False)

    def setup(self) -> None:
        self._model = model = Model(self.options["problem"])
        self.input_names = [component_name(v.name) for v in model.variables]
        self.output_names = [component_name(o.name) for o in model.objectives] + [
            "margin_" + component_name(o.name) for o in model.margins
        ]
        taken = set(self.input_names)
        self.output_names = [
            name if name not in taken else "objective_" + name for name in self.output_names
        ]
        for name, variable in zip(self.input_names, model.variables):
            self.add_input(name, val=variable.start, units=self._unit(variable.unit))
        for name, output in zip(self.output_names, model.objectives + model.margins):
            self.add_output(name, units=self._unit(output.unit))

    def setup_partials(self) -> None:
        self.declare_partials("*", "*")

    @staticmethod
    def _unit(unit: str) -> str | None:
        if unit == "1":
            return None
        from openmdao.utils.units import valid_units

        return unit if valid_units(unit) else None

    def _design(self, inputs: Any) -> np.ndarray:
        return np.array([inputs[name].item() for name in self.input_names])

    def compute(
        self, inputs: Any, outputs: Any, discrete_inputs: Any = None, discrete_outputs: Any = None
    ) -> None:
        objectives, margins = self._model.values(self._design(inputs))
        signs = [o.sign for o in self._model.objectives]
        for name, value in zip(self.output_names, [*(objectives * signs), *margins]):
            outputs[name] = value

    def compute_partials(self, inputs: Any, partials: Any, discrete_inputs: Any = None) -> None:
        objectives, margins = self._model.derivatives(self._design(inputs))
        signs = np.array([[o.sign] for o in self._model.objectives])
        for name, row in zip(self.output_names, [*(objectives * signs), *margins]):
            for of, value in zip(self.input_names, row):
                partials[name, of] = value
