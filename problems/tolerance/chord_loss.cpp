// SPDX-License-Identifier: MIT
#include "problems/tolerance/chord_loss.h"

#include <algorithm>
#include <cmath>

namespace camlaw::problems {
namespace {

inline double above_zero(double x) { return std::max(x, 0.0); }
inline Interval above_zero(const Interval& x) {
  Interval result;
  result.assign(std::max(x.lower(), 0.0), std::max(x.upper(), 0.0));
  return result;
}

/// 1 above zero, else 0.
inline double is_above_zero(double x) { return x > 0 ? 1 : 0; }
inline Interval is_above_zero(const Interval& x) {
  return Interval(is_above_zero(x.lower()), is_above_zero(x.upper()));
}

/// (PE9) By how much the follower's velocity changes from one chord to the next, of a curvature.
template <class T>
T velocity_change(const ProfilePlace<T>& p, const T& curvature, const ProfileErrors& errors,
                  double speed) {
  using std::sqrt;
  const T turned = p.lift.value * p.arc;
  if (errors.chord) return T(speed) * turned * sqrt(T(8 * *errors.chord / 1e3) * curvature);
  const T step(*errors.chord_step / profile::kPerDegree);
  return T(speed) * turned * (p.arc * curvature) * step;
}

/// By how much a chord deviates at most from the profile, m, of a curvature.
template <class T>
T deviation(const ProfilePlace<T>& p, const T& curvature, const ProfileErrors& errors) {
  if (errors.chord) return T(*errors.chord / 1e3);
  const T length = p.arc * T(*errors.chord_step / profile::kPerDegree);
  return profile::square(length) * curvature / T(8);
}

template <class F>
ProfileEffect effect_of(const ProfileGeometry& geometry, std::string name, const char* unit,
                        double drawn, const F& formula) {
  const double rough = highest(geometry, kInfinite, formula).value;
  // An effect that is proved to a thousandth is known better than the errors it comes from.
  constexpr double kOfPeak = 1e-3, kOfNothing = 1e-12;
  const CyclePeak peak = highest(geometry, std::max(kOfPeak * rough, kOfNothing), formula);
  return {std::move(name), unit, drawn, peak.value, peak.at, peak.proved};
}

/// The follower's force along chords and over their corners (PE10), where a roller runs on convex
/// stretches. Over a corner the spring gives less by its rate times how much lower the follower may
/// be; along a chord that is left out of the highest force.
std::vector<ProfileEffect> force_effects(const ProfileGeometry& geometry,
                                         const ProfileErrors& errors) {
  constexpr double kOfChange = 1e-3;  // three digits of the change are shown
  const double inertia = geometry.mass() * geometry.speed() * geometry.speed();
  const double radius = geometry.roller();
  const auto row = [&](const char* which, const char* where, double sign, const auto& change) {
    const auto drawn = [&](const auto& p) {
      using T = std::decay_t<decltype(p.force)>;
      return T(sign) * p.force;
    };
    const auto with = [&](const auto& p) { return drawn(p) + change(p); };
    const double rough = highest(geometry, kInfinite, drawn).value;
    const double grown = highest(geometry, kInfinite, with).value - rough;
    const double accuracy = std::max(0.5 * kOfChange * grown, 1e-9 * std::abs(rough) + 1e-12);
    const CyclePeak before = highest(geometry, accuracy, drawn);
    const CyclePeak worst = highest(geometry, accuracy, with);
    const double off = (before.at_most - before.value) + (worst.at_most - worst.value);
    return ProfileEffect{which + geometry.force_name() + where,
                         geometry.swings() ? "N m" : "N",
                         sign * before.value,
                         sign * worst.value,
                         worst.at,
                         off <= kOfChange * (worst.value - before.value)};
  };
  return {row("highest ", ", along a chord", 1,
              [&](const auto& p) {
                using T = std::decay_t<decltype(p.curvature)>;
                const T k = above_zero(p.curvature);
                return T(inertia) * p.lift.value * profile::square(p.arc) * k *
                       (T(1) + T(radius) * k);
              }),
          row("least ", ", over a corner", -1, [&](const auto& p) {
            using T = std::decay_t<decltype(p.curvature)>;
            const T lower = deviation(p, above_zero(p.curvature), errors);
            return p.lift.value * (T(inertia) * *p.stiffness + T(geometry.spring()) * lower) *
                   is_above_zero(p.curvature);
          })};
}

}  // namespace

std::vector<ProfileEffect> chord_effects(const ProfileGeometry& geometry,
                                         const AccelerationPeaks& drawn,
                                         const ProfileErrors& errors) {
  const double speed = geometry.speed(), square = speed * speed;
  const char* velocity_unit = geometry.swings() ? "rad/s" : "m/s";
  const char* unit = geometry.swings() ? "rad/s2" : "m/s2";
  const auto convex = [&](const auto& p) {
    return velocity_change(p, above_zero(p.curvature), errors, speed);
  };
  const double radius = geometry.roller();
  const auto hollow = [&](const auto& p) {
    using T = std::decay_t<decltype(p.curvature)>;
    const T k = above_zero(T(-p.curvature));
    return velocity_change(p, k, errors, speed) * (T(1) - T(radius) * k);
  };
  if (geometry.contact() != ProfileContact::Roller) {
    std::vector<ProfileEffect> all{
        effect_of(geometry, "jump of the velocity at corners", velocity_unit, 0, convex)};
    if (geometry.contact() == ProfileContact::Edge) {
      all.push_back(
          effect_of(geometry, "jump of the velocity in hollows", velocity_unit, 0, hollow));
    }
    return all;
  }
  std::vector<ProfileEffect> all{
      effect_of(geometry, "jump of the velocity in hollows", velocity_unit, 0, hollow),
      effect_of(geometry, "ripple of the velocity elsewhere", velocity_unit, 0, convex),
      effect_of(geometry, "acceleration away, along a chord", unit, drawn.away.value,
                [&](const auto& p) {
                  using T = std::decay_t<decltype(p.curvature)>;
                  const T k = above_zero(p.curvature);
                  return p.acceleration + T(square) * p.lift.value * profile::square(p.arc) * k *
                                              (T(1) + T(radius) * k);
                }),
      effect_of(geometry, "acceleration towards, over a corner", unit, drawn.towards.value,
                [&](const auto& p) {
                  using T = std::decay_t<decltype(p.curvature)>;
                  return T(square) * p.lift.value * *p.stiffness * is_above_zero(p.curvature) -
                         p.acceleration;
                })};
  for (ProfileEffect& effect : force_effects(geometry, errors)) all.push_back(std::move(effect));
  return all;
}

}  // namespace camlaw::problems
