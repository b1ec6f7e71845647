// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/crown_responses.h"
#include "machines/cams/roller_duty.h"
#include "machines/index_drives/roller_shares.h"
#include "machines/model/mean_number.h"

/// What the rollers of every index drive bear, for a machine with duty and all_rollers(): the
/// life of their bearings, and their speeds.
namespace camlaw::problems {

/// (IX23) From the damage |N|^p nu of the rollers that serve in each place, as integrands, which
/// by_place(machine, means) -> vector puts in order, and from turns(machine, f), those of the
/// roller that bears.
template <class M, class Turns, class ByPlace>
std::vector<MechanismResponse> turret_life(std::vector<Write> damages, Turns turns,
                                           ByPlace by_place) {
  const std::size_t places = damages.size();
  const auto of_follower = [](auto formula) {
    return detail::written_integrand<M>([formula](const auto& drive, const auto& motion) {
      return formula(drive, drive.over_angle(motion));
    });
  };
  damages.push_back(of_follower([](const auto&, const auto& f) { return f.ds; }));
  damages.push_back(of_follower(turns));
  const auto worst = [places, by_place](const auto& drive, const auto& means) {
    const std::vector<Expression> sums = by_place(drive, means.first(places));
    const Expression gained = 2 * pi() * means[places];
    return most_of_a_roller(std::span<const Expression>(sums), gained / drive.step(),
                            drive.all_rollers());
  };
  const std::string most = " of the most heavily loaded roller";
  return {number_of_means<M>(
              {"equivalent_load", "N", "N",
               "constant load under which the bearings of all rollers reach the life" + most},
              damages,
              [places, worst](const auto& drive, const auto& means) {
                return drive.duty.equivalent_load(drive.all_rollers() * worst(drive, means),
                                                  means[places + 1]);
              }),
          number_of_means<M>({"life", "h", "s", "basic rating life L10 of the bearing" + most},
                             damages, [worst](const auto& drive, const auto& means) {
                               return drive.duty.life(worst(drive, means), drive.angular_speed);
                             })};
}

/// Of the roller that bears, from turns(machine, f).
template <class M, class Turns>
std::vector<MechanismResponse> turret_roller_speeds(Turns turns) {
  return {cam_curve<M>({"roller_speed", "rpm", "rad/s",
                        "speed of the roller on its pin, on the flank that carries the load"},
                       [turns](const auto& drive, const auto& f) {
                         return drive.angular_speed * turns(drive, f);
                       }),
          cam_curve<M>({"speed_fraction", "1", "1",
                        "speed of the roller over its permissible speed; above 1 it is too fast"},
                       [turns](const auto& drive, const auto& f) {
                         return drive.angular_speed / drive.duty.speed_limit * turns(drive, f);
                       })};
}

/// From force(machine, f), N.
template <class M, class Force>
MechanismResponse turret_static_fraction(Force force) {
  return cam_curve<M>({"static_fraction", "1", "1",
                       "force on the loaded roller over its static load rating: the inverse of the "
                       "static safety factor"},
                      [force](const auto& drive, const auto& f) {
                        return absolute(force(drive, f)) / drive.duty.static_rating;
                      });
}

}  // namespace camlaw::problems
