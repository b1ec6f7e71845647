// SPDX-License-Identifier: MIT
#include "machines/model/highest_along_ranges.h"

#include <cmath>

namespace camlaw::problems {

Point highest_along_ranges(const Box& box, const std::vector<Point>& places,
                           const std::function<double(const Point&)>& value) {
  constexpr int kSteps = 32;  // a top that the grid misses may be as narrow along one range
  Point best = places.front();
  double highest = value(best);
  const auto look = [&](const Point& p) {
    const double here = value(p);
    if (std::isnan(highest) || !(here > highest || std::isnan(here))) return;
    highest = here;
    best = p;
  };
  for (const Point& p : places) look(p);
  for (std::size_t range = 0; range < box.size(); ++range) {
    const double lower = box[range].lower, upper = box[range].upper;
    Point p = best;
    for (int i = 0; i <= kSteps && lower < upper && !std::isnan(highest); ++i) {
      p[range] = std::lerp(lower, upper, static_cast<double>(i) / kSteps);
      look(p);
    }
  }
  return best;
}

}  // namespace camlaw::problems
