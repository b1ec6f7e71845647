// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "machines/model/highest_in_box.h"

namespace camlaw::problems {

/// What a function is at places of a box, as far as the first value that is not a number.
struct Heights {
  std::vector<Point> places;
  std::vector<double> values;

  void add(Point place, double value);
  /// Whether the last value is not a number.
  bool is_undefined() const;
  /// The value at one of the places.
  double at(const Point& place) const;
};

/// Values of many functions at a point of a box, to be made highest: those of the functions with
/// these numbers, in their order.
using ManyHeights =
    std::function<std::vector<double>(const Point&, const std::vector<std::size_t>& functions)>;

/// Of each of `count` functions the places and their values, as far as the first value that is not
/// a number; behind them the highest of 33 even places along each range, one range after the other,
/// from the highest of the places. A top that is narrow along a range, such as a resonance, falls
/// between the places of places_of. Where optim::ProofTime is over, nothing is looked for along the
/// ranges. Functions that go the same way are asked for together.
std::vector<Heights> heights_along_ranges(const Box& box, const std::vector<Point>& places,
                                          std::size_t count, const ManyHeights& values);

}  // namespace camlaw::problems
