// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "output/answers/cam_export.h"

/// A mechanism's motion as a table, or as a drive's file, by the options of camlaw export.
namespace camlaw::cli {

/// The text of the file; what is to be said of the motion comes into `exported`. Throws
/// std::invalid_argument that names the option.
std::string motion_text(const ExportOptions& options, const FormatRow& format, Exported& exported);

/// The motion that `slave` names, by default that of the follower: of a cam on a shaft over the
/// angle of the shaft, unless its own zero is asked for.
Possible<problems::ExportedMotion> exported_motion(const Exported& exported,
                                                   const std::optional<std::string>& slave);

/// "mm" by default.
problems::LengthUnit unit_of(const ExportOptions& options);

}  // namespace camlaw::cli
