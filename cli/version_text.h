// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace camlaw::cli {

/// "camlaw 0.1.0".
std::string short_version();

/// That, and the libraries behind the program with the versions in use, one a line.
std::string version_text();

}  // namespace camlaw::cli
