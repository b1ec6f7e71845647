# SPDX-License-Identifier: MIT
"""Problems within other people's studies: SciPy, pymoo, pygmo, OpenMDAO.

Each module needs its library, which is not installed with camlaw. Objectives are minimised,
whichever way the problem seeks them, and limits become margins: peaks over the whole cycle, found
and not proved. So check the result of such a study with Problem.evaluate, which proves it.
"""
