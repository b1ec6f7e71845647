// SPDX-License-Identifier: MIT
#include "cli/optimum_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "cli/text_table.h"

namespace camlaw::cli {
namespace {

using optim::Assessment;
using optim::LimitReport;
using optim::VariableReport;

std::string number(double value) { return fmt::format("{:.7g}", value); }

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit == "1" || unit.empty() ? text : text + " " + unit;
}

const Assessment& assessment(const Answer& answer) { return answer.optimum.found.assessment; }

std::string objective_name(const Answer& answer) {
  return answer.bound.statement().objective->response.name;
}

const std::string& objective_unit(const Answer& answer) {
  return answer.optimum.problem.objective.response.unit;
}

std::string limit_table(const Assessment& a) {
  if (a.limits.empty()) return {};
  TextTable table({{"limit", TextTable::Align::Left},
                   {"value"},
                   {"bound"},
                   {"margin"},
                   {"unit", TextTable::Align::Left},
                   {"at", TextTable::Align::Right},
                   {"proved", TextTable::Align::Left},
                   {"price", TextTable::Align::Right}});
  for (const LimitReport& limit : a.limits) {
    table.add({limit.name, number(limit.value),
               (limit.is_upper ? "<= " : ">= ") + number(limit.bound),
               fmt::format("{:.3g}", limit.margin), limit.unit,
               limit.worst_angle ? fmt::format("{:.2f}", *limit.worst_angle) : "",
               limit.proved ? "yes" : "no",
               limit.multiplier == 0 ? "" : fmt::format("{:.4g}", limit.multiplier)});
  }
  return table.text();
}

/// What one unit more of each pushing limit buys, in words.
std::string prices(const Answer& answer) {
  const Assessment& a = assessment(answer);
  if (a.verdict != optim::Verdict::Certified) return {};
  std::string text;
  const auto add = [&](const std::string& what, const std::string& unit, double price) {
    if (!(std::abs(price) > 1e-9 * std::abs(a.objective.value))) return;
    text += fmt::format("  {} by 1{}: {} better by {}\n", what, unit == "1" ? "" : " " + unit,
                        objective_name(answer),
                        with_unit(fmt::format("{:.4g}", price), objective_unit(answer)));
  };
  for (const LimitReport& limit : a.limits) {
    if (limit.is_equation) continue;
    add(fmt::format("easing the limit on {}", limit.name), limit.unit, limit.multiplier);
  }
  for (const VariableReport& v : a.variables) {
    if (v.at_lower != v.at_upper) {
      add(fmt::format("easing the {} bound of {}", v.at_upper ? "upper" : "lower", v.name), v.unit,
          v.multiplier);
    }
  }
  return text.empty() ? "" : "what limits cost, to first order\n" + text;
}

std::string how(const Answer& answer) {
  const optim::Found& found = answer.optimum.found;
  std::string text = fmt::format(
      "{} evaluations in {} solves, {} s; solver {} ({})", found.evaluations, found.solves,
      fmt::format("{:.3g}", answer.optimum.wall_s), found.solver, found.why_solver);
  if (found.starts > 1) {
    text += fmt::format("\n{} of {} starts ended at this objective", found.agreed, found.starts);
  }
  if (answer.optimum.combinations > 1) {
    text += fmt::format("\n{} combinations, {} problems solved", answer.optimum.combinations,
                        answer.optimum.solved);
  }
  return text;
}

}  // namespace

std::vector<Answer::Value> Answer::values() const {
  std::vector<Value> result;
  for (std::size_t i = 0; i < space.choices.size() && i < optimum.options.size(); ++i) {
    const optim::Choice& choice = space.choices[i];
    const std::size_t option = optimum.options[i];
    result.push_back({choice.name, choice.unit, choice.options[option],
                      choice.values.empty() ? std::nan("") : choice.values[option]});
  }
  for (const VariableReport& v : optimum.found.assessment.variables) {
    result.push_back({v.name, v.unit, fmt::format("{:.10g}", v.value), v.value});
  }
  return result;
}

std::string answer_text(const Answer& answer) {
  const Assessment& a = assessment(answer);
  std::string text =
      fmt::format("{}\n{}: {}\n", answer.bound.statement().title, to_string(a.verdict), a.reason);
  if (a.global) text += fmt::format("global: {}\n", *a.global);
  text += fmt::format("\n{} = {}{}\n\n", objective_name(answer),
                      with_unit(fmt::format("{:.10g}", a.objective.value), objective_unit(answer)),
                      a.objective.angle ? fmt::format("  (at {:.4g})", *a.objective.angle) : "");
  for (const Answer::Value& value : answer.values()) {
    text += fmt::format("  {} = {}\n", value.name, with_unit(value.text, value.unit));
  }
  if (!a.limits.empty()) text += "\n" + limit_table(a);
  if (!a.active.empty()) text += fmt::format("\nactive: {}\n", fmt::join(a.active, ", "));
  if (const std::string costs = prices(answer); !costs.empty()) text += "\n" + costs;
  if (std::isfinite(a.kkt_residual)) {
    text += fmt::format("\nconditions of optimality to {:.1e}; condition of the active limits {}\n",
                        a.kkt_residual,
                        std::isinf(a.condition) ? "infinite: their multipliers are not unique"
                                                : fmt::format("{:.2g}", a.condition));
  }
  return text + how(answer) + "\n";
}

Json answer_json(const Answer& answer) {
  const Assessment& a = assessment(answer);
  const optim::Found& found = answer.optimum.found;
  Json variables = Json::object(), units = Json::object();
  for (const Answer::Value& value : answer.values()) {
    variables[value.name] = std::isnan(value.number) ? Json(value.text) : to_json(value.number);
    if (!value.unit.empty()) units[value.name] = value.unit;
  }
  Json constraints = Json::array();
  for (const LimitReport& limit : a.limits) {
    constraints.push_back(
        {{"name", limit.name},
         {"value", to_json(limit.value)},
         {"bound", limit.bound},
         {"side", limit.is_upper ? "upper" : "lower"},
         {"margin", to_json(limit.margin)},
         {"tolerance", limit.tolerance},
         {"unit", limit.unit},
         {"worst_angle_deg", limit.worst_angle ? to_json(*limit.worst_angle) : Json(nullptr)},
         {"met", limit.met},
         {"proved", limit.proved},
         {"multiplier", to_json(limit.multiplier)}});
  }
  Json bounds = Json::array();
  for (const VariableReport& v : a.variables) {
    if (!v.at_lower && !v.at_upper) continue;
    bounds.push_back({{"name", v.name},
                      {"side", v.at_upper ? "upper" : "lower"},
                      {"multiplier", to_json(v.multiplier)}});
  }
  return {
      {"title", answer.bound.statement().title},
      {"status", optim::to_string(found.status)},
      {"verdict", optim::to_string(a.verdict)},
      {"reason", a.reason},
      {"objective", to_json(a.objective.value)},
      {"objective_name", objective_name(answer)},
      {"objective_unit", objective_unit(answer)},
      {"objective_proved", {to_json(a.objective.proved.lower), to_json(a.objective.proved.upper)}},
      {"variables", std::move(variables)},
      {"units", std::move(units)},
      {"constraints", std::move(constraints)},
      {"active", a.active},
      {"active_bounds", std::move(bounds)},
      {"blamed", a.blamed},
      {"kkt_residual", to_json(a.kkt_residual)},
      {"second_order", a.second_order},
      {"condition", to_json(a.condition)},
      {"global", a.global ? Json(*a.global) : Json(nullptr)},
      {"starts", found.starts},
      {"agreed", found.agreed},
      {"combinations", answer.optimum.combinations},
      {"evaluations", found.evaluations},
      {"iterations", found.iterations},
      {"solves", found.solves},
      {"wall_s", answer.optimum.wall_s},
      {"solver", found.solver},
      {"why_solver", found.why_solver}};
}

namespace {

Line curve_line(const optim::Trace& trace) {
  constexpr int kPoints = 720;
  Line line;
  const auto breaks = trace.breaks();
  const double cycle = breaks.back() - breaks.front();
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double share = (breaks[k + 1] - breaks[k]) / cycle;
    const int steps = std::max(4, static_cast<int>(kPoints * share));
    for (int i = 0; i <= steps; ++i) {
      const double angle =
          i == steps ? breaks[k + 1] : std::lerp(breaks[k], breaks[k + 1], i / double(steps));
      line.x.push_back(angle);
      line.y.push_back(trace.at({angle, i == steps})[0]);
    }
  }
  return line;
}

/// A dashed line across the cycle.
Line level(const optim::Trace& trace, double value) {
  const auto breaks = trace.breaks();
  Line line{.name = "limit", .x = {breaks.front(), breaks.back()}, .y = {value, value}};
  line.colour = "#b00020";
  line.dashed = true;
  line.width = 1.2;
  return line;
}

}  // namespace

Figure cycle_figure(const Answer& answer) {
  Figure figure;
  figure.title = answer.bound.statement().title;
  figure.subtitle = fmt::format(
      "{}: {} = {}", to_string(assessment(answer).verdict), objective_name(answer),
      with_unit(fmt::format("{:.6g}", assessment(answer).objective.value), objective_unit(answer)));
  figure.panel_height = 190;
  const optim::Problem& problem = answer.optimum.problem;
  const auto& x = answer.optimum.found.x;
  const auto add = [&](const optim::Response& response, std::vector<double> levels) {
    if (!response.is_curve() || x.empty()) return;
    const auto trace = response.curve().trace(x);
    Panel* panel = nullptr;
    for (Panel& known : figure.panels) {
      if (known.y.label == response.name) panel = &known;
    }
    if (panel == nullptr) {
      Panel fresh;
      const auto breaks = trace->breaks();
      fresh.x = {.label = breaks.back() > 1 ? "cam angle" : "x",
                 .unit = breaks.back() > 1 ? "deg" : "",
                 .lower = breaks.front(),
                 .upper = breaks.back()};
      fresh.y = {.label = response.name, .unit = response.unit == "1" ? "" : response.unit};
      fresh.lines.push_back(curve_line(*trace));
      fresh.lines.back().colour = "#0072b2";
      figure.panels.push_back(std::move(fresh));
      panel = &figure.panels.back();
    }
    for (const double value : levels) panel->lines.push_back(level(*trace, value));
  };
  add(problem.objective.response, {});
  for (const optim::Constraint& c : problem.constraints) {
    std::vector<double> levels;
    if (c.upper) levels.push_back(*c.upper);
    if (c.lower) levels.push_back(*c.lower);
    add(c.response, levels);
  }
  return figure;
}

std::string scaling_text(const optim::Problem& problem) {
  const optim::Sizes sizes = optim::sizes(problem, problem.start());
  TextTable table({{"scaling", TextTable::Align::Left},
                   {"size"},
                   {"tolerance"},
                   {"unit", TextTable::Align::Left}});
  for (std::size_t i = 0; i < problem.variables.size(); ++i) {
    table.add(
        {problem.variables[i].name, number(sizes.variables[i]), "", problem.variables[i].unit});
  }
  table.add({problem.objective.response.name + " (objective)", number(sizes.objective),
             number(sizes.objective_tolerance), problem.objective.response.unit});
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    table.add({problem.constraints[i].response.name, number(sizes.constraints[i].size),
               number(sizes.constraints[i].tolerance), problem.constraints[i].response.unit});
  }
  return table.text();
}

}  // namespace camlaw::cli
