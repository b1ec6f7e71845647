// SPDX-License-Identifier: MIT
#include "output/report/sensitivity_section.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "output/answers/sensitivity_output.h"
#include "output/answers/tolerance_output.h"
#include "output/document/formatting.h"
#include "output/report/html.h"
#include "problems/statement/speed_curves.h"

namespace camlaw::cli {
namespace {

/// Variables beyond which a table has no column for each.
constexpr std::size_t kListedBars = 6;

std::string number(double value) { return fmt::format("{:.4g}", value + 0.0); }

/// A number of a spread, beside whose values rounding shows as such.
std::string number(double value, const optim::Spread& spread) {
  double size = 0;
  for (const double other : {spread.nominal, spread.lowest, spread.highest}) {
    if (std::isfinite(other)) size = std::max(size, std::abs(other));
  }
  return significant(value, size, 4);
}

std::string name_of(const optim::Spread& spread) {
  return (spread.is_margin ? "margin of " : "") + spread.name;
}

std::string change_table(const std::vector<optim::Variable>& variables,
                         const std::vector<double>& tolerances,
                         const optim::ToleranceReport& report) {
  Table table{.columns = {names("change of"), words("unit")}};
  for (std::size_t i = 0; i < variables.size(); ++i) {
    table.columns.push_back(
        numbers(fmt::format("by {} \u00b1 {}", variables[i].name,
                            with_unit(number(tolerances[i]), variables[i].unit))));
  }
  for (const optim::Spread& spread : report.spreads) {
    std::vector<Cell> cells{name_of(spread), shown_unit(spread.unit)};
    for (const double change : spread.by_variable) cells.push_back(number(change, spread));
    table.add(std::move(cells));
  }
  return html_of(table);
}

std::string spread_table(const optim::ToleranceReport& report) {
  Table table{.columns = {names(""), numbers("nominal"), numbers("lowest"), numbers("highest"),
                          numbers("5 %"), numbers("95 %"), words("unit")}};
  for (const optim::Spread& s : report.spreads) {
    const std::string none = "not possible";
    table.add({name_of(s), number(s.nominal, s),
               s.possible || !s.worst_is_lowest ? number(s.lowest, s) : none,
               s.possible || s.worst_is_lowest ? number(s.highest, s) : none, number(s.low, s),
               number(s.high, s), shown_unit(s.unit)});
  }
  return html_of(table);
}

}  // namespace

ReportSection sensitivity_section(const optim::Problem& problem, optim::Design x) {
  constexpr std::size_t kSamples = 300;  // a page is to be there at once
  const auto& variables = problem.variables;
  const std::vector<double> tolerances = usual_tolerances(variables, x);
  const optim::ToleranceReport report = optim::tolerance_report(problem, x, tolerances, kSamples);
  std::string html =
      paragraph(fmt::format("How the design changes when {} either way: a length by up to "
                            "0.02 mm, an angle by up to "
                            "0.1 deg, anything else by up to a hundredth of its value.",
                            variables.size() == 1 ? plain_name(variables.front().name) + " deviates"
                                                  : "each continuous variable deviates"));
  if (variables.size() <= kListedBars) html += change_table(variables, tolerances, report);
  html += spread_table(report);
  std::string notes = fmt::format(
      "Lowest and highest over {}; the rest over {} samples, of which {:.1f} % meet every limit.",
      report.all_corners ? "every corner of the tolerances"
                         : "the corners that single changes point to",
      report.samples, 100 * report.yield);
  if (report.yield < 1) {
    notes +=
        " A design that stands at a limit passes it with the slightest deviation to one side, so "
        "about half of the samples are to be expected beyond it. For parts that all meet the "
        "limits "
        "state the tolerances of manufacture under [variation]: the search then keeps a margin.";
  }
  if (report.impossible_corners + report.impossible_samples > 0) {
    notes += fmt::format(" Not possible: {} of the corners and {} of the samples.",
                         report.impossible_corners, report.impossible_samples);
  }
  return {"sensitivity", "Tolerances", html + paragraph(notes)};
}

namespace {

/// Whether objectives or limits are curves over speeds, each point of which is a search of its own.
bool asks_over_speeds(const problems::ProblemStatement& design) {
  const auto is_slow = [](const auto& asked) {
    const auto* response = asked.response.response;
    return response != nullptr && response->curve && problems::is_over_speed(*response);
  };
  return std::any_of(design.objectives.begin(), design.objectives.end(), is_slow) ||
         std::any_of(design.constraints.begin(), design.constraints.end(), is_slow);
}

}  // namespace

namespace {

/// Each line of a table's note as a sentence.
std::string sentences(const std::string& lines) {
  std::string html;
  std::istringstream in(lines);
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    if (line.back() != '.') line += '.';
    html += paragraph(capitalised(line));
  }
  return html;
}

}  // namespace

std::optional<ReportSection> derivatives_section(const problems::ProblemStatement& design) {
  constexpr std::size_t kMostRanges = 24, kSamples = 64;  // a page is to be there at once
  const auto parameters = problems::design_parameters(design);
  if (parameters.empty() || problems::design_numbers(design, parameters).empty()) return {};
  const auto local = problems::local_sensitivity(design);
  std::string html = sentences(local_sensitivity_words(local));
  html += html_of(local_sensitivity_table(local));
  auto ranges = problems::sensitivity_ranges(design, {});
  const bool is_quick = ranges.ranges.size() <= kMostRanges && !asks_over_speeds(design);
  if (!ranges.ranges.empty() && is_quick) {
    const auto global =
        problems::global_sensitivity(design, std::move(ranges), {.samples = kSamples});
    html += sentences(global_sensitivity_words(global));
    html += html_of(global_sensitivity_table(global));
  }
  return ReportSection{"derivatives", "Sensitivities", html};
}

}  // namespace camlaw::cli
