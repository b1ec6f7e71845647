// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/peaks.h"
#include "kinematics/shape.h"

/// Laws made from other laws.
namespace camlaw {

namespace detail {

/// The piece over the new argument x' with x = slope x' + shift, displaced as
/// s' = factor s + offset. slope may be negative, which turns the piece round.
template <class T>
Piece<T> map_piece(const Piece<T>& piece, const T& slope, const T& shift, const T& factor,
                   const T& offset) {
  const auto place = [&](const T& x) { return (x - shift) / slope; };
  Piece<T> result{place(piece.begin), place(piece.end), place(piece.origin), {}, {}, {}};
  if (value_of(slope) < 0) std::swap(result.begin, result.end);
  T scale = factor;
  for (const T& c : piece.polynomial) {
    result.polynomial.push_back(scale * c);
    scale = scale * slope;
  }
  if (result.polynomial.empty()) result.polynomial.push_back(number<T>(0));
  result.polynomial.front() = result.polynomial.front() + offset;
  for (const auto& h : piece.harmonics) {
    result.harmonics.push_back({factor * h.sine, factor * h.cosine, slope * h.frequency});
  }
  for (const auto& c : piece.curves) {
    result.curves.push_back({factor * c.amplitude, slope * c.rate, c.shift, c.curve});
  }
  return result;
}

}  // namespace detail

/// reversed, told by value where rounding leaves a piece without length.
template <class T>
Possible<Law<T>> possible_reversed(const Law<T>& law) {
  const T one = number<T>(1);
  std::vector<Piece<T>> pieces;
  for (std::size_t i = law.pieces().size(); i-- > 0;) {
    pieces.push_back(detail::map_piece(law.pieces()[i], -one, one, -one, one));
  }
  return Law<T>::possible(std::move(pieces), {law.ends().end, law.ends().begin});
}

/// The law run backwards: s(x) = 1 - law(1 - x), its ends exchanged. A dwell-to-turn law becomes
/// the turn-to-dwell law.
template <class T>
Law<T> reversed(const Law<T>& law) {
  return possible_reversed(law).value();
}

/// Where the acceleration of a rest-to-rest law changes sign, and how far the law has risen there.
template <class T>
struct Crossover {
  T position, risen;
};

namespace detail {

/// Whether the piece moves at constant velocity.
template <class T>
bool is_straight(const Piece<T>& piece) {
  for (std::size_t k = 2; k < piece.polynomial.size(); ++k) {
    if (value_of(piece.polynomial[k]) != 0) return false;
  }
  return piece.harmonics.empty() && piece.curves.empty() && piece.polynomial.size() > 1;
}

}  // namespace detail

/// 1/2 and 1/2 for a symmetric law; else where the velocity peaks, the middle of it where the law
/// keeps its peak velocity for a while.
template <class T>
Crossover<T> crossover(const Law<T>& law) {
  const T half = ratio<T>(1, 2);
  if (is_symmetric(law.template as<double>())) return {half, half};
  const auto peak = peaks(law).high(Quantity::Velocity);
  T position = peak.position;
  for (const Piece<T>& piece : law.pieces()) {
    if (!detail::is_straight(piece)) continue;
    const double shortfall = value_of(peak.value) - value_of(piece.polynomial[1]);
    if (shortfall <= 1e-9 * value_of(peak.value)) position = (piece.begin + piece.end) * half;
  }
  return {position, law.template derivatives<1>(position)[0]};
}

/// The law with the crossover `now` moved to `at` in (0, 1): both parts are stretched in x, and
/// their strokes shared so that the velocity is continuous where they meet. The peak velocity of a
/// symmetric law stays, its peak accelerations become C / (2 at) and C / (2 (1 - at)).
/// Impossible for `at` outside (0, 1).
template <class T>
Possible<Law<T>> possible_with_crossover(const Law<T>& law, const Crossover<T>& now, const T& at) {
  if (!(value_of(at) > 0 && value_of(at) < 1)) {
    return Impossible{"crossover must lie between 0 and 1"};
  }
  const T one = number<T>(1);
  const auto& [from, risen] = now;
  const T slope1 = from / at, slope2 = (one - from) / (one - at);
  const T share1 = one / (risen + slope1 / slope2 * (one - risen));
  const T share2 = share1 * slope1 / slope2;
  const T shift2 = one - slope2;  // x = 1 - slope2 (1 - x')
  std::vector<Piece<T>> pieces;
  // A break that rounding alone keeps apart from the crossover is the crossover.
  constexpr double kRounding = 1e-13;
  const double early = value_of(from) - kRounding, late = value_of(from) + kRounding;
  for (Piece<T> piece : law.pieces()) {
    if (value_of(piece.begin) >= early) break;
    if (value_of(piece.end) >= early) piece.end = from;
    pieces.push_back(detail::map_piece(piece, slope1, number<T>(0), share1, number<T>(0)));
  }
  for (Piece<T> piece : law.pieces()) {
    if (value_of(piece.end) <= late) continue;
    if (value_of(piece.begin) <= late) piece.begin = from;
    pieces.push_back(detail::map_piece(piece, slope2, shift2, share2, one - share2));
  }
  pieces.back().end = one;
  return Law<T>::possible(std::move(pieces), law.ends());
}

/// The law skewed by c in (0, 1): the odds of its crossover x_c are multiplied by those of c,
/// x / (1 - x) = x_c / (1 - x_c) c / (1 - c). So c is the new crossover of a symmetric law, and 1/2
/// leaves every law as it is.
template <class T>
Possible<Law<T>> skewed(const Law<T>& law, const T& c) {
  const T one = number<T>(1);
  const Crossover<T> now = crossover(law);
  const T early = now.position * c, late = (one - now.position) * (one - c);
  return possible_with_crossover(law, now, T(early / (early + late)));
}

/// possible_with_crossover from the law's own crossover. Throws std::invalid_argument for `at`
/// outside (0, 1).
template <class T>
Law<T> with_crossover(const Law<T>& law, const T& at) {
  return possible_with_crossover(law, crossover(law), at).value();
}

}  // namespace camlaw
