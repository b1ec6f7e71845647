# SPDX-License-Identifier: MIT
"""Free laws as camlaw states them: splines from rest to rest on evenly spaced knots."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.interpolate import BSpline

Array = NDArray[np.float64]


@dataclass(frozen=True)
class FreeLaw:
    """Splines of `degree` with `knots` evenly spaced knots inside (0, 1), from 0 to 1.

    The first `held` coefficients are 0 and as many at the end are 1: with two, displacement and
    velocity fit the rests, with three acceleration too. Those between them are the variables.
    """

    degree: int
    knots: int
    held: int = 3

    @cached_property
    def all_knots(self) -> Array:
        inner = np.linspace(0, 1, self.knots + 2)
        return np.concatenate([np.zeros(self.degree), inner, np.ones(self.degree)])

    @property
    def count(self) -> int:
        return self.knots + self.degree + 1 - 2 * self.held

    @property
    def start(self) -> Array:
        """The variables of a law near the 3-4-5, whose values at the knots' means they are."""
        steps = np.lib.stride_tricks.sliding_window_view(self.all_knots[1:-1], self.degree)
        x = steps.mean(axis=1)[self.held : -self.held]
        return x**3 * (10 - 15 * x + 6 * x**2)

    @cached_property
    def knot_places(self) -> Array:
        return np.linspace(0, 1, self.knots + 2)

    @cached_property
    def middles(self) -> Array:
        """The middle of each span."""
        return (self.knot_places[1:] + self.knot_places[:-1]) / 2

    def places(self, in_each_span: int) -> Array:
        """Evenly spaced places, the knots among them."""
        return np.linspace(0, 1, (self.knots + 1) * in_each_span + 1)

    def derivative(self, order: int, places: Array) -> tuple[sparse.csr_array, Array]:
        """The matrix M and the vector m for which M c + m is that derivative at the places."""
        knots, matrix = self.all_knots, None
        for degree in range(self.degree, self.degree - order, -1):
            width = degree / (knots[degree + 1 : -1] - knots[1 : -degree - 1])
            difference = sparse.diags_array(
                [-width, width], offsets=[0, 1], shape=(len(width), len(width) + 1)
            )
            matrix = difference if matrix is None else difference @ matrix
            knots = knots[1:-1]
        basis = sparse.csr_array(BSpline.design_matrix(places, knots, self.degree - order))
        whole = sparse.csc_array(basis if matrix is None else basis @ matrix)
        return (
            sparse.csr_array(whole[:, self.held : -self.held]),
            np.asarray(whole[:, -self.held :].sum(axis=1)).ravel(),
        )

    def values(self, variables: Array, order: int, places: Array) -> Array:
        matrix, constant = self.derivative(order, places)
        return matrix @ variables + constant
