// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <utility>

#include "numerics/scalar/interval.h"
#include "optim/problem/automatic.h"

namespace camlaw::problems::detail {

/// A kernel with derivatives and enclosures from a callable that is generic in the scalar,
/// template <class T> T f(std::span<const T> u).
template <class F>
std::shared_ptr<const optim::Kernel> kernel_of(F f) {
  return std::make_shared<optim::AutomaticKernel<F, Interval>>(std::move(f));
}

}  // namespace camlaw::problems::detail
