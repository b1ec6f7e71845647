// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "kinematics/laws/catalogue.h"

/// The free law: a B-spline law all of whose coefficients may vary but those that its ends decide.
/// Equations: docs/theory.md, "Free laws".
namespace camlaw {

/// What a free law does at an end beside s = 0 or s = 1.
struct FreeEnd {
  int vanishing = 0;      ///< s', s'', ... up to this derivative are 0 there
  bool straight = false;  ///< s'' is 0 there, and s' is free; `vanishing` is 0 then
  friend bool operator==(const FreeEnd&, const FreeEnd&) = default;
};

/// The spline space in which a law is looked for.
struct FreeLaw {
  int degree = 3;
  std::vector<double> knots = {};  ///< inside (0, 1), increasing; each counted once
  int continuity = 2;              ///< s .. s^(continuity) are continuous at the knots
  FreeEnd begin = {}, end = {};
  bool symmetric = false;     ///< s(x) + s(1 - x) = 1
  bool moving_knots = false;  ///< the knots are parameters too
};

/// n even places inside (0, 1).
std::vector<double> even_knots(int n);

/// A member of the free law's own family, "free". Its parameters are `coefficients`, in which it is
/// linear: those that neither the ends nor the symmetry decide, in the order of the spline; and,
/// where they move, `knots` (of a symmetric law those below 1/2). It begins as the spline whose
/// coefficients are `start` at the means of each `degree` neighbouring knots, which follows `start`
/// closely. Member::listed() is the same law, to the last bit, as a `b-spline`.
///
/// Throws std::invalid_argument for a degree outside 1 .. 25, a continuity outside 0 .. degree - 1,
/// knots that do not increase within (0, 1), ends that ask for more than the degree has, a
/// symmetric law whose knots or ends are not, and where no coefficient is left free.
Member free_law(const FreeLaw& shape, const Law<double>& start);

}  // namespace camlaw
