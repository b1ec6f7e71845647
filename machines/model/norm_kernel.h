// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "optim/problem/function.h"

namespace camlaw::problems {

/// sqrt(a^2 + b^2) of two affine kernels of the same inputs: convex. Where both vanish, slopes and
/// curvature are given as 0, which is one of the slopes that a cone has at its tip.
class NormKernel final : public optim::Kernel {
 public:
  /// `exact` gives the enclosure.
  NormKernel(std::shared_ptr<const optim::Kernel> a, std::shared_ptr<const optim::Kernel> b,
             std::shared_ptr<const optim::Kernel> exact)
      : a_(std::move(a)), b_(std::move(b)), exact_(std::move(exact)) {}

  double value(std::span<const double> u) const override {
    return std::hypot(a_->value(u), b_->value(u));
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    return at(u, g).norm;
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    const Slopes s = at(u, g);
    std::fill_n(h.begin(), optim::packed_size(u.size()), 0.0);
    if (s.norm == 0) return 0;
    // (a' a'^T + b' b'^T - n' n'^T) / n = w w^T / n with w = (a b' - b a') / n.
    std::vector<double> w(u.size());
    for (std::size_t i = 0; i < w.size(); ++i) w[i] = (s.a * s.of_b[i] - s.b * s.of_a[i]) / s.norm;
    for (std::size_t i = 0; i < w.size(); ++i) {
      for (std::size_t k = 0; k <= i; ++k) h[optim::packed(i, k)] = w[i] * w[k] / s.norm;
    }
    return s.norm;
  }
  optim::Bounds enclose(std::span<const double> u) const override { return exact_->enclose(u); }
  bool is_enclosed() const override { return exact_->is_enclosed(); }

 private:
  struct Slopes {
    double a, b, norm;
    std::vector<double> of_a, of_b;
  };

  Slopes at(std::span<const double> u, std::span<double> g) const {
    Slopes s{0, 0, 0, std::vector<double>(u.size()), std::vector<double>(u.size())};
    s.a = a_->gradient(u, s.of_a);
    s.b = b_->gradient(u, s.of_b);
    s.norm = std::hypot(s.a, s.b);
    for (std::size_t i = 0; i < u.size(); ++i) {
      g[i] = s.norm == 0 ? 0 : (s.a * s.of_a[i] + s.b * s.of_b[i]) / s.norm;
    }
    return s;
  }

  std::shared_ptr<const optim::Kernel> a_, b_, exact_;
};

}  // namespace camlaw::problems
