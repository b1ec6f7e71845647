// SPDX-License-Identifier: MIT
#include "machines/index_drives/rib_edges.h"

#include <array>
#include <memory>
#include <numbers>

#include "machines/index_drives/barrel_index_cam.h"
#include "machines/index_drives/globoidal_cam.h"
#include "machines/index_drives/rib_responses.h"
#include "machines/model/machine.h"
#include "numerics/formula/formula.h"

namespace camlaw::problems {
namespace {

/// x, y and z of the contact with one flank, m, of the machine's parameters, psi and psi'.
template <class Drive>
std::array<Formula, 3> contact_formulas(RollerPlace place, double side) {
  const auto of = [&](int coordinate) {
    const std::size_t count = parameters_of<Drive>().size();
    return Formula::record(count + 2, [&](std::span<const Expression> inputs) {
      const auto drive = detail::machine_of<Drive>(inputs.first(count));
      FollowerMotion motion;
      motion.ds = inputs[count + 1];  // directions of contact depend on nothing else of the motion
      return contact_coordinate(drive, {coordinate, place, side}, inputs[count], motion, 0.0);
    });
  };
  return {of(0), of(1), of(2)};
}

template <class Drive>
RibEdges edges_of(RollerPlace place,
                  const std::function<double(std::string_view name)>& parameter) {
  struct Known {
    std::array<Formula, 3> driving, holding;
    std::vector<double> inputs;
  };
  auto known = std::make_shared<Known>(
      Known{contact_formulas<Drive>(place, kDrives), contact_formulas<Drive>(place, kHolds), {}});
  for (const MechanismParameter& p : parameters_of<Drive>()) {
    known->inputs.push_back(parameter(p.name));
  }
  return [known](double psi, double slope) {
    std::vector<double> inputs = known->inputs;
    inputs.insert(inputs.end(), {psi * std::numbers::pi / 180, slope});
    const auto at = [&](const std::array<Formula, 3>& formulas) {
      constexpr double kMillimetres = 1000;  // of a metre
      const auto value = [&](const Formula& formula) {
        return kMillimetres * formula(std::span<const double>(inputs));
      };
      return BesideCam{value(formulas[0]), value(formulas[1]), value(formulas[2])};
    };
    return GrooveSides{at(known->driving), at(known->holding)};
  };
}

}  // namespace

RibEdges rib_edges(Form form, RibHeight height,
                   const std::function<double(std::string_view name)>& parameter) {
  const RollerPlace place = height == RibHeight::Top ? RollerPlace::Root : RollerPlace::Middle;
  if (form == Form::RollerGear) return edges_of<GloboidalCam>(place, parameter);
  if (form == Form::BarrelIndex) return edges_of<BarrelIndexCam>(place, parameter);
  return {};
}

}  // namespace camlaw::problems
