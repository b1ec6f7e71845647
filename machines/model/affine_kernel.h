// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <vector>

#include "numerics/scalar/interval.h"
#include "optim/problem/automatic.h"

namespace camlaw::problems {

/// A kernel that is known to be affine: value and slopes at one point, worked out when they are
/// first needed, say all. Encloses as the kernel that it stands for.
class AffineKernel final : public optim::Kernel {
 public:
  AffineKernel(std::shared_ptr<const optim::Kernel> exact, std::vector<double> origin)
      : exact_(std::move(exact)), origin_(std::move(origin)) {}

  double value(std::span<const double> u) const override {
    std::call_once(made_, [&] {
      slopes_.resize(origin_.size());
      value_ = exact_->gradient(origin_, slopes_);
    });
    double sum = value_;
    for (std::size_t i = 0; i < u.size(); ++i) sum += slopes_[i] * (u[i] - origin_[i]);
    return sum;
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    const double result = value(u);
    std::copy(slopes_.begin(), slopes_.end(), g.begin());
    return result;
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::fill_n(h.begin(), optim::packed_size(u.size()), 0.0);
    return gradient(u, g);
  }
  optim::Bounds enclose(std::span<const double> u) const override { return exact_->enclose(u); }
  optim::BoxRange range(std::span<const optim::Bounds> box) const override {
    constexpr double kRounding = 1e-13;  // of the terms of the sum
    optim::BoxRange result{{}, {}};
    const double centre = value(origin_);
    Interval sum(centre);
    double terms = std::abs(centre);
    for (std::size_t i = 0; i < box.size(); ++i) {
      sum += slopes_[i] * (Interval(box[i].lower, box[i].upper) - origin_[i]);
      terms += std::abs(slopes_[i]) *
               (std::max(std::abs(box[i].lower), std::abs(box[i].upper)) + std::abs(origin_[i]));
      result.slopes.push_back({slopes_[i], slopes_[i]});
    }
    sum += kRounding * terms * Interval(-1, 1);
    result.value = optim::bounds_of(sum);
    return result;
  }
  bool is_enclosed() const override { return exact_->is_enclosed(); }

 private:
  std::shared_ptr<const optim::Kernel> exact_;
  std::vector<double> origin_;
  mutable std::once_flag made_;
  mutable std::vector<double> slopes_;
  mutable double value_ = 0;
};

}  // namespace camlaw::problems
