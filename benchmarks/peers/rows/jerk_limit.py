# SPDX-License-Identifier: MIT
"""The least acceleration at limits on velocity and jerk, which of all laws is 5.7217."""

from collections.abc import Callable

import clarabel
import numpy as np
from scipy import sparse

from least_peak import LeastPeak, passed
from program import problem
from row import Json, Outcome, Row, excess, verdict
from splines import Array, FreeLaw

FILE = "free_law/least_acceleration_at_jerk.toml"
VELOCITY, JERK = 1.6, 60.0
IN_EACH_SPAN = 2  # places of velocity, between which it is a parabola


def by_highs(law: FreeLaw) -> Array:
    program = LeastPeak(law, law.places(IN_EACH_SPAN), law.knot_places, JERK)
    program.bound(program.velocity, VELOCITY)
    return program.least(program.acceleration)


def by_clarabel(law: FreeLaw) -> Array:
    v, v0 = law.derivative(1, law.places(IN_EACH_SPAN))
    a, a0 = law.derivative(2, law.knot_places)
    j, j0 = law.derivative(3, law.middles)
    ones = np.ones((len(a0), 1))
    rows = [[v, None], [a, -ones], [-a, -ones], [j, None], [-j, None]]
    limits = np.concatenate([VELOCITY - v0, -a0, a0, JERK - j0, JERK + j0])
    settings = clarabel.DefaultSettings()
    settings.verbose, settings.max_threads = False, 1
    count = law.count + 1
    solution = clarabel.DefaultSolver(
        sparse.csc_matrix((count, count)),
        np.r_[np.zeros(law.count), 1.0],
        sparse.csc_matrix(sparse.block_array(rows)),
        limits,
        [clarabel.NonnegativeConeT(len(limits))],
        settings,
    ).solve()
    if solution.status != clarabel.SolverStatus.Solved:
        raise RuntimeError(f"Clarabel: {solution.status}")
    x = np.array(solution.x)
    return np.r_[x[:-1], VELOCITY, x[-1]]


def judge(answer: Json, found: Array, law: FreeLaw) -> Outcome:
    ours, theirs = answer["objective"], found[-1]
    over = passed(law, found, VELOCITY)
    return Outcome(
        f"C_a = {ours:.6f}; {verdict(answer)}",
        f"C_a = {theirs:.6f}",
        theirs / ours - 1,
        1e-4,
        f"C_v by {excess(over[0])}, its C_a by {excess(over[1])}",
    )


def row(knots: int, name: str, peer: str, solve: Callable[[FreeLaw], Array]) -> Row:
    law = FreeLaw(3, knots)
    return Row(
        f"jerk-limit-{knots}-{name}",
        f"least acceleration at a jerk of {JERK:.0f}, {knots} knots",
        peer,
        ["optimize", problem(FILE, knots=knots), "--workers", "1"],
        lambda: solve(law),
        lambda answer, found: judge(answer, found, law),
    )


def rows() -> list[Row]:
    return [
        row(knots, name, peer, solve)
        for knots in (100, 1000)
        for name, peer, solve in (
            ("highs", "HiGHS, simplex", by_highs),
            ("clarabel", "Clarabel", by_clarabel),
        )
    ]
