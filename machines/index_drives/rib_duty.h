// SPDX-License-Identifier: MIT
#pragma once

#include "machines/index_drives/rib_responses.h"
#include "machines/index_drives/turret_duty.h"

/// What the rollers between the ribs of a cam bear: life, speed, film, sliding.
namespace camlaw::problems {

/// formula(contact, side of the flank that bears) of the driving roller at psi. The
/// flank that drives counts where no force acts.
template <class Drive, class F>
Expression on_bearing_flank(const Drive& drive, RollerPlace place, const Expression& psi,
                            const FollowerMotion& f, F formula) {
  const RuledContact contact = drive.contact(place, psi, f);
  const Expression force = drive.follower().torque(f);
  return by_side(force, formula(contact, kDrives), formula(contact, kHolds));
}

template <class Drive>
Expression rib_turns(const Drive& drive, const Expression& psi, const FollowerMotion& f) {
  return on_bearing_flank(
      drive, RollerPlace::Middle, psi, f,
      [&](const auto& contact, double side) { return contact.turns(drive.roller_radius, side); });
}

/// (IX22) Speed at which a plane across the roller slides on the flank that bears, m/s: along the
/// axis, and round it by the difference from the middle, where it rolls.
template <class Drive>
Expression rib_sliding(const Drive& drive, RollerPlace place, const Expression& psi,
                       const FollowerMotion& f) {
  const Expression middle = drive.contact(RollerPlace::Middle, psi, f).length();
  return drive.angular_speed *
         on_bearing_flank(drive, place, psi, f, [&](const auto& contact, double side) {
           const Expression axial = contact.axial_slip(drive.roller_radius, side);
           if (place == RollerPlace::Middle) return absolute(axial);
           const Expression round = contact.length() - middle;
           return sqrt(axial * axial + round * round);
         });
}

/// A driving roller at psi with the oil between it and the flank.
template <class Drive>
auto rib_film(const Drive& drive, const Expression& psi, const FollowerMotion& f) {
  const auto& radius = drive.roller_radius;
  const Expression way = on_bearing_flank(
      drive, RollerPlace::Middle, psi, f,
      [&](const auto& contact, double side) { return contact.rolled_way(radius, side); });
  return roller_film(drive.duty.lubricant(), pressed_rib(drive, psi, f), drive.angular_speed * way);
}

/// |N|^p nu of the roller that serves in a place.
template <class M>
Write rib_damage(int place) {
  return detail::written_integrand<M>([place](const auto& drive, const auto& motion) {
    const auto f = drive.over_angle(motion);
    const auto step = drive.step();
    const Expression psi = rib_angle(drive, f.s - step * place);
    const Expression damage =
        drive.duty.to_life_exponent(rib_force(drive, psi, f)) * rib_turns(drive, psi, f);
    return while_serving(f.s, step, place, damage);
  });
}

template <class M>
std::vector<MechanismResponse> rib_duty_responses() {
  const auto turns = of_driving_roller(
      [](const auto& drive, const auto& psi, const auto& f) { return rib_turns(drive, psi, f); });
  std::vector<MechanismResponse> all = turret_roller_speeds<M>(turns);
  for (const RollerPlace place : {RollerPlace::Middle, RollerPlace::Root, RollerPlace::Tip}) {
    all.push_back(rib_curve<M>({std::string(place_prefix(place)) + "sliding_speed", "m/s", "m/s",
                                std::string("sliding speed of the roller on the loaded flank") +
                                    place_words(place) + ", if it rolls at its middle"},
                               [place](const auto& drive, const auto& psi, const auto& f) {
                                 return rib_sliding(drive, place, psi, f);
                               }));
  }
  all.push_back(turret_static_fraction<M>(of_driving_roller(
      [](const auto& drive, const auto& psi, const auto& f) { return rib_force(drive, psi, f); })));
  append(all,
         film_responses<M>({"undercut", "second_undercut"}, "loaded flank",
                           [](const auto& drive, const auto& f, const auto& formula) {
                             return of_driving_roller(
                                 [formula](const auto& its, const auto& psi, const auto& motion) {
                                   return formula(rib_film(its, psi, motion));
                                 })(drive, f);
                           }));
  std::vector<Write> damages;
  for (int place = 0; place < kServed; ++place) damages.push_back(rib_damage<M>(place));
  append(all, turret_life<M>(damages, turns, [](const auto&, const auto& means) {
           return std::vector(means.begin(), means.end());
         }));
  return all;
}

template <class M>
std::vector<MechanismResponse> rib_drive_responses() {
  std::vector<MechanismResponse> all = rib_responses<M>();
  append(all, rib_duty_responses<M>());
  return all;
}

}  // namespace camlaw::problems
