# SPDX-License-Identifier: MIT
"""The exceptions that the package raises. Their messages are the program's own."""

from typing import Any


class Error(Exception):
    """Something went wrong that is not the input's fault."""


class InputError(Error, ValueError):
    """An input is wrong: the message names it and says what is accepted."""


class MissingPackage(Error, ImportError):
    """A call needs an optional package that is not installed: the message names it."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C ended long work.

    result: the answer so far, as the call would have returned it; None if there is none yet.
    """

    def __init__(self, result: Any = None) -> None:
        super().__init__(
            "stopped by Ctrl-C" + ("" if result is None else "; .result has the answer so far")
        )
        self.result = result

    def __reduce__(self) -> Any:
        return Interrupted, (self.result,)
