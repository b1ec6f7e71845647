// SPDX-License-Identifier: MIT
#include "output/figure/profile_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "output/export/plane_curve.h"

namespace camlaw::cli {
namespace {

/// The points of a curve over the whole turn.
Line line_of(const problems::PlaneCurve& curve) {
  constexpr int kSteps = 720;  // half a degree: no corner is seen at any size of a page
  Line line{.name = curve.name()};
  line.dashed = !curve.name().ends_with("profile");
  for (int i = 0; i <= kSteps; ++i) {
    const auto point = curve.look(optim::even_place(curve.begin(), curve.end(), kSteps, i)).at;
    line.x.push_back(point.x());
    line.y.push_back(point.y());
  }
  return line;
}

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void take(const std::vector<double>& values) {
    for (const double value : values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  void widen(double by) { low -= by, high += by; }
};

}  // namespace

Figure profile_figure(const problems::ProblemStatement& statement) {
  Panel panel;
  for (const auto& curve : problems::cam_curves(statement, "all")) {
    panel.lines.push_back(line_of(curve));
  }
  if (panel.lines.empty()) {
    throw std::invalid_argument(
        fmt::format("{} has no profile to draw", statement.mechanism->name));
  }
  Extent x, y;
  for (const Line& line : panel.lines) x.take(line.x), y.take(line.y);
  const double margin = 0.04 * std::max(x.high - x.low, y.high - y.low);
  x.widen(margin), y.widen(margin);
  panel.x = {.label = "x", .unit = "mm", .lower = x.low, .upper = x.high};
  panel.y = {.label = "y", .unit = "mm", .lower = y.low, .upper = y.high};
  Figure figure;
  figure.title = statement.title;
  figure.subtitle = statement.mechanism->name;
  figure.panel_height = figure.panel_width * (y.high - y.low) / (x.high - x.low);
  figure.panels.push_back(std::move(panel));
  return figure;
}

}  // namespace camlaw::cli
