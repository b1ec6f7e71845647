// SPDX-License-Identifier: MIT
#include "cli/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "problems/law_files/law_file.h"
#include "problems/results/input_files.h"
#include "problems/results/start_settings.h"

namespace camlaw::cli {
namespace {

namespace fs = std::filesystem;

/// Of the program, which runs one command.
std::vector<fs::path>& inputs() {
  static std::vector<fs::path> all;
  return all;
}

/// Problems of records that it reads.
std::vector<problems::RecordedProblem>& recorded_problems() {
  static std::vector<problems::RecordedProblem> all;
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
  for (const std::string& file : problems::input_files(statement)) keep_input(file);
}

void keep_inputs(const problems::ReadDesign& read, const std::string& file) {
  if (!read.verdict) return keep_inputs(read.problem);
  recorded_problems().push_back(problems::recorded_problem(read, file));
}

void keep_recorded(const problems::ProblemStatement& problem, const std::string& study) {
  recorded_problems().push_back({problem, study});
}

void begin_with(problems::ProblemStatement& statement, const std::string& result) {
  keep_input(result);
  const std::vector<std::string> settings = problems::start_settings(statement, result);
  keep_inputs(problems::read_design_file(result), result);
  problems::set_values(statement, settings);
}

std::vector<std::string> settings_from(const std::string& file, const std::vector<std::string>& set,
                                       const std::string& result) {
  problems::ProblemStatement statement = problems::read_problem(problems::problem_text(file), file);
  problems::set_values(statement, set);
  begin_with(statement, result);
  return statement.settings;
}

void check_began_at(const std::string& file, const std::vector<std::string>& set,
                    const std::string& result) {
  const problems::ProblemStatement plain =
      problems::read_problem(problems::problem_text(file), file);
  // What was set before the design is not known, but what follows it is: the design is the rest.
  const auto begins_after = [&](std::size_t count) {
    problems::ProblemStatement statement = plain;
    problems::set_values(statement, {set.data(), count});
    const std::vector<std::string> found = problems::start_settings(statement, result);
    return std::equal(found.begin(), found.end(), set.begin() + static_cast<std::ptrdiff_t>(count),
                      set.end());
  };
  problems::start_settings(plain, result);  // throws where it is no result, or of something else
  for (std::size_t count = set.size(); count-- > 0;) {
    try {
      if (begins_after(count)) return;
    } catch (const std::invalid_argument&) {
      continue;  // values that are possible together alone
    }
  }
  throw std::invalid_argument(
      fmt::format("the study cannot be resumed: it did not begin at the design of {}; leave out "
                  "--start, or begin a new study in another file",
                  result));
}

bool is_input(const fs::path& path) {
  const auto is_it = [&](const fs::path& input) {
    std::error_code ignored;
    return fs::equivalent(input, path, ignored);
  };
  return std::any_of(inputs().begin(), inputs().end(), is_it) ||
         std::any_of(
             recorded_problems().begin(), recorded_problems().end(),
             [&](const auto& problem) { return problems::is_read_by(problem, path.string()); });
}

}  // namespace camlaw::cli
