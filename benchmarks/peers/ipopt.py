# SPDX-License-Identifier: MIT
"""Ipopt as CasADi brings it, with its own settings and nothing printed."""

from typing import Any

import casadi
import numpy as np
from numpy.typing import NDArray


def solved(program: dict[str, Any], **ends: Any) -> NDArray[np.float64]:
    """The optimal variables of a program of CasADi; `ends` are the start and the bounds."""
    options: dict[str, Any] = {"ipopt.print_level": 0, "ipopt.sb": "yes", "print_time": False}
    ipopt = casadi.nlpsol("program", "ipopt", program, options)
    found = ipopt(**ends)
    if not ipopt.stats()["success"]:
        raise SystemExit("Ipopt: " + ipopt.stats()["return_status"])
    return np.array(found["x"]).ravel()
