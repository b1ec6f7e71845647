// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <type_traits>
#include <vector>

#include "kinematics/law.h"
#include "numerics/possible.h"

/// A follower on an elastic train: one mass behind a spring and a damper that the cam moves at the
/// other end (docs/theory.md, "Elastic follower train"). What has happened before decides where the
/// mass is, so that a formula needs the law as a whole and goes through its pieces: it cannot be
/// recorded, and is a template in the scalar.
namespace camlaw {

/// Where the mass stands against the cam's motion, in parts of the stroke, and its rate by x.
template <class T>
struct TrainState {
  T z, rate;
};

/// The train over one stretch of unit length: z'' + 2 zeta W z' + W^2 z = -s'', z = y - s, where
/// y is the mass and W = 2 pi tau, tau the stretch's time over the natural period.
template <class T>
struct FollowerTrain {
  T period_ratio;   ///< tau, above 0
  T damping_ratio;  ///< zeta, 0 or more and below 1

  /// The state at the end of a stretch from a state at its beginning. Exact for laws that are data:
  /// each power and each harmonic of s'' has its integral against exp(lambda x) in closed form.
  /// Impossible for a law with curves or jumps of velocity, rest before and behind it counted, and
  /// for ratios outside their ranges.
  Possible<TrainState<T>> after(const Law<T>& law,
                                TrainState<T> begin = {number<T>(0), number<T>(0)}) const;
  /// The state at x inside the stretch.
  Possible<TrainState<T>> at(const Law<T>& law, double x,
                             TrainState<T> begin = {number<T>(0), number<T>(0)}) const;
  /// (U1) Amplitude of the free vibration that begins in a state, in parts of the stroke:
  /// sqrt(z^2 + ((z' + zeta W z) / (W sqrt(1 - zeta^2)))^2).
  T amplitude(const TrainState<T>& state) const;
  /// Greatest acceleration of the mass after a stretch that began at rest, by x: W^2 times the
  /// amplitude. Over the law's peak C it is the amplification that is left. Throws
  /// std::invalid_argument where after() is impossible.
  T residual_acceleration(const Law<T>& law) const;
};

/// How the train moves along a law, worked out once: a place then costs the piece that it lies in.
/// It looks at the law, which must outlive it.
template <class T>
class TrainMotion {
 public:
  /// From a state at the beginning, up to x = `until`. Impossible where FollowerTrain::after is.
  static Possible<TrainMotion> from(const FollowerTrain<T>& train, const Law<T>& law,
                                    const TrainState<T>& begin, double until = 1);
  /// (U5) The steady state of a cycle that the law goes through again and again, of unit length:
  /// it ends in the state in which it began. Impossible as above, jumps counted from the cycle's
  /// end to its beginning, and without damping where the cycle lasts a whole number of natural
  /// periods: the vibration then grows without end.
  static Possible<TrainMotion> periodic(const FollowerTrain<T>& train, const Law<T>& law);

  const FollowerTrain<T>& train() const { return train_; }
  /// The state at x, and where the motion ends. At the end of a piece it moves with that end.
  TrainState<T> at(double x) const;
  TrainState<T> last() const { return state(v_.back()); }
  /// What z and z' lie between within `radius` of a middle, all in one piece, where |s''| is no
  /// more than `peak`.
  TrainState<T> around(double middle, double radius,
                       double peak) const requires std::is_same_v<T, Interval>;
  /// (U6) The greatest amplitude with which the train swings freely while the law rests. Impossible
  /// where it never rests.
  Possible<T> swing_at_rest() const;

 private:
  using V = std::array<T, 2>;  ///< v = z' - conj(lambda) z, real and imaginary part
  TrainMotion(const FollowerTrain<T>& train, const Law<T>& law);
  TrainState<T> state(const V& v) const;
  V within(double x) const;
  void go(const TrainState<T>& begin, double until);

  FollowerTrain<T> train_;
  const Law<T>* law_;
  T decay_, damped_;  ///< lambda = -decay + i damped
  std::vector<V> v_;  ///< where each piece begins, and where the last one ends
};

/// Amplitude after a stretch that began at rest: the residual vibration, in parts of the stroke.
/// Throws std::invalid_argument where FollowerTrain::after is impossible.
template <class T>
T residual_vibration(const Law<T>& law, const T& period_ratio, const T& damping_ratio) {
  const FollowerTrain<T> train{period_ratio, damping_ratio};
  return train.amplitude(train.after(law).value());
}

}  // namespace camlaw
