# SPDX-License-Identifier: MIT
"""The least base circle of a disc cam whose rise is free, transcribed at places."""

import casadi
import numpy as np
from scipy import sparse

from cam import Array, Cam, bend, modified_sine, tangent
from ipopt import solved
from program import problem
from row import Json, Outcome, Row, excess, verdict
from splines import FreeLaw

FILE = "cams/free_rise_least_base.toml"
CAM = Cam()
ROLLER, PRELOAD = 8.0, 60.0  # mm, N
STEEPEST, STEEPEST_BACK = np.tan(np.radians(30)), np.tan(np.radians(40))
UNDERCUT = 0.8
LEAST, MOST, START = 10.0, 120.0, 60.0  # base radius, mm
IN_EACH_SPAN = 4
RETURN = 361  # places
LENGTH = 10.0  # mm by unit of the variable, so that it is of the size of the coefficients


def matrix(of: sparse.csr_array) -> casadi.DM:
    columns = sparse.csc_array(of)
    pattern = casadi.Sparsity(*columns.shape, columns.indptr.tolist(), columns.indices.tolist())
    return casadi.DM(pattern, columns.data)


def rise(law: FreeLaw, places: Array, coefficients: casadi.MX) -> list[casadi.MX]:
    """The lift and its derivatives by the cam's angle, mm."""
    found = []
    for order in range(3):
        by_coefficients, constant = law.derivative(order, places)
        value = casadi.mtimes(matrix(by_coefficients), coefficients) + constant
        found.append(CAM.stroke / CAM.rise**order * value)
    return found


def fall(places: int) -> tuple[Array, Array, Array]:
    s, v, a = modified_sine(np.linspace(1, 0, places))
    return CAM.stroke * s, -CAM.stroke / CAM.fall * v, CAM.stroke / CAM.fall**2 * a


def limits(prime: casadi.MX, lift: list[casadi.MX]) -> casadi.MX:
    """All that must not be above 0: pressure angle, undercut, force. The force of the return does
    not depend on the variables, and dwells are as tight as the ends of the rise."""
    s, s1, s2 = lift
    r, r1, r2 = fall(RETURN)
    above, below = bend(prime, s, s1, s2)
    above_r, below_r = bend(prime, r, r1, r2)
    return casadi.vertcat(
        (s1 - STEEPEST * (prime + s)) / LENGTH,
        (ROLLER * above - UNDERCUT * below) / LENGTH**3,
        -CAM.force(s, s2, PRELOAD) / 100,
        (-r1 - STEEPEST_BACK * (prime + r)) / LENGTH,
        (ROLLER * above_r - UNDERCUT * below_r) / LENGTH**3,
    )


def variable_of(base: float) -> float:
    return (base + ROLLER) / LENGTH


def solve(law: FreeLaw) -> Array:
    """The coefficients and the base radius, mm."""
    x = casadi.MX.sym("x", law.count + 1)
    prime = LENGTH * x[-1]
    program = {"x": x, "f": prime, "g": limits(prime, rise(law, law.places(IN_EACH_SPAN), x[:-1]))}
    values = solved(
        program,
        x0=np.r_[law.start, variable_of(START)],
        lbg=-np.inf,
        ubg=0,
        lbx=np.r_[np.full(law.count, -1.0), variable_of(LEAST)],
        ubx=np.r_[np.full(law.count, 2.0), variable_of(MOST)],
    )
    return np.r_[values[:-1], values[-1] * LENGTH - ROLLER]


def violated(law: FreeLaw, found: Array) -> str:
    dense, prime = law.places(100), found[-1] + ROLLER
    s, s1, s2 = (
        CAM.stroke / CAM.rise**order * law.values(found[:-1], order, dense) for order in range(3)
    )
    angle = np.degrees(np.arctan(tangent(prime, s, s1))).max() - 30
    above, below = bend(prime, s, s1, s2)
    undercut = (ROLLER * above / below).max() - UNDERCUT
    lack = -CAM.force(s, s2, PRELOAD).min()
    return (
        f"pressure angle by {excess(angle)} deg, undercut by {excess(undercut)}, "
        f"force by {excess(lack)} N"
    )


def judge(answer: Json, found: Array, law: FreeLaw) -> Outcome:
    ours, theirs = answer["objective"], found[-1]
    return Outcome(
        f"{ours:.4f} mm; {verdict(answer)}, {answer['agreed']} of {answer['starts']} starts agree",
        f"{theirs:.4f} mm, one start",
        theirs / ours - 1,
        1e-3,
        violated(law, found),
    )


def row(knots: int) -> Row:
    law = FreeLaw(3, knots)
    return Row(
        f"free-rise-{knots}",
        f"disc cam with a free rise, {knots} knots: base radius",
        f"CasADi, Ipopt, {IN_EACH_SPAN} places in each span",
        ["optimize", problem(FILE, knots=knots), "--workers", "1"],
        lambda: solve(law),
        lambda answer, found: judge(answer, found, law),
    )


def rows() -> list[Row]:
    return [row(knots) for knots in (32, 64, 128, 400)]
