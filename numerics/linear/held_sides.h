// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "numerics/linear/quadratic_program.h"

namespace camlaw::optim {

/// Which bounds hold rows and variables: 1 the upper one, -1 the lower one, 0 neither.
struct HeldSides {
  std::vector<signed char> rows, variables;
};

/// What holds a solution: equations, and sides whose multipliers exceed what their rows and
/// variables have room for.
HeldSides held_sides(const QuadraticProgram& program, const InteriorSolution& solution);

/// Whether rows and curvature are local, so that the conditions of optimality have banded factors.
bool has_local_rows(const QuadraticProgram& program);

/// The optimum by a primal-dual active-set method (docs/optimisation.md, (XM9)) from a guess of
/// what holds it, in a few banded factorisations where the guess is nearly right. None where rows
/// are not local, where more sides change than of a guess that is nearly right, or where the
/// conditions of optimality are not met to about ten digits.
std::optional<InteriorSolution> solve_from_held_sides(const QuadraticProgram& program,
                                                      HeldSides guess);

}  // namespace camlaw::optim
