// SPDX-License-Identifier: MIT
#include "output/answers/cycle_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "optim/cycle/extremes.h"
#include "output/answers/limit_text.h"
#include "output/document/formatting.h"
#include "problems/statement/speed_curves.h"

namespace camlaw::cli {
namespace {

Line even_line(const optim::Trace& trace, int points) {
  Line line;
  const auto breaks = trace.breaks();
  const double cycle = breaks.back() - breaks.front();
  const int least = std::clamp(points / static_cast<int>(breaks.size()), 1, 4);
  std::vector<optim::Place> places;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const double share = (breaks[k + 1] - breaks[k]) / cycle;
    const int steps = std::max(least, static_cast<int>(points * share));
    const auto here = optim::even_places(breaks[k], breaks[k + 1], steps);
    places.insert(places.end(), here.begin(), here.end());
  }
  for (const optim::Place& place : places) line.x.push_back(place.angle);
  line.y = trace.values(places);
  return line;
}

/// Puts a peak and places about it, closer and closer, among the points of a line.
void add_peak(const optim::Trace& trace, double peak, Line& line) {
  // To 1/4096 of a step of the line: narrower spikes are as wide as their line is drawn.
  constexpr int kHalvings = 12;
  const auto after = std::upper_bound(line.x.begin(), line.x.end(), peak);
  if (after == line.x.begin() || after == line.x.end()) return;
  const double before = *(after - 1), behind = *after;
  std::vector<double> places;
  for (int k = 1; k <= kHalvings; ++k) places.push_back(std::lerp(peak, before, std::exp2(-k)));
  places.push_back(peak);
  for (int k = kHalvings; k >= 1; --k) places.push_back(std::lerp(peak, behind, std::exp2(-k)));
  std::vector<double> values;
  for (const double place : places) values.push_back(trace.at({place})[0]);
  const auto at = after - line.x.begin();
  line.x.insert(line.x.begin() + at, places.begin(), places.end());
  line.y.insert(line.y.begin() + at, values.begin(), values.end());
}

/// A curve's highest or lowest value and its place.
struct KnownPeak {
  double value, at;
};

KnownPeak peak_of(const optim::Trace& trace, double sign, double size,
                  const problems::EvaluatedResponse* evaluated) {
  if (evaluated != nullptr) {
    return sign > 0 ? KnownPeak{evaluated->highest, evaluated->highest_at}
                    : KnownPeak{evaluated->lowest, evaluated->lowest_at};
  }
  const optim::Extreme peak = optim::proved_highest(trace, sign, size).peak;
  return {peak.value, peak.place.angle};
}

/// Even points, and more about a highest or lowest value that these would not show.
Line curve_line(const optim::Trace& trace, int points,
                const problems::EvaluatedResponse* evaluated = nullptr) {
  constexpr double kSeen = 1e-3;  // of the range
  Line line = even_line(trace, points);
  const auto [low, high] = std::minmax_element(line.y.begin(), line.y.end());
  const double lowest = *low, highest = *high, range = highest - lowest;
  if (!std::isfinite(range)) return line;
  const double size = std::max(std::abs(lowest), std::abs(highest));
  for (const double sign : {1.0, -1.0}) {
    const KnownPeak peak = peak_of(trace, sign, size, evaluated);
    const double seen = sign > 0 ? highest : -lowest;
    if (std::isfinite(peak.value) && sign * peak.value > seen + kSeen * range) {
      add_peak(trace, peak.at, line);
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

/// What a curve runs over: a cam's angle, the law's x, or a range of speeds.
enum class Over { Cycle, Speed };

Panel curve_panel(const optim::Trace& trace, const std::string& name, const std::string& unit,
                  Over over, int points = kCyclePoints,
                  const problems::EvaluatedResponse* evaluated = nullptr) {
  Panel panel;
  const auto breaks = trace.breaks();
  panel.x = {.label = breaks.back() > 1 ? "angle" : "x",
             .unit = breaks.back() > 1 ? "deg" : "",
             .lower = breaks.front(),
             .upper = breaks.back()};
  if (over == Over::Speed) panel.x.label = "speed", panel.x.unit = "rpm";
  panel.y = {.label = name, .unit = shown_unit(unit)};
  panel.lines.push_back(curve_line(trace, points, evaluated));
  panel.lines.back().colour = "#0072b2";
  return panel;
}

/// The responses in load cases that are limited or sought: of the others the figures are those of
/// the file's constants alone.
std::set<std::string> responses_in_cases(const problems::ProblemStatement& statement) {
  std::set<std::string> names;
  const auto add = [&](const problems::ResponseName& name) {
    if (name.response == nullptr) return;
    if (name.response->in_case) names.insert(name.response->name);
    for (const auto& one : name.response->over_cases) names.insert(one.response->name);
  };
  for (const auto& objective : statement.objectives) add(objective.response);
  for (const auto& limit : statement.constraints) add(limit.response);
  return names;
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
      const Over over = is_over_speed(*stated.response) ? Over::Speed : Over::Cycle;
      figure.panels.push_back(curve_panel(*trace, curve, response.unit, over));
      panel = &figure.panels.back();
    }
    for (const double value : levels) panel->lines.push_back(level(*panel, value));
  };
  if (sought.response != nullptr && !sought.response->over_cases.empty() && !x.empty()) {
    const problems::Binding binding = answer.bound.binding(answer.optimum.options);
    for (const problems::ResponseName& one : sought.response->over_cases) {
      add(problems::response_of(statement, one, binding), one, {});
    }
  } else {
    add(problem.objective().response, sought, {});
  }
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const optim::Constraint& c = problem.constraints[i];
    std::vector<double> levels;
    if (c.upper) levels.push_back(*c.upper);
    if (c.lower) levels.push_back(*c.lower);
    add(c.response, statement.constraints[i].response, levels);
  }
  return figure;
}

Figure curves_figure(const problems::ProblemStatement& statement, int points,
                     const std::vector<problems::EvaluatedResponse>& evaluated) {
  Figure figure;
  figure.title = statement.title;
  figure.subtitle = statement.mechanism->name;
  if (statement.mechanism->moved_by != problems::MovedBy::Nothing) {
    figure.subtitle += ", " + statement.laws.front().label();
  }
  figure.panel_height = 150;
  const std::set<std::string> in_cases = responses_in_cases(statement);
  const auto is_left_out = [&](const std::string& name) {
    const auto& all = statement.mechanism->responses;
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const auto& r) { return r.name == name; });
    return found != all.end() && found->in_case && !in_cases.contains(name);
  };
  const auto add = [&](const std::vector<optim::Response>& curves, Over over) {
    for (const optim::Response& response : curves) {
      if (is_left_out(response.name)) continue;
      const auto known = std::find_if(evaluated.begin(), evaluated.end(), [&](const auto& e) {
        return e.is_curve && e.name == response.name;
      });
      figure.panels.push_back(curve_panel(*response.curve().trace({}), response.name, response.unit,
                                          over, points,
                                          known == evaluated.end() ? nullptr : &*known));
    }
  };
  add(problems::curves_of(statement), Over::Cycle);
  add(problems::curves_over_speed(statement), Over::Speed);
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
  rows.front().push_back(problems::place_name(statement));
  const auto breaks = curves.front().curve().trace({})->breaks();
  const auto places = optim::even_places(breaks.front(), breaks.back(), steps);
  for (const optim::Place& place : places) rows.emplace_back(1, exact(place.angle));
  for (const optim::Response& curve : curves) {
    rows.front().push_back(fmt::format("{} [{}]", curve.name, curve.unit));
    const std::vector<double> values = curve.curve().trace({})->values(places);
    for (std::size_t i = 0; i < values.size(); ++i) rows[i + 1].push_back(exact(values[i]));
  }
  return to_csv(rows);
}

}  // namespace camlaw::cli
