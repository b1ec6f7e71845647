// SPDX-License-Identifier: MIT
#pragma once

/// What manufacture makes of a number that was meant.
namespace camlaw::optim {

/// By how much a value may be off, in its unit.
struct Variation {
  /// Between these ends; where the values are normal, three standard deviations about their mean.
  double lower = 0, upper = 0;
  bool is_normal = false;  ///< else even between the ends

  double middle() const { return lower + (upper - lower) / 2; }
  double half() const { return (upper - lower) / 2; }
  bool varies() const { return lower < upper; }
  /// The standard deviation: half / 3, of even values half / sqrt(3).
  double deviation() const;
  /// How much a value is off that stands where u does among normal numbers of deviation 1
  /// (docs/theory.md, TV1), and the slope of that by u.
  double at(double u) const;
  double slope(double u) const;
  /// The same of a share of all values that lie below.
  double at_share(double share) const;
};

}  // namespace camlaw::optim
