// SPDX-License-Identifier: MIT
#include "cli/inputs.h"

#include <algorithm>
#include <vector>

#include "problems/law_files/law_file.h"
#include "problems/results/start_settings.h"

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

void keep_law(const std::string& name, const std::string& folder) {
  keep_input(problems::law_file_of(name, folder));
}

void keep_own_laws() {
  for (const std::string& file : problems::own_law_files()) keep_input(file);
}

void keep_inputs(const problems::ProblemStatement& statement) {
  keep_input(statement.source);
  const std::string folder = fs::path(statement.source).parent_path().string();
  for (const auto& [name, law] : statement.files.laws) keep_law(name, folder);
  for (const auto& [name, text] : statement.files.tables) keep_input(fs::path(folder) / name);
}

void keep_inputs(const problems::ReadDesign& read) {
  if (!read.verdict) keep_inputs(read.problem);
}

void begin_with(problems::ProblemStatement& statement, const std::string& result) {
  keep_input(result);
  problems::set_values(statement, problems::start_settings(statement, result));
}

std::vector<std::string> settings_from(const std::string& file, const std::vector<std::string>& set,
                                       const std::string& result) {
  problems::ProblemStatement statement = problems::read_problem(problems::problem_text(file), file);
  problems::set_values(statement, set);
  begin_with(statement, result);
  return statement.settings;
}

bool is_input(const fs::path& path) {
  return std::any_of(inputs().begin(), inputs().end(), [&](const fs::path& input) {
    std::error_code ignored;
    return fs::equivalent(input, path, ignored);
  });
}

}  // namespace camlaw::cli
