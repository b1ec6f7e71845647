// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <system_error>

namespace camlaw {

/// Where a file stands, or would stand if it were written: an absolute path in which all links are
/// followed, those too that lead to what is not there yet, and "." and ".." are gone. `error` says
/// if links go in a circle (too_many_symbolic_link_levels) or one cannot be read.
std::filesystem::path file_place(const std::filesystem::path& path, std::error_code& error);

/// The same; where there is an error, the path as it is, for what comes next to find it.
std::filesystem::path file_place(const std::filesystem::path& path);

}  // namespace camlaw
