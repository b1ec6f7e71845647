// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "machines/model/mechanism.h"

/// Several cams on one shaft, as one mechanism.
namespace camlaw::problems {

/// The parameter that every cam on a shaft has: the shaft's angle at which the cam's own zero
/// stands. A cam whose phase grows runs later.
inline constexpr const char* kPhase = "phase";
/// The parameter that is the shaft's, for all its cams.
inline constexpr const char* kSpeed = "speed";

/// The phase of a cam as a parameter of that name; `whose` says of what the zero is.
MechanismParameter phase_parameter(const std::string& name, const std::string& whose);

/// A cam by its name, and its mechanism.
struct NamedCam {
  std::string name;
  std::shared_ptr<const Mechanism> mechanism;
};

/// The mechanism of a shaft with these cams: what each of them has, with its name and a dot before
/// (infeed.base_radius, peak infeed.drive_torque), a phase for each, one speed for all, and where
/// all cams have a drive torque what the shaft needs (shaft_torque.h). A curve of a cam
/// runs over the cam's own angle; in a formula it stands where the shaft has turned it. Throws
/// std::invalid_argument where the cams have no speed in common, or a cam has a phase already.
Mechanism shaft_mechanism(const std::vector<NamedCam>& cams);

/// Whether a response is a curve over the angle from 0 to 360 deg.
bool runs_over_turn(const MechanismResponse& response);

/// What of a binding of the shaft's mechanism one of its cams sees: its own parameters, in its own
/// order, and its own law.
Binding binding_of_cam(const Binding& binding, const Mechanism& shaft, std::size_t cam);

}  // namespace camlaw::problems
