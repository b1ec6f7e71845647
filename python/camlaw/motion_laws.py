# SPDX-License-Identifier: MIT
"""Motion laws: displacement, velocity, acceleration and jerk of one normalised motion."""

from __future__ import annotations

import re
from collections import namedtuple
from html import escape
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from . import plots, tables, units
from .arguments import flag, numbers, text, whole, word
from .arguments import path as checked_path
from .errors import Error, InputError
from .native import native
from .outputs import rendered, written

Place = namedtuple("Place", ["value", "at"])


#: Points of a table, as many as the program tabulates.
_MOST_SAMPLES = 1_000_000


class _Arrays(NamedTuple):
    s: np.ndarray
    v: np.ndarray
    a: np.ndarray
    j: np.ndarray


class Motion:
    """Displacement s, velocity v, acceleration a and jerk j at some x, each an array.

    It can be unpacked: s, v, a, j = law(x).
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

    Each is a pair (highest, lowest). With peaks(proved=False) each of the two is (value, at), the value
    and the x where it is first reached. With peaks(proved=True) it is (low, high), two numbers between
    which the exact value is proved to lie. If the acceleration jumps, both peaks of jerk are infinite.
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
        """The family and its coefficients, as law() and problem files read them."""
        return self._native.name

    @property
    def family(self) -> str:
        return self._native.family

    @property
    def formula(self) -> str:
        return self._native.formula

    @property
    def ends(self) -> str:
        """The states that it connects, after VDI 2143: "R-R" leads from rest to rest."""
        return self._native.ends

    @property
    def coefficients(self) -> dict[str, float | list[float]]:
        """The family's coefficients with their values."""
        return self._native.parameters()

    def __call__(self, x: Any) -> Motion:
        """s, v, a and j at x: a number, an array of one dimension, or a list of numbers.

        Where they jump, they are the limits from the right; outside 0 .. 1 they are NaN. An array of
        float64 in one piece is not copied.
        """
        if type(x) is np.ndarray:
            try:
                return Motion(self._at(x))
            except TypeError:
                pass  # of other numbers, or not in one piece
        return Motion(self._at(numbers(x, "x")))

    def into(
        self, x: np.ndarray, s: np.ndarray, v: np.ndarray, a: np.ndarray, j: np.ndarray
    ) -> None:
        """Writes s, v, a and j into arrays of yours: of float64, in one piece and as long as x."""
        try:
            self._native.at_into(x, [s, v, a, j])
        except TypeError:
            raise InputError(
                "into: x, s, v, a and j must be numpy arrays of float64 of one dimension that lie in "
                "one piece and, but for x, can be written to"
            ) from None

    def peaks(self, proved: bool = False) -> Peaks:
        """Highest and lowest velocity, acceleration, jerk and dynamic moment; see Peaks."""
        if flag(proved, "proved"):
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
        """lambda: 1 if no law with the same peaks is faster; None unless the law goes from rest to
        rest."""
        return self._native.limit_index()

    def facts(self) -> dict[str, Any]:
        """Everything that 'camlaw law NAME --json' prints."""
        return self._native.facts()

    def samples(self, count: int = 361) -> Any:
        """A table of x, s, v, a, j at evenly spaced points."""
        last = whole(count, "count", 2, _MOST_SAMPLES) - 1
        x = np.arange(last + 1) / last  # as 'camlaw law --samples' has them
        motion = self(x)
        return tables.of_columns(
            {"x": x, "s": motion.s, "v": motion.v, "a": motion.a, "j": motion.j}
        )

    def plot(self) -> Any:
        """Draws s, v, a and j one above the other with matplotlib; returns the axes."""
        return plots.draw(self._native.figure(400))

    def svg(self, path: str | Path | None = None) -> str:
        """The same as a picture in SVG, as 'camlaw law --svg' draws it; written to `path` if given."""
        return rendered(self._native.svg(), path, self._native.file)

    def save(self, path: str | Path, title: str = "") -> None:
        """Writes the law to a file, which law_file(path) and problem files read."""
        written(self._native.file_text(word(title, "title") or self._native.label), checked_path(path))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Law):
            return NotImplemented
        return self is other or self._pieces() == other._pieces()

    def _pieces(self) -> str:
        """The function itself, whatever it is called."""
        return self._native.file_text("law")

    def __reduce__(self) -> Any:
        return Law, (self._native,)

    def __hash__(self) -> int:
        return hash(self._pieces())

    def __repr__(self) -> str:
        if self._native.is_of_catalogue:
            return f"camlaw.law({self.name!r})"
        return f"<camlaw law: {self.name}>"

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

    `name` may contain coefficients, "modified-sine crossover=0.42", and may be the path of a law's
    file. A coefficient is a number, a text with a unit, a quantity of pint, or a list of these if the
    law has a list of them. Raises InputError for an unknown name, with similar names, and for values
    that make no law.
    """
    if isinstance(name, Law) and not coefficients:
        return Law(name._native)
    known = name_of(name, "law") if isinstance(name, Law) else word(name, "law")
    stated = "" if isinstance(name, Law) else known
    for twice in coefficients:
        if re.search(rf"(?:^|\s){re.escape(twice)}\s*=", stated):
            raise InputError(f"law: {twice} is given twice, in '{known}' and as an argument")
    return Law(native.law(known, units.settings_of(coefficients)))


def name_of(law: Law, what: str) -> str:
    """The name by which the library finds this very law. Raises InputError for a law of a file and for
    a motion program, which have none: what they are named may be another law's name in the catalogue."""
    try:
        if Law(native.law(law.name, [])) == law:
            return law.name
    except Error:
        pass
    raise InputError(
        f"{what}: '{law.name}' is the law of a file or a motion program, which has no name here; a law of "
        "the catalogue, or the path of a law's file, is accepted"
    )


def law_file(path: str | Path) -> Law:
    """Reads the law of a file."""
    return Law(native.law(str(Path(checked_path(path)).absolute()), []))


def laws() -> list[str]:
    """The names of all laws: the catalogue's, and those of the folder that CAMLAW_LAWS names."""
    return native.law_names()


def law_table() -> Any:
    """The constants of all laws with the default values of their parameters, as 'camlaw laws' lists
    them: one row for each name. continuity is infinite where the motion is smooth; lambda is not a
    number unless the law goes from rest to rest."""
    columns = (
        "name",
        "ends",
        "continuity",
        "C_v",
        "C_a_max",
        "C_a_min",
        "C_j_max",
        "C_j_min",
        "C_Mdyn",
        "lambda",
    )
    facts = [law(name).facts() for name in laws()]
    rows = [
        {column: "inf" if fact[column] == "smooth" else fact[column] for column in columns}
        for fact in facts
    ]
    return tables.of_rows(rows, index="name")
