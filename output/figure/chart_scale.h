// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

/// The numbers of a chart's axes: ranges, ticks and their labels, and curves cut to the range.
namespace camlaw::cli {

struct Range {
  double lower = 0;
  double upper = 1;
};

/// A point in px or, where said so, in units of the axes' ranges (0 to 1).
struct DrawnPoint {
  double x = 0;
  double y = 0;
};

/// Whether a chart can show the value: finite, and at most 1e300 so that differences are finite.
bool is_drawable(double value);

/// The drawable values' least and greatest, none if there are none.
std::optional<Range> extent(std::span<const double> values);

/// The range of an axis: the bounds where given, otherwise the data's extent with 4 % padding. A
/// constant (extent below 1e-7 of its size) gets 10 % of its size on either side, zero gets +-1, no
/// data 0 to 1. Throws std::invalid_argument, with the axis named, if a bound is not drawable or
/// lower is not below upper.
Range axis_range(const std::string& name, std::optional<Range> data, std::optional<double> lower,
                 std::optional<double> upper);

/// 4 to 8 multiples of 1, 2 or 5 times a power of ten within [lower, upper]; 2.5 where 5 gives less
/// than 4 ticks. Zero is never -0. A range narrower than 1e-12 of its size gets its two ends only.
/// Throws std::invalid_argument if a bound is not drawable or lower is not below upper.
std::vector<double> nice_ticks(double lower, double upper);

/// The same for an axis in degrees: over half a turn or more multiples of 30, 45, 60, 90 or 180,
/// where those give 4 to 8 ticks.
std::vector<double> degree_ticks(double lower, double upper);

/// The ticks as text with equally many decimals; beyond 1e6 and below 1e-3 with the exponent of the
/// largest one, as in 0.5e6, 1.0e6, 1.5e6.
std::vector<std::string> tick_labels(std::span<const double> ticks);

/// Position of the value within the range, 0 at lower and 1 at upper, limited to +-1e9.
double unit_position(double value, Range range);

/// The parts of the curve through (x[i], y[i]) that lie within the ranges, in units of the ranges,
/// each of at least two points (a lone sample is doubled). Samples that are not drawable break it.
std::vector<std::vector<DrawnPoint>> clipped_curve(std::span<const double> x,
                                                   std::span<const double> y, Range x_range,
                                                   Range y_range);

}  // namespace camlaw::cli
