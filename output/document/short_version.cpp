// SPDX-License-Identifier: MIT
#include "output/document/short_version.h"

namespace camlaw::cli {

// CAMLAW_VERSION is the project's version, from CMake.
std::string short_version() { return "camlaw " CAMLAW_VERSION; }

}  // namespace camlaw::cli
