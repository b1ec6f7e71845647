// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace camlaw::cli {

/// What --version prints: the program's version and those of the libraries that it uses.
std::string version_text();

}  // namespace camlaw::cli
