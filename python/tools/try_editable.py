# SPDX-License-Identifier: MIT
"""Tries an editable installation: its sources are the clone's, its workers and plug-in are found.

python try_editable.py CLONE
"""

import sys
from pathlib import Path

import camlaw as cl
from camlaw.native import native

clone = Path(sys.argv[1]).resolve()
assert Path(cl.__file__).resolve() == clone / "python/camlaw/__init__.py", cl.__file__
front = cl.Problem.load(clone / "problems/spine_cutter/front.toml").pareto(points=6, workers=2)
assert front.complete and front.notes == [], front.notes
scouted = cl.Problem.load(clone / "problems/spine_cutter/front.toml").pareto(points=4, method="nsga2")
assert len(scouted) >= 4
print(cl.__version__, cl.__file__, native.__file__)
