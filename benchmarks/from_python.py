#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What calls from Python cost, each as a ratio to the same work without Python, or without the calls.

    ./run python benchmarks/from_python.py [ROUNDS]

The two sides of a ratio take turns, and each counts with the least time of its turns: what else the
machine does makes a turn slower, never faster. benchmarks/README.md has what was measured.
"""

import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

import camlaw as cl

POINTS = 4096
EACH = 50  # calls of a law in a turn, as many as Law.loop_seconds makes of its own
PROBLEM = Path(__file__).parent.parent / "problems/cams/roller_least_base.toml"


def seconds(action: Callable[[], object], each: int = 1) -> float:
    """Time of one call, of `each` in a row."""
    began = time.perf_counter()
    for _ in range(each):
        action()
    return (time.perf_counter() - began) / each


def law_over_loop(name: str, rounds: int) -> tuple[float, float]:
    """Seconds of law(x), arrays and all, and of the library's loop over arrays that are there."""
    law, x = cl.law(name), np.linspace(0, 1, POINTS)
    turns = [
        (seconds(lambda: law(x), EACH), law._native.loop_seconds(POINTS, 1))
        for _ in range(10 * rounds)
    ]
    return min(mine for mine, _ in turns), min(loop for _, loop in turns)


def calls_over_batch(rounds: int) -> tuple[float, float]:
    """Seconds of 1000 calls of evaluate, 50 of which are made a turn, and of one evaluate_many."""
    problem = cl.Problem.load(PROBLEM)
    radii = np.linspace(40, 100, 1000)
    turns = []
    for _ in range(rounds):
        some = iter(radii[::20])
        one = seconds(lambda: problem.evaluate(base_radius=float(next(some))), len(radii[::20]))
        turns.append((1000 * one, seconds(lambda: problem.evaluate_many({"base_radius": radii}))))
    return min(calls for calls, _ in turns), min(batch for _, batch in turns)


def import_seconds(rounds: int) -> float:
    """Seconds that `import camlaw` takes in a fresh Python."""
    code = "import time; t = time.perf_counter(); import camlaw; print(time.perf_counter() - t)"
    command = [sys.executable, "-c", code]
    return min(
        float(subprocess.run(command, capture_output=True, text=True, check=True).stdout)
        for _ in range(rounds)
    )


def main() -> None:
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 21
    print(f"law(x) at {POINTS} points over the library's loop")
    for name in ("polynomial-5", "cycloidal", "modified-sine", "modified-trapezoid"):
        mine, loop = law_over_loop(name, rounds)
        print(f"  {name:20}{mine / loop:6.2f}   {mine * 1e6:.2f} us, {loop * 1e6:.2f} us")
    calls, batch = calls_over_batch(max(1, rounds // 5))
    print("1000 calls of evaluate over one call of evaluate_many")
    print(f"  {PROBLEM.stem:20}{calls / batch:6.1f}   {calls:.2f} s, {batch:.3f} s")
    print(f"import camlaw               {import_seconds(rounds):.3f} s")


if __name__ == "__main__":
    main()
