// SPDX-License-Identifier: MIT
#include "output/answers/optimum_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "output/answers/limit_text.h"
#include "output/answers/warnings.h"
#include "output/document/printing.h"
#include "output/document/short_version.h"
#include "output/document/text_table.h"
#include "problems/results/recorded_design.h"
#include "problems/results/seal.h"

namespace camlaw::cli {
namespace {

using optim::Assessment;
using optim::LimitReport;
using optim::VariableReport;

std::string shaded_verdict(optim::Verdict verdict) {
  const bool good = verdict == optim::Verdict::Certified;
  const bool bad = verdict == optim::Verdict::Infeasible || verdict == optim::Verdict::Failed;
  return shaded(std::string(to_string(verdict)), good  ? Shade::Good
                                                 : bad ? Shade::Bad
                                                       : Shade::Unsure);
}

std::string number(double value) { return fmt::format("{:.7g}", value); }

const Assessment& assessment(const Answer& answer) { return answer.optimum.found.assessment; }

std::string objective_name(const Answer& answer) {
  return answer.bound.statement().objectives.front().response.name;
}

const std::string& objective_unit(const Answer& answer) {
  return answer.optimum.problem.objective.response.unit;
}

/// Multipliers are prices of the objective where every limit is met; else they only weigh the
/// limits that contradict one another.
bool has_prices(const Assessment& a) {
  return a.verdict == optim::Verdict::Certified || a.verdict == optim::Verdict::Feasible;
}

std::string limit_table(const Answer& answer) {
  const std::vector<LimitReport> limits = answer.limits();
  if (limits.empty()) return {};
  const bool priced = has_prices(assessment(answer));
  TextTable table({{"limit", TextTable::Align::Left},
                   {"value"},
                   {"bound"},
                   {"margin"},
                   {"unit", TextTable::Align::Left},
                   {"at"},
                   {"proved", TextTable::Align::Left},
                   {priced ? "price" : ""}});
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const LimitReport& limit = limits[i];
    const LimitText text = limit_text(limit, answer.bound.statement().constraints[i]);
    const bool price = priced && limit.multiplier != 0;
    table.add({limit.name, text.value, text.bound, text.margin, limit.unit, text.place,
               limit.proved ? "yes" : "no",
               price                     ? fmt::format("{:.4g}", limit.multiplier)
               : priced && limit.at_rest ? "at rest"
                                         : ""});
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
    if (!limit.at_rest) continue;
    text += fmt::format(
        "  the limit on {} holds the design where the motion rests, and easing it there gains more "
        "than in proportion: it has no price\n",
        limit.name);
  }
  for (const VariableReport& v : a.variables) {
    if (v.at_lower != v.at_upper) {
      add(fmt::format("easing the {} bound of {}", v.at_upper ? "upper" : "lower", v.name), v.unit,
          v.multiplier);
    }
  }
  return text.empty() ? "" : "what limits cost, to first order\n" + text;
}

/// The solver asked for, and the one that ended the search where that is another: what a global
/// method finds a local one polishes.
std::string solver_words(const Answer& answer) {
  const optim::Found& found = answer.optimum.found;
  const bool another = answer.asked != "auto" && answer.asked != found.solver;
  return fmt::format(
      "solver {} ({})",
      another ? fmt::format("{}, then {}", answer.asked, found.solver) : found.solver,
      found.why_solver);
}

std::string how(const Answer& answer) {
  const optim::Found& found = answer.optimum.found;
  std::string text = fmt::format("{} evaluations in {} solves, {:.3g} s; {}", found.evaluations,
                                 found.solves, answer.optimum.wall_s, solver_words(answer));
  if (found.starts > 1) {
    text += fmt::format("\n{} of {} starts ended at this objective", found.agreed, found.starts);
  }
  if (answer.optimum.combinations > 1) {
    text += fmt::format("\n{} combinations, {} problems solved", answer.optimum.combinations,
                        answer.optimum.solved);
  }
  return text;
}

/// Numbers of one list beyond which they are not printed one by one.
constexpr std::size_t kListedOneByOne = 12;

/// "coefficients" of "coefficients[3]"; else empty.
std::string list_of(const std::string& name) {
  const std::size_t bracket = name.find('[');
  return bracket == std::string::npos ? "" : name.substr(0, bracket);
}

/// Where the run of values of one list ends that begins at one.
std::size_t end_of_list(const std::vector<Answer::Value>& values, std::size_t from) {
  const std::string list = list_of(values[from].name);
  std::size_t end = from + 1;
  while (!list.empty() && end < values.size() && list_of(values[end].name) == list) ++end;
  return end;
}

std::string long_list(const std::vector<Answer::Value>& values, std::size_t from, std::size_t end) {
  const auto [least, most] = std::minmax_element(
      values.begin() + static_cast<std::ptrdiff_t>(from),
      values.begin() + static_cast<std::ptrdiff_t>(end),
      [](const Answer::Value& a, const Answer::Value& b) { return a.number < b.number; });
  return fmt::format("  {}: {} numbers from {:.6g} to {}; --json has them\n",
                     list_of(values[from].name), end - from, least->number,
                     with_unit(fmt::format("{:.6g}", most->number), values[from].unit));
}

/// The objective and the variables, where there is a design.
std::string design_text(const Answer& answer) {
  const optim::ObjectiveReport& objective = assessment(answer).objective;
  const problems::ResponseName& response = answer.bound.statement().objectives.front().response;
  if (std::isnan(objective.value)) return "no design was found\n";
  std::string text = fmt::format(
      "{} = {}{}\n\n", objective_name(answer),
      with_unit(fmt::format("{:.10g}", objective.value + 0.0), objective_unit(answer)),
      objective.angle ? fmt::format("  (at {})", place_text(*objective.angle, response)) : "");
  const auto values = answer.values();
  for (std::size_t i = 0; i < values.size();) {
    const std::size_t end = end_of_list(values, i);
    if (end - i > kListedOneByOne) {
      text += long_list(values, i, end);
      i = end;
      continue;
    }
    for (; i < end; ++i) {
      text += fmt::format("  {} = {}\n", values[i].name, with_unit(values[i].text, values[i].unit));
    }
  }
  return text;
}

}  // namespace

std::vector<Answer::Value> Answer::values() const {
  std::vector<Value> result;
  for (std::size_t i = 0; i < space.choices.size() && i < optimum.options.size(); ++i) {
    const optim::Choice& choice = space.choices[i];
    const std::size_t option = optimum.options[i];
    // Of a law not the option's words, which have the starts of what varies.
    const auto chosen = choice.values.empty() ? law() : std::nullopt;
    result.push_back({choice.name, choice.unit, chosen ? chosen->label() : choice.options[option],
                      choice.values.empty() ? std::nan("") : choice.values[option]});
  }
  for (const VariableReport& v : optimum.found.assessment.variables) {
    const double size = std::max({std::abs(v.value), std::abs(v.lower), std::abs(v.upper)});
    const bool noise = std::abs(v.value) < 1e-12 * size;
    result.push_back({v.name, v.unit, fmt::format("{:.10g}", noise ? 0 : v.value), v.value});
  }
  return result;
}

std::optional<Member> Answer::law() const {
  if (bound.statement().mechanism->moved_by == problems::MovedBy::Nothing) return std::nullopt;
  if (optimum.found.x.size() != optimum.problem.variables.size()) return {};
  try {
    return bound.at(optimum.options, optimum.found.x).laws.front().listed();
  } catch (const std::invalid_argument&) {
    return {};  // the design makes no law
  }
}

std::vector<LimitReport> Answer::limits() const {
  return problems::as_stated(bound.statement(), optimum.found.assessment.limits);
}

std::string answer_text(const Answer& answer) {
  const Assessment& a = assessment(answer);
  const std::string& title = answer.bound.statement().title;
  std::string text = title.empty() ? "" : title + "\n";
  text += fmt::format("{}: {}\n", shaded_verdict(a.verdict), a.reason);
  if (a.global) text += fmt::format("global: {}\n", *a.global);
  text += warnings_text(answer.warnings);
  text += fmt::format("\n{}", design_text(answer));
  if (!a.limits.empty()) text += fmt::format("\n{}", limit_table(answer));
  if (!a.active.empty()) text += fmt::format("\nactive: {}\n", fmt::join(a.active, ", "));
  if (const std::string costs = prices(answer); !costs.empty()) text += "\n" + costs;
  if (std::isfinite(a.kkt_residual)) {
    text += fmt::format("\nconditions of {} to {:.1e}; condition of the active limits {}\n",
                        a.verdict == optim::Verdict::Infeasible ? "least violation" : "optimality",
                        a.kkt_residual,
                        std::isinf(a.condition) ? "infinite: their multipliers are not unique"
                                                : fmt::format("{:.2g}", a.condition));
  }
  return text + how(answer) + "\n";
}

Json answer_json(const Answer& answer) {
  const Assessment& a = assessment(answer);
  const optim::Found& found = answer.optimum.found;
  const std::optional<Member> law = answer.law();
  Json variables = Json::object(), units = Json::object();
  for (const Answer::Value& value : answer.values()) {
    variables[value.name] = std::isnan(value.number) ? Json(value.text) : to_json(value.number);
    if (!value.unit.empty()) units[value.name] = value.unit;
  }
  Json constraints = Json::array();
  for (const LimitReport& limit : answer.limits()) {
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
         {"multiplier", to_json(limit.multiplier)},
         {"at_rest", limit.at_rest}});
  }
  Json bounds = Json::array();
  for (const VariableReport& v : a.variables) {
    if (!v.at_lower && !v.at_upper) continue;
    bounds.push_back({{"name", v.name},
                      {"side", v.at_upper ? "upper" : "lower"},
                      {"multiplier", to_json(v.multiplier)}});
  }
  return {
      {"format", problems::kResultFormat.text()},
      {"program", short_version()},
      {"title", answer.bound.statement().title},
      {"status", optim::to_string(found.status)},
      {"verdict", optim::to_string(a.verdict)},
      {"reason", a.reason},
      {"warnings", answer.warnings},
      {"objective", to_json(a.objective.value)},
      {"objective_name", objective_name(answer)},
      {"objective_unit", objective_unit(answer)},
      {"objective_tolerance", to_json(a.objective.tolerance)},
      {"best_possible", a.best_possible ? to_json(*a.best_possible) : Json(nullptr)},
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
      {"solver", found.solver},
      {"solver_asked", answer.asked},
      {"why_solver", found.why_solver},
      {"seed", answer.seed},
      {"law", law ? Json(law->name()) : Json(nullptr)},
      {"design", problems::recorded_design(answer.bound, answer.optimum.options, found.x)}};
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
