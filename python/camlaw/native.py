# SPDX-License-Identifier: MIT
"""The library itself, and where its own programs lie."""

from pathlib import Path

from . import _camlaw as native

native.add_own_folder(str(Path(__file__).parent / "libexec"))

__all__ = ["native"]
