// SPDX-License-Identifier: MIT
#include "output/answers/limit_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "machines/model/load_case.h"
#include "output/document/formatting.h"
#include "output/document/printing.h"
#include "problems/statement/ranges.h"

namespace camlaw::cli {

std::string place_text(double place, const std::string& unit) {
  constexpr double kNone = 1e-6;  // what rounding leaves of the cycle's beginning
  return with_unit(fmt::format("{:.4g}", std::abs(place) < kNone ? 0 : place), unit);
}

std::string place_text(double place, const problems::ResponseName& curve) {
  return place_text(place, curve.response != nullptr ? curve.response->along : "");
}

std::string at_place(double place, const problems::ResponseName& curve) {
  const auto in = problems::place_in_case(curve, place);
  if (!in) return "at " + place_text(place, curve);
  const problems::ResponseName& one = curve.response->over_cases.front();
  const std::string where = one.response->curve ? "at " + place_text(in->place, one) : "";
  if (in->load_case.empty()) return where;
  return where + (where.empty() ? "" : " ") + "in case " + in->load_case;
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

LimitText limit_text(const optim::LimitReport& report, const problems::ProblemStatement& design,
                     std::size_t number) {
  const problems::ConstraintStatement& stated = design.constraints[number];
  LimitText text = limit_text(report, stated);
  const std::string worst = problems::worst_in_ranges(design, stated, report.worst_angle);
  if (!worst.empty()) text.place += (text.place.empty() ? "" : ", ") + worst;
  return text;
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
                          words("unit", "unit"), numbers("at", "worst_angle_deg"), data("met"),
                          data("tolerance"), words("proved", "proved")},
              .shown = 0};
  for (std::size_t i = 0; i < limits.size(); ++i) {
    std::vector<Cell> cells = limit_cells(limits[i], design.constraints[i]);
    cells.back().text = limit_text(limits[i], design, i).place;
    cells.insert(cells.begin(), limits[i].name);
    cells.push_back(datum(limits[i].met));
    cells.push_back(datum(limits[i].tolerance));
    cells.push_back(yes_or_no(limits[i].proved));
    table.add(std::move(cells));
  }
  return table;
}

Document limits_document(const std::vector<optim::LimitReport>& limits,
                         const problems::ProblemStatement& design) {
  Document document;
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const optim::LimitReport& limit = limits[i];
    const LimitText text = limit_text(limit, design, i);
    document.say(fmt::format("{} {} = {} {}{}{}\n",
                             limit.met ? shaded("met", Shade::Good) : shaded("NOT met", Shade::Bad),
                             limit.name, text.value, with_unit(text.bound, limit.unit),
                             text.place.empty() ? "" : fmt::format(" (worst at {})", text.place),
                             limit.met && !limit.proved ? " (not proved)" : ""));
  }
  document.add(limits_table(limits, design));
  return document;
}

}  // namespace camlaw::cli
