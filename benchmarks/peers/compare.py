#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The same work by camlaw and by its peers, in turns: one table of CPU seconds and answers.

    benchmarks/peers/set-up
    build/peers-venv/bin/python benchmarks/peers/compare.py [--turns N] [--only NAME]
                                                            [--program PATH]

camlaw runs as a process of its own, with one worker, as people run it: user and system time of the
process, less that of a start that prints the version. What is left is reading the file and the
units, search, proof, verdict, and printing. A start takes 8 ms and repeats to some tenths of one. A
call from Python would leave the reading out, and needs the package built beside the program.
A peer runs in this process, after its import, with one thread: CPU time of building its model and
of solving it. benchmarks/README.md, "Peers", has what was measured.
"""

import argparse
import os
import statistics
import sys
import time
from pathlib import Path

for threads in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
    os.environ[threads] = "1"  # before NumPy is imported

from program import ROOT, Program  # noqa: E402
from row import Outcome, Row  # noqa: E402
from rows import all_rows  # noqa: E402

HEADER = (
    "work",
    "peer",
    "camlaw, CPU s",
    "peer, CPU s",
    "camlaw over peer",
    "camlaw's answer",
    "peer's answer",
    "difference",
    "peer violates between its places",
)


def turns(row: Row, program: Program, count: int) -> tuple[list[float], list[float], Outcome]:
    """CPU seconds of both by turn, ours without the start, and the answers of the last turn."""
    ours, theirs = [], []
    for _ in range(count):
        start = program.start()
        seconds, answer = program.run(row.words)
        ours.append(seconds - start)
        began = time.process_time()
        found = row.solve()
        theirs.append(time.process_time() - began)
    return ours, theirs, row.judge(answer, found)


def line(row: Row, ours: list[float], theirs: list[float], outcome: Outcome) -> str:
    ratio = statistics.median(a / b for a, b in zip(ours, theirs, strict=True))
    differs = f"{outcome.difference:.1e}"
    if not abs(outcome.difference) <= outcome.tolerance:
        differs = f"**{differs}**, above {outcome.tolerance:.0e}"
    cells = (
        row.work,
        row.peer,
        f"{statistics.median(ours):.2g}",
        f"{statistics.median(theirs):.2g}",
        f"{ratio:.2g}",
        outcome.ours,
        outcome.theirs,
        differs,
        outcome.violated,
    )
    return "| " + " | ".join(cells) + " |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--turns", type=int, default=5)
    parser.add_argument("--only", metavar="NAME", help="rows whose name has this in it")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/cli/camlaw")
    arguments = parser.parse_args()
    if arguments.turns < 1:
        parser.error("--turns is at least 1")
    rows = [row for row in all_rows() if (arguments.only or "") in row.name]
    if not rows:
        parser.error("no such row; there are " + ", ".join(row.name for row in all_rows()))
    table = os.fdopen(os.dup(sys.stdout.fileno()), "w", buffering=1)
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # where HiGHS prints its name
    print("| " + " | ".join(HEADER) + " |\n|---|---|--:|--:|--:|---|---|--:|---|", file=table)
    for row in rows:
        print(f"{row.name} ...", file=sys.stderr)
        print(line(row, *turns(row, Program(arguments.program), arguments.turns)), file=table)


if __name__ == "__main__":
    main()
