// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "optim/problem/function.h"

/// The highest value of a function of a few parameters, each within bounds.
namespace camlaw::problems {

using Box = std::vector<optim::Bounds>;
using Point = std::vector<double>;

/// Places of a box at which a highest value is looked for: its corners first, then some within.
std::vector<Point> places_of(const Box& box);

/// Those of a box's places from which a climb may lead to the highest value: the highest first, and
/// of up to three parameters some others that are higher than all beside them. Where a value is not
/// a number, the first such place alone.
std::vector<Point> tops_of(const Box& box, const std::vector<Point>& places,
                           const std::function<double(const Point&)>& value);

/// Whether no step within the box leads uphill from a place with these slopes.
bool is_top(const Point& p, const Box& box, const Point& slopes);

/// Of one parameter: the top between a place, the highest of these with a slope that is not 0, and
/// its neighbour uphill. None where the slope does not fall to 0 there, or the value is lower.
struct Rise {
  double value, slope;
};
std::optional<double> top_along(double from, const Rise& here, const optim::Bounds& bounds,
                                const std::function<Rise(double)>& along);

/// From one of these places, the highest of them, uphill to the highest value nearby. `slopes` are
/// the function's first and second derivatives, packed, at a point.
struct Slopes {
  double value;
  std::vector<double> first, second;
};
Point climbed(Point from, const Box& box, const std::function<Slopes(const Point&)>& slopes);

/// What is proved of a function over a box.
struct OverBox {
  optim::Bounds value;
  std::vector<optim::Bounds> slopes;
};

/// How far a box is divided: at most so often, and into at most so many parts.
struct Division {
  int halvings;
  int parts;
};

/// What halving a box tells of the highest value over it.
struct Highest {
  optim::Bounds value;  ///< numbers between which it is proved to lie
  Point place;          ///< where it is the lower of them, at least; empty where nothing bounds it
  /// Of the parts that were not divided further the one that the upper of them comes from, or the
  /// place that nothing bounds; empty where it is reached at a place that is bounded.
  Box left;
};

/// The ends of a box one after the other, as a key.
std::vector<double> ends_of(const Box& box);

/// By halving the box: where a slope has one sign, that parameter stands at an end. `at` bounds the
/// value at a point; a part of the box that is bounded about as closely is not divided further.
Highest highest_within(const Box& box, const Division& division,
                       const std::function<optim::Bounds(const Point&)>& at,
                       const std::function<OverBox(const Box&)>& over);

}  // namespace camlaw::problems
