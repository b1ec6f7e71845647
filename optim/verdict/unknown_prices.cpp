// SPDX-License-Identifier: MIT
#include "optim/verdict/unknown_prices.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>
#include <vector>

#include "optim/cycle/scales.h"
#include "optim/verdict/kinks.h"
#include "optim/verdict/verdict.h"

namespace camlaw::optim {
namespace {

/// Names of what costs something that is not known.
std::vector<std::string> unknown_costs(const Assessment& a) {
  std::vector<std::string> names;
  for (const LimitReport& limit : a.limits) {
    if (std::isnan(limit.multiplier)) names.push_back("the limit on " + limit.name);
  }
  for (const VariableReport& v : a.variables) {
    if (!std::isnan(v.multiplier)) continue;
    names.push_back(fmt::format("the {} bound of {}", v.at_upper ? "upper" : "lower", v.name));
  }
  return names;
}

}  // namespace

void drop_unknown_prices(Assessment& assessment) {
  constexpr double kStands = 10;  // tolerances
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (assessment.kkt_residual <= kKktTolerance) return;
  const bool is_known = assessment.kkt_residual <= kPriceTolerance;
  // Multipliers that fit as well as any can also weigh limits that the design keeps clear of.
  for (LimitReport& limit : assessment.limits) {
    if (!limit.is_equation && limit.margin > kStands * limit.tolerance) limit.multiplier = 0;
    if (!is_known && limit.multiplier != 0) limit.multiplier = kNone;
  }
  for (VariableReport& v : assessment.variables) {
    if (!is_known && v.multiplier != 0) v.multiplier = kNone;
  }
}

std::string why_no_price(const Problem& problem, const Assessment& assessment, Design x) {
  const std::vector<std::string> unknown = unknown_costs(assessment);
  if (unknown.empty() || x.size() != problem.variables.size()) return {};
  if (assessment.kkt_residual <= kPriceTolerance) {
    return fmt::format(
        "what easing {} gains is not known: within its tolerance the slopes change too much, or "
        "there is no value beyond it",
        fmt::join(unknown, ", "));
  }
  const std::string kinked = kinked_name(problem, scales(problem, x), x);
  if (!kinked.empty()) {
    return fmt::format(
        "what easing the limits gains is not known to first order: the answer lies on a kink of {}",
        kinked);
  }
  return fmt::format(
      "what easing the limits gains is not known: the conditions of optimality hold only to {:.1e}",
      assessment.kkt_residual);
}

}  // namespace camlaw::optim
