# SPDX-License-Identifier: MIT
"""The least base circle of a disc cam whose laws are given: one variable, limits at a grid."""

import numpy as np
from scipy.optimize import brentq, minimize

from cam import Array, Cam, Lift, bend, cycloidal, lift, tangent
from program import problem
from row import Json, Outcome, Row, excess, verdict

CAM = Cam()
ROLLER, PRELOAD = 8.0, 60.0  # mm, N
STEEPEST, STEEPEST_BACK = np.tan(np.radians(30)), np.tan(np.radians(40))
UNDERCUT = 0.8
LEAST, MOST, START = 10.0, 120.0, 60.0  # base radius, mm
PLACES = 721  # of the whole turn, a place each half degree


def moved(places: int) -> Lift:
    """Where the follower moves, of so many places of the turn."""
    up = np.linspace(0, 1, int(places * CAM.rise / (2 * np.pi)) + 1)
    down = np.linspace(0, 1, int(places * CAM.fall / (2 * np.pi)) + 1)
    return lift(CAM, cycloidal, up, down)


def margins(base: float, of: Lift) -> Array:
    """What is left of the limits at each place, above 0 where they hold, each of a size near 1."""
    prime = base + ROLLER
    slope = tangent(prime, of.s, of.s1)
    above, below = bend(prime, of.s, of.s1, of.s2)
    return np.concatenate(
        [
            STEEPEST - slope,
            STEEPEST_BACK + slope,
            UNDERCUT - ROLLER * above / below,
            CAM.force(of.s, of.s2, PRELOAD) / PRELOAD,
        ]
    )


def by_slsqp() -> float:
    of = moved(PLACES)
    found = minimize(
        lambda x: x[0],
        [START],
        jac=lambda x: np.ones(1),
        method="SLSQP",
        bounds=[(LEAST, MOST)],
        constraints={"type": "ineq", "fun": lambda x: margins(x[0], of)},
        options={"ftol": 1e-10},
    )
    if not found.success:
        raise SystemExit("SLSQP: " + found.message)
    return float(found.x[0])


def by_root() -> float:
    of = moved(PLACES)
    return float(brentq(lambda base: margins(base, of).min(), LEAST, MOST, xtol=1e-10))


def judge(answer: Json, theirs: float) -> Outcome:
    ours, of = answer["objective"], moved(200 * PLACES)
    prime = theirs + ROLLER
    angle = np.degrees(np.arctan(tangent(prime, of.s, of.s1))).max() - 30
    above, below = bend(prime, of.s, of.s1, of.s2)
    undercut = (ROLLER * above / below).max() - UNDERCUT
    return Outcome(
        f"{ours:.5f} mm; {verdict(answer)}",
        f"{theirs:.5f} mm",
        theirs / ours - 1,
        5e-4,
        f"pressure angle by {excess(angle)} deg, undercut by {excess(undercut)}",
    )


def rows() -> list[Row]:
    words = ["optimize", problem("cams/roller_least_base.toml"), "--workers", "1"]
    grid = f"{PLACES - 1} places of the turn"
    return [
        Row(
            f"one-variable-{name}",
            "disc cam, base radius alone",
            f"SciPy {peer}, {grid}",
            words,
            solve,
            judge,
        )
        for name, peer, solve in (
            ("slsqp", "SLSQP", by_slsqp),
            ("root", "brentq of the least margin", by_root),
        )
    ]
