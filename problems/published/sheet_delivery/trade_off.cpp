// SPDX-License-Identifier: MIT
#include "problems/published/sheet_delivery/trade_off.h"

#include <fmt/format.h>

#include <stdexcept>

#include "optim/problem/deadline.h"
#include "optim/search/optimise.h"
#include "problems/sheet_delivery/greatest_least_efficiency.toml.h"
#include "problems/statement/bind.h"

namespace camlaw::problems {
namespace {

DeliveryChoice best_for(ProblemStatement statement, double slow_down,
                        const std::atomic<bool>* stop) {
  statement.constraints.front().lower = slow_down;
  const BoundProblem bound(std::move(statement));
  const optim::Optimum optimum = optim::optimise(bound.space(), {.stop = stop});
  optim::Deadline({}, stop).check();
  const optim::Assessment& assessment = optimum.found.assessment;
  DeliveryChoice choice{.slow_down = slow_down, .verdict = assessment.verdict};
  if (optimum.found.x.empty()) return choice;
  const ProblemStatement best = bound.at(optimum.options, optimum.found.x);
  choice.efficiency = assessment.objective.value;
  choice.price = assessment.limits.front().multiplier;
  choice.law = best.laws.front().label();
  choice.guide_ratio = best.constants[best.mechanism->parameter("guide_ratio")];
  choice.rod_angle_max = best.constants[best.mechanism->parameter("rod_angle_max")];
  return choice;
}

}  // namespace

std::vector<DeliveryChoice> trade_off_sheet_delivery(const DeliveryQuestion& question) {
  const auto& [least, greatest, points, progress, stop] = question;
  if (!(least > 0 && least < greatest && greatest < 1) || points < 2) {
    throw std::invalid_argument(
        fmt::format("trade-off: slow-downs from {} to {} in {} points; it needs 0 < from < to < 1 "
                    "and 2 points or more",
                    least, greatest, points));
  }
  const ProblemStatement statement =
      read_problem(data::greatest_least_efficiency, "greatest_least_efficiency.toml");
  std::vector<DeliveryChoice> choices;
  for (int i = 0; i < points; ++i) {
    if (progress) progress(static_cast<double>(i) / points);
    choices.push_back(best_for(statement, least + (greatest - least) * i / (points - 1), stop));
  }
  return choices;
}

}  // namespace camlaw::problems
