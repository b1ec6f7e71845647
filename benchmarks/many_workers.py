#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How much of two workers is of use: time by one process over twice the time by two workers.

Of use beside another: the same with the time of one process while a second one does the same work
beside it. Two cores of one machine share its memory, and may share more: no two workers are quicker.

    ./run python benchmarks/many_workers.py [ROUNDS] [POINTS]

Processes, the ranks of MPI (two that search, beside the one that hands out), and Dask's workers with
its scheduler. They take turns; the least time of each counts. It needs two idle cores, mpirun, and the
packages of python/requirements-full.txt. benchmarks/README.md has what was measured.
"""

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import camlaw as cl

ROOT = Path(__file__).parent.parent
PROGRAM = ROOT / "build/release/cli/camlaw"
FRONT = ROOT / "problems/cams/roller_front.toml"
PARTS = ROOT / "problems/cams/tolerances.toml"
SAMPLES = 20_000_000


def seconds(action: Callable[[], object]) -> float:
    began = time.perf_counter()
    action()
    return time.perf_counter() - began


def ran(*words: str) -> None:
    # As root where the benchmark is, on this machine alone, with more ranks than cores.
    settings = {
        "OMPI_ALLOW_RUN_AS_ROOT": "1",
        "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
        "OMPI_MCA_btl": "self,vader",
        "OMPI_MCA_rmaps_base_oversubscribe": "1",
        "OMPI_MCA_mpi_yield_when_idle": "1",
        "OMPI_MCA_plm_rsh_agent": "/bin/false",
    }
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, env=os.environ | settings)


def beside(*words: str) -> None:
    """Two programs at once, which share nothing."""
    both = [subprocess.Popen(words, stdout=subprocess.DEVNULL) for _ in range(2)]
    if any([process.wait() for process in both]):
        raise SystemExit("a program failed: " + " ".join(words))


def ways(points: int, client: object) -> dict[str, dict[str, Callable[[], object]]]:
    """Of each study who carries it out; the first of each is one process."""
    front, parts = cl.Problem.load(FRONT), cl.Problem.load(PARTS)
    said = ("pareto", str(FRONT), "--points", str(points), "--json")
    counted = ("tolerance", str(PARTS), "--samples", str(SAMPLES), "--json")
    mpi = ("mpirun", "-n", "3", str(PROGRAM))
    studies: dict[str, dict[str, Callable[[], object]]] = {
        f"front of {points} points": {
            "one process": lambda: ran(str(PROGRAM), *said, "--workers", "1"),
            "one beside another": lambda: beside(str(PROGRAM), *said, "--workers", "1"),
            "two processes": lambda: ran(str(PROGRAM), *said, "--workers", "2"),
            "two ranks of MPI": lambda: ran(*mpi, *said, "--executor", "mpi"),
            "Dask, two workers": lambda: front.pareto(points=points, executor=client),
        },
        f"yield of {SAMPLES} parts": {
            "one process": lambda: ran(str(PROGRAM), *counted, "--workers", "1"),
            "one beside another": lambda: beside(str(PROGRAM), *counted, "--workers", "1"),
            "two processes": lambda: ran(str(PROGRAM), *counted, "--workers", "2"),
            "two ranks of MPI": lambda: ran(*mpi, *counted, "--executor", "mpi"),
            "Dask, two workers": lambda: parts.tolerance(samples=SAMPLES, executor=client),
        },
    }
    if shutil.which("mpirun") is None:
        for study in studies.values():
            del study["two ranks of MPI"]
    return studies


def main() -> None:
    from distributed import Client, LocalCluster

    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 3
    points = int(sys.argv[2]) if len(sys.argv) > 2 else 400
    with (
        LocalCluster(
            n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address=None
        ) as cluster,
        Client(cluster) as client,
    ):
        for study, carried in ways(points, client).items():
            least = dict.fromkeys(carried, float("inf"))
            for _ in range(rounds):
                for who, action in carried.items():
                    least[who] = min(least[who], seconds(action))
            alone, together = least["one process"], least["one beside another"]
            print(study)
            for who, took in least.items():
                use = f"{alone / (2 * took):6.0%} of use, {together / (2 * took):.0%} beside another"
                print(f"  {who:20}{took:8.2f} s{'' if who.startswith('one') else use}")


if __name__ == "__main__":
    main()
