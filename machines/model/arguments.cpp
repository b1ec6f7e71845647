// SPDX-License-Identifier: MIT
#include "machines/model/arguments.h"

#include <algorithm>
#include <functional>

#include "numerics/scalar/interval.h"

namespace camlaw::problems {
namespace {

/// The kernel as one of its inputs, each once and in order; place[k] is the input behind argument
/// k.
class Rearranged final : public optim::Kernel {
 public:
  Rearranged(std::shared_ptr<const optim::Kernel> kernel, std::vector<std::size_t> place)
      : kernel_(std::move(kernel)), place_(std::move(place)) {}

  double value(std::span<const double> u) const override { return kernel_->value(arguments(u)); }

  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::vector<double> own(place_.size());
    const double result = kernel_->gradient(arguments(u), own);
    add_gradient(own, g);
    return result;
  }

  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::vector<double> own(place_.size()), own_second(optim::packed_size(place_.size()));
    const double result = kernel_->hessian(arguments(u), own, own_second);
    add_gradient(own, g);
    std::fill(h.begin(), h.end(), 0.0);
    for (std::size_t i = 0; i < place_.size(); ++i) {
      for (std::size_t k = 0; k <= i; ++k) {
        const auto [low, high] = std::minmax(place_[i], place_[k]);
        const double twice = i != k && low == high ? 2 : 1;  // both (i, k) and (k, i) fall on it
        h[optim::packed(high, low)] += twice * own_second[optim::packed(i, k)];
      }
    }
    return result;
  }

  optim::Bounds enclose(std::span<const double> u) const override {
    return kernel_->enclose(arguments(u));
  }
  optim::BoxRange range(std::span<const optim::Bounds> box) const override {
    std::vector<optim::Bounds> own_box;
    for (const std::size_t place : place_) own_box.push_back(box[place]);
    const optim::BoxRange own = kernel_->range(own_box);
    optim::BoxRange result{own.value, std::vector<optim::Bounds>(box.size(), {0, 0})};
    for (std::size_t k = 0; k < place_.size(); ++k) {
      optim::Bounds& sum = result.slopes[place_[k]];
      const Interval wider =
          Interval(sum.lower, sum.upper) + Interval(own.slopes[k].lower, own.slopes[k].upper);
      sum = {wider.lower(), wider.upper()};
    }
    return result;
  }
  bool is_searched() const override { return kernel_->is_searched(); }
  bool is_enclosed() const override { return kernel_->is_enclosed(); }
  std::shared_ptr<const optim::Kernel> proved() const override {
    auto kernel = kernel_->proved();
    return kernel ? std::make_shared<Rearranged>(std::move(kernel), place_) : nullptr;
  }
  std::string why_undefined(std::span<const double> u) const override {
    return kernel_->why_undefined(arguments(u));
  }

 private:
  std::vector<double> arguments(std::span<const double> u) const {
    std::vector<double> result;
    for (const std::size_t place : place_) result.push_back(u[place]);
    return result;
  }

  void add_gradient(std::span<const double> own, std::span<double> g) const {
    std::fill(g.begin(), g.end(), 0.0);
    for (std::size_t k = 0; k < place_.size(); ++k) g[place_[k]] += own[k];
  }

  std::shared_ptr<const optim::Kernel> kernel_;
  std::vector<std::size_t> place_;
};

}  // namespace

optim::Function function_of(const std::vector<std::size_t>& variables,
                            std::shared_ptr<const optim::Kernel> kernel, optim::Shape shape) {
  std::vector<std::size_t> inputs = variables, place;
  std::sort(inputs.begin(), inputs.end());
  inputs.erase(std::unique(inputs.begin(), inputs.end()), inputs.end());
  if (inputs == variables) return {std::move(inputs), std::move(kernel), shape};
  for (const std::size_t variable : variables) {
    const auto found = std::lower_bound(inputs.begin(), inputs.end(), variable);
    place.push_back(static_cast<std::size_t>(found - inputs.begin()));
  }
  auto rearranged = std::make_shared<Rearranged>(std::move(kernel), std::move(place));
  return {std::move(inputs), std::move(rearranged), shape};
}

std::vector<double> arguments_at(const std::vector<std::size_t>& variables, optim::Design x) {
  std::vector<double> result;
  for (const std::size_t variable : variables) result.push_back(x[variable]);
  return result;
}

}  // namespace camlaw::problems
