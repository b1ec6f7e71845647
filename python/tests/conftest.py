# SPDX-License-Identifier: MIT
"""What the tests share: the files of the project, and the program that they are compared with."""

import json
import os
import signal
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PROBLEMS = ROOT / "problems"
#: Nothing may be skipped for want of a library.
FULL = os.environ.get("CAMLAW_FULL") == "1"

os.chdir(ROOT)  # as the program is run: answers name files as they were given
# Ctrl-C is heard, also where the tests were started in the background by a shell that shuts it out.
signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_collection_modifyitems(config, items):
    if FULL or config.option.markexpr:
        return
    skip = pytest.mark.skip(reason="takes long: CAMLAW_FULL=1, as .ci/full sets it")
    for item in items:
        if "full" in item.keywords:
            item.add_marker(skip)


def needs(name):
    """A library that the test is about; without it the test is skipped, but in .ci/full."""
    if FULL:
        return __import__(name)
    return pytest.importorskip(name)


def program(*arguments, status=0):
    """What the program prints."""
    path = os.environ.get("CAMLAW_PROGRAM", str(ROOT / "build/release/cli/camlaw"))
    if not Path(path).exists():
        if FULL:
            raise FileNotFoundError(path)
        pytest.skip("the program has not been built")
    done = subprocess.run([path, *map(str, arguments)], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode == status, done.stderr
    return done.stdout


def program_json(*arguments, status=0):
    return json.loads(program(*arguments, "--json", status=status))


def same(ours, theirs):
    """Whether facts are the program's JSON, digit for digit."""
    return json.dumps(ours, ensure_ascii=False) == json.dumps(theirs, ensure_ascii=False)
