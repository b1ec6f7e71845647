// SPDX-License-Identifier: MIT
#include "fitting/motions/same_motion.h"

#include <cmath>

namespace camlaw::problems {

bool same_motion(const Member& a, const Member& b) {
  constexpr int kPlaces = 64;     // laws that differ do so at most of as many places
  constexpr double kSame = 1e-9;  // of the stroke: rounding of two formulas for one law
  const Law<double> first = a.law(), second = b.law();
  for (int i = 0; i < kPlaces; ++i) {
    const double x = (i + 0.5) / kPlaces;
    const double s = first.derivatives<1>(x, Side::Left)[0];
    if (!(std::abs(s - second.derivatives<1>(x, Side::Left)[0]) < kSame)) return false;
  }
  return true;
}

}  // namespace camlaw::problems
