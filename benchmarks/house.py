#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What the house measures: benchmarks/house.py [TREE] [--build FOLDER] [--headers] [--change FILE:TESTS ...]

Prints, for a checkout (this one where none is named), a line for each room: files, statements, lines
of code and of comments, the longest file and how many have more than 400 lines; then its functions by
size, in lines from their heads to their closing braces: how many, the median, the share of at most 25
lines, how many have more than 60, and the longest; then the cycles in which folders include one
another. With --build FOLDER (a build by Ninja) also objects, the seconds that they took and the weak
symbols in them. With --headers each installed header: its lines, how many headers of camlaw it
reaches, and the CPU seconds (user and system, the median of five) that g++ takes to read it, beside
those for the headers of other libraries that it reaches: what lies between is camlaw's own share.
With --change and a build folder only what one changed file costs there: the file counts as changed,
the programs are built without a compiler cache, and tests are run, those of files that are named after
a colon, separated by commas. For example, in the preset dev:
  benchmarks/house.py --build build/dev --change cli/new_command.cpp:first_file_test
"""
import argparse
import collections
import os
import pathlib
import re
import statistics
import subprocess
import sys
import time

ROOMS = ["numerics", "kinematics", "optim", "machines", "problems", "fitting", "output", "cli"]
OTHERS = ["tests", "benchmarks", "examples"]
SHORT, LONG = 25, 60  # lines of a function that are read at a glance, and that no longer are
TOKENS = re.compile(
    r'R"\((?s:.*?)\)"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|//[^\n]*|/\*(?s:.*?)\*/')


def sources(tree, room):
    return sorted(p for p in (tree / room).rglob("*") if p.suffix in (".h", ".cpp"))


def without_comments(text):
    """The text without comments and with empty strings, and the lines that hold comments."""
    comments = 0

    def replaced(match):
        nonlocal comments
        token = match.group(0)
        if token.startswith(("//", "/*")):
            comments += token.count("\n") + 1
            return "\n" * token.count("\n")
        return '""' + "\n" * token.count("\n")

    return TOKENS.sub(replaced, text), comments


def statements(code):
    """Semicolons outside of for's parentheses, and blocks of control."""
    code = re.sub(r"\bfor \([^{};]*;[^{};]*;", "for (", code)
    return code.count(";") + len(re.findall(r"\b(?:if|for|while|switch|else|case)\b", code))


CONTROL = re.compile(r"(?:else\s+)?(?:if|for|while|switch|catch|do|else|return|case)\b")
HEAD = re.compile(r"^[^=]*[\w>~)\]=+\-*/%!<&|^,]\s*\(.*\)\s*"
                  r"(?:const|noexcept|override|final|mutable|&{1,2}|->[\w:<>,\s*&]+|:(?!:).*)*\s*$", re.S)
NAME = re.compile(r"([\w:~]+|operator\s*\S+?)\s*\(")


def is_function(head):
    """Whether text before a brace is a function's head: no control, no lambda, no class, no value."""
    head = re.sub(r"^(?:public|private|protected)\s*:", "", head.strip()).strip()
    if not head or CONTROL.match(head) or re.search(r"\[[^\[\]]*\]\s*(?:<[^(]*>)?\s*\(", head):
        return False
    if re.match(r"(?:namespace|extern|TEST_CASE|BENCHMARK)\b", head):
        return False
    before = head.split("(")[0]
    is_value = "=" in before.replace("operator==", "").replace("operator=", "")
    return "(" in head and not is_value and HEAD.match(head.replace("operator==", "operator")) is not None


def functions(text):
    """Name and lines of every function that is defined in a text without comments and strings."""
    text = re.sub(r"^[ \t]*#(?:.*\\\n)*.*$", "", text, flags=re.M)  # directives
    found, open_braces, begin = [], [], 0
    for i, letter in enumerate(text):
        if letter == ";" and text.count("(", begin, i) == text.count(")", begin, i):
            begin = i + 1
        elif letter == "{":
            head = text[begin:i]
            within = any(of is not None for of in open_braces)
            start = begin + len(head) - len(head.lstrip())
            open_braces.append((head, start) if not within and is_function(head) else None)
            begin = i + 1
        elif letter == "}":
            of = open_braces.pop() if open_braces else None
            if of is not None:
                name = NAME.search(of[0])
                found.append((name.group(1) if name else "?", text.count("\n", of[1], i) + 1))
            begin = i + 1
    return found


def function_table(tree):
    print(f"\n{'functions':<12}{'count':>7}{'median':>8}{f'<= {SHORT}':>7}{f'> {LONG}':>6}  longest")
    every = []
    for room in ROOMS:
        if not (tree / room).is_dir():
            continue
        sizes = []
        for path in sources(tree, room):
            code, _ = without_comments(path.read_text())
            sizes += [(lines, name, path.relative_to(tree)) for name, lines in functions(code)]
        print_functions(room, sizes)
        every += sizes
    print_functions("product", every)


def print_functions(room, sizes):
    lines = [size[0] for size in sizes]
    longest = max(sizes, default=(0, "", ""))
    short = sum(1 for n in lines if n <= SHORT) / max(1, len(lines))
    print(f"{room:<12}{len(lines):>7}{statistics.median(lines or [0]):>8.0f}{short:>7.1%}"
          f"{sum(1 for n in lines if n > LONG):>6}  {longest[0]}: {longest[1]}, {longest[2]}")


def circles(edges):
    """Sets of folders that include one another, by Tarjan's strongly connected components."""
    index, low, stack, result = {}, {}, [], []

    def visit(folder):
        index[folder] = low[folder] = len(index)
        stack.append(folder)
        for to in edges.get(folder, ()):
            if to not in index:
                visit(to)
                low[folder] = min(low[folder], low[to])
            elif to in stack:
                low[folder] = min(low[folder], index[to])
        if low[folder] == index[folder]:
            part = stack[stack.index(folder):]
            del stack[stack.index(folder):]
            if len(part) > 1:
                result.append(sorted(part))

    for folder in list(edges):
        if folder not in index:
            visit(folder)
    return result


def table(tree):
    print(f"{'room':<12}{'files':>6}{'statements':>12}{'code':>8}{'comments':>10}{'share':>7}"
          f"{'longest':>9}{'> 400':>7}")
    total = collections.Counter()
    for room in ROOMS + OTHERS:
        if not (tree / room).is_dir():
            continue
        row, longest = collections.Counter(), 0
        for path in sources(tree, room):
            text = path.read_text()
            code, comments = without_comments(text)
            lines = text.count("\n")
            longest = max(longest, lines)
            row.update(files=1, statements=statements(code), comments=comments,
                       code=sum(1 for line in code.splitlines() if line.strip()),
                       long=int(lines > 400))
        if room in ROOMS:
            total.update(row)
        print_row(room, row, longest)
    print_row("product", total, 0)


def print_row(name, row, longest):
    share = row["comments"] / max(1, row["comments"] + row["code"])
    print(f"{name:<12}{row['files']:>6}{row['statements']:>12}{row['code']:>8}"
          f"{row['comments']:>10}{share:>7.1%}{longest or '':>9}{row['long']:>7}")


def folder_circles(tree):
    edges = collections.defaultdict(set)
    for room in ROOMS:
        for path in sources(tree, room) if (tree / room).is_dir() else []:
            here = path.parent.relative_to(tree).as_posix()
            for to in re.findall(r'#include "([^"]+)"', path.read_text()):
                there = pathlib.PurePosixPath(to).parent.as_posix()
                if there != here and (tree / to).is_file():
                    edges[here].add(there)
    return circles(edges)


def built(build):
    latest = {}  # of an object that was built again
    for line in (build / ".ninja_log").read_text().splitlines()[1:]:
        begin, end, _, output, _ = line.split("\t")
        if output.endswith(".o") and (build / output).is_file():
            latest[output] = (int(end) - int(begin)) / 1000
    seconds = collections.Counter()
    objects = collections.Counter(output.split("/")[0] for output in latest)
    for output, taken in latest.items():
        seconds[output.split("/")[0]] += taken
    print(f"\n{'built':<12}{'objects':>8}{'seconds':>9}")
    for room, count in objects.items():
        print(f"{room:<12}{count:>8}{seconds[room]:>9.0f}")
    weak, distinct = 0, set()
    for room in ROOMS:
        for path in (build / room).rglob("*.o"):
            listing = subprocess.run(["nm", "--defined-only", path], capture_output=True, text=True)
            names = [l.split()[2] for l in listing.stdout.splitlines() if l.split()[1] in "WVu"]
            weak += len(names)
            distinct.update(names)
    print(f"weak symbols: {weak} emitted, {len(distinct)} distinct")


def reached(tree, header):
    """Files of the tree that a header includes, itself among them, and what else it includes."""
    own, others, wanted = set(), set(), [header]
    while wanted:
        file = wanted.pop()
        if file in own:
            continue
        own.add(file)
        for bracket, name in re.findall(r'#include ([<"])([^>"]+)', (tree / file).read_text()):
            if bracket == "<":
                others.add(name)
            else:
                wanted.append(name)
    return own, others


def reading_time(tree, includes):
    """CPU seconds of g++ for a file that has these includes and nothing else."""
    text = "".join(f"#include {name}\n" for name in includes)
    eigen = subprocess.run(["pkg-config", "--cflags", "eigen3"], capture_output=True, text=True)
    command = ["g++", "-std=c++20", "-O0", "-fsyntax-only", "-I", str(tree), *eigen.stdout.split(),
               "-x", "c++", "-"]
    seconds = []
    for _ in range(5):
        before = os.times()
        subprocess.run(command, input=text, text=True, check=True, cwd=tree)
        after = os.times()
        seconds.append(after.children_user - before.children_user
                       + after.children_system - before.children_system)
    return statistics.median(seconds)


def installed_headers(tree):
    headers = re.findall(r"[\w/]+/\w+\.h\b", (tree / "cmake/CamlawHeaders.cmake").read_text())
    print(f"\n{'installed header':<42}{'lines':>6}{'reaches':>9}{'seconds':>9}{'others':>8}")
    for header in headers:
        own, others = reached(tree, header)
        lines = (tree / header).read_text().count("\n")
        whole = reading_time(tree, [f'"{header}"'])
        alone = reading_time(tree, [f"<{name}>" for name in sorted(others)])
        print(f"{header:<42}{lines:>6}{len(own) - 1:>9}{whole:>9.2f}{alone:>8.2f}")
    print(f"{len(headers)} headers")


def timed(command):
    """Wall and CPU seconds of a command that must succeed."""
    before, began = os.times(), time.monotonic()
    done = subprocess.run(command, env=os.environ | {"CCACHE_DISABLE": "1"}, capture_output=True,
                          text=True)
    took, after = time.monotonic() - began, os.times()
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}:\n{done.stdout}{done.stderr}")
    return took, (after.children_user - before.children_user
                  + after.children_system - before.children_system)


def change_table(tree, build, changes):
    build_all = ["cmake", "--build", build, "--target", "camlaw", "camlaw_tests"]
    timed(build_all)  # what is not up to date is none of the change
    print(f"{'changed file':<42}{'build':>8}{'tests':>8}{'both':>8}{'CPU':>8}   seconds")
    for change in changes:
        file, _, tests = change.partition(":")
        os.utime(tree / file)
        taken = [timed(build_all), (0.0, 0.0)]
        if tests:
            wanted = ",".join(f"[#{test}]~[heavy]~[.]" for test in tests.split(","))
            taken[1] = timed([build / "tests/camlaw_tests", "--filenames-as-tags", wanted])
        (built_in, built_cpu), (tested_in, tested_cpu) = taken
        print(f"{file:<42}{built_in:>8.1f}{tested_in:>8.1f}{built_in + tested_in:>8.1f}"
              f"{built_cpu + tested_cpu:>8.1f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("tree", nargs="?", default=pathlib.Path(__file__).parents[1],
                        type=pathlib.Path)
    parser.add_argument("--build", type=pathlib.Path, help="a build folder of Ninja")
    parser.add_argument("--headers", action="store_true", help="the installed headers")
    parser.add_argument("--change", nargs="+", metavar="FILE:TESTS", help="what one change costs")
    arguments = parser.parse_args()
    if arguments.change:
        if not arguments.build:
            parser.error("--change needs --build")
        change_table(arguments.tree, arguments.build.resolve(), arguments.change)
        return
    table(arguments.tree)
    function_table(arguments.tree)
    found = folder_circles(arguments.tree)
    print(f"\ninclude cycles of folders: {len(found)}")
    for circle in found:
        print("  " + " ".join(circle))
    if arguments.build:
        built(arguments.build)
    if arguments.headers:
        installed_headers(arguments.tree)


if __name__ == "__main__":
    main()
