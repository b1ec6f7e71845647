# SPDX-License-Identifier: MIT
"""The library itself, and where its own programs lie."""

from pathlib import Path

from . import _camlaw as native

# Beside the module: an editable installation has the sources elsewhere.
native.add_own_folder(str(Path(native.__file__).parent / "libexec"))

__all__ = ["native"]
