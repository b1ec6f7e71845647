// SPDX-License-Identifier: MIT
#include "optim/fit/loss.h"

#include <cmath>

namespace camlaw::optim {
namespace {

bool finite(std::span<const double> values) {
  return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
}

}  // namespace

LossAt loss_at(Loss loss, double scale, double r) {
  const double t = r / scale, size = std::abs(t);
  if (loss == Loss::Huber && size > 1) {
    return {scale * scale * (2 * size - 1), 1 / size, std::copysign(scale, r), 0};
  }
  if (loss == Loss::Cauchy) {
    const double weight = 1 / (1 + t * t);
    return {scale * scale * std::log1p(t * t), weight, weight * r, (1 - t * t) * weight * weight};
  }
  return {r * r, 1, r, 1};
}

double efficient_scale(Loss loss) { return loss == Loss::Huber ? 1.345 : 2.385; }

bool LossResiduals::evaluate(std::span<const double> p, std::span<double> r,
                             std::span<double> jacobian) const {
  ++evaluations_;
  if (!residuals_.evaluate(p, r, jacobian) || !finite(r) || !finite(jacobian)) return false;
  if (loss_ == Loss::None) return true;
  for (std::size_t i = 0; i < r.size(); ++i) {
    const LossAt at = loss_at(loss_, scale_, r[i]);
    const double root = std::copysign(std::sqrt(at.rho), r[i]);
    // d sqrt(rho) / dr = psi / sqrt(rho), which tends to 1 at r = 0.
    const double slope = root == 0 ? 1 : at.pull / root;
    r[i] = root;
    if (jacobian.empty()) continue;
    for (double& d : jacobian.subspan(i * p.size(), p.size())) d *= slope;
  }
  return true;
}

}  // namespace camlaw::optim
