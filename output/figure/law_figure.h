// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "kinematics/law.h"
#include "output/figure/chart.h"

namespace camlaw::cli {

/// s, v, a, j of some laws, one above the other over x. A law without a name stays out of the
/// legend.
struct DrawnLaw {
  std::string name;
  Law<double> law;
  bool dashed = false;
};
inline constexpr int kMotionPoints = 400;  ///< that each curve is drawn with, or some more
Figure motion_figure(const std::string& title, const std::vector<DrawnLaw>& laws,
                     int points = kMotionPoints);

/// A law at one place.
struct MotionSample {
  double x;
  Motion<double> motion;
};

/// A law at `count` even points from 0 to 1, at least 2; from the right at breaks. A block of them
/// is worked out at a time, by evaluate(): a table has the bits that arrays of points have.
class EvenSamples {
 public:
  EvenSamples(Law<double> law, int count);
  MotionSample at(int i);

 private:
  /// Five rows of so many numbers, 20 KB, stay in a processor's nearest cache.
  static constexpr int kBlock = 512;
  Law<double> law_;
  int count_;
  int block_ = -1;
  std::array<std::array<double, kBlock>, 5> numbers_;  ///< x, s, v, a, j
};

/// All of them as CSV: x, s, v, a, j.
std::string motion_csv(const Law<double>& law, int count);
/// The same in pieces, one after the other, so that no more than one is kept; `take` says whether
/// it wants more. Throws std::invalid_argument for fewer than 2 points.
void motion_csv(const Law<double>& law, int count,
                const std::function<bool(std::string_view)>& take);

}  // namespace camlaw::cli
