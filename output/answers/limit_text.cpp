// SPDX-License-Identifier: MIT
#include "output/answers/limit_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/document/text_table.h"

namespace camlaw::cli {

std::string place_text(double place, const problems::ResponseName& curve) {
  const std::string unit = curve.response != nullptr ? curve.response->along : "";
  return with_unit(fmt::format("{:.4g}", place + 0.0), unit);
}

LimitText limit_text(const optim::LimitReport& report,
                     const problems::ConstraintStatement& stated) {
  // A bound of zero leaves the tolerance to tell what is rounding.
  const double size =
      std::max({std::abs(report.value), std::abs(report.bound), 1e3 * report.tolerance});
  // It was stated: however far the value is from it, it has digits of its own.
  const double bound_size = std::max(std::abs(report.bound), 1e3 * report.tolerance);
  const char* sign = report.is_equation ? "==" : report.is_upper ? "<=" : ">=";
  return {significant(report.value, size),
          fmt::format("{} {}", sign, significant(report.bound, bound_size)),
          significant(report.margin, size, 3),
          report.worst_angle ? place_text(*report.worst_angle, stated.response) : ""};
}

}  // namespace camlaw::cli
