# SPDX-License-Identifier: MIT
"""Values with units, as people give them: numbers, texts such as "30 mm", quantities of pint.

A bare number is in the unit that the program lists; no unit is guessed.
"""

from typing import Any

from .errors import InputError


def is_pint(value: Any) -> bool:
    """Whether a value is a quantity of pint, which need not be there."""
    return hasattr(value, "magnitude") and hasattr(value, "units")


def pint_unit(units: Any) -> str:
    """A unit of pint as the program reads it: 'N/m', 'kg*m^2'."""
    return f"{units:~C}".replace("**", "^").replace("µ", "u").replace("Δ", "")


def value_text(value: Any) -> str:
    """A number to its last digit, a text as it is, a quantity as "30 mm"."""
    if isinstance(value, str):
        return value
    if is_pint(value):
        unit = pint_unit(value.units)
        number = value_text(value.magnitude)
        return f"{number} {unit}" if unit else number
    if isinstance(value, bool):
        raise InputError(f"{value} is not a number")
    if hasattr(value, "item"):
        value = value.item()
    if isinstance(value, (list, tuple)):
        return ",".join(value_text(item) for item in value)
    if isinstance(value, (int, float)):
        return repr(value)
    raise InputError(f"{value!r} is not a number, a text with a unit or a quantity of pint")


def settings_of(values: dict[str, Any]) -> list[str]:
    """What the program's --set takes: "name=value" of each."""
    return [f"{name}={value_text(value)}" for name, value in values.items()]
