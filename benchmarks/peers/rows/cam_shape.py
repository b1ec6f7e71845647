# SPDX-License-Identifier: MIT
"""The cam shape of COPS, with the rows over d^2 and d and the start that camlaw has."""

import casadi
import numpy as np

from ipopt import solved
from row import Json, Outcome, Row, excess
from splines import Array


def solve(count: int) -> Array:
    """The radii."""
    step = 2 * np.pi / (5 * (count + 1))
    radii = casadi.MX.sym("r", count)
    every = casadi.vertcat(1, 1, radii, 2, radii[-1])
    before, at, after = every[:-2], every[1:-1], every[2:]
    # 2 before after cos(step) - at (before + after), without the cancellation
    hollow = (
        before * (after - at) - after * (at - before) - 4 * np.sin(step / 2) ** 2 * before * after
    ) / step**2
    slope = (at[1:] - at[:-1]) / step
    program = {
        "x": radii,
        "f": -np.pi / count * casadi.sum1(radii),
        "g": casadi.vertcat(hollow, slope),
    }
    start = 1 + (np.arange(1, count + 1) / (count + 1)) ** 2
    return solved(
        program,
        x0=start,
        lbx=1,
        ubx=2,
        lbg=np.r_[np.full(count + 2, -np.inf), np.full(count + 1, -1.5)],
        ubg=np.r_[np.zeros(count + 2), np.full(count + 1, 1.5)],
    )


def violation(radii: Array) -> float:
    """The largest of the rows as they are published."""
    step = 2 * np.pi / (5 * (len(radii) + 1))
    every = np.r_[1, 1, radii, 2, radii[-1]]
    before, at, after = every[:-2], every[1:-1], every[2:]
    convexity = 2 * before * after * np.cos(step) - at * (before + after)
    slope = np.abs(np.diff(at)) - 1.5 * step
    return max(convexity.max(), slope.max(), (1 - radii).max(), (radii - 2).max(), 0)


def judge(answer: Json, radii: Array) -> Outcome:
    true, ours = answer["true_optimum"], answer["objective"]
    theirs = np.pi / len(radii) * radii.sum()
    return Outcome(
        f"{ours:.10f}, {ours / true - 1:.0e} from the exact optimum; {answer['verdict']}",
        f"{theirs:.10f}",
        theirs / ours - 1,
        1e-5,
        f"published rows by {excess(violation(radii))} (camlaw {answer['max_violation']:.0e})",
    )


def row(count: int) -> Row:
    return Row(
        f"cam-shape-{count}",
        f"cam shape, {count} radii",
        "CasADi, Ipopt",
        ["reproduce", "cam-shape", "--n", str(count)],
        lambda: solve(count),
        judge,
    )


def rows() -> list[Row]:
    return [row(count) for count in (1000, 3200, 10000)]
