// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/program/layout.h"

namespace camlaw::detail {

/// Throws std::invalid_argument where two segments do not meet as asked for, with what would make
/// them meet. Jumps are counted against what a motion of the segment's own stroke and share would
/// have.
void check_joints(const StatedProgram& program, const std::vector<Segment<double>>& segments,
                  const Law<double>& law);

}  // namespace camlaw::detail
