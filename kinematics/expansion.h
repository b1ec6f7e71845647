// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/piece.h"

namespace camlaw {

/// A piece of a law over a stretch of x: enclosures of s and five derivatives, which is what s, v,
/// a, j and two derivatives of each need.
struct Expansion {
  static constexpr std::size_t kOrders = 6;
  using Derivatives = std::array<Interval, kOrders>;

  double middle = 0;  ///< of the stretch
  double radius = 0;  ///< no x of the stretch is further from the middle
  Derivatives at;     ///< at the middle
  Derivatives over;   ///< at every x of the stretch
};

/// Encloses a piece over short stretches, many times: in plain numbers with an error bound beside
/// each, which is several times faster than interval arithmetic and as safe (docs/theory.md,
/// "Bounds of a law over an interval"). The piece's formula counts, wherever its ends are.
class PieceExpander {
 public:
  explicit PieceExpander(Piece<Interval> piece);

  Expansion operator()(const Interval& x) const;
  const Piece<Interval>& piece() const { return piece_; }

 private:
  /// A number known to lie within `error` of `value`.
  struct Near {
    double value = 0, error = 0;
    explicit Near(const Interval& x);
    double size() const { return std::abs(value) + error; }
  };
  struct NearHarmonic {
    Near sine, cosine, frequency;
    double amplitude;  ///< a bound, above
  };
  struct Sums;

  void add_polynomial(double t, double slack, Sums& sums) const;
  void add_harmonic(const NearHarmonic& harmonic, double t, double slack, Sums& sums) const;
  void add_intervals(const Interval& x, Expansion& e) const;

  Piece<Interval> piece_;
  Near origin_;
  std::vector<Near> polynomial_;  ///< empty where it has too many terms for the fast way
  std::vector<NearHarmonic> harmonics_;
};

}  // namespace camlaw
