// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
#include "machines/cams/roller_arm.h"
#include "machines/cams/roller_duty.h"
#include "machines/contact/crowned_roller.h"
#include "machines/index_drives/index_load.h"
#include "machines/index_drives/index_parameters.h"
#include "machines/index_drives/roller_shares.h"

namespace camlaw {

/// A roller of a parallel index drive at the angle psi to the line of centres, and what it does to
/// the flank below it.
template <class T, class X>
struct IndexRoller {
  RollerArm<T> arm;
  X angle;  ///< psi, rad
  RollerContact<T> contact;

  RollerContact<T> roller() const { return contact; }
  CamCurve<X> pitch_curve(const FollowerMotion<X>& f) const { return arm.pitch_curve(angle, f); }
  X pressure_angle(const FollowerMotion<X>& f) const { return arm.pressure_angle(angle, f); }
  /// 1 / cos alpha, above 0 where the flank drives and below where it holds.
  X inclination(const FollowerMotion<X>& f) const { return arm.inclination(angle, f); }
  CamPoint<X> profile(const FollowerMotion<X>& f) const {
    return pitch_curve(f).inside(contact.roller_radius);
  }
  /// (RB1) Its turns on its pin, by those of the cam, under which it passes by 1 + psi'.
  X turns(const FollowerMotion<X>& f) const {
    return roller_turns(number<X>(1), pitch_curve(f).speed(), X(f.ds + number<T>(1)),
                        contact.roller_radius);
  }
};

/// One flank of the cams of a parallel index drive: that under the roller which, after it has taken
/// over, turns from the angle `begin` to the line of centres by a step.
template <class T>
struct IndexFlank {
  RollerArm<T> arm;
  T begin;   ///< rad
  T step;    ///< delta, rad
  T gained;  ///< rad, since a roller took over, where the cycle begins
  RollerContact<T> contact;

  /// A roller that took over when the turret had gained so much less.
  template <class X>
  IndexRoller<T, X> after(const X& gain) const {
    return {arm, gain + begin, contact};
  }
  /// (IX6) The roller that serves.
  template <class X>
  IndexRoller<T, X> serving(const FollowerMotion<X>& f) const {
    return after(since_handover(X(f.s + gained), step));
  }
  /// formula(serving roller).
  template <class X, class F>
  X of_roller(const FollowerMotion<X>& f, F formula) const {
    return handed_over(X(f.s + gained), step,
                       [&](const X& gain) { return X(formula(after(gain))); });
  }
};

/// The part of a step by which a roller takes over early: enough that the end of a flank, where the
/// roller before it moves, stands out no further than its arc of rest.
inline constexpr double kTakeover = 0.1;

/// A parallel index drive (docs/theory.md, "Parallel index cams"): P disc cams on one shaft turn a
/// turret about a parallel axis, at the distance a, by a station S and cycle. Each cam has its own
/// ring of N rollers on the turret; the rings stand a P-th of a roller's pitch apart. Of all cams
/// one flank drives and one holds at a time, each for a step of delta = 2 pi / (N P), then those of
/// the next cam take over. Cam and turret turn opposite ways. Fields in SI units.
///
/// Valid for a > R_t, for programs that only gain. The drive runs without play and without bracing.
template <class T>
struct ParallelIndexCam {
  Given<T> given = {};
  T stations = given(turrets::kStations);  ///< S, 3 or more
  T rollers =
      given({"rollers", "N", "1", "1", "rollers of the turret for each cam", 4, 2, 60, true});
  T plates = given({"plates", "P", "1", "1", "disc cams on the shaft", 2, 2, 4, true});
  T axis_distance = given(turrets::kAxisDistance.by_default(90));  ///< a, m
  T turret_radius = given(
      turrets::kTurretRadius.by_default(60));  ///< R_t, m, of the circle of the rollers' centres
  T roller_radius = given(turrets::kRollerRadius.by_default(8));  ///< r_r, m
  T angular_speed = given(turrets::kSpeed);                       ///< omega, rad/s, of the cam
  T inertia = given(turrets::kInertia);                           ///< J, kg m^2
  T friction = given(turrets::kFriction);                         ///< M_C, N m
  T load = given(turrets::kLoad);                                 ///< M_L, N m
  T face_width = given(cams::kFaceWidth);                         ///< b, m, of a roller's contact
  T youngs_modulus = given(cams::kYoungsModulus);                 ///< E, Pa
  T poisson_ratio = given(cams::kPoissonRatio);                   ///< nu
  T cutter_radius = given(cams::kCutterRadius);                   ///< r_c, m
  T bore_radius = given(cams::kBoreRadius);                       ///< r_0, m, of the cams
  T shaft_radius = given({"shaft_radius", "r_S", "mm", "m",
                          "radius of the turret's shaft beside the cams", 10, 0, 1e5});
  T train_stiffness = given(turrets::kTrainStiffness);  ///< c_t, N m/rad, from turret to table
  T train_damping = given(cams::kTrainDamping);         ///< zeta
  T end_share = given(cams::kArmEndShare);              ///< kappa, of the inertia
  /// What each roller bears, and what lubricates it.
  RollerDuty<T> duty = RollerDuty<T>::given_by(given, turrets::kCrownRadius);

  auto conditions() const {
    return std::to_array<Condition<T>>(
        {{axis_distance - turret_radius, "axis_distance must be above turret_radius"}});
  }
  /// (IX4) delta, rad: what the turret turns by while a roller drives.
  T step() const { return number<T>(2) * pi<T>() / (rollers * plates); }
  /// (IX6) Where the roller that drives rests, rad from the line of centres: (P - 1) delta / 2.
  T resting_angle() const { return (plates - number<T>(1)) * step() / number<T>(2); }
  RollerContact<T> roller() const {
    return {roller_radius, cutter_radius, face_width, {youngs_modulus, poisson_ratio}};
  }
  IndexLoad<T> follower() const { return {inertia, friction, load, angular_speed}; }
  /// Rollers that share a turn of the turret.
  T all_rollers() const { return rollers * plates; }
  /// The driving flank, and the holding one on the other side of the line of centres.
  IndexFlank<T> main() const { return flank(resting_angle() - lead(), lead()); }
  IndexFlank<T> second() const { return flank(lead() - resting_angle() - step(), step() - lead()); }

  template <class X>
  FollowerMotion<X> over_angle(const Motion<X>& motion) const {
    return follower_over_angle(station_angle(stations), motion);
  }
  template <class X>
  const FollowerMotion<X>& second_motion(const FollowerMotion<X>& f) const {
    return f;
  }
  /// Where the driving roller is, and the points of both flanks.
  template <class X>
  CamCurve<X> pitch_curve(const FollowerMotion<X>& f) const {
    return main().serving(f).pitch_curve(f);
  }
  template <class X>
  CamPoint<X> second_profile(const FollowerMotion<X>& f) const {
    return second().serving(f).profile(f);
  }
  /// Their distance from the cam's centre, m.
  template <class X>
  X profile_distance(const FollowerMotion<X>& f) const {
    return distance(main(), f);
  }
  template <class X>
  X second_profile_distance(const FollowerMotion<X>& f) const {
    return distance(second(), f);
  }
  /// (IX7) Force between the flank that bears and its roller, N, above 0 where that one drives:
  /// N = M / (R_t cos alpha).
  template <class X>
  X contact_force(const FollowerMotion<X>& f) const {
    const auto inclined = [&](const auto& roller) { return roller.inclination(f); };
    const X force = follower().torque(f) / turret_radius;
    return force *
           by_side(force, main().of_roller(f, inclined), X(-second().of_roller(f, inclined)));
  }
  /// Greatest pressure, Pa, on the flank that bears. NaN where that one is undercut.
  template <class X>
  X contact_stress(const FollowerMotion<X>& f) const {
    return on_loaded(f, [&](const auto& roller, const X& force) {
      return roller.contact.stress(force, roller.pitch_curve(f).curvature());
    });
  }
  /// formula(PressedRoller) of the roller on the flank that bears, crowned or not.
  template <class X, class F>
  X of_pressed(const FollowerMotion<X>& f, F formula) const {
    return on_loaded(
        f, [&](const auto& roller, const X& force) { return formula(pressed(roller, force, f)); });
  }
  /// formula(RollerFilm) of that roller: without a load the film has no bound.
  template <class X, class F>
  X of_film(const FollowerMotion<X>& f, F formula) const {
    return on_bearing(f, [&](const auto& roller, const X& force) {
      return formula(
          roller_film(duty.lubricant(), pressed(roller, force, f),
                      X(angular_speed * rolled_way(roller.pitch_curve(f), roller_radius))));
    });
  }
  /// (RB1) Turns on its pin of the roller on that flank, by those of the cams.
  template <class X>
  X bearing_turns(const FollowerMotion<X>& f) const {
    return on_bearing(f, [&](const auto& roller, const X&) { return roller.turns(f); });
  }
  /// |N|^p nu of the roller that serves in a place on the driving flank (side 1) or the holding one
  /// (side -1), 0 where the other one bears.
  template <class X>
  X damage(int side, int place, const FollowerMotion<X>& f) const {
    const IndexFlank<T> flank = side > 0 ? main() : second();
    const X gained = f.s + flank.gained;
    const IndexRoller<T, X> roller = flank.after(X(gained - number<T>(place) * flank.step));
    const X force =
        greater_of(X(number<T>(side) * follower().torque(f) / turret_radius), number<X>(0));
    const X damage = duty.to_life_exponent(X(force * roller.inclination(f))) * roller.turns(f);
    return while_serving(gained, flank.step, place, damage);
  }
  /// (IX9) R_t (1 + psi') / a, above 1 where a roller on the line of centres runs ahead of the
  /// cam's surface. Well above 1 it cuts into the flank that it is to meet next.
  template <class X>
  X crossing_ratio(const FollowerMotion<X>& f) const {
    return turret_radius / axis_distance * (f.ds + number<T>(1));
  }
  /// (IX8) What is left between two neighbouring rollers of a ring, m: 2 (R_t sin(pi / N) - r_r).
  T roller_gap() const {
    using std::sin;
    return number<T>(2) * (turret_radius * sin(pi<T>() / rollers) - roller_radius);
  }

 private:
  /// formula(roller, force on it, N) of the flank that bears, of the driving one without a load.
  template <class X, class F>
  X on_bearing(const FollowerMotion<X>& f, F formula) const {
    const X force = follower().torque(f) / turret_radius, size = absolute(force);
    const auto of_flank = [&](const IndexFlank<T>& flank, int side) {
      return flank.of_roller(f, [&](const auto& roller) {
        const X inclined = number<T>(side) * roller.inclination(f);
        return formula(roller, X(size * inclined));
      });
    };
    return by_side(force, of_flank(main(), 1), of_flank(second(), -1));
  }
  /// The same, 0 without a load.
  template <class X, class F>
  X on_loaded(const FollowerMotion<X>& f, F formula) const {
    return unless_zero(follower().torque(f), on_bearing(f, formula));
  }
  template <class X>
  auto pressed(const IndexRoller<T, X>& roller, const X& force, const FollowerMotion<X>& f) const {
    const RollerContact<T>& contact = roller.contact;
    return pressed_roller(force, X(contact.curvature_sum(roller.pitch_curve(f).curvature())),
                          duty.crown_curvature(), face_width, contact.material);
  }
  /// epsilon, rad.
  T lead() const { return number<T>(kTakeover) * step(); }
  template <class X>
  static X distance(const IndexFlank<T>& flank, const FollowerMotion<X>& f) {
    return flank.of_roller(f, [&](const auto& roller) { return roller.profile(f).distance(); });
  }
  IndexFlank<T> flank(const T& begin, const T& gained) const {
    return {{turret_radius, axis_distance}, begin, step(), gained, roller()};
  }
};

}  // namespace camlaw
