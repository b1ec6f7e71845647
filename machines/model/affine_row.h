// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "numerics/scalar/interval.h"
#include "optim/problem/automatic.h"

namespace camlaw::problems {

/// constant + sum of slopes * u.
class AffineRow final : public optim::Kernel {
 public:
  /// `behind` and `slopes_behind`: what the constant and any slope are summed from, in |terms|.
  AffineRow(double constant, std::vector<double> slopes, double behind, double slopes_behind)
      : constant_(constant),
        slopes_(std::move(slopes)),
        behind_(behind),
        slopes_behind_(slopes_behind) {}

  double value(std::span<const double> u) const override {
    double sum = constant_;
    for (std::size_t i = 0; i < u.size(); ++i) sum += slopes_[i] * u[i];
    return sum;
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::copy(slopes_.begin(), slopes_.end(), g.begin());
    return value(u);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::fill_n(h.begin(), optim::packed_size(u.size()), 0.0);
    return gradient(u, g);
  }
  optim::BoxRange range(std::span<const optim::Bounds> box) const override {
    constexpr double kRounding = 1e-12;  // of the terms of the sum, and of those behind them
    optim::BoxRange result{{}, {}};
    Interval sum(constant_);
    double terms = behind_;
    const double widened = kRounding * slopes_behind_;
    for (std::size_t i = 0; i < box.size(); ++i) {
      sum += slopes_[i] * Interval(box[i].lower, box[i].upper);
      terms += slopes_behind_ * std::max(std::abs(box[i].lower), std::abs(box[i].upper));
      result.slopes.push_back({slopes_[i] - widened, slopes_[i] + widened});
    }
    sum += kRounding * terms * Interval(-1, 1);
    result.value = optim::bounds_of(sum);
    return result;
  }

 private:
  double constant_;
  std::vector<double> slopes_;
  double behind_, slopes_behind_;
};

}  // namespace camlaw::problems
