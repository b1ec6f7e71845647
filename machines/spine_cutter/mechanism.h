// SPDX-License-Identifier: MIT
#pragma once

#include "machines/model/machine.h"
#include "machines/model/mechanism.h"
#include "machines/spine_cutter/spine_cutter.h"

/// The spine cutter as problem files and the study see it.
namespace camlaw::problems {

/// "spine-cutter". Curves run over the cam angle, 0 to 360 degrees: the stroke and its return.
Mechanism spine_cutter_mechanism();

}  // namespace camlaw::problems
