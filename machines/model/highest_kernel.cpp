// SPDX-License-Identifier: MIT
#include "machines/model/highest_kernel.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "machines/model/inner_numbers.h"

namespace camlaw::problems {

using optim::Bounds, optim::Design, optim::Function;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Bounds times(double sign, const Bounds& b) { return sign > 0 ? b : Bounds{-b.upper, -b.lower}; }

Widened widened(const Binding& binding, const std::vector<ParameterRange>& ranges) {
  Widened result{binding, design_size(binding), {}};
  std::vector<std::pair<std::size_t, std::size_t>> varying;
  for (std::size_t k = 0; k < binding.parameters.size(); ++k) {
    varying.emplace_back(binding.parameters[k], binding.variables[k]);
  }
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    varying.emplace_back(ranges[i].parameter, result.first + i);
    result.box.push_back({ranges[i].lower, ranges[i].upper});
  }
  std::sort(varying.begin(), varying.end());
  result.binding.parameters.clear();
  result.binding.variables.clear();
  for (const auto& [parameter, variable] : varying) {
    result.binding.parameters.push_back(parameter);
    result.binding.variables.push_back(variable);
  }
  return result;
}

HighestKernel::HighestKernel(Function f, const Widened& wide, double sign)
    : f_(std::move(f)), first_(wide.first), box_(wide.box), sign_(sign), places_(places_of(box_)) {
  for (std::size_t k = 0; k < f_.inputs().size(); ++k) {
    (f_.inputs()[k] < first_ ? own_ : moved_).push_back(k);
  }
}

std::vector<std::size_t> HighestKernel::own_inputs() const {
  std::vector<std::size_t> inputs;
  for (const std::size_t k : own_) inputs.push_back(f_.inputs()[k]);
  return inputs;
}

double HighestKernel::value(std::span<const double> u) const {
  const Point p = worst(u);
  return settled(u, p, f_.value(design(u, p)));
}

bool HighestKernel::is_beside_pole(std::span<const double> u, const Point& p) const {
  constexpr double kBeside = 1e-7;  // of a range
  Box point, near;
  for (const double value : u) point.push_back({value, value});
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double room = kBeside * (box_[i].upper - box_[i].lower);
    near.push_back({std::max(box_[i].lower, p[i] - room), std::min(box_[i].upper, p[i] + room)});
  }
  const Bounds value = f_.range(widened_box(point, near)).value;
  return !(std::isfinite(value.lower) && std::isfinite(value.upper));
}

double HighestKernel::gradient(std::span<const double> u, std::span<double> g) const {
  std::vector<double> all(f_.inputs().size());
  const Point p = worst(u);
  const double value = settled(u, p, f_.gradient(design(u, p), all));
  for (std::size_t k = 0; k < own_.size(); ++k) g[k] = std::isnan(value) ? kNaN : all[own_[k]];
  return value;
}

double HighestKernel::hessian(std::span<const double> u, std::span<double> g,
                              std::span<double> h) const {
  const std::size_t n = f_.inputs().size();
  std::vector<double> all(n), second(optim::packed_size(n));
  const Point p = worst(u);
  const double value = settled(u, p, f_.hessian(design(u, p), all, second));
  if (std::isnan(value)) {
    std::fill(g.begin(), g.end(), kNaN);
    std::fill(h.begin(), h.end(), kNaN);
    return value;
  }
  const auto at = [&](std::size_t i, std::size_t k) -> double& {
    return second[optim::packed(std::max(i, k), std::min(i, k))];
  };
  // Ranges within which the place lies are eliminated one after the other.
  for (const std::size_t m : moved_) {
    const std::size_t range = f_.inputs()[m] - first_;
    const bool inside = p[range] > box_[range].lower && p[range] < box_[range].upper;
    const double bend = at(m, m);
    if (!inside || bend == 0) continue;
    const std::vector<double> column = [&] {
      std::vector<double> c(n);
      for (std::size_t i = 0; i < n; ++i) c[i] = at(i, m);
      return c;
    }();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = 0; k <= i; ++k) at(i, k) -= column[i] * column[k] / bend;
    }
  }
  for (std::size_t i = 0; i < own_.size(); ++i) {
    g[i] = all[own_[i]];
    for (std::size_t k = 0; k <= i; ++k) h[optim::packed(i, k)] = at(own_[i], own_[k]);
  }
  return value;
}

Bounds HighestKernel::enclose(std::span<const double> u) const {
  Box box;
  for (const double value : u) box.push_back({value, value});
  return range(box).value;
}

optim::BoxRange HighestKernel::range(std::span<const Bounds> box) const {
  constexpr Division kDivision{.halvings = 14, .parts = 1000};
  const auto over = [&](const Box& ranges) {
    const optim::BoxRange all = f_.range(widened_box(box, ranges));
    OverBox result{times(sign_, all.value), std::vector<Bounds>(ranges.size(), Bounds{0, 0})};
    for (const std::size_t m : moved_) {
      result.slopes[f_.inputs()[m] - first_] = times(sign_, all.slopes[m]);
    }
    return result;
  };
  const auto at = [&](const Point& p) {
    Box point;
    for (const double value : p) point.push_back({value, value});
    return times(sign_, f_.range(widened_box(box, point)).value);
  };
  optim::BoxRange result;
  result.value = times(sign_, highest_within(box_, kDivision, at, over));
  const optim::BoxRange whole = f_.range(widened_box(box, box_));
  for (const std::size_t k : own_) result.slopes.push_back(whole.slopes[k]);
  return result;
}

std::string HighestKernel::why_undefined(std::span<const double> u) const {
  for (const Point& p : places_) {
    if (std::string why = f_.why_undefined(design(u, p)); !why.empty()) return why;
  }
  return {};
}

Point HighestKernel::worst(std::span<const double> u) const {
  return climb(
      highest_place(places_, [&](const Point& p) { return sign_ * f_.value(design(u, p)); }), u);
}

double HighestKernel::settled(std::span<const double> u, const Point& p, double value) const {
  constexpr double kSteep = 1e6;  // times another value: what rises so far may have a pole
  const double other = std::abs(f_.value(design(u, places_.front())));
  if (std::abs(value) <= kSteep * other) return value;
  return is_beside_pole(u, p) ? kNaN : value;
}

Point HighestKernel::climb(const Point& from, std::span<const double> u) const {
  return climbed(from, box_, [&](const Point& p) {
    const std::size_t n = f_.inputs().size();
    std::vector<double> all(n), second(optim::packed_size(n));
    Slopes result{sign_ * f_.hessian(design(u, p), all, second), Point(box_.size()),
                  Point(optim::packed_size(box_.size()))};
    for (const std::size_t m : moved_) {
      const std::size_t i = f_.inputs()[m] - first_;
      result.first[i] = sign_ * all[m];
      result.second[optim::packed(i, i)] = sign_ * second[optim::packed(m, m)];
    }
    return result;
  });
}

std::vector<double> HighestKernel::design(std::span<const double> u, const Point& p) const {
  std::vector<double> x(first_ + p.size());
  for (std::size_t k = 0; k < own_.size(); ++k) x[f_.inputs()[own_[k]]] = u[k];
  std::copy(p.begin(), p.end(), x.begin() + static_cast<std::ptrdiff_t>(first_));
  return x;
}

std::vector<Bounds> HighestKernel::widened_box(std::span<const Bounds> u, const Box& ranges) const {
  std::vector<Bounds> all(first_ + ranges.size(), Bounds{0, 0});
  for (std::size_t k = 0; k < own_.size(); ++k) all[f_.inputs()[own_[k]]] = u[k];
  std::copy(ranges.begin(), ranges.end(), all.begin() + static_cast<std::ptrdiff_t>(first_));
  return all;
}

Function highest_of(const Function& f, const Widened& wide, double sign) {
  auto kernel = std::make_shared<HighestKernel>(f, wide, sign);
  std::vector<std::size_t> inputs = kernel->own_inputs();
  return {std::move(inputs), std::move(kernel)};
}

Point told(const Function& f, const Widened& wide, Design x, const Point& p) {
  constexpr double kSame = 1e-12;
  const double value = f.value(wide.design(x, p));
  Point result = p;
  for (std::size_t i = 0; i < p.size(); ++i) {
    bool is_same = true;
    for (const double end : {wide.box[i].lower, wide.box[i].upper}) {
      Point other = p;
      other[i] = end;
      is_same &= std::abs(f.value(wide.design(x, other)) - value) <= kSame * std::abs(value);
    }
    if (is_same) result[i] = kNaN;
  }
  return result;
}

}  // namespace camlaw::problems
