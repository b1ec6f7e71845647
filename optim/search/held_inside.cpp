// SPDX-License-Identifier: MIT
#include "optim/search/held_inside.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <numeric>
#include <utility>

#include "optim/cycle/forwarding_curve.h"

namespace camlaw::optim {
namespace {

/// A function of all variables.
class HeldKernel final : public Kernel {
 public:
  HeldKernel(Function function, IntoDomain into)
      : function_(std::move(function)), into_(std::move(into)) {}

  double value(std::span<const double> x) const override { return function_.value(into_(x)); }

  double gradient(std::span<const double> x, std::span<double> g) const override {
    std::vector<double> own(function_.inputs().size());
    const double value = function_.gradient(into_(x), own);
    std::fill(g.begin(), g.end(), 0);
    for (std::size_t k = 0; k < own.size(); ++k) g[function_.inputs()[k]] = own[k];
    return value;
  }

  double hessian(std::span<const double> x, std::span<double> g,
                 std::span<double> h) const override {
    const std::vector<std::size_t>& inputs = function_.inputs();
    std::vector<double> slope(inputs.size());
    std::vector<double> own(packed_size(inputs.size()));
    const double value = function_.hessian(into_(x), slope, own);
    std::fill(g.begin(), g.end(), 0);
    std::fill(h.begin(), h.end(), 0);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      g[inputs[i]] = slope[i];
      for (std::size_t j = 0; j <= i; ++j) h[packed(inputs[i], inputs[j])] = own[packed(i, j)];
    }
    return value;
  }

 private:
  Function function_;
  IntoDomain into_;
};

Function held(const Function& f, std::size_t variables, const IntoDomain& into) {
  if (f.shape() == Shape::Linear) return f;
  std::vector<std::size_t> all(variables);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return {std::move(all), std::make_shared<HeldKernel>(f, into)};
}

class HeldCurve final : public ForwardingCurve {
 public:
  HeldCurve(std::shared_ptr<const Curve> curve, std::size_t variables, IntoDomain into)
      : ForwardingCurve(std::move(curve)), variables_(variables), into_(std::move(into)) {}

  Function at(Place place) const override { return held(curve().at(place), variables_, into_); }
  std::vector<double> slope_gradient(Place place, Design x) const override {
    return curve().slope_gradient(place, into_(x));
  }
  Place tied(Place place, Design x) const override { return curve().tied(place, into_(x)); }
  std::vector<double> jump_motion(Place place, Design x) const override {
    return optim::jump_motion(curve(), place, into_(x));
  }
  std::vector<Rest> rests(double bound, Design x) const override {
    std::vector<Rest> rests = curve().rests(bound, into_(x));
    for (Rest& rest : rests) rest.leading = held(rest.leading, variables_, into_);
    return rests;
  }
  std::unique_ptr<Trace> trace(Design x) const override { return curve().trace(into_(x)); }
  double largest(Design x) const override { return curve().largest(into_(x)); }
  Shape shape() const override { return Shape::General; }

 private:
  std::size_t variables_;
  IntoDomain into_;
};

}  // namespace

IntoDomain drawn_towards(std::vector<double> inside, std::function<bool(Design)> is_within) {
  // They reach the last bits of the distance, so that the step ends at the edge.
  constexpr int kHalvings = 50;
  struct Last {
    std::mutex mutex;
    std::vector<double> asked, given;
  };
  const auto last = std::make_shared<Last>();
  return [inside = std::move(inside), is_within = std::move(is_within), last](Design x) {
    const std::lock_guard lock(last->mutex);
    if (std::equal(x.begin(), x.end(), last->asked.begin(), last->asked.end())) return last->given;
    std::vector<double> place(x.begin(), x.end());
    const auto go_to = [&](double part) {
      for (std::size_t i = 0; i < place.size(); ++i) {
        place[i] = std::lerp(inside[i], x[i], part);
      }
    };
    if (!is_within(place)) {
      double within = 0;
      double beyond = 1;
      for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (within + beyond);
        go_to(middle);
        (is_within(place) ? within : beyond) = middle;
      }
      go_to(within);
    }
    last->asked.assign(x.begin(), x.end());
    last->given = place;
    return place;
  };
}

Problem held_inside(Problem problem, const IntoDomain& into) {
  const std::size_t variables = problem.variables.size();
  replace_curves(problem, [&](const std::shared_ptr<const Curve>& curve) {
    std::shared_ptr<const Curve> held = curve;
    if (curve->shape() != Shape::Linear) {
      held = std::make_shared<HeldCurve>(curve, variables, into);
    }
    return held;
  });
  const auto hold = [&](Response& response) {
    if (!response.is_curve()) response.measure = held(response.function(), variables, into);
  };
  for (Objective& objective : problem.objectives) hold(objective.response);
  for (Constraint& c : problem.constraints) hold(c.response);
  return problem;
}

}  // namespace camlaw::optim
