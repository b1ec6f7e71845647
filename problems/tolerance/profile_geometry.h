// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <optional>
#include <string>

#include "numerics/scalar/absolute.h"
#include "numerics/scalar/where_positive.h"
#include "problems/statement/statement.h"
#include "problems/tolerance/cycle_peak.h"

/// A cam's profile as its follower feels errors of it (docs/theory.md, "Errors of the profile").
/// Lengths in m, angles in rad, derivatives by the cam angle.
namespace camlaw::problems {

/// How a follower touches the profile.
enum class ProfileContact : char {
  Roller,
  Edge,  ///< a knife edge
  Face,
};

/// Waves along the profile: so many in a turn, or so long.
struct Waves {
  std::optional<double> in_turn;  ///< n; none: by length
  double length = 0;              ///< lambda, m, along the profile
};

/// What is known at one place of the cycle, or over a stretch of it.
template <class T>
struct ProfilePlace {
  CurveJet<T> lift;            ///< q: what the follower moves by, of an error along the normal
  T acceleration;              ///< m/s^2 or rad/s^2
  T force;                     ///< of the follower, N or N m
  T arc, arc_slope;            ///< |p'| and its derivative
  T curvature;                 ///< kappa of the profile, 1/m, above 0 where it is convex
  std::optional<T> stiffness;  ///< K = |p'|^2 (kappa + 1/r), m; none under an edge
};

/// One cam with its follower.
class ProfileGeometry {
 public:
  /// The design that a statement begins with. Throws std::invalid_argument for a machine without a
  /// profile of one cam and one follower.
  explicit ProfileGeometry(const ProblemStatement& design);

  ProfileContact contact() const { return contact_; }
  bool swings() const { return swings_; }
  /// What acts along the follower's way.
  std::string force_name() const { return swings_ ? "follower torque" : "follower force"; }
  double speed() const { return speed_; }    ///< omega, rad/s
  double mass() const { return mass_; }      ///< kg or kg m^2
  double spring() const { return spring_; }  ///< N/m or N m/rad
  double roller() const { return roller_; }  ///< its radius, m; under an edge 0, under a face none
  const Traces& traces() const { return traces_; }
  /// Of the contact, in its listed unit; null where the machine knows none.
  const optim::Trace* stress() const { return stress_.get(); }
  const std::string& stress_unit() const { return stress_unit_; }

  template <class T>
  ProfilePlace<T> place(const std::vector<CurveJet<T>>& jets) const;
  ProfilePlace<double> place_at(const optim::Place& place) const;

 private:
  template <class T>
  CurveJet<T> lift(const std::vector<CurveJet<T>>& jets) const;

  /// The curves, in the order of the traces.
  enum Curve : std::size_t { kAcceleration, kForce, kX, kY, kBent, kLift };

  ProfileContact contact_ = ProfileContact::Roller;
  bool swings_ = false;
  double speed_ = 0, mass_ = 0, spring_ = 0, roller_ = 0, arm_ = 1;
  Traces traces_;
  std::unique_ptr<optim::Trace> stress_;
  std::string stress_unit_;
};

namespace profile {

/// Of one angle in degrees.
inline constexpr double kPerDegree = 180 / std::numbers::pi;

inline double square(double x) { return x * x; }
inline Interval square(const Interval& x) { return boost::numeric::square(x); }

/// 1 / cos with its derivatives, of an angle in degrees by degrees; by radians.
template <class T>
CurveJet<T> secant(const CurveJet<T>& degrees) {
  using std::cos;
  using std::sin;
  const T angle = degrees.value / T(kPerDegree), c = cos(angle), u = sin(angle) / c;
  const T slope = degrees.slope, bend = degrees.bend * T(kPerDegree), s = T(1) / c;
  return {s, s * u * slope, s * ((T(1) + T(2) * square(u)) * square(slope) + u * bend)};
}

/// 1 / f of a length in mm over degrees, in 1/m by radians.
template <class T>
CurveJet<T> inverse(const CurveJet<T>& f) {
  const T x = f.value / T(1e3), d = f.slope * T(kPerDegree / 1e3);
  const T dd = f.bend * T(kPerDegree * kPerDegree / 1e3);
  return {T(1) / x, -d / square(x), T(2) * square(d) / (x * square(x)) - dd / square(x)};
}

}  // namespace profile

template <class T>
CurveJet<T> ProfileGeometry::lift(const std::vector<CurveJet<T>>& jets) const {
  if (contact_ == ProfileContact::Face) {
    return swings_ ? profile::inverse(jets[kLift]) : CurveJet<T>{T(1), T(0), T(0)};
  }
  const CurveJet<T> s = profile::secant(jets[kLift]);
  return {s.value / T(arm_), s.slope / T(arm_), s.bend / T(arm_)};
}

template <class T>
ProfilePlace<T> ProfileGeometry::place(const std::vector<CurveJet<T>>& jets) const {
  using profile::kPerDegree, profile::square, std::sqrt;
  const T first(kPerDegree / 1e3), second(kPerDegree * kPerDegree / 1e3);
  const T dx = jets[kX].slope * first, dy = jets[kY].slope * first;
  const T ddx = jets[kX].bend * second, ddy = jets[kY].bend * second;
  ProfilePlace<T> p;
  p.lift = lift(jets);
  p.acceleration = jets[kAcceleration].value;
  p.force = jets[kForce].value;
  p.arc = sqrt(square(dx) + square(dy));
  p.arc_slope = (dx * ddx + dy * ddy) / p.arc;
  const bool by_radius = contact_ == ProfileContact::Face;
  p.curvature = by_radius ? T(1e3) / jets[kBent].value : jets[kBent].value * T(1e3);
  if (contact_ == ProfileContact::Roller) {
    p.stiffness = square(p.arc) * (p.curvature + T(1 / roller_));
  } else if (contact_ == ProfileContact::Face) {
    p.stiffness = square(p.arc) * p.curvature;
  }
  return p;
}

/// What is made of the follower's displacement: inertia * delta'' + spring * delta. The
/// acceleration is (omega^2, 0), the force (m omega^2, c).
struct WaveFactors {
  double inertia, spring = 0;
};

/// That of waves of the amplitude 1 m at worst, whatever their phase (PE4, PE11); of any error
/// within 1 m without shorter waves (PE8).
template <class T>
struct WaveSize {
  T either;  ///< away from the cam and towards it
  T steep;   ///< inertia * q k^2, the part that the roller sharpens in the valleys
  T number;  ///< k, by radian of the cam angle
};

template <class T>
WaveSize<T> wave_size(const ProfilePlace<T>& p, const Waves& waves, bool any,
                      const WaveFactors& of) {
  using profile::square, std::sqrt;
  T k(waves.in_turn.value_or(0)), dk(0);
  if (!waves.in_turn) {
    const T by_arc = T(2) * pi<T>() / T(waves.length);
    k = by_arc * p.arc;
    dk = by_arc * p.arc_slope;
  }
  const T inertia(of.inertia);
  const T steep = inertia * p.lift.value * square(k);
  const T across = inertia * (T(2) * p.lift.slope * k + p.lift.value * dk);
  const T smooth = inertia * p.lift.bend + T(of.spring) * p.lift.value;
  if (any) return {absolute(smooth) + steep + absolute(across), steep, k};
  return {sqrt(square(smooth - steep) + square(across)), steep, k};
}

/// chi = A k^2 / K (PE5): 1 where the roller, or the face, does not reach into the valleys.
template <class T>
T valley_share(const ProfilePlace<T>& p, const T& k, double amplitude) {
  return p.stiffness ? T(amplitude) * profile::square(k) / *p.stiffness : T(0);
}

/// By how much it grows at worst, away from the cam, with waves of an amplitude (PE6). Where chi
/// reaches 1 it is infinite or NaN.
template <class T>
T worst_away(const ProfilePlace<T>& p, const Waves& waves, bool any, double amplitude,
             const WaveFactors& of) {
  const WaveSize<T> w = wave_size(p, waves, any, of);
  const T chi = valley_share(p, w.number, amplitude);
  const T left = T(1) - chi;
  const T sharper = w.steep * chi / where_positive(left, left);
  return T(amplitude) * (w.either + sharper);
}
/// The same towards the cam.
template <class T>
T worst_towards(const ProfilePlace<T>& p, const Waves& waves, bool any, double amplitude,
                const WaveFactors& of) {
  return T(amplitude) * wave_size(p, waves, any, of).either;
}

/// Of what waves change the share that the theory leaves out, in size: (A k / |p'|)^2 + A |kappa|.
template <class T>
T left_out(const ProfilePlace<T>& p, const Waves& waves, double amplitude) {
  const T slope =
      T(amplitude) * (waves.in_turn ? T(*waves.in_turn) / p.arc : T(2) * pi<T>() / T(waves.length));
  return profile::square(slope) + T(amplitude) * absolute(p.curvature);
}

/// Where over the cycle a formula of the profile's places is highest.
template <class F>
CyclePeak highest(const ProfileGeometry& geometry, double accuracy, F formula) {
  return highest_over_cycle(
      geometry.traces(),
      [&geometry, formula](const auto& jets) { return formula(geometry.place(jets)); }, accuracy);
}

}  // namespace camlaw::problems
