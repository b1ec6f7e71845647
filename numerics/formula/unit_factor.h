// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "numerics/formula/expression.h"

namespace camlaw {

/// The conversion from one unit to another of the same kind, asked of udunits once.
class UnitFactor {
 public:
  /// Throws std::invalid_argument where the units are of different kinds.
  UnitFactor(const std::string& from, const std::string& to);

  /// The factor; an interval encloses the true one, which udunits gives to the last digits.
  template <class T>
  T as() const {
    const double wide = factor_ == 1 ? 0 : 4 * std::numeric_limits<double>::epsilon() * factor_;
    if constexpr (std::is_same_v<T, Interval>) {
      return {factor_ - wide, factor_ + wide};
    } else if constexpr (std::is_same_v<T, Expression>) {
      return {factor_, factor_ - wide, factor_ + wide};
    } else {
      return number<T>(factor_);
    }
  }

 private:
  double factor_;
};

}  // namespace camlaw
