// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <set>
#include <vector>

#include "problems/statement/statement.h"

namespace camlaw::problems {

/// The machine's parameters that the objective and the constraints depend on; all, where there are
/// neither.
std::set<std::size_t> used_parameters(const ProblemStatement& problem);
/// Whether a parameter has one value that nothing else decides: no variable, load case, range or
/// part that is chosen.
bool is_constant(const ProblemStatement& problem, std::size_t parameter);
/// The used parameters whose values are the mechanism's own, because neither the file nor its
/// motion nor a part states them.
std::vector<std::size_t> left_to_defaults(const ProblemStatement& problem);

}  // namespace camlaw::problems
