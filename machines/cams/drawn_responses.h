// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/cam_motion.h"
#include "machines/cams/cam_tables.h"
#include "machines/model/listed_responses.h"
#include "machines/model/mean_number.h"

/// What is drawn of a cam, and cut: its curves in its own coordinates, mass and inertia.
namespace camlaw::problems {

enum class DrawnCurve { ProfileX, ProfileY, PitchX, PitchY, CutterX, CutterY, SecondX, SecondY };

/// The profile under a roller is its pitch curve less the roller; other cams say themselves.
template <class Cam, class X>
CamPoint<X> profile_of(const Cam& cam, const FollowerMotion<X>& f) {
  if constexpr (requires { cam.profile(f); }) {
    return cam.profile(f);
  } else {
    return cam.pitch_curve(f).inside(cam.roller().roller_radius);
  }
}

template <class Cam, class X>
CamPoint<X> cutter_of(const Cam& cam, const FollowerMotion<X>& f) {
  if constexpr (requires { cam.cutter(f); }) {
    return cam.cutter(f);
  } else {
    const auto roller = cam.roller();
    return cam.pitch_curve(f).inside(roller.roller_radius - roller.cutter_radius);
  }
}

/// Where a point of the frame lies on the cam at phi: a disc has turned.
template <class Cam, class X>
std::pair<X, X> on_cam(const Cam& cam, const CamPoint<X>& p, const X& phi) {
  if constexpr (requires { cam.placed(p, phi); }) {
    return cam.placed(p, phi);
  } else {
    return turned_back(p, phi);
  }
}

template <class Cam, class X>
CamPoint<X> drawn_point(const Cam& cam, DrawnCurve which, const FollowerMotion<X>& f) {
  using D = DrawnCurve;
  if constexpr (requires { cam.second_profile(f); }) {
    if (which == D::SecondX || which == D::SecondY) return cam.second_profile(f);
  }
  if constexpr (requires { cam.pitch_curve(f); }) {
    if (which == D::CutterX || which == D::CutterY) return cutter_of(cam, f);
    if (which == D::PitchX || which == D::PitchY) {
      const auto w = cam.pitch_curve(f);
      return {w.x, w.y, w.x1, w.y1};
    }
  }
  return profile_of(cam, f);
}

template <template <class> class M>
MechanismResponse drawn_response(DrawnCurve which, const char* name, const char* meaning) {
  return listed_curve<M>({name, "mm", "m", meaning}, turn_of_the_cam(), which,
                         [](const auto& cam, DrawnCurve curve, const auto& motion, const auto& x) {
                           using X = std::decay_t<decltype(x)>;
                           const X phi = number<X>(2) * pi<X>() * x;
                           const auto place =
                               on_cam(cam, drawn_point(cam, curve, cam.over_angle(motion)), phi);
                           using D = DrawnCurve;
                           const bool across = curve == D::ProfileY || curve == D::PitchY ||
                                               curve == D::CutterY || curve == D::SecondY;
                           return across ? place.second : place.first;
                         });
}

/// Profile, and of a roller or an edge the pitch curve and the path of the tool.
template <template <class> class M>
std::vector<MechanismResponse> drawn_responses(bool with_pitch_curve) {
  using D = DrawnCurve;
  std::vector<MechanismResponse> all{
      drawn_response<M>(D::ProfileX, "profile_x", "profile, in the cam's own coordinates"),
      drawn_response<M>(D::ProfileY, "profile_y", "profile, in the cam's own coordinates")};
  if (!with_pitch_curve) return all;
  all.push_back(
      drawn_response<M>(D::PitchX, "pitch_x", "pitch curve: path of the follower's trace point"));
  all.push_back(
      drawn_response<M>(D::PitchY, "pitch_y", "pitch curve: path of the follower's trace point"));
  all.push_back(drawn_response<M>(D::CutterX, "cutter_x", "cutter-centre path"));
  all.push_back(drawn_response<M>(D::CutterY, "cutter_y", "cutter-centre path"));
  return all;
}

/// Mass and inertia of a disc cam with blank().
template <template <class> class M>
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
          using T = std::decay_t<decltype(mean)>;
          const T swept = number<T>(2) * pi<T>() * mean;
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
