#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Two builds' speed: benchmarks/compare.py OLD NEW [--filter REGEX] [--turns N] [--time SECONDS]

OLD and NEW are camlaw_benchmarks of two builds. Their single measures run in turns, and a line for
each says how much longer the new one takes (processor time): the median of the turns' ratios and
its quartiles. A measure counts as slower where all between the quartiles is above 1 and the median
above 1.05.
"""
import argparse
import collections
import json
import statistics
import subprocess


def times(program, arguments):
    run = subprocess.run(
        [program, f"--benchmark_filter={arguments.filter}", "--benchmark_format=json",
         f"--benchmark_min_time={arguments.time}"],
        check=True, capture_output=True, text=True)
    report = run.stdout[run.stdout.index("{"):]
    return {one["name"]: one["cpu_time"] for one in json.loads(report)["benchmarks"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--filter", default=".")
    parser.add_argument("--turns", type=int, default=21)
    parser.add_argument("--time", type=float, default=0.02)
    arguments = parser.parse_args()

    ratios = collections.defaultdict(list)
    for turn in range(arguments.turns):
        programs = [arguments.old, arguments.new]
        order = programs if turn % 2 == 0 else programs[::-1]
        measured = {program: times(program, arguments) for program in order}
        for name, old in measured[arguments.old].items():
            if name in measured[arguments.new] and old > 0:
                ratios[name].append(measured[arguments.new][name] / old)

    slower = 0
    for name, values in ratios.items():
        low, middle, high = statistics.quantiles(values, n=4)
        is_slower = low > 1 and middle > 1.05
        slower += is_slower
        print(f"{middle:6.3f}  {low:6.3f} to {high:6.3f}  {name}{'  slower' if is_slower else ''}")
    middle = statistics.median(statistics.median(values) for values in ratios.values())
    print(f"{len(ratios)} measures, {slower} slower; the median of the ratios is {middle:.3f}")


if __name__ == "__main__":
    main()
