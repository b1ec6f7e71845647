# SPDX-License-Identifier: MIT
"""Python ends with its own status whatever its threads do in the library."""

import subprocess
import sys

import pytest
from conftest import PROBLEMS

CALLS = {
    "a search": "problem.optimize()",
    "a front": "front.pareto(points=60, workers=1)",
    "a front with progress": "front.pareto(points=60, workers=1, progress=lambda done, words: None)",
    "many evaluations": "problem.evaluate_many({'base_radius': np.linspace(30, 60, 40000)})",
    "a sweep": "problem.sweep({'stroke': '20:0.05:40 mm'}, workers=2)",
    "laws": "cl.law('modified-sine', crossover=0.4).C_a",
    "an export": "problem.export(format='dxf')",
}


@pytest.mark.parametrize("name", CALLS)
def test_a_daemon_thread_in_the_library_does_not_abort_the_interpreter(name):
    script = f"""
import threading, time
import camlaw as cl, numpy as np
problem = cl.Problem.load({str(PROBLEMS / "cams/roller_least_base.toml")!r})
front = cl.Problem.load({str(PROBLEMS / "cams/roller_front.toml")!r})
begun = threading.Event()
def run():
    while True:
        begun.set()
        {CALLS[name]}
threading.Thread(target=run, daemon=True).start()
begun.wait()
time.sleep(0.3)
print("the main thread ends", flush=True)
"""
    for _ in range(3):
        ended = subprocess.run(
            [sys.executable, "-c", script], capture_output=True, text=True, timeout=120
        )
        assert (ended.returncode, ended.stderr) == (0, "")
        assert ended.stdout == "the main thread ends\n"


def test_the_library_can_be_called_while_python_ends():
    script = f"""
import atexit
atexit.register(lambda: print(round(cl.law("cycloidal").C_v, 9), problem.evaluate().feasible in (True, False)))
import camlaw as cl  # whose own end comes before what was registered earlier
problem = cl.Problem.load({str(PROBLEMS / "cams/roller_least_base.toml")!r})
"""
    ended = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, timeout=120
    )
    assert (ended.returncode, ended.stderr) == (0, "")
    assert ended.stdout == "2.0 True\n"
