// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kinematics/piece.h"
#include "numerics/possible.h"

namespace camlaw {

/// What joins a stretch at an end, after VDI 2143: R rest (v = 0, a = 0 beyond), G constant
/// velocity (a = 0 beyond), U reversal (v = 0, the motion mirrored beyond), B any motion.
enum class End { Rest, Velocity, Reversal, Motion };

/// The two ends of a stretch, for example {Rest, Rest} for a dwell-to-dwell law.
struct Ends {
  End begin = End::Rest;
  End end = End::Rest;
  friend bool operator==(const Ends&, const Ends&) = default;
};

/// "R-R", "R-U", ... (VDI 2143 letters).
std::string to_string(Ends ends);

/// Displacement, velocity, acceleration and jerk of a normalised law: derivatives by x.
template <class R>
struct Motion {
  R s, v, a, j;
};

/// Which limit is meant where two pieces meet.
enum class Side { Left, Right };

/// A motion law: normalised displacement s(x) of one stretch, x in [0, 1], as a list of pieces
/// (docs/theory.md, "Laws as data"). A stretch of stroke S covered in time T moves as S s(t / T).
///
/// T is the scalar of the coefficients. Evaluation takes x as double, Dual or Interval; with an
/// Interval the result encloses every value over that stretch of x. Outside [0, 1] and at NaN the
/// result is NaN (for an Interval: the part inside [0, 1] counts, none gives NaN).
template <class T>
class Law {
 public:
  using Scalar = T;

  /// Takes pieces in order that cover [0, 1]; ends that differ by up to 1e-12 are joined. Throws
  /// std::invalid_argument where they do not.
  Law(std::vector<Piece<T>> pieces, Ends ends) : Law(possible(std::move(pieces), ends).value()) {}
  /// The same, told by value where the pieces make no law.
  static Possible<Law> possible(std::vector<Piece<T>> pieces, Ends ends);

  const std::vector<Piece<T>>& pieces() const { return pieces_; }
  Ends ends() const { return ends_; }
  /// Whether every piece is polynomial plus harmonics.
  bool is_data() const {
    return std::all_of(pieces_.begin(), pieces_.end(), [](const auto& p) { return p.is_data(); });
  }
  /// The same law between other ends.
  Law with_ends(Ends ends) const { return Law(pieces_, ends); }

  /// s, v, a, j at x; at a break the limit from the given side.
  template <class X>
  Motion<Joined<T, X>> operator()(const X& x, Side side = Side::Right) const {
    const auto d = derivatives<4>(x, side);
    return {d[0], d[1], d[2], d[3]};
  }

  /// The first N derivatives, s itself included. N above kCurveOrders only for laws that are data.
  template <std::size_t N, class X>
  std::array<Joined<T, X>, N> derivatives(const X& x, Side side = Side::Right) const;

  /// Index of the piece that holds x, the earlier one from the left at a break; x in [0, 1].
  std::size_t piece_at(double x, Side side) const;

  /// The same law in the scalar R.
  template <class R>
  Law<R> as() const {
    std::vector<Piece<R>> result;
    for (const auto& piece : pieces_) result.push_back(piece_as<R>(piece));
    return Law<R>(std::move(result), ends_);
  }

 private:
  struct Checked {};
  Law(Checked, std::vector<Piece<T>> pieces, Ends ends) : pieces_(std::move(pieces)), ends_(ends) {}

  template <std::size_t N, class R>
  std::array<R, N> enclosure(const Interval& x) const;

  std::vector<Piece<T>> pieces_;
  Ends ends_;
};

/// Curves of one law over many points; each span as long as x, or empty where not wanted.
struct MotionSpans {
  std::span<double> s, v, a, j;
};

/// s, v, a, j at every point of x (from the right at breaks; NaN outside [0, 1]): the fast way
/// through many points. No span may overlap x. Throws std::invalid_argument if a span's length
/// differs from x's.
void evaluate(const Law<double>& law, std::span<const double> x, MotionSpans out);

// ---------------------------------------------------------------------------------------------

namespace detail {
Impossible bad_pieces(const std::string& why);
/// Where a piece that ends at `end` does not meet one that begins at `next`.
std::optional<Impossible> gap_between(double end, double next);

template <class T>
bool is_finite(const Piece<T>& piece) {
  bool finite = true;
  const auto look = [&](const T& x) { finite = finite && std::isfinite(value_of(x)); };
  look(piece.origin);
  for (const T& c : piece.polynomial) look(c);
  for (const auto& h : piece.harmonics) look(h.sine), look(h.cosine), look(h.frequency);
  for (const auto& c : piece.curves) look(c.amplitude), look(c.rate), look(c.shift);
  return finite;
}

/// Joins pieces whose breaks rounding has set apart, so that no x lies between two of them; says
/// why where they do not cover [0, 1].
template <class T>
std::optional<Impossible> join_pieces(std::vector<Piece<T>>& pieces) {
  if (pieces.empty()) return bad_pieces("it has no pieces");
  for (const Piece<T>& piece : pieces) {
    if (!is_finite(piece)) return bad_pieces("a coefficient is not finite");
  }
  if (auto gap = gap_between(0, value_of(pieces.front().begin))) return gap;
  if (auto gap = gap_between(value_of(pieces.back().end), 1)) return gap;
  pieces.front().begin = number<T>(0);
  pieces.back().end = number<T>(1);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i > 0) {
      auto gap = gap_between(value_of(pieces[i - 1].end), value_of(pieces[i].begin));
      if (gap) return gap;
      pieces[i].begin = pieces[i - 1].end;
    }
    if (!(value_of(pieces[i].begin) < value_of(pieces[i].end))) {
      return bad_pieces("a piece does not end after it begins");
    }
  }
  return {};
}
}  // namespace detail

template <class T>
Possible<Law<T>> Law<T>::possible(std::vector<Piece<T>> pieces, Ends ends) {
  if (auto fault = detail::join_pieces(pieces)) return std::move(*fault);
  return Law(Checked{}, std::move(pieces), ends);
}

template <class T>
std::size_t Law<T>::piece_at(double x, Side side) const {
  const auto holds =
      std::partition_point(pieces_.begin(), pieces_.end() - 1, [&](const Piece<T>& piece) {
        const double end = value_of(piece.end);
        return !(x < end || (x == end && side == Side::Left));
      });
  return static_cast<std::size_t>(holds - pieces_.begin());
}

template <class T>
template <std::size_t N, class X>
std::array<Joined<T, X>, N> Law<T>::derivatives(const X& x, Side side) const {
  using R = Joined<T, X>;
  if constexpr (std::is_same_v<X, Interval>) {
    return enclosure<N, R>(x);
  } else {
    const double at = value_of(x);
    if (!(at >= 0 && at <= 1)) {
      std::array<R, N> undefined;
      undefined.fill(number<R>(std::numeric_limits<double>::quiet_NaN()));
      return undefined;
    }
    return camlaw::derivatives<N>(pieces_[piece_at(at, side)], x);
  }
}

template <class T>
template <std::size_t N, class R>
std::array<R, N> Law<T>::enclosure(const Interval& x) const {
  std::array<R, N> hull;
  hull.fill(Interval::empty());
  for (const auto& piece : pieces_) {
    const Interval begin = convert<Interval>(piece.begin);
    const Interval end = convert<Interval>(piece.end);
    const Interval part = boost::numeric::intersect(x, Interval(begin.lower(), end.upper()));
    if (boost::numeric::empty(part)) continue;
    const auto d = camlaw::derivatives<N, T, Interval, Interval>(piece, part);
    for (std::size_t k = 0; k < N; ++k) hull[k] = boost::numeric::hull(hull[k], d[k]);
  }
  return hull;
}

}  // namespace camlaw
