// SPDX-License-Identifier: MIT
#include "optim/search/convex_part.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "optim/search/interruptible.h"
#include "optim/search/plan.h"

namespace camlaw::optim {
namespace {

/// The sum of all inputs, each times its weight.
class WeightedSum final : public Kernel {
 public:
  explicit WeightedSum(std::vector<double> weights) : weights_(std::move(weights)) {}
  double value(std::span<const double> u) const override {
    return std::inner_product(u.begin(), u.end(), weights_.begin(), 0.0);
  }
  double gradient(std::span<const double> u, std::span<double> g) const override {
    std::copy(weights_.begin(), weights_.end(), g.begin());
    return value(u);
  }
  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::fill(h.begin(), h.end(), 0.0);
    return gradient(u, g);
  }

 private:
  std::vector<double> weights_;
};

/// Least where a design lies farthest from one towards another, by the variables' scales; it falls
/// by one on the path between them.
Objective towards(Design from, Design to, const std::vector<double>& scales) {
  std::vector<std::size_t> inputs(from.size());
  std::iota(inputs.begin(), inputs.end(), std::size_t{0});
  std::vector<double> weights(from.size());
  double distance = 0;  // squared
  for (std::size_t i = 0; i < from.size(); ++i) {
    weights[i] = (from[i] - to[i]) / (scales[i] * scales[i]);
    distance += weights[i] * (from[i] - to[i]);
  }
  for (double& weight : weights) weight /= distance > 0 ? distance : 1;
  Objective objective;
  objective.response = {"direction", "1",
                        Function(inputs, std::make_shared<WeightedSum>(weights), Shape::Linear)};
  return objective;
}

}  // namespace

std::vector<double> begun_in_convex_part(Design start, const Setting& setting, Trail& trail) {
  Problem convex = setting.problem;
  std::erase_if(convex.constraints, [](const Constraint& c) { return !is_convex_limit(c); });
  if (convex.constraints.empty()) return {start.begin(), start.end()};
  const std::vector<double> own = setting.problem.start();
  // Where every limit is convex, the optimum of that part is where the first start has led.
  const bool leaves_out = convex.constraints.size() < setting.problem.constraints.size();
  Scales own_scales = scales(convex, own);
  if (trail.found.starts > 2 || !leaves_out) {
    convex.objectives = {towards(own, start, variable_scales(convex))};
    own_scales.objective = 1;
  }
  SolverOptions how;
  how.time_limit = setting.deadline.left();
  how.stop = setting.options.stop;
  const Attempt led =
      exchange(convex, own_scales, own, *plan(convex, "auto").solvers.front(), how, Aim::Optimum);
  trail.count(led);
  if (is_interruption(led.error)) throw Interrupted();
  if (led.status == Status::Unbounded) return {start.begin(), start.end()};
  return led.x.empty() ? own : led.x;
}

}  // namespace camlaw::optim
