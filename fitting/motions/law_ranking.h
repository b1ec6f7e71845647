// SPDX-License-Identifier: MIT
#pragma once

#include "fitting/motions/law_fit.h"

namespace camlaw::problems {

struct Ranking {
  std::vector<LawFit> fits;
  std::vector<std::string> untried = {};  ///< laws that the deadline left no time for
};

/// Those of the names that are not among the others yet join them.
void add_names(const std::vector<std::string>& names, std::vector<std::string>& others);

/// Each of the laws, as it is and skewed, by how likely it is; first of those that noise does not
/// tell from the best the one with the fewest numbers (law_choice.h). Laws that cannot be fitted
/// are left out. Intervals are those of each law alone. Laws of few coefficients come first; once
/// the deadline has passed and one law has been fitted, the others are not tried. Impossible where
/// bad_motion() finds a fault.
Possible<Ranking> possible_ranking(const MotionSamples& samples, const std::vector<Member>& laws,
                                   const MotionGuess& guess, const LawFitOptions& options = {});
/// The same; throws std::invalid_argument where it is impossible.
Ranking rank_fits(const MotionSamples& samples, const std::vector<Member>& laws,
                  const MotionGuess& guess, const LawFitOptions& options = {});

}  // namespace camlaw::problems
