// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_curve.h"
#include "machines/cams/cam_motion.h"
#include "machines/cams/cam_tables.h"
#include "machines/model/append.h"
#include "machines/model/mean_number.h"

/// What is drawn of a cam, and cut: its curves in its own coordinates, mass and inertia.
namespace camlaw::problems {

/// The profile under a roller is its pitch curve less the roller; other cams say themselves.
template <class Cam>
CamPoint profile_of(const Cam& cam, const FollowerMotion& f) {
  if constexpr (requires { cam.profile(f); }) {
    return cam.profile(f);
  } else {
    return cam.pitch_curve(f).inside(cam.roller().roller_radius);
  }
}

template <class Cam>
CamPoint cutter_of(const Cam& cam, const FollowerMotion& f) {
  if constexpr (requires { cam.cutter(f); }) {
    return cam.cutter(f);
  } else {
    const auto roller = cam.roller();
    return cam.pitch_curve(f).inside(roller.roller_radius - roller.cutter_radius);
  }
}

/// Where a point of the frame lies on the cam at phi: a disc has turned.
template <class Cam>
std::pair<Expression, Expression> on_cam(const Cam& cam, const CamPoint& p, const Expression& phi) {
  if constexpr (requires { cam.placed(p, phi); }) {
    return cam.placed(p, phi);
  } else {
    return turned_back(p, phi);
  }
}

/// The follower's trace point on the pitch curve.
template <class Cam>
CamPoint trace_point(const Cam& cam, const FollowerMotion& f) {
  const auto w = cam.pitch_curve(f);
  return {w.x, w.y, w.x1, w.y1};
}

/// NAME_x and NAME_y of point(cam, f) as it lies on the cam.
template <class M, class Point>
std::vector<MechanismResponse> drawn_curve(const std::string& name, const char* meaning,
                                           Point point) {
  const auto on_drawing = [point](const auto& cam, const auto& f, const auto& x) {
    return on_cam(cam, point(cam, f), 2 * pi() * x);
  };
  return {cam_curve<M>({name + "_x", "mm", "m", meaning, {}, true},
                       [on_drawing](const auto& cam, const auto& f, const auto& x) {
                         return on_drawing(cam, f, x).first;
                       }),
          cam_curve<M>({name + "_y", "mm", "m", meaning, {}, true},
                       [on_drawing](const auto& cam, const auto& f, const auto& x) {
                         return on_drawing(cam, f, x).second;
                       })};
}

/// Profile, and of a roller or an edge the pitch curve and the path of the tool.
template <class M>
std::vector<MechanismResponse> drawn_responses(bool with_pitch_curve) {
  std::vector<MechanismResponse> all =
      drawn_curve<M>("profile", "profile, in the cam's own coordinates",
                     [](const auto& cam, const auto& f) { return profile_of(cam, f); });
  if constexpr (requires(const M& cam, const FollowerMotion& f) { cam.pitch_curve(f); }) {
    if (!with_pitch_curve) return all;
    append(all, drawn_curve<M>("pitch", "pitch curve: path of the follower's trace point",
                               [](const auto& cam, const auto& f) { return trace_point(cam, f); }));
    append(all, drawn_curve<M>("cutter", "cutter-centre path",
                               [](const auto& cam, const auto& f) { return cutter_of(cam, f); }));
  }
  return all;
}

/// Mass and inertia of a disc cam with blank().
template <class M>
std::vector<MechanismResponse> blank_responses() {
  enum class Quantity { Mass, Inertia };
  const auto made = [](Quantity which, ResponseAbout about) {
    return mean_number<M>(
        std::move(about),
        [which](const auto& cam, const auto& motion) {
          const auto p = profile_of(cam, cam.over_angle(motion));
          return which == Quantity::Mass ? p.area_rate() : p.moment_rate();
        },
        [which](const auto& cam, const auto& mean) {
          const Expression swept = 2 * pi() * mean;
          return which == Quantity::Mass ? cam.blank().mass(swept) : cam.blank().inertia(swept);
        });
  };
  return {made(Quantity::Mass, {"cam_mass", "kg", "kg",
                                "mass of the cam less its bore, for a profile without undercut"}),
          made(Quantity::Inertia,
               {"cam_inertia", "kg cm2", "kg m2",
                "moment of inertia of the cam about its shaft, for a profile without undercut"})};
}

}  // namespace camlaw::problems
