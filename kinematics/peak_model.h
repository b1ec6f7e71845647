// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "kinematics/peaks.h"
#include "numerics/polynomial/polynomial.h"
#include "numerics/scalar/bounds.h"

/// What a peak search knows of a quantity on one box of x: a polynomial with a remainder, in
/// Bernstein form (docs/theory.md, "Peaks"). T is double (fast) or Interval (proof).
namespace camlaw::detail {

/// Order of the Taylor polynomial of s taken of harmonics: at (frequency) (radius) = 0.8 the
/// remainder of s''' is 1e-15 of its size.
inline constexpr std::size_t kTaylorOrder = 18;

/// Boxes with a larger (frequency) (radius) are divided before anything is worked out.
inline constexpr double kWidestAngle = 1.0;

/// A box of x, as middle and radius; covers [low, high].
struct PeakBox {
  double low, high, middle, radius;

  PeakBox(double a, double b)
      : low(a),
        high(b),
        middle(std::midpoint(a, b)),
        radius(step_up(std::max(b - middle, middle - a))) {}
};

/// A quantity f on a box: |f(middle + radius u) - sum c[k] u^k| <= remainder for |u| <= 1.
template <class T>
struct TaylorModel {
  std::vector<T> c;
  double remainder = 0;
  Interval range;  ///< encloses f over the box
};

/// Models of the four quantities on one box, made once and kept as scratch space.
template <class T>
class BoxModels {
 public:
  /// Expands the piece about the box's middle.
  void expand(const Piece<T>& piece, const PeakBox& box);
  /// Encloses a quantity over the box, at less cost than its model.
  Interval range(Quantity q);
  /// The model of a quantity; valid until the next call of expand.
  const TaylorModel<T>& quantity(Quantity q);

 private:
  void expand_data(const Piece<T>& piece, const PeakBox& box);
  void expand_natural(const Piece<T>& piece, const PeakBox& box);
  void differentiate(std::size_t order);
  void multiply_moment();

  std::vector<T> taylor_;               // of s about the middle, unscaled
  std::vector<T> radius_powers_;        // 1, r, r^2, ...
  std::array<double, 4> remainders_{};  // of s, s', s'', s'''
  std::array<Interval, 4> ranges_{};    // natural ranges of the same
  bool has_ranges_ = false;
  std::array<TaylorModel<T>, kQuantities> models_;
  std::array<bool, kQuantities> ready_{};
};

}  // namespace camlaw::detail
