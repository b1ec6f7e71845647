# SPDX-License-Identifier: MIT
"""The program camlaw as a process of its own, and what it takes of the processor."""

import json
import os
import re
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
PROBLEMS = ROOT / "problems"
FOUND, NONE_FOUND = 0, 3  # of the program's exit statuses


def cpu_seconds(words: list[str]) -> tuple[float, str]:
    """User and system time of a process and of those that it waited for, and what it printed."""
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        printed = process.stdout.read()
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode not in (FOUND, NONE_FOUND):
        raise SystemExit(f"ended with {process.returncode}: {' '.join(words)}")
    return used.ru_utime + used.ru_stime, printed


@dataclass(frozen=True)
class Program:
    path: Path

    def start(self) -> float:
        """CPU seconds of a start that does nothing: it prints the version."""
        return cpu_seconds([str(self.path), "--version"])[0]

    def run(self, words: list[str]) -> tuple[float, dict[str, Any]]:
        """CPU seconds of a command, and its answer."""
        seconds, printed = cpu_seconds([str(self.path), *words, "--json"])
        return seconds, json.loads(printed)


def problem(name: str, **values: object) -> str:
    """The path of a shipped problem file, or of a copy in which keys have other values."""
    text = (PROBLEMS / name).read_text()
    if not values:
        return str(PROBLEMS / name)
    for key, value in values.items():
        text, count = re.subn(rf"^{key} = .*$", f"{key} = {value}", text, flags=re.MULTILINE)
        if count != 1:
            raise SystemExit(f"{name} has {count} lines for {key}")
    stated = "_".join(f"{key}_{value}" for key, value in values.items())
    copy = copies() / f"{Path(name).stem}_{stated}.toml"
    copy.write_text(text)
    return str(copy)


_copies: list[tempfile.TemporaryDirectory[str]] = []


def copies() -> Path:
    """The folder of such copies, which goes when the process ends."""
    if not _copies:
        _copies.append(tempfile.TemporaryDirectory(prefix="camlaw-peers-"))
    return Path(_copies[0].name)
