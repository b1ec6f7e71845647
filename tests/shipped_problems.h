// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/paths.h"

namespace camlaw::testing {

/// The problem files of the tree, sorted; the published tables beside them are none.
inline std::vector<std::string> shipped_problem_files() {
  namespace fs = std::filesystem;
  std::vector<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(testing::source("problems"))) {
    const bool is_table = entry.path().parent_path().filename() == "published";
    if (entry.path().extension() == ".toml" && !is_table) files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace camlaw::testing
