// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

namespace camlaw {

/// A file that is installed with the program, by its whole path: beside the running program, in
/// libexec/camlaw of its prefix or of the prefixes that camlaw was built for; for a program that
/// runs in the build folder, in plugins/ of that. None where it is in none of these, or cannot be
/// read.
std::optional<std::string> own_file(const std::string& name);

/// The same for a file that can be executed.
std::optional<std::string> own_program(const std::string& name);

/// A folder of data that is installed with the program, such as "problems": in share/camlaw of its
/// prefix or of the prefixes that camlaw was built for; the build folder has such a share/camlaw
/// too.
std::optional<std::string> own_data(const std::string& name);

/// Has both files looked for in this folder first, from now on and in every thread: of a library
/// within a program that is not camlaw's, such as Python, the folder that its package brings.
void add_own_folder(const std::string& folder);

}  // namespace camlaw
