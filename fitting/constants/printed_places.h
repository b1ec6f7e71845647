// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fitting/motions/law_limits.h"

/// Values of the unknowns to begin a search at (docs/optimisation.md, (FS8)).
namespace camlaw::problems {

/// An unknown between its bounds by a coordinate from 0 to 1, which is even within `size` of the
/// default value and beyond it even in the logarithm of the distance.
struct SearchScale {
  double lower, upper, about, size;

  double at(double coordinate) const;
  double coordinate(double x) const;
};

/// Places that fill the bounds, ends included, and the room that a linear limit leaves, with its
/// edges and corners. The first is where the unknowns have their default values. Equal inputs,
/// equal places. Factors of the limit are those of the unknowns from `first_of_law` on.
std::vector<std::vector<double>> search_places(const std::vector<SearchScale>& unknowns,
                                               const std::optional<LawLimit>& limit,
                                               std::size_t first_of_law);

}  // namespace camlaw::problems
