// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "output/answers/buildable_output.h"
#include "output/answers/front_output.h"
#include "output/document/formatting.h"

namespace camlaw::cli {

using optim::Front;
using optim::FrontPoint;

std::string front_csv(const FrontAnswer& answer) {
  const Front& front = answer.front;
  const auto named = [](const std::string& name, const std::string& unit) {
    return unit.empty() || unit == "1" ? name : fmt::format("{} [{}]", name, unit);
  };
  std::vector<std::string> header, columns;  // of variables: in the order in which they appear
  for (const auto& o : front.objectives) header.push_back(named(o.name, o.unit));
  for (std::size_t i = 1; i < front.objectives.size(); ++i) {
    header.push_back(
        fmt::format("d {} / d {}", front.objectives[i].name, front.objectives[0].name));
  }
  header.insert(header.end(), {"verdict", "global", "buildable", "law"});
  for (const FrontPoint& point : front.points) {
    for (const auto& value : answer.values(point)) {
      const std::string column = named(value.name, value.unit);
      if (std::find(columns.begin(), columns.end(), column) == columns.end()) {
        columns.push_back(column);
      }
    }
  }
  header.insert(header.end(), columns.begin(), columns.end());
  std::vector<std::vector<std::string>> rows{header};
  for (std::size_t k = 0; k < front.points.size(); ++k) {
    const FrontPoint& point = front.points[k];
    std::vector<std::string> row;
    for (const double value : point.objectives) row.push_back(exact(value));
    for (std::size_t i = 1; i < front.objectives.size(); ++i) {
      row.push_back(exact(answer.front.slope(point, i, 0)));
    }
    row.emplace_back(to_string(point.verdict));
    row.emplace_back(point.is_global ? "yes" : "no");
    row.push_back(buildable_in_short(answer.built[k]));
    const auto law = answer.study.law(point);
    row.push_back(law ? law->name() : "");
    const std::size_t first = row.size();
    row.resize(header.size());
    for (const auto& value : answer.values(point)) {
      const auto at = std::find(columns.begin(), columns.end(), named(value.name, value.unit));
      if (at == columns.end()) continue;
      row[first + static_cast<std::size_t>(at - columns.begin())] =
          std::isnan(value.number) ? value.text : exact(value.number);
    }
    rows.push_back(std::move(row));
  }
  return to_csv(rows);
}

}  // namespace camlaw::cli
