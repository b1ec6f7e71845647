// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "output/answers/cam_export.h"

/// What the head of a program for a machine tool says of the tool.
namespace camlaw::cli {

/// Of --tool, mm; none without it. Throws std::invalid_argument that names the option.
std::optional<double> tool_radius(const ExportOptions& options);

/// The radius of the tool, for who sets up the machine: the tool's own, what it must be below where
/// a controller leads it along the profile, or that of the roller along the pitch curve.
std::string tool_line(const ExportOptions& options, const Exported& exported);

/// What whoever mills is to be warned of: a cut without `depth`, and a tool that nobody stated.
std::vector<std::string> milling_cautions(const ExportOptions& options, const Exported& exported,
                                          double depth);

}  // namespace camlaw::cli
