// SPDX-License-Identifier: MIT
#include "machines/balancing_cam/mechanism.h"

#include "machines/balancing_cam/balancing_cam.h"
#include "machines/cams/buildable_checks.h"
#include "machines/geneva/drive_tables.h"
#include "machines/model/append.h"
#include "machines/model/peak_number.h"
#include "machines/model/turn_responses.h"

namespace camlaw::problems {
namespace {

const std::vector<MechanismParameter>& balancing_parameters() {
  static const std::vector<MechanismParameter> all = [] {
    auto result = drive_parameters();
    const std::vector<MechanismParameter> own{
        {"design_speed", "n_c", "rpm", "rad/s", "speed that the cam is cut for", 60, 1e-3, 1e6},
        {"preload_ratio", "psi", "1", "1", "preload over working stroke of the stack", 1, 0.02,
         100},
        {"springs", "i", "1", "1", "packets of disc springs in a row", 44, 1, 10000, true},
        {"nested", "n_s", "1", "1", "springs in a packet, nested", 1, 1, 10, true},
        {"outer_diameter", "D_e", "mm", "m", "outer diameter of a spring", 31.5, 1, 1000},
        {"inner_diameter", "D_i", "mm", "m", "inner diameter of a spring", 16.3, 0.5, 1000},
        {"thickness", "t", "mm", "m", "thickness of a spring", 1.75, 0.05, 100},
        {"cone_height", "h_0", "mm", "m", "free height of a spring's cone, its deflection to flat",
         0.7, 0.01, 100},
        {"youngs_modulus", "E", "GPa", "Pa", "Young's modulus of springs, cam and roller", 206,
         1e-3, 1e4},
        {"poisson_ratio", "mu", "1", "1", "Poisson's ratio of springs, cam and roller", 0.3, 0,
         0.5},
        {"cams", "k", "1", "1", "1, or 2 equal cams on both ends of the stack", 1, 1, 2, true},
        {"base_radius", "r_b", "mm", "m", "least radius of the cam's profile", 60, 0.1, 1e5},
        {"roller_radius", "r_r", "mm", "m", "radius of the roller", 25, 0.1, 1e5},
        {"face_width", "b", "mm", "m", "width of roller and cam in contact", 25, 0.1, 1e4},
        {"moved_mass", "m", "kg", "kg", "what moves with each roller", 1, 0, 1e6},
        {"lift_off", "delta", "deg", "rad",
         "angle from the engagement on in which the rollers are off the cam", 0, 0, 60}};
    result.insert(result.end(), own.begin(), own.end());
    return result;
  }();
  return all;
}

template <template <class> class M, class T>
constexpr std::array<T M<T>::*, 20> kBalancingFields{
    &M<T>::slots,          &M<T>::angular_speed,  &M<T>::inertia,    &M<T>::friction,
    &M<T>::design_speed,   &M<T>::preload_ratio,  &M<T>::springs,    &M<T>::nested,
    &M<T>::outer_diameter, &M<T>::inner_diameter, &M<T>::thickness,  &M<T>::cone_height,
    &M<T>::youngs_modulus, &M<T>::poisson_ratio,  &M<T>::cams,       &M<T>::base_radius,
    &M<T>::roller_radius,  &M<T>::face_width,     &M<T>::moved_mass, &M<T>::lift_off};

}  // namespace

template <>
struct MachineTraits<PlanarBalancingCam> {
  static const std::vector<MechanismParameter>& parameters() { return balancing_parameters(); }
  template <class T>
  static constexpr auto fields = kBalancingFields<PlanarBalancingCam, T>;
};

template <>
struct MachineTraits<SphericalBalancingCam> {
  static const std::vector<MechanismParameter>& parameters() { return balancing_parameters(); }
  template <class T>
  static constexpr auto fields = kBalancingFields<SphericalBalancingCam, T>;
};

namespace {

using optim::Part;

enum class Quantity {
  StoredEnergy,
  Displacement,
  Travel,
  SpringForce,
  RollerForce,
  BalancingTorque,
  Residual,
  Touching,
  ResidualShare,
  TouchingShare,
  PressureAngle,
  PitchCurvature,
  Undercut,
  ContactStress,
  ProfileX,
  ProfileY
};

template <class Turn, class X>
X cam_quantity(const Turn& turn, Quantity which, std::size_t section, const X& phi) {
  const auto motion = turn.roller(section, phi);
  const auto cam = turn.machine().cam();
  if (which == Quantity::PressureAngle) return cam.pressure_angle(motion);
  const auto pitch = cam.pitch_curve(motion);
  if (which == Quantity::ProfileX || which == Quantity::ProfileY) {
    const auto [x, y] = turned_back(pitch.inside(cam.roller_radius), phi);
    return which == Quantity::ProfileX ? x : y;
  }
  const X k = pitch.curvature();
  if (which == Quantity::PitchCurvature) return k;
  if (which == Quantity::Undercut) return cam.roller().undercut(k);
  return cam.roller().stress(
      turn.roller_force(turn.displacement(section, phi)) * pitch.speed() / pitch.y, k);
}

template <class Turn, class X>
X quantity(const Turn& turn, Quantity which, std::size_t section, const X& phi) {
  switch (which) {
    case Quantity::StoredEnergy:
      return turn.surplus().range * turn.stored(section, phi).s;
    case Quantity::Displacement:
      return turn.displacement(section, phi).s;
    case Quantity::Travel:
      return turn.roller(section, phi).s;
    case Quantity::SpringForce:
      return turn.spring_force(turn.displacement(section, phi));
    case Quantity::RollerForce:
      return turn.roller_force(turn.displacement(section, phi));
    case Quantity::BalancingTorque:
      return turn.balancing_torque(turn.displacement(section, phi));
    case Quantity::Residual:
      return turn.residual_torque(section, phi);
    case Quantity::Touching:
      return turn.touching_torque(section, phi);
    case Quantity::ResidualShare:
      return turn.residual_torque(section, phi) / turn.peak_torque();
    case Quantity::TouchingShare:
      return turn.touching_torque(section, phi) / turn.peak_torque();
    default:
      return cam_quantity(turn, which, section, phi);
  }
}

struct Row {
  Quantity which;
  const char *name, *unit, *stored, *meaning;
};

constexpr Row kRows[] = {
    {Quantity::StoredEnergy, "stored_energy", "J", "J", "energy in the springs above the least"},
    {Quantity::Displacement, "balancing_displacement", "1", "1",
     "displacement of the stack's end over its stroke, equation 7"},
    {Quantity::Travel, "roller_displacement", "mm", "m", "displacement of each roller"},
    {Quantity::SpringForce, "spring_force", "N", "N",
     "force of the stack by its own characteristic"},
    {Quantity::RollerForce, "roller_force", "N", "N",
     "force along a roller's path, if it were always on the cam; below 0 it leaves the cam"},
    {Quantity::BalancingTorque, "balancing_torque", "N m", "N m",
     "what the rollers ask of the driver, were they always on the cam"},
    {Quantity::Residual, "residual_torque", "N m", "N m", "what the balanced driver sees"},
    {Quantity::Touching, "touching_torque", "N m", "N m",
     "the same, were the rollers always on the cam"},
    {Quantity::ResidualShare, "residual_share", "1", "1",
     "residual torque over the greatest before balancing: its peak is 1 / K"},
    {Quantity::TouchingShare, "touching_share", "1", "1",
     "the same, were the rollers always on the cam"},
    {Quantity::PressureAngle, "pressure_angle", "deg", "rad",
     "between the normal and the path of the roller"},
    {Quantity::PitchCurvature, "pitch_curvature", "1/mm", "1/m",
     "curvature of the pitch curve, positive where convex"},
    {Quantity::Undercut, "undercut", "1", "1",
     "share of the pitch curve's radius that the roller takes; at 1 the profile is undercut"},
    {Quantity::ContactStress, "contact_stress", "MPa", "Pa",
     "greatest Hertz pressure, were the roller always on the cam"},
    {Quantity::ProfileX, "profile_x", "mm", "m", "the profile in the cam, along its zero line"},
    {Quantity::ProfileY, "profile_y", "mm", "m", "the profile in the cam, across its zero line"}};

template <template <class> class M>
MechanismResponse curve(const Row& row) {
  return turn_response<M>(
      {row.name, row.unit, row.stored, row.meaning}, row.which, [](const auto& machine) {
        return
            [turn = BalancedTurn(machine)](Quantity which, std::size_t section, const auto& phi) {
              return quantity(turn, which, section, phi);
            };
      });
}

template <template <class> class M>
std::vector<MechanismResponse> curves() {
  std::vector<MechanismResponse> all = drive_curves<M>();
  for (const Row& row : kRows) all.push_back(curve<M>(row));
  return all;
}

enum class Size { Mean, Range, Ideal, Stroke, Deflection, Flattening, Needed, Stress, Tension };

/// A number of a machine, for the surplus work that its cam is cut for.
template <class Machine>
auto size_of(const Machine& machine, Size which) {
  if (which == Size::Mean) return machine.mean_torque();
  const auto surplus = surplus_of(machine.designed());
  if (which == Size::Range) return surplus.range;
  if (which == Size::Ideal) return surplus.peak_torque / machine.mean_torque();
  if (which == Size::Stroke) return machine.stroke(surplus.range);
  if (which == Size::Needed) return machine.springs_needed(surplus.range);
  const auto deflection = machine.deflection(surplus.range);
  if (which == Size::Flattening) return deflection / machine.cone_height;
  if (which == Size::Stress) return -machine.spring().stress_upper_inner(deflection);
  if (which == Size::Tension) return machine.spring().stress_lower_outer(deflection);
  return deflection;
}

struct SizeRow {
  Size which;
  const char *name, *unit, *stored, *meaning;
};

constexpr SizeRow kSizes[] = {
    {Size::Mean, "mean_torque", "N m", "N m", "mean torque on the driver over its turn"},
    {Size::Range, "surplus_range", "J", "J",
     "work that the springs store and return, at the speed the cam is cut for"},
    {Size::Ideal, "ideal_balance", "1", "1",
     "greatest over mean torque at the speed the cam is cut for: K of an ideal balance"},
    {Size::Stroke, "spring_stroke", "mm", "m", "working stroke of the stack"},
    {Size::Deflection, "spring_deflection", "mm", "m", "greatest deflection of each spring"},
    {Size::Flattening, "flattening", "1", "1",
     "greatest deflection of a spring over the one to flat; catalogues allow 0.75"},
    {Size::Needed, "springs_needed", "1", "1",
     "packets in a row for a greatest deflection of 0.75 h_0, equation 10, not rounded"},
    {Size::Stress, "spring_stress", "MPa", "Pa",
     "compression at the inner upper edge of a spring, the greatest"},
    {Size::Tension, "spring_tension", "MPa", "Pa",
     "greatest tension at the outer lower edge of a spring"}};

template <template <class> class M>
std::vector<MechanismResponse> numbers() {
  std::vector<MechanismResponse> all;
  for (const SizeRow& row : kSizes) {
    all.push_back(searched_number<M>(
        {row.name, row.unit, row.stored, row.meaning},
        [which = row.which](const auto& machine) { return size_of(machine, which); }));
  }
  return all;
}

/// K = greatest torque before balancing over the greatest after.
template <template <class> class M>
MechanismResponse balance(const char* name, const char* meaning, Quantity share) {
  const auto row = std::find_if(std::begin(kRows), std::end(kRows),
                                [&](const Row& r) { return r.which == share; });
  return peak_number<M>({name, "1", "1", meaning}, curve<M>(*row), Part::Magnitude,
                        [](const auto&, const auto& peak) {
                          using T = std::decay_t<decltype(peak)>;
                          return number<T>(1) / peak;
                        });
}

template <template <class> class M>
Mechanism balancing_cam(const char* name, const char* title) {
  std::vector<MechanismResponse> responses = numbers<M>();
  responses.push_back(balance<M>("balancing_coefficient",
                                 "greatest torque before balancing over the greatest after, K",
                                 Quantity::ResidualShare));
  responses.push_back(balance<M>("touching_coefficient", "K, were the rollers always on the cam",
                                 Quantity::TouchingShare));
  append(responses, curves<M>());
  return checked(
      {.name = name,
       .title = title,
       .source =
           "K. V. Tir, A. S. Glavatskii, A. I. Petruk, The balancing of the surplus forces of "
           "the main conveyors' drive of the book-processing units, Polihrafiia i vydavnycha "
           "sprava, UDC 621.835",
       .parameters = MachineTraits<M>::parameters(),
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
       .form = Form::BalancingCam},
      {undercut_checks(), stress_checks()});
}

}  // namespace

Mechanism planar_balancing_cam_mechanism() {
  return balancing_cam<PlanarBalancingCam>(
      "balancing-cam", "spring-loaded cam that balances a conveyor with a planar Geneva");
}

Mechanism spherical_balancing_cam_mechanism() {
  return balancing_cam<SphericalBalancingCam>(
      "balancing-cam-spherical",
      "spring-loaded cam that balances a conveyor with a spherical Geneva");
}

}  // namespace camlaw::problems
