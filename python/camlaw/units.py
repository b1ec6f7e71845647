# SPDX-License-Identifier: MIT
"""Values with units, as people give them: numbers, texts such as "30 mm", quantities of pint.

A bare number is in the unit that the program lists; no unit is guessed.
"""

import re
from collections.abc import Mapping
from typing import Any

from .arguments import is_pint, shown, word
from .errors import InputError
from .native import native


def pint_unit(units: Any) -> str:
    """A unit of pint as the program reads it: 'N/m', 'kg*m^2'."""
    return f"{units:~C}".replace("**", "^").replace("µ", "u").replace("Δ", "")


def of_pint(value: Any) -> tuple[Any, str]:
    """Number and unit of a quantity of pint. If a symbol is another unit's here ("ct" is pint's carat
    and a hundredth of a tonne), the quantity goes in SI units. One without a unit has the unit "1",
    which is not accepted for a dimension."""
    unit = pint_unit(value.units)
    if not unit:
        return value.magnitude, "1"
    try:
        base = (1 * value.units).to_base_units()
        si = pint_unit(base.units) or "1"
        here = native.quantity(f"1 {unit}", si, si, "")
        known = float(base.magnitude)
        if abs(here - known) <= 1e-9 * abs(known):
            return value.magnitude, unit
    except (InputError, ValueError):
        pass
    in_si = value.to_base_units()
    return in_si.magnitude, pint_unit(in_si.units) or "1"


def value_text(value: Any, what: str = "") -> str:
    """A number to its last digit, a text as it is, a quantity as "30 mm". `what` names it in errors."""
    said = f"{what}: " if what else ""
    if isinstance(value, str):
        return word(value, what or "value")
    if is_pint(value):
        number, unit = of_pint(value)
        return f"{value_text(number, what)} {unit}"
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, bool):
        raise InputError(f"{said}{value} is not a number")
    if isinstance(value, (list, tuple)):
        return ",".join(value_text(item, what) for item in value)
    if isinstance(value, (int, float)):
        return repr(value)
    raise InputError(
        f"{said}{shown(value)} is not a number, a text with a unit or a quantity of pint"
    )


def seconds(time_limit: Any) -> float | None:
    """A time limit, seconds or such as "1 min"; None where there is none."""
    if time_limit is None:
        return None
    time = native.quantity(value_text(time_limit, "time_limit"), "s", "s", "time_limit")
    if not time > 0:
        raise InputError(f"time_limit: {time:g} s is not above zero")
    return None if time == float("inf") else time


_SIZES = {
    "": 1,
    **{f"{prefix}B": 1000 ** (k + 1) for k, prefix in enumerate("kMGT")},
    **{f"{prefix}iB": 1024 ** (k + 1) for k, prefix in enumerate("KMGT")},
}


def _bytes_of_pint(memory: Any) -> Any:
    try:
        return memory.to("byte").magnitude
    except Exception:  # pint's own kinds
        raise InputError(f"memory: {shown(memory)} is not a size") from None


def size_in_bytes(memory: Any) -> float | None:
    """Memory, bytes or such as "4 GB" or "2 GiB"; None where none is named."""
    if memory is None:
        return None
    if is_pint(memory):
        memory = _bytes_of_pint(memory)
    found = re.fullmatch(r"\s*([-+.0-9eE]+)\s*([A-Za-z]*)\s*", value_text(memory, "memory"))
    try:
        if found is not None and 0 < float(found[1]) < float("inf"):
            return float(found[1]) * _SIZES[found[2]]
    except (KeyError, ValueError):
        pass
    raise InputError(
        f"memory: {shown(memory)} is not a size above zero; write bytes as a number, or a text such as '4 GB' "
        "with a unit from kB to TB or from KiB to TiB"
    )


def settings_of(values: Mapping[str, Any]) -> list[str]:
    """What the program's --set takes: "name=value" of each."""
    return [f"{name}={value_text(value, name)}" for name, value in values.items()]
