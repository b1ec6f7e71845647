#!/usr/bin/env python3
"""Coverage by folder from gcovr's JSON summary, and the files of which the tests reach least.

    tests/coverage_table.py SUMMARY.json
"""

import collections
import json
import sys

# Files of which less of the lines than this is reached are named.
LEAST = 0.9


def share(part, whole):
    return f"{100 * part / whole:.1f} %" if whole else "-"


def main(path):
    with open(path, encoding="utf-8") as file:
        files = json.load(file)["files"]
    folders = collections.defaultdict(lambda: [0, 0, 0, 0])
    few = []
    for entry in files:
        counts = [
            entry["line_covered"],
            entry["line_total"],
            entry["branch_covered"],
            entry["branch_total"],
        ]
        folder = folders[entry["filename"].split("/")[0]]
        for i, count in enumerate(counts):
            folder[i] += count
        if counts[0] < LEAST * counts[1]:
            few.append((counts[0] / counts[1], entry["filename"], *counts))
    print("| folder | lines | reached | branches | reached |\n|---|---|---|---|---|")
    for name, (hit, lines, taken, branches) in sorted(folders.items()):
        print(f"| {name} | {lines} | {share(hit, lines)} | {branches} | {share(taken, branches)} |")
    print(f"\n{len(few)} of {len(files)} files have less than {100 * LEAST:.0f} % of their lines reached")
    for _, name, hit, lines, taken, branches in sorted(few):
        print(f"  {name}: {share(hit, lines)} of {lines} lines, {share(taken, branches)} of {branches} branches")


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]) if len(sys.argv) == 2 else __doc__)
