# SPDX-License-Identifier: MIT
"""What the package raises. The sentences are the program's own."""

from typing import Any


class Error(Exception):
    """Something went wrong that is not the input's fault, such as a file that cannot be written."""


class InputError(Error, ValueError):
    """Bad input: the sentence names what is wrong with it, and what is accepted."""


class MissingPackage(Error, ImportError):
    """An optional package is wanted and not installed: the sentence names it."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C ended long work, and this is what it had by then.

    result: the answer so far, as the work would have returned it; None where it has none.
    """

    def __init__(self, result: Any = None) -> None:
        super().__init__(
            "stopped by Ctrl-C" + ("" if result is None else "; .result has the answer so far")
        )
        self.result = result

    def __reduce__(self) -> Any:
        return Interrupted, (self.result,)
