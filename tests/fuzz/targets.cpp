// SPDX-License-Identifier: MIT
#include "tests/fuzz/targets.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "problems/fits/sample_table.h"
#include "problems/law_files/law_file.h"
#include "problems/results/judged_design.h"
#include "problems/statement/bind.h"

namespace camlaw::fuzz {
namespace {

namespace fs = std::filesystem;

/// A reader refuses with std::invalid_argument, and with nothing else.
template <class F>
void refused_or_read(const F& read) {
  try {
    read();
  } catch (const std::invalid_argument&) {  // one clear error is an answer
  }
}

void read_a_problem(std::string_view bytes) {
  refused_or_read([&] {
    const auto statement = problems::read_problem(bytes, "fuzz.toml");
    problems::in_words(statement);
    if (statement.objectives.size() == 1) problems::BoundProblem(statement).space();
  });
}

void read_a_law(std::string_view bytes) {
  refused_or_read([&] { problems::read_law_text(std::string(bytes), "fuzz.json"); });
}

void read_a_result(std::string_view bytes) {
  refused_or_read([&] { problems::held_problem(problems::read_result(bytes, "fuzz.json")); });
}

void read_samples(std::string_view bytes) {
  refused_or_read([&] { problems::parse_samples(std::string(bytes), "fuzz.csv"); });
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all{
      {"problem", read_a_problem, {"problems"}, ".toml"},
      {"law", read_a_law, {"tests/fuzz/corpus/law"}, ".json"},
      {"result", read_a_result, {"tests/fuzz/corpus/result"}, ".json"},
      {"samples", read_samples, {"problems/cams", "tests/fuzz/corpus/samples"}, ".csv"}};
  return all;
}

const Target& find_target(std::string_view name) {
  std::string known;
  for (const Target& target : targets()) {
    if (target.name == name) return target;
    known += (known.empty() ? "" : ", ") + target.name;
  }
  throw std::invalid_argument("no target '" + std::string(name) + "'; there are " + known);
}

std::vector<std::string> corpus(const Target& target) {
  std::vector<fs::path> paths;
  for (const std::string& folder : target.folders) {
    const fs::path root = fs::path(CAMLAW_SOURCE_DIR) / folder;
    if (!fs::exists(root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (entry.is_regular_file() && entry.path().extension() == target.ending) {
        paths.push_back(entry.path());
      }
    }
  }
  std::sort(paths.begin(), paths.end());  // the same order on every machine
  std::vector<std::string> result;
  for (const fs::path& path : paths) result.push_back(bytes_of(path));
  return result;
}

}  // namespace camlaw::fuzz
