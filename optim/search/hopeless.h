// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "optim/cycle/scales.h"
#include "optim/verdict/assessment.h"

/// Limits that no design meets: known without a search, or found to be enough by leaving out
/// others.
namespace camlaw::optim {

/// A limit that is passed whatever the design.
struct Hopeless {
  std::string limit;
  std::string why;     ///< "no variable changes it"
  std::string global;  ///< the same as a statement of every design; empty where none is proved
};

/// Looks for a limit that nothing moves which varies, or that is passed at a place of the cycle at
/// which the curve is enclosed as the same for every design. None where there is none.
std::optional<Hopeless> hopeless_limit(const Problem& problem, const Scales& scales);

/// The answer to a problem with fewer limits.
using SearchAgain = std::function<Assessment(const Problem&)>;

/// Of the limits that an infeasible answer blames, those are taken out of the blame without which
/// the others contradict one another, or the variables' bounds, as well: what is left is in each
/// other's way alone. The design and its limits stay.
void narrow_blame(Problem problem, const SearchAgain& search, Assessment& answer);

}  // namespace camlaw::optim
