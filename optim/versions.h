// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace camlaw::optim {

/// The libraries that search and record, with the versions in use: "ipopt 3.11.9", "nlopt 2.7.1".
/// Each back end tells its own.
std::vector<std::string> library_versions();

}  // namespace camlaw::optim
