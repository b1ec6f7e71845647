# SPDX-License-Identifier: MIT
"""A row of the table: one piece of work that camlaw and a peer do."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

Json = dict[str, Any]


@dataclass(frozen=True)
class Outcome:
    """Both answers, as the table says them."""

    ours: str
    theirs: str
    difference: float  # of the two answers, as a fraction of ours
    tolerance: float  # up to which they count as the same
    violated: str  # what the peer's answer violates between its places


@dataclass(frozen=True)
class Row:
    """`solve` is timed, as the peer's work; `judge` is not, and has our answer and the peer's."""

    name: str
    work: str
    peer: str
    words: list[str]  # the command of camlaw
    solve: Callable[[], Any]
    judge: Callable[[Json, Any], Outcome]


def excess(value: float) -> str:
    """How far something is above 0, in words."""
    return f"{value:.0e}" if value > 0 else "0"


def verdict(answer: Json) -> str:
    """The verdict of an answer of `camlaw optimize`."""
    return answer["verdict"] + (", global" if answer.get("global") else "")
