// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fitting/motions/law_fit.h"
#include "machines/model/law_binding.h"

namespace camlaw::problems {

/// A number of a law that a fit adjusts.
struct Coefficient {
  LawVariable at;
  std::string name, unit;  ///< "alpha", of a list "c[2]"
  double low, high;        ///< accepted values
  double value;            ///< of the member
};

/// All numbers of a law but what shapes its data, the crossover only where it is free; the
/// variables behind them are counted from `first`.
std::vector<Coefficient> coefficients_of(const Member& law, std::size_t first = 0,
                                         Skew skew = Skew::Held);

/// Whether a law has a crossover that none of its other numbers stand for: those of symmetric
/// families.
bool can_be_skewed(const Member& law);

}  // namespace camlaw::problems
