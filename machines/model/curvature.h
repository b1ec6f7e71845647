// SPDX-License-Identifier: MIT
#pragma once

#include "numerics/formula/operations.h"
#include "optim/problem/function.h"

/// What is known of the shape of a function, and how steps of a formula pass it on (docs/theory.md,
/// "Convexity from rules").
namespace camlaw::problems {

/// What a function is in the design's variables. Quasiconvex: every set {f <= c} is convex. Where
/// one variable alone varies: whether the function rises or falls with it, not strictly. Any of
/// these says too that the set where the function has a value is convex.
struct Curvature {
  bool convex = false, concave = false, quasiconvex = false, quasiconcave = false;
  bool rises = false, falls = false;

  bool is_linear() const { return convex && concave; }
  bool is_monotone() const { return rises || falls; }
  bool is_quasilinear() const { return (quasiconvex && quasiconcave) || is_monotone(); }
  /// Whether every set {f <= c} ({f >= c}) is convex.
  bool convex_below() const { return quasiconvex || is_monotone(); }
  bool convex_above() const { return quasiconcave || is_monotone(); }
};
inline constexpr Curvature kLinearShape{true, true, true, true};

/// What is known of a step's result. A constant has every curvature.
struct Ruled : Curvature {
  bool is_constant = false;
  Interval range;
  /// Of linear functions, and of convex ones of 0 or above; constants of 0 or above count.
  bool is_sum_of_squares = false;
  bool is_log_convex = false;  ///< positive, with a convex logarithm; positive constants count

  bool is_not_negative() const { return range.lower() >= 0; }
  bool is_not_positive() const { return range.upper() <= 0; }
  bool is_positive() const { return range.lower() > 0; }
  bool is_negative() const { return range.upper() < 0; }
  bool is_zero() const { return range.lower() == 0 && range.upper() == 0; }
};

Curvature mirrored(const Curvature& a);
Ruled negative(const Ruled& a);
Curvature sum(const Ruled& a, const Ruled& b);
Curvature product(const Ruled& a, const Ruled& b);
Curvature ratio(const Ruled& a, const Ruled& b);
Curvature powered(const Ruled& a, double p);
/// The root. A norm is convex.
Curvature root_of(const Ruled& a);
Curvature logarithm(const Ruled& a);
/// |a|
Curvature size_of(const Ruled& a);
/// An increasing function of a. It keeps quasiconvex and quasiconcave; `is_convex` and `is_concave`
/// say what it is itself.
Curvature increasing(const Curvature& a, bool is_convex, bool is_concave);
/// The arcsine, which has a value where a is within -1 and 1.
Curvature arcsine(const Ruled& a);
/// The tangent increases between plus and minus a right angle; from 0 on it is convex.
Curvature tangent(const Ruled& a);
/// a where it is positive.
Ruled where_positive(const Ruled& a);
Curvature greatest(const Curvature& a, const Curvature& b);
Curvature least(const Curvature& a, const Curvature& b);
/// Of one or the other.
Curvature common(const Curvature& a, const Curvature& b);

/// Whether a step gives a sum of squares of functions that are linear, or convex and 0 or above:
/// its root is a norm.
bool gives_sum_of_squares(Operation operation, bool same, const Ruled& a, const Ruled& b);
/// Whether a step gives a function whose logarithm is convex.
bool gives_log_convex(Operation operation, const Ruled& a, const Ruled& b);

optim::Shape shape_of(const Curvature& a);

}  // namespace camlaw::problems
