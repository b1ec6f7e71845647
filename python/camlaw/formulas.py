# SPDX-License-Identifier: MIT
"""Formulas that Python writes: expressions, and the functions that accept them.

A function of a machine's names is called once, with an object that stands for the machine, and its
formula is recorded in the grammar of docs/formulas.md, as the library records its own. No Python runs
during a search, and derivatives, enclosures and verdicts are those of any other response.

All quantities are in SI units, and angles in radians.
"""

from __future__ import annotations

from collections.abc import Callable
from contextvars import ContextVar
from math import isfinite
from typing import Any

from .arguments import is_pint, optional_text, shown
from .errors import InputError
from .units import of_pint

_SUM, _TERM, _SIGN, _POWER, _PRIMARY = range(1, 6)

#: Characters of a formula that the library reads (docs/formulas.md).
_LONGEST = 4096


class Expression:
    """A number in a formula that is being recorded. It has no value.

    It accepts +, -, *, /, **, the functions of this module, and numpy's functions of the same names.
    """

    __slots__ = ("text", "_rank")

    def __init__(self, text: str, rank: int = _PRIMARY) -> None:
        if len(text) > _LONGEST:
            raise InputError(
                f"a formula of more than {_LONGEST} characters cannot be recorded; each use of an "
                "intermediate result writes it out again, so make it a response of its own"
            )
        self.text = text
        self._rank = rank

    def _within(self, rank: int) -> str:
        return self.text if self._rank >= rank else f"({self.text})"

    def __add__(self, other: Any) -> Expression:
        return _pair(self, "+", other, _SUM)

    def __radd__(self, other: Any) -> Expression:
        return _pair(other, "+", self, _SUM)

    def __sub__(self, other: Any) -> Expression:
        return _pair(self, "-", other, _SUM)

    def __rsub__(self, other: Any) -> Expression:
        return _pair(other, "-", self, _SUM)

    def __mul__(self, other: Any) -> Expression:
        return _pair(self, "*", other, _TERM)

    def __rmul__(self, other: Any) -> Expression:
        return _pair(other, "*", self, _TERM)

    def __truediv__(self, other: Any) -> Expression:
        return _pair(self, "/", other, _TERM)

    def __rtruediv__(self, other: Any) -> Expression:
        return _pair(other, "/", self, _TERM)

    def __pow__(self, other: Any) -> Expression:
        return Expression(f"{self._within(_PRIMARY)}^{expression(other)._within(_PRIMARY)}", _POWER)

    def __rpow__(self, other: Any) -> Expression:
        return expression(other) ** self

    def __neg__(self) -> Expression:
        return Expression(f"-{self._within(_POWER)}", _SIGN)

    def __pos__(self) -> Expression:
        return self

    def __abs__(self) -> Expression:
        return absolute(self)

    def __bool__(self) -> bool:
        raise InputError(
            "an expression has no value to compare or to decide by, as its formula is written down only "
            "once; write select(f, y, z), which is y where f is 0 or above and z elsewhere"
        )

    def __float__(self) -> float:
        raise InputError(
            "an expression has no value; take sin, sqrt and the like from camlaw.formulas or numpy"
        )

    def _refuse(self, other: Any) -> bool:
        return self.__bool__()

    __lt__ = __le__ = __gt__ = __ge__ = __eq__ = __ne__ = _refuse
    __hash__ = object.__hash__
    __array_priority__ = 1000

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **kwargs: Any) -> Any:
        does = _UFUNCS.get(ufunc.__name__)
        if method != "__call__" or kwargs or does is None:
            return NotImplemented
        return does(*inputs)

    def __repr__(self) -> str:
        return f"<{self.text}>"


def expression(value: Any) -> Expression:
    """A number, or a quantity of pint, as a part of a formula."""
    if isinstance(value, Expression):
        return value
    if is_pint(value):
        return quantity(value)
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        if not isfinite(value):
            raise InputError(f"{value} cannot be part of a formula; a finite number is accepted")
        return _signed(repr(value))
    raise InputError(
        f"{shown(value)} cannot be part of a formula; numbers, expressions and quantity('9.81 m/s^2') can"
    )


def _signed(text: str) -> Expression:
    return Expression(text, _SIGN if text.startswith("-") else _PRIMARY)


def quantity(value: Any, unit: str | None = None) -> Expression:
    """A number with a unit: quantity(9.81, "m/s^2"), quantity("30 mm")."""
    if isinstance(value, str):
        number, _, rest = value.strip().partition(" ")
        unit = rest if unit is None else unit
        try:
            value = float(number)
        except ValueError:
            raise InputError(f"'{number}' is not a number; write quantity('9.81 m/s^2')") from None
    if is_pint(value):
        if unit is not None:
            raise InputError(f"quantity: {shown(value)} has a unit already; leave out '{unit}'")
        value, unit = of_pint(value)
        unit = None if unit == "1" else unit
    if hasattr(value, "tolist"):
        value = value.tolist()
    if not isinstance(value, (int, float)) or isinstance(value, bool) or not isfinite(value):
        raise InputError(f"quantity: {shown(value)} is not a finite number")
    unit = optional_text(unit, "unit")
    return _signed(f"{value!r} [{unit}]" if unit else repr(value))


def _pair(a: Any, sign: str, b: Any, rank: int) -> Expression:
    left, right = expression(a), expression(b)
    return Expression(f"{left._within(rank)} {sign} {right._within(rank + 1)}", rank)


def _call(name: str, *parts: Any) -> Expression:
    return Expression(f"{name}({', '.join(expression(part).text for part in parts)})")


def sqrt(x: Any) -> Expression:
    return _call("sqrt", x)


def absolute(x: Any) -> Expression:
    return _call("abs", x)


def sign(x: Any) -> Expression:
    return _call("sign", x)


def exp(x: Any) -> Expression:
    return _call("exp", x)


def log(x: Any) -> Expression:
    return _call("log", x)


def log10(x: Any) -> Expression:
    return _call("log10", x)


def sin(x: Any) -> Expression:
    return _call("sin", x)


def cos(x: Any) -> Expression:
    return _call("cos", x)


def tan(x: Any) -> Expression:
    return _call("tan", x)


def asin(x: Any) -> Expression:
    return _call("asin", x)


def acos(x: Any) -> Expression:
    return _call("acos", x)


def atan(x: Any) -> Expression:
    return _call("atan", x)


def atan2(y: Any, x: Any) -> Expression:
    return _call("atan2", y, x)


def minimum(x: Any, y: Any) -> Expression:
    return _call("min", x, y)


def maximum(x: Any, y: Any) -> Expression:
    return _call("max", x, y)


def select(f: Any, y: Any, z: Any) -> Expression:
    """y where f is 0 or above, else z."""
    return _call("select", f, y, z)


def where_positive(f: Any, y: Any) -> Expression:
    """y where f is above 0, and undefined elsewhere."""
    return _call("where_positive", f, y)


def along(f: Any, y: Any) -> Expression:
    """|y| with the sign of f."""
    return _call("along", f, y)


def unless_zero(f: Any, y: Any) -> Expression:
    """y, but 0 where f is 0."""
    return _call("unless_zero", f, y)


_roots: ContextVar[int] = ContextVar("roots that are being recorded within one another", default=0)


def root(
    low: Any,
    high: Any,
    f: Callable[[Expression], Any],
    level: Callable[[Expression], Any] | None = None,
) -> Expression:
    """The first y between low and high at which f(y) is 0; if `level` is given, the one of several at
    which level(y) is highest."""
    depth = _roots.get() + 1
    outside = _roots.set(depth)
    y = Expression(f"root_{depth}")
    try:
        parts = [y, low, high, f(y)] + ([level(y)] if level else [])
    finally:
        _roots.reset(outside)
    return _call("root", *parts)


#: 3.14159...
pi = Expression("pi")

_UFUNCS: dict[str, Callable[..., Expression]] = {
    "sqrt": sqrt,
    "absolute": absolute,
    "fabs": absolute,
    "sign": sign,
    "exp": exp,
    "log": log,
    "log10": log10,
    "sin": sin,
    "cos": cos,
    "tan": tan,
    "arcsin": asin,
    "arccos": acos,
    "arctan": atan,
    "arctan2": atan2,
    "minimum": minimum,
    "maximum": maximum,
    "add": lambda a, b: _pair(a, "+", b, _SUM),
    "subtract": lambda a, b: _pair(a, "-", b, _SUM),
    "multiply": lambda a, b: _pair(a, "*", b, _TERM),
    "divide": lambda a, b: _pair(a, "/", b, _TERM),
    "power": lambda a, b: expression(a) ** b,
    "negative": lambda a: -expression(a),
    "square": lambda a: expression(a) ** 2,
}


class Names:
    """What a formula may name, as attributes: parameters, responses, and s, v, a, j, x and angle of the
    motion. peak, highest and lowest accept a curve or its name."""

    pi = pi

    def __getattr__(self, name: str) -> Expression:
        if name.startswith("_"):
            raise AttributeError(name)
        return Expression(name)

    def __getitem__(self, name: str) -> Expression:
        return Expression(name)

    @staticmethod
    def _part(part: str, curve: Any) -> Expression:
        return Expression(f"{part} {curve.text if isinstance(curve, Expression) else curve}")

    def peak(self, curve: Any) -> Expression:
        """The highest |value| of a curve."""
        return self._part("peak", curve)

    def highest(self, curve: Any) -> Expression:
        return self._part("highest", curve)

    def lowest(self, curve: Any) -> Expression:
        return self._part("lowest", curve)
