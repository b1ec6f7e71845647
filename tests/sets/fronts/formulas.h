// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "numerics/scalar/interval.h"
#include "optim/problem/automatic.h"

/// What the formulas of known fronts share.
namespace camlaw::sets {

inline constexpr double kPi = std::numbers::pi;

template <class T>
T square(const T& x) {
  return x * x;
}

/// A formula of the first variables, enclosed too.
template <class F>
optim::Function formula(std::size_t variables, F f, optim::Shape shape = optim::Shape::General) {
  std::vector<std::size_t> inputs(variables);
  std::iota(inputs.begin(), inputs.end(), std::size_t{0});
  return optim::function<Interval>(std::move(inputs), std::move(f), shape);
}

}  // namespace camlaw::sets
