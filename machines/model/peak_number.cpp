// SPDX-License-Identifier: MIT
#include "machines/model/peak_number.h"

namespace camlaw::problems::detail {

using optim::packed, optim::packed_size;

std::vector<double> PeakNumberKernel::arguments(std::span<const double> u, double peak) const {
  std::vector<double> result;
  for (const std::size_t variable : variables_) result.push_back(u[variable]);
  result.push_back(peak);
  return result;
}

double PeakNumberKernel::gradient(std::span<const double> u, std::span<double> g) const {
  std::vector<double> own(variables_.size() + 1);
  const double top = peak_.gradient(u, g);
  const double result = outer_->gradient(arguments(u, top), own);
  for (double& slope : g) slope *= own.back();
  for (std::size_t k = 0; k < variables_.size(); ++k) g[variables_[k]] += own[k];
  return result;
}

/// With f(m, p) and the peak p(u): f_p p_uu + f_pp p_u p_u^T + f_pm p_u^T + p_u f_pm^T + f_mm.
double PeakNumberKernel::hessian(std::span<const double> u, std::span<double> g,
                                 std::span<double> h) const {
  const std::size_t machine = variables_.size();
  std::vector<double> own(machine + 1), second(packed_size(machine + 1)), slopes(u.size());
  const double top = peak_.hessian(u, slopes, h);
  const double result = outer_->hessian(arguments(u, top), own, second);
  const double bend = second[packed(machine, machine)];
  std::vector<double> mixed(u.size(), 0.0);
  for (std::size_t k = 0; k < machine; ++k) mixed[variables_[k]] += second[packed(machine, k)];
  for (std::size_t i = 0; i < u.size(); ++i) {
    g[i] = own.back() * slopes[i];
    for (std::size_t k = 0; k <= i; ++k) {
      double& here = h[packed(i, k)];
      here = own.back() * here + bend * slopes[i] * slopes[k] + mixed[i] * slopes[k] +
             slopes[i] * mixed[k];
    }
  }
  for (std::size_t a = 0; a < machine; ++a) {
    g[variables_[a]] += own[a];
    for (std::size_t b = 0; b <= a; ++b) {
      const auto [low, high] = std::minmax(variables_[a], variables_[b]);
      const double twice = a != b && low == high ? 2 : 1;  // one variable behind both
      h[packed(high, low)] += twice * second[packed(a, b)];
    }
  }
  return result;
}

optim::Bounds PeakNumberKernel::enclose(std::span<const double> u) const {
  const optim::Bounds bounds = peak_.enclose(u);
  const std::vector<double> plain = arguments(u, 0);
  std::vector<Interval> own(plain.begin(), plain.end());
  own.back().assign(bounds.lower, bounds.upper);
  const Interval result = recorded_(std::span<const Interval>(own));
  return {result.lower(), result.upper()};
}

}  // namespace camlaw::problems::detail
