// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <vector>

#include "numerics/linear/envelope.h"
#include "numerics/scalar/scalar.h"

/// Motion through points (docs/theory.md, "Motion through points"): pieces of a polynomial each,
/// joined so that the mean square of the acceleration, or of the jerk, is the least possible.
namespace camlaw {

/// How smooth a motion through points is.
enum class Smoothness {
  Acceleration = 2,  ///< pieces of degree 3, least mean square of the acceleration
  Snap = 4           ///< pieces of degree 5, least mean square of the jerk
};

/// A piece of such a run: its part of the cycle, and the displacement at its ends.
template <class T>
struct RunPiece {
  T share, from, to;
};

/// What is stated of the motion where pieces meet, by the cycle's x.
template <class T>
struct RunKnot {
  std::optional<T> velocity, acceleration;
};

/// Velocity and acceleration at a knot; no acceleration where pieces are of degree 3.
template <class T>
using RunState = std::array<T, 2>;

namespace detail {

/// The integral over a unit interval of the square of the second derivative of the cubic with s, s'
/// at its ends, and of the third derivative of the quintic with s, s', s'' at its ends, as
/// quadratic forms in these.
inline constexpr double kCubicEnergy[4][4] = {
    {12, 6, -12, 6}, {6, 4, -6, 2}, {-12, -6, 12, -6}, {6, 2, -6, 4}};
inline constexpr double kQuinticEnergy[6][6] = {
    {720, 360, 60, -720, 360, -60},   {360, 192, 36, -360, 168, -24}, {60, 36, 9, -60, 24, -3},
    {-720, -360, -60, 720, -360, 60}, {360, 168, 24, -360, 192, -36}, {-60, -24, -3, 60, -36, 9}};

/// The unknown derivatives at the knots of a run, and the equations that they make the energy least
/// by.
template <class T>
class RunSystem {
 public:
  RunSystem(const std::vector<RunKnot<T>>& knots, Smoothness smoothness)
      : order_(smoothness == Smoothness::Acceleration ? 2 : 3),
        knots_(knots),
        unknown_(knots.size()),
        system_(number_unknowns()) {}

  /// Adds a piece between two knots.
  void add(const RunPiece<T>& piece, std::size_t begin, std::size_t end) {
    const std::size_t width = 2 * order_;
    std::vector<T> power{number<T>(1)};  // of the share
    for (std::size_t k = 1; k < width; ++k) power.push_back(power.back() * piece.share);
    const T& longest = power.back();
    // Entry i of the piece is derivative i % order at one of its ends.
    for (std::size_t i = 0; i < width; ++i) {
      const std::size_t row = i % order_;
      if (row == 0) continue;
      const auto at = index(i < order_ ? begin : end, row);
      if (!at) continue;
      for (std::size_t k = 1; k < width; ++k) {  // 0 is told with the displacement at the end
        const std::size_t column = k % order_;
        const T entry = number<T>(energy(i, k)) * power[row + column] / longest;
        const std::size_t knot = k < order_ ? begin : end;
        const auto other = column == 0 ? std::nullopt : index(knot, column);
        if (other) {
          if (*other <= *at) system_.add(*at, *other, entry);
        } else {
          const T known = column == 0 ? piece.to - piece.from : *stated(knot, column);
          system_.add_right(*at, -(entry * known));
        }
      }
    }
  }

  std::vector<RunState<T>> solve() && {
    const std::vector<T> found = std::move(system_).solve();
    std::vector<RunState<T>> states;
    for (std::size_t knot = 0; knot < knots_.size(); ++knot) {
      RunState<T> state{number<T>(0), number<T>(0)};
      for (std::size_t k = 1; k < order_; ++k) {
        const auto at = index(knot, k);
        state[k - 1] = at ? found[*at] : *stated(knot, k);
      }
      states.push_back(state);
    }
    return states;
  }

 private:
  std::optional<std::size_t> index(std::size_t knot, std::size_t derivative) const {
    return unknown_[knot][derivative - 1];
  }
  const std::optional<T>& stated(std::size_t knot, std::size_t derivative) const {
    return derivative == 1 ? knots_[knot].velocity : knots_[knot].acceleration;
  }
  double energy(std::size_t i, std::size_t k) const {
    return order_ == 2 ? kCubicEnergy[i][k] : kQuinticEnergy[i][k];
  }
  std::size_t number_unknowns() {
    std::size_t count = 0;
    for (std::size_t knot = 0; knot < knots_.size(); ++knot) {
      for (std::size_t k = 1; k < order_; ++k) {
        if (!stated(knot, k)) unknown_[knot][k - 1] = count++;
      }
    }
    return count;
  }

  std::size_t order_;
  const std::vector<RunKnot<T>>& knots_;
  std::vector<std::array<std::optional<std::size_t>, 2>> unknown_;
  Envelope<T> system_;
};

}  // namespace detail

/// Velocity and acceleration at every knot of a run of pieces. There is one knot more than pieces,
/// the first and the last with all that the smoothness needs, velocity and for quintics
/// acceleration; or as many knots as pieces, where the last piece ends at the first knot.
template <class T>
std::vector<RunState<T>> run_states(const std::vector<RunPiece<T>>& pieces,
                                    const std::vector<RunKnot<T>>& knots, Smoothness smoothness) {
  detail::RunSystem<T> system(knots, smoothness);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    system.add(pieces[i], i, (i + 1) % knots.size());
  }
  return std::move(system).solve();
}

}  // namespace camlaw
