// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/figure/chart.h"
#include "output/figure/chart_labels.h"
#include "output/figure/chart_scale.h"

/// Where everything of a figure goes, in px, before anything is drawn.
namespace camlaw::cli {

/// Font sizes, line heights and distances shared by planning and drawing, px.
namespace chart_size {
inline constexpr double kTitleFont = 16, kTitleLine = 21;
inline constexpr double kPanelFont = 13, kPanelLine = 18;
inline constexpr double kTextFont = 12, kTextLine = 16;  // Subtitle, axis titles, legend.
inline constexpr double kSmallFont = 11;                 // Numbers at ticks, labels of points.
inline constexpr double kMargin = 12;                    // Around the figure and between its parts.
inline constexpr double kTick = 4;                       // Length of a tick mark.
inline constexpr double kLegendSample = 28, kLegendGap = 6, kLegendRow = 20;
}  // namespace chart_size

/// A named series in the legend: its sample's left end, at half the row's height.
struct LegendEntry {
  std::string name;
  std::string colour = {};
  const Line* line = nullptr;
  const Markers* markers = nullptr;
  DrawnPoint position = {};
};

struct PlannedAxis {
  Range range;
  std::vector<double> ticks;
  std::vector<std::string> labels;
  std::vector<std::string> title;  ///< In lines.
};

struct PlannedPanel {
  const Panel* panel = nullptr;
  PlannedAxis x;
  PlannedAxis y;
  std::vector<std::string> title;  ///< In lines.
  Rect frame = {};
  bool has_data = false;
  bool shows_x = true;  ///< Whether numbers and title stand under the frame.
};

/// Refers to the figure it was made from, which must outlive it.
struct ChartPlan {
  double width = 0;
  double height = 0;
  double left = 0;          ///< Where title, subtitle and legend begin.
  double number_width = 0;  ///< Of the widest number at a y axis.
  std::vector<std::string> title;
  std::vector<std::string> subtitle;
  std::vector<LegendEntry> legend;
  std::vector<PlannedPanel> panels;
};

/// Lays the figure out; throws as to_svg.
ChartPlan make_plan(const Figure& figure);

}  // namespace camlaw::cli
