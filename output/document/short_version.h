// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace camlaw::cli {

/// "camlaw 0.1.0".
std::string short_version();

}  // namespace camlaw::cli
