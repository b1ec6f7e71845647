// SPDX-License-Identifier: MIT
#include "output/answers/limit_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/document/formatting.h"

namespace camlaw::cli {

std::string place_text(double place, const problems::ResponseName& curve) {
  constexpr double kNone = 1e-6;  // what rounding leaves of the cycle's beginning
  const std::string unit = curve.response != nullptr ? curve.response->along : "";
  return with_unit(fmt::format("{:.4g}", std::abs(place) < kNone ? 0 : place), unit);
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

std::vector<Cell> limit_cells(const optim::LimitReport& report,
                              const problems::ConstraintStatement& stated) {
  const LimitText text = limit_text(report, stated);
  return {{text.value, report.value},
          {text.bound, report.bound},
          datum(report.is_upper ? "upper" : "lower"),
          {text.margin, report.margin},
          report.unit,
          {text.place, report.worst_angle}};
}

Table limits_table(const std::vector<optim::LimitReport>& limits,
                   const problems::ProblemStatement& design) {
  Table table{.key = "constraints",
              .columns = {words("limit", "name"), numbers("value", "value"),
                          numbers("bound", "bound"), data("side"), numbers("margin", "margin"),
                          words("unit", "unit"), numbers("at", "worst_angle_deg"), data("met")},
              .shown = 0};
  for (std::size_t i = 0; i < limits.size(); ++i) {
    std::vector<Cell> cells = limit_cells(limits[i], design.constraints[i]);
    cells.insert(cells.begin(), limits[i].name);
    cells.push_back(datum(limits[i].met));
    table.add(std::move(cells));
  }
  return table;
}

}  // namespace camlaw::cli
