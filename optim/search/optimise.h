// SPDX-License-Identifier: MIT
#pragma once

#include "optim/search/local.h"

/// The front door: a problem in, a judged design out.
namespace camlaw::optim {

/// The answer to a problem.
struct Optimum {
  std::vector<std::size_t> options;  ///< the option taken of each choice
  Problem problem;                   ///< the problem of those options
  Found found;                       ///< design, assessment, how it was found
  std::size_t combinations = 1;      ///< of options and integer values
  std::size_t solved = 1;            ///< of them, or of the nodes of a branch and bound
  double wall_s = 0;
};

/// Solves a problem: continuous variables by a local or global method from one or several starts,
/// choices and integer variables by enumeration, or by branch and bound where there are too many
/// combinations. The verdict is the code's own (optim/verdict). Throws std::invalid_argument for a
/// problem that is not well posed, for an unknown solver and for native options that it does not
/// accept.
Optimum optimise(const ProblemSpace& space, const OptimiseOptions& options = {});
Optimum optimise(const Problem& problem, const OptimiseOptions& options = {});

}  // namespace camlaw::optim
