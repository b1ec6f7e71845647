# SPDX-License-Identifier: MIT
"""The library itself, and where its own programs lie."""

from pathlib import Path

from . import _camlaw as native

# Beside the module: where the sources are linked, as an editable installation does, that is elsewhere.
native.add_own_folder(str(Path(native.__file__).parent / "libexec"))

__all__ = ["native"]
