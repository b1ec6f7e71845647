// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "problems/statement/buildable.h"

namespace camlaw::problems {

std::string_view to_string(Built built) {
  switch (built) {
    case Built::Holds:
      return "holds";
    case Built::Fails:
      return "fails";
    case Built::NotChecked:
      break;
  }
  return "not checked";
}

std::string failure_text(const BuildableAnswer& answer) {
  const optim::LimitReport& report = answer.report;
  constexpr double kNone = 1e-6;  // what rounding leaves of the cycle's beginning
  const std::string& along = answer.limit.response.response->along;
  std::string place;
  if (report.worst_angle) {
    const double at = std::abs(*report.worst_angle) < kNone ? 0 : *report.worst_angle;
    place = fmt::format(" at {:.4g}{}", at, along == "1" ? "" : " " + along);
  }
  if (std::isnan(report.margin)) return report.name + " is not a number";
  return fmt::format("{} {:.4g}{}{}", report.name, report.value,
                     report.unit == "1" ? "" : " " + report.unit, place);
}

std::string failure_text(const Buildability& found) {
  std::vector<std::string> parts;
  for (const BuildableAnswer& answer : found.checks) {
    if (answer.built == Built::Fails) parts.push_back(failure_text(answer));
  }
  return parts.empty() ? "" : fmt::format("cannot be built: {}", fmt::join(parts, ", "));
}

}  // namespace camlaw::problems
