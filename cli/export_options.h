// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "cli/command.h"
#include "output/answers/cam_export.h"

namespace camlaw::cli {

/// The options of camlaw export.
std::vector<Option> export_options(ExportOptions& options);

}  // namespace camlaw::cli
