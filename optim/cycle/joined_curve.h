// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "optim/problem/problem.h"

/// Several responses one behind the other as one curve, so that the highest of all is the peak of a
/// curve: a worst case over a list.
namespace camlaw::optim {

/// Where a place of a joined curve is: in which part, and where there.
struct PartPlace {
  std::size_t part;
  double angle;
};

/// A place of a curve of `count` parts that are `length` apart.
PartPlace part_place(double angle, std::size_t count, double length);

/// Part k stands at angles larger by k * length; the angles of a part lie between 0 and length.
/// Between the end of a part and the beginning of the next the curve stays as it was at the end,
/// and there is such a stretch, so that no angle belongs to two parts. A number stands in for a
/// curve that is constant from 0 to length / 2. `variables`: of the design, at least. The shape is
/// what the shapes of all parts have in common.
std::shared_ptr<const Curve> joined_curve(std::vector<Response> parts, double length,
                                          std::size_t variables);

/// The strongest shape that a function of either shape has.
Shape common_shape(Shape a, Shape b);

}  // namespace camlaw::optim
