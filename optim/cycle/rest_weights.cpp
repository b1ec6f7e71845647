// SPDX-License-Identifier: MIT
#include "optim/cycle/rest_weights.h"

#include <cmath>

namespace camlaw::optim {
namespace {

/// The distance of a place from a rest into its stretch; below 0 on the other side.
double distance_to(const Rest& rest, Place place) {
  if (place.angle == rest.angle) return place.from_left == rest.is_end ? 0 : -1;
  return rest.is_end ? rest.angle - place.angle : place.angle - rest.angle;
}

}  // namespace

double RestWeights::at(Place place) const {
  double weight = 1;
  for (const Rest& rest : rests_) {
    const double d = distance_to(rest, place);
    if (d >= 0 && d < rest.length) weight *= std::pow(d / rest.length, rest.order);
  }
  return weight;
}

bool vanishes(double largest_slope) {
  // Where a limit vanishes, rounding leaves slopes of some 1e-17 of the row's size.
  constexpr double kRounding = 1e-11;
  return !(largest_slope > kRounding);
}

}  // namespace camlaw::optim
