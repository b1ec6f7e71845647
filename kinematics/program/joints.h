// SPDX-License-Identifier: MIT
#pragma once

#include "kinematics/program/layout.h"

namespace camlaw::detail {

/// Where two segments do not meet as asked for, with what would make them meet. Jumps are counted
/// against what a motion of the segment's own stroke and share would have.
std::optional<Impossible> bad_joint(const StatedProgram& program,
                                    const std::vector<Segment<double>>& segments,
                                    const Law<double>& law);

}  // namespace camlaw::detail
