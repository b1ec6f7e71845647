// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "kinematics/law.h"
#include "numerics/possible.h"

/// A follower on an elastic train: one mass behind a spring and a damper that the cam moves at the
/// other end (docs/theory.md, "Elastic follower train").
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

/// Amplitude after a stretch that began at rest: the residual vibration, in parts of the stroke.
/// Throws std::invalid_argument where FollowerTrain::after is impossible.
template <class T>
T residual_vibration(const Law<T>& law, const T& period_ratio, const T& damping_ratio) {
  const FollowerTrain<T> train{period_ratio, damping_ratio};
  return train.amplitude(train.after(law).value());
}

}  // namespace camlaw
