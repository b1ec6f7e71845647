# SPDX-License-Identifier: MIT
"""A disc cam with a translating roller, from its equations in docs/theory.md, "Cams".

Lengths are in mm, forces in N, angles in rad; s, s1 and s2 are the lift and its derivatives by the
cam's angle. The functions take arrays of NumPy and expressions of CasADi alike.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Cam:
    """The constants that the shipped files of disc cams share."""

    stroke: float = 30
    speed: float = 200 * 2 * np.pi / 60  # rad/s
    mass: float = 1.2
    spring_rate: float = 6  # N/mm
    rise: float = np.radians(80)
    fall: float = np.radians(100)

    def force(self, s: Any, s2: Any, preload: Any) -> Any:
        """What moves the follower along its path, N."""
        return self.mass * self.speed**2 * s2 / 1000 + self.spring_rate * s + preload


@dataclass(frozen=True)
class Lift:
    """The lift and its derivatives by the cam's angle where it moves, mm; it ends in its dwells."""

    s: Array
    s1: Array
    s2: Array


def lift(cam: Cam, law: Any, up: Array, down: Array) -> Lift:
    """A rise by a law at these places, and a modified-sine return at those."""
    s, v, a = law(up)
    r, w, b = modified_sine(1 - down)
    return Lift(
        cam.stroke * np.r_[s, r],
        cam.stroke * np.r_[v / cam.rise, -w / cam.fall],
        cam.stroke * np.r_[a / cam.rise**2, b / cam.fall**2],
    )


def tangent(prime: Any, s: Any, s1: Any) -> Any:
    """The tangent of the pressure angle on a prime circle of this radius."""
    return s1 / (prime + s)


def bend(prime: Any, s: Any, s1: Any, s2: Any) -> tuple[Any, Any]:
    """The curvature of the pitch curve as a fraction: what is above and what below its line."""
    y = prime + s
    return y**2 + 2 * s1**2 - y * s2, (y**2 + s1**2) ** 1.5


def modified_sine(x: Array) -> tuple[Array, Array, Array]:
    """The law and its first two derivatives."""
    k, edge = 4 + np.pi, 1 / 8
    outer = (x < edge) | (x > 1 - edge)
    angle = np.where(outer, 4 * np.pi * x, np.pi / 3 + 4 * np.pi / 3 * x)
    shift = np.where(x < edge, 0, np.where(x > 1 - edge, 4, 2))
    part = np.where(outer, 1 / 4, 9 / 4)
    return (
        (np.pi * x + shift - part * np.sin(angle)) / k,
        np.pi * (1 - np.where(outer, 1, 3) * np.cos(angle)) / k,
        4 * np.pi**2 * np.sin(angle) / k,
    )


def cycloidal(x: Array) -> tuple[Array, Array, Array]:
    """The law and its first two derivatives."""
    turn = 2 * np.pi * x
    return x - np.sin(turn) / (2 * np.pi), 1 - np.cos(turn), 2 * np.pi * np.sin(turn)
