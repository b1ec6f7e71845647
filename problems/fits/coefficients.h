// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "problems/mechanism/law_binding.h"

namespace camlaw::problems {

/// A number of a law that a fit adjusts.
struct Coefficient {
  LawVariable at;
  std::string name, unit;  ///< "alpha", of a list "c[2]"
  double low, high;        ///< accepted values
  double value;            ///< of the member
};

/// All numbers of a law but the crossover and what shapes its data; the variables behind them are
/// counted from `first`.
std::vector<Coefficient> coefficients_of(const Member& law, std::size_t first = 0);

}  // namespace camlaw::problems
