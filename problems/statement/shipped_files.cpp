// SPDX-License-Identifier: MIT
#include "problems/statement/shipped_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "numerics/own_files.h"
#include "numerics/text/names.h"
#include "problems/statement/statement.h"

namespace camlaw::problems {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEnding = ".toml", kFolder = "problems/";

/// The first sentence of a file's first comment; empty where it does not begin with one.
std::string first_sentence(const std::string& text) {
  std::istringstream lines(text);
  std::string words;
  for (std::string line; std::getline(lines, line) && line.starts_with('#');) {
    if (!words.empty()) words += ' ';
    words += trimmed(std::string_view(line).substr(1));
    for (std::size_t i = 0; i + 1 < words.size(); ++i) {
      const bool ends = words[i] == '.' || words[i] == '?';
      if (ends && words[i + 1] == ' ') return words.substr(0, i + 1);
    }
    if (words.ends_with(':')) {  // a command or a list follows
      words.back() = '.';
      return words;
    }
  }
  return words;
}

/// Whether a file is meant by a name without its folder, or with it.
bool is_named(const ShippedFile& file, std::string_view name) {
  return file.name == name || file.path.stem() == name;
}

}  // namespace

std::vector<ShippedFile> shipped_files() {
  const auto folder = own_data("problems");
  if (!folder) throw std::runtime_error("the problem files are not installed with this program");
  std::vector<ShippedFile> files;
  for (auto at = fs::recursive_directory_iterator(*folder); at != fs::end(at); ++at) {
    const fs::directory_entry& entry = *at;
    // Printed tables are for 'camlaw reproduce'.
    if (entry.path().filename() == "published") at.disable_recursion_pending();
    if (!entry.is_regular_file() || entry.path().extension() != kEnding) continue;
    files.push_back({entry.path().lexically_relative(*folder).replace_extension().generic_string(),
                     entry.path(), first_sentence(problem_text(entry.path().string()))});
  }
  std::sort(files.begin(), files.end(),
            [](const ShippedFile& a, const ShippedFile& b) { return a.name < b.name; });
  return files;
}

ShippedFile find_shipped(std::string_view name) {
  std::string_view wanted = name;
  if (wanted.starts_with(kFolder)) wanted.remove_prefix(kFolder.size());
  if (wanted.ends_with(kEnding)) wanted.remove_suffix(kEnding.size());
  const std::vector<ShippedFile> all = shipped_files();
  std::vector<std::string> known, met;
  const ShippedFile* found = nullptr;
  for (const ShippedFile& file : all) {
    known.push_back(file.name);
    if (!is_named(file, wanted)) continue;
    found = &file;
    met.push_back(file.name);
  }
  if (found == nullptr) {
    refuse_name("there is no example", name, known, "'camlaw examples' lists them");
  }
  if (met.size() > 1) {
    throw std::invalid_argument(
        fmt::format("several examples are called '{}': {}", name, fmt::join(met, ", ")));
  }
  return *found;
}

std::vector<fs::path> files_of(const ShippedFile& shipped) {
  const ProblemStatement problem = read_problem_file(shipped.path.string());
  const fs::path folder = shipped.path.parent_path();
  std::vector<fs::path> files = {shipped.path.filename()};
  const auto add = [&](const fs::path& file) {
    const fs::path relative = file.lexically_normal();
    if (std::find(files.begin(), files.end(), relative) == files.end()) files.push_back(relative);
  };
  for (const auto& [name, law] : problem.files.laws) add(name);
  for (const auto& [name, text] : problem.files.tables) add(name);
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().stem() == shipped.path.stem()) add(entry.path().filename());
  }
  std::sort(files.begin() + 1, files.end());
  return files;
}

}  // namespace camlaw::problems
