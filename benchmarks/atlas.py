#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The law atlas: benchmarks/atlas.py [--camlaw PROGRAM] [--out FOLDER] [--only PAIR] [--resume] [--quick | --check]

Works out, by `camlaw sweep`, how little one characteristic value of a law may be where another one is
bounded: the fronts of nine families with parameters and of the free law, and the points of the laws of
the catalogue as they are. Writes FOLDER/atlas.csv, FOLDER/atlas.svg and FOLDER/nearest.md, docs/atlas
unless told. With --quick two bounds of each front. With --check nothing is written: two bounds of each
front of the first pair, or of that of --only, are compared with FOLDER/atlas.csv.

A row of the CSV is a search: the pair, the family, the bound, the least value, the verdict, the law's
parameters. Rows of laws without parameters have what the law has.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# What varies of each family, as a problem file states it. The ranges are those in which the front lies.
FAMILIES = {
    "polynomial-5": {"alpha": (-20, 20)},
    "polynomial-7": {"A": (-60, 160)},
    "legendre": {"c": (-30, 30, [-3, 0, 0])},
    "fourier": {"a": (-2, 2, [0, 0.1, 0])},
    "trapezoidal-velocity": {"t1": (0.02, 0.5), "t2": (0.02, 0.5)},
    "trapezoidal-acceleration": {"ramp": (0.01, 0.25), "constant": (0, 0.49)},
    "scca": {"a": (0.01, 0.9), "b": (0, 0.9), "c": (0.01, 0.9)},
    "elliptic": {"n": (0.4, 3)},
    "inclined-sinusoid": {"angle": (55, 125)},
}

# Families and laws whose acceleration begins and ends at zero, and does not jump inside.
SMOOTH = ["free", "polynomial-7", "fourier", "trapezoidal-acceleration", "scca", "inclined-sinusoid"]
ALL = ["free", *FAMILIES]


# The limit index as a response: the least time for a law's own peaks. Under these peaks the fastest motion
# reaches the least of the acceleration limit and of what the velocity and the stroke leave, and then the least
# of the velocity limit and of what the stroke leaves.
LAMBDA = """[responses.acceleration_reached]
formula = "min(peak acceleration, sqrt(peak velocity * peak jerk), (peak jerk^2 / 2)^(1/3))"
[responses.ramp]
formula = "acceleration_reached / peak jerk"
[responses.velocity_reached]
formula = "min(peak velocity, acceleration_reached * (sqrt(ramp^2 + 4 / acceleration_reached) - ramp) / 2)"
[responses.lambda]
formula = "1 / velocity_reached + velocity_reached / acceleration_reached + ramp"
"""


class Pair:
    """The value that is sought, the one that is bounded, its bounds, what the free law is (none: it is
    not searched), the families that are compared with it, whether the value is to be high, and the limit
    that is known of it."""

    def __init__(self, sought, bounded, bounds, free, laws=None, smooth=False, constants="", highest=False,
                 limit=None):
        self.sought, self.bounded, self.bounds = sought, bounded, bounds
        self.free, self.smooth, self.constants = free, smooth, constants
        self.laws = laws or (SMOOTH if smooth else ALL)
        self.highest, self.limit = highest, limit
        self.sense = "maximize" if highest else "minimize"


# The free law may begin and end with an acceleration unless the families may not.
PAIRS = {
    "C_a over C_v": Pair("C_a", "C_v", "1.2:0.2:2", "degree = 2\nknots = 98"),
    "C_Mdyn over C_v": Pair("C_Mdyn", "C_v", "1.2:0.2:2", "degree = 2\nknots = 60"),
    "C_j over C_a": Pair("C_j", "C_a", "4.4:0.4:6", "degree = 3\nknots = 60", smooth=True),
    "mean_square_acceleration over C_v": Pair(
        "mean_square_acceleration", "C_v", "1.2:0.2:2",
        'degree = 3\nknots = 40\nbegin = "U"\nend = "U"'),
    "residual_amplitude over C_a": Pair(
        "residual_amplitude", "C_a", "4.4:0.4:6", None, laws=list(FAMILIES),
        constants="[constants]\nperiod_ratio = 1.25\n"),
    "lambda over C_j": Pair(
        "lambda", "C_j", "34:3:46", None,  # of fourier a bound takes minutes: it has no slope where two peaks meet
        laws=["polynomial-7", "trapezoidal-acceleration", "scca", "inclined-sinusoid"],
        smooth=True, constants=LAMBDA, highest=True, limit=1),
}

AS_IT_IS = "as it is"  # the verdict of a law that is not searched

# Families whose default member stands for another law, or for none: docs/atlas.md says why.
LEFT_OUT = ["boundary-5", "boundary-7", "b-spline", "table"]


def family_problem(pair, law):
    asked = PAIRS[pair]
    text = f'mechanism = "law"\n{asked.constants}[law]\nname = "{law}"\n'
    if law == "free":
        text += f"[free]\n{asked.free}\n"
    for name, (low, high, *start) in FAMILIES.get(law, {}).items():
        text += f"[variables.{name}]\nlower = {low}\nupper = {high}\n"
        text += "".join(f"start = {values}\n" for values in start)  # a list's gives its length
    return text + (f'[objective]\n{asked.sense} = "{asked.sought}"\n'
                   f'[[constraints]]\nresponse = "{asked.bounded}"\nupper = 100\n')


def sweep(program, text, more):
    done = subprocess.run([program, "sweep", "-", "--json", *more], input=text, text=True,
                          capture_output=True, check=False)
    if not done.stdout:
        raise SystemExit(f"camlaw sweep failed: {done.stderr}")
    return json.loads(done.stdout)


def rows_of_front(program, pair, law, quick):
    sought, bounded, bounds = PAIRS[pair].sought, PAIRS[pair].bounded, PAIRS[pair].bounds
    if quick:
        low, step, high = (float(part) for part in bounds.split(":"))
        bounds = f"{low + 2 * step:g},{high:g}"
    answer = sweep(program, family_problem(pair, law), ["--set", f"{bounded}.upper={bounds}", "--time-limit", "900 s"])
    for row in answer["combinations"]:
        parameters = {name.removeprefix("design "): value for name, value in row.items()
                      if name.startswith("design ")}
        if law == "free":
            parameters = {}
        yield {"pair": pair, "law": law, "bound": row[f"{bounded}.upper"],
               "value": row[sought], "verdict": row["verdict"],
               "parameters": " ".join(f"{n}={v:.6g}" for n, v in parameters.items()
                                      if isinstance(v, (int, float)))}


def rows_of_fixed(program, pair):
    """The laws of the catalogue from rest to rest as they are."""
    asked = PAIRS[pair]
    text = f'mechanism = "law"\nlaw.name = "cycloidal"\n{asked.constants}'
    text += "".join(f'[[objectives]]\nminimize = "{name}"\n' for name in (asked.sought, asked.bounded))
    laws = "ends R-R, continuity >= 2" if asked.smooth else "ends R-R"
    answer = sweep(program, text, ["--evaluate", "--set", f"law={laws}"])
    for row in answer["combinations"]:
        if row["law"].split()[0] in LEFT_OUT:
            continue
        value, bound = row[asked.sought], row[asked.bounded]
        if isinstance(value, (int, float)) and isinstance(bound, (int, float)):
            yield {"pair": pair, "law": row["law"], "bound": bound, "value": value,
                   "verdict": AS_IT_IS, "parameters": ""}


def panel(pair, rows, x0, width, height):
    """One chart: fronts as lines, laws as they are as dots, the free law as the limit."""
    bounded, bounds = PAIRS[pair].bounded, PAIRS[pair].bounds
    low, _, high = (float(part) for part in bounds.split(":"))
    own = [r for r in rows if r["pair"] == pair and r["value"] is not None
           and low - 1e-9 <= r["bound"] <= high + 1e-9]
    certified = [r for r in own if r["verdict"] != AS_IT_IS]
    least = min(r["value"] for r in own)
    most = max(2.2 * least, sorted(r["value"] for r in certified)[len(certified) * 3 // 4])
    if least <= 0:
        most = max(r["value"] for r in certified)
    if PAIRS[pair].highest:
        least, most = min(r["value"] for r in certified) - 0.01, PAIRS[pair].limit
    left, top, bottom = 56, 26, 40
    px = lambda b: x0 + left + (b - low) / (high - low) * (width - left - 16)
    py = lambda v: height - bottom - (v - least) / (most - least) * (height - top - bottom)
    colours = ["#0b63b0", "#b35309", "#1a7f37", "#8250df", "#57606a", "#bf3989", "#9a6700", "#0a7d91",
               "#cf222e"]
    parts = [f'<text x="{x0 + width / 2:.0f}" y="15" text-anchor="middle" font-weight="600">{pair}</text>']
    for k in range(5):
        b, v = low + k * (high - low) / 4, least + k * (most - least) / 4
        parts.append(f'<text x="{px(b):.1f}" y="{height - bottom + 16}" text-anchor="middle">{b:.3g}</text>')
        parts.append(f'<text x="{x0 + left - 6}" y="{py(v) + 4:.1f}" text-anchor="end">{v:.3g}</text>')
        parts.append(f'<line x1="{x0 + left}" x2="{x0 + width - 16}" y1="{py(v):.1f}" y2="{py(v):.1f}" '
                     'stroke="#d8dee4"/>')
    parts.append(f'<text x="{x0 + width / 2:.0f}" y="{height - 6}" text-anchor="middle">{bounded}, at most</text>')
    for law in ALL:
        line = [r for r in certified if r["law"] == law and r["value"] <= most]
        if not line:
            continue
        colour = "#000" if law == "free" else colours[list(FAMILIES).index(law)]
        points = " ".join(f'{px(r["bound"]):.1f},{py(r["value"]):.1f}' for r in line)
        parts.append(f'<polyline points="{points}" fill="none" stroke="{colour}" '
                     f'stroke-width="{2.4 if law == "free" else 1.4}"/>')
    for row in own:
        if row["verdict"] == AS_IT_IS and least <= row["value"] <= most:
            parts.append(f'<circle cx="{px(row["bound"]):.1f}" cy="{py(row["value"]):.1f}" r="2.4" '
                         f'fill="#57606a"><title>{row["law"]}</title></circle>')
    return parts


def nearest_table(rows):
    """For each pair and bound the free spline's best value, or the limit that is known, and the family
    nearest to it."""
    lines = ["| pair | bound | free spline, or known limit | nearest family | its value | more |",
             "|---|--:|--:|---|--:|--:|"]
    for pair in PAIRS:
        of_pair = [r for r in rows if r["pair"] == pair and isinstance(r["value"], (int, float))]
        free = {r["bound"]: r["value"] for r in of_pair if r["law"] == "free"}
        for bound in sorted({r["bound"] for r in of_pair if r["verdict"] != AS_IT_IS}):
            limit = free.get(bound, PAIRS[pair].limit)
            others = [r for r in of_pair if r["law"] != "free" and r["bound"] <= bound + 1e-9]
            if not others:
                continue
            best = (max if PAIRS[pair].highest else min)(others, key=lambda r: r["value"])
            more = f"{100 * (best['value'] / limit - 1):.2f} %" if limit else "-"
            least = f"{limit:.5g}" if limit else "-"
            lines.append(f"| {pair} | {bound:g} | {least} | {best['law']} | {best['value']:.5g} | {more} |")
    return "\n".join(lines) + "\n"


def figure(rows):
    width, height = 430, 320
    pairs = [p for p in PAIRS if any(r["pair"] == p and r["value"] is not None for r in rows)]
    colours = ["#0b63b0", "#b35309", "#1a7f37", "#8250df", "#57606a", "#bf3989", "#9a6700", "#0a7d91",
               "#cf222e"]
    columns = 2
    lines = -(-(len(pairs) + 1) // columns)
    text = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {columns * width} {lines * height}" '
            'font-family="sans-serif" font-size="11" fill="#1b1f24">\n'
            f'<rect width="100%" height="100%" fill="#fff"/>\n')
    for k, pair in enumerate(pairs):
        text += f'<g transform="translate({k % columns * width} {k // columns * height})">\n'
        text += "\n".join(panel(pair, rows, 0, width, height)) + "\n</g>\n"
    k = len(pairs)
    text += f'<g transform="translate({k % columns * width + 60} {k // columns * height + 40})">\n'
    for i, law in enumerate(ALL):
        colour = "#000" if law == "free" else colours[i - 1]
        text += (f'<line x1="0" x2="26" y1="{i * 20}" y2="{i * 20}" stroke="{colour}" stroke-width="2"/>'
                 f'<text x="34" y="{i * 20 + 4}">{law}</text>\n')
    n = len(FAMILIES) + 1
    text += (f'<circle cx="13" cy="{n * 20}" r="2.4" fill="#57606a"/><text x="34" y="{n * 20 + 4}">'
             'a law of the catalogue as it is</text>\n</g>\n')
    return text + "</svg>\n"


def read_rows(path):
    if not path.exists():
        return []
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        row["bound"] = float(row["bound"])
        row["value"] = float(row["value"]) if row["value"] else None
    cut_short = {(r["pair"], r["law"]) for r in rows if r["verdict"] == "not done"}
    return [r for r in rows if (r["pair"], r["law"]) not in cut_short]


def write_rows(path, rows):
    """Whole or not at all, by pair, law and bound."""
    order = {pair: i for i, pair in enumerate(PAIRS)}
    rows = sorted(rows, key=lambda r: (order[r["pair"]], r["verdict"] == AS_IT_IS))
    beside = path.with_suffix(".new")
    with beside.open("w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({key: f"{value:.9g}" if isinstance(value, float) else value
                             for key, value in row.items()})
    beside.rename(path)


def rows_of_pair(program, pair, quick):
    rows = list(rows_of_fixed(program, pair))
    for law in PAIRS[pair].laws:
        rows += rows_of_front(program, pair, law, quick)
    return rows


def differences(program, pair, known):
    """What two bounds of each front have now that the rows of the atlas do not."""
    def place(row):
        return row["law"], row["verdict"] == AS_IT_IS, f"{row['bound']:.7g}"

    there = {place(r): r for r in known if r["pair"] == pair}
    searched = set()
    for row in rows_of_pair(program, pair, quick=True):
        searched.add(row["law"])
        old = there.get(place(row))
        name = f"{pair}, {row['law']} at {row['bound']:g}"
        if old is None:
            yield f"{name}: the atlas does not have it"
        elif row["verdict"] != old["verdict"]:
            yield f"{name}: {row['verdict']}, in the atlas {old['verdict']}"
        elif (row["value"] is None) != (old["value"] is None) or (
                row["value"] is not None and abs(row["value"] - old["value"]) > 1e-6 * abs(old["value"])):
            yield f"{name}: {row['value']}, in the atlas {old['value']}"
    for law in sorted({r["law"] for r in there.values()} - searched):
        yield f"{pair}, {law}: nothing was computed"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--camlaw", default=str(ROOT / "build/release/cli/camlaw"))
    parser.add_argument("--out", default=str(ROOT / "docs/atlas"))
    parser.add_argument("--only", choices=list(PAIRS), help="one pair of values")
    parser.add_argument("--resume", action="store_true", help="keep the fronts that the CSV has")
    parser.add_argument("--quick", action="store_true", help="two bounds of each front")
    parser.add_argument("--check", action="store_true", help="compare two bounds of each front with the CSV")
    options = parser.parse_args()
    out = pathlib.Path(options.out)
    if options.check:
        found = list(differences(options.camlaw, options.only or next(iter(PAIRS)), read_rows(out / "atlas.csv")))
        raise SystemExit("\n".join(found) if found else 0)
    out.mkdir(parents=True, exist_ok=True)
    table = out / "atlas.csv"
    rows = read_rows(table) if options.resume else []
    for pair in [options.only] if options.only else PAIRS:
        if not any(r["pair"] == pair and r["verdict"] == AS_IT_IS for r in rows):
            rows += rows_of_fixed(options.camlaw, pair)
        for law in PAIRS[pair].laws:
            if any(r["pair"] == pair and r["law"] == law and r["verdict"] != AS_IT_IS for r in rows):
                continue
            print(f"{pair}: {law}", file=sys.stderr, flush=True)
            rows += rows_of_front(options.camlaw, pair, law, options.quick)
            write_rows(table, rows)
    if options.quick or options.only:
        return
    (out / "atlas.svg").write_text(figure(rows))
    (out / "nearest.md").write_text("# Which family comes nearest to the limit\n\n" + nearest_table(rows))


if __name__ == "__main__":
    main()
