// SPDX-License-Identifier: MIT
#include "cli/front_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "cli/text_table.h"

namespace camlaw::cli {
namespace {

using optim::Front;
using optim::FrontPoint;

std::string number(double value) { return fmt::format("{:.7g}", value + 0.0); }

const optim::ObjectiveName& objective(const FrontAnswer& answer, std::size_t i) {
  return answer.front.objectives[i];
}

std::string with_its_unit(const FrontAnswer& answer, std::size_t i, double value) {
  return with_unit(number(value), objective(answer, i).unit);
}

std::string verdict_text(const FrontPoint& point) {
  return fmt::format("{}{}", to_string(point.verdict), point.is_global ? ", global" : "");
}

/// "R 33.1 mm, F 4.2 N".
std::string values_text(const FrontAnswer& answer, const std::vector<double>& costs) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    parts.push_back(fmt::format("{} {}", objective(answer, i).name,
                                with_its_unit(answer, i, answer.value(i, costs[i]))));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::optional<problems::FrontRuler> ruler(const FrontAnswer& answer) {
  return problems::front_ruler(answer.study.bound().statement());
}

/// More variables than this are not listed in tables.
constexpr std::size_t kListed = 6;

std::string table_text(const FrontAnswer& answer) {
  const Front& front = answer.front;
  const bool laws = !answer.law(front.points.front()).empty();
  const std::size_t objectives = front.objectives.size();
  std::vector<TextTable::Column> columns{{"#"}};
  for (const auto& o : front.objectives) {
    columns.push_back({o.unit == "1" ? o.name : fmt::format("{}, {}", o.name, o.unit)});
  }
  for (std::size_t i = 1; i < objectives; ++i) {
    columns.push_back({objectives == 2 ? "slope" : fmt::format("slope {}", i + 1)});
  }
  columns.push_back({"verdict", TextTable::Align::Left});
  if (laws) columns.push_back({"law", TextTable::Align::Left});
  columns.push_back({"design", TextTable::Align::Left});
  TextTable table(std::move(columns));
  for (std::size_t k = 0; k < front.points.size(); ++k) {
    const FrontPoint& point = front.points[k];
    std::vector<std::string> row{fmt::format("{}", k + 1)};
    for (const double value : point.objectives) row.push_back(number(value));
    for (std::size_t i = 1; i < objectives; ++i) {
      row.push_back(shown(answer.slope(point, i, 0), 4));
    }
    row.push_back(verdict_text(point));
    if (laws) row.push_back(answer.family(point));
    std::vector<std::string> design;
    const auto values = answer.values(point);
    for (const auto& value : values) {
      if (value.name != "law") {
        design.push_back(fmt::format("{} = {}", value.name, with_unit(value.text, value.unit)));
      }
    }
    row.push_back(design.size() > kListed ? fmt::format("{} variables", design.size())
                                          : fmt::format("{}", fmt::join(design, ", ")));
    table.add(std::move(row));
  }
  return table.text();
}

std::string slopes_note(const FrontAnswer& answer) {
  const auto& o = answer.front.objectives;
  std::string text;
  for (std::size_t i = 1; i < o.size(); ++i) {
    const std::string unit = o[i].unit == "1" && o[0].unit == "1"
                                 ? ""
                                 : fmt::format(", {} per {}", o[i].unit, o[0].unit);
    text += fmt::format("slope{}: change of {} per unit of {} along the front{}\n",
                        o.size() == 2 ? "" : fmt::format(" {}", i + 1), o[i].name, o[0].name, unit);
  }
  return text;
}

std::string knee_text(const FrontAnswer& answer) {
  const auto all = answer.costs();
  const auto knee = optim::knee(all);
  if (!knee) return "";
  std::string text =
      fmt::format("knee: point {}, {}\n", knee->point + 1, values_text(answer, all[knee->point]));
  for (std::size_t i = 0; i < knee->low.size(); ++i) {
    text += fmt::format("  stays the knee while {} counts {} to {} times as much\n",
                        objective(answer, i).name, shown(knee->low[i], 2), shown(knee->high[i], 2));
  }
  return text;
}

std::string measures_text(const FrontAnswer& answer) {
  const Front& front = answer.front;
  std::string text = fmt::format("ideal: {}\nnadir: {}\n", values_text(answer, front.ideal),
                                 values_text(answer, front.nadir));
  text += fmt::format("hypervolume {} from {}\n", number(front.hypervolume),
                      values_text(answer, front.reference));
  if (front.hypervolume_of_mixtures) {
    text += fmt::format("  with mixtures of neighbours, which the problem allows, {}\n",
                        number(*front.hypervolume_of_mixtures));
  }
  if (front.hypervolume_at_most) {
    const double more = 100 * (*front.hypervolume_at_most / front.hypervolume - 1);
    const bool global = std::all_of(front.points.begin(), front.points.end(),
                                    [](const FrontPoint& p) { return p.is_global; });
    text += fmt::format(
        "  {}, it is at most {}{}\n",
        global ? "whatever lies between the points" : "if each search found the best there is",
        number(*front.hypervolume_at_most),
        std::isfinite(more) ? fmt::format(" ({:.3f} % more)", more) : "");
  }
  const auto limit = ruler(answer);
  if (const double most = limit ? limit->hypervolume(front.reference) : 0; most > 0) {
    const double reached = front.hypervolume_of_mixtures.value_or(front.hypervolume);
    text += fmt::format("  no law exceeds {}: this is {:.3f} % of that\n", number(most),
                        100 * reached / most);
  }
  const auto all = answer.costs();
  if (front.objectives.size() == 2 && all.size() > 2) {
    const auto lengths = optim::steps(all);
    double sum = 0;
    for (const double l : lengths) sum += l;
    text += fmt::format("largest step between neighbours: {:.2f} times the mean\n",
                        *std::max_element(lengths.begin(), lengths.end()) * lengths.size() / sum);
  }
  return text;
}

std::string work_text(const FrontAnswer& answer) {
  const Front& front = answer.front;
  const auto certified =
      std::count_if(front.points.begin(), front.points.end(),
                    [](const FrontPoint& p) { return p.verdict == optim::Verdict::Certified; });
  std::string text = fmt::format("{} of {} points certified; {} searches, {} evaluations\n",
                                 certified, front.points.size(), front.tasks, front.evaluations);
  if (front.parts > 1) {
    text += fmt::format("{} combinations{}\n", front.parts,
                        front.empty_parts > 0
                            ? fmt::format(", {} of them without a design", front.empty_parts)
                            : "");
  }
  for (const optim::FailedTask& failed : front.failures) {
    text += fmt::format("search {} failed: {}\n", failed.number + 1, failed.why);
  }
  if (!front.complete) text += "the study is not finished; --resume goes on with it\n";
  return text;
}

Json costs_json(const FrontAnswer& answer, const optim::Costs& costs) {
  Json result = Json::array();
  for (std::size_t i = 0; i < costs.size(); ++i) {
    result.push_back(to_json(answer.value(i, costs[i])));
  }
  return result;
}

Json point_object(const FrontAnswer& answer, std::size_t k) {
  const FrontPoint& point = answer.front.points[k];
  Json objectives = Json::object(), variables = Json::object(), slopes = Json::array();
  for (std::size_t i = 0; i < point.objectives.size(); ++i) {
    objectives[objective(answer, i).name] = to_json(point.objectives[i]);
  }
  for (const auto& value : answer.values(point)) {
    if (value.name == "law") continue;
    variables[value.name] = std::isnan(value.number) ? Json(value.text) : to_json(value.number);
  }
  for (std::size_t i = 1; i < point.objectives.size(); ++i) {
    slopes.push_back({{"of", objective(answer, i).name},
                      {"per", objective(answer, 0).name},
                      {"value", to_json(answer.slope(point, i, 0))}});
  }
  const auto law = answer.study.law(point);
  Json limits = Json::array();
  for (const optim::Standing& limit : point.limits) {
    limits.push_back({{"name", limit.name},
                      {"margin", to_json(limit.margin)},
                      {"unit", limit.unit},
                      {"worst_angle", limit.angle ? to_json(*limit.angle) : Json(nullptr)},
                      {"met", limit.met},
                      {"proved", limit.proved},
                      {"price", to_json(limit.price)}});
  }
  return {{"objectives", std::move(objectives)},
          {"variables", std::move(variables)},
          {"law", law ? Json(law->name()) : Json(nullptr)},
          {"verdict", to_string(point.verdict)},
          {"reason", point.reason},
          {"global", point.is_global},
          {"slopes", std::move(slopes)},
          {"limits", std::move(limits)},
          {"solver", point.solver}};
}

Json next_json(const FrontAnswer& answer, std::size_t point) {
  constexpr double kTenth = 0.1;
  Json next = Json::array();
  const auto all = answer.costs();
  for (std::size_t i = 0; i < 2 && answer.front.objectives.size() == 2; ++i) {
    const auto other = optim::cost_of_next(all, point, i, kTenth);
    next.push_back({{"better", objective(answer, i).name},
                    {"by", kTenth},
                    {"other", objective(answer, 1 - i).name},
                    {"value", other ? to_json(answer.value(1 - i, *other)) : Json(nullptr)}});
  }
  return next;
}

}  // namespace

double FrontAnswer::value(std::size_t i, double cost) const {
  return front.objectives[i].sense == optim::Sense::Minimize ? cost : -cost;
}

std::vector<FrontAnswer::Value> FrontAnswer::values(const FrontPoint& point) const {
  const auto& space = study.space();
  const auto options = space.options(point.part);
  std::vector<Value> result;
  for (std::size_t i = 0; i < space.choices.size(); ++i) {
    const optim::Choice& choice = space.choices[i];
    result.push_back({choice.name, choice.unit, choice.options[options[i]],
                      choice.values.empty() ? std::nan("") : choice.values[options[i]]});
  }
  const optim::MultiProblem problem = space.problem(options);
  for (std::size_t i = 0; i < point.x.size(); ++i) {
    const optim::Variable& v = problem.variables[i];
    result.push_back({v.name, v.unit, fmt::format("{:.7g}", point.x[i]), point.x[i]});
  }
  return result;
}

std::string FrontAnswer::law(const FrontPoint& point) const {
  const auto law = study.law(point);
  if (!law) return "";
  const bool program = study.bound().statement().mechanism->moved_by == problems::MovedBy::Program;
  return program ? law->family->formula : law->label();
}

std::string FrontAnswer::family(const FrontPoint& point) const {
  const auto& statement = study.bound().statement();
  if (statement.mechanism->moved_by == problems::MovedBy::Program) {
    if (statement.laws.size() == 1) return "program";
    return fmt::format("program {}", study.space().options(point.part).front() + 1);
  }
  const std::string its_law = law(point);
  return its_law.substr(0, its_law.find(' '));
}

double FrontAnswer::slope(const FrontPoint& point, std::size_t of, std::size_t per) const {
  // At an end one of the costs counts nothing: there the front goes on in one direction only.
  if (point.weights.empty() || !(point.weights[of] > 0) || !(point.weights[per] > 0)) {
    return std::nan("");
  }
  const double sign = (value(of, 1) > 0) == (value(per, 1) > 0) ? 1 : -1;
  return -sign * point.weights[per] / point.weights[of];
}

std::vector<optim::Costs> FrontAnswer::costs() const {
  std::vector<optim::Costs> result;
  for (const FrontPoint& point : front.points) result.push_back(point.costs);
  return result;
}

std::string front_text(const FrontAnswer& answer) {
  const std::string& title = answer.study.bound().statement().title;
  std::string text = title.empty() ? "" : title + "\n\n";
  if (answer.front.points.empty()) {
    return text + "no design that meets every limit was found\n" + work_text(answer);
  }
  text += table_text(answer) + slopes_note(answer) + "\n" + measures_text(answer);
  return text + knee_text(answer) + "\n" + work_text(answer);
}

Json front_json(const FrontAnswer& answer) {
  const Front& front = answer.front;
  Json objectives = Json::array(), points = Json::array(), failures = Json::array();
  for (const auto& o : front.objectives) {
    objectives.push_back({{"name", o.name},
                          {"unit", o.unit},
                          {"sense", o.sense == optim::Sense::Minimize ? "minimize" : "maximize"}});
  }
  for (std::size_t k = 0; k < front.points.size(); ++k) points.push_back(point_object(answer, k));
  for (const optim::FailedTask& failed : front.failures) {
    failures.push_back({{"search", failed.number + 1}, {"why", failed.why}});
  }
  const auto all = answer.costs();
  const auto knee = optim::knee(all);
  Json knee_object(nullptr);
  if (knee) {
    knee_object = {{"point", knee->point},
                   {"factor_low", to_json(knee->low)},
                   {"factor_high", to_json(knee->high)},
                   {"next", next_json(answer, knee->point)}};
  }
  const auto limit = ruler(answer);
  return {{"title", answer.study.bound().statement().title},
          {"objectives", std::move(objectives)},
          {"points", std::move(points)},
          {"ideal", costs_json(answer, front.ideal)},
          {"nadir", costs_json(answer, front.nadir)},
          {"reference", costs_json(answer, front.reference)},
          {"hypervolume", to_json(front.hypervolume)},
          {"hypervolume_at_most",
           front.hypervolume_at_most ? to_json(*front.hypervolume_at_most) : Json(nullptr)},
          {"hypervolume_of_mixtures",
           front.hypervolume_of_mixtures ? to_json(*front.hypervolume_of_mixtures) : Json(nullptr)},
          {"limit_hypervolume", limit && !front.reference.empty()
                                    ? to_json(limit->hypervolume(front.reference))
                                    : Json(nullptr)},
          {"knee", std::move(knee_object)},
          {"complete", front.complete},
          {"searches", front.tasks},
          {"evaluations", front.evaluations},
          {"combinations", front.parts},
          {"empty_combinations", front.empty_parts},
          {"failures", std::move(failures)},
          {"seed", answer.study.options().seed}};
}

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
  header.insert(header.end(), {"verdict", "global", "law"});
  for (const FrontPoint& point : front.points) {
    for (const auto& value : answer.values(point)) {
      if (value.name == "law") continue;
      const std::string column = named(value.name, value.unit);
      if (std::find(columns.begin(), columns.end(), column) == columns.end()) {
        columns.push_back(column);
      }
    }
  }
  header.insert(header.end(), columns.begin(), columns.end());
  std::vector<std::vector<std::string>> rows{header};
  for (const FrontPoint& point : front.points) {
    std::vector<std::string> row;
    for (const double value : point.objectives) row.push_back(exact(value));
    for (std::size_t i = 1; i < front.objectives.size(); ++i) {
      row.push_back(exact(answer.slope(point, i, 0)));
    }
    row.emplace_back(to_string(point.verdict));
    row.emplace_back(point.is_global ? "yes" : "no");
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

std::string point_text(const FrontAnswer& answer, std::size_t k) {
  const FrontPoint& point = answer.front.points[k];
  std::string text = fmt::format("point {}: {}\n{}: {}\n", k + 1, values_text(answer, point.costs),
                                 verdict_text(point), point.reason);
  if (const std::string law = answer.law(point); !law.empty()) text += "  law " + law + "\n";
  const auto values = answer.values(point);
  if (values.size() <= 4 * kListed) {
    for (const auto& value : values) {
      if (value.name == "law") continue;
      text += fmt::format("  {} = {}\n", value.name, with_unit(value.text, value.unit));
    }
  } else {
    text += fmt::format("  {} variables; --json and --csv have them\n", values.size());
  }
  if (!point.limits.empty()) {
    TextTable table({{"limit", TextTable::Align::Left},
                     {"margin"},
                     {"unit", TextTable::Align::Left},
                     {"at"},
                     {"proved", TextTable::Align::Left},
                     {"price"}});
    for (const optim::Standing& limit : point.limits) {
      table.add({limit.name, fmt::format("{:.4g}", limit.margin), limit.unit,
                 limit.angle ? fmt::format("{:.4g}", *limit.angle) : "",
                 limit.proved ? "yes" : "no", fmt::format("{:.4g}", limit.price)});
    }
    text += "\n" + table.text();
  }
  constexpr double kTenth = 0.1;
  const auto all = answer.costs();
  for (std::size_t i = 0; i < 2 && answer.front.objectives.size() == 2; ++i) {
    const auto other = optim::cost_of_next(all, k, i, kTenth);
    text +=
        fmt::format("10 % better {}: {}\n", objective(answer, i).name,
                    other ? fmt::format("{} {} instead of {}", objective(answer, 1 - i).name,
                                        with_its_unit(answer, 1 - i, answer.value(1 - i, *other)),
                                        with_its_unit(answer, 1 - i, point.objectives[1 - i]))
                          : "the front does not reach that far");
  }
  return text;
}

Json point_json(const FrontAnswer& answer, std::size_t k) {
  Json object = point_object(answer, k);
  object["point"] = k;
  object["next"] = next_json(answer, k);
  return object;
}

}  // namespace camlaw::cli
