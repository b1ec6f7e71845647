// SPDX-License-Identifier: MIT
#include "output/answers/study_fronts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "output/document/text_table.h"

namespace camlaw::cli {
namespace {

using problems::ProvedFront;
using problems::SpineCutterFronts;

std::array<const ProvedFront*, 3> all(const SpineCutterFronts& fronts) {
  return {&fronts.families, &fronts.smooth, &fronts.free};
}

/// About eight points of a front, its ends among them.
std::vector<std::size_t> some_of(const optim::Front& front) {
  constexpr std::size_t kShown = 8;
  std::vector<std::size_t> shown;
  const std::size_t last = front.points.size() - 1;
  for (std::size_t i = 0; i < kShown; ++i) {
    const std::size_t k = (last * i + (kShown - 1) / 2) / (kShown - 1);
    if (shown.empty() || k > shown.back()) shown.push_back(k);
  }
  return shown;
}

std::string front_lines(const ProvedFront& front) {
  if (front.front.points.empty()) return fmt::format("{}: no design was found\n", front.name);
  std::string text = fmt::format(
      "{}: {} of {} points certified in {} searches; hypervolume{} {:.2f} % of the limit's\n",
      front.name, front.front.certified(), front.front.points.size(), front.front.tasks,
      front.front.hypervolume_of_mixtures ? " with mixtures of neighbours" : " of the points alone",
      100 * front.share_of_limit);
  TextTable table({{"R, mm"}, {"F, N"}, {"N per mm"}, {"law", TextTable::Align::Left}});
  for (const std::size_t k : some_of(front.front)) {
    const optim::FrontPoint& p = front.front.points[k];
    table.add({shown(p.objectives[0], 2), shown(p.objectives[1], 3),
               shown(front.front.slope(p, 1, 0), 3), front.laws[k]});
  }
  return text + table.text();
}

std::string saving_text(const problems::Saving& saving) {
  const auto less = [](double from, double to) { return 100 * (1 - to / from); };
  return fmt::format(
      "{} (R {:.2f} mm, F {:.3f} N): with the same cam the force could be {:.3f} N, {:.1f} % less "
      "({}); with the same force the cam could be {:.2f} mm, {:.1f} % smaller ({})\n",
      saving.law, saving.cam_radius, saving.inertia_force, saving.least_force,
      less(saving.inertia_force, saving.least_force), to_string(saving.force_verdict),
      saving.least_radius, less(saving.cam_radius, saving.least_radius),
      to_string(saving.radius_verdict));
}

}  // namespace

std::string fronts_text(const SpineCutterFronts& fronts) {
  std::string text = "proved fronts: the least force for a cam radius, from B = 1.17 to 2\n";
  for (const ProvedFront* front : all(fronts)) text += fmt::format("\n{}", front_lines(*front));
  text += "\nagainst the published choices, the free law:\n";
  for (const problems::Saving& saving : fronts.savings) text += "  " + saving_text(saving);
  return text;
}

std::string fronts_csv(const SpineCutterFronts& fronts) {
  std::vector<std::vector<std::string>> rows{
      {"front", "cam_radius_mm", "inertia_force_N", "slope_N_per_mm", "law", "verdict"}};
  for (const ProvedFront* front : all(fronts)) {
    for (std::size_t k = 0; k < front->front.points.size(); ++k) {
      const optim::FrontPoint& p = front->front.points[k];
      rows.push_back({front->name, exact(p.objectives[0]), exact(p.objectives[1]),
                      exact(front->front.slope(p, 1, 0)), front->laws[k],
                      std::string(to_string(p.verdict))});
    }
  }
  return to_csv(rows);
}

Json fronts_json(const SpineCutterFronts& fronts) {
  Json result = Json::array(), savings = Json::array();
  for (const ProvedFront* front : all(fronts)) {
    Json points = Json::array();
    for (std::size_t k = 0; k < front->front.points.size(); ++k) {
      const optim::FrontPoint& p = front->front.points[k];
      points.push_back({{"cam_radius_mm", to_json(p.objectives[0])},
                        {"inertia_force_N", to_json(p.objectives[1])},
                        {"law", front->laws[k]},
                        {"verdict", to_string(p.verdict)}});
    }
    result.push_back({{"name", front->name},
                      {"hypervolume", to_json(front->front.hypervolume)},
                      {"share_of_limit", to_json(front->share_of_limit)},
                      {"points", std::move(points)}});
  }
  for (const problems::Saving& saving : fronts.savings) {
    savings.push_back({{"law", saving.law},
                       {"cam_radius_mm", saving.cam_radius},
                       {"inertia_force_N", saving.inertia_force},
                       {"least_radius_mm", to_json(saving.least_radius)},
                       {"least_force_N", to_json(saving.least_force)},
                       {"radius_verdict", to_string(saving.radius_verdict)},
                       {"force_verdict", to_string(saving.force_verdict)}});
  }
  return {{"fronts", std::move(result)}, {"savings", std::move(savings)}};
}

void draw_fronts(const SpineCutterFronts& fronts, Panel& panel) {
  constexpr std::array kColours{"#56b4e9", "#d55e00", "#009e73"};
  const auto list = all(fronts);
  for (std::size_t i = 0; i < list.size(); ++i) {
    Line line{.name = "front: " + list[i]->name, .colour = kColours[i]};
    for (const optim::FrontPoint& p : list[i]->front.points) {
      line.x.push_back(p.objectives[0]);
      line.y.push_back(p.objectives[1]);
    }
    panel.lines.push_back(std::move(line));
  }
}

}  // namespace camlaw::cli
