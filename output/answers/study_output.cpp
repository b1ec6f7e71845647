// SPDX-License-Identifier: MIT
#include "output/answers/study_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "output/answers/answer_formats.h"
#include "output/document/formatting.h"
#include "output/figure/law_figure.h"

namespace camlaw::cli {
namespace {

using problems::SpineCutterStudy;
using problems::StudyRow;

std::string marks(const StudyRow& row) {
  return fmt::format("{}{}{}", row.non_dominated ? '*' : ' ', row.smooth_non_dominated ? 'o' : ' ',
                     row.published ? 'p' : ' ');
}

/// Whether a published law stands at the same point (the cosine and its turn-to-turn twin).
bool hidden_by_published(const SpineCutterStudy& study, const StudyRow& row) {
  return !row.published &&
         std::any_of(study.rows.begin(), study.rows.end(), [&](const StudyRow& other) {
           return other.published && other.cam_radius == row.cam_radius &&
                  other.inertia_force == row.inertia_force;
         });
}

}  // namespace

Table study_table(const SpineCutterStudy& study) {
  Table table{
      .key = "rows",
      .columns = {words("law", "law"), words(""), numbers("C_v", "C_v"), numbers("C_a", "C_a"),
                  numbers("C_j", "C_j"), numbers("C_Mdyn", "C_Mdyn"), numbers("lambda", "lambda"),
                  numbers("R, mm", "cam_radius_mm"), numbers("F, N", "inertia_force_N"),
                  numbers("F by (7), N", "printed_inertia_force_N"),
                  numbers("torque, N m", "drive_torque_Nm"),
                  numbers("above limit, %", "above_limit"), data("smooth"), data("non_dominated"),
                  data("smooth_non_dominated"), data("published")}};
  for (const StudyRow& row : study.rows) {
    const double radius = row.cam_radius * 1e3;
    table.add({{row.label, row.law},
               marks(row),
               shown_cell(row.peaks.max_velocity(), 4),
               shown_cell(row.peaks.max_acceleration(), 4),
               shown_cell(row.peaks.max_jerk(), 2),
               shown_cell(row.peaks.max_dynamic_moment(), 4),
               row.limit_index ? shown_cell(*row.limit_index, 3) : Cell("-", Json(nullptr)),
               shown_cell(radius, 2),
               shown_cell(row.inertia_force, 3),
               shown_cell(row.printed_inertia_force, 3),
               shown_cell(row.drive_torque, 4),
               {shown(row.above_limit * 100, 1), row.above_limit},
               datum(row.smooth),
               datum(row.non_dominated),
               datum(row.smooth_non_dominated),
               datum(row.published)});
  }
  return table;
}

Document study_document(const SpineCutterStudy& study) {
  Document document;
  document.fact("format", kTradeOffFormat.text());
  document.fact("study", "spine-cutter");
  document.say("Spine cutter: which motion law for the cam?\n\ninputs\n");
  Json givens = Json::array();
  for (const auto& given : problems::givens(study.cutter)) {
    document.say(fmt::format("  {:<16} {:<4} = {:g}{}  ({})\n", given.name, given.symbol,
                             given.value, given.unit == "1" ? "" : " " + given.unit,
                             given.meaning));
    givens.push_back({{"name", given.name},
                      {"symbol", given.symbol},
                      {"value", given.value},
                      {"unit", given.unit}});
  }
  document.fact("givens", givens);
  document.say("\n");
  document.add(study_table(study));
  document.say(fmt::format(
      "\n*  non-dominated in (R, F)   o  non-dominated among laws of continuous acceleration   "
      "p  in the paper\n"
      "F: physical peak inertia force; F by (7): as the paper prints its formula, half of it\n"
      "above limit: C_a over the least of any law with this C_v (C_v^2/(C_v-1) up to C_v = 2, then "
      "4)\n\n"
      "{}\n",
      study.recommendation));
  document.fact("smallest_cam", study.rows[study.smallest_cam].law);
  document.fact("least_force", study.rows[study.least_force].law);
  document.fact("compromise", study.rows[study.compromise].law);
  document.fact("recommendation", study.recommendation);
  return document;
}

Figure trade_off_figure(const SpineCutterStudy& study) {
  // The frame holds B from 1.1 to 2.35 and C from 3.7 (below the least possible) to 9.5, where
  // nearly all laws lie; the few outliers would squeeze the rest into a corner.
  const double smallest = problems::minimum_cam_radius(study.cutter, 1.1) * 1e3;
  const double largest = problems::minimum_cam_radius(study.cutter, 2.35) * 1e3;
  const double floor = problems::peak_inertia_force(study.cutter, 3.7);
  const double ceiling = problems::peak_inertia_force(study.cutter, 9.5);
  Panel panel;
  panel.x = {.label = "cam radius R", .unit = "mm", .lower = smallest, .upper = largest};
  panel.y = {.label = "peak inertia force F", .unit = "N", .lower = floor, .upper = ceiling};
  Line limit{.name = "least force of any law", .x = {}, .y = {}, .colour = "#000000"};
  constexpr int kSteps = 400;  // the limit bends little: no corner is seen
  for (int i = 0; i <= kSteps; ++i) {
    const double R = std::lerp(smallest, largest, i / double(kSteps));
    limit.x.push_back(R);
    limit.y.push_back(problems::least_inertia_force(study.cutter, R * 1e-3));
  }
  panel.lines.push_back(std::move(limit));
  Markers published{.name = "the paper's six laws",
                    .points = {},
                    .colour = "#0072b2",
                    .shape = MarkerShape::Square,
                    .size = 5};
  Markers smooth{.name = "non-dominated among laws of continuous acceleration",
                 .points = {},
                 .colour = "#d55e00",
                 .shape = MarkerShape::Circle,
                 .size = 4.5};
  Markers on_front{.name = "non-dominated among all",
                   .points = {},
                   .colour = "#000000",
                   .shape = MarkerShape::Diamond};
  Markers others{.name = "other laws",
                 .points = {},
                 .colour = "#7f7f7f",
                 .shape = MarkerShape::Circle,
                 .filled = false,
                 .size = 3.5};
  for (const StudyRow& row : study.rows) {
    if (!std::isfinite(row.inertia_force) || hidden_by_published(study, row)) continue;
    Markers& series = row.published              ? published
                      : row.smooth_non_dominated ? smooth
                      : row.non_dominated        ? on_front
                                                 : others;
    const bool named = row.published || row.smooth_non_dominated;
    series.points.push_back({row.cam_radius * 1e3, row.inertia_force, named ? row.label : "",
                             fmt::format("{}: R {:.2f} mm, F {:.3f} N", row.label,
                                         row.cam_radius * 1e3, row.inertia_force)});
  }
  panel.markers = {std::move(published), std::move(smooth), std::move(on_front), std::move(others)};
  Figure figure;
  figure.title = "Spine cutter: cam size against inertia force";
  figure.subtitle = fmt::format(
      "stroke {:g} mm, block speed {:g} m/s, depth {:g} mm, pressure angle {:g} deg; "
      "points beyond the frame are in the table",
      study.cutter.stroke * 1e3, study.cutter.block_speed, study.cutter.depth * 1e3,
      study.cutter.pressure_angle * 180 / std::numbers::pi);
  figure.panels.push_back(std::move(panel));
  figure.panel_width = 900;
  figure.panel_height = 560;
  return figure;
}

Figure study_motion_figure(const SpineCutterStudy& study) {
  std::vector<DrawnLaw> laws;
  const auto add = [&](const std::string& name, bool dashed) {
    const bool there = std::any_of(laws.begin(), laws.end(),
                                   [&](const DrawnLaw& law) { return law.name == name; });
    if (!there) laws.push_back({name, find_law(name).law(), dashed});
  };
  // The law for the smallest cam alone is left out: its jerk would flatten all the others.
  add(study.rows[study.compromise].law, false);
  add(study.rows[study.least_force].law, false);
  for (const std::string& published : problems::published_laws()) add(published, true);
  return motion_figure("The compromise, the law of least force, and the paper's six (dashed)",
                       laws);
}

}  // namespace camlaw::cli
