# SPDX-License-Identifier: MIT
"""Dicts as the text of a problem file, which is what the library reads."""

import json
import re
from collections.abc import Mapping
from typing import Any

from .arguments import is_pint, shown, text
from .errors import InputError
from .units import value_text

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def _key(name: Any, where: str) -> str:
    if not isinstance(name, str):
        raise InputError(f"{where or 'problem'}: the name {shown(name)} is not a text")
    if any(ord(letter) < 32 for letter in name):
        raise InputError(f"{where or 'problem'}: the name {shown(name)} has a control character")
    return name if _BARE.fullmatch(name) else _text(text(name, where))


def _text(value: str) -> str:
    # A basic string of TOML; JSON's escapes are among its own.
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def _large(value: int, where: str) -> str:
    """A whole number beyond those of TOML, as a float."""
    try:
        return repr(float(value))
    except OverflowError:
        raise InputError(f"{where}: the number is larger than 1.8e308") from None


def _value(value: Any, where: str) -> str:
    if hasattr(value, "tolist") and not is_pint(value):
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return _text(text(value, where))
    if is_pint(value):
        return _text(value_text(value))
    if isinstance(value, int) and not -(2**63) <= value < 2**63:
        return _large(value, where)
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(_value(item, where) for item in value) + "]"
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{_key(k, where)} = {_value(v, where)}" for k, v in value.items()) + "}"
    raise InputError(f"{where}: {shown(value)} is not a number, a text, a list or a dict")


def _is_tables(value: Any) -> bool:
    return (
        isinstance(value, (list, tuple))
        and bool(value)
        and all(isinstance(v, Mapping) for v in value)
    )


def _table(table: Mapping[str, Any], path: tuple[str, ...], lines: list[str]) -> None:
    within = ".".join(path)
    keys = {name: _key(name, within) for name in table}
    for name, value in table.items():
        if value is None or isinstance(value, Mapping) or _is_tables(value):
            continue
        lines.append(f"{keys[name]} = {_value(value, '.'.join((*path, name)))}")
    for name, value in table.items():
        inner = (*path, name)
        title = ".".join(_key(part, within) for part in inner)
        if isinstance(value, Mapping):
            lines += ["", f"[{title}]"]
            _table(value, inner, lines)
        elif _is_tables(value):
            for item in value:
                lines += ["", f"[[{title}]]"]
                _table(item, inner, lines)


def toml_text(table: Mapping[str, Any]) -> str:
    """The text of nested dicts; what is None is left out. Numbers keep every digit."""
    lines: list[str] = []
    _table(table, (), lines)
    return "\n".join(lines) + "\n"
