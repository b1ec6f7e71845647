// SPDX-License-Identifier: MIT
#include "output/answers/tolerance_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/text/units.h"
#include "output/document/text_table.h"

namespace camlaw::cli {
namespace {

optim::MultiProblem problem_of(const FrontAnswer& answer, const optim::FrontPoint& point) {
  const optim::MultiSpace& space = answer.study.space();
  return space.problem(space.options(point.part));
}

std::size_t variable_named(const optim::MultiProblem& problem, const std::string& name) {
  const auto at = std::find_if(problem.variables.begin(), problem.variables.end(),
                               [&](const optim::Variable& v) { return v.name == name; });
  if (at == problem.variables.end()) {
    std::vector<std::string> known;
    for (const optim::Variable& v : problem.variables) known.push_back(v.name);
    throw std::invalid_argument(
        fmt::format("--tolerance: no variable '{}'; there are {}", name, fmt::join(known, ", ")));
  }
  return static_cast<std::size_t>(at - problem.variables.begin());
}

}  // namespace

std::vector<double> hundredths(const std::vector<optim::Variable>& variables, optim::Design x) {
  constexpr double kShare = 0.01;
  std::vector<double> tolerances;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const optim::Variable& v = variables[i];
    const double range = std::isfinite(v.upper - v.lower) ? v.upper - v.lower : 1;
    tolerances.push_back(kShare * (x[i] != 0 ? std::abs(x[i]) : range));
  }
  return tolerances;
}

std::vector<double> tolerances_of(const FrontAnswer& answer, const optim::FrontPoint& point,
                                  const std::vector<std::string>& assignments) {
  const optim::MultiProblem problem = problem_of(answer, point);
  if (assignments.empty()) return hundredths(problem.variables, point.x);
  std::vector<double> tolerances(point.x.size(), 0.0);
  for (const std::string& assignment : assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos) {
      throw std::invalid_argument(fmt::format(
          "--tolerance: '{}' is not of the form name=value, such as stroke=0.1", assignment));
    }
    const std::size_t i = variable_named(problem, assignment.substr(0, equals));
    const std::string& unit = problem.variables[i].unit;
    const std::string what = "--tolerance " + problem.variables[i].name;
    const double value = problems::parse_quantity(assignment.substr(equals + 1), unit, unit, what);
    if (!(value >= 0 && std::isfinite(value))) {
      throw std::invalid_argument(what + ": a number that is not negative is wanted");
    }
    tolerances[i] = value;
  }
  return tolerances;
}

optim::ToleranceReport tolerances_at(const FrontAnswer& answer, const optim::FrontPoint& point,
                                     const std::vector<double>& tolerances) {
  return optim::tolerance_report(problem_of(answer, point), point.x, tolerances);
}

std::string tolerance_text(const FrontAnswer& answer, const optim::FrontPoint& point,
                           const std::vector<double>& tolerances,
                           const optim::ToleranceReport& report) {
  const optim::MultiProblem problem = problem_of(answer, point);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    if (tolerances[i] == 0) continue;
    const optim::Variable& v = problem.variables[i];
    parts.push_back(
        fmt::format("{} +-{}", v.name, with_unit(fmt::format("{:.4g}", tolerances[i]), v.unit)));
  }
  constexpr std::size_t kListed = 6;
  std::string text = parts.size() > kListed
                         ? fmt::format("\ntolerances of {} variables\n", parts.size())
                         : fmt::format("\ntolerances: {}\n", fmt::join(parts, ", "));
  TextTable table({{"", TextTable::Align::Left},
                   {"as meant"},
                   {"lowest"},
                   {"highest"},
                   {"mean"},
                   {"deviation"},
                   {"5 %"},
                   {"95 %"},
                   {"unit", TextTable::Align::Left}});
  const auto number = [](double value) { return fmt::format("{:.6g}", value + 0.0); };
  for (const optim::Spread& s : report.spreads) {
    const std::string none = "not possible";
    table.add({s.is_margin ? "margin of " + s.name : s.name, number(s.nominal),
               s.possible || !s.worst_is_lowest ? number(s.lowest) : none,
               s.possible || s.worst_is_lowest ? number(s.highest) : none, number(s.mean),
               number(s.deviation), number(s.low), number(s.high), s.unit});
  }
  text += table.text();
  if (report.impossible_corners + report.impossible_samples > 0) {
    text += fmt::format(
        "not possible: {} of the corners and {} of the samples; the model gives no number there\n",
        report.impossible_corners, report.impossible_samples);
  }
  return text + fmt::format(
                    "lowest and highest: over {}; the rest over {} samples, of which {:.1f} % meet "
                    "every limit\n",
                    report.all_corners ? "every corner of the tolerances"
                                       : "the corners that single changes point to",
                    report.samples, 100 * report.yield);
}

Json tolerance_json(const std::vector<double>& tolerances, const optim::ToleranceReport& report) {
  Json spreads = Json::array();
  for (const optim::Spread& s : report.spreads) {
    spreads.push_back({{"name", s.name},
                       {"unit", s.unit},
                       {"margin", s.is_margin},
                       {"nominal", to_json(s.nominal)},
                       {"lowest", to_json(s.lowest)},
                       {"highest", to_json(s.highest)},
                       {"possible", s.possible},
                       {"mean", to_json(s.mean)},
                       {"deviation", to_json(s.deviation)},
                       {"low", to_json(s.low)},
                       {"high", to_json(s.high)},
                       {"by_variable", to_json(s.by_variable)}});
  }
  return {{"tolerances", to_json(tolerances)},
          {"samples", report.samples},
          {"impossible_samples", report.impossible_samples},
          {"impossible_corners", report.impossible_corners},
          {"yield", report.yield},
          {"all_corners", report.all_corners},
          {"spreads", std::move(spreads)}};
}

}  // namespace camlaw::cli
