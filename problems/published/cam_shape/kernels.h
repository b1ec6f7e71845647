// SPDX-License-Identifier: MIT
#pragma once

#include "optim/problem/function.h"

/// The functions of the cam-shape problem; private to this folder.
namespace camlaw::problems::cam_shape_parts {

/// A radius of the cam: a variable (its number from 0) or, before and after them, a given one.
struct Radius {
  int variable = -1;
  double given = 0;
};

/// (2 A C cos d - B (A + C)) / d^2 of three neighbours A, B, C and the angle d between them: how
/// far the cam is from convex at B. Written as A (C - B) - C (B - A) - 4 sin^2(d/2) A C, since what
/// is left of the products is some d^2 of them; over d^2 it tends to r r'' - 2 r'^2 - r^2.
optim::Function convexity(Radius a, Radius b, Radius c, double angle);

/// (B - A) / d.
optim::Function slope(Radius a, Radius b, double angle);

/// factor times the sum of the variables 0 .. count - 1.
optim::Function sum(std::size_t count, double factor);

}  // namespace camlaw::problems::cam_shape_parts
