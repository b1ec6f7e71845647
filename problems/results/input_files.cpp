// SPDX-License-Identifier: MIT
#include "problems/results/input_files.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "numerics/tables/line_source.h"
#include "numerics/text/file_text.h"
#include "problems/law_files/json_text.h"
#include "problems/law_files/law_file.h"
#include "problems/law_files/pieces_json.h"

namespace camlaw::problems {
namespace {

namespace fs = std::filesystem;

bool is_regular(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool is_same_place(const fs::path& one, const fs::path& other) {
  std::error_code ignored;
  return fs::equivalent(one, other, ignored);
}

/// A text as tables are kept: line by line, whatever ends the lines.
std::string lines_of(const std::string& text, const std::string& path) {
  std::istringstream raw(text);
  LineSource lines(raw, path);
  std::string result;
  for (std::string line; lines.next(line);) result += line + "\n";
  return result;
}

bool holds_table(const ProblemStatement& problem, const std::string& text,
                 const std::string& path) {
  if (problem.files.tables.empty()) return false;
  const std::string lines = lines_of(text, path);
  return std::any_of(problem.files.tables.begin(), problem.files.tables.end(),
                     [&](const auto& table) { return table.second == lines; });
}

bool holds_law(const ProblemStatement& problem, const std::string& text, const std::string& path) {
  if (problem.files.laws.empty() || !text.starts_with('{')) return false;
  const Json pieces = pieces_to_json(read_law_text(text, path).law());
  return std::any_of(problem.files.laws.begin(), problem.files.laws.end(),
                     [&](const auto& law) { return pieces_to_json(law.second.law()) == pieces; });
}

}  // namespace

std::vector<std::string> input_files(const ProblemStatement& problem) {
  std::vector<std::string> files{problem.source};
  const fs::path folder = fs::path(problem.source).parent_path();
  for (const auto& [name, law] : problem.files.laws) {
    files.push_back(law_file_of(name, folder.string()));
  }
  for (const auto& [name, text] : problem.files.tables) files.push_back((folder / name).string());
  std::erase_if(files, [](const std::string& file) { return !is_regular(file); });
  return files;
}

RecordedProblem recorded_problem(const ReadDesign& result, const std::string& file) {
  RecordedProblem recorded{result.problem, file};
  if (!result.problem_file.empty()) recorded.problem.source = result.problem_file;
  return recorded;
}

std::vector<std::string> input_files(const RecordedProblem& recorded) {
  // A result may lie in a folder of results beside the problem's, or in one of that.
  constexpr int kFolders = 3;
  const fs::path source = recorded.problem.source;
  std::vector<fs::path> places{source};
  if (!recorded.record.empty()) {
    fs::path folder = fs::absolute(recorded.record).lexically_normal().parent_path();
    for (int i = 0; i < kFolders; ++i, folder = folder.parent_path()) {
      places.push_back(folder / source.filename());
    }
  }
  std::vector<std::string> files;
  ProblemStatement found = recorded.problem;
  for (const fs::path& place : places) {
    found.source = place.string();
    if (!is_regular(place)) continue;
    for (std::string& file : input_files(found)) files.push_back(std::move(file));
  }
  return files;
}

bool holds_input(const RecordedProblem& recorded, const std::string& path) {
  const ProblemStatement& problem = recorded.problem;
  if (!is_regular(path)) return false;
  try {
    const std::string text = file_text(path, "file");
    return text == problem.text || holds_table(problem, text, path) ||
           holds_law(problem, text, path);
  } catch (const std::exception&) {
    return false;  // what cannot be read as such was not
  }
}

bool is_read_by(const ProblemStatement& problem, const std::string& path) {
  const auto files = input_files(problem);
  return std::any_of(files.begin(), files.end(),
                     [&](const std::string& file) { return is_same_place(file, path); });
}

bool is_read_by(const RecordedProblem& recorded, const std::string& path) {
  const auto files = input_files(recorded);
  return std::any_of(files.begin(), files.end(),
                     [&](const std::string& file) { return is_same_place(file, path); }) ||
         holds_input(recorded, path);
}

}  // namespace camlaw::problems
