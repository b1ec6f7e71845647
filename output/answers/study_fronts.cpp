// SPDX-License-Identifier: MIT
#include "output/answers/study_fronts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "output/document/formatting.h"

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

Table proved_points_table(const ProvedFront& front, const std::vector<std::size_t>& points) {
  Table table{.key = "points",
              .columns = {data("front"), numbers("R, mm", "cam_radius_mm"),
                          numbers("F, N", "inertia_force_N"), numbers("N per mm", "slope_N_per_mm"),
                          words("law", "law"), data("verdict")}};
  for (const std::size_t k : points) {
    const optim::FrontPoint& p = front.front.points[k];
    table.add({datum(front.name), shown_cell(p.objectives[0], 2), shown_cell(p.objectives[1], 3),
               shown_cell(front.front.slope(p, 1, 0), 3), front.laws[k],
               datum(to_string(p.verdict))});
  }
  return table;
}

std::vector<std::size_t> all_of(const optim::Front& front) {
  std::vector<std::size_t> points(front.points.size());
  std::iota(points.begin(), points.end(), std::size_t{0});
  return points;
}

Document proved_front_document(const ProvedFront& front) {
  Document document;
  document.fact("name", front.name);
  document.fact("hypervolume", front.front.hypervolume);
  document.fact("fraction_of_limit", front.share_of_limit);
  document.fact("points", json_of(proved_points_table(front, all_of(front.front))));
  if (front.front.points.empty()) {
    document.say(fmt::format("\n{}: no design was found\n", front.name));
    return document;
  }
  document.say(fmt::format(
      "\n{}: {} of {} points certified in {} searches; hypervolume{} {:.2f} % of the limit's\n",
      front.name, front.front.certified(), front.front.points.size(), front.front.tasks,
      front.front.hypervolume_of_mixtures ? " with mixtures of neighbours" : " of the points alone",
      100 * front.share_of_limit));
  Table some = proved_points_table(front, some_of(front.front));
  some.key.clear();
  document.add(std::move(some));
  return document;
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

Document fronts_document(const SpineCutterFronts& fronts) {
  Document document;
  document.say("proved fronts: the least force for a cam radius, from C_v = 1.17 to 2\n");
  std::vector<Document> parts;
  for (const ProvedFront* front : all(fronts)) parts.push_back(proved_front_document(*front));
  document.add("fronts", std::move(parts));
  document.say("\nagainst the published choices, the free law:\n");
  Json savings = Json::array();
  for (const problems::Saving& saving : fronts.savings) {
    document.say("  " + saving_text(saving));
    savings.push_back({{"law", saving.law},
                       {"cam_radius_mm", saving.cam_radius},
                       {"inertia_force_N", saving.inertia_force},
                       {"least_radius_mm", to_json(saving.least_radius)},
                       {"least_force_N", to_json(saving.least_force)},
                       {"radius_verdict", to_string(saving.radius_verdict)},
                       {"force_verdict", to_string(saving.force_verdict)}});
  }
  document.fact("savings", savings);
  return document;
}

Table fronts_table(const SpineCutterFronts& fronts) {
  const auto list = all(fronts);
  Table table = proved_points_table(*list.front(), {});
  for (const ProvedFront* front : list) {
    for (auto& row : proved_points_table(*front, all_of(front->front)).rows)
      table.add(std::move(row));
  }
  return table;
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
