// SPDX-License-Identifier: MIT
#include "cli/inputs.h"

#include <algorithm>
#include <vector>

namespace camlaw::cli {
namespace {

namespace fs = std::filesystem;

/// Of the program, which runs one command.
std::vector<fs::path>& inputs() {
  static std::vector<fs::path> all;
  return all;
}

}  // namespace

void keep_input(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_regular_file(path, ignored)) inputs().push_back(fs::absolute(path));
}

void keep_inputs(const problems::ProblemStatement& statement) {
  keep_input(statement.source);
  const fs::path folder = fs::path(statement.source).parent_path();
  for (const auto& [name, law] : statement.law_files) keep_input(folder / name);
}

void keep_inputs(const problems::ReadDesign& read) {
  if (!read.verdict) keep_inputs(read.problem);
}

bool is_input(const fs::path& path) {
  return std::any_of(inputs().begin(), inputs().end(), [&](const fs::path& input) {
    std::error_code ignored;
    return fs::equivalent(input, path, ignored);
  });
}

}  // namespace camlaw::cli
