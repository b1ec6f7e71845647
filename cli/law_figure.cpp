// SPDX-License-Identifier: MIT
#include "cli/law_figure.h"

#include <array>
#include <cmath>

#include "cli/text_table.h"

namespace camlaw::cli {
namespace {

constexpr int kCurvePoints = 400;

/// One curve, piece by piece, so that jumps are drawn as gaps.
Line motion_line(const NamedLaw& named, std::size_t order) {
  Line line;
  line.name = named.name;
  for (const auto& piece : named.law.pieces()) {
    const int steps = std::max(8, static_cast<int>(kCurvePoints * (piece.end - piece.begin)));
    for (int i = 0; i <= steps; ++i) {
      const double x =
          i == steps ? piece.end : std::lerp(piece.begin, piece.end, i / double(steps));
      line.x.push_back(x);
      line.y.push_back(derivatives<4>(piece, x)[order]);
    }
    const double next = derivatives<4>(piece, piece.end)[order];
    const auto& last = named.law.pieces().back();
    if (&piece == &last) continue;
    const double after = named.law.derivatives<4>(piece.end, Side::Right)[order];
    if (std::abs(after - next) > 1e-9 * std::max(1.0, std::abs(next))) {
      line.x.push_back(piece.end);
      line.y.push_back(std::nan(""));
    }
  }
  return line;
}

}  // namespace

Figure motion_figure(const std::string& title, const std::vector<NamedLaw>& laws) {
  struct Row {
    const char *title, *unit;
  };
  constexpr std::array kRows{Row{"s", "S"}, Row{"v = s'", "S/T"}, Row{"a = s''", "S/T²"},
                             Row{"j = s'''", "S/T³"}};
  Figure figure;
  figure.title = title;
  figure.panel_height = 170;
  for (std::size_t order = 0; order < kRows.size(); ++order) {
    Panel panel;
    panel.x = {.label = "x = t / T", .unit = "", .lower = 0.0, .upper = 1.0};
    panel.y = {.label = kRows[order].title, .unit = kRows[order].unit};
    for (const NamedLaw& law : laws) panel.lines.push_back(motion_line(law, order));
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

std::vector<MotionSample> motion_samples(const Law<double>& law, int count) {
  if (count < 2) throw std::invalid_argument("samples: at least 2 are needed");
  std::vector<MotionSample> result;
  for (int i = 0; i < count; ++i) {
    const double x = i / (count - 1.0);
    result.push_back({x, law(x, i + 1 == count ? Side::Left : Side::Right)});
  }
  return result;
}

std::string motion_csv(const Law<double>& law, int count) {
  std::vector<std::vector<std::string>> rows{{"x", "s", "v", "a", "j"}};
  for (const auto& [x, m] : motion_samples(law, count)) {
    rows.push_back({exact(x), exact(m.s), exact(m.v), exact(m.a), exact(m.j)});
  }
  return to_csv(rows);
}

}  // namespace camlaw::cli
