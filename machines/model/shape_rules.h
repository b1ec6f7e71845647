// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "numerics/formula/formula.h"
#include "optim/problem/function.h"

/// The shape of a recorded formula by rules of composition: a sum of convex functions is convex,
/// the root of a concave one concave, a quotient of linear ones quasilinear; and where one input
/// alone varies by what encloses its slope and its second derivative (docs/theory.md, "Convexity
/// from rules"). What is not found so may still have a shape.
namespace camlaw::problems {

/// How an input varies: not at all, linearly in the design's variables, or in another way.
enum class Varies : char { Not, Linearly, Otherwise };

struct RuledInput {
  Varies varies;
  Interval range;  ///< what it lies between; signs come from it
};

struct RuledShape {
  optim::Shape shape = optim::Shape::General;
  bool by_enclosure = false;  ///< from the slope or the second derivative over the range
};

RuledShape shape_by_rules(const Formula& formula, std::span<const RuledInput> inputs);

}  // namespace camlaw::problems
