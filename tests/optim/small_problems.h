// SPDX-License-Identifier: MIT
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "optim/problem/problem.h"

/// Words that the tests of search and verdict state their problems in.
namespace camlaw::optim::small_problems {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
using Point = std::vector<double>;
using Names = std::vector<std::string>;

/// Of intervals Boost's own, which is narrower, is found by the argument.
template <class T>
T square(const T& x) {
  return x * x;
}

inline Objective least(Function f) {
  return {{"cost", "N", std::move(f)}, Sense::Minimize, {}, {}};
}
inline Objective most(Function f) { return {{"gain", "N", std::move(f)}, Sense::Maximize, {}, {}}; }

}  // namespace camlaw::optim::small_problems
