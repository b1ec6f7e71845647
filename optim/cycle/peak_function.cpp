// SPDX-License-Identifier: MIT
#include "optim/cycle/peak_function.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "optim/cycle/extremes.h"

namespace camlaw::optim {
namespace {

class PeakKernel final : public Kernel {
 public:
  PeakKernel(Response response, Part part) : response_(std::move(response)), part_(part) {}

  double value(std::span<const double> u) const override {
    const Extreme peak = find(u);
    return part_ == Part::Magnitude ? std::abs(peak.value) : peak.value;
  }

  double gradient(std::span<const double> u, std::span<double> g) const override {
    const Extreme peak = find(u);
    const Function f = response_.curve().at(peak.place);
    std::vector<double> slopes(f.inputs().size());
    f.gradient(u, slopes);
    const double sign = part_ == Part::Magnitude && peak.value < 0 ? -1 : 1;
    std::fill(g.begin(), g.end(), 0.0);
    for (std::size_t k = 0; k < slopes.size(); ++k) g[f.inputs()[k]] = sign * slopes[k];
    return sign * peak.value;
  }

  double hessian(std::span<const double> u, std::span<double> g,
                 std::span<double> h) const override {
    std::fill(h.begin(), h.end(), std::numeric_limits<double>::quiet_NaN());
    return gradient(u, g);
  }

 private:
  Extreme find(std::span<const double> u) const {
    return extreme_of(*response_.curve().trace(u), part_);
  }

  Response response_;
  Part part_;
};

}  // namespace

Function peak_function(const Response& response, Part part, std::size_t variables) {
  std::vector<std::size_t> all(variables);
  std::iota(all.begin(), all.end(), std::size_t{0});
  return {std::move(all), std::make_shared<PeakKernel>(response, part)};
}

SizedProblem with_peaks_as_numbers(const Problem& problem, const Sizes& sizes) {
  const std::size_t n = problem.variables.size();
  const auto number = [&](const Response& curve, Part part) {
    return Response{curve.name, curve.unit, peak_function(curve, part, n)};
  };
  SizedProblem result{problem, sizes};
  Objective& objective = result.problem.objective;
  if (objective.response.is_curve()) {
    objective.response = number(objective.response, objective.part);
    objective.part = Part::Value;
  }
  result.problem.constraints.clear();
  result.sizes.constraints.clear();
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const auto add = [&](Constraint side) {
      result.problem.constraints.push_back(std::move(side));
      result.sizes.constraints.push_back(sizes.constraints[i]);
    };
    const Constraint& c = problem.constraints[i];
    if (!c.response.is_curve()) {
      add(c);
      continue;
    }
    Constraint upper = c, lower = c;
    upper.response = number(c.response, Part::Highest);
    lower.response = number(c.response, Part::Lowest);
    upper.lower.reset();
    lower.upper.reset();
    if (c.upper) add(std::move(upper));
    if (c.lower) add(std::move(lower));
  }
  return result;
}

}  // namespace camlaw::optim
