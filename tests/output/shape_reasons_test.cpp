// SPDX-License-Identifier: MIT
// By which reason the shape of each objective and limit of the shipped problem files is known, and
// which files are global: shape_reasons.txt has it, so that a change is noticed.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>

#include "optim/search/optimise.h"
#include "output/answers/shape_output.h"
#include "problems/statement/bind.h"
#include "tests/shipped_problems.h"

namespace camlaw::cli::shape_reasons_test {
namespace {

namespace fs = std::filesystem;
using problems::ProblemStatement;

const fs::path kSource = testing::source();
const fs::path kRecord = kSource / "tests/output/shape_reasons.txt";

/// The files that ask for a design, by their place in the sources.
std::vector<std::string> shipped_files() {
  std::vector<std::string> files;
  for (const std::string& file : testing::shipped_problem_files()) {
    const ProblemStatement statement = problems::read_problem_file(file);
    if (statement.objectives.empty()) continue;
    files.push_back(fs::relative(file, kSource).generic_string());
  }
  return files;
}

ProblemStatement read(const std::string& file) {
  return problems::read_problem_file((kSource / file).string());
}

/// What shape_reasons.txt holds of a file: in the first line whether its optimum is global, then
/// the table of shapes.
struct Recorded {
  std::string global, table;
};

std::map<std::string, Recorded> recorded() {
  std::map<std::string, Recorded> all;
  std::ifstream text(kRecord);
  std::string line, file;
  while (std::getline(text, line)) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("problems/") && colon != std::string::npos) {
      file = line.substr(0, colon);
      all[file].global = line.substr(colon + 2);
    } else if (!file.empty() && !line.empty()) {
      all[file].table += line + "\n";
    }
  }
  return all;
}

std::string table_of(const std::string& file) { return text_of(shape_table(read(file))); }

/// "global by shapes", "global by its box", "not global", "a front".
std::string found_of(const std::string& file) {
  const ProblemStatement statement = read(file);
  if (statement.objectives.size() > 1) return "a front";
  const auto optimum = optim::optimise(problems::BoundProblem(statement).space());
  const auto& global = optimum.found.assessment.global;
  if (!global) return "not global";
  return global->find("was split into") != std::string::npos ? "global by its box"
                                                             : "global by shapes";
}

}  // namespace

TEST_CASE("the reasons for the shapes of the shipped files are the recorded ones", "[shapes]") {
  const auto record = recorded();
  const std::vector<std::string> files = shipped_files();
  CHECK(files.size() == record.size());
  for (const std::string& file : files) {
    INFO(file << "; 'camlaw_tests [.shape-reasons]' writes the record anew");
    REQUIRE(record.contains(file));
    CHECK(record.at(file).table == table_of(file));
  }
}

TEST_CASE("the shipped files that are recorded as global are so, and no others",
          "[shapes][heavy]") {
  for (const auto& [file, reasons] : recorded()) {
    INFO(file);
    CHECK(reasons.global == found_of(file));
  }
}

TEST_CASE("write shape_reasons.txt", "[.shape-reasons]") {
  std::ofstream text(kRecord);
  for (const std::string& file : shipped_files()) {
    text << file << ": " << found_of(file) << "\n" << table_of(file) << "\n";
  }
}

}  // namespace camlaw::cli::shape_reasons_test
