# SPDX-License-Identifier: MIT
"""Tries an installed package: laws, a search, a front with workers, and where its libraries are.

python try_wheel.py FOLDER      of problem files
"""

import sys
from pathlib import Path

import camlaw as cl
import numpy as np

problems = Path(sys.argv[1])
package = Path(cl.__file__).parent
assert "site-packages" in str(package), package

law = cl.law("modified-sine", crossover=0.42)
assert abs(law(np.linspace(0, 1, 5)).s[-1] - 1) < 1e-15
result = cl.Problem.load(problems / "cams/roller_least_base.toml").optimize()
assert result.verdict == "certified optimum" and abs(result["base_radius"] - 52.64791933) < 1e-7
assert cl.Problem.load(problems / "cams/roller_least_base.toml").optimize(solver="ipopt").certified
front = cl.Problem.load(problems / "spine_cutter/front.toml").pareto(points=6, workers=2)
assert front.complete and front.notes == [], front.notes
scouted = cl.Problem.load(problems / "spine_cutter/front.toml").pareto(points=4, method="nsga2")
assert len(scouted) >= 4
assert result.report().startswith("<!DOCTYPE html>")
with open("/proc/self/maps", encoding="utf-8") as maps:
    theirs = {line.split()[-1] for line in maps if ".so" in line}
# What it needs of linear algebra comes with it, and is the reference.
algebra = [library for library in theirs if "blas" in library or "lapack" in library]
own = [library for library in algebra if "camlaw.libs" in library]
others = [name for name in theirs if any(one in name for one in ("atlas", "openblas", "mkl", "blis"))]
others = [name for name in others if "numpy" not in name]  # which brings its own
assert len(own) >= 2 and others == [], (algebra, others)
print(cl.__version__, package)
for library in sorted(theirs):
    if any(name in library for name in ("ipopt", "nlopt", "ceres", "blas", "lapack", "mumps")):
        print(library)
