// SPDX-License-Identifier: MIT

#include "machines/balancing_cam/balancing_cam.h"
#include "machines/cams/buildable_checks.h"
#include "machines/geneva/drive_tables.h"
#include "machines/model/append.h"
#include "machines/model/peak_number.h"
#include "machines/model/turn_responses.h"
#include "machines/model/usual_problem.h"
#include "machines/model/why_impossible.h"

namespace camlaw::problems {
namespace {

using optim::Part;

/// A curve from formula(turn, section, angle).
template <class M, class F>
MechanismResponse curve(ResponseAbout about, F formula) {
  return turn_response<M>(std::move(about), [formula](const auto& machine) {
    return [formula, turn = BalancedTurn(machine)](std::size_t section, const auto& phi) {
      return formula(turn, section, phi);
    };
  });
}

/// One of the cam, from formula(cam, pitch, turn, section, angle).
template <class M, class F>
MechanismResponse roller_curve(ResponseAbout about, F formula) {
  return curve<M>(std::move(about),
                  [formula](const auto& turn, std::size_t section, const auto& phi) {
                    const auto cam = turn.machine().cam();
                    const auto pitch = cam.pitch_curve(turn.roller(section, phi));
                    return formula(cam, pitch, turn, section, phi);
                  });
}

constexpr auto residual_torque = [](const auto& turn, std::size_t section, const auto& phi) {
  return turn.residual_torque(section, phi);
};
constexpr auto touching_torque = [](const auto& turn, std::size_t section, const auto& phi) {
  return turn.touching_torque(section, phi);
};

/// A torque over the greatest before balancing.
template <class M, class F>
MechanismResponse share(const char* name, const char* meaning, F torque) {
  return curve<M>({name, "1", "1", meaning},
                  [torque](const auto& turn, std::size_t section, const auto& phi) {
                    return torque(turn, section, phi) / turn.peak_torque();
                  });
}
template <class M>
MechanismResponse residual_fraction() {
  return share<M>("residual_fraction",
                  "residual torque over the greatest torque before balancing; its peak is 1 / K",
                  residual_torque);
}
template <class M>
MechanismResponse touching_fraction() {
  return share<M>("touching_fraction", "the same, if the rollers were always on the cam",
                  touching_torque);
}

template <class M>
std::vector<MechanismResponse> turn_curves() {
  using At = std::size_t;
  return {
      curve<M>({"stored_energy", "J", "J", "energy stored in the springs in excess of its minimum"},
               [](const auto& turn, At section, const auto& phi) {
                 return turn.surplus().range * turn.stored(section, phi).s;
               }),
      curve<M>({"balancing_displacement", "1", "1",
                "displacement of the end of the stack over its stroke (equation 7 of the source)"},
               [](const auto& turn, At section, const auto& phi) {
                 return turn.displacement(section, phi).s;
               }),
      curve<M>({"roller_displacement", "mm", "m", "displacement of each roller"},
               [](const auto& turn, At section, const auto& phi) {
                 return turn.roller(section, phi).s;
               }),
      curve<M>(
          {"spring_force", "N", "N", "force of the stack, from the springs' own characteristic"},
          [](const auto& turn, At section, const auto& phi) {
            return turn.spring_force(turn.displacement(section, phi));
          }),
      curve<M>({"roller_force", "N", "N",
                "force along a roller's path, if it were always on the cam; below 0 the roller "
                "leaves the cam"},
               [](const auto& turn, At section, const auto& phi) {
                 return turn.roller_force(turn.displacement(section, phi));
               }),
      curve<M>({"balancing_torque", "N m", "N m",
                "torque that the rollers take from the driver, if they were always on the cam"},
               [](const auto& turn, At section, const auto& phi) {
                 return turn.balancing_torque(turn.displacement(section, phi));
               }),
      curve<M>({"residual_torque", "N m", "N m", "torque on the balanced driver"}, residual_torque),
      curve<M>({"touching_torque", "N m", "N m", "the same, if the rollers were always on the cam"},
               touching_torque),
      residual_fraction<M>(),
      touching_fraction<M>(),
      curve<M>({"pressure_angle", "deg", "rad",
                "angle between the normal of the profile and the path of the roller"},
               [](const auto& turn, At section, const auto& phi) {
                 return turn.machine().cam().pressure_angle(turn.roller(section, phi));
               }),
      roller_curve<M>(
          {"pitch_curvature", "1/mm", "1/m", "curvature of the pitch curve, positive where convex"},
          [](const auto&, const auto& pitch, const auto&, At, const auto&) {
            return pitch.curvature();
          }),
      roller_curve<M>(
          {"undercut", "1", "1",
           "roller radius over the pitch curve's radius of curvature; at 1 the profile is "
           "undercut"},
          [](const auto& cam, const auto& pitch, const auto&, At, const auto&) {
            return cam.roller().undercut(pitch.curvature());
          }),
      roller_curve<M>(
          {"contact_stress", "MPa", "Pa",
           "greatest Hertz pressure, if the roller were always on the cam"},
          [](const auto& cam, const auto& pitch, const auto& turn, At section, const auto& phi) {
            const auto force = turn.roller_force(turn.displacement(section, phi));
            return cam.roller().stress(force * pitch.speed() / pitch.y, pitch.curvature());
          }),
      roller_curve<M>(
          {"profile_x", "mm", "m", "the profile in the cam, along its zero line", {}, true},
          [](const auto& cam, const auto& pitch, const auto&, At, const auto& phi) {
            return turned_back(pitch.inside(cam.roller_radius), phi).first;
          }),
      roller_curve<M>(
          {"profile_y", "mm", "m", "the profile in the cam, across its zero line", {}, true},
          [](const auto& cam, const auto& pitch, const auto&, At, const auto& phi) {
            return turned_back(pitch.inside(cam.roller_radius), phi).second;
          })};
}

/// A number from formula(machine, surplus), for the surplus work that its cam is cut for.
template <class M, class F>
MechanismResponse balancing_number(ResponseAbout about, F formula) {
  return number_response<M>(std::move(about), [formula](const auto& machine) {
    return formula(machine, surplus_of(machine.designed()));
  });
}

template <class M>
std::vector<MechanismResponse> balancing_numbers() {
  return {
      balancing_number<M>({"mean_torque", "N m", "N m", "mean torque on the driver over its turn"},
                          [](const auto& machine, const auto&) { return machine.mean_torque(); }),
      balancing_number<M>(
          {"surplus_range", "J", "J",
           "work that the springs store and return, at the speed the cam is cut for"},
          [](const auto&, const auto& surplus) { return surplus.range; }),
      balancing_number<M>(
          {"ideal_balance", "1", "1",
           "greatest torque over mean torque at the speed the cam is cut for: K of an ideal "
           "balance"},
          [](const auto& machine, const auto& surplus) {
            return surplus.peak_torque / machine.mean_torque();
          }),
      balancing_number<M>(
          {"spring_stroke", "mm", "m", "working stroke of the stack"},
          [](const auto& machine, const auto& surplus) { return machine.stroke(surplus.range); }),
      balancing_number<M>({"spring_deflection", "mm", "m", "greatest deflection of each spring"},
                          [](const auto& machine, const auto& surplus) {
                            return machine.deflection(surplus.range);
                          }),
      balancing_number<M>(
          {"flattening", "1", "1",
           "greatest deflection of a spring over its deflection to flat; catalogues allow 0.75"},
          [](const auto& machine, const auto& surplus) {
            return machine.deflection(surplus.range) / machine.cone_height;
          }),
      balancing_number<M>(
          {"springs_needed", "1", "1",
           "packets in series for a greatest deflection of 0.75 h_0 (equation 10 of the "
           "source), not rounded"},
          [](const auto& machine, const auto& surplus) {
            return machine.springs_needed(surplus.range);
          }),
      balancing_number<M>({"spring_stress", "MPa", "Pa",
                           "greatest compressive stress, at the inner upper edge of a spring"},
                          [](const auto& machine, const auto& surplus) {
                            return -machine.spring().stress_upper_inner(
                                machine.deflection(surplus.range));
                          }),
      balancing_number<M>({"spring_tension", "MPa", "Pa",
                           "greatest tensile stress at the outer lower edge of a spring"},
                          [](const auto& machine, const auto& surplus) {
                            return machine.spring().stress_lower_outer(
                                machine.deflection(surplus.range));
                          })};
}

/// K = greatest torque before balancing over the greatest after.
template <class M>
MechanismResponse balance(const char* name, const char* meaning, const MechanismResponse& share) {
  return peak_number<M>({name, "1", "1", meaning}, share, Part::Magnitude,
                        [](const auto&, const auto& peak) { return Expression(1.0) / peak; });
}

template <class M>
Mechanism balancing_cam(const char* name, const char* title, UsualProblem usual) {
  std::vector<MechanismResponse> responses = balancing_numbers<M>();
  responses.push_back(
      balance<M>("balancing_coefficient",
                 "greatest torque before balancing over the greatest torque after it, K",
                 residual_fraction<M>()));
  responses.push_back(balance<M>("touching_coefficient", "K, if the rollers were always on the cam",
                                 touching_fraction<M>()));
  append(responses, drive_curves<M>());
  append(responses, turn_curves<M>());
  return checked(
      {.name = name,
       .title = title,
       .source =
           "K. V. Tir, A. S. Glavatskii, A. I. Petruk, The balancing of the surplus forces of "
           "the main conveyors' drive of the book-processing units, Polihrafiia i vydavnycha "
           "sprava, UDC 621.835",
       .parameters = parameters_of<M>(),
       .responses = std::move(responses),
       .peaks = {{"peak_residual_torque", "residual_torque", Part::Magnitude,
                  "greatest torque after balancing"},
                 {"peak_drive_torque", "drive_torque", Part::Magnitude,
                  "greatest torque before balancing"},
                 {"least_roller_force", "roller_force", Part::Lowest,
                  "least force on a roller; above 0 it stays on the cam"},
                 {"peak_pressure_angle", "pressure_angle", Part::Magnitude,
                  "greatest pressure angle"},
                 {"peak_stress", "contact_stress", Part::Highest, "greatest contact stress"}},
       .moved_by = MovedBy::Nothing,
       .validity = {{"flattening", 1}},
       .form = Form::BalancingCam,
       .why_impossible = why_impossible_as<M>,
       .usual = usual_problem(std::move(usual))},
      {undercut_checks(), stress_checks()});
}

}  // namespace

Mechanism planar_balancing_cam_mechanism() {
  return balancing_cam<PlanarBalancingCam>(
      "balancing-cam", "spring-loaded cam that balances a conveyor with a planar Geneva",
      {.objective = "spring_tension",
       .variables = {{"preload_ratio", 0.6, 2, 1}, {"cone_height", 0.65, 1, 0.75}},
       .limits = {{"flattening", kNone, 0.75}, {"balancing_coefficient", 9.1, kNone}},
       .others = {"peak_residual_torque", "peak_stress", "peak_pressure_angle",
                  "least_roller_force", "spring_stress", "undercut"},
       .constants = {{"springs", 48}}});
}

Mechanism spherical_balancing_cam_mechanism() {
  return balancing_cam<SphericalBalancingCam>(
      "balancing-cam-spherical",
      "spring-loaded cam that balances a conveyor with a spherical Geneva",
      {.objective = "spring_tension",
       .variables = {{"preload_ratio", 0.6, 2, 1}, {"cone_height", 0.65, 1, 0.75}},
       .limits = {{"flattening", kNone, 0.75}, {"balancing_coefficient", 3.7, kNone}},
       .others = {"peak_residual_torque", "peak_stress", "peak_pressure_angle",
                  "least_roller_force", "spring_stress", "undercut"},
       .constants = {{"springs", 48}}});
}

}  // namespace camlaw::problems
