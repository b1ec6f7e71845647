// SPDX-License-Identifier: MIT
#include "cli/profile_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "problems/statement/bind.h"

namespace camlaw::cli {
namespace {

/// A drawn curve and the responses that are its coordinates.
struct Drawn {
  const char *name, *curve;
  bool dashed;
};
constexpr Drawn kDrawn[] = {{"profile", "profile", false},
                            {"second profile", "second_profile", false},
                            {"pitch curve", "pitch", true},
                            {"middle of the tool", "cutter", true}};

const optim::Response* find_curve(const std::vector<optim::Response>& curves,
                                  const std::string& name) {
  const auto found = std::find_if(curves.begin(), curves.end(),
                                  [&](const optim::Response& curve) { return curve.name == name; });
  return found == curves.end() ? nullptr : &*found;
}

/// The points of a curve given by two, over the whole turn.
Line line_of(const Drawn& drawn, const optim::Response& x, const optim::Response& y) {
  constexpr int kSteps = 720;
  Line line{.name = drawn.name};
  line.dashed = drawn.dashed;
  const auto across = x.curve().trace({}), along = y.curve().trace({});
  const std::vector<double> breaks = across->breaks();
  for (int i = 0; i <= kSteps; ++i) {
    const optim::Place place = optim::even_place(breaks.front(), breaks.back(), kSteps, i);
    line.x.push_back(across->at(place)[0]);
    line.y.push_back(along->at(place)[0]);
  }
  return line;
}

struct Range {
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
  const auto curves = problems::curves_of(statement);
  Panel panel;
  for (const Drawn& drawn : kDrawn) {
    const auto* x = find_curve(curves, fmt::format("{}_x", drawn.curve));
    const auto* y = find_curve(curves, fmt::format("{}_y", drawn.curve));
    if (x != nullptr && y != nullptr) panel.lines.push_back(line_of(drawn, *x, *y));
  }
  if (panel.lines.empty()) {
    throw std::invalid_argument(
        fmt::format("{} has no profile to draw", statement.mechanism->name));
  }
  Range x, y;
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
