# SPDX-License-Identifier: MIT
"""The front of the spine cutter's free law: cam radius against inertia force, 50 points."""

from collections.abc import Callable

import numpy as np

from least_peak import Exchange, LeastPeak, passed
from program import problem
from row import Json, Outcome, Row, excess
from splines import Array, FreeLaw

FILE = "spine_cutter/free_front.toml"
KNOTS, POINTS = 64, 50
RADIUS = 40 / (np.pi * np.tan(np.radians(30)))  # mm by C_v: stroke over pi tan(pressure angle)
FORCE = 4 * 2.4 * 0.04 * (0.3 / (np.pi * (0.050 - 2 * 0.001))) ** 2  # N by C_a
MOST_ACCELERATION = 12.238 / FORCE
BESIDE = 1 + 1e-7  # the ends lie so far beside the least values, where HiGHS is sure of its rows


def front(make: Callable[[], LeastPeak]) -> list[Array]:
    """Least accelerations for velocities between the ends, each begun where the last one ended."""
    program = make()
    program.bound(program.acceleration, MOST_ACCELERATION)
    steepest = program.least(program.velocity)
    program.bound(program.velocity, BESIDE * steepest[program.velocity])
    found = [program.least(program.acceleration)]
    program.bound(program.velocity, np.inf)
    gentlest = program.least(program.acceleration)
    program.bound(program.acceleration, BESIDE * gentlest[program.acceleration])
    fastest = program.least(program.velocity)[program.velocity]
    program.bound(program.acceleration, MOST_ACCELERATION)
    for velocity in np.linspace(steepest[program.velocity], fastest, POINTS)[1:]:
        program.bound(program.velocity, velocity)
        found.append(program.least(program.acceleration))
    return found


def points(answer: Json) -> Array:
    """C_v and C_a of each point of ours."""
    return np.array(
        [
            [
                point["objectives"]["minimum_cam_radius"] / RADIUS,
                point["objectives"]["peak_inertia_force"] / FORCE,
            ]
            for point in answer["points"]
        ]
    )


def judge(
    answer: Json, found: list[Array], make: Callable[[], LeastPeak], tolerance: float
) -> Outcome:
    """The peer's least accelerations at our points' velocities, beside ours."""
    ours, program = points(answer), make()
    differences = []
    for velocity, acceleration in ours:
        program.bound(program.velocity, velocity)
        theirs = program.least(program.acceleration)[program.acceleration]
        differences.append(theirs / acceleration - 1)
    proved = sum(
        point["verdict"] == "certified optimum" and bool(point["global"])
        for point in answer["points"]
    )
    law, column = program.law, program.velocity
    over = np.array([passed(law, one, one[column]) for one in found]).max(axis=0)
    ends = [(one[column], one[program.acceleration]) for one in (found[0], found[-1])]
    return Outcome(
        f"{len(ours)} points from {said(ours[0])} to {said(ours[-1])}; {proved} certified, global",
        f"{len(found)} points from {said(ends[0])} to {said(ends[1])}",
        max(differences, key=abs),
        tolerance,
        f"C_v by {excess(over[0])}, its C_a by {excess(over[1])}",
    )


def said(point: tuple[float, float]) -> str:
    return f"({point[0]:.4f}, {point[1]:.4f})"


def exact() -> LeastPeak:
    """At degree 2 the knots and the pieces' middles hold every peak."""
    law = FreeLaw(2, KNOTS, held=2)
    return LeastPeak(law, law.knot_places, law.middles)


def on_grid() -> LeastPeak:
    law = FreeLaw(5, KNOTS)
    return LeastPeak(law, law.places(8), law.places(8))


def with_exchange() -> LeastPeak:
    return Exchange(FreeLaw(5, KNOTS), at_first=4, in_each_span=64, within=1e-6)


def row(name: str, degree: int, how: str, make: Callable[[], LeastPeak], tolerance: float) -> Row:
    file = problem(FILE) if degree == 2 else problem(FILE, degree=degree)
    return Row(
        name,
        f"front of the free law, degree {degree}, {KNOTS} knots, {POINTS} points (C_v, C_a)",
        f"HiGHS, simplex from basis to basis, {how}",
        ["pareto", file, "--points", str(POINTS), "--workers", "1"],
        lambda: front(make),
        lambda answer, found: judge(answer, found, make, tolerance),
    )


def rows() -> list[Row]:
    return [
        row("free-front-2", 2, "exact", exact, 1e-6),
        row("free-front-5-grid", 5, "8 places in each span", on_grid, 2e-3),
        row(
            "free-front-5-exchange",
            5,
            "places added at peaks until they pass by 1e-6",
            with_exchange,
            1e-5,
        ),
    ]
