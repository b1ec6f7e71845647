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
struct IndexRoller {
  RollerArm arm;
  Expression angle;  ///< psi, rad
  RollerContact contact;

  RollerContact roller() const { return contact; }
  CamCurve pitch_curve(const FollowerMotion& f) const { return arm.pitch_curve(angle, f); }
  Expression pressure_angle(const FollowerMotion& f) const { return arm.pressure_angle(angle, f); }
  /// 1 / cos alpha, above 0 where the flank drives and below where it holds.
  Expression inclination(const FollowerMotion& f) const { return arm.inclination(angle, f); }
  CamPoint profile(const FollowerMotion& f) const {
    return pitch_curve(f).inside(contact.roller_radius);
  }
  /// (RB1) Its turns on its pin, by those of the cam, under which it passes by 1 + psi'.
  Expression turns(const FollowerMotion& f) const {
    return roller_turns(1, pitch_curve(f).speed(), f.ds + 1, contact.roller_radius);
  }
};

/// One flank of the cams of a parallel index drive: that under the roller which, after it has taken
/// over, turns from the angle `begin` to the line of centres by a step.
struct IndexFlank {
  RollerArm arm;
  Expression begin;   ///< rad
  Expression step;    ///< delta, rad
  Expression gained;  ///< rad, since a roller took over, where the cycle begins
  RollerContact contact;

  /// A roller that took over when the turret had gained so much less.
  IndexRoller after(const Expression& gain) const { return {arm, gain + begin, contact}; }
  /// (IX6) The roller that serves.
  IndexRoller serving(const FollowerMotion& f) const {
    return after(since_handover(f.s + gained, step));
  }
  /// formula(serving roller).
  template <class F>
  Expression of_roller(const FollowerMotion& f, F formula) const {
    return handed_over(f.s + gained, step,
                       [&](const Expression& gain) { return formula(after(gain)); });
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
struct ParallelIndexCam {
  Given given = {};
  Expression stations = given(turrets::kStations);  ///< S, 3 or more
  Expression rollers =
      given({"rollers", "N", "1", "1", "rollers of the turret for each cam", 4, 2, 60, true});
  Expression plates = given({"plates", "P", "1", "1", "disc cams on the shaft", 2, 2, 4, true});
  Expression axis_distance = given(turrets::kAxisDistance.by_default(90));  ///< a, m
  Expression turret_radius = given(
      turrets::kTurretRadius.by_default(60));  ///< R_t, m, of the circle of the rollers' centres
  Expression roller_radius = given(turrets::kRollerRadius.by_default(8));  ///< r_r, m
  Expression angular_speed = given(turrets::kSpeed);        ///< omega, rad/s, of the cam
  Expression inertia = given(turrets::kInertia);            ///< J, kg m^2
  Expression friction = given(turrets::kFriction);          ///< M_C, N m
  Expression load = given(turrets::kLoad);                  ///< M_L, N m
  Expression face_width = given(cams::kFaceWidth);          ///< b, m, of a roller's contact
  Expression youngs_modulus = given(cams::kYoungsModulus);  ///< E, Pa
  Expression poisson_ratio = given(cams::kPoissonRatio);    ///< nu
  Expression cutter_radius = given(cams::kCutterRadius);    ///< r_c, m
  Expression bore_radius = given(cams::kBoreRadius);        ///< r_0, m, of the cams
  Expression shaft_radius = given({"shaft_radius", "r_S", "mm", "m",
                                   "radius of the turret's shaft next to the cams", 10, 0, 1e5});
  Expression train_stiffness =
      given(turrets::kTrainStiffness);                    ///< c_t, N m/rad, from turret to table
  Expression train_damping = given(cams::kTrainDamping);  ///< zeta
  Expression end_share = given(cams::kArmEndShare);       ///< kappa, of the inertia
  /// What each roller bears, and what lubricates it.
  RollerDuty duty = RollerDuty::given_by(given, turrets::kCrownRadius);

  auto conditions() const {
    return std::to_array<Condition>(
        {{axis_distance - turret_radius, "axis_distance must be above turret_radius"}});
  }
  /// (IX4) delta, rad: what the turret turns by while a roller drives.
  Expression step() const { return 2 * pi() / (rollers * plates); }
  /// (IX6) Where the roller that drives rests, rad from the line of centres: (P - 1) delta / 2.
  Expression resting_angle() const { return (plates - 1) * step() / 2; }
  RollerContact roller() const {
    return {roller_radius, cutter_radius, face_width, {youngs_modulus, poisson_ratio}};
  }
  IndexLoad follower() const { return {inertia, friction, load, angular_speed}; }
  /// Rollers that share a turn of the turret.
  Expression all_rollers() const { return rollers * plates; }
  /// The driving flank, and the holding one on the other side of the line of centres.
  IndexFlank main() const { return flank(resting_angle() - lead(), lead()); }
  IndexFlank second() const { return flank(lead() - resting_angle() - step(), step() - lead()); }

  FollowerMotion over_angle(const Motion<Expression>& motion) const {
    return follower_over_angle(station_angle(stations), motion);
  }
  const FollowerMotion& second_motion(const FollowerMotion& f) const { return f; }
  /// Where the driving roller is, and the points of both flanks.
  CamCurve pitch_curve(const FollowerMotion& f) const { return main().serving(f).pitch_curve(f); }
  CamPoint second_profile(const FollowerMotion& f) const { return second().serving(f).profile(f); }
  /// Their distance from the cam's centre, m.
  Expression profile_distance(const FollowerMotion& f) const { return distance(main(), f); }
  Expression second_profile_distance(const FollowerMotion& f) const {
    return distance(second(), f);
  }
  /// (IX7) Force between the flank that bears and its roller, N, above 0 where that one drives:
  /// N = M / (R_t cos alpha).
  Expression contact_force(const FollowerMotion& f) const {
    const auto inclined = [&](const auto& roller) { return roller.inclination(f); };
    const Expression force = follower().torque(f) / turret_radius;
    return force * by_side(force, main().of_roller(f, inclined), -second().of_roller(f, inclined));
  }
  /// Greatest pressure, Pa, on the flank that bears. NaN where that one is undercut.
  Expression contact_stress(const FollowerMotion& f) const {
    return on_loaded(f, [&](const auto& roller, const Expression& force) {
      return roller.contact.stress(force, roller.pitch_curve(f).curvature());
    });
  }
  /// formula(PressedRoller) of the roller on the flank that bears, crowned or not.
  template <class F>
  Expression of_pressed(const FollowerMotion& f, F formula) const {
    return on_loaded(f, [&](const auto& roller, const Expression& force) {
      return formula(pressed(roller, force, f));
    });
  }
  /// formula(RollerFilm) of that roller: without a load the film has no bound.
  template <class F>
  Expression of_film(const FollowerMotion& f, F formula) const {
    return on_bearing(f, [&](const auto& roller, const Expression& force) {
      return formula(roller_film(duty.lubricant(), pressed(roller, force, f),
                                 angular_speed * rolled_way(roller.pitch_curve(f), roller_radius)));
    });
  }
  /// (RB1) Turns on its pin of the roller on that flank, by those of the cams.
  Expression bearing_turns(const FollowerMotion& f) const {
    return on_bearing(f, [&](const auto& roller, const Expression&) { return roller.turns(f); });
  }
  /// |N|^p nu of the roller that serves in a place on the driving flank (side 1) or the holding one
  /// (side -1), 0 where the other one bears.
  Expression damage(int side, int place, const FollowerMotion& f) const {
    const IndexFlank flank = side > 0 ? main() : second();
    const Expression gained = f.s + flank.gained;
    const IndexRoller roller = flank.after(gained - place * flank.step);
    const Expression force = greater_of(side * follower().torque(f) / turret_radius, 0);
    const Expression damage =
        duty.to_life_exponent(force * roller.inclination(f)) * roller.turns(f);
    return while_serving(gained, flank.step, place, damage);
  }
  /// (IX9) R_t (1 + psi') / a, above 1 where a roller on the line of centres runs ahead of the
  /// cam's surface. Well above 1 it cuts into the flank that it is to meet next.
  Expression crossing_ratio(const FollowerMotion& f) const {
    return turret_radius / axis_distance * (f.ds + 1);
  }
  /// (IX8) What is left between two neighbouring rollers of a ring, m: 2 (R_t sin(pi / N) - r_r).
  Expression roller_gap() const {
    return 2 * (turret_radius * sin(pi() / rollers) - roller_radius);
  }

 private:
  /// formula(roller, force on it, N) of the flank that bears, of the driving one without a load.
  template <class F>
  Expression on_bearing(const FollowerMotion& f, F formula) const {
    const Expression force = follower().torque(f) / turret_radius, size = absolute(force);
    const auto of_flank = [&](const IndexFlank& flank, int side) {
      return flank.of_roller(f, [&](const auto& roller) {
        const Expression inclined = side * roller.inclination(f);
        return formula(roller, size * inclined);
      });
    };
    return by_side(force, of_flank(main(), 1), of_flank(second(), -1));
  }
  /// The same, 0 without a load.
  template <class F>
  Expression on_loaded(const FollowerMotion& f, F formula) const {
    return unless_zero(follower().torque(f), on_bearing(f, formula));
  }
  PressedRoller pressed(const IndexRoller& roller, const Expression& force,
                        const FollowerMotion& f) const {
    const RollerContact& contact = roller.contact;
    return pressed_roller(force, contact.curvature_sum(roller.pitch_curve(f).curvature()),
                          duty.crown_curvature(), face_width, contact.material);
  }
  /// epsilon, rad.
  Expression lead() const { return Expression(kTakeover) * step(); }
  static Expression distance(const IndexFlank& flank, const FollowerMotion& f) {
    return flank.of_roller(f, [&](const auto& roller) { return roller.profile(f).distance(); });
  }
  IndexFlank flank(const Expression& begin, const Expression& gained) const {
    return {{turret_radius, axis_distance}, begin, step(), gained, roller()};
  }
};

}  // namespace camlaw
