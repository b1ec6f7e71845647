// SPDX-License-Identifier: MIT
#pragma once

#include "machines/cams/bearing_side.h"
#include "machines/cams/crown_responses.h"
#include "machines/index_drives/ruled_contact.h"
#include "machines/index_drives/turret_responses.h"
#include "machines/model/append.h"

/// What index drives have alike whose rollers run between the ribs of a cam with its axis across.
namespace camlaw::problems {

/// Sides of the roller: on that behind it the rib drives, on that before it the next one holds.
inline constexpr double kDrives = -1, kHolds = 1;

/// (IX10) Angle of a driving roller to the line of centres, rad, after what the turret has gained
/// since it took over.
template <class Drive>
Expression rib_angle(const Drive& drive, const Expression& gain) {
  return gain - drive.step() / 2;
}

/// (IX18) Force between the flank that bears and the roller, N, as if it acted at the middle, above
/// 0 where it drives: N = M / (R cos alpha).
template <class Drive>
Expression rib_force(const Drive& drive, const RuledContact& middle, const FollowerMotion& f) {
  return drive.follower().torque(f) / drive.lever() * middle.inclination();
}
template <class Drive>
Expression rib_force(const Drive& drive, const Expression& psi, const FollowerMotion& f) {
  return rib_force(drive, drive.contact(RollerPlace::Middle, psi, f), f);
}

/// What names of responses in a plane across the roller begin with, and where that is.
inline const char* place_prefix(RollerPlace place) {
  return place == RollerPlace::Middle ? "" : place == RollerPlace::Root ? "root_" : "tip_";
}
inline const char* place_words(RollerPlace place) {
  return place == RollerPlace::Middle ? " at the middle of the roller"
         : place == RollerPlace::Root ? " at the roller's end away from the cam's axis"
                                      : " at the roller's end towards the cam's axis";
}

/// The place in few words, for lines that say more than it: seen from the cam's axis.
inline const char* short_place(RollerPlace place) {
  return place == RollerPlace::Middle ? "the roller's middle"
         : place == RollerPlace::Root ? "the roller's far end"
                                      : "the roller's near end";
}

/// Sum of the curvatures of the roller and of the flank that bears.
template <class Drive>
Expression loaded_curvature(const Drive& drive, const RuledContact& contact,
                            const Expression& force) {
  return by_side(force, contact.curvature_sum(drive.roller_radius, kDrives),
                 contact.curvature_sum(drive.roller_radius, kHolds));
}

template <class Drive>
auto rib_material(const Drive& drive) {
  return LineContact{drive.youngs_modulus, drive.poisson_ratio};
}

/// Greatest pressure in a plane across a driving roller at the angle psi, Pa.
template <class Drive>
Expression rib_stress(const Drive& drive, RollerPlace place, const Expression& psi,
                      const FollowerMotion& f) {
  const RuledContact contact = drive.contact(place, psi, f);
  const Expression force = rib_force(drive, psi, f);
  const Expression sum = loaded_curvature(drive, contact, force);
  return unless_zero(force, rib_material(drive).pressure(absolute(force) / drive.face_width, sum));
}

/// (RB15) The driving roller at the angle psi, crowned about its middle or not.
template <class Drive>
auto pressed_rib(const Drive& drive, const Expression& psi, const FollowerMotion& f) {
  const RuledContact middle = drive.contact(RollerPlace::Middle, psi, f);
  const Expression force = rib_force(drive, middle, f);
  return pressed_askew(absolute(force), loaded_curvature(drive, middle, force),
                       middle.slant(drive.roller_radius), drive.duty.crown_curvature(),
                       drive.face_width, rib_material(drive));
}

/// Of the driving roller at each place of the turn: formula(drive, psi, f) with its angle psi.
template <class F>
auto of_driving_roller(F formula) {
  return [formula](const auto& drive, const auto& f) {
    return handed_over(f.s, drive.step(), [&](const Expression& gain) {
      return formula(drive, rib_angle(drive, gain), f);
    });
  };
}

template <class M, class F>
MechanismResponse rib_curve(ResponseAbout about, F formula) {
  return cam_curve<M>(std::move(about), of_driving_roller(formula));
}

/// A coordinate of a line of contact: 0 for x, 1 for y, 2 for z.
struct ContactPlace {
  int coordinate;
  RollerPlace place;
  double side;
};

/// Where the driving roller at psi touches a flank, in the coordinates of the cam turned by phi.
template <class Drive>
Expression contact_coordinate(const Drive& drive, const ContactPlace& which, const Expression& psi,
                              const FollowerMotion& f, const Expression& phi) {
  const auto theta = drive.contact(which.place, psi, f).direction(which.side);
  const SpacePoint at = on_turned_cam(drive.surface_point(which.place, psi, theta), phi);
  return which.coordinate == 0 ? at.x : which.coordinate == 1 ? at.y : at.z;
}

/// The lines of contact of both flanks, each by three of its points.
template <class M>
std::vector<MechanismResponse> contact_lines() {
  std::vector<MechanismResponse> all;
  for (const double side : {kDrives, kHolds}) {
    for (const RollerPlace place : {RollerPlace::Middle, RollerPlace::Root, RollerPlace::Tip}) {
      for (const int coordinate : {0, 1, 2}) {
        const std::string name = std::string(side == kDrives ? "" : "second_") +
                                 place_prefix(place) + "contact_" + "xyz"[coordinate];
        const std::string meaning =
            std::string("where the ") + (side == kDrives ? "driving" : "holding") +
            " flank touches " + short_place(place) +
            ", in axes that turn with the cam; in a dwell, of the next roller";
        const ContactPlace which{coordinate, place, side};
        all.push_back(cam_curve<M>(
            {name, "mm", "m", meaning}, [which](const auto& drive, const auto& f, const auto& x) {
              return handed_over(f.s, drive.step(), [&](const Expression& gain) {
                return contact_coordinate(drive, which, rib_angle(drive, gain), f, 2 * pi() * x);
              });
            }));
      }
    }
  }
  return all;
}

/// In a plane across the roller.
template <class M>
std::vector<MechanismResponse> rib_place_responses(RollerPlace place) {
  const std::string prefix = place_prefix(place), at = place_words(place);
  const auto undercut = [place](double side) {
    return [place, side](const auto& drive, const auto& psi, const auto& f) {
      return drive.contact(place, psi, f).undercut(drive.roller_radius, side);
    };
  };
  std::vector<MechanismResponse> all{
      rib_curve<M>(
          {prefix + "pressure_angle", "deg", "rad",
           "angle between the flank normal and the roller's path" + at + ", with the slope's sign"},
          [place](const auto& drive, const auto& psi, const auto& f) {
            return drive.contact(place, psi, f).pressure_angle();
          }),
      rib_curve<M>({prefix + "undercut", "1", "1",
                    "undercut ratio of the driving flank" + at + "; at 1 it is undercut"},
                   undercut(kDrives)),
      rib_curve<M>({"second_" + prefix + "undercut", "1", "1",
                    "undercut ratio of the holding flank" + at + "; at 1 it is undercut"},
                   undercut(kHolds)),
      rib_curve<M>({prefix + "contact_stress", "MPa", "Pa",
                    "greatest Hertz pressure on the loaded flank" + at},
                   [place](const auto& drive, const auto& psi, const auto& f) {
                     return rib_stress(drive, place, psi, f);
                   })};
  for (const std::string& limit : {prefix + "undercut", "second_" + prefix + "undercut"}) {
    set_defined_while(all, {prefix + "contact_stress"}, {.response = limit, .upper = 1});
  }
  return all;
}

template <class M>
std::vector<MechanismResponse> rib_responses() {
  std::vector<MechanismResponse> all = turret_responses<M>();
  all.push_back(cam_curve<M>(
      {"roller_angle", "deg", "rad",
       "angle of the driving roller beside the line of centres; in a dwell between two rollers, of "
       "the next"},
      [](const auto& drive, const auto& f) {
        return rib_angle(drive, since_handover(f.s, drive.step()));
      }));
  for (const RollerPlace place : {RollerPlace::Middle, RollerPlace::Root, RollerPlace::Tip}) {
    append(all, rib_place_responses<M>(place));
  }
  all.push_back(rib_curve<M>(
      {"curvature_sum", "1/mm", "1/m", "sum of the curvatures of roller and driving flank"},
      [](const auto& drive, const auto& psi, const auto& f) {
        return drive.contact(RollerPlace::Middle, psi, f)
            .curvature_sum(drive.roller_radius, kDrives);
      }));
  all.push_back(rib_curve<M>(
      {"second_curvature_sum", "1/mm", "1/m", "sum of the curvatures of roller and holding flank"},
      [](const auto& drive, const auto& psi, const auto& f) {
        return drive.contact(RollerPlace::Middle, psi, f)
            .curvature_sum(drive.roller_radius, kHolds);
      }));
  all.push_back(rib_curve<M>(
      {"contact_force", "N", "N",
       "force between the loaded flank and its roller, positive where that "
       "is the driving one"},
      [](const auto& drive, const auto& psi, const auto& f) { return rib_force(drive, psi, f); }));
  append(
      all, crown_responses<M>({"undercut", "second_undercut"}, [](const auto& drive, const auto& f,
                                                                  const auto& formula) {
        return of_driving_roller([formula](const auto& its, const auto& psi, const auto& motion) {
          return unless_zero(rib_force(its, psi, motion), formula(pressed_rib(its, psi, motion)));
        })(drive, f);
      }));
  append(all, contact_lines<M>());
  const auto number_of = [&](const char* name, const char* meaning, auto formula) {
    all.push_back(number_response<M>({name, "mm", "m", meaning}, formula));
  };
  number_of("roller_gap", "gap between neighbouring rollers: the rib's thickness",
            [](const auto& drive) { return drive.roller_gap(); });
  number_of("throat_radius", "least radius of the cam, below the rollers' ends",
            [](const auto& drive) { return drive.throat_radius(); });
  number_of("outer_radius",
            "greatest radius that a roller's edge reaches while it drives or holds: no contact "
            "lies beyond",
            [](const auto& drive) { return drive.outer_radius(); });
  number_of("wall", "wall between the cam's bore and the rollers' ends",
            [](const auto& drive) { return drive.throat_radius() - drive.bore_radius; });
  return all;
}

}  // namespace camlaw::problems
