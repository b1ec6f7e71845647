// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "problems/statement/statement.h"

/// What stands already in the folder of --out.
namespace camlaw::cli {

/// A problem's search replaces its own earlier answer, and nobody else's: throws
/// std::invalid_argument where one of `files`, which the search may write, is a result or a law of
/// another problem, or is called so and is none. A problem is known by its file's place, by its
/// text, and, where that place is not known or is gone, by its file's name.
void keep_other_results(const std::vector<std::filesystem::path>& files,
                        const problems::ProblemStatement& statement);

}  // namespace camlaw::cli
