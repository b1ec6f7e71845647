# SPDX-License-Identifier: MIT
"""A disc cam's front of base radius, torque and contact stress, with two laws to choose from."""

from typing import Any

import numpy as np
from pymoo.algorithms.moo.nsga2 import NSGA2
from pymoo.core.problem import Problem
from pymoo.indicators.hv import HV
from pymoo.optimize import minimize

from cam import Array, Cam, Lift, bend, cycloidal, lift, modified_sine, tangent
from program import problem
from row import Json, Outcome, Row, excess

CAM = Cam()
FRICTION, OVERHANG, GUIDE = 0.12, 40.0, 60.0  # of the guide; mm
FACE, MODULUS, POISSON = 15.0, 210e3, 0.3  # mm; MPa
STEEPEST, STEEPEST_BACK = np.tan(np.radians(35)), np.tan(np.radians(40))
UNDERCUT, LEAST_FORCE = 0.8, 10.0  # N
LOWER, UPPER = (25.0, 5.0, 0.0, 0.0), (80.0, 20.0, 300.0, 2.0)  # base, roller, preload, law
STEP = 0.5  # degrees of the cam between places
POPULATION, GENERATIONS = 100, 200
NAMES = ("base_radius", "peak drive_torque", "highest contact_stress")


def lifts(step: float) -> Lift:
    """A row for each law of the rise, cycloidal and modified-sine."""
    up = np.linspace(0, 1, round(np.degrees(CAM.rise) / step) + 1)
    down = np.linspace(0, 1, round(np.degrees(CAM.fall) / step) + 1)
    rises = [lift(CAM, law, up, down) for law in (cycloidal, modified_sine)]
    return Lift(
        np.array([rise.s for rise in rises]),
        np.array([rise.s1 for rise in rises]),
        np.array([rise.s2 for rise in rises]),
    )


def evaluate(x: Array, of: Lift) -> tuple[Array, Array]:
    """Objectives (mm, N m, MPa) and what must not be above 0, a row for each design."""
    base, roller, preload = x[:, 0:1], x[:, 1:2], x[:, 2:3]
    law = (x[:, 3] >= 1).astype(int)
    s, s1, s2 = of.s[law], of.s1[law], of.s2[law]
    prime = base + roller
    slope = tangent(prime, s, s1)
    above, below = bend(prime, s, s1, s2)
    undercut = roller * above / below
    force = CAM.force(s, s2, preload)
    rubbed = FRICTION * (2 * (OVERHANG - s) / GUIDE + 1) * slope
    driven = force / np.where(force >= 0, 1 - rubbed, 1 + rubbed)
    normal = driven * np.sqrt(1 + slope**2)
    curvature = 1 / (roller * np.maximum(1 - undercut, 1e-9))
    pressed = MODULUS / (1 - POISSON**2) / (2 * np.pi) * normal / FACE * curvature
    objectives = [
        base[:, 0],
        np.abs(driven * s1).max(axis=1) / 1000,
        np.sqrt(np.maximum(pressed, 0).max(axis=1)),
    ]
    limits = [
        slope.max(axis=1) - STEEPEST,
        -STEEPEST_BACK - slope.min(axis=1),
        undercut.max(axis=1) - UNDERCUT,
        (LEAST_FORCE - force.min(axis=1)) / 100,
    ]
    return np.column_stack(objectives), np.column_stack(limits)


class RollerCam(Problem):
    def __init__(self) -> None:
        super().__init__(n_var=4, n_obj=3, n_ieq_constr=4, xl=LOWER, xu=UPPER)
        self.lifts = lifts(STEP)

    def _evaluate(self, x: Array, out: dict[str, Any], *_: Any, **__: Any) -> None:
        out["F"], out["G"] = evaluate(x, self.lifts)


def solve() -> Array:
    """The designs of the front."""
    found = minimize(RollerCam(), NSGA2(POPULATION), ("n_gen", GENERATIONS), seed=1)
    return np.atleast_2d(found.X)


def design(point: Json) -> list[float]:
    values = point["variables"]
    law = 1.5 if "rise=modified-sine" in point["law"] else 0.5
    return [values["base_radius"], values["roller_radius"], values["spring_preload"], law]


def volume(front: Array, ideal: Array, nadir: Array) -> float:
    """Of all that a front betters, up to a tenth beyond our worst, as a fraction of that box."""
    scaled = (front - ideal) / (nadir - ideal)
    return float(HV(ref_point=np.full(3, 1.1))(scaled)) / 1.1**3


def judge(answer: Json, found: Array) -> Outcome:
    """Both fronts by our ideal and nadir, and our own points by the peer's model, in one number."""
    dense = lifts(STEP / 20)
    theirs, limits = evaluate(found, dense)
    ours = np.array([[point["objectives"][name] for name in NAMES] for point in answer["points"]])
    modelled, _ = evaluate(np.array([design(point) for point in answer["points"]]), dense)
    apart = np.abs(modelled / ours - 1).max()
    ideal, nadir = np.array(answer["ideal"]), np.array(answer["nadir"])
    volumes = volume(ours, ideal, nadir), volume(theirs, ideal, nadir)
    certified = sum(point["verdict"] == "certified optimum" for point in answer["points"])
    return Outcome(
        f"{len(ours)} points, hypervolume {volumes[0]:.4f}; {certified} certified",
        f"{len(found)} points, hypervolume {volumes[1]:.4f}; its model gives our points "
        f"to {apart:.0e}",
        volumes[1] / volumes[0] - 1,
        0.02,
        said(limits.max(axis=0)),
    )


def said(limits: Array) -> str:
    return (
        f"tangent of the pressure angle by {excess(max(limits[:2]))}, "
        f"undercut by {excess(limits[2])}, force by {excess(100 * limits[3])} N"
    )


def rows() -> list[Row]:
    return [
        Row(
            "roller-front",
            "disc cam, front of base radius, torque and stress, 50 points",
            f"pymoo, NSGA-II, {POPULATION} designs, {GENERATIONS} generations",
            ["pareto", problem("cams/roller_front.toml"), "--points", "50", "--workers", "1"],
            solve,
            judge,
        )
    ]
