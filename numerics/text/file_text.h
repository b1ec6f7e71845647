// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace camlaw::problems {

/// The content of a file of at most 16 MiB; `what` says what is wanted: "problem file". Throws
/// std::invalid_argument with the path for one that is larger, is a directory or a device, or
/// cannot be read.
std::string file_text(const std::string& path, const std::string& what);

/// "it cannot be read: No such file or directory", from errno after the attempt; 0 where it says
/// nothing.
std::string unreadable(int error);

}  // namespace camlaw::problems
