// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "output/answers/front_output.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

Axis axis_of(const optim::ObjectiveName& o) {
  return {.label = o.name, .unit = shown_unit(o.unit)};
}

/// The name under which points stand in the legend: their law's family, or the choice.
std::string group_of(const FrontAnswer& answer, const optim::FrontPoint& point) {
  if (answer.study.space().choices.empty()) return "the front";
  const std::string family = answer.family(point);
  if (!family.empty()) return family;
  std::string group;
  for (const auto& value : answer.values(point)) {
    if (group.empty()) group = fmt::format("{} {}", value.name, value.text);
  }
  return group;
}

std::string tooltip(const FrontAnswer& answer, const optim::FrontPoint& point, std::size_t k) {
  constexpr std::size_t kListed = 6;
  std::string text = fmt::format("point {}", k + 1);
  for (std::size_t i = 0; i < point.objectives.size(); ++i) {
    const auto& o = answer.front.objectives[i];
    text += fmt::format(", {} {}", o.name,
                        with_unit(fmt::format("{:.6g}", point.objectives[i]), o.unit));
  }
  if (const std::string law = answer.law(point); !law.empty()) text += "; " + law;
  const auto values = answer.values(point);
  if (values.size() <= kListed) {
    for (const auto& value : values) text += fmt::format("; {} {}", value.name, value.text);
  }
  return text + fmt::format(": {}", to_string(point.verdict));
}

/// The analytic limit over the range of the lower derivative.
Line limit_line(const FrontAnswer& answer, const problems::FrontRuler& ruler) {
  // The limit bends once or twice, and 200 chords of it show no corner.
  constexpr int kSamples = 200;
  Line line{.name = "no law is below", .colour = "#000000", .dashed = true};
  const auto& front = answer.front;
  const std::size_t lower = ruler.pair().first.objective;
  for (int i = 0; i <= kSamples; ++i) {
    const double x = front.ideal[lower] + (front.nadir[lower] - front.ideal[lower]) * i / kSamples;
    const double y = ruler.least(x);
    line.x.push_back(lower == 0 ? x : y);
    line.y.push_back(lower == 0 ? y : x);
  }
  return line;
}

Panel panel_of(const FrontAnswer& answer, std::size_t across, std::size_t up) {
  Panel panel;
  panel.x = axis_of(answer.front.objectives[across]);
  panel.y = axis_of(answer.front.objectives[up]);
  std::map<std::string, std::size_t> groups;
  for (std::size_t k = 0; k < answer.front.points.size(); ++k) {
    const optim::FrontPoint& point = answer.front.points[k];
    const std::string name = group_of(answer, point);
    const auto [at, fresh] = groups.try_emplace(name, panel.markers.size());
    if (fresh) panel.markers.push_back({.name = name, .size = 3});
    panel.markers[at->second].points.push_back(
        {point.objectives[across], point.objectives[up], "", tooltip(answer, point, k)});
  }
  return panel;
}

void mark_knee(const FrontAnswer& answer, Panel& panel, std::size_t across, std::size_t up) {
  const auto knee = optim::knee(answer.costs(), answer.front.tolerances, answer.front.sizes);
  if (!knee) return;
  const optim::FrontPoint& point = answer.front.points[knee->point];
  Markers mark{.name = "knee",
               .colour = "#000000",
               .shape = MarkerShape::Diamond,
               .filled = false,
               .size = 7};
  mark.points.push_back({point.objectives[across], point.objectives[up], "knee",
                         tooltip(answer, point, knee->point)});
  panel.markers.push_back(std::move(mark));
}

}  // namespace

Figure front_figure(const FrontAnswer& answer) {
  Figure figure;
  const std::size_t objectives = answer.front.objectives.size();
  if (answer.front.points.empty() || objectives > 3) return figure;
  const std::string& title = answer.study.bound().statement().title;
  figure.title = title.empty() ? "Front" : title;
  figure.subtitle = fmt::format("{} points, {} of them certified", answer.front.points.size(),
                                answer.front.certified());
  for (std::size_t up = 1; up < objectives; ++up) {
    for (std::size_t across = 0; across < up; ++across) {
      Panel panel = panel_of(answer, across, up);
      if (objectives == 2 && answer.ruler) {
        panel.lines.push_back(limit_line(answer, *answer.ruler));
      }
      mark_knee(answer, panel, across, up);
      figure.panels.push_back(std::move(panel));
    }
  }
  figure.panel_height = 400;
  return figure;
}

}  // namespace camlaw::cli
