# SPDX-License-Identifier: MIT
"""Cam motion laws and mechanisms: choose, optimise, fit, check; every answer proved.

    import camlaw as cl
    law = cl.law("modified-sine", crossover=0.42)
    problem = cl.Problem.load("roller.toml")
    result = problem.optimize()

docs/python.md is a tutorial. The names are those of the program's files and of docs/glossary.md.
InputError says what is wrong with an input. All that the package raises by itself is an Error,
except Interrupted, which Ctrl-C raises.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from .errors import Error, InputError, Interrupted, MissingPackage

if TYPE_CHECKING:
    from . import formulas
    from .evaluations import Check, Evaluation, Sensitivity, Tolerance
    from .fits import Fit, fit, fit_constants
    from .formulas import Expression
    from .fronts import Front
    from .machines import mechanism, mechanisms
    from .motion_laws import Law, Motion, Peaks, law, law_file, law_table, laws
    from .own_machines import Machine, Response
    from .problems import Problem, examples
    from .published import Reproduction, Study, cam_shape, reproduce, reproducible, study
    from .results import Result, Verification
    from .sweeps import Sweep

# Where each name is; what is not asked for is not read.
_HOMES = {
    "Fit": "fits",
    "fit": "fits",
    "fit_constants": "fits",
    "Expression": "formulas",
    "Machine": "own_machines",
    "Response": "own_machines",
    "formulas": "formulas",
    "Front": "fronts",
    "Law": "motion_laws",
    "Motion": "motion_laws",
    "Peaks": "motion_laws",
    "law": "motion_laws",
    "law_file": "motion_laws",
    "law_table": "motion_laws",
    "laws": "motion_laws",
    "mechanism": "machines",
    "mechanisms": "machines",
    "Check": "evaluations",
    "Evaluation": "evaluations",
    "Sensitivity": "evaluations",
    "Tolerance": "evaluations",
    "Problem": "problems",
    "examples": "problems",
    "cam_shape": "published",
    "Reproduction": "published",
    "Study": "published",
    "reproduce": "published",
    "reproducible": "published",
    "study": "published",
    "Result": "results",
    "Verification": "results",
    "Sweep": "sweeps",
}

__all__ = ["Error", "InputError", "Interrupted", "MissingPackage", *sorted(_HOMES)]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from .native import native

        return native.version().split()[-1]
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module 'camlaw' has no attribute '{name}'")
    module = import_module(f".{home}", __name__)
    value = module if name == home else getattr(module, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__, "__version__"})
