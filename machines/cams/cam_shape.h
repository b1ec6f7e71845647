// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "machines/model/mechanism.h"

namespace camlaw::problems {

/// What the curves of a machine's cam, in the cam's own coordinates, are.
enum class CamShape {
  Disc,   ///< closed about the shaft's centre
  Drum,   ///< on a drum, developed: after a turn they go on a circumference farther along x
  Plate,  ///< along a plate: they end where the plate does
};
/// None where the machine does not say: it has no cam, or is a file's own.
std::optional<CamShape> cam_shape(const Mechanism& mechanism);

}  // namespace camlaw::problems
