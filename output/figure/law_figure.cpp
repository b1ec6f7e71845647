// SPDX-License-Identifier: MIT
#include "output/figure/law_figure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kinematics/peaks.h"
#include "output/document/formatting.h"

namespace camlaw::cli {
namespace {

/// One curve, piece by piece, so that jumps are drawn as gaps.
Line motion_line(const DrawnLaw& named, std::size_t order, int points) {
  const int least = std::clamp(points / static_cast<int>(named.law.pieces().size()), 1, 8);
  Line line;
  line.name = named.name;
  line.dashed = named.dashed;
  for (const auto& piece : named.law.pieces()) {
    const int steps = std::max(least, static_cast<int>(points * (piece.end - piece.begin)));
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

/// Limits the scale of a curve that runs off to infinity, so that the rest of it can be seen: drawn
/// up to twice the value that nine points in ten stay below.
void limit_scale(Panel& panel) {
  std::vector<double> sizes;
  for (const Line& line : panel.lines) {
    for (const double y : line.y) {
      if (std::isfinite(y)) sizes.push_back(std::abs(y));
    }
  }
  if (sizes.empty()) return;
  const auto tenth = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() * 9 / 10);
  std::nth_element(sizes.begin(), tenth, sizes.end());
  const double bound = 2 * *tenth;
  if (!(bound > 0)) return;  // level but for a few places: the chart's own scale will do
  panel.y.lower = -bound;
  panel.y.upper = bound;
}

/// What a panel must say of peaks that a curve cannot show.
void mark_unbounded(Panel& panel, std::size_t order, const std::vector<DrawnLaw>& laws) {
  if (order < 2) return;
  const auto q = order == 2 ? Quantity::Acceleration : Quantity::Jerk;
  bool jumps = false, singular = false;
  for (const DrawnLaw& named : laws) {
    const auto peak = peaks(named.law);
    const double inside = q == Quantity::Jerk ? std::max(peak.jerk_inside_highest.value,
                                                         -peak.jerk_inside_lowest.value)
                                              : peak.max_acceleration();
    singular = singular || std::isinf(inside);
    jumps = jumps || (std::isinf(peak.absolute(q).value) && !std::isinf(inside));
  }
  if (singular) limit_scale(panel);
  if (singular) panel.title = "a curve that leaves the frame has no bound there";
  if (jumps && !singular) panel.title = "not drawn: the pulses of jerk where an acceleration jumps";
}

}  // namespace

Figure motion_figure(const std::string& title, const std::vector<DrawnLaw>& laws, int points) {
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
    for (const DrawnLaw& law : laws) panel.lines.push_back(motion_line(law, order, points));
    mark_unbounded(panel, order, laws);
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

EvenSamples::EvenSamples(Law<double> law, int count) : law_(std::move(law)), count_(count) {
  if (count < 2) throw std::invalid_argument("samples: at least 2 are needed");
}

MotionSample EvenSamples::at(int i) {
  if (i / kBlock != block_) {
    block_ = i / kBlock;
    const int first = block_ * kBlock;
    const auto size = static_cast<std::size_t>(std::min(kBlock, count_ - first));
    for (std::size_t k = 0; k < size; ++k) {
      numbers_[0][k] = (first + static_cast<int>(k)) / (count_ - 1.0);
    }
    const auto part = [&](std::size_t number) {
      return std::span<double>(numbers_[number]).first(size);
    };
    evaluate(law_, part(0), {part(1), part(2), part(3), part(4)});
  }
  const auto k = static_cast<std::size_t>(i % kBlock);
  return {numbers_[0][k], {numbers_[1][k], numbers_[2][k], numbers_[3][k], numbers_[4][k]}};
}

void motion_csv(const Law<double>& law, int count,
                const std::function<bool(std::string_view)>& take) {
  EvenSamples samples(law, count);
  constexpr std::size_t kPiece = 1000;  // rows
  std::vector<std::vector<std::string>> rows{{"x", "s", "v", "a", "j"}};
  for (int i = 0; i < count; ++i) {
    const auto [x, m] = samples.at(i);
    rows.push_back({exact(x), exact(m.s), exact(m.v), exact(m.a), exact(m.j)});
    if (rows.size() < kPiece && i + 1 < count) continue;
    if (!take(to_csv(rows))) return;
    rows.clear();
  }
}

std::string motion_csv(const Law<double>& law, int count) {
  std::string all;
  motion_csv(law, count, [&](std::string_view piece) {
    all += piece;
    return true;
  });
  return all;
}

}  // namespace camlaw::cli
