# SPDX-License-Identifier: MIT
"""Answers of the library as data, where they go to another process."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from .errors import InputError


class Kept:
    """What the methods of an answer of the library return, by their names; it is asked as the answer is."""

    def __init__(self, answer: Any, names: Sequence[str]) -> None:
        self._told = {name: self._tell(answer, name) for name in names}

    @staticmethod
    def _tell(answer: Any, name: str) -> Any:
        try:
            return getattr(answer, name)()
        except InputError as refusal:  # such as of a figure that there is not
            return refusal

    def __getattr__(self, name: str) -> Any:
        if name == "_told" or name not in self._told:
            raise AttributeError(name)
        told = self._told[name]

        def answer() -> Any:
            if isinstance(told, InputError):
                raise told
            return told

        return answer
