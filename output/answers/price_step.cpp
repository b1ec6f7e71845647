// SPDX-License-Identifier: MIT
#include "output/answers/price_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace camlaw::cli {
namespace {

template <class Report>
PricedStep told_of_report(const Report& report, const optim::Assessment& assessment) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const PricedStep none{kNone, kNone};
  if (assessment.verdict != optim::Verdict::Certified) return none;
  return priced_step(report, assessment.objective.value).value_or(none);
}

}  // namespace

std::optional<PricedStep> priced_step(double scale, double price, double objective) {
  // A tenth of a bound, or of the objective, is small enough for a price to hold, to first order
  // (optimisation: Prices). What gains less than kIdle of the objective is rounding.
  constexpr double kShare = 0.1, kIdle = 1e-9;
  constexpr double kWhole = 1e-9;  // so that a tenth of 10 is 1 whatever its rounding
  if (!(std::abs(price) > kIdle * std::abs(objective))) return std::nullopt;
  double most = scale > 0 ? kShare * scale : 1;
  const double by_gain = kShare * std::abs(objective / price);
  if (by_gain > 0) most = std::min(most, by_gain);
  const double step = std::pow(10.0, std::floor(std::log10(most) + kWhole));
  if (!(step > 0) || !std::isfinite(step)) return std::nullopt;
  return PricedStep{step, price * step};
}

std::optional<PricedStep> priced_step(const optim::LimitReport& limit, double objective) {
  if (limit.is_equation) return std::nullopt;
  return priced_step(std::abs(limit.bound), limit.multiplier, objective);
}

std::optional<PricedStep> priced_step(const optim::VariableReport& variable, double objective) {
  if (variable.at_lower == variable.at_upper) return std::nullopt;
  const double bound = std::abs(variable.at_upper ? variable.upper : variable.lower);
  const double range = variable.upper - variable.lower;
  double scale = bound;
  if (range > 0 && std::isfinite(range)) scale = bound > 0 ? std::min(bound, range) : range;
  return priced_step(scale, variable.multiplier, objective);
}

PricedStep told_step(const optim::LimitReport& limit, const optim::Assessment& assessment) {
  return told_of_report(limit, assessment);
}

PricedStep told_step(const optim::VariableReport& variable, const optim::Assessment& assessment) {
  return told_of_report(variable, assessment);
}

}  // namespace camlaw::cli
