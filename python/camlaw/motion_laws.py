# SPDX-License-Identifier: MIT
"""Motion laws: displacement, velocity, acceleration and jerk of one normalised stretch."""

from __future__ import annotations

from collections import namedtuple
from html import escape
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from . import plots, tables, units
from .errors import InputError
from .native import native
from .outputs import written

Place = namedtuple("Place", ["value", "at"])


class _Arrays(NamedTuple):
    s: np.ndarray
    v: np.ndarray
    a: np.ndarray
    j: np.ndarray


class Motion:
    """s, v, a and j at some places: displacement, velocity, acceleration and jerk, each an array.

    It unpacks: s, v, a, j = law(x).
    """

    __slots__ = ("_arrays",)

    def __init__(self, arrays: Any) -> None:
        self._arrays = arrays

    @property
    def s(self) -> np.ndarray:
        """Displacement, from 0 to 1."""
        return self._arrays.s

    @property
    def v(self) -> np.ndarray:
        """Velocity, ds/dx."""
        return self._arrays.v

    @property
    def a(self) -> np.ndarray:
        """Acceleration, d2s/dx2."""
        return self._arrays.a

    @property
    def j(self) -> np.ndarray:
        """Jerk, d3s/dx3."""
        return self._arrays.j

    def __iter__(self) -> Any:
        arrays = self._arrays
        return iter((arrays.s, arrays.v, arrays.a, arrays.j))

    def __len__(self) -> int:
        return 4

    def __reduce__(self) -> Any:
        return Motion, (_Arrays(*self),)

    def __repr__(self) -> str:
        return f"Motion(s={self.s!r}, v={self.v!r}, a={self.a!r}, j={self.j!r})"


class Peaks(NamedTuple):
    """Highest and lowest velocity, acceleration, jerk and dynamic moment of a law.

    Each is a pair (highest, lowest). Of peaks(proved=False) one of these is (value, at), the value
    with the place where it is first reached; of peaks(proved=True) it is (low, high), numbers that
    the exact value is proved to lie between. A jump of acceleration makes both peaks of jerk
    infinite.
    """

    v: Any
    a: Any
    j: Any
    moment: Any


class Law:
    """A motion law: s(x) for x from 0 to 1, with exact derivatives and peaks. Made by law()."""

    __slots__ = ("_native", "_at", "_peaks")

    def __init__(self, native_law: Any) -> None:
        self._native = native_law
        self._at = native_law.at
        self._peaks: Peaks | None = None

    @property
    def name(self) -> str:
        """Family and coefficients, as law() and problem files read them."""
        return self._native.name

    @property
    def family(self) -> str:
        return self._native.family

    @property
    def formula(self) -> str:
        return self._native.formula

    @property
    def ends(self) -> str:
        """What joins it at both ends, after VDI 2143: "R-R" from rest to rest."""
        return self._native.ends

    @property
    def coefficients(self) -> dict[str, float | list[float]]:
        """The family's coefficients with their values."""
        return self._native.parameters()

    def __call__(self, x: Any) -> Motion:
        """s, v, a, j at x: an array of one dimension, or what makes one.

        At a break they are the limits from the right; outside 0 .. 1 they are NaN. An array of
        float64 in one piece is read in place.
        """
        try:
            return Motion(self._at(x))
        except TypeError:
            array = np.ascontiguousarray(np.atleast_1d(x), dtype=np.float64)
            if array.ndim != 1:
                raise InputError(
                    f"x has {array.ndim} dimensions; an array of one is wanted"
                ) from None
            return Motion(self._at(array))

    def into(
        self, x: np.ndarray, s: np.ndarray, v: np.ndarray, a: np.ndarray, j: np.ndarray
    ) -> None:
        """The same into arrays of float64 that are there already."""
        self._native.at_into(x, [s, v, a, j])

    def peaks(self, proved: bool = False) -> Peaks:
        """Highest and lowest velocity, acceleration, jerk and dynamic moment; see Peaks."""
        if proved:
            return Peaks(**self._native.enclosures())
        if self._peaks is None:
            found = self._native.peaks()
            self._peaks = Peaks(
                **{name: (Place(*high), Place(*low)) for name, (high, low) in found.items()}
            )
        return self._peaks

    def _largest(self, quantity: str) -> float:
        high, low = getattr(self.peaks(), quantity)
        return max(high.value, -low.value)

    @property
    def C_v(self) -> float:
        """Peak velocity, max |s'|."""
        return self._largest("v")

    @property
    def C_a(self) -> float:
        """Peak acceleration, max |s''|."""
        return self._largest("a")

    @property
    def C_j(self) -> float:
        """Peak jerk, max |s'''|."""
        return self._largest("j")

    @property
    def C_Mdyn(self) -> float:
        """Peak dynamic moment, max |s' s''|."""
        return self._largest("moment")

    @property
    def limit_index(self) -> float | None:
        """lambda: 1 of a law than which none is faster with its peaks; None unless it goes from
        rest to rest."""
        return self._native.limit_index()

    def facts(self) -> dict[str, Any]:
        """All that 'camlaw law NAME --json' says of it."""
        return self._native.facts()

    def samples(self, count: int = 361) -> Any:
        """A table of x, s, v, a, j at even points."""
        x = np.linspace(0, 1, count)
        motion = self(x)
        return tables.of_columns(
            {"x": x, "s": motion.s, "v": motion.v, "a": motion.a, "j": motion.j}
        )

    def plot(self) -> Any:
        """s, v, a, j one above the other, drawn by matplotlib; returns the axes."""
        return plots.draw(self._native.figure(400))

    def save(self, path: str | Path, title: str = "") -> None:
        """Writes the law's own file, which law(path) and problem files read."""
        written(self._native.file_text(title or self._native.label), path)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Law) and self.name == other.name

    def __reduce__(self) -> Any:
        return Law, (self._native,)

    def __hash__(self) -> int:
        return hash(self.name)

    def __repr__(self) -> str:
        return f"camlaw.law({self.name!r})"

    def _repr_html_(self) -> str:
        index = self.limit_index
        rows = [("C_v", self.C_v), ("C_a", self.C_a), ("C_j", self.C_j), ("C_Mdyn", self.C_Mdyn)]
        if index is not None:
            rows.append(("lambda", index))
        cells = "".join(f"<td><b>{name}</b> {value:.6g}</td>" for name, value in rows)
        return (
            f"<p><b>{escape(self._native.label)}</b>, {escape(self.ends)}: "
            f"{escape(self.formula)}</p><table><tr>{cells}</tr></table>{self._native.svg()}"
        )


def law(name: str | Law, /, **coefficients: Any) -> Law:
    """A law by its name: English, German or Ukrainian, with or without coefficients.

    `name` may hold coefficients, "modified-sine crossover=0.42", and may be the path of a law's
    file. A coefficient is a number, a text with a unit or a quantity of pint; a list for those that
    are lists. Raises InputError for unknown names, which lists near ones, and for values that make
    no law.
    """
    text = name.name if isinstance(name, Law) else name
    return Law(native.law(text, units.settings_of(coefficients)))


def law_file(path: str | Path) -> Law:
    """The law of a file."""
    return Law(native.law(str(Path(path).absolute()), []))


def laws() -> list[str]:
    """The names of all laws: the catalogue's, and those of the folder that CAMLAW_LAWS names."""
    return native.law_names()
