// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "kinematics/law.h"
#include "output/figure/chart.h"

namespace camlaw::cli {

/// s, v, a, j of some laws, one above the other over x. A law without a name stays out of the
/// legend.
struct NamedLaw {
  std::string name;
  Law<double> law;
  bool dashed = false;
};
inline constexpr int kMotionPoints = 400;  ///< that each curve is drawn with, or some more
Figure motion_figure(const std::string& title, const std::vector<NamedLaw>& laws,
                     int points = kMotionPoints);

/// A law at one place.
struct MotionSample {
  double x;
  Motion<double> motion;
};

/// `count` even points from 0 to 1, from the right at breaks. Throws std::invalid_argument for
/// fewer than 2.
std::vector<MotionSample> motion_samples(const Law<double>& law, int count);

/// The same as CSV: x, s, v, a, j.
std::string motion_csv(const Law<double>& law, int count);

}  // namespace camlaw::cli
