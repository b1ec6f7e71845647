# SPDX-License-Identifier: MIT
"""The least peaks of a free law, as a linear program of HiGHS with limits at places.

The columns are the law's coefficients, then the peaks of velocity and of acceleration, which may be
bounded or minimised.
"""

import highspy
import numpy as np
from scipy import sparse

from splines import Array, FreeLaw

LOWEST, HIGHEST = -1.0, 2.0  # coefficients, as camlaw bounds them unless told otherwise
MOST_ROUNDS = 50


class LeastPeak:
    """A program that keeps its basis from one solution to the next."""

    def __init__(
        self,
        law: FreeLaw,
        of_velocity: Array,
        of_acceleration: Array,
        jerk: float | None = None,
    ) -> None:
        self.law = law
        self.velocity, self.acceleration = law.count, law.count + 1  # their columns
        self.highs = highspy.Highs()
        self.highs.setOptionValue("output_flag", False)
        self.highs.setOptionValue("threads", 1)
        self.highs.setOptionValue("solver", "simplex")
        self.highs.passModel(self._model(*self._rows(of_velocity, of_acceleration, jerk)))

    def _rows(
        self, of_velocity: Array, of_acceleration: Array, jerk: float | None
    ) -> tuple[sparse.csr_array, Array, Array]:
        """The matrix, and the bounds of its rows: v <= C_v, -C_a <= a <= C_a, |j| <= jerk."""
        v, v0 = self.law.derivative(1, of_velocity)
        a, a0 = self.law.derivative(2, of_acceleration)
        ones_v, ones_a = np.ones((len(v0), 1)), np.ones((len(a0), 1))
        blocks = [[v, -ones_v, None], [a, None, -ones_a], [a, None, ones_a]]
        lower = [np.full(len(v0) + len(a0), -np.inf), -a0]
        upper = [-v0, -a0, np.full(len(a0), np.inf)]
        if jerk is not None:
            j, j0 = self.law.derivative(3, self.law.middles)
            blocks.append([j, None, None])
            lower.append(-jerk - j0)
            upper.append(jerk - j0)
        return (
            sparse.csr_array(sparse.block_array(blocks)),
            np.concatenate(lower),
            np.concatenate(upper),
        )

    def _model(self, matrix: sparse.csr_array, lower: Array, upper: Array) -> highspy.HighsLp:
        model, count = highspy.HighsLp(), self.law.count
        model.num_row_, model.num_col_ = matrix.shape
        model.col_cost_ = np.zeros(count + 2)
        model.col_lower_ = np.r_[np.full(count, LOWEST), 0, 0]
        model.col_upper_ = np.r_[np.full(count, HIGHEST), np.inf, np.inf]
        model.row_lower_, model.row_upper_ = lower, upper
        model.a_matrix_.format_ = highspy.MatrixFormat.kRowwise
        model.a_matrix_.start_ = matrix.indptr
        model.a_matrix_.index_ = matrix.indices
        model.a_matrix_.value_ = matrix.data
        return model

    def bound(self, column: int, upper: float) -> None:
        self.highs.changeColBounds(column, 0, upper)

    def least(self, column: int) -> Array:
        """The coefficients and both peaks where that column is least."""
        for one in (self.velocity, self.acceleration):
            self.highs.changeColCost(one, float(one == column))
        self.highs.run()
        status = self.highs.getModelStatus()
        if status != highspy.HighsModelStatus.kOptimal:
            raise SystemExit(f"HiGHS: {status}")
        return np.array(self.highs.getSolution().col_value)


class Exchange(LeastPeak):
    """The same with more places where the last solution passed its peaks by more than `within`."""

    def __init__(self, law: FreeLaw, at_first: int, in_each_span: int, within: float) -> None:
        super().__init__(law, law.places(at_first), law.places(at_first))
        self.within = within
        self.dense = law.places(in_each_span)
        self.curves = {order: law.derivative(order, self.dense) for order in (1, 2)}
        self.highs.setOptionValue("primal_feasibility_tolerance", within / 1000)

    def least(self, column: int) -> Array:
        for _ in range(MOST_ROUNDS):
            solution = super().least(column)
            added = [self._add(order, sign, solution) for order, sign in ((1, 1), (2, 1), (2, -1))]
            if not any(added):
                return solution
        raise SystemExit("HiGHS: peaks still pass their limits after all rounds")

    def _add(self, order: int, sign: int, solution: Array) -> bool:
        """Adds rows where that derivative passes the solution's peak; whether there are any."""
        column = self.velocity if order == 1 else self.acceleration
        matrix, constant = self.curves[order]
        places = self._peaks(
            sign * (matrix @ solution[: self.law.count] + constant) - solution[column]
        )
        if not len(places):
            return False
        matrix, constant = self.law.derivative(order, places)
        peak = np.zeros((len(places), 2))
        peak[:, column - self.law.count] = -1
        rows = sparse.csr_array(sparse.hstack([sign * matrix, sparse.csr_array(peak)]))
        none, upper = np.full(len(places), -np.inf), -sign * constant
        self.highs.addRows(
            len(places), none, upper, rows.nnz, rows.indptr[:-1], rows.indices, rows.data
        )
        return True

    def _peaks(self, over: Array) -> Array:
        """The vertices of parabolas through each peak beyond and its two neighbours."""
        left, at, right = over[:-2], over[1:-1], over[2:]
        peak = np.flatnonzero((at > self.within) & (at >= left) & (at > right))
        bend = left[peak] - 2 * at[peak] + right[peak]
        shift = np.where(bend < 0, (left[peak] - right[peak]) / (2 * np.minimum(bend, -1e-300)), 0)
        return self.dense[peak + 1] + shift * (self.dense[1] - self.dense[0])


def passed(law: FreeLaw, solution: Array, velocity: float) -> tuple[float, float]:
    """How far the peaks pass the limit on velocity, and the acceleration that the peer claims."""
    dense = law.places(100)
    v = law.values(solution[: law.count], 1, dense).max()
    a = np.abs(law.values(solution[: law.count], 2, dense)).max()
    return v - velocity, a - solution[law.count + 1]
