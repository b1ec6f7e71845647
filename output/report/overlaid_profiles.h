// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "output/answers/comparison_output.h"

namespace camlaw::cli {

/// The profiles of those designs that are cams, over one another and to one scale: discs in one
/// picture about the shaft's centre, developed cams in another. A sentence says which designs
/// have none; empty where no design has one.
std::string overlaid_profiles(const std::vector<ComparedDesign>& designs);

}  // namespace camlaw::cli
