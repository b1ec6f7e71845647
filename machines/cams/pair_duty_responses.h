// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "machines/cams/duty_responses.h"
#include "machines/cams/pair_responses.h"

/// What the two rollers of a pair of cams bear, each on its own cam, for a machine with main(),
/// second(), second_motion(), main_force(), second_force() and duty().
namespace camlaw::problems {

template <class Cam>
Expression force_of_pair(const Cam& cam, OfPair which, const FollowerMotion& f) {
  return which == OfPair::Main ? cam.main_force(f) : cam.second_force(f);
}
/// (RB1) Turns of one of the rollers on its pin, by those of the cams: it rolls on its own cam
/// whether that bears or not.
template <class Cam>
Expression turns_of_pair(const Cam& cam, OfPair which, const FollowerMotion& f) {
  return which == OfPair::Main ? own_flank_turns(cam.main(), f)
                               : own_flank_turns(cam.second(), cam.second_motion(f));
}

template <class M>
void add_pair_duty(std::vector<MechanismResponse>& all, OfPair which, const std::string& name) {
  const std::string prefix = which == OfPair::Main ? "" : "second_";
  const std::string roller = "the " + name + "'s roller", bearing = "the bearing of " + roller;
  all.push_back(
      cam_curve<M>({prefix + "roller_speed", "rpm", "rad/s", "speed of " + roller + " on its pin"},
                   [which](const auto& cam, const auto& f) {
                     return cam.angular_speed * turns_of_pair(cam, which, f);
                   }));
  all.push_back(cam_curve<M>(
      {prefix + "speed_fraction", "1", "1",
       "speed of " + roller + " over its permissible speed; above 1 it is too fast"},
      [which](const auto& cam, const auto& f) {
        return cam.angular_speed / cam.duty().speed_limit * turns_of_pair(cam, which, f);
      }));
  const auto damage = [which](const auto& cam, const auto& motion) {
    const auto f = cam.over_angle(motion);
    return cam.duty().to_life_exponent(force_of_pair(cam, which, f)) * turns_of_pair(cam, which, f);
  };
  const auto turns = [which](const auto& cam, const auto& motion) {
    return turns_of_pair(cam, which, cam.over_angle(motion));
  };
  all.push_back(mean_number<M>({prefix + "equivalent_load", "N", "N",
                                "constant load under which " + bearing +
                                    " reaches as many revolutions; 0 if that cam carries none"},
                               damage, turns,
                               [](const auto& cam, const auto& mean, const auto& turned) {
                                 return cam.duty().equivalent_load(mean, turned);
                               }));
  all.push_back(
      mean_number<M>({prefix + "life_revolutions", "1", "1",
                      "basic rating life L10 of " + bearing + ", in millions of revolutions"},
                     damage, turns, [](const auto& cam, const auto& mean, const auto& turned) {
                       return cam.duty().revolutions(cam.duty().equivalent_load(mean, turned)) /
                              cam.duty().kMillion;
                     }));
  all.push_back(mean_number<M>(
      {prefix + "life", "h", "s", "basic rating life L10 of " + bearing}, damage,
      [](const auto& cam, const auto& mean) { return cam.duty().life(mean, cam.angular_speed); }));
}

/// The two cams by the names given.
template <class M>
std::vector<MechanismResponse> pair_duty_responses(const std::string& main,
                                                   const std::string& second) {
  std::vector<MechanismResponse> all;
  add_pair_duty<M>(all, OfPair::Main, main);
  add_pair_duty<M>(all, OfPair::Second, second);
  all.push_back(cam_curve<M>(
      {"static_fraction", "1", "1",
       "force on the loaded roller over its static load rating: the inverse of the static safety "
       "factor"},
      [](const auto& cam, const auto& f) {
        return absolute(cam.contact_force(f)) / cam.duty().static_rating;
      }));
  return all;
}

}  // namespace camlaw::problems
