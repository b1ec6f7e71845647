// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optim/search/optimise.h"
#include "problems/statement/statement.h"

/// Knots of a free law that are added where they gain something: what [free] knots = "auto" asks
/// for (docs/theory.md, "Knots where they gain").
namespace camlaw::problems {

/// An optimum with so many knots.
struct KnotRound {
  std::size_t knots;
  double objective;  ///< in its unit
  optim::Verdict verdict;
};

struct RefinedKnots {
  std::vector<double> knots;      ///< inside (0, 1)
  std::vector<KnotRound> rounds;  ///< one or more
  std::string ended;              ///< why no more were added, in words
  /// What the objective would still gain by further knots, in its unit, as the last rounds go on;
  /// an estimate. None where they do not shrink.
  std::optional<double> left = {};
};

/// Searches one optimum of a statement.
using SearchOnce = std::function<optim::Optimum(const ProblemStatement& statement)>;

/// Searches with a few even knots and adds more, each in the middle of a span where the optimum's
/// highest derivative jumps most, until they change the objective by less than 1e-5 of it. The
/// statement's knots become these (a setting "free.knots=[...]", with which results are read
/// again). `stop` is asked between rounds. Throws std::invalid_argument where a law is chosen, or
/// knots move.
RefinedKnots refine_knots(ProblemStatement& statement, const SearchOnce& search,
                          const std::function<bool()>& stop);

/// The same with optimise() in so many processes, as long as less than half of the search's time
/// limit is spent.
RefinedKnots find_knots(ProblemStatement& statement, const optim::OptimiseOptions& search,
                        int workers, const std::function<double()>& spent);

}  // namespace camlaw::problems
