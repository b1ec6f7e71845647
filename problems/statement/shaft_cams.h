// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "problems/statement/statement.h"

/// The cams of a problem that has several on one shaft.
namespace camlaw::problems {

/// One of the cams by itself, with the sizes and the motion that it has on the shaft: what its own
/// table states, without objectives and limits.
ProblemStatement cam_alone(const ProblemStatement& shaft, std::size_t cam);

/// A cam by its name; throws std::invalid_argument with near and known names, and where the problem
/// has one machine only.
std::size_t find_cam(const ProblemStatement& shaft, std::string_view name);

}  // namespace camlaw::problems
