# SPDX-License-Identifier: MIT
"""A problem stated by Python's values, as the tables of a problem file."""

from __future__ import annotations

import itertools
import re
from collections.abc import Mapping, Sequence
from typing import Any

from .arguments import mapping, optional_text, sequence, shown, text
from .errors import InputError
from .motion_laws import Law
from .own_machines import Machine, Response


#: Laws that a problem names as files, and has with it: by these names.
Held = dict[str, Law]


def law_name(law: Law, held: Held) -> str:
    """What a problem's text calls a law: by its name if it has one that everybody knows, else as a
    file, which the problem has with it."""
    if law._native.is_of_catalogue:
        return law.name
    stem = re.sub(r"\W+", "-", law.family).strip("-") or "law"
    names = (f"./{stem}{number}.json" for number in itertools.chain([""], itertools.count(2)))
    name = next(name for name in names if held.get(name, law) == law)
    held[name] = law
    return name


def law_table(law: Any, held: Held) -> Any:
    if isinstance(law, Law):
        if not law._native.is_of_catalogue:
            return {"name": law_name(law, held)}
        return {"name": law.family} | {
            name: value for name, value in law.coefficients.items() if value != []
        }
    if isinstance(law, (list, tuple)):
        return {"name": [law_name(item, held) if isinstance(item, Law) else item for item in law]}
    if isinstance(law, Mapping):
        return law
    return {"name": text(law, "law")}


def bounds_table(bounds: Any, what: str) -> dict[str, Any]:
    """(lower, upper), either of which may be None, or a table."""
    if isinstance(bounds, (tuple, list)) and len(bounds) == 2:
        lower, upper = bounds
        return {
            key: value for key, value in (("lower", lower), ("upper", upper)) if value is not None
        }
    if isinstance(bounds, Mapping):
        return dict(bounds)
    raise InputError(
        f"{what}: {shown(bounds)} is neither (lower, upper) nor a dict such as {{'upper': 0.8}}"
    )


def bounds_tables(bounds: Any, what: str) -> dict[str, Any] | None:
    """Such tables by name."""
    return {
        name: bounds_table(each, f"{what}.{name}") for name, each in mapping(bounds, what, "{'base_radius': ('10 mm', '120 mm')}").items()
    } or None


def segment_table(segment: Any, held: Held) -> dict[str, Any]:
    return {
        name: law_name(value, held) if isinstance(value, Law) else value
        for name, value in mapping(segment, "program").items()
    }


_SEGMENTS = "[{'name': 'rise', 'angle': '80 deg', 'law': 'cycloidal'}]"
_CASES = "[{'name': 'fast', 'speed': '400 rpm'}]"
_CONSTRAINTS = "[{'response': 'pressure_angle', 'upper': '30 deg'}]"


def program_table(program: Any, held: Held) -> dict[str, Any] | None:
    """The segments one after the other, or the table."""
    if program is None:
        return None
    if isinstance(program, Mapping):
        return dict(program)
    segments = sequence(program, "program", _SEGMENTS)
    return {"segments": [segment_table(segment, held) for segment in segments]}


def constraint_tables(constraints: Any) -> list[Any]:
    if isinstance(constraints, Mapping):
        tables = bounds_tables(constraints, "constraints") or {}
        return [{"response": name} | table for name, table in tables.items()]
    return [mapping(table, "constraints") for table in sequence(constraints, "constraints", _CONSTRAINTS)]


def constants_table(constants: Any) -> dict[str, Any] | None:
    stated = mapping(constants, "constants", "{'stroke': '30 mm'}")
    for name, value in stated.items():
        if value is None:
            raise InputError(
                f"constants.{name}: None is not a value; leave the name out for its default"
            )
    return stated or None


def objective_table(objective: Any, what: str) -> Any:
    """The name of what is to be least, or a table."""
    if objective is None or isinstance(objective, Mapping):
        return objective
    if isinstance(objective, str):
        return {"minimize": objective}
    raise InputError(
        f"{what}: {shown(objective)} is neither the name of a response nor a dict such as "
        "{'maximize': 'stroke'}"
    )


def response_table(response: Any, what: str) -> Any:
    if isinstance(response, Response):
        return response.table()
    return mapping(response, what)


def variation_table(variation: Any) -> dict[str, Any]:
    """A deviation, plus and minus, or a table."""
    if isinstance(variation, Mapping):
        return dict(variation)
    return {"plus": variation, "minus": variation}


def cam_table(name: str, cam: Any, held: Held) -> dict[str, Any]:
    """The table of one of several cams on a shaft, stated as a problem is."""
    stated = mapping(cam, f"cams.{name}")
    unknown = [key for key in stated if key not in _OF_A_CAM]
    if unknown:
        raise InputError(
            f"cams.{name}: a cam has no '{unknown[0]}'; it accepts {', '.join(_OF_A_CAM)}"
        )
    table = problem_table(**{**dict.fromkeys(_ALL), **stated}, held=held)
    return {key: value for key, value in table.items() if value is not None}


#: What Problem takes, and what of it the table of a cam has.
_OF_A_CAM = ("mechanism", "machine", "responses", "constants", "law", "free", "program", "parts",
             "variables", "buildable")  # fmt: skip
_ALL = ("mechanism", "machine", "title", "constants", "law", "free", "program", "variables",
        "objective", "objectives", "constraints", "responses", "parts", "cams", "cases", "ranges",
        "variation", "buildable", "profile", "solver")  # fmt: skip


def problem_table(
    mechanism: str | Machine | None,
    *,
    machine: Machine | Mapping[str, Any] | None,
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
    variation: Mapping[str, Any] | None,
    buildable: Mapping[str, Any] | None,
    profile: Mapping[str, Any] | None,
    solver: Mapping[str, Any] | None,
    held: Held,
) -> dict[str, Any]:
    """The tables of the problem file that states this; see Problem. Puts into `held` the laws that the
    problem has to have with it."""
    if isinstance(mechanism, Machine):
        mechanism, machine = None, mechanism
    if machine is not None and not isinstance(machine, (Machine, Mapping)):
        raise InputError(f"machine: {shown(machine)} is neither a camlaw.Machine nor a dict")
    stated = {
        name: response_table(response, f"responses.{name}")
        for name, response in mapping(responses, "responses", "{'load': camlaw.Response(...)}").items()
    }
    if isinstance(machine, Machine):
        stated = {name: r.table() for name, r in machine.responses.items()} | stated
    together = mapping(cams, "cams", "{'press': {'mechanism': ...}}")
    varied = mapping(variation, "variation", "{'base_radius': '0.02 mm'}")
    return {
        "title": optional_text(title, "title"),
        "mechanism": optional_text(mechanism, "mechanism"),
        "machine": machine.table() if isinstance(machine, Machine) else machine,
        "constants": constants_table(constants),
        "responses": stated or None,
        "law": law_table(law, held) if law is not None else None,
        "free": mapping(free, "free") or None,
        "program": program_table(program, held),
        "parts": mapping(parts, "parts", "{'roller': {'catalogue': 'rollers.csv'}}") or None,
        "cams": {name: cam_table(name, cam, held) for name, cam in together.items()} or None,
        "cases": [mapping(case, "cases") for case in sequence(cases, "cases", _CASES)] or None,
        "ranges": bounds_tables(ranges, "ranges"),
        "variation": {
            name: variation_table(each) for name, each in varied.items()
        }
        or None,
        "variables": bounds_tables(variables, "variables"),
        "objective": objective_table(objective, "objective"),
        "objectives": [
            objective_table(each, "objectives") for each in sequence(objectives, "objectives", "['base_radius']")
        ]
        or None,
        "constraints": constraint_tables(constraints) or None,
        "buildable": mapping(buildable, "buildable", "{'require': True}") or None,
        "profile": mapping(profile, "profile", "{'waviness': '2 um', 'waves': 40}") or None,
        "solver": mapping(solver, "solver", "{'name': 'ipopt'}") or None,
    }
