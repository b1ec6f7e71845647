// SPDX-License-Identifier: MIT
#include "cli/cycle_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cli/limit_text.h"
#include "cli/text_table.h"

namespace camlaw::cli {
namespace {

Line curve_line(const optim::Trace& trace, int points) {
  Line line;
  const auto breaks = trace.breaks();
  const double cycle = breaks.back() - breaks.front();
  const int least = std::clamp(points / static_cast<int>(breaks.size()), 1, 4);
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double share = (breaks[k + 1] - breaks[k]) / cycle;
    const int steps = std::max(least, static_cast<int>(points * share));
    for (int i = 0; i <= steps; ++i) {
      const optim::Place place = optim::even_place(breaks[k], breaks[k + 1], steps, i);
      line.x.push_back(place.angle);
      line.y.push_back(trace.at(place)[0]);
    }
  }
  return line;
}

/// A dashed line across a panel.
Line level(const Panel& panel, double value) {
  Line line{.name = "limit", .x = {*panel.x.lower, *panel.x.upper}, .y = {value, value}};
  line.colour = "#b00020";
  line.dashed = true;
  line.width = 1.2;
  return line;
}

Panel curve_panel(const optim::Trace& trace, const std::string& name, const std::string& unit,
                  int points = kCyclePoints) {
  Panel panel;
  const auto breaks = trace.breaks();
  panel.x = {.label = breaks.back() > 1 ? "angle" : "x",
             .unit = breaks.back() > 1 ? "deg" : "",
             .lower = breaks.front(),
             .upper = breaks.back()};
  panel.y = {.label = name, .unit = shown_unit(unit)};
  panel.lines.push_back(curve_line(trace, points));
  panel.lines.back().colour = "#0072b2";
  return panel;
}

}  // namespace

Figure cycle_figure(const Answer& answer) {
  Figure figure;
  figure.title = answer.bound.statement().title;
  const optim::Assessment& assessment = answer.optimum.found.assessment;
  const problems::ResponseName& sought = answer.bound.statement().objectives.front().response;
  figure.subtitle =
      fmt::format("{}: {} = {}", to_string(assessment.verdict), sought.name,
                  with_unit(fmt::format("{:.6g}", assessment.objective.value), sought.unit));
  figure.panel_height = 190;
  const optim::Problem& problem = answer.optimum.problem;
  const problems::ProblemStatement& statement = answer.bound.statement();
  const auto& x = answer.optimum.found.x;
  const auto add = [&](const optim::Response& response, const problems::ResponseName& stated,
                       std::vector<double> levels) {
    if (!response.is_curve() || x.empty()) return;
    const auto trace = response.curve().trace(x);
    const std::string& curve = stated.response->name;  // X of "peak X"
    Panel* panel = nullptr;
    for (Panel& known : figure.panels) {
      if (known.y.label == curve) panel = &known;
    }
    if (panel == nullptr) {
      figure.panels.push_back(curve_panel(*trace, curve, response.unit));
      panel = &figure.panels.back();
    }
    for (const double value : levels) panel->lines.push_back(level(*panel, value));
  };
  add(problem.objective.response, statement.objectives.front().response, {});
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const optim::Constraint& c = problem.constraints[i];
    std::vector<double> levels;
    if (c.upper) levels.push_back(*c.upper);
    if (c.lower) levels.push_back(*c.lower);
    add(c.response, statement.constraints[i].response, levels);
  }
  return figure;
}

Figure curves_figure(const problems::ProblemStatement& statement, int points) {
  Figure figure;
  figure.title = statement.title;
  figure.subtitle = statement.mechanism->name;
  if (statement.mechanism->moved_by != problems::MovedBy::Nothing) {
    figure.subtitle += ", " + statement.laws.front().label();
  }
  figure.panel_height = 150;
  for (const optim::Response& response : problems::curves_of(statement)) {
    figure.panels.push_back(
        curve_panel(*response.curve().trace({}), response.name, response.unit, points));
  }
  return figure;
}

void draw_limits(const problems::ProblemStatement& statement, Figure& figure) {
  for (const problems::ConstraintStatement& limit : statement.constraints) {
    if (limit.response.response == nullptr) continue;
    const auto panel =
        std::find_if(figure.panels.begin(), figure.panels.end(),
                     [&](const Panel& p) { return p.y.label == limit.response.response->name; });
    if (panel == figure.panels.end()) continue;
    if (limit.lower) panel->lines.push_back(level(*panel, *limit.lower));
    if (limit.upper) panel->lines.push_back(level(*panel, *limit.upper));
    const bool both_ways = limit.response.part == optim::Part::Magnitude && limit.upper;
    if (both_ways) panel->lines.push_back(level(*panel, -*limit.upper));
  }
}

std::string curves_csv(const problems::ProblemStatement& statement, int steps) {
  const auto curves = problems::curves_of(statement);
  std::vector<std::vector<std::string>> rows(1);
  if (curves.empty()) return to_csv(rows);
  std::vector<std::unique_ptr<optim::Trace>> traces;
  rows.front().push_back(problems::place_name(statement));
  for (const optim::Response& curve : curves) {
    rows.front().push_back(fmt::format("{} [{}]", curve.name, curve.unit));
    traces.push_back(curve.curve().trace({}));
  }
  const auto breaks = traces.front()->breaks();
  for (int i = 0; i <= steps; ++i) {
    const optim::Place place = optim::even_place(breaks.front(), breaks.back(), steps, i);
    rows.emplace_back(1, exact(place.angle));
    for (const auto& trace : traces) rows.back().push_back(exact(trace->at(place)[0]));
  }
  return to_csv(rows);
}

}  // namespace camlaw::cli
