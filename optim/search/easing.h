// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "optim/problem/problem.h"
#include "optim/search/optimise.h"

/// What would cure limits that cannot be met: by how much each of them has to be eased
/// (docs/optimisation.md LV5).
namespace camlaw::optim {

/// A limit, or a bound of a variable, that alone has to be eased so that a design meets all others.
struct Easing {
  std::string name;  ///< of the response or the variable
  std::string unit;
  bool is_bound = false;  ///< of a variable, else of a limit
  bool is_upper = true;   ///< the side
  double bound = 0;       ///< as it is, in the unit
  double by = 0;          ///< the least that helps, above 0
  std::vector<double> x;  ///< a design that then meets every limit

  bool operator==(const Easing&) const = default;
};

/// The answer to another problem from its start.
using SearchFromStart = std::function<Found(const Problem&)>;

/// Of each limit and each bound that an infeasible answer blames, by how much it has to be eased if
/// it alone is: the limit's response becomes the objective, the others stay. Left out are
/// those for which the search found no design, or one at which the problem's own objective has no
/// value; equations; and bounds of integers. At most `kMostEased` are looked at.
std::vector<Easing> easings(const Problem& problem, const Found& infeasible,
                            const SearchFromStart& search);

/// What was found of them, and what was not looked for.
struct FoundEasings {
  std::vector<Easing> all;
  std::string cut_short;  ///< why some were not looked for to the end; empty where all were
};

/// The same with one search each, by the solver of `options`, from the design of least violation.
/// Nothing of large problems, whose searches take long. With a time limit they take half of what is
/// left of it at most: what comes after them has the rest.
FoundEasings easings(const Problem& problem, const Found& infeasible, OptimiseOptions options);

/// Each takes a search; of the limits that contradict one another few are of use to who has to
/// decide which to ease.
inline constexpr std::size_t kMostEased = 4;

}  // namespace camlaw::optim
