// SPDX-License-Identifier: MIT
#include "output/figure/thinning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace camlaw::cli {
namespace {

using Stretch = std::pair<std::size_t, std::size_t>;  // first and last sample

/// How far a sample is from the straight line between two others, along y.
double off_line(const Line& line, const Stretch& ends, std::size_t i) {
  const auto [first, last] = ends;
  const double length = line.x[last] - line.x[first];
  if (!(length > 0)) return std::numeric_limits<double>::infinity();
  const double part = (line.x[i] - line.x[first]) / length;
  return std::abs(line.y[i] - std::lerp(line.y[first], line.y[last], part));
}

/// Marks the samples between two that are kept without which the line would be off by more.
void keep_between(const Line& line, Stretch whole, double most, std::vector<bool>& kept) {
  std::vector<Stretch> open{whole};
  while (!open.empty()) {
    const Stretch ends = open.back();
    open.pop_back();
    std::size_t worst = ends.first;
    double distance = most;
    for (std::size_t i = ends.first + 1; i < ends.second; ++i) {
      const double off = off_line(line, ends, i);
      if (off > distance) worst = i, distance = off;
    }
    if (worst == ends.first) continue;
    kept[worst] = true;
    open.push_back({ends.first, worst});
    open.push_back({worst, ends.second});
  }
}

/// The stretches with values, each between samples that stay.
std::vector<Stretch> stretches_of(const Line& line, const std::vector<bool>& kept) {
  std::vector<Stretch> all;
  for (std::size_t i = 0, before = line.y.size(); i < line.y.size(); ++i) {
    if (!std::isfinite(line.y[i])) {
      before = line.y.size();
    } else if (kept[i]) {
      if (before < i) all.push_back({before, i});
      before = i;
    }
  }
  return all;
}

}  // namespace

Line thinned(const Line& line, double share) {
  const std::size_t count = line.y.size();
  std::vector<bool> kept(count, false);
  std::size_t low = count, high = count;
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_value = std::isfinite(line.y[i]);
    const bool begins = i == 0 || std::isfinite(line.y[i - 1]) != is_value;
    const bool ends = i + 1 == count || std::isfinite(line.y[i + 1]) != is_value;
    kept[i] = begins || (is_value && ends);
    if (!is_value) continue;
    if (low == count || line.y[i] < line.y[low]) low = i;
    if (high == count || line.y[i] > line.y[high]) high = i;
  }
  if (low == count) return line;
  kept[low] = kept[high] = true;
  const double most = share * (line.y[high] - line.y[low]);
  for (const Stretch& stretch : stretches_of(line, kept)) keep_between(line, stretch, most, kept);
  Line result = line;
  result.x.clear(), result.y.clear();
  for (std::size_t i = 0; i < count; ++i) {
    if (!kept[i]) continue;
    result.x.push_back(line.x[i]);
    result.y.push_back(line.y[i]);
  }
  return result;
}

Figure thinned(Figure figure) {
  constexpr double kShare = 1.0 / (8 * 600);  // an eighth of a pixel of a figure that is 600 high
  for (Panel& panel : figure.panels) {
    for (Line& line : panel.lines) line = thinned(line, kShare);
  }
  return figure;
}

}  // namespace camlaw::cli
