// SPDX-License-Identifier: MIT
#include "machines/model/cycle.h"

namespace camlaw::problems {

const Stretch& Cycle::stretch_at(optim::Place place) const {
  for (const Stretch& stretch : stretches) {
    if (place.angle < stretch.end || (place.from_left && place.angle == stretch.end)) {
      return stretch;
    }
  }
  return stretches.back();
}

Cycle::Part Cycle::part_of(const Stretch& stretch) const {
  const double begin = stretches.front().begin;
  return {stretch.begin - begin, stretch.length(), stretches.back().end - begin};
}

LawPlace law_place(const Stretch& stretch, optim::Place place) {
  return {(place.angle - stretch.begin) / stretch.length(),
          place.from_left ? Side::Left : Side::Right};
}

}  // namespace camlaw::problems
