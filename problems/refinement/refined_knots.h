// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "optim/search/optimise.h"
#include "problems/statement/statement.h"

/// Knots of a free law that are added where they gain something: what [free] knots = "auto" asks
/// for (docs/theory.md, "Adding knots where they help most").
namespace camlaw::problems {

/// An optimum with so many knots.
struct KnotRound {
  std::size_t knots;
  double objective;  ///< in its unit
  optim::Verdict verdict;
  int halvings = 1;  ///< of spans at once that led to these knots
};

struct RefinedKnots {
  std::vector<double> knots;      ///< inside (0, 1)
  optim::Optimum optimum;         ///< with these
  std::vector<KnotRound> rounds;  ///< one or more
  std::string ended;              ///< why no more were added, in words
  /// What the objective would still gain by further knots, in its unit, as the last rounds go on;
  /// an estimate. None where they do not shrink.
  std::optional<double> left = {};
};

/// Where a search begins.
enum class Begin {
  AsStated,  ///< from as many starts as are stated
  AtStart,   ///< from the statement's start alone
};

/// Searches one optimum of a statement.
using SearchOnce = std::function<optim::Optimum(const ProblemStatement& statement, Begin begin)>;

/// Searches with a few even knots and adds more, each in the middle of a span where the optimum's
/// highest derivative jumps most, and several towards a place where it grows without bound, until
/// two rounds in a row change the objective by less than 1e-5 of it, the objective is within 1e-4
/// of what theory says that no law passes, a round leads to nothing better, or `stop`, asked
/// between rounds, says so. Each round begins where the one before has ended; where a search has
/// several starts, the last knots are searched once more from these. The statement's knots become
/// the best round's (a setting "free.knots=[...]", with which results are read again). Throws
/// std::invalid_argument where a law is chosen.
RefinedKnots refine_knots(ProblemStatement& statement, const SearchOnce& search,
                          const std::function<bool()>& stop);

/// The same with optimise() in so many processes, within the search's time limit, of which so many
/// seconds are spent. `begins` is called before each round, with "knots, round 3".
RefinedKnots find_knots(ProblemStatement& statement, const optim::OptimiseOptions& search,
                        int workers, const std::function<double()>& spent,
                        const std::function<void(const std::string& stage)>& begins = {});

}  // namespace camlaw::problems
