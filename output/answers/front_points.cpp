// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/answers/buildable_output.h"
#include "output/answers/front_output.h"
#include "output/answers/front_words.h"
#include "output/answers/limit_text.h"
#include "output/answers/warnings.h"
#include "output/document/formatting.h"
#include "output/document/printing.h"

namespace camlaw::cli {
namespace {

using optim::FrontPoint;

/// More variables than this are not listed in tables.
constexpr std::size_t kListedPoints = 6;

/// Where a curve is worst, with the unit of its places.
std::string place_of(const FrontAnswer& answer, const optim::Standing& limit) {
  const auto& stated = answer.study.bound().statement().constraints;
  const auto at = std::find_if(stated.begin(), stated.end(), [&](const auto& constraint) {
    return constraint.response.name == limit.name;
  });
  return at == stated.end() ? fmt::format("{:.4g}", *limit.angle)
                            : place_text(*limit.angle, at->response);
}

/// The limits of a design, with what easing each by a unit buys of the first objective.
Table front_limits_table(const FrontAnswer& answer, const FrontPoint& point) {
  Table table{.key = "limits",
              .columns = {words("limit", "name"), numbers("margin", "margin"),
                          words("unit", "unit"), numbers("at", "worst_angle"), data("met"),
                          words("proved", "proved"), numbers("price", "multiplier")},
              .shown = point.limits.size()};
  constexpr double kResolved = 1e-3;  // in any unit: a millionth of it is what rounding leaves
  for (const optim::Standing& limit : point.limits) {
    const double price = answer.front.price(point, limit);
    table.add(
        {limit.name,
         {significant(limit.margin, std::max(std::abs(limit.margin), kResolved), 4), limit.margin},
         limit.unit,
         {limit.angle ? place_of(answer, limit) : "", limit.angle},
         datum(limit.met),
         yes_or_no(limit.proved),
         {price != 0 ? in_digits(price, 5) : "", price}});
  }
  return table;
}

/// "a = 1 mm, b = 2", or how many there are.
std::string design_text(const std::vector<DesignValue>& values) {
  if (values.size() > kListedPoints) return fmt::format("{} variables", values.size());
  std::vector<std::string> parts;
  for (const auto& value : values) {
    parts.push_back(fmt::format("{} = {}", value.name, value.words()));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

Json variables_json(const std::vector<DesignValue>& values) {
  Json variables = Json::object();
  for (const auto& value : values) {
    variables[value.name] = value.json();
  }
  return variables;
}

Json objectives_json(const FrontAnswer& answer, const FrontPoint& point) {
  Json objectives = Json::object();
  for (std::size_t i = 0; i < point.objectives.size(); ++i) {
    objectives[answer.front.objectives[i].name] = to_json(point.objectives[i]);
  }
  return objectives;
}

Json slopes_json(const FrontAnswer& answer, const FrontPoint& point) {
  Json slopes = Json::array();
  for (std::size_t i = 1; i < point.objectives.size(); ++i) {
    slopes.push_back({{"of", answer.front.objectives[i].name},
                      {"per", answer.front.objectives[0].name},
                      {"value", to_json(answer.front.slope(point, i, 0))}});
  }
  return slopes;
}

std::vector<Column> point_columns(const FrontAnswer& answer) {
  const auto& objectives = answer.front.objectives;
  std::vector<Column> columns{numbers("#")};
  for (const auto& o : objectives) {
    columns.push_back(numbers(o.unit == "1" ? o.name : fmt::format("{}, {}", o.name, o.unit)));
  }
  for (std::size_t i = 1; i < objectives.size(); ++i) {
    const std::string title = objectives.size() == 2 ? "slope" : fmt::format("slope {}", i + 1);
    columns.push_back(numbers(title).only_in_text());
  }
  const bool laws = !answer.front.points.empty() && !answer.law(answer.front.points[0]).empty();
  columns.insert(columns.end(), {data("objectives"), data("variables"), words("verdict", "verdict"),
                                 laws ? words("law", "law") : data("law"), data("reason"),
                                 data("global"), data("slopes"), data("limits"), data("buildable"),
                                 data("lambda"), data("solver"), names("design")});
  return columns;
}

std::vector<Cell> point_cells(const FrontAnswer& answer, std::size_t k) {
  const FrontPoint& point = answer.front.points[k];
  std::vector<Cell> cells{fmt::format("{}", k + 1)};
  for (const double value : point.objectives) cells.push_back(in_digits(value));
  for (std::size_t i = 1; i < point.objectives.size(); ++i) {
    cells.push_back(in_digits(answer.front.slope(point, i, 0), 5));
  }
  const auto values = answer.values(point);
  const auto law = answer.study.law(point);
  cells.insert(
      cells.end(),
      {datum(objectives_json(answer, point)),
       datum(variables_json(values)),
       {verdict_words(point), to_string(point.verdict)},
       {answer.family(point), law ? Json(law->name()) : Json(nullptr)},
       datum(point.reason),
       datum(point.is_global),
       datum(slopes_json(answer, point)),
       datum(json_of(front_limits_table(answer, point))),
       datum(buildable_json(answer.built[k])),
       datum(answer.ruler ? to_json(answer.ruler->limit_index(point.objectives)) : Json(nullptr)),
       datum(point.solver),
       design_text(values)});
  return cells;
}

}  // namespace

Table points_table(const FrontAnswer& answer, const std::vector<std::size_t>& points) {
  Table table{.key = "points", .columns = point_columns(answer), .shown = points.size()};
  for (const std::size_t k : points) table.add(point_cells(answer, k));
  return table;
}

Document point_document(const FrontAnswer& answer, std::size_t k) {
  const FrontPoint& point = answer.front.points[k];
  const Warnings warnings = warnings_of(answer.study.design(point));
  Document document;
  const Headline line = headline(verdict_words(point), answer.built[k]);
  document.say(fmt::format("point {}: {}\n{}{}{}\n", k + 1, values_text(answer, point.costs),
                           line.spoilt ? shaded(line.text, Shade::Unsure) : line.text,
                           line.spoilt ? "\n" : ": ", point.reason));
  document.take_facts(json_of(points_table(answer, {k})).front());
  document.fact("point", k);
  document.say(warnings_text(warnings));
  document.fact("warnings", warnings);
  if (const std::string law = answer.law(point); !law.empty()) {
    document.say("  law " + law + "\n");
  }
  const auto values = answer.values(point);
  if (values.size() > 4 * kListedPoints) {
    document.say(fmt::format("  {} variables; --json and --csv have them\n", values.size()));
  } else {
    for (const auto& value : values) {
      document.say(fmt::format("  {} = {}\n", value.name, value.words()));
    }
  }
  if (!point.limits.empty()) {
    const auto& first = answer.front.objectives.front();
    document.say("\n");
    document.add(front_limits_table(answer, point));
    document.say(fmt::format("price: by how much {} improves{} per unit of the limit's bound\n",
                             first.name,
                             first.unit == "1" ? "" : fmt::format(", in {},", first.unit)));
  }
  document.add(buildable_document(answer.built[k]));
  document.add(next_document(answer, k));
  return document;
}

}  // namespace camlaw::cli
