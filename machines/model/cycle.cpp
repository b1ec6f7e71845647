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

LawPlace law_place(const Stretch& stretch, optim::Place place) {
  return {(place.angle - stretch.begin) / stretch.length(),
          place.from_left ? Side::Left : Side::Right};
}

}  // namespace camlaw::problems
