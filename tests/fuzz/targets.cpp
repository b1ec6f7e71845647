// SPDX-License-Identifier: MIT
#include "tests/fuzz/targets.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "numerics/tables/sample_table.h"
#include "problems/fronts/stored_front.h"
#include "problems/law_files/law_file.h"
#include "problems/published/table/stated_model.h"
#include "problems/results/judged_design.h"
#include "problems/results/recorded_design.h"
#include "problems/statement/bind.h"
#include "tests/cutter_study.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

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

/// With all that its rows and hypotheses name; the search behind it reads nothing more.
void read_a_table(std::string_view bytes) {
  refused_or_read([&] {
    const auto table = problems::read_stated_table(bytes, "fuzz.toml");
    const problems::stated::Model model(table, nullptr);
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

/// As 'camlaw front' does: its front, and of each point what is shown of it.
void read_a_study(std::string_view bytes) {
  const testing::Folder folder;  // what SQLite puts beside the file goes with it
  const std::string path = folder / "fuzz.db";
  testing::write(path, std::string(bytes));
  refused_or_read([&] {
    optim::StudyRecord record = optim::StudyRecord::read(path);
    const problems::FrontStudy study = problems::FrontStudy::of(record);
    const problems::StoredFront stored = problems::stored_front(study, record);
    for (const optim::FrontPoint& point : stored.front.points) study.design(point);
  });
}

/// A study of four points, the same half done, and both as version 2 had them: there what is
/// changed is told by no checksum, so that more of it is looked at.
std::vector<std::string> made_studies() {
  const testing::Folder folder;
  const std::string path = folder / "s.db";
  testing::make_cutter_study(path, 4);
  std::vector<std::string> result{testing::read(path)};
  const auto change = [&](const char* sql) {
    SQLite::Database(path, SQLite::OPEN_READWRITE).exec(sql);
    result.push_back(testing::read(path));
  };
  constexpr const char* kOlder =
      "ALTER TABLE task DROP COLUMN checksum; ALTER TABLE setting DROP COLUMN checksum; "
      "PRAGMA user_version = 2";
  change("DELETE FROM task WHERE id > 3");
  change(kOlder);
  testing::write(path, result.front());
  change(kOlder);
  return result;
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all{
      {"problem", read_a_problem, {"problems"}, ".toml"},
      {"table", read_a_table, {"problems/published"}, ".toml"},
      {"law", read_a_law, {"tests/fuzz/corpus/law"}, ".json"},
      {"result", read_a_result, {"tests/fuzz/corpus/result"}, ".json"},
      {"samples", read_samples, {"problems/cams", "tests/fuzz/corpus/samples"}, ".csv"},
      {"study", read_a_study, {}, ".db", made_studies, false}};
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
    const fs::path root = fs::path(testing::source()) / folder;
    if (!fs::exists(root)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root)) {
      if (entry.is_regular_file() && entry.path().extension() == target.ending) {
        paths.push_back(entry.path());
      }
    }
  }
  std::sort(paths.begin(), paths.end());  // the same order on every machine
  std::vector<std::string> result;
  for (const fs::path& path : paths) result.push_back(testing::read(path));
  if (target.made != nullptr) {
    for (std::string& bytes : target.made()) result.push_back(std::move(bytes));
  }
  return result;
}

}  // namespace camlaw::fuzz
