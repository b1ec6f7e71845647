// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/answers/cam_export.h"

/// What camlaw export writes as a solid, by its options.
namespace camlaw::cli {

/// The text of a STEP file. What the solid is, and by what curves it is bounded, is added to
/// `exported`. Throws std::invalid_argument that names the option, and for a build without STEP.
std::string solid_text(const ExportOptions& options, Exported& exported);

}  // namespace camlaw::cli
