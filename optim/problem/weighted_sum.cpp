// SPDX-License-Identifier: MIT
#include "optim/problem/weighted_sum.h"

#include <algorithm>
#include <cmath>

namespace camlaw::optim {
namespace {

/// Bounds of a sum of `count` products as rounded: what rounding may have moved is a share of their
/// sizes.
Bounds widened(Bounds sum, double sizes, std::size_t count) {
  constexpr double kOfOne = 4e-16;  // two operations of 2^-53 each, and more
  const double room = static_cast<double>(count + 2) * kOfOne * sizes;
  return {sum.lower - room, sum.upper + room};
}

double size_of(const Bounds& b) { return std::max(std::abs(b.lower), std::abs(b.upper)); }

class SumKernel final : public Kernel {
 public:
  /// Inputs of the parts count within the inputs of the sum.
  SumKernel(std::vector<Function> parts, std::vector<double> weights)
      : parts_(std::move(parts)), weights_(std::move(weights)) {}

  double value(std::span<const double> u) const override {
    double sum = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) sum += weights_[i] * parts_[i].value(u);
    return sum;
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::fill(g.begin(), g.end(), 0.0);
    double sum = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const auto& inputs = parts_[i].inputs();
      std::vector<double> own(inputs.size());
      sum += weights_[i] * parts_[i].gradient(u, own);
      for (std::size_t k = 0; k < inputs.size(); ++k) g[inputs[k]] += weights_[i] * own[k];
    }
    return sum;
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::fill(g.begin(), g.end(), 0.0);
    std::fill(h.begin(), h.end(), 0.0);
    double sum = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const auto& inputs = parts_[i].inputs();
      std::vector<double> own(inputs.size()), second(packed_size(inputs.size()));
      sum += weights_[i] * parts_[i].hessian(u, own, second);
      for (std::size_t k = 0; k < inputs.size(); ++k) {
        g[inputs[k]] += weights_[i] * own[k];
        for (std::size_t m = 0; m <= k; ++m) {
          h[packed(inputs[k], inputs[m])] += weights_[i] * second[packed(k, m)];
        }
      }
    }
    return sum;
  }
  Bounds enclose(std::span<const double> u) const override {
    Bounds sum{0, 0};
    double sizes = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const Bounds part = parts_[i].enclose(u);
      sum.lower += weights_[i] * part.lower;
      sum.upper += weights_[i] * part.upper;
      sizes += weights_[i] * size_of(part);
    }
    return std::isfinite(sizes) ? widened(sum, sizes, parts_.size()) : Bounds{};
  }
  BoxRange range(std::span<const Bounds> box) const override {
    BoxRange sum{{0, 0}, std::vector<Bounds>(box.size(), Bounds{0, 0})};
    double sizes = 0;
    std::vector<double> slope_sizes(box.size());
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const BoxRange part = parts_[i].range(box);
      sum.value.lower += weights_[i] * part.value.lower;
      sum.value.upper += weights_[i] * part.value.upper;
      sizes += weights_[i] * size_of(part.value);
      for (std::size_t k = 0; k < part.slopes.size(); ++k) {
        const std::size_t input = parts_[i].inputs()[k];
        sum.slopes[input].lower += weights_[i] * part.slopes[k].lower;
        sum.slopes[input].upper += weights_[i] * part.slopes[k].upper;
        slope_sizes[input] += weights_[i] * size_of(part.slopes[k]);
      }
    }
    sum.value = std::isfinite(sizes) ? widened(sum.value, sizes, parts_.size()) : Bounds{};
    for (std::size_t k = 0; k < box.size(); ++k) {
      sum.slopes[k] = std::isfinite(slope_sizes[k])
                          ? widened(sum.slopes[k], slope_sizes[k], parts_.size())
                          : Bounds{};
    }
    return sum;
  }
  bool is_searched() const override { return any(&Function::is_searched); }
  bool is_enclosed() const override {
    return std::all_of(parts_.begin(), parts_.end(),
                       [](const Function& part) { return part.is_enclosed(); });
  }
  std::shared_ptr<const Kernel> proved() const override {
    if (!is_searched()) return nullptr;
    std::vector<Function> proved;
    for (const Function& part : parts_) proved.push_back(part.proved());
    return std::make_shared<SumKernel>(std::move(proved), weights_);
  }
  std::string why_undefined(std::span<const double> u) const override {
    for (const Function& part : parts_) {
      if (std::string why = part.why_undefined(u); !why.empty()) return why;
    }
    return {};
  }

 private:
  bool any(bool (Function::*is)() const) const {
    return std::any_of(parts_.begin(), parts_.end(),
                       [is](const Function& part) { return (part.*is)(); });
  }

  std::vector<Function> parts_;
  std::vector<double> weights_;
};

/// The shape of a sum with positive weights.
Shape shape_of(const std::vector<Function>& parts) {
  const auto all = [&](bool (*is)(Shape)) {
    return std::all_of(parts.begin(), parts.end(),
                       [is](const Function& part) { return is(part.shape()); });
  };
  if (all(is_convex)) return all(is_concave) ? Shape::Linear : Shape::Convex;
  return all(is_concave) ? Shape::Concave : Shape::General;
}

}  // namespace

Function weighted_sum(const std::vector<Function>& parts, const std::vector<double>& weights) {
  std::vector<std::size_t> inputs;
  for (const Function& part : parts) {
    inputs.insert(inputs.end(), part.inputs().begin(), part.inputs().end());
  }
  std::sort(inputs.begin(), inputs.end());
  inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
  std::vector<Function> own;
  for (const Function& part : parts) own.push_back(part.within(inputs));
  return {std::move(inputs), std::make_shared<SumKernel>(std::move(own), weights), shape_of(parts)};
}

}  // namespace camlaw::optim
