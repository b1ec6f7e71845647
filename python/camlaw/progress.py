# SPDX-License-Identifier: MIT
"""Progress of long work: a bar of tqdm where that is installed and somebody watches."""

import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from .arguments import shown as value_shown
from .errors import InputError

Told = Callable[[float | None, str], None]

#: What may be given as `progress`: True and False show a bar or none, None shows one where somebody
#: watches, and a function is called with the share that is done (None where nobody can say) and words.
Progress = bool | None | Told


def _is_watched() -> bool:
    if "ipykernel" in sys.modules:
        return True
    return sys.stderr is not None and sys.stderr.isatty()


@contextmanager
def shown(progress: Progress, what: str) -> Iterator[Told | None]:
    """What to tell progress to; None where nobody wants to know."""
    if callable(progress):
        yield progress
        return
    if progress is not None and not isinstance(progress, bool):
        raise InputError(
            f"progress: {value_shown(progress)} is none of True, False, None and a function"
        )
    if progress is False or (progress is None and not _is_watched()):
        yield None
        return
    try:
        with warnings.catch_warnings():
            # In a notebook without ipywidgets tqdm draws its bar of text, which is enough.
            warnings.filterwarnings("ignore", message="IProgress not found")
            from tqdm.auto import tqdm
    except ImportError:
        yield None
        return
    bar: Any = tqdm(
        total=1.0,
        desc=what,
        delay=0.5,
        leave=False,
        bar_format="{desc}: {percentage:3.0f}%|{bar}| {elapsed}{postfix}",
    )

    def tell(done: float | None, words: str) -> None:
        if done is not None and done > bar.n:
            bar.update(min(done, 1.0) - bar.n)
        bar.set_postfix_str(words)

    try:
        yield tell
    finally:
        bar.close()
