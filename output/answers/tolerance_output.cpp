// SPDX-License-Identifier: MIT
#include "output/answers/tolerance_output.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "numerics/text/units.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

optim::Problem problem_of(const FrontAnswer& answer, const optim::FrontPoint& point) {
  const optim::ProblemSpace& space = answer.study.space();
  return space.problem(space.options(point.part));
}

std::size_t variable_named(const optim::Problem& problem, const std::string& name) {
  const auto at = std::find_if(problem.variables.begin(), problem.variables.end(),
                               [&](const optim::Variable& v) { return v.name == name; });
  if (at == problem.variables.end()) {
    std::vector<std::string> known;
    for (const optim::Variable& v : problem.variables) known.push_back(v.name);
    throw std::invalid_argument(fmt::format(
        "--tolerance: '{}' is not a variable; the variables are {}", name, fmt::join(known, ", ")));
  }
  return static_cast<std::size_t>(at - problem.variables.begin());
}

}  // namespace

std::vector<double> usual_tolerances(const std::vector<optim::Variable>& variables,
                                     optim::Design x) {
  constexpr double kLength = 0.02, kAngle = 0.1, kShare = 0.01;  // mm, deg, of a value
  std::vector<double> tolerances;
  for (std::size_t i = 0; i < variables.size(); ++i) {
    const optim::Variable& v = variables[i];
    if (v.unit == "mm" || v.unit == "deg") {
      tolerances.push_back(v.unit == "mm" ? kLength : kAngle);
      continue;
    }
    const double range = std::isfinite(v.upper - v.lower) ? v.upper - v.lower : 1;
    tolerances.push_back(kShare * (x[i] != 0 ? std::abs(x[i]) : range));
  }
  return tolerances;
}

std::vector<double> tolerances_of(const FrontAnswer& answer, const optim::FrontPoint& point,
                                  const std::vector<std::string>& assignments) {
  const optim::Problem problem = problem_of(answer, point);
  if (assignments.empty()) return usual_tolerances(problem.variables, point.x);
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
    const double value = parse_quantity(assignment.substr(equals + 1), unit, unit, what);
    if (!(value >= 0 && std::isfinite(value))) {
      throw std::invalid_argument(what + ": it must be a number that is not negative");
    }
    tolerances[i] = value;
  }
  return tolerances;
}

namespace {

/// "stroke +-0.4 mm", of those that are not 0.
std::string tolerances_text(const std::vector<optim::Variable>& variables,
                            const std::vector<double>& tolerances) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < tolerances.size(); ++i) {
    if (tolerances[i] == 0) continue;
    parts.push_back(
        fmt::format("{} +-{}", variables[i].name,
                    with_unit(fmt::format("{:.4g}", tolerances[i]), variables[i].unit)));
  }
  constexpr std::size_t kListed = 6;
  return parts.size() > kListed ? fmt::format("\ntolerances of {} variables\n", parts.size())
                                : fmt::format("\ntolerances: {}\n", fmt::join(parts, ", "));
}

Table spreads_table(const optim::ToleranceReport& report) {
  Table table{
      .key = "spreads",
      .columns = {words("", "name"), numbers("nominal", "nominal"), numbers("lowest", "lowest"),
                  numbers("highest", "highest"), numbers("mean", "mean"),
                  numbers("deviation", "deviation"), numbers("5 %", "low"), numbers("95 %", "high"),
                  words("unit", "unit"), data("margin"), data("possible"), data("by_variable")}};
  const auto number = [](double value, bool possible = true) {
    return Cell(possible ? fmt::format("{:.6g}", value + 0.0) : "not possible", value);
  };
  for (const optim::Spread& s : report.spreads) {
    table.add({{s.is_margin ? "margin of " + s.name : s.name, s.name},
               number(s.nominal),
               number(s.lowest, s.possible || !s.worst_is_lowest),
               number(s.highest, s.possible || s.worst_is_lowest),
               number(s.mean),
               number(s.deviation),
               number(s.low),
               number(s.high),
               s.unit,
               datum(s.is_margin),
               datum(s.possible),
               datum(s.by_variable)});
  }
  return table;
}

}  // namespace

Document spreads_document(const optim::ToleranceReport& report, bool with_yield) {
  Document document;
  document.add(spreads_table(report));
  if (report.impossible_corners + report.impossible_samples > 0) {
    document.say(fmt::format(
        "not possible: {} of the corners and {} of the samples; the model is undefined there\n",
        report.impossible_corners, report.impossible_samples));
  }
  document.say(fmt::format("lowest and highest: over {} and the samples; the rest over {} samples",
                           report.all_corners ? "every corner of the tolerances"
                                              : "the corners that single changes point to",
                           report.samples));
  if (with_yield) {
    document.say(fmt::format(", of which {:.1f} % meet every limit (standard error {:.2g} %)",
                             100 * report.yield, 100 * report.yield_error));
  }
  document.say("\n");
  document.fact("samples", report.samples);
  document.fact("impossible_samples", report.impossible_samples);
  document.fact("impossible_corners", report.impossible_corners);
  if (with_yield) {
    document.fact("yield", report.yield);
    document.fact("yield_error", report.yield_error);
  }
  document.fact("all_corners", report.all_corners);
  return document;
}

Document tolerance_document(const FrontAnswer& answer, const optim::FrontPoint& point,
                            const std::vector<double>& tolerances) {
  const optim::Problem problem = problem_of(answer, point);
  Document document;
  document.say(tolerances_text(problem.variables, tolerances));
  document.fact("tolerances", tolerances);
  document.add(spreads_document(optim::tolerance_report(problem, point.x, tolerances)));
  return document;
}

}  // namespace camlaw::cli
