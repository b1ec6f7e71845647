// SPDX-License-Identifier: MIT
#include "output/export/solid/exact_flank.h"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>

namespace camlaw::problems {

std::array<double, 3> ExactFlank::centre(double angle) const {
  double turn = std::fmod(angle, kWholeTurn);
  if (turn < 0) turn += kWholeTurn;
  const double at = std::min(pitch_.begin() + kPerRad * turn, pitch_.end());
  const auto h = pitch_.height({at, at == pitch_.end()});
  return {h[0], kPerRad * h[1], kPerRad * kPerRad * h[2]};
}

double ExactFlank::roller_angle(double angle, double distance) const {
  const double most = std::asin(roller_radius_ / distance) + 1e-9;
  const auto miss = [&](double at) {
    return at + contact(centre(at)[1], distance).turned() - angle;
  };
  const double low = angle - most, high = angle + most;
  boost::uintmax_t count = 100;
  const auto found = boost::math::tools::toms748_solve(
      miss, low, high, boost::math::tools::eps_tolerance<double>(50), count);
  return (found.first + found.second) / 2;
}

FlankSurface::Corner ExactFlank::corner(double angle, double distance) const {
  const double at = roller_angle(angle, distance);
  const auto [height, rise, bend] = centre(at);
  const auto c = contact(rise, distance);
  // The slope m of the flank is that of the roller's way; at the same angle it changes with q as
  // the roller's angle does.
  const double by_distance = -c.turned_by_distance() / (1 + c.turned_by_angle(bend));
  return {height + c.raised(), c.slope(), c.outward_slope(), bend * by_distance};
}

}  // namespace camlaw::problems
