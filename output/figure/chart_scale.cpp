// SPDX-License-Identifier: MIT
#include "output/figure/chart_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace camlaw::cli {
namespace {

/// Sizes a chart tells from zero and from infinity; far enough from the limits of double for spans,
/// steps and their inverses to be finite.
constexpr double kSmallest = 1e-280;
constexpr double kLargest = 1e300;

/// The data's extent with padding; see axis_range.
Range padded(Range data) {
  const double size = std::max(std::abs(data.lower), std::abs(data.upper));
  if (size < kSmallest) return {-1, 1};
  const double span = data.upper - data.lower;
  const double pad = span > 1e-7 * size ? 0.04 * span : 0.1 * size;
  return {std::max(data.lower - pad, -kLargest), std::min(data.upper + pad, kLargest)};
}

void check_bounds(const std::string& name, Range range) {
  if (!is_drawable(range.lower) || !is_drawable(range.upper))
    throw std::invalid_argument(fmt::format("axis '{}': bounds {} and {} must be at most 1e300",
                                            name, range.lower, range.upper));
  if (range.lower >= range.upper)
    throw std::invalid_argument(
        fmt::format("axis '{}': lower {} is not below upper {}", name, range.lower, range.upper));
}

/// Multiples of the step in [lower, upper]; 1e-9 of a step lets 0.3 / 0.1 count as 3.
std::pair<double, double> multiples(double lower, double upper, double step) {
  return {std::ceil(lower / step - 1e-9), std::floor(upper / step + 1e-9)};
}

double count(double lower, double upper, double step) {
  const auto [first, last] = multiples(lower, upper, step);
  return last - first + 1;
}

/// 10^exponent with the rounding of a literal, which std::pow does not promise below 1.
double power_of_ten(int exponent) {
  return exponent < 0 ? 1 / std::pow(10.0, -exponent) : std::pow(10.0, exponent);
}

/// The least step of 1, 2, 5 times a power of ten with at most 8 ticks; 2.5 for 5 if that has less
/// than 4. (5 has 3 ticks only if 2 has 9, a span of 3.2 steps; then 2.5 has 5 to 7.)
double nice_step(double lower, double upper) {
  // A tenth of the span gives at least 10 ticks or 9, so the search starts at or below it.
  int exponent = static_cast<int>(std::floor(std::log10((upper - lower) / 10)));
  for (;; ++exponent) {
    const double decade = power_of_ten(exponent);
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double step = factor * decade;
      if (count(lower, upper, step) > 8) continue;
      return count(lower, upper, step) < 4 ? 0.5 * step : step;
    }
  }
}

/// All multiples of the step in [lower, upper].
std::vector<double> ticks_by(double step, double lower, double upper) {
  const auto [first, last] = multiples(lower, upper, step);
  // A step below 1 is divided by its inverse: 3 / 10 is 0.3 exactly rounded, 3 * 0.1 is not.
  const double inverse = std::round(1 / step);
  const bool divides = step < 1 && std::abs(inverse * step - 1) < 1e-12;
  std::vector<double> ticks;
  for (int k = 0; k <= static_cast<int>(last - first); ++k) {
    const double i = first + k;
    ticks.push_back(i == 0 ? 0.0 : (divides ? i / inverse : i * step));
  }
  return ticks;
}

/// Decimals after which a step (1, 2, 2.5, 5 times a power of ten, roughly) has no more digits.
int decimals_of(double step) {
  int decimals = 0;
  for (double scaled = step; decimals < 17; scaled *= 10, ++decimals)
    if (std::abs(scaled - std::round(scaled)) < 1e-3 * scaled) break;
  return decimals;
}

bool is_inside(DrawnPoint p) { return p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1; }

/// The part of the segment ab within the unit square (Liang and Barsky 1984).
std::optional<std::pair<DrawnPoint, DrawnPoint>> clip(DrawnPoint a, DrawnPoint b) {
  double enter = 0, leave = 1;
  const double dx = b.x - a.x, dy = b.y - a.y;
  // Each side of the square: outward speed along the segment, and distance from a to the side.
  const std::pair<double, double> sides[] = {{-dx, a.x}, {dx, 1 - a.x}, {-dy, a.y}, {dy, 1 - a.y}};
  for (const auto& [speed, distance] : sides) {
    if (speed == 0 && distance < 0) return {};
    if (speed < 0) enter = std::max(enter, distance / speed);
    if (speed > 0) leave = std::min(leave, distance / speed);
  }
  if (enter > leave) return {};
  const auto at = [&](double t) {
    return DrawnPoint{std::clamp(a.x + t * dx, 0.0, 1.0), std::clamp(a.y + t * dy, 0.0, 1.0)};
  };
  return std::pair{at(enter), at(leave)};
}

/// Collects the points of a curve's visible parts.
class Pieces {
 public:
  void add(DrawnPoint p) { current_.push_back(p); }
  bool is_open() const { return !current_.empty(); }
  void close() {
    if (current_.size() == 1) current_.push_back(current_.front());
    if (is_open()) pieces_.push_back(std::move(current_));
    current_.clear();
  }
  std::vector<std::vector<DrawnPoint>> take() {
    close();
    return std::move(pieces_);
  }

 private:
  std::vector<std::vector<DrawnPoint>> pieces_;
  std::vector<DrawnPoint> current_;
};

}  // namespace

bool is_drawable(double value) { return std::abs(value) <= kLargest; }

std::optional<Range> extent(std::span<const double> values) {
  std::optional<Range> range;
  for (const double value : values) {
    if (!is_drawable(value)) continue;
    if (!range) range = Range{value, value};
    range = Range{std::min(range->lower, value), std::max(range->upper, value)};
  }
  return range;
}

Range axis_range(const std::string& name, std::optional<Range> data, std::optional<double> lower,
                 std::optional<double> upper) {
  Range range = data ? padded(*data) : Range{};
  const double width = range.upper - range.lower;
  // One given bound beyond all data keeps the data's width.
  if (lower) range = {*lower, upper || range.upper > *lower ? range.upper : *lower + width};
  if (upper) range = {lower || range.lower < *upper ? range.lower : *upper - width, *upper};
  check_bounds(name, range);
  return range;
}

std::vector<double> nice_ticks(double lower, double upper) {
  check_bounds("ticks", {lower, upper});
  const double size = std::max(std::abs(lower), std::abs(upper));
  if (upper - lower < std::max(1e-12 * size, kSmallest)) return {lower, upper};
  return ticks_by(nice_step(lower, upper), lower, upper);
}

std::vector<double> degree_ticks(double lower, double upper) {
  check_bounds("ticks", {lower, upper});
  for (const double step : {30.0, 45.0, 60.0, 90.0, 180.0}) {
    const double ticks = count(lower, upper, step);
    if (upper - lower >= 180 && ticks >= 4 && ticks <= 8) return ticks_by(step, lower, upper);
  }
  return nice_ticks(lower, upper);
}

std::vector<std::string> tick_labels(std::span<const double> ticks) {
  if (ticks.empty()) return {};
  const double size = std::max(std::abs(ticks.front()), std::abs(ticks.back()));
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : size;
  const bool plain = size == 0 || (size >= 1e-3 && size < 1e6);
  const int exponent = plain ? 0 : static_cast<int>(std::floor(std::log10(size)));
  const double decade = power_of_ten(exponent);
  const int decimals = decimals_of(step / decade);
  const std::string suffix = plain ? "" : fmt::format("e{}", exponent);
  std::vector<std::string> labels;
  for (const double tick : ticks)
    labels.push_back(
        tick == 0 && !plain ? "0" : fmt::format("{:.{}f}{}", tick / decade, decimals, suffix));
  return labels;
}

double unit_position(double value, Range range) {
  return std::clamp((value - range.lower) / (range.upper - range.lower), -1e9, 1e9);
}

std::vector<std::vector<DrawnPoint>> clipped_curve(std::span<const double> x,
                                                   std::span<const double> y, Range x_range,
                                                   Range y_range) {
  Pieces pieces;
  DrawnPoint previous{};
  bool has_previous = false;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (!is_drawable(x[i]) || !is_drawable(y[i])) {
      pieces.close();
      has_previous = false;
      continue;
    }
    const DrawnPoint point{unit_position(x[i], x_range), unit_position(y[i], y_range)};
    if (!has_previous && is_inside(point)) pieces.add(point);
    if (const auto part = has_previous ? clip(previous, point) : std::nullopt) {
      if (!pieces.is_open()) pieces.add(part->first);
      pieces.add(part->second);
    }
    if (!is_inside(point)) pieces.close();
    previous = point;
    has_previous = true;
  }
  return pieces.take();
}

}  // namespace camlaw::cli
