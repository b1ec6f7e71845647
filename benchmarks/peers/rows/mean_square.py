# SPDX-License-Identifier: MIT
"""The least mean square of acceleration or jerk of a free law: a quadratic program."""

from collections.abc import Callable
from dataclasses import dataclass

import clarabel
import numpy as np
import piqp
from scipy import sparse

from program import problem
from row import Json, Outcome, Row, verdict
from splines import Array, FreeLaw

KNOTS, DEGREE = 20, 5
GAUSS = 4  # places in each span, by which the square of a cubic is integrated exactly


@dataclass(frozen=True)
class Quadratic:
    """x P x / 2 + q x + constant."""

    p: sparse.csc_matrix
    q: Array
    constant: float

    def __call__(self, x: Array) -> float:
        return float(x @ (self.p @ x) / 2 + self.q @ x + self.constant)


def mean_square(law: FreeLaw, order: int) -> Quadratic:
    places, weights = np.polynomial.legendre.leggauss(GAUSS)
    half = 1 / (law.knots + 1) / 2
    x = (law.middles[:, None] + half * places).ravel()
    every = np.tile(half * weights, law.knots + 1)
    m, m0 = law.derivative(order, x)
    p = sparse.csc_matrix(2 * m.T @ sparse.diags_array(every) @ m)
    p.sort_indices()  # as PIQP takes for granted
    return Quadratic(p, 2 * m.T @ (every * m0), float(every @ m0**2))


def by_clarabel(law: FreeLaw, order: int) -> float:
    of = mean_square(law, order)
    settings = clarabel.DefaultSettings()
    settings.verbose, settings.max_threads = False, 1
    none = sparse.csc_matrix((0, law.count))
    solver = clarabel.DefaultSolver(
        sparse.csc_matrix(sparse.triu(of.p)), of.q, none, np.zeros(0), [], settings
    )
    solution = solver.solve()
    if solution.status != clarabel.SolverStatus.Solved:
        raise RuntimeError(f"Clarabel: {solution.status}")
    return of(np.array(solution.x))


def by_piqp(law: FreeLaw, order: int) -> float:
    of = mean_square(law, order)
    solver = piqp.SparseSolver()
    solver.setup(of.p, of.q)
    if solver.solve() != piqp.PIQP_SOLVED:
        raise SystemExit("PIQP found no optimum")
    return of(solver.result.x)


def judge(answer: Json, theirs: float) -> Outcome:
    ours = answer["objective"]
    return Outcome(
        f"{ours:.9g}; {verdict(answer)}",
        f"{theirs:.9g}",
        theirs / ours - 1,
        1e-8,
        "nothing: there are no limits",
    )


def row(what: str, order: int, held: int, peer: str, solve: Callable[[FreeLaw, int], float]) -> Row:
    law = FreeLaw(DEGREE, KNOTS, held)
    return Row(
        f"mean-square-{what}-{peer.lower()}",
        f"least mean-square {what}, {KNOTS} knots",
        peer,
        ["optimize", problem(f"free_law/least_mean_square_{what}.toml"), "--workers", "1"],
        lambda: solve(law, order),
        judge,
    )


def rows() -> list[Row]:
    return [
        row(what, order, held, peer, solve)
        for what, order, held in (("acceleration", 2, 2), ("jerk", 3, 3))
        for peer, solve in (("Clarabel", by_clarabel), ("PIQP", by_piqp))
    ]
