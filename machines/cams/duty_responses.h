// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_curve.h"
#include "machines/cams/cam_motion.h"
#include "machines/cams/crown_responses.h"
#include "machines/cams/roller_duty.h"
#include "machines/model/append.h"
#include "machines/model/mean_number.h"

/// What a roller bears, for a machine with pitch_curve(), contact_force(), roller(), turning() and
/// duty: the life of its bearing, the shear below the surface, the film that carries it.
namespace camlaw::problems {

/// (RB1) Turns of the roller on its pin, by those of the cam: on the flank that bears, or on the
/// cam's own.
template <class Cam>
Expression roller_turns_of(const Cam& cam, const FollowerMotion& f) {
  return roller_turns(cam.contact_force(f), cam.pitch_curve(f).speed(), cam.turning(f),
                      cam.roller_radius);
}

template <class Cam>
Expression own_flank_turns(const Cam& cam, const FollowerMotion& f) {
  return roller_turns(1, cam.pitch_curve(f).speed(), cam.turning(f), cam.roller_radius);
}

/// The roller on the cam's own flank.
template <class Cam>
auto own_flank_roller(const Cam& cam, const FollowerMotion& f) {
  const auto roller = cam.roller();
  return pressed_roller(cam.contact_force(f), roller.curvature_sum(cam.pitch_curve(f).curvature()),
                        cam.duty.crown_curvature(), roller.face_width, roller.material);
}

/// Numbers that the whole cycle makes.
template <class M>
std::vector<MechanismResponse> life_responses() {
  const auto damage = [](const auto& cam, const auto& motion) {
    const auto f = cam.over_angle(motion);
    return cam.duty.to_life_exponent(cam.contact_force(f)) * roller_turns_of(cam, f);
  };
  const auto turns = [](const auto& cam, const auto& motion) {
    return roller_turns_of(cam, cam.over_angle(motion));
  };
  return {
      mean_number<M>({"equivalent_load", "N", "N",
                      "equivalent load: constant load under which the roller's bearing reaches the "
                      "same number of revolutions"},
                     damage, turns,
                     [](const auto& cam, const auto& mean, const auto& turned) {
                       return cam.duty.equivalent_load(mean, turned);
                     }),
      mean_number<M>({"life_revolutions", "1", "1",
                      "basic rating life L10 of the roller's bearing, in millions of revolutions"},
                     damage, turns,
                     [](const auto& cam, const auto& mean, const auto& turned) {
                       return cam.duty.revolutions(cam.duty.equivalent_load(mean, turned)) /
                              cam.duty.kMillion;
                     }),
      mean_number<M>({"life", "h", "s", "basic rating life L10 of the roller's bearing"}, damage,
                     [](const auto& cam, const auto& mean) {
                       return cam.duty.life(mean, cam.angular_speed);
                     })};
}

template <class M>
std::vector<MechanismResponse> duty_responses() {
  std::vector<MechanismResponse> all =
      crown_responses<M>({"undercut"}, [](const auto& cam, const auto& f, const auto& formula) {
        return formula(own_flank_roller(cam, f));
      });
  all.push_back(cam_curve<M>(
      {"roller_speed", "rpm", "rad/s", "speed of the roller on its pin, on the cam's own flank"},
      [](const auto& cam, const auto& f) { return cam.angular_speed * own_flank_turns(cam, f); }));
  all.push_back(cam_curve<M>({"speed_fraction", "1", "1",
                              "speed of the roller over its permissible speed; above 1 it is too "
                              "fast"},
                             [](const auto& cam, const auto& f) {
                               return cam.angular_speed / cam.duty.speed_limit *
                                      own_flank_turns(cam, f);
                             }));
  all.push_back(cam_curve<M>(
      {"static_fraction", "1", "1",
       "force on the roller over its static load rating: the inverse of the static safety factor"},
      [](const auto& cam, const auto& f) {
        return absolute(cam.contact_force(f)) / cam.duty.static_rating;
      }));
  append(all, film_responses<M>(
                  {"undercut"}, "cam", [](const auto& cam, const auto& f, const auto& formula) {
                    return formula(roller_film(
                        cam.duty.lubricant(), own_flank_roller(cam, f),
                        cam.angular_speed * rolled_way(cam.pitch_curve(f), cam.roller_radius)));
                  }));
  for (const char* of_contact :
       {"max_shear", "shear_depth", "crown_stress", "crown_shear", "crown_shear_depth",
        "crown_half_length", "crown_fraction", "crown_elongation", "film_thickness", "lambda_ratio",
        "crown_film", "crown_lambda"}) {
    set_defined_while(all, {of_contact}, {.response = "contact_force", .lower = 0});
  }
  append(all, life_responses<M>());
  return all;
}

}  // namespace camlaw::problems
