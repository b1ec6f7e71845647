// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "machines/model/highest_in_box.h"

namespace camlaw::problems {

/// The highest of some places of a box and of 33 even places along each range from there, one range
/// after the other. A top that is narrow along a range, such as a resonance, falls between the
/// places of places_of. Where a value is not a number, the first such place.
Point highest_along_ranges(const Box& box, const std::vector<Point>& places,
                           const std::function<double(const Point&)>& value);

}  // namespace camlaw::problems
