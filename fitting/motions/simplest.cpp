// SPDX-License-Identifier: MIT
#include "fitting/motions/simplest.h"

#include <algorithm>
#include <cmath>

namespace camlaw::problems {
namespace {

int significant(double whole) {
  int digits = 0;
  for (double left = std::abs(whole); left >= 1; left = std::floor(left / 10)) {
    if (digits > 0 || std::fmod(left, 10) != 0) ++digits;
  }
  return std::max(digits, 1);
}

}  // namespace

SimpleNumber simplest_between(double low, double high) {
  // Digits that tell any double. Fractions up to twelfths are what designers write, and cost as
  // much as two digits.
  constexpr int kMostDigits = 17, kDenominators = 12, kOfFraction = 2;
  if (low <= 0 && high >= 0) return {0, 1};
  const double middle = low + (high - low) / 2;
  SimpleNumber best{middle, kMostDigits};
  const int size = static_cast<int>(std::floor(std::log10(std::abs(middle))));
  for (int place = size + 1; place > size - kMostDigits; --place) {
    const double unit = std::pow(10.0, place);
    const double whole = std::round(middle / unit);
    // Of a power of ten below one, dividing by its inverse gives the number as it is read.
    const double value = place < 0 ? whole / std::pow(10.0, -place) : whole * unit;
    if (value == 0 || !(value >= low && value <= high)) continue;
    best = {value, significant(whole)};
    break;
  }
  for (int q = 2; q <= kDenominators && best.digits > kOfFraction; ++q) {
    const double value = std::round(middle * q) / q;
    if (value >= low && value <= high && std::abs(middle * q) < 100) best = {value, kOfFraction};
  }
  return best;
}

}  // namespace camlaw::problems
