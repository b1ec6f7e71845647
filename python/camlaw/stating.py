# SPDX-License-Identifier: MIT
"""A problem stated by Python's values, as the tables of a problem file."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from typing import Any

from .formulas import Machine, Response
from .motion_laws import Law


def law_table(law: Any) -> Any:
    if isinstance(law, Law):
        if os.sep in law.name:
            return {"name": law.name}
        return {"name": law.family} | {
            name: value for name, value in law.coefficients.items() if value != []
        }
    if isinstance(law, (list, tuple)):
        return {"name": [item.name if isinstance(item, Law) else item for item in law]}
    return {"name": law} if isinstance(law, str) else law


def bounds_table(bounds: Any) -> Any:
    if isinstance(bounds, (tuple, list)) and len(bounds) == 2:
        lower, upper = bounds
        return {
            key: value for key, value in (("lower", lower), ("upper", upper)) if value is not None
        }
    return bounds


def segment_table(segment: Mapping[str, Any]) -> dict[str, Any]:
    return {
        name: value.name if isinstance(value, Law) else value for name, value in segment.items()
    }


def constraint_tables(constraints: Any) -> list[Any]:
    if isinstance(constraints, Mapping):
        return [{"response": name} | bounds_table(bounds) for name, bounds in constraints.items()]
    return list(constraints)


def response_table(response: Any) -> Any:
    return response.table() if isinstance(response, Response) else response


def cam_table(cam: Mapping[str, Any]) -> dict[str, Any]:
    """The table of one of several cams on a shaft, stated as a problem is."""
    stated = dict.fromkeys(_OF_A_CAM) | dict(cam)
    table = problem_table(stated.pop("mechanism", None), **{**dict.fromkeys(_ALL), **stated})
    return {key: value for key, value in table.items() if value is not None}


#: What Problem takes, and what of it the table of a cam has.
_OF_A_CAM = ("mechanism", "machine", "responses", "constants", "law", "free", "program", "parts",
             "variables", "buildable")  # fmt: skip
_ALL = ("machine", "title", "constants", "law", "free", "program", "variables", "objective",
        "objectives", "constraints", "responses", "parts", "cams", "cases", "ranges", "buildable",
        "solver")  # fmt: skip


def problem_table(
    mechanism: str | Machine | None,
    *,
    machine: Machine | None,
    title: str | None,
    constants: Mapping[str, Any] | None,
    law: Any,
    free: Mapping[str, Any] | None,
    program: Any,
    variables: Mapping[str, Any] | None,
    objective: Any,
    objectives: Sequence[Any] | None,
    constraints: Any,
    responses: Mapping[str, Any] | None,
    parts: Mapping[str, Any] | None,
    cams: Mapping[str, Mapping[str, Any]] | None,
    cases: Sequence[Mapping[str, Any]] | None,
    ranges: Mapping[str, Any] | None,
    buildable: Mapping[str, Any] | None,
    solver: Mapping[str, Any] | None,
) -> dict[str, Any]:
    """The tables of the problem file that states this; see Problem."""
    if isinstance(mechanism, Machine):
        mechanism, machine = None, mechanism
    stated = {name: response_table(r) for name, r in (responses or {}).items()}
    if machine is not None:
        stated = {name: r.table() for name, r in machine.responses.items()} | stated
    if isinstance(program, (list, tuple)):
        program = {"segments": [segment_table(segment) for segment in program]}
    return {
        "title": title,
        "mechanism": mechanism,
        "machine": machine.table() if machine is not None else None,
        "constants": dict(constants) if constants else None,
        "responses": stated or None,
        "law": law_table(law) if law is not None else None,
        "free": free,
        "program": program,
        "parts": parts,
        "cams": {name: cam_table(cam) for name, cam in cams.items()} if cams else None,
        "cases": [dict(case) for case in cases] if cases else None,
        "ranges": {name: bounds_table(b) for name, b in ranges.items()} if ranges else None,
        "variables": {name: bounds_table(b) for name, b in variables.items()}
        if variables
        else None,
        "objective": {"minimize": objective} if isinstance(objective, str) else objective,
        "objectives": [{"minimize": o} if isinstance(o, str) else o for o in objectives]
        if objectives
        else None,
        "constraints": constraint_tables(constraints) if constraints else None,
        "buildable": buildable,
        "solver": solver,
    }
