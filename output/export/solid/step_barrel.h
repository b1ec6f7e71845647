// SPDX-License-Identifier: MIT
#pragma once

#include <TopoDS_Solid.hxx>

#include "output/export/solid/step_plugin.h"

namespace camlaw::step {

/// A barrel with its groove, its faces built one by one: no surfaces are cut with each other.
/// Throws std::runtime_error where a loop of the body does not close.
TopoDS_Solid barrel_of(const CamlawStepPrism& body, const CamlawStepGroove& groove);

}  // namespace camlaw::step
