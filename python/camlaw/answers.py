# SPDX-License-Identifier: MIT
"""What all answers have in common."""

from __future__ import annotations

from typing import Any

#: Of a search, what differs where it is done once more.
_OF_ONE_RUN = ("wall_s", "checksum")


class Answer:
    """An answer with facts: two are equal if they are of one kind and say the same, to the last digit."""

    facts: dict[str, Any]

    def _said(self) -> str:
        return repr({name: fact for name, fact in self.facts.items() if name not in _OF_ONE_RUN})

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return self._said() == other._said()

    def __hash__(self) -> int:
        return hash(self._said())
