# SPDX-License-Identifier: MIT
"""Problems within other people's studies: SciPy, pymoo, pygmo, OpenMDAO.

Each module needs its library, which is not installed with camlaw. Objectives are made small,
whichever way the problem seeks them, and limits become margins: peaks over the whole cycle, found
and not proved. So what such a study comes to is worth a look by Problem.evaluate, which proves it.
"""
